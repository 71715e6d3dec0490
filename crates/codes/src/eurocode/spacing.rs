//! Spacing, end and edge distances: EN 1993-1-8:2005 Table 3.3; room for tools and washers.

use crate::check::{Check, CheckId, Status, Topic};
use crate::formula::{Number, Traced};
use crate::subject::{Part, Subject};

const TABLE: &str = "EN 1993-1-8:2005 Table 3.3";
/// In place of a clause: the room that a socket wrench needs.
const PRACTICE: &str = "practice";

/// Distances of one rectangular pattern of bolts in one plate \[mm\]; `None` where a distance does
/// not exist.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pattern {
    /// Hole diameter.
    pub d0: f64,
    /// Thickness of the thinner outer plate.
    pub thickness: f64,
    /// Smallest end distance.
    pub e1: Option<f64>,
    /// Smallest edge distance.
    pub e2: Option<f64>,
    /// Smallest and largest pitch of the rows.
    pub p1: Option<[f64; 2]>,
    /// Distance between the columns.
    pub p2: Option<f64>,
}

/// Checks of a pattern; `subject` names the plate.
///
/// The least values are binding: e1, e2 ≥ 1.2 d0, p1 ≥ 2.2 d0, p2 ≥ 2.4 d0. The greatest values (e
/// ≤ 4 t + 40 mm; p1, p2 ≤ min(14 t, 200 mm)) apply to exposed and to compressed plates only (note
/// 1 of the table): exceeding one is a warning.
///
/// # Source
/// EN 1993-1-8:2005 Table 3.3.
pub fn pattern_checks(part: Part, p: &Pattern) -> Vec<Check> {
    let what = (Topic::Detailing, part);
    let least = |id, symbol: &'static str, factor: f64, provided: f64| {
        let rule = Traced::from(factor) * Traced::length("d0", p.d0);
        Check::at_least(what, (TABLE, id), symbol, rule, provided, Status::Failed)
    };
    let most = |id, symbol: &'static str, allowed: &Traced, provided: f64| {
        let allowed = allowed.clone();
        Check::at_most(what, (TABLE, id), symbol, allowed, provided, Status::Warning)
    };
    let (t, n) = (|| Traced::length("t", p.thickness), Traced::from);
    let edge = &(n(4.0) * t() + n(40.0));
    let pitch = &(n(14.0) * t()).min(n(200.0));
    let mut out = Vec::new();
    for (e, symbol, id, exposed) in [
        (p.e1, "e1", CheckId::EndDistance, CheckId::EndDistanceExposed),
        (p.e2, "e2", CheckId::EdgeDistance, CheckId::EdgeDistanceExposed),
    ] {
        if let Some(e) = e {
            out.push(least(id, symbol, 1.2, e));
            out.push(most(exposed, symbol, edge, e));
        }
    }
    if let Some([smallest, largest]) = p.p1 {
        out.push(least(CheckId::PitchOfRows, "p1", 2.2, smallest));
        out.push(most(CheckId::PitchOfRowsExposed, "p1", pitch, largest));
    }
    if let Some(p2) = p.p2 {
        out.push(least(CheckId::GaugeOfColumns, "p2", 2.4, p2));
        out.push(most(CheckId::GaugeOfColumnsExposed, "p2", pitch, p2));
    }
    out
}

/// Room for a socket wrench between the axis of a bolt and a web, a flange or the toe of its weld
/// \[mm\].
///
/// About `2 d + 5 mm`. No clause of the code: a shorter distance is a warning.
pub fn wrench_check(subject: impl Into<Subject>, distance: f64, d: f64) -> Check {
    let what = (Topic::Detailing, subject);
    let rule = Traced::from(2.0) * Traced::length("d", d) + Traced::from(5.0);
    Check::at_least(
        what,
        (PRACTICE, CheckId::SpannerClearance),
        "c",
        rule,
        distance,
        Status::Warning,
    )
}

/// Whether a washer of outer diameter `washer` bears on a plane surface: the distance of the bolt
/// axis from the face of the web must be at least the root radius and half of the washer \[mm\].
///
/// Washers and nuts must bear on plane surfaces (EN 1090-2 8.2). Plain bolts in normal holes need
/// no washers (8.2.4), so a shorter distance is a warning.
pub fn washer_check(part: Part, distance: f64, washer: f64, root: f64) -> Check {
    let what = (Topic::Detailing, part);
    let rule = Traced::length("r", root) + Traced::length("d_w", washer) / Traced::from(2.0);
    let clear = ("EN 1090-2 8.2", CheckId::WasherClearOfRoot);
    Check::at_least(what, clear, "c", rule, distance, Status::Warning)
}
