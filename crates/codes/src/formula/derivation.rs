//! The derivation of a value: formulas, comparisons and words, one after the other.

use super::number::Number;
use super::print::{Run, Style};
use super::term::{Term, extended};
use super::traced::Traced;
use crate::unit::Unit;
use serde::{Deserialize, Serialize};
use std::borrow::Cow;

/// A value with its symbol and the term that gives it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Formula {
    /// Symbol of the value; empty where it has none.
    pub symbol: Cow<'static, str>,
    /// The term.
    pub term: Term,
    /// The value, internal unit.
    #[serde(with = "extended")]
    pub value: f64,
    /// Its unit.
    pub unit: Unit,
}

impl Formula {
    /// The formula of a traced value. Of an intermediate value it is its definition.
    pub fn new(symbol: impl Into<Cow<'static, str>>, of: Traced, unit: Unit) -> Self {
        let term = of.definition().unwrap_or(of.term()).clone();
        Self { symbol: symbol.into(), term, value: of.value(), unit }
    }

    /// The value as a symbol of a further formula.
    pub fn traced(&self) -> Traced {
        Traced::symbol(self.symbol.clone(), self.value, self.unit)
    }

    /// Symbol, term with symbols, term with numbers and value; what would stand twice stands
    /// once.
    pub fn sides(&self) -> Vec<Vec<Run>> {
        let of = |style| self.term.part(style).runs;
        let value = Run::Number(self.unit.show(self.value));
        let symbol = vec![Run::Symbol(self.symbol.to_string())];
        let mut out: Vec<Vec<Run>> = Vec::new();
        for side in [symbol, of(Style::Symbols), of(Style::Numbers), vec![value]] {
            let text = text_of(&side);
            // a value repeats its number without a unit
            let repeats = |last: String| last == text || text.split(' ').next() == Some(&last);
            match out.last_mut() {
                Some(last) if repeats(text_of(last)) => *last = side,
                _ if text.is_empty() => {}
                _ => out.push(side),
            }
        }
        out
    }

    /// Its sides, joined by `=`.
    pub fn text(&self) -> String {
        let sides: Vec<String> = self.sides().iter().map(|side| text_of(side)).collect();
        sides.join(" = ")
    }
}

/// The right-hand side of a formula, to be written out in another one.
impl From<&Formula> for Traced {
    fn from(of: &Formula) -> Self {
        Traced::new(of.value, of.term.clone())
    }
}

fn text_of(runs: &[Run]) -> String {
    runs.iter().map(Run::text).collect()
}

/// Relation of a value to its limit.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Relation {
    /// At least the limit.
    #[serde(rename = "≥")]
    AtLeast,
    /// At most the limit.
    #[serde(rename = "≤")]
    AtMost,
    /// Below a least value.
    #[serde(rename = "<")]
    Below,
    /// Above a greatest value.
    #[serde(rename = ">")]
    Above,
}

impl Relation {
    /// The sign.
    pub fn sign(self) -> &'static str {
        match self {
            Relation::AtLeast => "≥",
            Relation::AtMost => "≤",
            Relation::Below => "<",
            Relation::Above => ">",
        }
    }
}

/// A part of a derivation.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Line {
    /// A sentence.
    Words(String),
    /// A formula with its value.
    Formula(Formula),
    /// A value and its limit: `e1 = 23 mm < 1.2 d0 = 1.2 · 20 = 24 mm`.
    Comparison {
        /// Symbol of the value.
        symbol: Cow<'static, str>,
        /// The value, internal unit.
        #[serde(with = "extended")]
        value: f64,
        /// Relation to the limit.
        relation: Relation,
        /// The limit; its unit is also that of the value.
        limit: Formula,
    },
    /// What would decide an undecided check.
    DecidedBy(String),
}

/// Words before what would decide an undecided check.
pub const DECIDED_BY: &str = "what would decide it";

impl Line {
    /// The part as text.
    pub fn text(&self) -> String {
        match self {
            Line::Words(words) => words.clone(),
            Line::Formula(formula) => formula.text(),
            Line::Comparison { relation, limit, .. } => {
                format!("{} {} {}", self.provided(), relation.sign(), limit.text())
            }
            Line::DecidedBy(step) => format!("{DECIDED_BY}: {step}"),
        }
    }

    /// The value of a comparison with its symbol; empty for other parts.
    pub fn provided(&self) -> String {
        match self {
            Line::Comparison { symbol, value, limit, .. } => {
                format!("{symbol} = {}", limit.unit.show(*value))
            }
            _ => String::new(),
        }
    }
}

impl From<Formula> for Line {
    fn from(formula: Formula) -> Self {
        Line::Formula(formula)
    }
}

impl From<String> for Line {
    fn from(words: String) -> Self {
        Line::Words(words)
    }
}

impl From<&str> for Line {
    fn from(words: &str) -> Self {
        Line::Words(words.into())
    }
}

/// The derivation of a value or of a statement. In files it stands as text and as data.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(from = "Record", into = "Record")]
pub struct Derivation {
    /// Its parts.
    pub lines: Vec<Line>,
}

impl Derivation {
    /// The derivation with a further part at its end.
    #[must_use]
    pub fn then(mut self, line: impl Into<Line>) -> Self {
        self.lines.push(line.into());
        self
    }

    /// The derivation with the parts of another one at its end.
    #[must_use]
    pub fn followed_by(mut self, other: impl Into<Derivation>) -> Self {
        self.lines.extend(other.into().lines);
        self
    }

    /// The derivation as text.
    pub fn text(&self) -> String {
        let mut out = String::new();
        for line in &self.lines {
            if !out.is_empty() {
                // a colon leads to what follows it
                out += if out.ends_with(':') { " " } else { "; " };
            }
            out += &line.text();
        }
        out
    }

    /// The formulas, limits of comparisons included.
    pub fn formulas(&self) -> impl Iterator<Item = &Formula> {
        self.lines.iter().filter_map(|line| match line {
            Line::Formula(formula) | Line::Comparison { limit: formula, .. } => Some(formula),
            Line::Words(_) | Line::DecidedBy(_) => None,
        })
    }
}

impl<L: Into<Line>> From<L> for Derivation {
    fn from(line: L) -> Self {
        Self { lines: vec![line.into()] }
    }
}

/// A derivation in a file.
#[derive(Clone, Serialize, Deserialize)]
struct Record {
    /// As text.
    formula: String,
    /// As data; absent in files of earlier editions.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    derivation: Vec<Line>,
}

impl From<Derivation> for Record {
    fn from(of: Derivation) -> Self {
        // words alone are their own data
        let formula = of.text();
        let alone = matches!(of.lines.as_slice(), [Line::Words(_)]);
        Self { formula, derivation: if alone { Vec::new() } else { of.lines } }
    }
}

/// Data whose text is not the text of the file says something else, such as that of another
/// edition: then the text counts.
impl From<Record> for Derivation {
    fn from(record: Record) -> Self {
        let data = Self { lines: record.derivation };
        match data.text() == record.formula {
            true => data,
            false => record.formula.into(),
        }
    }
}
