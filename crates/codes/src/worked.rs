//! A value of the code with its derivation, and how it becomes a check.

use super::check::{Check, Status, Step, Topic, Unit};
use std::fmt;

/// A value computed by a formula of the code, with its derivation.
#[derive(Clone, Debug, PartialEq)]
pub struct Worked {
    /// Clause of the formula.
    pub clause: &'static str,
    /// Name of the value.
    pub title: &'static str,
    /// The formula with symbols, then with numbers, then the result.
    pub formula: String,
    /// Intermediate values.
    pub steps: Vec<Step>,
    /// The value, internal unit.
    pub value: f64,
    /// Its unit.
    pub unit: Unit,
}

impl Worked {
    /// A value with its clause; `formula` is the formula with its numbers, to which the result is
    /// appended.
    pub fn new(
        clause: &'static str,
        title: &'static str,
        value: f64,
        unit: Unit,
        formula: impl fmt::Display,
    ) -> Self {
        let formula = format!("{formula} = {}", unit.show(value));
        Self { clause, title, formula, steps: Vec::new(), value, unit }
    }

    /// Adds an intermediate value.
    #[must_use]
    pub fn with(mut self, symbol: &str, value: f64, unit: Unit) -> Self {
        self.steps.push(Step { symbol: symbol.into(), value, unit });
        self
    }

    /// The value times a factor, which `words` explain with its number.
    #[must_use]
    pub fn times(mut self, factor: f64, words: impl fmt::Display) -> Self {
        self.value *= factor;
        self.formula = format!("{}; times {words} = {}", self.formula, self.unit.show(self.value));
        self
    }

    /// The intermediate value with a symbol.
    pub fn step(&self, symbol: &str) -> Option<f64> {
        self.steps.iter().find(|s| s.symbol == symbol).map(|s| s.value)
    }

    /// The value as information, without a demand. A value that is not finite is left out, and so
    /// are such intermediate values.
    pub fn information(mut self, topic: Topic, subject: impl Into<String>) -> Check {
        self.steps.retain(|step| step.value.is_finite());
        Check {
            topic,
            case: None,
            subject: subject.into(),
            clause: self.clause.into(),
            title: self.title.into(),
            formula: self.formula,
            values: self.steps,
            demand: None,
            resistance: Some(self.value).filter(|value| value.is_finite()),
            utilisation: None,
            unit: self.unit,
            status: Status::Information,
            advice: false,
        }
    }

    /// The value as a resistance against a demand ≥ 0 in the same unit; `otherwise` is the status
    /// if the demand is larger.
    pub fn against(
        self,
        topic: Topic,
        subject: impl Into<String>,
        demand: f64,
        otherwise: Status,
    ) -> Check {
        let resistance = self.value;
        let mut check = self.information(topic, subject);
        check.judge(demand, resistance, otherwise);
        check
    }

    /// The value as a utilisation, to be at most 1; `otherwise` is the status if it is larger.
    pub fn utilised(self, topic: Topic, subject: impl Into<String>, otherwise: Status) -> Check {
        let demand = self.value;
        let mut check = self.information(topic, subject);
        check.judge(demand, 1.0, otherwise);
        check
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_resistance_becomes_a_check() {
        let worked = || {
            Worked::new("3.6.1", "tension", 90e3, Unit::Force, "F").with("k2", 0.9, Unit::Number)
        };
        let check = worked().against(Topic::Bolts, "row 1", 99e3, Status::Failed);
        assert_eq!((check.status, check.utilisation), (Status::Failed, Some(1.1)));
        assert_eq!(
            worked().against(Topic::Bolts, "row 1", 90e3, Status::Failed).status,
            Status::Ok
        );
        assert_eq!(
            worked().against(Topic::Bolts, "row 1", 99e3, Status::Warning).status,
            Status::Warning
        );
        let share = |value| Worked::new("6.2.7.1", "moment", value, Unit::Number, "M");
        assert_eq!(
            share(0.9).utilised(Topic::Bolts, "row 1", Status::Failed).utilisation,
            Some(0.9)
        );
        assert_eq!(
            share(1.01).utilised(Topic::Bolts, "row 1", Status::Failed).status,
            Status::Failed
        );
        assert_eq!(
            share(f64::NAN).utilised(Topic::Bolts, "row 1", Status::Failed).status,
            Status::Failed
        );
        let check = worked().information(Topic::Bolts, "row 1");
        assert_eq!(
            (check.status, check.demand, check.resistance),
            (Status::Information, None, Some(90e3))
        );
    }
}
