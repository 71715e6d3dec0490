//! Detailing of an end plate: spacing and edge distances, room for tools and washers, length of the
//! bolts.

use super::at_plate;
use super::bolt_rows::{bolt, end_distance, from_top, pitches};
use super::clamped_plates::{WASHERS, other_thickness, stocked_length};
use crate::check::{Check, CheckId, Status, Step, Topic, Unit, number as n, within};
use crate::component_method::column_web::STIFFENER_SLENDERNESS;
use crate::eurocode::bolt_length;
use crate::eurocode::section::epsilon;
use crate::eurocode::spacing::{Pattern, pattern_checks, washer_check, wrench_check};
use crate::formula::Traced;
use crate::subject::{Part, Place, Subject};
use bracket_base::say;
use bracket_joint::assembly::{ColumnSide, EndPlate, Way};
use std::f64::consts::SQRT_2;

/// All checks of detailing.
pub(super) fn detailing(e: &EndPlate) -> Vec<Check> {
    let mut out = spacing(e);
    out.extend(room(e));
    out.extend(length_of_bolts(e));
    out
}

/// Spacing, end and edge distances of end plate and column flange.
fn spacing(e: &EndPlate) -> Vec<Check> {
    let columns = e.columns();
    let across = columns.windows(2).map(|w| w[1] - w[0]).fold(f64::INFINITY, f64::min);
    let (p1, p2) = (pitches(e), Some(across));
    let outermost = e.gauge.max(e.outer_gauge);
    let thinner = e.thickness.min(other_thickness(e));
    let plate = Pattern {
        d0: e.hole,
        thickness: thinner,
        e1: Some(end_distance(e, e.bottom, e.top)),
        e2: Some(0.5 * (e.width - outermost)),
        p1,
        p2,
    };
    let mut out = pattern_checks(Part::EndPlate, &plate);
    if let Some(c) = &e.column {
        // the pattern has the pitch and gauge of the plate
        let ends = e.rows.iter().filter_map(|z| c.ends().nearest(*z));
        let e1 = ends.reduce(f64::min).filter(|end| within(*end, 4.0 * thinner + 40.0));
        let flange =
            Pattern { e1, e2: Some(0.5 * (c.section.b - outermost)), p1: None, p2: None, ..plate };
        out.extend(pattern_checks(Part::ColumnFlange, &flange));
        out.extend(overhang(e, c));
    }
    out
}

/// Room for wrenches and washers, and the outstand of stiffeners.
fn room(e: &EndPlate) -> Vec<Check> {
    let (d, mut out) = (e.bolt.d, Vec::new());
    let stiffener = e.column.as_ref().map_or(0.0, |c| c.stiffener);
    let leg = |throat: f64| SQRT_2 * throat;
    let beam = at_plate::beam(e);
    for z in from_top(e) {
        let (a, outer) = (z.abs(), 0.5 * e.depth());
        let inner = outer - beam.along(if z < 0.0 { Way::Down } else { Way::Up });
        let mut room = if a > outer { a - outer } else { inner - a } - leg(e.flange_throat);
        // the flange between the two webs of a haunched beam
        if let Some([lower, upper]) = at_plate::inner_flange(e) {
            room = room.min((z - upper).max(lower - z) - leg(e.flange_throat));
        }
        if stiffener > 0.0 {
            room = room.min((a - 0.5 * (outer + inner)).abs() - 0.5 * stiffener);
        }
        let place = Subject::from(Place::Rows(vec![z])).and(Part::FlangesAndStiffeners);
        out.push(wrench_check(place, room, d));
    }
    let [_, web] = at_plate::webs(e);
    out.push(wrench_check(Part::BeamWeb, 0.5 * (e.gauge - web) - leg(e.web_throat), d));
    if let Some(c) = &e.column {
        let to_web = 0.5 * (e.gauge - c.section.tw);
        out.push(wrench_check(Part::ColumnWeb, to_web, d));
        out.push(washer_check(Part::ColumnFlange, to_web, e.bolt.washer_outer, c.section.r));
        if c.stiffener > 0.0 {
            out.push(stiffener_slenderness(c));
        }
    }
    out
}

/// Length of the bolts, and their free thread.
fn length_of_bolts(e: &EndPlate) -> Vec<Check> {
    let (b, grip, mut out) = (&e.bolt, e.grip, Vec::new());
    let least = bolt_length::least_length(b, grip, WASHERS);
    let stocked = stocked_length(e);
    let subject = Subject::from(bolt(e)).and(Place::Washers(WASHERS));
    let mut length = least.information(Topic::Detailing, subject.clone());
    if let Some(l) = stocked {
        let count = e.bolt_count();
        let words = match e.column {
            Some(_) => say!("order {} × {}, {} for each end plate", &b.size, n(l), count),
            None => say!("order {} × {}, {} for the splice", &b.size, n(l), count),
        };
        length.derivation.lines.push(words.into());
        length.values.push(Step { symbol: "l".into(), value: l, unit: Unit::Length });
    }
    out.push(length);
    out.extend(stocked.map(|l| bolt_length::shank_check(subject, b, l, grip, WASHERS)));
    out
}

/// An end plate wider than the column flange bears on the flange alone: allowed, but seldom
/// intended, so a warning. `None` where it is not wider.
///
/// # Source
/// EN 1993-1-8:2005 Figure 6.8(b): e_min is then the edge distance in the column's flange.
fn overhang(e: &EndPlate, c: &ColumnSide) -> Option<Check> {
    let what = ("EN 1993-1-8:2005 Figure 6.8", CheckId::PlateOverhang);
    let rule = Traced::length(say!("b_fc of {}", &c.section.name), c.section.b);
    let check = Check::at_most(
        (Topic::Detailing, Part::EndPlate),
        what,
        "b_p",
        rule,
        e.width,
        Status::Warning,
    );
    (check.status != Status::Ok).then_some(check)
}

/// Whether the stiffeners of the column can buckle about their weld: `c/t_s ≤ 13 ε`, which is
/// I_T/I_p ≥ 5.3 f_y/E for a flat bar. A warning here; undecided under a load that compresses them
/// (`Topic::Stability`).
///
/// # Source
/// EN 1993-1-5:2006 9.2.1(8).
fn stiffener_slenderness(c: &ColumnSide) -> Check {
    let outstand = 0.5 * (c.section.b - c.section.tw);
    let rule = Traced::from(STIFFENER_SLENDERNESS)
        * Traced::number("ε", epsilon(c.steel.fy.mpa()))
        * Traced::length("t_s", c.stiffener);
    let what = ("EN 1993-1-5:2006 9.2.1", CheckId::StiffenerOutstand);
    Check::at_most((Topic::Detailing, Part::Stiffener), what, "c", rule, outstand, Status::Warning)
}
