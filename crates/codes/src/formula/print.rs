//! Terms as text and as pieces of a layout.
//!
//! A product is written without a sign between symbols, `k2 f_ub A_s`, and with `·` before a
//! number. It binds more strongly than the stroke: `a f_u/(√3 β_w γ_M2)`.

use super::term::Term;
use crate::unit::{Unit, number};
use bracket_base::words::{Gap, Said, Text};
use std::sync::Arc;

/// How symbols and numbers are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Style {
    /// Symbols by their names.
    Symbols,
    /// Symbols by their values with four digits, forces and moments in kN and kN m.
    Numbers,
    /// Symbols by their values in the internal units with all digits.
    Exact,
}

/// How strongly the pieces of a part hold together.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Strength {
    /// A sum.
    Sum,
    /// A product or a quotient.
    Product,
    /// A number with its unit, or with its sign.
    Measure,
    /// One symbol, number, bracket or call.
    Atom,
}

/// A piece of a printed term.
#[derive(Clone, Debug, PartialEq)]
pub enum Run {
    /// Signs, brackets and names of functions.
    Text(String),
    /// A number, with its unit if it is shown.
    Number(String),
    /// A symbol.
    Symbol(Text),
    /// A fraction.
    Fraction(Part, Part),
}

/// Pieces one after the other.
#[derive(Clone, Debug, PartialEq)]
pub struct Part {
    /// The pieces.
    pub runs: Vec<Run>,
    strength: Strength,
}

impl Part {
    fn atom(run: Run) -> Self {
        Self { runs: vec![run], strength: Strength::Atom }
    }

    /// The pieces, in brackets where they hold together less strongly than their neighbours need.
    fn within(mut self, least: Strength) -> Vec<Run> {
        if self.strength < least {
            self.runs.insert(0, Run::Text("(".into()));
            self.runs.push(Run::Text(")".into()));
        }
        self.runs
    }

    /// The pieces to the right of a sign, in brackets if they begin with a sign of their own.
    fn right_of_sign(self, least: Strength) -> Vec<Run> {
        let signed = self.is_signed();
        self.within(if signed { Strength::Atom } else { least })
    }

    /// Whether the pieces begin with a sign.
    fn is_signed(&self) -> bool {
        match self.runs.first() {
            Some(Run::Number(text)) => text.starts_with('-'),
            Some(Run::Text(text)) => text == "−",
            Some(Run::Fraction(top, _)) => top.is_signed(),
            _ => false,
        }
    }
}

impl Run {
    /// Gives the pieces on one line one after the other; a fraction is written with a stroke.
    fn each(self, put: &mut impl FnMut(Gap)) {
        match self {
            Run::Text(text) | Run::Number(text) => put(Gap::Given(text)),
            Run::Symbol(symbol) => put(symbol.into()),
            Run::Fraction(top, bottom) => {
                top.within(Strength::Product).into_iter().for_each(|run| run.each(put));
                put(Gap::Given("/".into()));
                bottom.within(Strength::Measure).into_iter().for_each(|run| run.each(put));
            }
        }
    }
}

/// Pieces on one line as text: symbols are messages, all else is given.
pub(super) fn on_one_line(runs: Vec<Run>) -> Text {
    let mut gaps: Vec<Gap> = Vec::new();
    for run in runs {
        run.each(&mut |gap| match (gaps.last_mut(), gap) {
            (Some(Gap::Given(before)), Gap::Given(text)) => before.push_str(&text),
            (_, gap) => gaps.push(gap),
        });
    }
    match (gaps.len(), gaps.pop()) {
        (1, Some(Gap::Text(Said(symbol)))) => symbol,
        (count, last) => {
            gaps.extend(last);
            Text { id: "{}".repeat(count).into(), gaps }
        }
    }
}

/// Pieces on one line in English.
pub(super) fn english(runs: &[Run]) -> String {
    let mut out = String::new();
    for run in runs {
        match run {
            Run::Text(text) | Run::Number(text) => out += text,
            Run::Symbol(symbol) => out += &symbol.to_string(),
            Run::Fraction(top, bottom) => {
                out += &english(&top.clone().within(Strength::Product));
                out += "/";
                out += &english(&bottom.clone().within(Strength::Measure));
            }
        }
    }
    out
}

impl Term {
    /// The term in English.
    pub fn print(&self, style: Style) -> String {
        english(&self.part(style).runs)
    }

    /// The term with its symbols as text.
    pub fn text(&self) -> Text {
        on_one_line(self.part(Style::Symbols).runs)
    }

    /// The pieces of the term.
    pub fn part(&self, style: Style) -> Part {
        match self {
            Term::Constant(value) => value_part(*value, Unit::Number, style),
            Term::Symbol(name, ..) if style == Style::Symbols => {
                Part::atom(Run::Symbol(name.clone()))
            }
            Term::Symbol(_, value, unit) => value_part(*value, *unit, style),
            Term::Sum(a, b) => sum(a, " + ", b, style),
            Term::Difference(a, b) => sum(a, " − ", b, style),
            Term::Product(..) | Term::Quotient(..) => quotient(self, style),
            Term::Negative(a) => {
                joined([text("−"), a.part(style).right_of_sign(Strength::Product)], Strength::Sum)
            }
            Term::Power(base, exponent) => power(base, exponent, style),
            Term::Root(of) => {
                joined([text("√"), of.part(style).within(Strength::Atom)], Strength::Atom)
            }
            Term::Absolute(of) => {
                joined([text("|"), of.part(style).runs, text("|")], Strength::Atom)
            }
            Term::Least(all) => call("min(", all, style),
            Term::Largest(all) => call("max(", all, style),
            Term::Series(all) if style == Style::Symbols => {
                let body = all.first().map(|first| first.part(style).within(Strength::Product));
                joined([text("Σ "), body.unwrap_or_default()], Strength::Sum)
            }
            Term::Series(all) => {
                let strength = if all.len() == 1 { Strength::Product } else { Strength::Sum };
                list(all, " + ", |t| t.part(style).right_of_sign(Strength::Product), strength)
            }
        }
    }
}

fn text(text: &str) -> Vec<Run> {
    vec![Run::Text(text.into())]
}

fn joined<const N: usize>(runs: [Vec<Run>; N], strength: Strength) -> Part {
    Part { runs: runs.into_iter().flatten().collect(), strength }
}

/// Several terms with something between them.
fn list(
    all: &[Arc<Term>],
    between: &str,
    each: impl Fn(&Term) -> Vec<Run>,
    strength: Strength,
) -> Part {
    let mut runs = Vec::new();
    for (i, term) in all.iter().enumerate() {
        if i > 0 {
            runs.extend(text(between));
        }
        runs.extend(each(term));
    }
    Part { runs, strength }
}

fn value_part(value: f64, unit: Unit, style: Style) -> Part {
    let (text, measured) = match style {
        Style::Exact => (format!("{value:?}"), false),
        // stresses and lengths stand without their unit, as in the code
        _ if unit.printed().0 == 1.0 => (number(value), false),
        _ => (unit.show(value), true),
    };
    let strength =
        if text.starts_with('-') || measured { Strength::Measure } else { Strength::Atom };
    Part { runs: vec![Run::Number(text)], strength }
}

fn sum(a: &Term, sign: &str, b: &Term, style: Style) -> Part {
    // a sum to the right of a plus needs no brackets
    let least = if sign == " + " { Strength::Sum } else { Strength::Product };
    let right = b.part(style).right_of_sign(least);
    joined([a.part(style).runs, text(sign), right], Strength::Sum)
}

/// The factors of a term above and below the line.
fn factors<'a>(term: &'a Term, above: &mut Vec<&'a Term>, below: &mut Vec<&'a Term>) {
    match term {
        Term::Product(a, b) => {
            factors(a, above, below);
            factors(b, above, below);
        }
        Term::Quotient(a, b) => {
            factors(a, above, below);
            factors(b, below, above);
        }
        factor => above.push(factor),
    }
}

fn quotient(term: &Term, style: Style) -> Part {
    let (mut above, mut below) = (Vec::new(), Vec::new());
    factors(term, &mut above, &mut below);
    below.retain(|factor| **factor != Term::Constant(1.0));
    let top = product(&above, style);
    if below.is_empty() {
        return top;
    }
    let fraction = Run::Fraction(top, product(&below, style));
    Part { runs: vec![fraction], strength: Strength::Product }
}

fn product(factors: &[&Term], style: Style) -> Part {
    // a symbol times itself is its power
    let same = |a: &&Term, b: &&Term| match (a, b) {
        (Term::Symbol(a, x, u), Term::Symbol(b, y, v)) => (x, u) == (y, v) && a == b,
        _ => false,
    };
    let mut parts = factors.chunk_by(same).map(|same| match same.len() {
        1 => same[0].part(style),
        n => power(same[0], &Term::Constant(n as f64), style),
    });
    let Some(mut out) = parts.next() else {
        return Part::atom(Run::Number("1".into()));
    };
    for part in parts {
        let right = part.right_of_sign(Strength::Measure);
        // between two symbols a blank is enough
        let symbols = style == Style::Symbols && !matches!(right[0], Run::Number(_));
        let between = if symbols { " " } else { " · " };
        let left = out.within(Strength::Product);
        out = joined([left, text(between), right], Strength::Product);
    }
    out
}

fn power(base: &Term, exponent: &Term, style: Style) -> Part {
    let base = base.part(style).within(Strength::Atom);
    let raised = match exponent {
        Term::Constant(2.0) => text("²"),
        Term::Constant(3.0) => text("³"),
        _ => joined([text("^"), exponent.part(style).within(Strength::Atom)], Strength::Atom).runs,
    };
    joined([base, raised], Strength::Atom)
}

fn call(name: &str, all: &[Arc<Term>], style: Style) -> Part {
    let arguments = list(all, ", ", |t| t.part(style).runs, Strength::Atom);
    joined([text(name), arguments.runs, text(")")], Strength::Atom)
}
