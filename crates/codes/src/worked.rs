//! A value of the code with its derivation, and how it becomes a check.

use super::check::{Binding, Check, CheckId, Status, Step, Topic, Unit};
use super::formula::{Derivation, Formula, Line, Number, Traced};
use crate::subject::Subject;
use bracket_base::words::Text;

/// A value computed by a formula of the code, with its derivation.
#[derive(Clone, Debug, PartialEq)]
pub struct Worked {
    /// Clause of the formula.
    pub clause: &'static str,
    /// What it is.
    pub id: CheckId,
    /// The formula that gives it, and what stands before and behind it.
    pub derivation: Derivation,
    /// Intermediate values.
    pub steps: Vec<Step>,
    /// The value, internal unit.
    pub value: f64,
    /// Its unit.
    pub unit: Unit,
}

impl Worked {
    /// A value with its clause and its formula, `symbol` = `of`.
    pub fn of(
        clause: &'static str,
        id: CheckId,
        symbol: impl Into<Text>,
        of: Traced,
        unit: Unit,
    ) -> Self {
        let value = of.value();
        let derivation = Formula::new(symbol, of, unit).into();
        Self { clause, id, derivation, steps: Vec::new(), value, unit }
    }

    /// Adds an intermediate value.
    #[must_use]
    pub fn with(mut self, symbol: impl Into<Text>, value: f64, unit: Unit) -> Self {
        self.steps.push(Step { symbol: symbol.into(), value, unit });
        self
    }

    /// Adds symbols of the formula as intermediate values.
    #[must_use]
    pub fn with_symbols<const N: usize>(mut self, symbols: [&Traced; N]) -> Self {
        for (symbol, value, unit) in symbols.into_iter().flat_map(|s| s.term().symbols()) {
            self = self.with(symbol.clone(), value, unit);
        }
        self
    }

    /// The value with a further part of its derivation: a formula, a comparison or a sentence.
    #[must_use]
    pub fn then(mut self, line: impl Into<Line>) -> Self {
        self.derivation = self.derivation.then(line);
        self
    }

    /// The value with what its derivation begins with.
    #[must_use]
    pub fn after(mut self, before: impl Into<Derivation>) -> Self {
        self.derivation = before.into().followed_by(self.derivation);
        self
    }

    /// A further formula whose value takes the place of this one.
    #[must_use]
    pub fn becomes(mut self, symbol: impl Into<Text>, of: Traced) -> Self {
        self.value = of.value();
        self.derivation = self.derivation.then(Formula::new(symbol, of, self.unit));
        self
    }

    /// The value as a symbol of a further formula: that of its last formula.
    pub fn traced(&self) -> Traced {
        let symbol = self.derivation.formulas().last().map_or("".into(), |f| f.symbol.clone());
        Traced::symbol(symbol, self.value, self.unit)
    }

    /// The derivation as text.
    pub fn formula(&self) -> Text {
        self.derivation.text()
    }

    /// The intermediate value with a symbol of the code.
    pub fn step(&self, symbol: &str) -> Option<f64> {
        self.steps.iter().find(|s| s.symbol.id == symbol).map(|s| s.value)
    }

    /// The value as information, without a demand. A value that is not finite is left out, and so
    /// are such intermediate values.
    pub fn information(mut self, topic: Topic, subject: impl Into<Subject>) -> Check {
        self.steps.retain(|step| step.value.is_finite());
        Check {
            topic,
            case: None,
            subject: subject.into(),
            clause: self.clause.into(),
            title: self.id.into(),
            derivation: self.derivation,
            values: self.steps,
            demand: None,
            resistance: Some(self.value).filter(|value| value.is_finite()),
            utilisation: None,
            unit: self.unit,
            status: Status::Information,
            binding: Binding::Information,
            advice: false,
        }
    }

    /// The value as a resistance against a demand ≥ 0 in the same unit; `otherwise` is the status
    /// if the demand is larger.
    pub fn against(
        self,
        topic: Topic,
        subject: impl Into<Subject>,
        demand: f64,
        otherwise: Status,
    ) -> Check {
        let resistance = self.value;
        let mut check = self.information(topic, subject);
        check.judge(demand, resistance, otherwise);
        check
    }

    /// The value as a utilisation, to be at most 1; `otherwise` is the status if it is larger.
    pub fn utilised(self, topic: Topic, subject: impl Into<Subject>, otherwise: Status) -> Check {
        let demand = self.value;
        let mut check = self.information(topic, subject);
        check.judge(demand, 1.0, otherwise);
        check
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::subject::Part;

    #[test]
    fn a_resistance_becomes_a_check() {
        let worked =
            || {
                Worked::of("3.6.1", CheckId::BoltTension, "F", Traced::from(90e3), Unit::Force)
                    .with("k2", 0.9, Unit::Number)
            };
        let check = worked().against(Topic::Bolts, Part::BoltRows, 99e3, Status::Failed);
        assert_eq!((check.status, check.utilisation), (Status::Failed, Some(1.1)));
        assert_eq!(
            worked().against(Topic::Bolts, Part::BoltRows, 90e3, Status::Failed).status,
            Status::Ok
        );
        assert_eq!(
            worked().against(Topic::Bolts, Part::BoltRows, 99e3, Status::Warning).status,
            Status::Warning
        );
        let share = |value: f64| {
            Worked::of("6.2.7.1", CheckId::MomentAndAxial, "M", Traced::from(value), Unit::Number)
        };
        assert_eq!(
            share(0.9).utilised(Topic::Bolts, Part::BoltRows, Status::Failed).utilisation,
            Some(0.9)
        );
        assert_eq!(
            share(1.01).utilised(Topic::Bolts, Part::BoltRows, Status::Failed).status,
            Status::Failed
        );
        assert_eq!(
            share(f64::NAN).utilised(Topic::Bolts, Part::BoltRows, Status::Failed).status,
            Status::Failed
        );
        let check = worked().information(Topic::Bolts, Part::BoltRows);
        assert_eq!(
            (check.status, check.demand, check.resistance),
            (Status::Information, None, Some(90e3))
        );
    }
}
