//! What a solve returns: status, unknowns, multipliers. Outcomes are data, not errors.

use super::sparse::patterns::Patterns;
use serde::{Deserialize, Serialize};
use std::sync::Arc;
use std::sync::atomic::AtomicBool;

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
    /// Not started: the forecast exceeds the memory there is.
    TooLarge,
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

/// What a solver tells at every iteration.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Iteration {
    /// Its number; 0 is the starting point.
    pub number: u32,
    /// Relative duality gap.
    pub gap: f64,
    /// Largest relative residual.
    pub residual: f64,
    /// Length of the step that led here, 0 to 1; 0 at the start and where the solver does not tell.
    pub step: f64,
    /// Wall time since the solve began \[s\].
    pub seconds: f64,
}

/// Told at every iteration.
pub type Iterations = Arc<dyn Fn(&Iteration) + Send + Sync>;

/// Which method solves the conic programs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Solver {
    /// The condensed interior-point method, with Clarabel behind it when it ends without an answer.
    #[default]
    Condensed,
    /// Clarabel, a general interior-point solver.
    Clarabel,
}

/// Relative gap at which limit analysis stops: its bounds are certified whatever the solver leaves.
pub const LIMIT_GAP: f64 = 1e-4;

/// Residual at which solves of limit analysis end, in gaps: what stresses leave unbalanced is paid
/// for in the lower bound. Measured on a bolted joint at a gap of 1e-4: 7e-5 of it.
const LIMIT_RESIDUAL: f64 = 1e-2;
/// The same of the balance of forces beside velocities. The upper bound comes from the velocities
/// alone, whose cones hold long before the stresses beside them balance. Measured on the joint:
/// 8e-5 of the upper bound, after a third of the iterations.
const MECHANISM_UNBALANCED: f64 = 10.0;

/// Limits and reporting of a solve.
#[derive(Clone)]
pub struct SolveOptions {
    /// The method.
    pub solver: Solver,
    /// Relative duality gap at which to stop.
    pub gap: f64,
    /// The same for passes of limit analysis, whose bounds are certified whatever the solver
    /// leaves.
    pub limit_gap: f64,
    /// Relative residuals at which to stop.
    ///
    /// An iterate that stalls within a hundred times (in limit analysis ten times) the gap and the
    /// residual asked for is taken.
    pub residual: f64,
    /// Forces may be so far out of balance (and strains from flow), relative to the largest, where
    /// that is more than the residual.
    pub unbalanced: f64,
    /// Iterations at most.
    pub max_iterations: u32,
    /// Wall time at most \[s\].
    pub time_limit: f64,
    /// Told every iteration.
    pub progress: Option<Iterations>,
    /// Set from outside to end the solve at the next iteration.
    pub interrupt: Option<Arc<AtomicBool>>,
    /// Orderings and symbolic factors that are known; clones of these options share them.
    pub patterns: Patterns,
}

impl SolveOptions {
    /// The same limits for a solve for the velocities of limit analysis.
    pub fn for_mechanism(&self) -> Self {
        Self { unbalanced: MECHANISM_UNBALANCED * self.limit_gap, ..self.for_resistance() }
    }

    /// The same limits for a solve for its stresses.
    pub fn for_resistance(&self) -> Self {
        Self {
            gap: self.limit_gap,
            residual: self.residual.max(LIMIT_RESIDUAL * self.limit_gap),
            ..self.clone()
        }
    }

    /// True once the user has asked to stop.
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
            interrupt: None,
            patterns: Patterns::default(),
        }
    }
}
