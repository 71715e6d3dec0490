//! `bracket verify`: the certificate of a finished result, recomputed from its stored fields and
//! mesh alone.

use super::common::{CommandResult, Common, Format};
use crate::diag::ExitStatus;
use crate::report::console::out;
use crate::result::verify::{Finding, Verification, verify};
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
    let verification = verify(&args.folder)?;
    let confirmed = verification.confirmed();
    match common.format {
        Format::Json => out::json(&serde_json::json!({
            "confirmed": confirmed,
            "bounds": verification.findings,
            "refuted": verification.refuted,
        }))?,
        Format::Text => out::text(&page(&verification))?,
    }
    Ok(if confirmed { ExitStatus::Ok } else { ExitStatus::NotOk })
}

fn page(verification: &Verification) -> String {
    let head =
        ["case", "bound", "claimed", "recomputed", "worst residual", "random points", "finding"];
    let rows: Vec<Vec<String>> = verification.findings.iter().map(row).collect();
    let mut text = out::columns(&head, &rows);
    for sentence in &verification.refuted {
        text += &format!("REFUTED: {sentence}\n");
    }
    if rows.is_empty() {
        text += "the result claims no bound: nothing to confirm\n";
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
