//! Spec + template + catalogue → parts, interfaces, supports, loads, symmetry.

pub mod joint;

pub use joint::Assembly;
