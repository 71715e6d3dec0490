//! How the solve of one program ended, and what it cost.

use crate::analysis::memory::Room;
use crate::analysis::program::Program;
use crate::solve::{Forecast, Iteration, SolveStatus};
use bracket_base::words::Text;

/// A program that was not started because its solve does not fit into the memory.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct InsufficientMemory {
    /// Memory its solve needs \[bytes\].
    pub needed: u64,
    /// Memory that was available.
    pub room: Room,
}

/// How one program of a pass ended.
///
/// `result.json` holds it as a `ProgramRun`.
#[derive(Clone, Debug)]
pub struct ProgramOutcome {
    /// How the solve ended.
    pub status: SolveStatus,
    /// Iterations.
    pub iterations: u32,
    /// Unknowns.
    pub dofs: usize,
    /// Contact cones.
    pub cones: usize,
    /// Time to assemble \[s\].
    pub assembly_seconds: f64,
    /// Time to order and solve \[s\].
    pub solve_seconds: f64,
    /// Time to recover and certify the field \[s\].
    pub certify_seconds: f64,
    /// Expected cost of the solve; `None` where the solver gives no forecast.
    pub forecast: Option<Forecast>,
    /// Memory that Clarabel needed at most \[bytes\], where it took over; otherwise 0.
    pub handed_over: u64,
    /// Every iteration, seconds counted from the start of the solve. The numbers start again where
    /// another solver took over or another problem of a sequence began.
    pub trace: Vec<Iteration>,
    /// For a program too large for the memory: needed and available memory.
    pub refusal: Option<InsufficientMemory>,
    /// Elastic, perfectly plastic analysis: tets with a yield condition in the last solve.
    pub yielding: Option<usize>,
    /// Number of solves.
    pub rounds: u32,
    /// For an unbounded program: the parts that move.
    pub mechanism: Option<Text>,
    /// For an infeasible program: the contacts that exclude each other.
    pub conflict: Option<Text>,
    /// For a solve that ended without a solution and without a certificate: the tets whose shape
    /// can be the cause.
    pub long_tets: Option<Text>,
    /// Why no field could be certified although the solve ended with an optimal solution.
    pub trouble: Option<Text>,
}

/// The programs that ran or were to run, each with its outcome.
pub(crate) fn outcomes<'a>(
    kinematic: &'a Option<ProgramOutcome>,
    statics: &'a Option<ProgramOutcome>,
) -> impl Iterator<Item = (Program, &'a ProgramOutcome)> {
    let kinematic = kinematic.iter().map(|r| (Program::Kinematic, r));
    kinematic.chain(statics.iter().map(|r| (Program::Static, r)))
}
