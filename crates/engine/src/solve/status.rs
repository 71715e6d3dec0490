//! Result of a solve: status, unknowns, multipliers. Outcomes are data, not errors.

use super::sparse::patterns::Patterns;
use super::stop_rules::StopRules;
use serde::{Deserialize, Serialize};
use std::sync::Arc;
use std::sync::atomic::AtomicBool;

/// How a solve ended. Only a solution ([`SolveStatus::is_solution`]) can become a bound.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum SolveStatus {
    /// Solved to the requested tolerance.
    Optimal,
    /// Stopped at the limit of the arithmetic, nearly at the requested tolerance
    /// ([`StopRules::nearly`]). The certificate of its fields decides what it is worth.
    AlmostOptimal,
    /// The objective is unbounded along a direction: there is no equilibrium.
    Unbounded,
    /// No point satisfies the cones.
    Infeasible,
    /// Stopped short of the tolerance.
    ReducedAccuracy,
    /// Iteration limit reached.
    IterationLimit,
    /// Time limit reached.
    TimeLimit,
    /// Numerical trouble.
    NumericalError,
    /// Stopped by the user.
    Interrupted,
    /// Not started: the forecast exceeds the available memory.
    TooLarge,
}

impl SolveStatus {
    /// What a solve with a solution ends with.
    pub const SOLUTIONS: [Self; 2] = [SolveStatus::Optimal, SolveStatus::AlmostOptimal];

    /// True for unknowns and multipliers from which fields can be recovered.
    pub fn is_solution(self) -> bool {
        Self::SOLUTIONS.contains(&self)
    }

    /// Wording in reports.
    pub fn words(self) -> &'static str {
        match self {
            SolveStatus::Optimal => "optimal",
            SolveStatus::AlmostOptimal => "almost optimal",
            SolveStatus::Unbounded => "unbounded",
            SolveStatus::Infeasible => "infeasible",
            SolveStatus::ReducedAccuracy => "reduced accuracy",
            SolveStatus::IterationLimit => "iteration limit",
            SolveStatus::TimeLimit => "time limit",
            SolveStatus::NumericalError => "numerical error",
            SolveStatus::Interrupted => "interrupted",
            SolveStatus::TooLarge => "too large for the memory",
        }
    }
}

/// Primal and dual unknowns of a [`crate::programs::ConicProgram`].
///
/// For `Unbounded`, `x` is the direction along which the objective falls.
#[derive(Clone, Debug)]
pub struct Solution {
    /// How the solve ended.
    pub status: SolveStatus,
    /// Unknowns.
    pub x: Vec<f64>,
    /// Multipliers of the cones: `P x + q = Gᵀ z`.
    pub z: Vec<f64>,
    /// Interior-point iterations (1 for a linear solve).
    pub iterations: u32,
    /// Wall time \[s\].
    pub seconds: f64,
}

/// Report of a solver at an iteration.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Iteration {
    /// Number; 0 is the starting point.
    pub number: u32,
    /// Relative duality gap.
    pub gap: f64,
    /// Largest relative residual.
    pub residual: f64,
    /// Length of the step that led to this iterate, 0 to 1; 0 at the start and where the solver
    /// does not report it.
    pub step: f64,
    /// Wall time since the solve began \[s\].
    pub seconds: f64,
}

/// Receiver of the reports, called at every iteration.
pub type Iterations = Arc<dyn Fn(&Iteration) + Send + Sync>;

/// Called before a solve is handed to Clarabel, with the memory that it needs at most \[bytes\];
/// true: it may have them.
pub type HandOver = Arc<dyn Fn(u64) -> bool + Send + Sync>;

/// Which method solves the conic programs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Solver {
    /// The condensed interior-point method; Clarabel solves the program when it ends without an
    /// answer.
    #[default]
    Condensed,
    /// Clarabel, a general interior-point solver.
    Clarabel,
}

/// Limits and reporting of a solve.
#[derive(Clone)]
pub struct SolveOptions {
    /// The method.
    pub solver: Solver,
    /// When a solve ends.
    pub stop: StopRules,
    /// Largest wall time \[s\].
    pub time_limit: f64,
    /// Receives a report of every iteration.
    pub progress: Option<Iterations>,
    /// Decides whether Clarabel takes over; `None`: where the memory of the machine allows it.
    pub hand_over: Option<HandOver>,
    /// Set by the caller to end the solve at the next iteration.
    pub interrupt: Option<Arc<AtomicBool>>,
    /// Known orderings and symbolic factors; clones of these options share them.
    pub patterns: Patterns,
}

impl SolveOptions {
    /// These options with other rules of when to end.
    pub fn with(&self, stop: StopRules) -> Self {
        Self { stop, ..self.clone() }
    }

    /// True once the user has requested a stop.
    pub fn interrupted(&self) -> bool {
        self.interrupt.as_ref().is_some_and(|i| i.load(std::sync::atomic::Ordering::Relaxed))
    }
}

impl Default for SolveOptions {
    fn default() -> Self {
        Self {
            solver: Solver::default(),
            stop: StopRules::default(),
            time_limit: f64::INFINITY,
            progress: None,
            hand_over: None,
            interrupt: None,
            patterns: Patterns::default(),
        }
    }
}
