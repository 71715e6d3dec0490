//! Options and errors of a pass: both programs on one mesh.

use crate::analysis::memory::{RoomSource, room};
use crate::certify::bracket::Contradiction;
use crate::model::ModelError;
use crate::solve::SolveOptions;
use bracket_base::diag::Diagnostic;
use std::sync::Arc;
use std::time::Instant;

/// Limits of a pass.
#[derive(Clone)]
pub struct PassOptions {
    /// Options of each solve; the time limit counts from the start of the pass.
    pub solve: SolveOptions,
    /// Source of the memory available for solves.
    pub room: RoomSource,
    /// Limit analysis with friction. `None`: the static program is solved with and without
    /// friction. `Some(at)`: only for the bound that answers the friction law. Under Coulomb's law
    /// that is the one without friction; with associated friction the one without friction is
    /// added where the one with friction reaches the load factor `at`.
    pub answer_from: Option<f64>,
    /// Limit analysis: both programs run if their solves are expected to take at most this long
    /// together \[s\]. Otherwise the static one runs alone, because the lower bound decides, and
    /// [`crate::analysis::limit::add_upper`] adds the upper bound. 0: the static one runs alone.
    pub both_within: f64,
}

impl Default for PassOptions {
    /// Default solves, limited by the memory of the machine.
    fn default() -> Self {
        let room: RoomSource = Arc::new(|| room(None));
        Self { solve: SolveOptions::default(), room, answer_from: None, both_within: f64::INFINITY }
    }
}

impl PassOptions {
    /// The same options for a later part of a pass, with the time limit that is left of it.
    pub(crate) fn remaining(&self, start: Instant) -> Self {
        let mut options = self.clone();
        options.solve.time_limit =
            (options.solve.time_limit - start.elapsed().as_secs_f64()).max(0.0);
        options
    }
}

/// Why a pass could not run, or why its results contradict each other.
#[derive(Debug, thiserror::Error)]
pub enum PassError {
    /// A program could not be built.
    #[error(transparent)]
    Model(#[from] ModelError),
    /// The two bounds contradict each other.
    #[error(transparent)]
    Contradiction(#[from] Contradiction),
    /// The contributions of elements and contacts do not sum to the gap: the two certificates are
    /// inconsistent.
    #[error("the contributions to the gap sum to {sum:.9e}, the bounds differ by {gap:.9e}")]
    Identity {
        /// Upper bound less lower bound of the meshed part.
        gap: f64,
        /// Sum of the contributions.
        sum: f64,
    },
}

impl From<PassError> for Diagnostic {
    fn from(e: PassError) -> Self {
        match e {
            PassError::Model(e) => e.into(),
            e => Diagnostic::undecided("bounds/contradiction", e.to_string()).help(
                "the numbers are withheld; try another mesh or `--solver clarabel`, and report \
                 the case",
            ),
        }
    }
}

/// Checks Σ contributions = upper − lower, to 1e-8 of the largest of the bounds, the sum and
/// `scale`, another measure of their size.
pub(crate) fn check_identity(
    [lower, upper]: [f64; 2],
    scale: f64,
    sum: f64,
) -> Result<(), PassError> {
    let gap = upper - lower;
    if (gap - sum).abs() > 1e-8 * lower.abs().max(upper.abs()).max(scale).max(sum) {
        return Err(PassError::Identity { gap, sum });
    }
    Ok(())
}
