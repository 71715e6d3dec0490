//! Buckling of a compressed cover between the bolts that hold it.

use super::distances::{ends, pitches};
use crate::check::{Unit, within};
use crate::eurocode::column_curve::{CURVE_C, chi, lambda_1, phi};
use crate::eurocode::section::epsilon;
use crate::formula::{Derivation, Formula, Line, Number, Relation, Traced};
use bracket_joint::strength::Strength;

/// Share of the distance between bolts that is the buckling length, Table 3.3 note 2.
const BUCKLING_LENGTH: f64 = 0.6;
/// Distance over thickness, over ε, up to which nothing buckles, Table 3.3 note 2.
const STOCKY: f64 = 9.0;

/// χ of a cover between its bolts.
pub(super) struct Buckling {
    /// How slender the cover is.
    pub before: Derivation,
    /// χ; `None` where it is too stocky to buckle.
    pub chi: Option<Formula>,
}

/// The largest distance between bolts along the covers: across the gap, or between rows \[mm\].
pub(super) fn free_length(rows: &[f64]) -> f64 {
    let [first, _] = ends(rows);
    pitches(rows).map_or(0.0, |[_, most]| most).max(2.0 * first)
}

/// χ of a cover between bolts at the distance `p` \[mm\].
///
/// # Source
/// EN 1993-1-8:2005 Table 3.3 note 2: p/t ≤ 9 ε, else a member of the length 0.6 p; EN
/// 1993-1-1:2005 6.3.1, curve c.
pub(super) fn buckling(p: f64, thickness: f64, steel: &Strength) -> Buckling {
    let n = Traced::from;
    let limit = n(STOCKY) * Traced::number("ε", epsilon(steel.fy.mpa()));
    let line = |relation| {
        let limit = limit.clone();
        Line::comparison("p1/t", p / thickness, relation, limit, Unit::Number)
    };
    if within(p / thickness, limit.value()) {
        return Buckling { before: line(Relation::AtMost).into(), chi: None };
    }
    let length = n(BUCKLING_LENGTH) * Traced::length("p1", p);
    let radius = Traced::length("t", thickness) / n(12.0).sqrt();
    let slowest = lambda_1(Traced::stress("E", steel.e), Traced::stress("f_y", steel.fy.mpa()));
    let slenderness = Formula::new("λ̄", length / (radius * slowest), Unit::Number);
    let alpha = Traced::number("α", CURVE_C);
    let phi = Formula::new("Φ", phi(alpha, slenderness.traced()), Unit::Number);
    let chi = Formula::new("χ", chi(phi.traced(), slenderness.traced()), Unit::Number);
    let before = Derivation::from(line(Relation::Above)).then(slenderness).then(phi);
    Buckling { before, chi: Some(chi) }
}
