//! Detailing of a splice: spacing and edge distances of all plates, room for tools, washers and
//! covers, length of the bolts.

use super::bolt_checks::bolt;
use super::distances::{ends, from_ends, pitches};
use super::side::{Side, sides};
use crate::check::{Check, CheckId, Status, Step, Topic, Unit, number as n};
use crate::eurocode::bolt_length;
use crate::eurocode::spacing::{Pattern, pattern_checks, washer_check, wrench_check};
use crate::formula::{Number, Traced};
use crate::subject::{Part, Place, Subject};
use bracket_base::say;
use bracket_joint::assembly::CoverSplice;

/// Washers of a bolt: one under the head and one under the nut.
const WASHERS: u32 = 2;

/// All checks of detailing.
pub(super) fn detailing(e: &CoverSplice) -> Vec<Check> {
    let mut out = of_covers(e);
    for side in sides(e) {
        out.extend(of_member(e, &side));
    }
    out.extend(bolts(e, Part::FlangeBolts, e.flange_grip, 4 * e.flange_bolts()));
    out.extend(bolts(e, Part::WebBolts, e.web_grip, 2 * e.web_bolts()));
    out
}

/// Pitches of the rows of a cover, the one across the gap included.
fn across_gap(rows: &[f64]) -> Option<[f64; 2]> {
    let gap = 2.0 * rows.first()?;
    let [least, most] = pitches(rows).unwrap_or([gap, gap]);
    Some([least.min(gap), most.max(gap)])
}

/// Smallest pitch.
fn least(places: &[f64]) -> Option<f64> {
    pitches(places).map(|[least, _]| least)
}

/// Spacing, end and edge distances of the covers.
fn of_covers(e: &CoverSplice) -> Vec<Check> {
    let columns = e.flange_columns();
    let outermost = e.gauges.last().copied().unwrap_or(0.0);
    let [_, last] = ends(&e.flange_rows);
    let flange = Pattern {
        d0: e.hole,
        thickness: e.outer.thickness,
        e1: Some(0.5 * e.outer.length - last),
        e2: Some(0.5 * (e.outer.width - outermost)),
        p1: across_gap(&e.flange_rows),
        p2: least(&columns),
    };
    let mut out = pattern_checks(Part::OuterCover, &flange);
    if let Some(inner) = &e.inner {
        let strip: Vec<f64> = columns.iter().copied().filter(|y| *y > 0.0).collect();
        let e2 = from_ends(&strip, inner.from, inner.from + inner.plate.width);
        let pattern = Pattern {
            thickness: inner.plate.thickness,
            e1: Some(0.5 * inner.plate.length - last),
            e2: Some(e2),
            p2: least(&strip),
            ..flange
        };
        out.extend(pattern_checks(Part::InnerCovers, &pattern));
    }
    let [_, last] = ends(&e.web_columns);
    let half = 0.5 * e.web.width;
    let pattern = Pattern {
        d0: e.hole,
        thickness: e.web.thickness,
        e1: Some(from_ends(&e.web_rows, e.web_middle - half, e.web_middle + half)),
        e2: Some(0.5 * e.web.length - last),
        p1: pitches(&e.web_rows),
        p2: across_gap(&e.web_columns).map(|[least, _]| least),
    };
    out.extend(pattern_checks(Part::WebCovers, &pattern));
    out
}

/// Distances in the flanges and the web of a member, and room beside its root fillets.
fn of_member(e: &CoverSplice, side: &Side<'_>) -> Vec<Check> {
    let (s, d) = (&side.section, e.bolt.d);
    let [innermost, outermost] = ends(&e.gauges);
    let first = ends(&e.flange_rows)[0];
    let to_end = |first: f64| Some(first - 0.5 * e.gap);
    let flange = Pattern {
        d0: e.hole,
        thickness: s.tf,
        e1: to_end(first),
        e2: Some(0.5 * (s.b - outermost)),
        p1: pitches(&e.flange_rows),
        p2: least(&e.flange_columns()),
    };
    let web = Pattern {
        thickness: s.tw,
        e1: None,
        e2: to_end(ends(&e.web_columns)[0]),
        p1: pitches(&e.web_rows),
        p2: least(&e.web_columns),
        ..flange
    };
    let named = |part| side.of(Subject::default(), part);
    let mut out = pattern_checks(Part::SplicedFlange, &flange);
    for check in &mut out {
        check.subject = named(Part::SplicedFlange);
    }
    let mut in_web = pattern_checks(Part::SplicedWeb, &web);
    for check in &mut in_web {
        check.subject = named(Part::SplicedWeb);
    }
    out.extend(in_web);
    // the web covers with their packs reach out from the web
    let beside_web = 0.5 * (innermost - s.tw) - e.web.thickness - side.member.web_packs;
    out.push(wrench_check(named(Part::FlangeBolts), beside_web, d));
    if e.inner.is_none() {
        let to_web = 0.5 * (innermost - s.tw);
        let mut washer = washer_check(Part::FlangeBolts, to_web, e.bolt.washer_outer, s.root);
        washer.subject = named(Part::FlangeBolts);
        out.push(washer);
    }
    let inner = e.inner.as_ref().map_or(0.0, |i| i.plate.thickness + side.member.inner_packs);
    let reach = 0.5 * s.h - s.tf - inner;
    let axis = side.member.axis;
    let to_flange = from_ends(&e.web_rows, axis - reach, axis + reach);
    out.push(wrench_check(named(Part::WebBolts), to_flange, d));
    out.extend(clear_of_root(e, side, reach));
    out
}

/// Covers that reach into the root fillets do not lie flat: a warning.
fn clear_of_root(e: &CoverSplice, side: &Side<'_>, reach: f64) -> Vec<Check> {
    let (s, axis, half) = (&side.section, side.member.axis, 0.5 * e.web.width);
    let what = ("EN 1090-2 8.2", CheckId::CoverClearOfRoot);
    let check = |part, limit: Traced, symbol: &'static str, provided: f64| {
        let of = (Topic::Detailing, side.of(Subject::default(), part));
        Check::at_least(of, what, symbol, limit, provided, Status::Warning)
    };
    let root = || Traced::length("r", s.root);
    let edges = [e.web_middle - half, e.web_middle + half];
    let clear = (edges[0] - (axis - reach)).min(axis + reach - edges[1]);
    // inside covers the fillet ends below their thickness, or further out
    let covered = 0.5 * s.h - s.tf - reach;
    let limit = match covered > 0.0 {
        true => (root() - Traced::length("t", covered)).max(Traced::from(0.0)),
        false => root(),
    };
    let mut out = vec![check(Part::WebCovers, limit, "c", clear)];
    out.extend(
        e.inner
            .as_ref()
            .map(|inner| check(Part::InnerCovers, root(), "c", inner.from - 0.5 * s.tw)),
    );
    out
}

/// Length of the bolts of a group, and their free thread.
fn bolts(e: &CoverSplice, part: Part, grip: f64, count: usize) -> Vec<Check> {
    let least = bolt_length::least_length(&e.bolt, grip, WASHERS);
    let stocked = bolt_length::stocked_length(least.value);
    let subject = Subject::from(part).and(bolt(e)).and(Place::Washers(WASHERS));
    let mut length = least.information(Topic::Detailing, subject.clone());
    if let Some(l) = stocked {
        let words = say!("order {} × {}, {} for the splice", &e.bolt.size, n(l), count);
        length.derivation.lines.push(words.into());
        length.values.push(Step { symbol: "l".into(), value: l, unit: Unit::Length });
    }
    let mut out = vec![length];
    out.extend(stocked.map(|l| bolt_length::shank_check(subject, &e.bolt, l, grip, WASHERS)));
    out
}
