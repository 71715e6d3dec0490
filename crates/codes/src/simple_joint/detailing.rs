//! Detailing of a simple joint: spacing and edge distances, room for tools and washers, bolts.

use super::plies::{Ply, pitches, plies};
use crate::check::{Check, Step, Topic, Unit, number as n};
use crate::eurocode::bolt_length;
use crate::eurocode::spacing::{Pattern, pattern_checks, washer_check, wrench_check};
use crate::subject::{Part, Place, Subject};
use bracket_base::say;
use bracket_joint::assembly::{SimpleJoint, SimpleKind, SupportElement};
use std::f64::consts::SQRT_2;

/// Washers of a bolt: one under the head and one under the nut.
const WASHERS: u32 = 2;

/// All checks of detailing.
pub(super) fn detailing(e: &SimpleJoint) -> Vec<Check> {
    let mut out = spacing(e);
    out.extend(room(e));
    out.extend(length_of_bolts(e));
    out
}

/// Spacing, end and edge distances of the plate and of the ply behind it.
fn spacing(e: &SimpleJoint) -> Vec<Check> {
    let [plate, other] = plies(e);
    let thickness = plate.thickness.min(other.thickness);
    let there = |x: f64| Some(x).filter(|x| x.is_finite());
    let pattern = |p: &Ply<'_>| Pattern {
        d0: e.hole,
        thickness,
        e1: there(p.e1),
        e2: there(p.e2),
        p1: pitches(&e.rows),
        p2: pitches(&e.columns).map(|p| p[0]),
    };
    let mut out = pattern_checks(plate.part, &pattern(&plate));
    // the pattern has the pitches of the plate
    let ends = Pattern { p1: None, p2: None, ..pattern(&other) };
    // the flange of the beam closes the web of an unnotched beam: no exposed end
    let far = ends.e1.filter(|e1| *e1 <= 4.0 * thickness + 40.0);
    out.extend(pattern_checks(other.part, &Pattern { e1: far, ..ends }));
    out
}

/// Room for wrenches and washers.
fn room(e: &SimpleJoint) -> Vec<Check> {
    let (d, leg) = (e.bolt.d, SQRT_2 * e.throat);
    let nearest = e.columns.iter().fold(f64::INFINITY, |least, y| least.min(y.abs()));
    let section = &e.support.section;
    match e.kind {
        SimpleKind::FinPlate => {
            let place = Subject::from(Part::FinPlate).and(Place::EndBolt);
            vec![wrench_check(place, nearest - leg, d)]
        }
        SimpleKind::HeaderPlate => {
            let to_web = nearest - 0.5 * e.beam.tw - leg;
            let mut out = vec![wrench_check(Part::BeamWeb, to_web, d)];
            if e.support.element == SupportElement::ColumnFlange {
                let to_web = nearest - 0.5 * section.tw;
                out.push(wrench_check(Part::ColumnWeb, to_web, d));
                let washer = e.bolt.washer_outer;
                out.push(washer_check(Part::ColumnFlange, to_web, washer, section.r));
            }
            out
        }
    }
}

/// Length of the bolts, and their free thread.
fn length_of_bolts(e: &SimpleJoint) -> Vec<Check> {
    let (b, grip) = (&e.bolt, e.grip);
    let least = bolt_length::least_length(b, grip, WASHERS);
    let stocked = bolt_length::stocked_length(least.value);
    let subject = Subject::from(Place::bolt(b, &e.grade)).and(Place::Washers(WASHERS));
    let mut length = least.information(Topic::Detailing, subject.clone());
    if let Some(l) = stocked {
        let count = e.rows.len() * e.columns.len();
        let words = say!("order {} × {}, {} for the joint", &b.size, n(l), count);
        length.derivation.lines.push(words.into());
        length.values.push(Step { symbol: "l".into(), value: l, unit: Unit::Length });
    }
    let mut out = vec![length];
    out.extend(stocked.map(|l| bolt_length::shank_check(subject, b, l, grip, WASHERS)));
    out
}
