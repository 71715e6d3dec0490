//! How many cases have each outcome.

use super::merged::Merged;
use super::plan::Plan;
use super::row::{Outcome, Record};
use bracket_base::diag::{Diagnostic, Diagnostics, ExitStatus};
use bracket_base::say;
use bracket_base::words::Text;
use bracket_joint::spec::expr::{Expr, Value};
use serde_json::{Map, Value as Json};

/// Numbers of cases by outcome, and of those that are not finished.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Counts {
    of: [usize; Outcome::ALL.len()],
    /// Cases without a record.
    pub open: usize,
    /// Groups of the choice, and those with a chosen joint; `None` where nothing is chosen.
    pub choice: Option<[usize; 2]>,
}

impl Counts {
    /// Counts records; `None` is a case that is not finished.
    pub fn new<'a>(records: impl Iterator<Item = Option<&'a Record>>) -> Self {
        let mut counts = Self::default();
        for record in records {
            match record {
                Some(r) => counts.of[r.outcome as usize] += 1,
                None => counts.open += 1,
            }
        }
        counts
    }

    /// Counts what a sweep has found.
    pub fn of(merged: &Merged, plan: &Plan) -> Self {
        let mut counts = Self::new(merged.records.iter().map(Option::as_ref));
        let chosen = merged.decisions.iter().filter(|d| d.chosen.is_some()).count();
        counts.choice = plan.header.choose.as_ref().map(|_| [merged.decisions.len(), chosen]);
        counts
    }

    /// Number of cases with an outcome.
    pub fn with(&self, outcome: Outcome) -> usize {
        self.of[outcome as usize]
    }

    /// `1 case`, `24 cases`.
    pub fn cases(number: usize) -> Text {
        if number == 1 { "1 case".into() } else { say!("{} cases", number) }
    }

    /// The numbers by their names in the conditions of `expect`, and `open`.
    pub fn json(&self) -> Map<String, Json> {
        let outcomes = Outcome::ALL.iter().map(|o| (o.word(), self.with(*o)));
        let choice = self.choice.map(|[groups, chosen]| [("groups", groups), ("chosen", chosen)]);
        let others = [("cases", self.all()), ("open", self.open)];
        let all = outcomes.chain(others).chain(choice.into_iter().flatten());
        all.map(|(name, n)| (name.to_string(), n.into())).collect()
    }

    /// Number of all cases.
    pub fn all(&self) -> usize {
        self.of.iter().sum::<usize>() + self.open
    }

    /// `12 ok, 3 undecided, 1 failed`: what occurs.
    pub fn words(&self) -> String {
        let mut parts: Vec<String> = Outcome::ALL
            .iter()
            .filter(|o| self.with(**o) > 0)
            .map(|o| format!("{} {}", self.with(*o), o.plain()))
            .collect();
        if self.open > 0 {
            parts.push(format!("{} not finished", self.open));
        }
        parts.join(", ")
    }

    /// The exit status: that of the worst case; undecided while cases are open.
    pub fn status(&self) -> ExitStatus {
        let worst = Outcome::ALL.into_iter().rev().find(|o| self.with(*o) > 0);
        match worst.map(Outcome::status) {
            Some(ExitStatus::Ok) | None if self.open > 0 => ExitStatus::Undecided,
            Some(status) => status,
            None => ExitStatus::Ok,
        }
    }

    /// The exit status of the cases without a verdict alone.
    pub fn without_verdict(&self) -> ExitStatus {
        self.with_verdicts(std::iter::empty())
    }

    /// The exit status with other verdicts in place of those of the cases.
    pub fn with_verdicts(&self, verdicts: impl Iterator<Item = Outcome>) -> ExitStatus {
        let mut rest = *self;
        for o in [Outcome::Ok, Outcome::Undecided, Outcome::NotOk] {
            rest.of[o as usize] = 0;
        }
        verdicts.for_each(|o| rest.of[o as usize] += 1);
        rest.status()
    }

    /// The conditions of `expect` that do not hold.
    pub fn broken<'a>(&self, expect: &'a [String]) -> Result<Vec<&'a str>, Diagnostics> {
        let mut lookup = |name: &str| {
            let count = match name {
                "cases" => Some(self.all()),
                "groups" => Some(self.choice.unwrap_or_default()[0]),
                "chosen" => Some(self.choice.unwrap_or_default()[1]),
                _ => Outcome::ALL.into_iter().find(|o| o.word() == name).map(|o| self.with(o)),
            };
            count.map(|n| Value::number(n as f64)).ok_or_else(|| {
                let known = Outcome::ALL.into_iter().map(Outcome::word);
                let known = known.chain(["cases", "groups", "chosen"]);
                format!("unknown name `{name}`{}", bracket_base::diag::did_you_mean(name, known))
            })
        };
        let mut broken = Vec::new();
        for text in expect {
            let truth = Expr::parse(text).and_then(|e| e.eval_truth(&mut lookup)).map_err(|e| {
                Diagnostic::input("sweep/expect", e.to_string())
                    .path("expect")
                    .help("conditions use the numbers of cases: `failed == 0`, `ok >= 10`")
            })?;
            if !truth {
                broken.push(text.as_str());
            }
        }
        Ok(broken)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn counts(outcomes: &[Option<Outcome>]) -> Counts {
        let records: Vec<Option<Record>> =
            outcomes.iter().map(|o| o.map(|o| Record::without_result("k", o, "x"))).collect();
        Counts::new(records.iter().map(Option::as_ref))
    }

    #[test]
    fn the_worst_case_gives_the_exit_status() {
        use Outcome::{BadInput, Failed, NotOk, Ok, TimedOut, Undecided};
        for (outcomes, code) in [
            (vec![], 0),
            (vec![Some(Ok)], 0),
            (vec![Some(Ok), None], 3),
            (vec![Some(Ok), Some(Undecided)], 3),
            (vec![Some(TimedOut), Some(Ok)], 3),
            (vec![Some(NotOk), Some(Undecided), None], 1),
            (vec![Some(BadInput), Some(NotOk)], 2),
            (vec![Some(Failed), Some(BadInput)], 4),
        ] {
            assert_eq!(counts(&outcomes).status().code(), code, "{outcomes:?}");
        }
    }

    /// What the user expects may replace verdicts, not missing ones.
    #[test]
    fn cases_without_a_verdict_count_on() {
        use Outcome::{BadInput, NotOk, Ok, TimedOut, Undecided};
        for (outcomes, code) in [
            (vec![Some(Ok), Some(NotOk), Some(Undecided)], 0),
            (vec![Some(NotOk), Some(TimedOut)], 3),
            (vec![Some(NotOk), None], 3),
            (vec![Some(NotOk), Some(BadInput)], 2),
        ] {
            assert_eq!(counts(&outcomes).without_verdict().code(), code, "{outcomes:?}");
        }
    }

    #[test]
    fn conditions_on_the_outcome() {
        let c = counts(&[Some(Outcome::Ok), Some(Outcome::Ok), Some(Outcome::NotOk), None]);
        assert_eq!(c.words(), "2 ok, 1 not ok, 1 not finished");
        let expect = ["ok == 2", "cases == 4", "not_ok == 0"].map(str::to_owned);
        assert_eq!(c.broken(&expect), Result::Ok(vec!["not_ok == 0"]));
        let fault = c.broken(&["okay > 1".to_owned()]).expect_err("an unknown name");
        assert!(fault.first().message.contains("unknown name `okay`"), "{fault:?}");
    }
}
