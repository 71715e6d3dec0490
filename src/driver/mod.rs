//! What `run`, `analyse` and `check` share: context, cases, and how a run ends.

pub mod adaptive;
pub mod analysis_pass;
pub mod aside;
pub mod case;
pub mod conclude;
pub mod interrupt;
pub mod memory_limit;
pub mod polygon;
pub mod remesh;

use crate::diag::Diagnostics;

/// What a subcommand returns: the exit code of CONTRACT.md, or the faults that ended it.
pub type CommandResult = Result<u8, Diagnostics>;
