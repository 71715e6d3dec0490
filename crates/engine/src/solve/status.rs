//! Result of a solve: status, unknowns, multipliers. Outcomes are data, not errors.

use super::sparse::patterns::Patterns;
use serde::{Deserialize, Serialize};
use std::sync::Arc;
use std::sync::atomic::AtomicBool;

/// How a solve ended. Only `Optimal` can become a bound.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum SolveStatus {
    /// Solved to the requested tolerance.
    Optimal,
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
    /// Wording in reports.
    pub fn words(self) -> &'static str {
        match self {
            SolveStatus::Optimal => "optimal",
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

/// Relative gap at which limit analysis stops; its bounds are certified at any accuracy of the
/// solver.
pub const LIMIT_GAP: f64 = 1e-4;

/// Residual at which solves of limit analysis end, relative to the gap.
///
/// Unbalanced stresses reduce the lower bound. Measured on three bolted joints at a gap of 1e-4: by
/// 3e-5 to 5e-4 of the bound. 1e-2 reduces it by at most 4e-5 and takes 20 to 42 % longer; 1
/// reduces it by up to 4e-3. The upper bound is 0 to 4e-4 higher than with 1e-2.
const LIMIT_RESIDUAL: f64 = 1e-1;
/// The same for the balance of forces in a solve for velocities. The upper bound is computed from
/// the velocities alone, whose cones hold long before the stresses balance. Measured on the joint:
/// 8e-5 of the upper bound, after a third of the iterations.
const MECHANISM_UNBALANCED: f64 = 10.0;

/// Limits and reporting of a solve.
#[derive(Clone)]
pub struct SolveOptions {
    /// The method.
    pub solver: Solver,
    /// Relative duality gap at which to stop.
    pub gap: f64,
    /// The same for limit analysis, whose bounds are certified at any accuracy of the solver.
    pub limit_gap: f64,
    /// Relative residuals at which to stop.
    ///
    /// An iterate that stalls within a hundred times (in limit analysis ten times) the requested
    /// gap and residual is accepted.
    pub residual: f64,
    /// Relative imbalance of forces, and error of strains, at which to stop, where it exceeds
    /// `residual`.
    pub unbalanced: f64,
    /// Largest number of iterations.
    pub max_iterations: u32,
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
    /// Options for a solve for the velocities of limit analysis.
    pub fn for_mechanism(&self) -> Self {
        Self { unbalanced: MECHANISM_UNBALANCED * self.limit_gap, ..self.for_resistance() }
    }

    /// Options for a solve for the stresses of limit analysis.
    pub fn for_resistance(&self) -> Self {
        Self {
            gap: self.limit_gap,
            residual: self.residual.max(LIMIT_RESIDUAL * self.limit_gap),
            ..self.clone()
        }
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
            gap: 1e-8,
            limit_gap: LIMIT_GAP,
            residual: 1e-8,
            unbalanced: 0.0,
            max_iterations: 100,
            time_limit: f64::INFINITY,
            progress: None,
            hand_over: None,
            interrupt: None,
            patterns: Patterns::default(),
        }
    }
}
