//! The verdict on each of several load cases.

use crate::result::demand::EndAction;
use bracket_codes::Judgement;
use bracket_codes::verdict::Verdict;
use bracket_joint::spec::loads::Action;
use serde::{Deserialize, Serialize};
use serde_json::json;

/// File of a result folder with a row for each load case.
pub const CASES_FILE: &str = "cases.csv";

/// A load case with its verdict.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct JudgedCase {
    /// Its name.
    pub case: String,
    /// Bracket of demand over capacity by limit analysis, lower first.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub by_bounds: Option<[f64; 2]>,
    /// The verdicts by code and by analysis, the reason and what governs.
    #[serde(flatten)]
    pub judgement: Judgement,
}

impl JudgedCase {
    /// Utilisation of what governs, lower and upper bound.
    pub fn utilisation(&self) -> Option<[f64; 2]> {
        self.judgement.governing.as_ref().and_then(|g| g.utilisation)
    }
}

/// The text of `cases.csv`: verdict, utilisation and governing check of each load case with the
/// actions `given` in it. Reasons and checks are English, as in `result.json`.
pub fn cases_csv(cases: &[JudgedCase], given: &[(&str, &[EndAction])]) -> String {
    let mut out = csv::Writer::from_writer(Vec::new());
    let heads = [
        "case",
        "verdict",
        "by_code",
        "by_analysis",
        "utilisation_low",
        "utilisation_high",
        "analysis_low",
        "analysis_high",
        "governing",
        "clause",
        "reason",
        "end",
        "at",
    ];
    let actions = Action::ALL
        .map(|a| format!("{} [{}]", a.word(), if a.direction().1 { "kN m" } else { "kN" }));
    // a writer to memory cannot fail
    let _ = out.write_record(heads.map(str::to_owned).iter().chain(&actions));
    for case in cases {
        let j = &case.judgement;
        let word = |v: Verdict| json!(v).as_str().unwrap_or_default().to_owned();
        let pair = |used: Option<[f64; 2]>| {
            used.map_or([String::new(), String::new()], |u| u.map(|u| u.to_string()))
        };
        let governing = j.governing.as_ref();
        let [low, high] = pair(case.utilisation());
        let [analysis_low, analysis_high] = pair(case.by_bounds);
        let row = [
            case.case.clone(),
            word(j.verdict),
            word(j.by_code),
            word(j.by_analysis),
            low,
            high,
            analysis_low,
            analysis_high,
            governing.map_or_else(String::new, |g| g.what.to_string()),
            governing.map_or_else(String::new, |g| g.clause.to_string()),
            j.reason.to_string(),
        ];
        let given = given.iter().filter(|d| d.0 == case.case).flat_map(|d| d.1);
        let mut ends: Vec<(&str, &str)> = Vec::new();
        for a in given.clone() {
            if !ends.contains(&(&a.end, &a.at)) {
                ends.push((&a.end, &a.at));
            }
        }
        for (end, at) in ends {
            let numbers = Action::ALL.map(|action| {
                let here = given
                    .clone()
                    .filter(|a| a.end == end && a.at == at && a.action == action.word());
                let scale = if action.direction().1 { 1e6 } else { 1e3 };
                let sum = here.map(|a| a.value.value()).fold(0.0, |s, v| s + v);
                (sum / scale).to_string()
            });
            let place = [end.to_owned(), at.to_owned()];
            let _ = out.write_record(row.iter().chain(&place).chain(&numbers));
        }
    }
    out.into_inner().ok().and_then(|bytes| String::from_utf8(bytes).ok()).unwrap_or_default()
}
