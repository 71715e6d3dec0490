//! What `verify` computes again from the spec of a result: the models, the hand checks, the demands
//! and the verdicts.

use crate::checks::HandChecks;
use crate::checks::verdict::Verdict;
use crate::diag::Diagnostics;
use crate::driver::demands::demands;
use crate::driver::finish::{certified, judge_result};
use crate::driver::run_cases::safe_utilisation;
use crate::driver::spec_context::spec_checks;
use crate::driver::spec_file::{self, SpecFile};
use crate::mesh::msh;
use crate::mesh::naming::symmetry_face;
use crate::model::file::ModelFile;
use crate::model::from_joint;
use crate::report::markdown::report_data::ReportData;
use crate::result::case_result::CaseResult;
use crate::result::demand::Demand;
use crate::result::file_names::entry_stem;
use crate::result::result_file::ResultFile;
use crate::result::stiffness::joint_stiffness;
use crate::spec::yaml;
use crate::text_file;
use serde_json::{Value, json};
use std::path::Path;

/// Relative difference allowed between a claimed and a recomputed number.
const SAME: f64 = 1e-9;

/// The outcome of the second computation.
pub enum Again {
    /// It was made.
    Recomputed {
        /// What was computed.
        what: &'static str,
        /// A sentence for each difference.
        differences: Vec<String>,
    },
    /// It could not be made.
    Recorded {
        /// What stays as recorded, and why.
        what: String,
    },
}

/// Computes again what a result says beside its bounds.
pub fn judged_again(folder: &Path, result: &ResultFile, data: &ReportData) -> Again {
    if !yaml::top_level(&data.input_text, "template") {
        let differences = of_model(result);
        return Again::Recomputed { what: "utilisations; a model has no demand", differences };
    }
    // templates and tables of the user are found if they lie in the result folder
    match spec_file::parse(&data.input_text, &folder.join(&data.input_name), None) {
        Ok(input) => Again::Recomputed {
            what: "the models, `checks`, demands and verdicts, from the spec",
            differences: of_spec(folder, result, &input),
        },
        Err(faults) => {
            let why = faults.into_first().message;
            Again::Recorded {
                what: format!(
                    "the models, `checks`, demands and verdicts; the spec cannot be read here \
                     ({why}): with its templates and tables copied into the folder they are \
                     recomputed"
                ),
            }
        }
    }
}

/// Differences of a result of a model file, which has no checks and no demand.
fn of_model(result: &ResultFile) -> Vec<String> {
    let mut again = result.clone();
    for case in &mut again.cases {
        case.utilisation = safe_utilisation(case);
        case.demand = None;
        case.joint_stiffness = None;
    }
    (again.verdict, again.judgement) = (Verdict::None, None);
    again.checks.clear();
    compared(result, &again)
}

/// Differences of a result of a spec.
fn of_spec(folder: &Path, result: &ResultFile, input: &SpecFile) -> Vec<String> {
    let mut checks = spec_checks(input);
    let demands = demands(&input.spec.value.loads);
    let mut again = result.clone();
    for case in &mut again.cases {
        case.utilisation = safe_utilisation(case);
        let demand = demands.iter().find(|d| d.case == case.name);
        case.demand =
            demand.map(|d| Demand::new(case, certified(case), d.actions.clone(), &checks));
        case.joint_stiffness = joint_stiffness(case, &checks.moments);
    }
    judge_result(&mut again, &mut checks, &demands);
    let mut out = compared(result, &again);
    out.extend(warnings_missing(result, &checks));
    for (i, case) in result.cases.iter().enumerate() {
        let stem = entry_stem(&result.cases[..i], case);
        match models_differ(folder, &stem, case, input) {
            Ok(found) => out.extend(found),
            Err(faults) => out.push(format!("{}: {}", case.name, faults.into_first().message)),
        }
    }
    out
}

/// Notes of the checks that the result must contain.
fn warnings_missing(result: &ResultFile, checks: &HandChecks) -> Vec<String> {
    let missing = checks.notes.iter().filter(|n| !result.warnings.contains(n));
    missing.map(|n| format!("the warning \"{n}\" is missing")).collect()
}

/// Differences between the stored models of a case and those that the spec gives.
fn models_differ(
    folder: &Path,
    stem: &str,
    case: &CaseResult,
    input: &SpecFile,
) -> Result<Vec<String>, Diagnostics> {
    let own = folder.join(format!("model_{stem}.yaml"));
    let mut files = vec![if own.exists() { own } else { folder.join("model.yaml") }];
    for kind in ["static", "static_frictionless"] {
        let beside = folder.join("fields").join(format!("{stem}_{kind}.yaml"));
        files.extend(beside.exists().then_some(beside));
    }
    let mut out = Vec::new();
    for path in files {
        let text = text_file::read(&path, |e| {
            crate::diag::Diagnostic::input("verify/read", format!("the model cannot be read: {e}"))
                .file(&path)
        })?;
        let stored = yaml::parse::<ModelFile>(&text, &path)?.value;
        let mesh = msh::read(&path.parent().unwrap_or(folder).join(&stored.mesh))?;
        let assembly = &input.joint.assembly;
        let has = |axis: usize| stored.supports.iter().any(|s| s.face == symmetry_face(axis));
        let symmetry: Vec<_> = assembly.symmetry.iter().filter(|p| has(p.axis)).cloned().collect();
        let mut found = from_joint::model_file(
            assembly,
            &mesh,
            &symmetry,
            &stored.mesh,
            &case.name,
            case.analysis,
        );
        // a request, which changes no bound
        found.coulomb_estimate = stored.coulomb_estimate;
        found.symmetry = stored.symmetry;
        let pair = [&stored, &found].map(|m| json!(m));
        let place = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
        out.extend(first_difference(&pair[0], &pair[1], &place));
    }
    Ok(out)
}

/// Sentences about what the spec and the bounds give otherwise.
fn compared(claimed: &ResultFile, again: &ResultFile) -> Vec<String> {
    let mut out = Vec::new();
    let mut pair = |name: &str, a: Value, b: Value| out.extend(first_difference(&a, &b, name));
    pair("verdict", json!(claimed.verdict), json!(again.verdict));
    pair("judgement", json!(claimed.judgement), json!(again.judgement));
    pair("checks", json!(claimed.checks), json!(again.checks));
    for (a, b) in claimed.cases.iter().zip(&again.cases) {
        let name = |key: &str| format!("{}: {key}", a.name);
        pair(&name("utilisation"), json!(a.utilisation), json!(b.utilisation));
        pair(&name("demand"), json!(a.demand), json!(b.demand));
        pair(&name("joint_stiffness"), json!(a.joint_stiffness), json!(b.joint_stiffness));
    }
    out
}

/// A sentence about the first place at which two values differ. Numbers agree up to their rounding
/// errors.
fn first_difference(claimed: &Value, found: &Value, place: &str) -> Option<String> {
    let differ = || {
        let shown = |v: &Value| {
            let text = if v.is_null() { "nothing".into() } else { v.to_string() };
            text.chars().take(120).collect::<String>()
        };
        Some(format!("{place} is {}, computed again it is {}", shown(claimed), shown(found)))
    };
    match (claimed, found) {
        (Value::Number(a), Value::Number(b)) => {
            let (a, b) = (a.as_f64().unwrap_or(f64::NAN), b.as_f64().unwrap_or(f64::NAN));
            // NaN never agrees
            let same = (a - b).abs() <= SAME * a.abs().max(b.abs());
            if same { None } else { differ() }
        }
        (Value::Array(a), Value::Array(b)) if a.len() == b.len() => {
            let mut pairs = a.iter().zip(b).enumerate();
            pairs.find_map(|(i, (a, b))| first_difference(a, b, &format!("{place}[{i}]")))
        }
        (Value::Object(a), Value::Object(b)) => {
            let keys = a.keys().chain(b.keys().filter(|k| !a.contains_key(*k)));
            let of = |map: &serde_json::Map<String, Value>, key: &String| {
                map.get(key).cloned().unwrap_or_default()
            };
            keys.into_iter()
                .find_map(|k| first_difference(&of(a, k), &of(b, k), &format!("{place}.{k}")))
        }
        (a, b) if a == b => None,
        _ => differ(),
    }
}
