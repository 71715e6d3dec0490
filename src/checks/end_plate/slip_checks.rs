//! Slip of preloaded bolts by their category, and the kind of holes and bolt assemblies.

use crate::assembly::{EndPlate, PlaneActions};
use crate::checks::check::{Check, Status, Topic, Unit, number as n};
use crate::checks::eurocode::bearing::Hole;
use crate::checks::eurocode::slip::{SlipHole, preload, slip_resistance};
use crate::checks::worked::Worked;
use crate::spec::connection::BoltCategory;
use crate::spec::loads::LimitState;

/// Tolerance of the comparison of hole diameters \[mm\].
const WIDER: f64 = 1e-6;

/// Kind of the holes for bearing and for slip: a hole wider than normal is oversize.
///
/// # Source
/// EN 1993-1-8:2005 Table 3.4 note 1 and Table 3.6; EN 1090-2 Table 11 for the clearances.
pub(super) fn hole(e: &EndPlate) -> (Hole, SlipHole) {
    if e.hole > e.bolt.hole_normal + WIDER {
        (Hole::Oversize, SlipHole::Oversize)
    } else {
        (Hole::Normal, SlipHole::Normal)
    }
}

/// Limit state in which slip is checked, as the title of the check, and its status where it fails.
fn demanded(category: Option<BoltCategory>, state: LimitState) -> Option<(&'static str, Status)> {
    const ULTIMATE: &str = "slip of the preloaded bolts at the ultimate limit state (category C)";
    const SERVICEABILITY: &str = "slip of the preloaded bolts at serviceability (category B)";
    match (category, state) {
        (Some(BoltCategory::B), LimitState::Serviceability) => {
            Some((SERVICEABILITY, Status::Failed))
        }
        (Some(BoltCategory::C), LimitState::Ultimate) => Some((ULTIMATE, Status::Failed)),
        (Some(_), _) => None,
        // no category is given, so slip need not be prevented
        (None, LimitState::Serviceability) => Some((SERVICEABILITY, Status::Warning)),
        (None, LimitState::Ultimate) => Some((ULTIMATE, Status::Warning)),
    }
}

/// Slip of all preloaded bolts of a plate. The compression of a moment balances the clamping force
/// that its tension takes (3.9.2(3)); an axial tension is shared by the bolts. The check binds
/// where the spec names category B or C. Otherwise the joint need not resist slip, and exceeding
/// the resistance is a warning.
///
/// # Source
/// EN 1993-1-8:2005 3.4.1, Table 3.2, 3.9.
pub(super) fn slip(e: &EndPlate, a: &PlaneActions) -> Option<Check> {
    let (title, otherwise) = demanded(e.category, a.state)?;
    // with a category that must not slip, no friction means no resistance; without a category there
    // is nothing to check
    let preload = e.preload.filter(|_| e.mu > 0.0 || e.category.is_some())?;
    let gamma = if a.state.is_ultimate() { e.factors.gamma_m3 } else { e.factors.gamma_m3_ser };
    let [axial, vy, vz] = a.at(1.0)[0];
    let shear = vy.hypot(vz);
    let bolts = 2.0 * e.rows.len() as f64;
    let mut worked = slip_resistance(hole(e).1, 1, e.mu, preload, axial.max(0.0) / bolts, gamma);
    worked.title = title;
    worked.formula =
        format!("V_Ed/n = {}/{}; {}", Unit::Force.show(shear), n(bolts), worked.formula);
    if !a.state.is_ultimate() {
        worked.formula = worked.formula.replace("γ_M3", "γ_M3,ser");
    }
    Some(worked.against(Topic::Bolts, a.end.clone(), shear / bolts, otherwise))
}

/// Kind of the holes, preloaded assemblies, and the load cases that a category requires.
pub(super) fn assembly(e: &EndPlate) -> Vec<Check> {
    let subject = format!("{} {}", e.bolt.size, e.grade.grade);
    let mut out = holes(e);
    if e.category == Some(BoltCategory::B)
        && !e.actions.is_empty()
        && e.actions.iter().all(|a| a.state.is_ultimate())
    {
        let title = "category B: no load case has `state: SLS`, so that slip is not checked";
        let mut check = Worked::new(
            "EN 1993-1-8:2005 3.4.1(3)",
            title,
            0.0,
            Unit::Number,
            "load cases of serviceability",
        )
        .information(Topic::Bolts, subject.clone());
        (check.resistance, check.status) = (None, Status::Undecided);
        out.push(check);
    }
    let Some(force) = e.preload else { return out };
    if e.bolt.system == "ISO 4014" {
        let title = "preloaded bolts are assemblies of EN 14399: take a size `HR …` or `HV …`";
        let words = format!("{} is of {}; F_p", e.bolt.size, e.bolt.standard);
        let mut check =
            Worked::new("EN 1993-1-8:2005 3.1.2(1), 1.2.4", title, force, Unit::Force, words)
                .information(Topic::Bolts, subject.clone());
        check.status = Status::Warning;
        out.push(check);
    }
    let full = preload(&e.bolt, &e.grade);
    if e.category.is_some_and(|c| matches!(c, BoltCategory::B | BoltCategory::C))
        && force > full.value * (1.0 + 1e-9)
    {
        let mut worked = full;
        worked.title = "preload of the slip resistance, no more than F_p,C";
        out.push(worked.against(Topic::Bolts, subject, force, Status::Failed));
    }
    out
}

/// Kind of the holes with its factors, and a warning where they are wider than oversize.
fn holes(e: &EndPlate) -> Vec<Check> {
    const CLAUSE: &str = "EN 1090-2:2008 Table 11";
    let b = &e.bolt;
    let (kind, slip) = hole(e);
    let (title, part) = match kind {
        Hole::Oversize => ("oversize round holes", 0.8),
        _ => ("normal round holes", 1.0),
    };
    let formula = format!(
        "d0 = {} mm, normal {} mm, oversize {} mm: bearing times {} (Table 3.4), k_s = {} (Table \
         3.6); d0 − d",
        n(e.hole),
        n(b.hole_normal),
        n(b.hole_oversize),
        n(part),
        n(slip.ks())
    );
    let mut out = vec![
        Worked::new(CLAUSE, title, e.hole - b.d, Unit::Length, formula)
            .information(Topic::Detailing, "holes"),
    ];
    let what = (CLAUSE, "oversize round hole");
    let rule = (b.hole_oversize, format!("{} mm", n(b.hole_oversize)));
    let wider =
        Check::at_most((Topic::Detailing, "holes"), what, "d0", rule, e.hole, Status::Warning);
    out.extend((wider.status != Status::Ok).then_some(wider));
    out
}
