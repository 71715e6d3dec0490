//! Effective lengths of fillet welds: one rule for all welds, by `welds.ends` of the spec.

use super::at_plate::{self, PlateFlange};
use crate::check::{Check, CheckId, Topic, Unit};
use crate::eurocode::welds::{effective_run, flange_run};
use crate::formula::{Formula, Number, Traced};
use crate::subject::Part;
use bracket_joint::assembly::{EndPlate, Way};
use bracket_joint::spec::welds::WeldEnds;

/// l_eff \[mm\]; negative where a run is shorter than its ends.
fn effective(length: Traced) -> Formula {
    Formula::new("l_eff", length, Unit::Length)
}

/// A single run of a weld, `length` long \[mm\], with its throat \[mm\]; see [`effective_run`].
pub(super) fn run(e: &EndPlate, length: f64, throat: f64) -> Formula {
    effective_run(e.welds.ends, length, throat)
}

/// The welds of one flange of the beam: outside along its width, inside up to the root fillets.
///
/// # Source
/// EN 1993-1-8:2005 4.5.1(1), see [`flange_run`]. Open runs that are too short, 4.5.1(2), do not
/// count.
pub(super) fn flange(e: &EndPlate, f: &PlateFlange<'_>) -> Formula {
    let lengths = [("b", f.width), ("t_w", f.web), ("r", f.root), ("a", e.flange_throat)];
    let lengths = lengths.map(|(symbol, value)| Traced::length(symbol, value));
    effective(flange_run(e.welds.ends, lengths))
}

/// Length of the shortest of the welds of a flange that stand alone, for 4.5.1(2) \[mm\]: outside
/// along its width, or one of the inside runs where they stop at the tips.
pub(super) fn shortest_of_flange(e: &EndPlate, f: &PlateFlange<'_>) -> f64 {
    let a = e.flange_throat;
    match e.welds.ends {
        WeldEnds::Open => run(e, 0.5 * (f.width - f.web) - f.root, a).value,
        WeldEnds::Returned | WeldEnds::AllRound => run(e, f.width, a).value,
    }
}

/// Clear depth of the beam web between the root fillets along the plate, that of the haunch web
/// included \[mm\].
pub(super) fn web_depth(e: &EndPlate) -> f64 {
    let (b, r) = (&e.beam, e.beam.r);
    if at_plate::rafter(e).is_none() {
        return b.h - 2.0 * (b.tf + r);
    }
    let end = at_plate::beam(e);
    let clear = e.depth() - end.along(Way::Up) - end.along(Way::Down) - 2.0 * r;
    at_plate::inner_flange(e).map_or(clear, |[lower, upper]| clear - (upper - lower))
}

/// Each of the two welds of the beam web, between the root fillets. The flange above a haunch parts
/// it into two runs: one more pair of ends.
pub(super) fn web(e: &EndPlate) -> Formula {
    let parted = match (at_plate::haunch(e), e.welds.ends) {
        (None, _) | (_, WeldEnds::AllRound) => 0.0,
        (Some(_), WeldEnds::Returned | WeldEnds::Open) => 2.0 * e.web_throat,
    };
    run(e, web_depth(e) - parted, e.web_throat)
}

/// l_eff as a factor of a resistance, no less than 0.
pub(super) fn counted(length: &Formula) -> Traced {
    let l = length.traced();
    if length.value > 0.0 { l } else { l.max(Traced::from(0.0)) }
}

/// The rule that the checks follow; `None` for a joint without fillet welds.
pub(super) fn rule(e: &EndPlate) -> Option<Check> {
    let column = e.column.as_ref().map_or(0.0, |c| c.stiffener_throat.max(c.doubler_throat));
    let seam = at_plate::haunch(e).map_or(0.0, |h| h.seam_throat);
    let throats = [e.flange_throat, e.web_throat, e.rib_throat, column, seam];
    if throats.iter().all(|a| *a == 0.0) {
        return None;
    }
    let words = match e.welds.ends {
        WeldEnds::Returned => {
            "fillets are full-size round the tips of the flanges, where they lose a leg √2 a at \
             either end; every other run loses 2 a (welds.ends: returned; open and all_round say \
             otherwise)"
        }
        WeldEnds::Open => "every run of a fillet weld loses 2 a (welds.ends: open)",
        WeldEnds::AllRound => {
            "fillets are full-size round all tips and root fillets, so that no run loses anything \
             (welds.ends: all_round)"
        }
    };
    let (clause, id) = ("EN 1993-1-8:2005 4.5.1(1)", CheckId::WeldLengths);
    Some(Check::assumption(Topic::Welds, Part::Welds, clause, id, words))
}
