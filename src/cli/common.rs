//! Options of every subcommand.

use crate::driver::present::Finished;
use bracket_base::diag::{Diagnostic, Diagnostics, ExitStatus};
use bracket_report::console::out;
use clap::ValueEnum;

/// How a subcommand ends: with an exit status, or with the faults that stopped it.
pub type CommandResult = Result<ExitStatus, Diagnostics>;

/// Form of the data on standard output.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub enum Format {
    /// For people.
    #[default]
    Text,
    /// For programs.
    Json,
}

/// Options every subcommand takes.
#[derive(Clone, Debug, clap::Args)]
pub struct Common {
    /// Form of the data on standard output.
    #[arg(long, global = true, value_enum, default_value = "text")]
    pub format: Format,
    /// Threads to use (default: all).
    #[arg(long, global = true, value_name = "N")]
    pub threads: Option<usize>,
    /// Show no progress and no messages, only errors.
    #[arg(long, short, global = true)]
    pub quiet: bool,
}

impl Common {
    /// Prints the result of a run as JSON if the user asked for it; returns the exit status.
    pub fn print_result(&self, finished: &Finished) -> CommandResult {
        if finished.written && self.format == Format::Json {
            out::data(&finished.result.to_json().map_err(Diagnostic::from)?)?;
        }
        Ok(finished.status)
    }
}
