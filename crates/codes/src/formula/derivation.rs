//! The derivation of a value: formulas, comparisons and words, one after the other.

use super::number::Number;
use super::print::{Run, Style, english, on_one_line};
use super::term::{Term, extended};
use super::traced::Traced;
use crate::unit::Unit;
use bracket_base::say;
use bracket_base::words::Text;
use serde::{Deserialize, Serialize};

/// A value with its symbol and the term that gives it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Formula {
    /// Symbol of the value; empty where it has none.
    pub symbol: Text,
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
    pub fn new(symbol: impl Into<Text>, of: Traced, unit: Unit) -> Self {
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
        let symbol = vec![Run::Symbol(self.symbol.clone())];
        let mut out: Vec<Vec<Run>> = Vec::new();
        let mut last = String::new();
        for side in [symbol, of(Style::Symbols), of(Style::Numbers), vec![value]] {
            let text = english(&side);
            // a value repeats its number without a unit
            let repeats = last == text || text.split(' ').next() == Some(&last);
            match out.last_mut() {
                Some(before) if repeats => *before = side,
                _ if text.is_empty() => continue,
                _ => out.push(side),
            }
            last = text;
        }
        out
    }

    /// Its sides, joined by `=`.
    pub fn text(&self) -> Text {
        let mut runs = Vec::new();
        for side in self.sides() {
            if !runs.is_empty() {
                runs.push(Run::Text(" = ".into()));
            }
            runs.extend(side);
        }
        on_one_line(runs)
    }
}

/// The right-hand side of a formula, to be written out in another one.
impl From<&Formula> for Traced {
    fn from(of: &Formula) -> Self {
        Traced::new(of.value, of.term.clone())
    }
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
    Words(Text),
    /// A formula with its value.
    Formula(Formula),
    /// A value and its limit: `e1 = 23 mm < 1.2 d0 = 1.2 · 20 = 24 mm`.
    Comparison {
        /// Symbol of the value.
        symbol: Text,
        /// The value, internal unit.
        #[serde(with = "extended")]
        value: f64,
        /// Relation to the limit.
        relation: Relation,
        /// The limit; its unit is also that of the value.
        limit: Formula,
    },
    /// What would decide an undecided check.
    DecidedBy(Text),
}

impl Line {
    /// A value beside its limit; both have this unit.
    pub fn comparison(
        symbol: impl Into<Text>,
        value: f64,
        relation: Relation,
        limit: Traced,
        unit: Unit,
    ) -> Self {
        let limit = Formula::new("", limit, unit);
        Line::Comparison { symbol: symbol.into(), value, relation, limit }
    }

    /// The part as text.
    pub fn text(&self) -> Text {
        match self {
            Line::Words(words) => words.clone(),
            Line::Formula(formula) => formula.text(),
            Line::Comparison { relation, limit, .. } => {
                let sign = relation.sign().to_owned();
                say!("{} {} {}", self.provided(), sign, limit.text())
            }
            Line::DecidedBy(step) => say!("what would decide it: {}", step),
        }
    }

    /// The value of a comparison with its symbol; empty for other parts.
    pub fn provided(&self) -> Text {
        match self {
            Line::Comparison { symbol, value, limit, .. } => {
                say!("{} = {}", symbol, limit.unit.show(*value))
            }
            _ => Text::default(),
        }
    }

    /// Whether it leads to what follows it.
    fn leads_on(&self) -> bool {
        match self {
            Line::Words(words) | Line::DecidedBy(words) => words.id.ends_with(':'),
            Line::Formula(_) | Line::Comparison { .. } => false,
        }
    }
}

impl From<Formula> for Line {
    fn from(formula: Formula) -> Self {
        Line::Formula(formula)
    }
}

impl From<Text> for Line {
    fn from(words: Text) -> Self {
        Line::Words(words)
    }
}

impl From<&'static str> for Line {
    fn from(words: &'static str) -> Self {
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
    pub fn text(&self) -> Text {
        text_of(&self.lines)
    }

    /// The formulas, limits of comparisons included.
    pub fn formulas(&self) -> impl Iterator<Item = &Formula> {
        self.lines.iter().filter_map(|line| match line {
            Line::Formula(formula) | Line::Comparison { limit: formula, .. } => Some(formula),
            Line::Words(_) | Line::DecidedBy(_) => None,
        })
    }

    /// Whether its first formula is that of the demand: `V_wp,Ed = …; V_wp,Rd = …`. One without a
    /// symbol is if its term is made of demands.
    pub(crate) fn has_demand(&self) -> bool {
        let first = self.lines.iter().find_map(|line| match line {
            Line::Formula(formula) if formula.symbol.is_empty() => {
                Some(formula.term.symbols().into_iter().any(|(symbol, ..)| of_demand(symbol)))
            }
            Line::Formula(Formula { symbol, .. }) | Line::Comparison { symbol, .. } => {
                Some(of_demand(symbol))
            }
            Line::Words(_) | Line::DecidedBy(_) => None,
        });
        first.unwrap_or(false)
    }
}

/// Whether a symbol is that of a demand.
fn of_demand(symbol: &Text) -> bool {
    symbol.id.contains("Ed")
}

impl<L: Into<Line>> From<L> for Derivation {
    fn from(line: L) -> Self {
        Self { lines: vec![line.into()] }
    }
}

/// Parts of a derivation as text.
pub(crate) fn text_of(lines: &[Line]) -> Text {
    if let [line] = lines {
        return line.text();
    }
    let mut id = String::new();
    for (i, _) in lines.iter().enumerate() {
        id += match i.checked_sub(1).map(|before| lines[before].leads_on()) {
            None => "{}",
            // a colon leads to what follows it
            Some(true) => " {}",
            Some(false) => "; {}",
        };
    }
    Text { id: id.into(), gaps: lines.iter().map(|line| line.text().into()).collect() }
}

/// A derivation in a file.
#[derive(Clone, Serialize, Deserialize)]
struct Record {
    /// As text.
    formula: Text,
    /// As data; absent in files of earlier editions.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    derivation: Vec<Line>,
}

impl From<Derivation> for Record {
    fn from(of: Derivation) -> Self {
        match of.lines.as_slice() {
            // words alone are their own data
            [Line::Words(words)] => Self { formula: words.clone(), derivation: Vec::new() },
            _ => Self { formula: of.text().sentence(), derivation: of.lines },
        }
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
