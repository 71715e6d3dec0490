//! Analyses of one mesh: both programs of each kind of analysis, their fields and bounds.
//!
//! [`dispatch`] selects what runs for a kind of analysis: [`elastic`], [`hencky`] (elastic,
//! perfectly plastic) or [`limit`]. Each of them assembles its programs and hands them to
//! `engine`, which plans the memory, solves and certifies.

pub mod cone_shift;
pub mod diagnosis;
pub(crate) mod discrete_program;
pub mod dispatch;
pub mod elastic;
pub mod energy_pass;
pub(crate) mod engine;
pub mod event;
pub mod fixed_point;
pub mod hencky;
pub mod limit;
pub mod memory;
pub mod pass;
pub mod preloaded_bolt;
pub mod program;
pub mod program_outcome;
mod tightening;
