//! Recomputation of the load steps of a case from their stored fields.

use super::case_files::CaseFiles;
use super::derived::Reference;
use super::finding::Finding;
use super::measured::same;
use crate::result::case_result::CaseResult;
use crate::result::certificate::Certificate;
use crate::result::evidence::Side;
use crate::result::file_names::step_suffix;
use crate::result::load_step::without_steps;
use crate::result::preload::close_cuts;
use crate::result::quantity::Upper;
use crate::result::step_bounds::{add_loads, step_of, step_of_case};
use bracket_base::diag::Diagnostics;
use bracket_engine::model::{AnalysisKind, AnalysisModel};
use serde_json::json;
use std::path::Path;

/// Recomputes the load steps of a case; `model` is that of its upper bound. A step at load factor 1
/// is the case itself.
pub(super) fn verify_steps(
    (folder, stem): (&Path, &str),
    case: &CaseResult,
    model: &AnalysisModel,
    reference: Option<&Reference>,
    refuted: &mut Vec<String>,
) -> Result<Vec<Finding>, Diagnostics> {
    let asked = reference.map_or(&[][..], |r| &r.load_steps);
    let asked = if case.analysis == AnalysisKind::Elastoplastic { asked } else { &[] };
    let given: Vec<f64> = case.load_steps.iter().map(|s| s.factor).collect();
    let lacking: Vec<f64> = asked.iter().copied().filter(|f| !given.contains(f)).collect();
    let rest: Vec<f64> = asked.iter().copied().filter(|f| given.contains(f)).collect();
    let excused = lacking.is_empty() || case.warnings.contains(&without_steps(&lacking));
    if rest != given || !excused {
        refuted.push(format!("{}: `load_steps` are not those of the spec", case.name));
        return Ok(Vec::new());
    }
    let mut base = model.clone();
    close_cuts(&mut base, &case.preload);
    let plan = reference.and_then(|r| r.evidence.as_ref());
    let mut findings = Vec::new();
    let mut found = Vec::new();
    for step in &case.load_steps {
        if step.factor == 1.0 {
            found.push(step_of_case(case));
            continue;
        }
        let number = asked.iter().position(|f| *f == step.factor).map_or(0, |i| i + 1);
        let scaled = base.at_load_factor(step.factor);
        let claimed = CaseResult {
            name: format!("{} at {}", case.name, step.factor),
            lower: step.lower,
            upper: step.upper.map(Upper::Finite),
            certificate: case.certificate.map(|c| Certificate { strict: step.strict, ..c }),
            ..case.clone()
        };
        let files = CaseFiles {
            model: &scaled,
            case: &claimed,
            folder,
            stem,
            suffix: &step_suffix(number),
            wanted: [true, true, false],
        };
        let (new, entry, pass) = files.energies(refuted)?;
        findings.extend(new);
        let side = Side { model: &scaled, pass: &pass };
        let bolts = plan.map_or(Vec::new(), |plan| plan.bolts(side, side));
        found.push(step_of(step.factor, &entry, bolts));
    }
    add_loads(&mut found, &base, case.problem);
    for (claimed, found) in case.load_steps.iter().zip(&found) {
        if !same(&json!(claimed), &json!(found)) {
            refuted.push(format!(
                "{}: the load step {} is not what the fields give",
                case.name, claimed.factor
            ));
        }
    }
    Ok(findings)
}
