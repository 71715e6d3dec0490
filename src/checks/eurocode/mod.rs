//! Bolts, bearing, slip, spacing and welds of EN 1993-1-8:2005, sections 3 and 4.

pub mod bearing;
pub mod bolt_length;
pub mod bolts;
pub mod interaction;
pub mod punching;
pub mod section;
pub mod slip;
pub mod spacing;
pub mod welds;

#[cfg(test)]
mod tests;
