//! Solver and limits of a run: time, memory, threads, and the user's interrupt.

use crate::driver::interrupt::Interrupt;
use crate::driver::memory_limit;
use bracket_base::diag::{Diagnostic, Diagnostics};
use bracket_engine::solve::Solver;

/// Effect of the first Ctrl-C, as the log announces it.
pub const WHEN_INTERRUPTED: &str = "the mesher stops now, the solvers after their current \
                                    iteration, and certified results are written";

/// Solver of the conic programs, and the limits that end a run early. The default has no limit, and
/// receives no signals.
#[derive(Clone, Default)]
pub struct Limits {
    /// The requested solver.
    pub solver: Solver,
    /// Wall time the run may take \[s\].
    pub time: Option<f64>,
    /// Memory the process may use \[bytes\].
    pub memory: Option<u64>,
    /// The user's request to stop.
    pub interrupt: Interrupt,
}

impl Limits {
    /// The limits, with the text of `--memory-limit`; an invalid text is refused. Call it before
    /// any thread starts: from this call on the user's interrupts are received.
    pub fn new(solver: Solver, memory_limit: Option<&str>) -> Result<Self, Diagnostics> {
        let memory = memory_limit.map(memory_limit::parse).transpose()?;
        Ok(Limits { solver, time: None, memory, interrupt: Interrupt::watch()? })
    }

    /// The limits with the time limit of a spec \[s\]; the earlier one holds.
    pub fn within(&self, time: Option<f64>) -> Self {
        let time = [self.time, time].into_iter().flatten().reduce(f64::min);
        Self { time, ..self.clone() }
    }
}

/// Sets the number of threads of the process; `None`: one per processor.
pub fn use_threads(threads: Option<usize>) -> Result<(), Diagnostics> {
    let Some(n) = threads else { return Ok(()) };
    if !(1..=1024).contains(&n) {
        let d = Diagnostic::input(
            "cli/value",
            format!("--threads is {n}, it must be between 1 and 1024"),
        );
        return Err(d.help("leave the option out to use every processor").into());
    }
    // a second call in one process (tests) keeps the first pool
    let _ = rayon::ThreadPoolBuilder::new().num_threads(n).build_global();
    Ok(())
}
