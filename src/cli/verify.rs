//! `bracket verify`: the certificate of a finished result, recomputed from its stored fields and mesh alone.

use super::analysis::file_stem;
use super::{Common, Format, Outcome, out};
use crate::bounds::bracket::{LowerBound, UpperBound};
use crate::bounds::certificate::{TOLERANCE, certify_displacement, certify_stress};
use crate::bounds::sampling::sample;
use crate::diag::{Diagnostic, Diagnostics};
use crate::model::AnalysisModel;
use crate::model::resolve::load_model;
use crate::report::data::{CaseResult, RESULT_FILE, ResultFile};
use crate::report::field_files::{read_displacement, read_stress};
use serde::Serialize;
use std::path::{Path, PathBuf};

/// Random points tried per field.
const POINTS: usize = 10_000;

/// Recompute the certificate of a finished result.
#[derive(Debug, clap::Args)]
pub struct VerifyArgs {
    /// Result folder.
    #[arg(value_name = "DIR")]
    pub folder: PathBuf,
}

/// What was found for one bound.
#[derive(Clone, Debug, Serialize)]
struct Finding {
    case: String,
    bound: &'static str,
    claimed: f64,
    recomputed: f64,
    worst_residual: f64,
    worst_at_random_points: f64,
    strict: bool,
    confirmed: bool,
}

/// Runs `bracket verify`.
pub fn run(args: &VerifyArgs, common: &Common) -> Outcome {
    let text = read(&args.folder.join(RESULT_FILE))?;
    let result = ResultFile::from_json(&String::from_utf8_lossy(&text)).map_err(Diagnostic::from)?;
    let mut findings = Vec::new();
    for case in &result.cases {
        findings.extend(verify_case(&args.folder, case, result.symmetry)?);
    }
    let confirmed = findings.iter().all(|f| f.confirmed) && findings.len() == claimed_bounds(&result);
    match common.format {
        Format::Json => out::json(&serde_json::json!({"confirmed": confirmed, "bounds": findings}))?,
        Format::Text => {
            let rows: Vec<Vec<String>> = findings
                .iter()
                .map(|f| {
                    vec![
                        f.case.clone(),
                        f.bound.into(),
                        format!("{:.9e}", f.claimed),
                        format!("{:.9e}", f.recomputed),
                        format!("{:.1e}", f.worst_residual),
                        format!("{:.1e}", f.worst_at_random_points),
                        if !f.confirmed {
                            "REFUTED"
                        } else if f.strict {
                            "confirmed"
                        } else {
                            "confirmed as an estimate"
                        }
                        .into(),
                    ]
                })
                .collect();
            let head = ["case", "bound", "claimed", "recomputed", "worst residual", "random points", "finding"];
            out::text(&out::columns(&head, &rows))?;
            if findings.is_empty() {
                out::text("the result claims no bound: nothing to confirm\n")?;
            }
        }
    }
    Ok(u8::from(!confirmed))
}

fn claimed_bounds(result: &ResultFile) -> usize {
    result.cases.iter().map(|c| usize::from(c.lower.is_some()) + usize::from(c.upper.is_some())).sum()
}

fn read(path: &Path) -> Result<Vec<u8>, Diagnostics> {
    std::fs::read(path).map_err(|e| {
        Diagnostic::input("verify/read", format!("`{}` cannot be read: {e}", path.display()))
            .file(path)
            .help("name the folder of a finished result, as `bracket run` or `bracket analyse` left it")
            .into()
    })
}

fn verify_case(folder: &Path, case: &CaseResult, symmetry: u32) -> Result<Vec<Finding>, Diagnostics> {
    let own = folder.join(format!("model_{}.yaml", file_stem(&case.name)));
    let model = load_model(&if own.exists() { own } else { folder.join("model.yaml") })?;
    let claims_strict = case.certificate.is_some_and(|c| c.strict);
    let field = |kind: &str| folder.join("fields").join(format!("{}_{kind}.vtu", file_stem(&case.name)));
    let mut findings = Vec::new();
    if let Some(claimed) = case.lower {
        findings.push(lower(&model, &read(&field("static"))?, case, claimed, claims_strict, symmetry)?);
    }
    if let Some(claimed) = case.upper.and_then(|u| u.finite()) {
        findings.push(upper(&model, &read(&field("kinematic"))?, case, claimed, claims_strict, symmetry)?);
    }
    Ok(findings)
}

fn lower(
    model: &AnalysisModel,
    bytes: &[u8],
    case: &CaseResult,
    claimed: f64,
    claims_strict: bool,
    symmetry: u32,
) -> Result<Finding, Diagnostics> {
    let stress = read_stress(model, bytes).map_err(Diagnostic::from)?;
    let sampled = sample(model, None, Some(&stress), POINTS);
    let bound = LowerBound::new(certify_stress(model, &stress), symmetry);
    let c = bound.certificate();
    let worst = c.equilibrium.max(c.traction_jump).max(c.contact.unwrap_or(0.0));
    let random = sampled.traction_jump.max(sampled.traction_cone);
    Ok(finding(case, "lower", [claimed, bound.value(), worst, random], bound.is_strict(), claims_strict))
}

fn upper(
    model: &AnalysisModel,
    bytes: &[u8],
    case: &CaseResult,
    claimed: f64,
    claims_strict: bool,
    symmetry: u32,
) -> Result<Finding, Diagnostics> {
    let displacement = read_displacement(model, bytes).map_err(Diagnostic::from)?;
    let sampled = sample(model, Some(&displacement), None, POINTS);
    let bound = UpperBound::new(certify_displacement(model, &displacement), symmetry);
    let c = bound.certificate();
    let worst = c.compatibility.max(c.contact.unwrap_or(0.0));
    Ok(finding(case, "upper", [claimed, bound.value(), worst, sampled.gap_cone], bound.is_strict(), claims_strict))
}

/// Confirmed: the same number to 1e-9, and strict where strictness is claimed, at random points as well.
fn finding(
    case: &CaseResult,
    bound: &'static str,
    [claimed, recomputed, worst_residual, worst_at_random_points]: [f64; 4],
    strict: bool,
    claims_strict: bool,
) -> Finding {
    let same = (claimed - recomputed).abs() <= 1e-9 * claimed.abs().max(recomputed.abs());
    let admissible = strict && worst_at_random_points <= TOLERANCE;
    Finding {
        case: case.name.clone(),
        bound,
        claimed,
        recomputed,
        worst_residual,
        worst_at_random_points,
        strict: admissible,
        confirmed: same && (admissible || !claims_strict),
    }
}
