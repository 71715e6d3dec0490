//! The `bracket` command.

use clap::Parser;
use std::process::ExitCode;

fn main() -> ExitCode {
    let cli = bracket::cli::Cli::parse();
    match bracket::cli::dispatch(&cli) {
        Ok(code) => ExitCode::from(code),
        Err(faults) => {
            for fault in &faults.0 {
                eprintln!("error[{}]: {fault}", fault.code);
            }
            ExitCode::from(faults.exit_code())
        }
    }
}
