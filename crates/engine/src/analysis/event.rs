//! Events that the programs of a pass report while they run.

use crate::analysis::memory::Room;
use crate::analysis::program::Program;
use crate::analysis::program_outcome::{InsufficientMemory, ProgramOutcome};
use crate::solve::{Forecast, Iteration};
use std::sync::Arc;

/// A step of one program.
#[derive(Clone, Copy, Debug)]
pub enum Event<'a> {
    /// Its assembly begins.
    Assembly,
    /// It is assembled and ordered.
    Forecast {
        /// Unknowns.
        unknowns: usize,
        /// Expected cost of the solve; `None` where the solver gives no forecast.
        forecast: Option<&'a Forecast>,
    },
    /// It waits until the other program has ended, because both together do not fit.
    Waits {
        /// Memory that both need side by side \[bytes\].
        needed: u64,
        /// Memory that is available.
        room: Room,
    },
    /// Limit analysis under a time limit: it runs later, because the other program decides.
    Later {
        /// Time that both are expected to take \[s\]; infinite where it is not known.
        expected: f64,
        /// Time that is there for both \[s\].
        within: f64,
    },
    /// It does not fit and is not started, while the other program is.
    Refused(&'a InsufficientMemory),
    /// Its solve begins.
    Solve {
        /// Expected cost; `None` where the solver gives no forecast.
        forecast: Option<&'a Forecast>,
    },
    /// The next iterate of the solver.
    Iteration(&'a Iteration),
    /// The solver ended without an answer, and Clarabel takes over.
    HandOver {
        /// Memory that it needs at most \[bytes\].
        bytes: u64,
    },
    /// Preload: both programs tighten the bolts before the loads act.
    Tightening,
    /// Coulomb friction: it is solved again with its contact cones shifted by the slips so far.
    ConeShift {
        /// Solves so far.
        solves: usize,
        /// Largest change of the shift in the last of them, over the largest shift.
        change: f64,
    },
    /// Its field is being recovered and certified.
    Certify,
    /// Limit analysis: the static program is solved again with every friction coefficient zero.
    Frictionless,
    /// Limit analysis: the fixed point for Coulomb's law begins.
    Coulomb,
    /// It is solved again with yield conditions on part of the tets.
    Yielding {
        /// Tets with a yield condition.
        tets: usize,
    },
    /// It has ended.
    Ended(&'a ProgramOutcome),
}

/// Callback that receives the events of both programs, also from several threads.
pub type Progress = Arc<dyn Fn(Program, Event<'_>) + Send + Sync>;

/// A callback that ignores all events.
pub fn silent() -> Progress {
    Arc::new(|_, _| {})
}
