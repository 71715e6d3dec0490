//! What `verify` computes again from the spec of a result: the hand checks, the demands and the
//! verdicts.

use crate::driver::demands::demands;
use crate::driver::judge::judged;
use crate::driver::spec_context::spec_checks;
use crate::driver::spec_file::SpecFile;
use bracket_codes::HandChecks;
use bracket_codes::route::RouteFacts;
use bracket_report::result::result_file::ResultFile;
use bracket_report::result::verify::first_difference;
use serde_json::{Value, json};

/// Differences of a result of a spec.
pub fn of_spec(result: &ResultFile, input: &SpecFile) -> Vec<String> {
    let checks = spec_checks(input);
    let facts = RouteFacts::of(&input.joint);
    let again = judged(result.clone(), &checks, Some(&facts), &demands(&input.spec.value.loads));
    let mut out = compared(result, &again);
    out.extend(warnings_missing(result, &checks));
    out
}

/// Notes of the checks that the result must contain.
fn warnings_missing(result: &ResultFile, checks: &HandChecks) -> Vec<String> {
    let missing = checks.notes.iter().filter(|n| !result.warnings.contains(n));
    missing.map(|n| format!("the warning \"{n}\" is missing")).collect()
}

/// Sentences about what the spec and the bounds give otherwise.
pub fn compared(claimed: &ResultFile, again: &ResultFile) -> Vec<String> {
    let mut out = Vec::new();
    let mut pair = |name: &str, a: Value, b: Value| out.extend(first_difference(&a, &b, name));
    pair("verdict", json!(claimed.verdict), json!(again.verdict));
    pair("judgement", json!(claimed.judgement), json!(again.judgement));
    pair("checks", json!(claimed.checks), json!(again.checks));
    pair("neglected", json!(claimed.neglected), json!(again.neglected));
    pair("component_method", json!(claimed.component_method), json!(again.component_method));
    for (a, b) in claimed.cases.iter().zip(&again.cases) {
        let name = |key: &str| format!("{}: {key}", a.name);
        pair(&name("utilisation"), json!(a.utilisation), json!(b.utilisation));
        pair(&name("demand"), json!(a.demand), json!(b.demand));
        pair(&name("joint_stiffness"), json!(a.joint_stiffness), json!(b.joint_stiffness));
    }
    out
}
