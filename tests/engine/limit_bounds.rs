//! Computes strict bounds of the load factor from approximate fields. Exact fields with noise are
//! projected and certified. Wrong fields must not pass. No solver is involved.
mod cases;
mod loads;

mod lower;
mod solved;
mod upper;
