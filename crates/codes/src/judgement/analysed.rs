//! What the analyses of a load case have proved.

use crate::route::{RouteStep, is_complete};
use crate::verdict::Verdict;
use bracket_base::words::Text;

/// Result of the analyses of a load case.
#[derive(Clone, Debug, PartialEq)]
pub struct Analysed {
    /// Load case with a demand.
    pub case: String,
    /// Verdict by strict bounds of limit analysis: `None` where no limit analysis gave an answer,
    /// undecided where it was asked and its bounds do not decide.
    pub verdict: Verdict,
    /// Bracket of demand over capacity.
    pub utilisation: Option<[f64; 2]>,
    /// Whether a lower bound that carries the load decides nothing, because no rule of rotation
    /// capacity holds.
    pub brittle: bool,
    /// Whether no rule of rotation capacity holds, so that no lower bound can give OK.
    pub no_rule: bool,
    /// What its analyses did not supply: `limit analysis gave no lower bound (time
    /// limit)`.
    pub missing: Option<Text>,
    /// The steps of the route of analysis; none where no limit analysis was asked.
    pub steps: Vec<RouteStep>,
}

impl Analysed {
    /// A case that no analysis brackets.
    pub fn not(case: impl Into<String>) -> Self {
        Self {
            case: case.into(),
            verdict: Verdict::None,
            utilisation: None,
            brittle: false,
            no_rule: false,
            missing: None,
            steps: Vec::new(),
        }
    }

    /// The first step of the route of analysis that does not hold.
    pub fn first_open(&self) -> Option<&RouteStep> {
        self.steps.iter().find(|s| !s.holds())
    }

    /// Whether the route of analysis is complete and every step holds.
    pub fn route_holds(&self) -> bool {
        is_complete(&self.steps)
    }
}
