//! From approximate fields to strict bounds of the load factor: exact fields with noise, projected
//! and certified; wrong fields, which must not pass. No solver takes part.
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
