//! `bracket verify`: the certificate of a finished result, recomputed from its stored fields and
//! mesh alone.

use super::common::{CommandResult, Common, Format};
use crate::driver::interrupt::Interrupt;
use crate::driver::verify_folder::{Verified, verify_folder};
use bracket_base::diag::{ExitStatus, in_line};
use bracket_report::console::out;
use bracket_report::result::verify::Finding;
use std::path::PathBuf;

/// Recompute the certificate of a finished result.
#[derive(Debug, clap::Args)]
pub struct VerifyArgs {
    /// Result folder.
    #[arg(value_name = "DIR")]
    pub folder: PathBuf,
}

/// Runs `bracket verify`.
pub fn run(args: &VerifyArgs, common: &Common) -> CommandResult {
    // nothing is written, so that a signal ends the program at once
    Interrupt::watch()?;
    let verified = verify_folder(&args.folder)?;
    let confirmed = verified.confirmed();
    match common.format {
        Format::Json => out::json(&serde_json::json!({
            "confirmed": confirmed,
            "bounds": verified.bounds,
            "refuted": verified.refuted,
            "recomputed": verified.recomputed,
            "recorded": verified.recorded,
        }))?,
        Format::Text => out::text(&page(&verified))?,
    }
    Ok(if confirmed { ExitStatus::Ok } else { ExitStatus::NotOk })
}

fn page(verified: &Verified) -> String {
    let head =
        ["case", "bound", "claimed", "recomputed", "worst residual", "random points", "finding"];
    let rows: Vec<Vec<String>> = verified.bounds.iter().map(row).collect();
    let mut text = out::columns(&head, &rows);
    if rows.is_empty() {
        text = "the result claims no bound\n".into();
    }
    for sentence in &verified.refuted {
        text += &format!("REFUTED: {}\n", in_line(sentence));
    }
    for what in &verified.recomputed {
        text += &format!("recomputed: {}\n", in_line(what));
    }
    for what in &verified.recorded {
        text += &format!("recorded, not recomputed: {}\n", in_line(what));
    }
    text
}

fn row(f: &Finding) -> Vec<String> {
    let finding = match (f.confirmed, f.strict) {
        (false, _) => "REFUTED",
        (true, true) => "confirmed",
        (true, false) => "confirmed as an estimate",
    };
    vec![
        f.case.clone(),
        f.bound.into(),
        format!("{:.9e}", f.claimed),
        format!("{:.9e}", f.recomputed),
        format!("{:.1e}", f.worst_residual),
        format!("{:.1e}", f.worst_at_random_points),
        finding.into(),
    ]
}
