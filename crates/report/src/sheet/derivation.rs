//! Derivations of checks as pieces, with the fractions of their formulas.

use crate::document::symbols::{Piece, pieces};
use crate::words::Words;
use bracket_codes::formula::{Derivation, Line, Run};

/// The pieces of a derivation, in the language of `words`.
pub fn derivation(of: &Derivation, words: &Words) -> Vec<Piece> {
    let mut out = Vec::new();
    for line in &of.lines {
        if !out.is_empty() {
            let leads = |p: &Piece| p.text.ends_with(':');
            out.push(Piece::text(if out.last().is_some_and(leads) { " " } else { "; " }));
        }
        match line {
            Line::Words(_) | Line::DecidedBy(_) => out.extend(pieces(&words.say(&line.text()))),
            Line::Formula(formula) => out.extend(sides(formula.sides(), words)),
            Line::Comparison { relation, limit, .. } => {
                out.extend(pieces(&words.say(&line.provided())));
                out.push(Piece::text(format!(" {} ", relation.sign())));
                out.extend(sides(limit.sides(), words));
            }
        }
    }
    joined(out)
}

/// The sides of an equation.
fn sides(sides: Vec<Vec<Run>>, words: &Words) -> Vec<Piece> {
    let mut out = Vec::new();
    for side in sides {
        if !out.is_empty() {
            out.push(Piece::text(" = "));
        }
        out.extend(runs(side, words));
    }
    out
}

fn runs(runs: Vec<Run>, words: &Words) -> Vec<Piece> {
    joined(runs.into_iter().flat_map(|run| one(run, words)).collect())
}

fn one(run: Run, words: &Words) -> Vec<Piece> {
    match run {
        Run::Text(text) => vec![Piece::text(text)],
        // a unit stays on the line of its number
        Run::Number(text) => vec![Piece::text(text.replace(' ', "\u{a0}"))],
        Run::Symbol(symbol) => symbol_pieces(&words.say(&symbol)),
        Run::Fraction(top, bottom) => vec![Piece {
            top: runs(top.runs, words),
            bottom: runs(bottom.runs, words),
            ..Piece::default()
        }],
    }
}

/// A symbol; one letter without a subscript is one as well.
fn symbol_pieces(symbol: &str) -> Vec<Piece> {
    let mut found = pieces(symbol);
    if let [piece] = found.as_mut_slice()
        && piece.text.chars().filter(|c| c.is_alphabetic()).count() == 1
    {
        piece.symbol = true;
    }
    found
}

/// Neighbouring texts as one.
fn joined(pieces: Vec<Piece>) -> Vec<Piece> {
    let mut out: Vec<Piece> = Vec::new();
    for piece in pieces {
        let plain = |p: &Piece| !p.symbol && p.top.is_empty();
        match out.last_mut().filter(|last| plain(last) && plain(&piece)) {
            Some(last) => last.text.push_str(&piece.text),
            None => out.push(piece),
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;
    use bracket_codes::Unit;
    use bracket_codes::formula::{Formula, Number, Relation, Traced};

    /// Pieces as text: fractions in braces, symbols in angle brackets.
    fn shown(pieces: &[Piece]) -> String {
        let one = |p: &Piece| match (p.top.is_empty(), p.symbol) {
            (false, _) => format!("{{{}|{}}}", shown(&p.top), shown(&p.bottom)),
            (_, true) if p.below.is_empty() => format!("<{}>", p.text),
            (_, true) => format!("<{}_{}>", p.text, p.below),
            _ => p.text.replace('\u{a0}', " "),
        };
        pieces.iter().map(one).collect()
    }

    #[test]
    fn a_quotient_is_a_fraction_and_a_stroke_in_words_stays_one() {
        let [a, f] = [Traced::length("a", 5.0), Traced::stress("f_u", 360.0)];
        let root = Traced::from(3.0).sqrt() * Traced::number("β_w", 0.8);
        let weld = Formula::new("F_w,Rd", a.clone() * f / root, Unit::ForcePerLength);
        let limit = Formula::new("", Traced::from(6.0) * a, Unit::Length);
        let of = Derivation::from("force and/or stress:").then(weld).then(Line::Comparison {
            symbol: "l_eff".into(),
            value: 20.0,
            relation: Relation::Below,
            limit,
        });
        assert_eq!(
            shown(&derivation(&of, &Words::default())),
            "force and/or stress: <F_w,Rd> = {<a> <f_u>|√3 <β_w>} = {5 · 360|√3 · 0.8} = \
             1299 N/mm; <l_eff> = 20 mm < 6 <a> = 6 · 5 = 30 mm"
        );
    }
}
