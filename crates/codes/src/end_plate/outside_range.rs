//! What lies outside the range of the rules: steels, thicknesses, bolt grades and holes for which
//! EN 1993-1-8 gives no resistance. Each is one undecided check with the clause and what would
//! supply a resistance, so that the verdict by code is never OK.
//!
//! Geometry that the tables of effective lengths do not cover is an error of the component method
//! (`component_method::rows`), which becomes an undecided check of each load case.

use super::at_plate;
use crate::check::{Check, CheckId, Topic, Unit, within};
use crate::eurocode::bolts::is_listed;
use crate::eurocode::holes::{CLEARANCES, Clearance};
use crate::eurocode::yielding::STRONGEST;
use crate::formula::{Derivation, Line, Relation, Traced};
use crate::subject::{Part, Place, Subject};
use bracket_base::say;
use bracket_base::words::Text;
use bracket_joint::assembly::EndPlate;
use bracket_joint::catalog::{BoltGrade, BoltSize};
use bracket_joint::strength::Strength;

/// Least thickness \[mm\], EN 1993-1-1:2005 1.1.2(1).
const THINNEST: f64 = 3.0;
/// Least thickness of a welded part \[mm\], EN 1993-1-8:2005 4.1(1).
const THINNEST_WELDED: f64 = 4.0;

/// A part of the joint with its steel.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Piece<'a> {
    /// The part.
    pub part: Part,
    /// Its thickness \[mm\].
    pub thickness: f64,
    /// Its steel.
    pub steel: &'a Strength,
    /// True if a weld holds it.
    pub welded: bool,
}

/// Everything about a joint that lies outside the range of the rules.
pub(super) fn outside_range(e: &EndPlate) -> Vec<Check> {
    beyond(&parts(e), &e.bolt, &e.grade, e.hole)
}

/// What of the parts, the bolts and their holes \[mm\] lies outside the range of the rules.
pub(crate) fn beyond(
    parts: &[Piece<'_>],
    bolt: &BoltSize,
    grade: &BoltGrade,
    hole: f64,
) -> Vec<Check> {
    let mut out = steels(parts);
    out.extend(thicknesses(parts));
    out.extend(bolt_grade(bolt, grade));
    out.extend(holes(bolt, hole));
    out
}

/// The parts of a joint.
fn parts(e: &EndPlate) -> Vec<Piece<'_>> {
    let piece = |part, thickness, steel, welded| Piece { part, thickness, steel, welded };
    let (b, steel) = (&e.beam, &e.beam_steel);
    let mut out = vec![
        piece(Part::EndPlate, e.thickness, &e.plate_steel, true),
        piece(Part::BeamFlange, b.tf, steel, true),
        piece(Part::BeamWeb, b.tw, steel, true),
        piece(Part::Rib, e.rib, steel, true),
    ];
    if let Some(h) = at_plate::haunch(e) {
        out.extend([
            piece(Part::HaunchFlange, h.flange, &h.steel, true),
            piece(Part::HaunchWeb, h.web, &h.steel, true),
            piece(Part::HaunchStiffener, h.stiffener, steel, true),
        ]);
    }
    if let Some(c) = &e.column {
        let (stiffened, doubled) = (c.stiffener > 0.0, c.doubler > 0.0);
        out.extend([
            piece(Part::ColumnFlange, c.section.tf, &c.steel, stiffened),
            piece(Part::ColumnWeb, c.section.tw, &c.steel, stiffened || doubled),
            piece(Part::Stiffener, c.stiffener, &c.steel, true),
            piece(Part::Doubler, c.doubler, &c.steel, true),
        ]);
    }
    out.retain(|p| p.thickness > 0.0);
    out
}

fn undecided(
    topic: Topic,
    subject: impl Into<Subject>,
    clause: impl Into<Text>,
    why: impl Into<Derivation>,
    step: &'static str,
) -> Check {
    Check::undecided(topic, subject, clause, CheckId::OutsideRange, why, step)
}

/// Steels above S460, each once.
fn steels(parts: &[Piece<'_>]) -> Vec<Check> {
    let mut strong: Vec<&Piece<'_>> = Vec::new();
    for p in parts {
        let known = strong.iter().any(|q| q.steel.grade == p.steel.grade);
        if !known && !within(p.steel.fy.mpa().max(named(&p.steel.grade)), STRONGEST) {
            strong.push(p);
        }
    }
    let check = |p: &Piece<'_>| {
        let why = say!(
            "{} of {} is a steel above S460: EN 1993-1-12 has further rules for it, which are not \
             in this edition",
            p.part.words(),
            &p.steel.grade
        );
        let step = "a steel up to S460, or a check of the joint by EN 1993-1-12";
        undecided(Topic::Detailing, p.part, "EN 1993-1-8:2005 1.1(1)", why, step)
    };
    strong.into_iter().map(check).collect()
}

/// Yield strength in the name of a grade, `S690Q` \[MPa\]; 0 of another name. A thick part has
/// less, but its steel stays outside.
fn named(grade: &str) -> f64 {
    let digits: String =
        grade.trim_start_matches('S').chars().take_while(char::is_ascii_digit).collect();
    digits.parse().ok().filter(|_| grade.starts_with('S')).unwrap_or(0.0)
}

/// Parts that are too thin for the rules of sections or of welds.
fn thicknesses(parts: &[Piece<'_>]) -> Vec<Check> {
    let check = |p: &Piece<'_>| {
        let below = |least: f64| {
            let (relation, limit) = (Relation::Below, Traced::from(least));
            let line = Line::comparison("t", p.thickness, relation, limit, Unit::Length);
            Derivation::from(line)
        };
        let (topic, clause, why) = if !within(THINNEST, p.thickness) {
            let why = below(THINNEST).then("thin-walled steel is the matter of EN 1993-1-3");
            (Topic::Detailing, "EN 1993-1-1:2005 1.1.2(1)", why)
        } else if p.welded && !within(THINNEST_WELDED, p.thickness) {
            let words = "welds of thinner material are the matter of EN 1993-1-3";
            (Topic::Welds, "EN 1993-1-8:2005 4.1(1)", below(THINNEST_WELDED).then(words))
        } else {
            return None;
        };
        let step = "a thicker part, or a check by EN 1993-1-3";
        Some(undecided(topic, p.part, clause, why, step))
    };
    parts.iter().filter_map(check).collect()
}

/// A bolt grade stronger or weaker than those of Table 3.1.
fn bolt_grade(bolt: &BoltSize, g: &BoltGrade) -> Option<Check> {
    (!is_listed(g)).then(|| {
        let why = say!(
            "f_yb = {} and f_ub = {} of {} lie outside the grades 4.6 to 10.9: Table 3.1 does not \
             list them, and Table 3.4 has no α_v",
            Unit::Stress.show(g.fyb),
            Unit::Stress.show(g.fub),
            &g.grade
        );
        let clause = "EN 1993-1-8:2005 3.1.1(3), Table 3.1";
        let subject = Place::Bolt { size: bolt.size.clone(), grade: g.grade.clone() };
        undecided(Topic::Bolts, subject, clause, why, "a grade of Table 3.1")
    })
}

/// Holes wider than oversize: no factor of bearing and no k_s.
fn holes(bolt: &BoltSize, hole: f64) -> Option<Check> {
    (Clearance::of(bolt, hole) == Clearance::Beyond).then(|| {
        let why = say!(
            "d0 = {} is wider than an oversize hole of {} = {}: no bearing resistance \
             (Table 3.4) and no k_s (Table 3.6)",
            Unit::Length.show(hole),
            &bolt.size,
            Unit::Length.show(bolt.hole_oversize)
        );
        let clause = say!("{}, {}", CLEARANCES, "EN 1993-1-8:2005 3.6.1(4)");
        let step = "a hole of at most that size (`parameters.hole_clearance`)";
        undecided(Topic::Detailing, Part::Holes, clause, why, step)
    })
}
