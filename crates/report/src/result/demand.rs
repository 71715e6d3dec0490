//! The demand of a load case, and the verdict on it.

use bracket_base::words::Text;
use bracket_codes::route::RouteStep;
use bracket_codes::verdict::{Route, Verdict};
use bracket_codes::{Comparison, Judgement};
use bracket_joint::spec::loads::Action;
use serde::{Deserialize, Serialize};

/// The demand of a load case and the verdict on it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Demand {
    /// The verdict at load factor 1: what the complete routes prove.
    pub verdict: Verdict,
    /// The route that proves `ok`; absent otherwise.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub route: Option<Route>,
    /// The verdict of the code's checks of the load case.
    pub by_code: Verdict,
    /// The verdict of the strict bounds of this entry; `none` for an analysis that brackets no
    /// resistance.
    pub by_analysis: Verdict,
    /// Forces and moments at member ends, in the order of the spec.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub actions: Vec<EndAction>,
    /// Result of the component method for the case, one entry for each member end.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub component_method: Vec<Comparison>,
    /// Reason why no lower bound decides: no rule of rotation capacity is satisfied.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub brittle: Option<Text>,
    /// The steps of the route of analysis.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub steps: Vec<RouteStep>,
}

impl Demand {
    /// Stores the verdicts of the load case.
    pub fn judged(&mut self, judgement: &Judgement) {
        (self.by_code, self.verdict) = (judgement.by_code, judgement.verdict);
        self.route = judgement.route;
        self.steps.clone_from(&judgement.steps);
    }
}

/// A force or moment at a member end.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct EndAction {
    /// Member end: `beam_right`.
    pub end: String,
    /// The point it refers to: `column_face`.
    pub at: String,
    /// `N`, `Vy`, `Vz`, `T`, `My` or `Mz`.
    pub action: String,
    /// Its value at load factor 1, in the member's own axes.
    pub value: ActionValue,
    /// True if the load factor multiplies it.
    pub factored: bool,
}

/// Value of an action.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum ActionValue {
    /// A force \[N\].
    Force(f64),
    /// A moment \[N mm\].
    Moment(f64),
}

impl ActionValue {
    /// The value of an action \[N, N mm\].
    pub fn of(action: Action, value: f64) -> Self {
        if action.direction().1 { Self::Moment(value) } else { Self::Force(value) }
    }

    /// Value \[N, N mm\].
    pub fn value(self) -> f64 {
        match self {
            ActionValue::Force(v) | ActionValue::Moment(v) => v,
        }
    }
}
