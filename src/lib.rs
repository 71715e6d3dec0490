//! Bracket: steel connections with certified bounds.
//!
//! An engineer's YAML spec becomes parts, a mesh and two dual finite-element analyses; the answer
//! is a bracket `[lower, upper]` that contains the exact one, with a certificate computed by code
//! that shares nothing with the solver. The modules are the steps of the work, in the order of the
//! data flow (see `ARCHITECTURE.md`).
//!
//! Units everywhere: mm, N, MPa, N mm, rad. Symmetric tensors in Mandel form
//! `[xx, yy, zz, √2 yz, √2 xz, √2 xy]`.

pub mod analysis;
pub mod assembly;
pub mod batch;
pub mod catalog;
pub mod certify;
pub mod checks;
pub mod cli;
pub mod diag;
pub mod diag_render;
pub mod driver;
pub mod elements;
pub mod geometry;
pub mod math;
pub mod mesh;
pub mod model;
pub mod programs;
pub mod recover;
pub mod refine;
pub mod report;
pub mod result;
pub mod solve;
pub mod spec;
pub mod text_file;
pub mod units;
