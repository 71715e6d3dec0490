//! Resistance of a joint by the component method, to compare with the bracket of a limit analysis.

use crate::check::{CheckId, Unit, number as n, within};
use crate::component_method::Assessment;
use crate::component_method::equilibrium::{Carried, Equilibrium, SMALL_AXIAL};
use crate::formula::{Derivation, Formula, Number, Traced};
use crate::subject::Sense;
use crate::worked::Worked;
use bracket_base::say;
use bracket_base::words::Text;
use bracket_joint::assembly::{EndPlate, PlaneActions};
use serde::{Deserialize, Serialize};

/// Resistance of a joint by the component method, for the sense of bending of a load case.
#[derive(Clone, Debug)]
pub(super) struct Method {
    /// M_j,Rd \[N mm\].
    pub moment: f64,
    /// Moment and axial force together; `None` without an axial force, or where the tables do not
    /// cover the joint.
    pub equilibrium: Option<Equilibrium>,
    /// β.
    pub beta: f64,
    /// Sense of bending.
    pub sense: Sense,
}

impl Method {
    /// Whether an axial force is small enough to be neglected beside a moment.
    fn small(&self, axial: f64) -> bool {
        axial == 0.0 || self.equilibrium.as_ref().is_some_and(|e| e.small(axial))
    }

    /// M_j,Ed/M_j,Rd; 0 without a moment, whatever the resistance.
    pub(super) fn bending(&self, moment: f64) -> f64 {
        self.traced_bending(moment).value()
    }

    fn traced_bending(&self, moment: f64) -> Traced {
        if moment == 0.0 && self.moment == 0.0 {
            return Traced::from(0.0);
        }
        size("M_j,Ed", moment, Unit::Moment) / Traced::symbol("M_j,Rd", self.moment, Unit::Moment)
    }

    /// Plastic equilibrium of the rows, where the axial force counts.
    pub(super) fn with_axial(&self, [force, moment]: [[f64; 3]; 2]) -> Option<Carried> {
        let (axial, my) = (force[0], moment[1]);
        self.equilibrium.as_ref().filter(|_| !self.small(axial))?.at(axial, my)
    }

    /// Utilisation of the joint under forces and moments of a member end, to be at most 1.
    ///
    /// M_j,Ed/M_j,Rd, and N_j,Ed/N_j,Rd where that is more; beyond |N_Ed| = 5 % of N_pl,Rd at least
    /// the reciprocal of the largest factor on M and N together, by the plastic equilibrium of the
    /// components. Tension relieves the compressed side, which is not counted.
    ///
    /// `None` where an axial force counts and the tables do not cover it.
    ///
    /// # Source
    /// EN 1993-1-8:2005 6.2.7.1(2) and (3).
    pub(super) fn share(&self, at: [[f64; 3]; 2]) -> Option<Worked> {
        const CLAUSE: &str = "EN 1993-1-8:2005 6.2.7.1";
        const ID: CheckId = CheckId::MomentAndAxial;
        let (axial, moment) = (at[0][0], at[1][1]);
        // beside a moment and an axial force with their signs the demand is an absolute value
        let signed = !self.small(axial);
        let bending = self.traced_bending(if signed { moment } else { moment.abs() });
        let symbol = "M_j,Ed/M_j,Rd";
        if axial == 0.0 {
            return Some(Worked::of(CLAUSE, ID, symbol, bending, Unit::Number));
        }
        let bending = bending.named(symbol, Unit::Number);
        let before = Derivation::from(Formula::new(symbol, bending.clone(), Unit::Number));
        let larger = |other, before| {
            Worked::of(CLAUSE, ID, "", bending.max(other), Unit::Number).after(before)
        };
        if !signed {
            // a small force is neglected beside the moment, but by itself it is still compared with
            // the resistance of the joint
            let symbol = "N_Ed/N_j,Rd";
            let alone = self.pull(axial, axial.abs())?.named(symbol, Unit::Number);
            let alone_line = Formula::new(symbol, alone.clone(), Unit::Number);
            let words = "not added for N_Ed ≤ 0.05 N_pl,Rd";
            return Some(larger(alone, before.then(alone_line).then(words)));
        }
        let carried = self.with_axial(at).filter(|c| c.factor > 0.0)?;
        let together = Traced::from(1.0) / Traced::number("α", carried.factor);
        let worked = larger(together, before.followed_by(largest_multiple(moment, axial)));
        Some(self.by_hand(worked, &carried, [axial, moment]))
    }

    /// N_Ed/N_j,Rd of an axial force, which the formula shows as `demand`; `None` without a
    /// resistance.
    fn pull(&self, axial: f64, demand: f64) -> Option<Traced> {
        let e = self.equilibrium.as_ref()?;
        let resistance = if axial > 0.0 { e.tension } else { e.compression };
        let demand = size("N_Ed", demand, Unit::Force);
        Some(demand / Traced::force("N_j,Rd", resistance)).filter(|_| resistance > 0.0)
    }

    /// Adds to the check what a hand needs to follow it: the forces of rows and flanges at the
    /// largest multiple, their sums, and the linear sum of formula 6.24 beside it.
    fn by_hand(&self, mut worked: Worked, carried: &Carried, [axial, moment]: [f64; 2]) -> Worked {
        let Some(e) = &self.equilibrium else { return worked };
        let alpha = carried.factor;
        let [upper, web, lower] = carried.compression;
        worked = worked.then("tension positive");
        let mut forces: Vec<(Text, f64, f64)> = carried
            .rows
            .iter()
            .map(|r| (say!("F of the row at z = {} mm", n(r.z)), r.force, r.z))
            .collect();
        forces.retain(|f| f.1 > 0.0);
        forces.sort_by(|a, b| b.2.total_cmp(&a.2));
        let [top, bottom] = e.middles;
        let middle = 0.5 * (top + bottom);
        let (above, axis, below) = (n(top), n(middle), n(bottom));
        let parts = [
            (say!("F of the upper flange at z = {} mm", above), upper, top),
            (say!("F of the web at z = {} mm", axis), web, middle),
            (say!("F of the lower flange at z = {} mm", below), lower, bottom),
        ];
        let pushed = parts.into_iter().filter(|p| p.1 > 0.0);
        forces.extend(pushed.map(|(symbol, push, z)| (symbol, -push, z)));
        let force = |f: &(Text, f64, f64)| Traced::force("F", f.1);
        let turning = |f: &(Text, f64, f64)| force(f) * Traced::length("z", f.2);
        let of_load =
            |symbol, load, unit| Traced::number("α", alpha) * Traced::symbol(symbol, load, unit);
        let (sum, turned) = (forces.iter().map(force), forces.iter().map(turning));
        for (symbol, of, unit) in [
            ("Σ F", Traced::series(sum), Unit::Force),
            ("α N_Ed", of_load("N_Ed", axial, Unit::Force), Unit::Force),
            ("Σ F z", Traced::series(turned), Unit::Moment),
            ("α M_j,Ed", of_load("M_j,Ed", moment, Unit::Moment), Unit::Moment),
        ] {
            worked = worked.then(Formula::new(symbol, of, unit));
        }
        for (symbol, force, _) in forces {
            worked = worked.with(symbol, force, Unit::Force);
        }
        worked = worked.with("α", alpha, Unit::Number);
        if let Some(pull) = self.pull(axial, axial) {
            let sum = self.traced_bending(moment) + pull;
            let value = sum.value();
            worked = worked
                .then("linear sum (6.24)")
                .then(Formula::new("", sum, Unit::Number))
                .then(
                    "it does not bind: 6.2.7.1(3) offers it as a conservative method, and forces \
                     in equilibrium, none beyond its resistance, satisfy 2.5(1)",
                )
                .with("linear sum (6.24)", value, Unit::Number);
        }
        worked
    }
}

/// The absolute value of a demand.
fn size(symbol: &'static str, value: f64, unit: Unit) -> Traced {
    let of = Traced::symbol(symbol, value, unit);
    if value < 0.0 { of.abs() } else { of }
}

/// What the largest multiple α in plastic equilibrium is of.
pub(super) fn largest_multiple(moment: f64, axial: f64) -> Derivation {
    let of = |symbol, value, unit| Formula::new(symbol, Traced::symbol(symbol, value, unit), unit);
    Derivation::from(of("M_j,Ed", moment, Unit::Moment))
        .then(of("N_Ed", axial, Unit::Force))
        .then("α is the largest multiple of M_j,Ed and N_Ed in plastic equilibrium")
}

/// Result of the component method for a load case at one member end.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Comparison {
    /// Load case.
    #[serde(skip)]
    pub case: String,
    /// Member end.
    pub end: String,
    /// Sense of bending: `tension at the top`.
    pub sense: Text,
    /// β of 5.3(8); 0 in a splice.
    pub beta: f64,
    /// M_j,Ed at the bolt plane \[N mm\].
    pub demand: f64,
    /// M_j,Rd \[N mm\].
    pub resistance: f64,
    /// The load factor at which moment and axial force reach the resistance; absent where they
    /// never reach it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub factor: Option<f64>,
    /// Components that limit the rows, from the tension side: a sentence.
    pub limited_by: Text,
    /// Components that may buckle, a sentence each: the component method then binds the verdict.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub stability: Vec<Text>,
    /// Lever arm M_j,Rd/ΣF_tr,Rd \[mm\].
    pub lever: f64,
    /// M_c,Rd of the beam \[N mm\].
    pub beam: f64,
    /// Half of the width of a bolt's head across flats \[mm\].
    pub head: f64,
}

impl Comparison {
    pub(super) fn new(
        e: &EndPlate,
        a: &PlaneActions,
        method: &Method,
        assessment: &Assessment,
    ) -> Self {
        let upside_down = a.at(1.0)[1][1] < 0.0;
        let rows = assessment.rows.iter().map(|r| {
            let z = n(if upside_down { -r.z } else { r.z });
            let (force, by) = (Unit::Force.show(r.force), r.limited_by.text());
            match r.mode {
                Some(mode) => say!("z = {} mm {} ({}, {})", z, force, by, mode.name()),
                None => say!("z = {} mm {} ({})", z, force, by),
            }
        });
        let total = assessment.tension();
        Self {
            case: a.case.clone(),
            end: a.end.clone(),
            sense: method.sense.words().into(),
            beta: method.beta,
            demand: a.at(1.0)[1][1],
            resistance: method.moment,
            factor: factor(a, method),
            limited_by: Text::joined("; ", rows),
            stability: assessment
                .stability
                .iter()
                .map(|s| say!("{} ({})", s.why.text(), s.clause))
                .collect(),
            lever: if total > 0.0 { method.moment / total } else { 0.0 },
            beam: assessment.beam_moment.value,
            head: 0.5 * e.bolt.head_width,
        }
    }
}

/// Least load factor at which the utilisation by moment and axial force reaches 1; `None` where it
/// never does.
fn factor(a: &PlaneActions, method: &Method) -> Option<f64> {
    if a.dead.iter().flatten().all(|x| *x == 0.0) {
        let [[axial, ..], [_, my, _]] = a.at(1.0);
        let bending = if my == 0.0 { f64::INFINITY } else { method.moment / my.abs() };
        // load factor from which the axial force counts
        let plastic = method.equilibrium.as_ref().map_or(f64::INFINITY, |e| e.plastic);
        let counts = SMALL_AXIAL * plastic / axial.abs();
        let together =
            || method.equilibrium.as_ref().and_then(|e| e.at(axial, my)).map_or(0.0, |c| c.factor);
        let least =
            if within(bending, counts) { bending } else { bending.min(together()).max(counts) };
        let resistance = method
            .equilibrium
            .as_ref()
            .map(|e| if axial > 0.0 { e.tension } else { e.compression });
        let alone = resistance.filter(|_| axial != 0.0).map_or(f64::INFINITY, |r| r / axial.abs());
        let least = least.min(alone);
        return least.is_finite().then_some(least);
    }
    let over = |factor: f64| method.share(a.at(factor)).is_none_or(|u| u.value >= 1.0);
    if over(0.0) {
        return Some(0.0);
    }
    let (mut low, mut high) = (0.0, 1.0);
    while !over(high) {
        (low, high) = (high, 2.0 * high);
        if high > 1e6 {
            return None;
        }
    }
    while high - low > 1e-9 * high {
        let middle = 0.5 * (low + high);
        if over(middle) {
            high = middle;
        } else {
            low = middle;
        }
    }
    Some(high)
}
