//! Computes strict bounds of the load factor from approximate fields. Exact fields with noise are
//! projected and certified. Wrong fields must not pass. No solver is involved.
#![allow(clippy::unwrap_used)]

#[path = "limit_bounds/cases.rs"]
mod cases;
mod common;
#[path = "limit_bounds/loads.rs"]
mod loads;

#[path = "limit_bounds/lower.rs"]
mod lower;
#[path = "limit_bounds/solved.rs"]
mod solved;
#[path = "limit_bounds/upper.rs"]
mod upper;
