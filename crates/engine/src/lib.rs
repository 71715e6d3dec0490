//! Certified analysis of solids: two dual finite-element analyses on any tetrahedral mesh.
//!
//! A mesh and a [`model::AnalysisModel`] go in; a bracket `[lower, upper]` that contains the exact
//! answer comes out, with a certificate computed by code that shares nothing with the solver. The
//! engine knows no joint, no design code and no spec. The modules are the steps of the work, in the
//! order of the data flow (see `ARCHITECTURE.md`).
//!
//! `examples/clamped_block.rs` brackets the limit load of a block.
//!
//! Units everywhere: mm, N, MPa, N mm, rad. Symmetric tensors in Mandel form
//! `[xx, yy, zz, √2 yz, √2 xz, √2 xy]`.

pub mod analysis;
pub mod certify;
pub mod elements;
pub mod estimate;
pub mod mesh;
pub mod model;
pub mod programs;
pub mod recover;
pub mod refine;
pub mod solve;
