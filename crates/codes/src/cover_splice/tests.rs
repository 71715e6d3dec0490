//! Tests of the checks of a cover-plate splice.

mod column_splices;
mod fixture;
mod properties;
mod published;
mod random;
mod range_and_slip;
mod second;
mod second_web;
