//! Fillet welds of the column on its plate, under an elastic distribution of N and M.

use super::case_end::at;
use super::compression::IBase;
use crate::check::{Check, Status, Topic, Unit};
use crate::end_plate::without_strength;
use crate::eurocode::i_section::Section;
use crate::eurocode::welds::{
    PairForce, WeldedSteel, directional_pair, effective_run, flange_run, least_size,
};
use crate::formula::{Formula, Traced};
use crate::subject::{Part, Place};
use bracket_joint::assembly::PlaneActions;
use bracket_joint::strength::Strength;

/// A pair of welds on both sides of a flange or of the web.
struct Pair<'a> {
    part: Part,
    /// Thickness of the plate between them.
    thickness: f64,
    throat: f64,
    /// Effective length of each weld, the mean of both sides.
    run: Formula,
    steel: &'a Strength,
}

/// The pairs with fillets: flange, web.
fn pairs<'a>(e: &'a IBase<'_>) -> Vec<Pair<'a>> {
    let p = e.profile;
    let s = Section::from(p);
    let flange = Pair {
        part: Part::ColumnFlange,
        thickness: p.tf,
        throat: e.flange_throat,
        run: of_flange(e, s.root),
        steel: e.flange_steel.weaker(&e.plate_steel),
    };
    let web = Pair {
        part: Part::ColumnWeb,
        thickness: p.tw,
        throat: e.web_throat,
        run: effective_run(e.ends, s.clear_depth(), e.web_throat),
        steel: e.web_steel.weaker(&e.plate_steel),
    };
    [flange, web].into_iter().filter(|w| w.throat > 0.0).collect()
}

/// Mean effective length of the two sides of a flange; the root fillets of the web take their part
/// of the inner side.
fn of_flange(e: &IBase<'_>, root: f64) -> Formula {
    let lengths = [("b", e.profile.b), ("t_w", e.profile.tw), ("r", root), ("a", e.flange_throat)];
    let both = flange_run(e.ends, lengths.map(|(symbol, l)| Traced::length(symbol, l)));
    Formula::new("l_eff", both / Traced::from(2.0), Unit::Length)
}

/// Least sizes, and steels that give their welds no strength.
pub(super) fn sizes(e: &IBase<'_>) -> Vec<Check> {
    let mut out = Vec::new();
    for w in pairs(e) {
        out.extend(least_size(w.part, w.throat, w.run.value));
        if WeldedSteel::of(w.steel, e.factors.gamma_m2).is_none() {
            out.push(without_strength(w.part, w.steel));
        }
    }
    out
}

/// The welds of flanges and web by the directional method: a flange takes M/(h − t_f) and its
/// share of N, the web its elastic stresses and all of Vz; the flanges share Vy.
///
/// # Source
/// EN 1993-1-8:2005 4.5.3.2(6), 2.5(1). Compression counts like tension: contact of the column with
/// the plate is not asked for.
pub(super) fn under_load(e: &IBase<'_>, a: &PlaneActions) -> Vec<(Part, Check)> {
    let [[n, across, v], [_, m, _]] = a.at(1.0);
    let p = e.profile;
    let s = Section::from(p);
    let mut out = Vec::new();
    for w in pairs(e) {
        let Some(steel) = WeldedSteel::of(w.steel, e.factors.gamma_m2) else { continue };
        let run = w.run;
        let flange = w.part == Part::ColumnFlange;
        // each flange takes half of the shear across the column
        let shear = if flange { 0.5 * across.abs() } else { v.abs() };
        if n == 0.0 && m == 0.0 && shear == 0.0 || run.value <= 0.0 {
            continue;
        }
        let length = |symbol: &'static str, value| Traced::length(symbol, value);
        let moment = Traced::symbol("M_Ed", m.abs(), Unit::Moment);
        let push = Traced::force("N_Ed", n.abs()) / Traced::area("A", s.area);
        let normal = if flange {
            let area = length("b", p.b) * length("t_f", p.tf);
            let arm = length("h", p.h) - length("t_f", p.tf);
            (moment / arm + push * area) / run.traced()
        } else {
            let bent = moment * length("d", s.clear_depth())
                / (Traced::from(2.0) * Traced::number("I", s.i));
            (push + bent) * length("t_w", p.tw)
        };
        let normal = Formula::new("n", normal, Unit::ForcePerLength);
        let along = Traced::force("V_Ed", shear) / run.traced();
        let along = Formula::new("l", along, Unit::ForcePerLength);
        let force = PairForce { normal: normal.value, along: along.value, ..PairForce::default() };
        let mut worked = directional_pair(&force, w.thickness, w.throat, &steel);
        if along.value > 0.0 {
            worked = worked.after(along);
        }
        let worked = worked.after(normal).after(run);
        let seam = at(a).and(Place::Seam { of: w.part, to: Part::BasePlate });
        out.push((w.part, worked.utilised(Topic::Welds, seam, Status::Failed)));
    }
    out
}
