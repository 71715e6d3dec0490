//! A step of the route of analysis with its numbers.

use crate::unit::Unit;
use bracket_base::words::Text;
use serde::{Deserialize, Serialize};

/// What a step shows.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum StepId {
    /// Steels, bolts and holes within the range of the rules.
    Scope,
    /// Distances of the holes.
    Detailing,
    /// Strength by a certified lower bound.
    Strength,
    /// Bolts that stay elastic carry their forces.
    Bolts,
    /// Plates strain little.
    Strain,
    /// Nothing buckles.
    Stability,
    /// Fillet welds carry their lines of force.
    Welds,
}

impl StepId {
    /// Its title, as a report prints it.
    pub fn title(self) -> &'static str {
        match self {
            StepId::Scope => "range of the rules",
            StepId::Detailing => "distances of the holes",
            StepId::Strength => "strength by the lower bound",
            StepId::Bolts => "forces of elastic bolts",
            StepId::Strain => "strain of the plates",
            StepId::Stability => "stability of the plates",
            StepId::Welds => "lines of force of the welds",
        }
    }
}

/// State of a step.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum StepState {
    /// It holds, by a bound or by a rule on the input.
    Proved,
    /// It holds by numbers without a proven error.
    Estimated,
    /// It does not hold, or its numbers are missing.
    Open,
}

/// One value of a step against its limit.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct RouteUse {
    /// What and where.
    pub what: Text,
    /// Value, with its spread added.
    pub value: f64,
    /// Difference between the two fields or the two meshes that the value rests on.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub spread: Option<f64>,
    /// What is allowed.
    pub limit: f64,
    /// Unit of these.
    pub unit: Unit,
    /// Clause of the limit.
    pub source: Text,
}

impl RouteUse {
    /// Value over limit.
    pub fn utilisation(&self) -> f64 {
        self.value / self.limit
    }

    /// `14.2 kN of 94.1 kN`.
    pub fn words(&self) -> Text {
        let [value, limit] = [self.value, self.limit].map(|x| self.unit.show(x));
        bracket_base::say!("{}: {} of {}", &self.what, value, limit)
    }
}

/// A step of the route.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct RouteStep {
    /// What it shows.
    pub step: StepId,
    /// Whether it holds.
    pub state: StepState,
    /// Largest value over its limit, where there is one.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub utilisation: Option<f64>,
    /// What was found.
    pub finding: Text,
    /// Clause.
    pub source: Text,
    /// What would close it, where it is open.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub next: Option<Text>,
    /// Its largest values.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub uses: Vec<RouteUse>,
}

/// Number of values of a step that are kept.
const LISTED: usize = 8;

impl RouteStep {
    /// A step that holds by a proof.
    pub fn proved(step: StepId, finding: Text, source: impl Into<Text>) -> Self {
        Self {
            step,
            state: StepState::Proved,
            utilisation: None,
            finding,
            source: source.into(),
            next: None,
            uses: Vec::new(),
        }
    }

    /// A step that is open; `next` closes it.
    pub fn open(
        step: StepId,
        finding: Text,
        source: impl Into<Text>,
        next: impl Into<Text>,
    ) -> Self {
        let next = Some(next.into());
        Self { state: StepState::Open, next, ..Self::proved(step, finding, source) }
    }

    /// A step that rests on values against limits: it holds if every value is at most its limit.
    /// `otherwise` would close it.
    pub fn of_uses(
        step: StepId,
        holds: StepState,
        mut uses: Vec<RouteUse>,
        source: impl Into<Text>,
        otherwise: impl Into<Text>,
    ) -> Self {
        uses.sort_by(|a, b| b.utilisation().total_cmp(&a.utilisation()));
        let largest = uses.first();
        let finding = largest.map_or_else(|| "nothing to show".into(), RouteUse::words);
        // a value that is no number never holds: it sorts before all numbers
        let within = largest.is_none_or(|u| u.utilisation() <= 1.0);
        let utilisation = largest.map(RouteUse::utilisation).filter(|u| u.is_finite());
        let step = if within {
            Self { state: holds, ..Self::proved(step, finding, source) }
        } else {
            Self::open(step, finding, source, otherwise)
        };
        uses.truncate(LISTED);
        Self { utilisation, uses, ..step }
    }

    /// The step with its values, left open although they are within their limits.
    #[must_use]
    pub fn left_open(self, finding: Text, next: impl Into<Text>) -> Self {
        Self { state: StepState::Open, finding, next: Some(next.into()), ..self }
    }

    /// Whether a value is above its limit even with the smaller number of the two that it rests
    /// on: it is the larger one plus their difference.
    pub fn is_surely_exceeded(&self) -> bool {
        self.uses.iter().any(|u| u.value - 2.0 * u.spread.unwrap_or(0.0) > u.limit)
    }

    /// Whether its values are known and within their limits, whether or not they have converged.
    pub fn is_within(&self) -> bool {
        self.utilisation.is_some_and(|u| u <= 1.0)
    }

    /// Whether it holds.
    pub fn holds(&self) -> bool {
        self.state != StepState::Open
    }
}
