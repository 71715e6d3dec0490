//! Bolts, bearing, slip, spacing and welds of EN 1993-1-8:2005, sections 3 and 4; cross-sections of
//! EN 1993-1-1:2005, 6.2.

pub mod bearing;
pub mod block_tearing;
pub mod bolt_group;
pub mod bolt_length;
pub mod bolts;
pub mod column_curve;
pub mod concrete;
pub mod grip;
pub mod holes;
pub mod hollow;
pub mod i_section;
pub mod interaction;
pub mod net_section;
pub mod notched_section;
pub mod plate_buckling;
pub mod plate_section;
pub mod punching;
pub mod section;
pub mod slip;
pub mod spacing;
pub mod welds;
pub mod yielding;

#[cfg(test)]
mod tests;
