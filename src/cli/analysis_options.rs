//! Options of the commands that analyse.

use crate::driver::limits::Limits;
use bracket_base::diag::Diagnostics;
use bracket_engine::solve::Solver;
use std::path::{Path, PathBuf};

/// Which solver solves the conic programs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, clap::ValueEnum)]
pub enum SolverChoice {
    /// The condensed interior-point method: one sparse factor per iteration.
    #[default]
    Condensed,
    /// Clarabel, a general interior-point solver.
    Clarabel,
}

impl From<SolverChoice> for Solver {
    fn from(choice: SolverChoice) -> Self {
        match choice {
            SolverChoice::Condensed => Solver::Condensed,
            SolverChoice::Clarabel => Solver::Clarabel,
        }
    }
}

/// Options of an analysis.
#[derive(Clone, Debug, clap::Args)]
pub struct AnalysisOptions {
    /// Folder for the result (default: named after the input, beside it).
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
    /// Solver of the conic programs.
    #[arg(long, value_enum, default_value = "condensed")]
    pub solver: SolverChoice,
    /// Memory the run may use in all, for example 8GiB (default: what the machine has left).
    #[arg(long, value_name = "SIZE", allow_hyphen_values = true)]
    pub memory_limit: Option<String>,
}

impl AnalysisOptions {
    /// The result folder for an input file.
    pub fn folder(&self, input: &Path) -> PathBuf {
        self.out.clone().unwrap_or_else(|| input.with_extension(""))
    }

    /// The limits of a run, as far as the options set them; see [`Limits::new`].
    pub fn limits(&self) -> Result<Limits, Diagnostics> {
        Limits::new(self.solver.into(), self.memory_limit.as_deref())
    }
}
