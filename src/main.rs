//! The `bracket` command.

use bracket::cli::commands::Cli;
use bracket::cli::commands::dispatch;
use bracket::cli::common::Format;
use bracket::diag_render;
use clap::Parser;
use std::io::{IsTerminal, Write};
use std::process::ExitCode;

fn main() -> ExitCode {
    let cli = Cli::parse();
    match dispatch(&cli) {
        Ok(status) => ExitCode::from(status.code()),
        Err(faults) => {
            let mut stderr = std::io::stderr();
            let text = match cli.common.format {
                Format::Json => diag_render::json(&faults),
                // https://no-color.org: any non-empty value switches colour off
                Format::Text => diag_render::text(
                    &faults,
                    stderr.is_terminal()
                        && std::env::var_os("NO_COLOR").is_none_or(|v| v.is_empty()),
                ),
            };
            // standard error may be closed; the exit code still reports the fault
            let _ = stderr.write_all(text.as_bytes());
            ExitCode::from(faults.exit_code())
        }
    }
}
