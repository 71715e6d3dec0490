//! What a solve returns: status, unknowns, multipliers. Outcomes are data, not errors.

use serde::{Deserialize, Serialize};
use std::sync::Arc;

/// How a solve ended. Only `Optimal` can become a bound.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum SolveStatus {
    /// Solved to the asked tolerance.
    Optimal,
    /// The objective falls without limit along a direction: no equilibrium.
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
}

impl SolveStatus {
    /// In the words of a report.
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
        }
    }
}

/// Primal and dual unknowns of a [`crate::model::ConicProgram`].
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

/// Told at every iteration: its number, the relative gap, the residual.
pub type Iterations = Arc<dyn Fn(u32, f64, f64) + Send + Sync>;

/// Which method solves the conic programs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Solver {
    /// The condensed interior-point method, with Clarabel behind it when it ends without an answer.
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
    /// Relative duality gap and residuals at which to stop; an iterate that stalls within a hundred times this is taken.
    pub tolerance: f64,
    /// Iterations at most.
    pub max_iterations: u32,
    /// Wall time at most \[s\].
    pub time_limit: f64,
    /// Told every iteration.
    pub progress: Option<Iterations>,
}

impl Default for SolveOptions {
    fn default() -> Self {
        Self {
            solver: Solver::default(),
            tolerance: 1e-9,
            max_iterations: 100,
            time_limit: f64::INFINITY,
            progress: None,
        }
    }
}
