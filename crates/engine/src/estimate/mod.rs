//! Numbers of no proven error, computed from certified fields.

pub mod buckling;
#[cfg(test)]
mod fixtures;
pub mod plate;
pub mod plate_strain;
pub mod refined;
pub mod section_forces;
pub mod tet_slices;
pub mod weld_forces;
pub mod windows;
