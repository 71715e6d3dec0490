//! Bracket: steel connections with certified bounds.
//!
//! An engineer's YAML spec becomes parts, a mesh and two dual finite-element analyses; the answer
//! is a bracket `[lower, upper]` that contains the exact one, with a certificate computed by code
//! that shares nothing with the solver. The modules are the steps of the work, in the order of the
//! data flow (see `ARCHITECTURE.md`).
//!
//! [`check`] gives the checks of a spec by code, [`run`] its bounds and verdict, both without files
//! and prints. The commands are made of them.
//!
//! Units everywhere: mm, N, MPa, N mm, rad. Symmetric tensors in Mandel form
//! `[xx, yy, zz, √2 yz, √2 xz, √2 xy]`.

pub mod batch;
pub mod cli;
pub mod driver;

pub use driver::check_spec::{Checked, check};
pub use driver::limits::Limits;
pub use driver::overrides::Overrides;
pub use driver::spec_input::SpecInput;
pub use driver::spec_run::{Ran, run};

pub use bracket_base::{diag, diag_render, math, text_file, units, words, yaml};
pub use bracket_codes as checks;
pub use bracket_engine::{
    analysis, certify, elements, estimate, mesh, model, programs, recover, refine, solve,
};
pub use bracket_joint::{assembly, catalog, geometry, meshing, model_file, spec, strength};
pub use bracket_report as report;
pub use bracket_report::result;
