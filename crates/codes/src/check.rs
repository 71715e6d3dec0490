//! The record of one check: clause, formula with its numbers, demand, resistance, utilisation.

mod check_id;
mod title;

pub use check_id::CheckId;
pub use title::Title;

use crate::formula::{Derivation, Line, Number, Relation, Traced, text_of};
use crate::subject::Subject;
pub use crate::unit::{Unit, number};
use bracket_base::say;
use bracket_base::units::limits;
use bracket_base::words::Text;
use serde::{Deserialize, Serialize};

/// What the formula of a check says whose demand or resistance is not finite.
const NO_NUMBER: &str = "there is no such number, so that the check does not hold";

/// An intermediate value.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Step {
    /// Symbol of the code.
    pub symbol: Text,
    /// Value, internal unit.
    pub value: f64,
    /// Unit.
    pub unit: Unit,
}

impl Step {
    /// A length \[mm\].
    pub fn length(symbol: impl Into<Text>, value: f64) -> Self {
        Self { symbol: symbol.into(), value, unit: Unit::Length }
    }
}

/// Topic of a check; the report has a table for each.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Topic {
    /// Spacing, edges, room for tools and washers, bolt length.
    Detailing,
    /// Resistance of single bolts.
    Bolts,
    /// Welds.
    Welds,
    /// The beam's cross-section and the column's stiffeners at the joint.
    Member,
    /// Component method of EN 1993-1-8 section 6.
    ComponentMethod,
    /// Buckling and slenderness.
    Stability,
    /// Stiffness of the component method.
    Stiffness,
    /// Rotation capacity.
    Ductility,
}

/// What a check can decide.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Binding {
    /// Strength that a limit analysis of the same case determines as well, and stands in for.
    Strength,
    /// Strength or stability of the joint for which the code has no method: the complete route of
    /// analysis answers it ([`crate::route`]).
    Open,
    /// What a limit analysis does not know: single bolts and welds, sections, stability, detailing,
    /// and what the code leaves open.
    Beside,
    /// Nothing: a value or a remark without a demand.
    Information,
}

/// Result of a check.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Status {
    /// The demand is within the limit.
    Ok,
    /// The demand exceeds the limit.
    Failed,
    /// The code gives no resistance: neither satisfied nor failed.
    Undecided,
    /// A recommendation is not followed, or strength by the component method does not suffice where
    /// a limit analysis decides. It does not affect the verdict.
    Warning,
    /// A value without a demand.
    Information,
}

/// One check of the report and of `result.json`. Values are in the internal units (mm, N, MPa, N
/// mm).
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Check {
    /// Topic.
    pub topic: Topic,
    /// The load case of the demand; absent for a check that needs no load.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub case: Option<String>,
    /// Part, row or sense of bending.
    #[serde(flatten)]
    pub subject: Subject,
    /// Clause.
    pub clause: Text,
    /// What it checks.
    #[serde(flatten)]
    pub title: Title,
    /// The formula with its numbers.
    #[serde(flatten)]
    pub derivation: Derivation,
    /// Intermediate values.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub values: Vec<Step>,
    /// Demand: the force, or the required length.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub demand: Option<f64>,
    /// Resistance: the force that can be carried, or the provided length.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub resistance: Option<f64>,
    /// Demand over resistance.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub utilisation: Option<f64>,
    /// Unit of demand and resistance.
    pub unit: Unit,
    /// Result.
    pub status: Status,
    /// What it can decide.
    pub binding: Binding,
    /// True for a recommendation, which decides nothing where it is not followed.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub advice: bool,
}

impl Check {
    /// What it checks.
    pub fn id(&self) -> CheckId {
        self.title.id
    }

    /// The check with an id and a subject.
    pub fn find<'a>(checks: &'a [Check], id: CheckId, subject: &Subject) -> Option<&'a Check> {
        checks.iter().find(|c| c.id() == id && c.subject == *subject)
    }

    /// A check for which the code gives no resistance, with the reason, and what would decide it.
    pub fn undecided(
        topic: Topic,
        subject: impl Into<Subject>,
        clause: impl Into<Text>,
        id: CheckId,
        why: impl Into<Derivation>,
        step: impl Into<Text>,
    ) -> Self {
        let open = Self::assumption(topic, subject, clause, id, why);
        Self { status: Status::Undecided, binding: Binding::Beside, ..open }.decided_by(step)
    }

    /// The check with names of the user that belong to its title.
    #[must_use]
    pub fn naming(mut self, detail: Text) -> Self {
        self.title.detail = Some(detail);
        self
    }

    /// The check; if it is undecided, with what would decide it.
    #[must_use]
    pub fn decided_by(mut self, step: impl Into<Text>) -> Self {
        if self.status == Status::Undecided {
            self.derivation.lines.push(Line::DecidedBy(step.into()));
        }
        self
    }

    /// Whether it is undecided because the code has no method for the strength or the stability of
    /// the joint.
    pub fn is_without_method(&self) -> bool {
        let of_joint = matches!(self.binding, Binding::Strength | Binding::Open);
        self.status == Status::Undecided && of_joint
    }

    /// Why an undecided check is open, and what would decide it.
    pub fn open(&self) -> Option<(Text, &Text)> {
        let (last, why) = self.derivation.lines.split_last()?;
        match last {
            Line::DecidedBy(step) if self.status == Status::Undecided => Some((text_of(why), step)),
            _ => None,
        }
    }

    /// The formula with its numbers, as text.
    pub fn formula(&self) -> Text {
        self.derivation.text()
    }

    /// An assumption of the checks, in words.
    pub fn assumption(
        topic: Topic,
        subject: impl Into<Subject>,
        clause: impl Into<Text>,
        id: CheckId,
        what: impl Into<Derivation>,
    ) -> Self {
        Self {
            topic,
            case: None,
            subject: subject.into(),
            clause: clause.into(),
            title: id.into(),
            derivation: what.into(),
            values: Vec::new(),
            demand: None,
            resistance: None,
            utilisation: None,
            unit: Unit::Number,
            status: Status::Information,
            binding: Binding::Information,
            advice: false,
        }
    }

    /// A length that must reach a least value: the demand is the required length `limit`, the
    /// resistance the provided one. `otherwise` is the status where it is too small.
    pub fn at_least(
        of: (Topic, impl Into<Subject>),
        what: (&'static str, CheckId),
        symbol: impl Into<Text>,
        limit: impl Into<Traced>,
        provided: f64,
        otherwise: Status,
    ) -> Self {
        let limit = limit.into();
        let numbers = (limit.value(), provided);
        let relation =
            if within(limit.value(), provided) { Relation::AtLeast } else { Relation::Below };
        Self::limit(of, what, (symbol.into(), provided, relation, limit), numbers, otherwise)
    }

    /// A length that must not exceed a greatest value `limit`: the demand is the provided length,
    /// the resistance the allowed one. `otherwise` is the status where it is too large.
    pub fn at_most(
        of: (Topic, impl Into<Subject>),
        what: (&'static str, CheckId),
        symbol: impl Into<Text>,
        limit: impl Into<Traced>,
        provided: f64,
        otherwise: Status,
    ) -> Self {
        let limit = limit.into();
        let numbers = (provided, limit.value());
        let relation =
            if within(provided, limit.value()) { Relation::AtMost } else { Relation::Above };
        Self::limit(of, what, (symbol.into(), provided, relation, limit), numbers, otherwise)
    }

    /// The limit of a pure number in place of that of a length.
    #[must_use]
    pub fn of_numbers(mut self) -> Self {
        self.unit = Unit::Number;
        for line in &mut self.derivation.lines {
            if let Line::Comparison { limit, .. } = line {
                limit.unit = Unit::Number;
            }
        }
        self
    }

    fn limit(
        (topic, subject): (Topic, impl Into<Subject>),
        (clause, id): (&'static str, CheckId),
        (symbol, value, relation, limit): (Text, f64, Relation, Traced),
        (demand, resistance): (f64, f64),
        otherwise: Status,
    ) -> Self {
        let formula = Line::comparison(symbol, value, relation, limit, Unit::Length);
        let mut check = Self {
            unit: Unit::Length,
            status: Status::Ok,
            ..Self::assumption(topic, subject, clause, id, formula)
        };
        check.judge(demand, resistance, otherwise);
        check
    }

    /// Compares a demand with a resistance. A number that is not finite never holds: the check ends
    /// with `otherwise`, and its formula says so.
    pub(super) fn judge(&mut self, demand: f64, resistance: f64, otherwise: Status) {
        let number = |x: f64| Some(x).filter(|x| x.is_finite());
        self.demand = number(demand);
        self.resistance = number(resistance);
        // a utilisation needs a positive resistance
        self.utilisation = if resistance > 0.0 { number(demand / resistance) } else { None };
        self.advice = otherwise == Status::Warning;
        self.binding = Binding::Beside;
        let finite = self.demand.is_some() && self.resistance.is_some();
        self.status = if finite && within(demand, resistance) { Status::Ok } else { otherwise };
        if !finite {
            self.derivation.lines.push(NO_NUMBER.into());
        }
    }

    /// True for a length or an angle with its limit, which measures no strength: a distance, a
    /// throat.
    pub fn is_limit(&self) -> bool {
        self.unit == Unit::Length || self.id() == CheckId::HaunchAngle
    }

    /// True for a utilisation that decides: of a strength, no kept length, no recommendation.
    pub fn measures_strength(&self) -> bool {
        let decides = self.binding != Binding::Information && !self.advice;
        decides && self.utilisation.is_some() && !self.is_limit()
    }

    /// The check as one of strength that a limit analysis determines as well.
    #[must_use]
    pub fn of_strength(mut self) -> Self {
        self.binding = Binding::Strength;
        self
    }

    /// The check of strength or stability of the joint for which the code has no method.
    #[must_use]
    pub fn without_method(mut self) -> Self {
        self.binding = Binding::Open;
        self
    }

    /// The check with its load case.
    #[must_use]
    pub fn of_case(mut self, case: &str) -> Self {
        self.case = Some(case.into());
        self
    }

    /// The check in a sentence.
    pub fn sentence(&self) -> Text {
        let (subject, title) = (self.subject.text(), self.title.text());
        let (formula, clause) = (self.formula(), &self.clause);
        let Some(case) = &self.case else {
            return say!("{}: {}: {} ({})", subject, title, formula, clause);
        };
        // a formula that begins with the demand already has it
        let demand =
            self.demand.filter(|_| self.unit != Unit::Number && !self.derivation.has_demand());
        match demand.map(|ed| self.unit.show(ed)) {
            Some(ed) => {
                say!("{}, {}: {}: {} against {} ({})", case, subject, title, ed, formula, clause)
            }
            None => say!("{}, {}: {}: {} ({})", case, subject, title, formula, clause),
        }
    }
}

/// Whether a value is at most a limit, but for rounding; never true of NaN.
///
/// Every comparison of the checks with a limit of the code is made with this slack, so that a value
/// given in another unit, or as a product of decimals, is judged like the value itself.
pub fn within(value: f64, limit: f64) -> bool {
    limits::at_most(value, limit)
}

/// Sum of forces or moments that may balance: 0 where only rounding is left of them.
pub fn balance(of: impl IntoIterator<Item = f64>) -> f64 {
    let (sum, size) = of.into_iter().fold((0.0, 0.0), |(s, size), x| (s + x, size + x.abs()));
    // beside the size of its terms it is nothing but rounding
    if within(size + sum.abs(), size) { 0.0 } else { sum }
}

/// The item with the largest value, the first of those that are equal but for rounding.
pub fn largest<T>(of: impl IntoIterator<Item = T>, value: impl Fn(&T) -> f64) -> Option<T> {
    of.into_iter().reduce(|a, b| if within(value(&b), value(&a)) { a } else { b })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::subject::Part;

    #[test]
    fn a_limit_met_exactly_holds_and_one_missed_by_a_hair_does_not() {
        let check = |provided: f64| {
            let (topic, what) =
                ((Topic::Detailing, Part::EndPlate), ("Table 3.3", CheckId::EndDistance));
            let rule = Traced::from(1.2) * Traced::symbol("d0", 20.0, Unit::Length);
            Check::at_least(topic, what, "e1", rule, provided, Status::Failed)
        };
        assert_eq!(check(24.0).status, Status::Ok);
        assert_eq!(check(23.99).status, Status::Failed);
        assert_eq!(check(f64::NAN).status, Status::Failed);
        assert!(check(23.99).utilisation.is_some_and(|u| u > 1.0));
        let formula = check(23.99).formula();
        assert_eq!(formula, "e1 = 23.99 mm < 1.2 d0 = 1.2 · 20 = 24 mm");
        let (topic, what) = ((Topic::Welds, Part::BeamWeb), ("4.5.2", CheckId::LeastThroat));
        let throat = Check::at_least(topic, what, "a", 3.0, 6.0, Status::Failed);
        assert_eq!(throat.formula(), "a = 6 mm ≥ 3 mm");
        assert_eq!(check(-3.0).utilisation, None, "no finite utilisation where nothing is there");
    }
}
