//! The record of a case: its outcome, and a row for each load case.

use super::sweep::Who;
use bracket_base::diag::ExitStatus;
use bracket_codes::Judgement;
use bracket_codes::judgement::Governing;
use bracket_codes::verdict::{Route, Verdict};
use serde::{Deserialize, Serialize};

/// What became of a case.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Outcome {
    /// The demand is carried.
    Ok,
    /// Neither is certain.
    Undecided,
    /// The demand is not carried.
    NotOk,
    /// The case was ended at its time limit.
    TimedOut,
    /// The spec of the case is wrong.
    BadInput,
    /// The process of the case ended without a result.
    Failed,
}

impl Outcome {
    /// All outcomes, the best first.
    pub const ALL: [Self; 6] =
        [Self::Ok, Self::Undecided, Self::NotOk, Self::TimedOut, Self::BadInput, Self::Failed];

    /// Its word in tables and in the conditions of `expect`.
    pub fn word(self) -> &'static str {
        match self {
            Outcome::Ok => "ok",
            Outcome::Undecided => "undecided",
            Outcome::NotOk => "not_ok",
            Outcome::TimedOut => "timed_out",
            Outcome::BadInput => "bad_input",
            Outcome::Failed => "failed",
        }
    }

    /// Its word for people.
    pub fn plain(self) -> &'static str {
        match self {
            Outcome::NotOk => "not ok",
            Outcome::TimedOut => "timed out",
            Outcome::BadInput => "bad input",
            other => other.word(),
        }
    }

    /// The outcome of a verdict. Loads that are no demand are undecided.
    pub fn of(verdict: Verdict) -> Self {
        match verdict {
            Verdict::Ok => Outcome::Ok,
            Verdict::NotOk => Outcome::NotOk,
            Verdict::Undecided | Verdict::None => Outcome::Undecided,
        }
    }

    /// The exit status of a sweep whose worst case has this outcome.
    pub fn status(self) -> ExitStatus {
        match self {
            Outcome::Ok => ExitStatus::Ok,
            Outcome::Undecided | Outcome::TimedOut => ExitStatus::Undecided,
            Outcome::NotOk => ExitStatus::NotOk,
            Outcome::BadInput => ExitStatus::BadInput,
            Outcome::Failed => ExitStatus::Environment,
        }
    }
}

/// The result of one load case.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct LoadRow {
    /// Name of the load case.
    pub case: String,
    /// The verdict: what the complete routes prove.
    pub verdict: Verdict,
    /// The route that proves it; absent unless it is ok.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub route: Option<Route>,
    /// By the checks of the code.
    pub by_code: Verdict,
    /// By the strict bounds of limit analysis.
    pub by_analysis: Verdict,
    /// Strict lower bound of the load factor.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub lower: Option<f64>,
    /// Strict upper bound of the load factor.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub upper: Option<f64>,
    /// Whether the bounds prove no capacity: no rule of rotation capacity holds.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub brittle: bool,
    /// The check or bound that governs.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub governing: Option<Governing>,
    /// M_j,Rd of the component method \[N mm\], of the end that reaches it first.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub moment_resistance: Option<f64>,
    /// Load factor at which the component method reaches its resistance.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub component_factor: Option<f64>,
    /// S_j,ini of the component method \[N mm/rad\].
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub component_stiffness: Option<f64>,
    /// N and Vz \[N\] and My \[N mm\] at the bolt plane, of the end that reaches its resistance
    /// first; without checks as the case gives them.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub actions: Option<[f64; 3]>,
    /// The member end of these actions.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub end: Option<String>,
    /// Why the load case is not OK, and what would decide it; absent where it is.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub reason: Option<String>,
}

impl LoadRow {
    /// The reason of a judgement that is not OK.
    pub fn reason(judgement: &Judgement) -> Option<String> {
        let told = matches!(judgement.verdict, Verdict::NotOk | Verdict::Undecided);
        told.then(|| judgement.reason.to_string())
    }
}

/// The record of a case.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Record {
    /// Content key of the case.
    pub key: String,
    /// What became of it.
    pub outcome: Outcome,
    /// Why it is bad input, or failed.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub cause: Option<String>,
    /// Mass of plates, stiffeners and bolts \[kg\].
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub mass: Option<f64>,
    /// Number of bolts.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub bolts: Option<u32>,
    /// Wall time of finite elements \[s\].
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub seconds: Option<f64>,
    /// Whether a check fails that no limit analysis can overrule: detailing, buckling, bolts,
    /// welds.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub rejected: bool,
    /// Whether finite elements left a result folder.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub result: bool,
    /// The load cases.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub loads: Vec<LoadRow>,
}

impl Record {
    /// Whether the case has its answer: a result, or a fault of its input.
    pub fn is_final(&self) -> bool {
        self.result || !matches!(self.outcome, Outcome::Failed | Outcome::TimedOut)
    }

    /// Whether the checks of a case ask for finite elements.
    pub fn wants(&self, who: Who) -> bool {
        match (who, self.outcome) {
            (_, Outcome::BadInput | Outcome::Failed | Outcome::TimedOut) => false,
            (Who::All, _) => true,
            (Who::Passing, _) => !self.rejected,
            (Who::Undecided, outcome) => outcome != Outcome::Ok && !self.rejected,
        }
    }

    /// The folder of its result, relative to the sweep.
    pub fn folder(&self) -> String {
        format!("cases/{}", self.key)
    }

    /// A case without a result.
    pub fn without_result(key: &str, outcome: Outcome, cause: impl Into<String>) -> Self {
        Self {
            key: key.into(),
            outcome,
            cause: Some(cause.into()),
            mass: None,
            bolts: None,
            seconds: None,
            rejected: false,
            result: false,
            loads: Vec::new(),
        }
    }
}
