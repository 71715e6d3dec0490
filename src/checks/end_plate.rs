//! The hand checks of a bolted end plate, from the values of a resolved spec.
//!
//! Detailing is checked and can fail. Resistances, the component method, stiffness and ductility are information: what acts on
//! a single bolt or on the joint is not known from pressures on sections.

use super::check::{Check, Status, Step, Topic, Unit, Worked, number as n};
use super::component_method::joint::{Beam, Bolts, Column, Plate};
use super::component_method::rows::Component;
use super::component_method::stiffness::{Joins, for_elastic_analysis};
use super::component_method::{Assessment, EndPlateJoint, assess};
use super::ductility::{Clamped, plastic_distribution, rotation_capacity};
use super::eurocode::bearing::{Across, Along, Bearing, Hole};
use super::eurocode::bolt_length;
use super::eurocode::bolts::{ShearPlane, shear_resistance, tension_resistance};
use super::eurocode::punching::{mean_diameter, punching_resistance};
use super::eurocode::spacing::{Pattern, pattern_checks, washer_check, wrench_check};
use super::eurocode::welds::{WeldedSteel, full_strength_throat};
use crate::assembly::EndPlate;
use std::f64::consts::SQRT_2;

/// Washers of a bolt, one under the head and one under the nut.
const WASHERS: u32 = 2;

/// The checks of a connection, and what could not be checked.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct HandChecks {
    /// The checks, by topic.
    pub checks: Vec<Check>,
    /// Why a part of them is missing.
    pub notes: Vec<String>,
}

impl HandChecks {
    /// Whether a check failed.
    pub fn failed(&self) -> bool {
        self.checks.iter().any(|c| c.status == Status::Failed)
    }
}

/// All hand checks of an end plate.
pub fn hand_checks(e: &EndPlate) -> HandChecks {
    let mut out = HandChecks { checks: detailing(e), notes: Vec::new() };
    out.checks.extend(bolts(e));
    out.checks.extend(welds(e));
    let joint = joint(e);
    for (sense, joint) in [("tension at the top", joint.clone()), ("tension at the bottom", joint.mirrored())] {
        match assess(&joint) {
            Ok(a) => out.checks.extend(component_method(sense, sense.ends_with("bottom"), &a)),
            Err(fault) => out.notes.push(format!("component method, {sense}: {fault}")),
        }
    }
    out.checks.extend(ductility(e));
    out.checks.sort_by_key(|c| c.topic);
    out
}

/// Rows from the top.
fn from_top(e: &EndPlate) -> Vec<f64> {
    let mut rows = e.rows.clone();
    rows.sort_by(|a, b| b.total_cmp(a));
    rows
}

/// Smallest and largest pitch of the rows.
fn pitches(e: &EndPlate) -> Option<[f64; 2]> {
    let rows = from_top(e);
    let pitches = rows.windows(2).map(|w| w[0] - w[1]);
    pitches.fold(None, |range: Option<[f64; 2]>, p| Some(range.map_or([p, p], |[a, b]| [a.min(p), b.max(p)])))
}

/// Smallest distance of a row from an upper and a lower end.
fn end_distance(e: &EndPlate, bottom: f64, top: f64) -> f64 {
    e.rows.iter().map(|z| (top - z).min(z - bottom)).fold(f64::INFINITY, f64::min)
}

fn detailing(e: &EndPlate) -> Vec<Check> {
    let (b, d) = (&e.bolt, e.bolt.d);
    let (p1, p2) = (pitches(e), Some(e.gauge));
    let thinner = e.thickness.min(e.column.tf);
    let plate = Pattern {
        d0: e.hole,
        thickness: thinner,
        e1: Some(end_distance(e, e.bottom, e.top)),
        e2: Some(0.5 * (e.width - e.gauge)),
        p1,
        p2,
    };
    // pitch and gauge are those of the plate; the ends of the column are far
    let end = end_distance(e, -e.column_below, e.column_above);
    let flange = Pattern {
        e1: (end < 4.0 * thinner + 40.0).then_some(end),
        e2: Some(0.5 * (e.column.b - e.gauge)),
        p1: None,
        p2: None,
        ..plate
    };
    let mut out = pattern_checks("end plate", &plate);
    out.extend(pattern_checks("column flange", &flange));
    let leg = |throat: f64| SQRT_2 * throat;
    let (outer, inner) = (0.5 * e.beam.h, 0.5 * e.beam.h - e.beam.tf);
    for z in from_top(e) {
        let a = z.abs();
        let mut room = if a > outer { a - outer } else { inner - a } - leg(e.flange_throat);
        if e.stiffener > 0.0 {
            room = room.min((a - 0.5 * (outer + inner)).abs() - 0.5 * e.stiffener);
        }
        out.push(wrench_check(&format!("row at z = {} mm, flanges and stiffeners", n(z)), room, d));
    }
    for (subject, section, toe) in [("beam web", &e.beam, leg(e.web_throat)), ("column web", &e.column, 0.0)] {
        out.push(wrench_check(subject, 0.5 * (e.gauge - section.tw) - toe, d));
    }
    let to_web = 0.5 * (e.gauge - e.column.tw);
    out.push(washer_check("column flange", to_web, b.washer_outer, e.column.r));
    let grip = e.thickness + e.column.tf;
    let least = bolt_length::least_length(b, grip, WASHERS);
    let subject = format!("{} {}, {} washers", b.size, e.grade.grade, WASHERS);
    let stocked = bolt_length::stocked_length(least.value);
    let mut length = least.information(Topic::Detailing, subject.clone());
    if let Some(l) = stocked {
        let count = 2 * e.rows.len();
        length.formula += &format!("; order {} × {}, {count} for each end plate", b.size, n(l));
        length.values.push(Step { symbol: "l".into(), value: l, unit: Unit::Length });
    }
    out.push(length);
    out.extend(stocked.map(|l| bolt_length::shank_check(&subject, b, l, grip, WASHERS)));
    out
}

fn bolts(e: &EndPlate) -> Vec<Check> {
    let (b, g, gamma) = (&e.bolt, &e.grade, e.gamma_m2);
    let subject = format!("{} {}", b.size, g.grade);
    let tension = tension_resistance(b, g, false, gamma);
    let shear = shear_resistance(b, g, ShearPlane::Thread, 1.0, gamma);
    let mut out = Vec::new();
    out.push(tension.information(Topic::Bolts, subject.clone()));
    out.push(shear.information(Topic::Bolts, format!("{subject}, thread in the shear plane")));
    let end = end_distance(e, e.bottom, e.top);
    for (part, thickness, steel, width, e1) in [
        ("end plate", e.thickness, &e.plate_steel, e.width, Some(end)),
        ("column flange", e.column.tf, &e.column_steel, e.column.b, None),
    ] {
        let dm = mean_diameter(b);
        out.push(punching_resistance(dm, thickness, steel.fu, gamma).information(Topic::Bolts, part));
        let across = Across::Edge { e2: 0.5 * (width - e.gauge), p2: Some(e.gauge) };
        let place = |along| Bearing {
            along,
            across,
            hole: Hole::Normal,
            d: b.d,
            d0: e.hole,
            thickness,
            fu: steel.fu,
            fub: g.fub,
        };
        let at = |along, words: &str| {
            place(along).resistance(gamma).information(Topic::Bolts, format!("{part}, {words}, vertical force"))
        };
        out.extend(e1.map(|e1| at(Along::End { e1 }, "end bolt")));
        out.extend(pitches(e).map(|[p1, _]| at(Along::Inner { p1 }, "inner bolt")));
    }
    out
}

fn welds(e: &EndPlate) -> Vec<Check> {
    let (beam, plate) = (&e.beam_steel, &e.plate_steel);
    // the weaker of the parts joined; grades without β_w have no fillet welds by this code
    let weaker = if plate.fu < beam.fu { plate } else { beam };
    let Some(beta_w) = weaker.beta_w else { return Vec::new() };
    let steel = WeldedSteel { fu: weaker.fu, beta_w, gamma_m2: e.gamma_m2 };
    [("beam flange", e.beam.tf), ("beam web", e.beam.tw)]
        .into_iter()
        .map(|(part, t)| full_strength_throat(t, beam.fy, e.gamma_m0, &steel).information(Topic::Welds, part))
        .collect()
}

/// The joint of the component method.
fn joint(e: &EndPlate) -> EndPlateJoint {
    let grip = e.thickness + e.column.tf;
    let tension = tension_resistance(&e.bolt, &e.grade, false, e.gamma_m2).value;
    let punching = |t: f64, fu: f64| punching_resistance(mean_diameter(&e.bolt), t, fu, e.gamma_m2).value;
    let punched = punching(e.thickness, e.plate_steel.fu).min(punching(e.column.tf, e.column_steel.fu));
    EndPlateJoint {
        column: Column {
            section: (&e.column).into(),
            fy: e.column_steel.fy,
            above: e.column_above,
            below: e.column_below,
            stiffener: e.stiffener,
            stiffener_throat: 0.0,
            doublers: 0,
            doubler_width: 0.0,
            longitudinal: 0.0,
        },
        beam: Beam {
            section: (&e.beam).into(),
            fy: e.beam_steel.fy,
            flange_throat: e.flange_throat,
            web_throat: e.web_throat,
        },
        plate: Plate { thickness: e.thickness, width: e.width, bottom: e.bottom, top: e.top, fy: e.plate_steel.fy },
        bolts: Bolts {
            gauge: e.gauge,
            rows: e.rows.clone(),
            tension: tension.min(punched),
            stress_area: e.bolt.stress_area,
            elongation: bolt_length::elongation_length(&e.bolt, grip, WASHERS),
            washer: None,
            always_prying: false,
        },
        beta: e.beta,
        young: e.column_steel.e,
        gamma_m0: e.gamma_m0,
        gamma_m1: e.gamma_m1,
    }
}

/// The tables of one sense of bending.
fn component_method(sense: &str, mirrored: bool, a: &Assessment) -> Vec<Check> {
    let topic = Topic::ComponentMethod;
    let mut out = Vec::new();
    for (r, row) in a.rows.iter().enumerate() {
        let z = if mirrored { -row.z } else { row.z };
        let subject = format!("{sense}, row {} at z = {} mm", r + 1, n(z));
        // the component that limits the row shows its numbers
        let name = row.limited_by.split(',').next().unwrap_or_default();
        let of = |c: &&Component| c.name == name;
        let groups = row.groups.iter().map(|g| &g.component);
        let shown = if row.limited_by.contains("rows") { groups.rev().find(of) } else { row.alone.iter().find(of) };
        let formula = match shown {
            Some(c) if row.limited_by.contains("rows") => {
                format!("{} less the rows above", c.worked.formula)
            }
            Some(c) => c.worked.formula.clone(),
            None => "what is left of the sum".into(),
        };
        let mut force = Worked::new(
            "EN 1993-1-8:2005 6.2.7.2",
            "tension resistance of a row",
            row.force,
            Unit::Force,
            format!("F_tr,Rd, limited by {}: {formula}; F_tr,Rd", row.limited_by),
        )
        .with("h_r", row.lever, Unit::Length);
        for c in &row.alone {
            force = force.with(&format!("{} alone", c.name), c.worked.value, Unit::Force);
        }
        force = force.with("after groups", row.grouped, Unit::Force);
        // m, n, effective lengths and modes of the component that limits it
        force.steps.extend(shown.into_iter().flat_map(|c| c.worked.steps.iter().cloned()));
        out.push(force.information(topic, subject));
    }
    out.extend(a.limits.iter().map(|l| l.clone().information(topic, sense)));
    out.push(a.moment.clone().information(topic, sense));
    let (joint, beam) = (a.moment.value, a.beam_moment.value);
    let formula = format!("M_j,Rd/M_c,Rd = {}/{}", Unit::Moment.show(joint), Unit::Moment.show(beam));
    let share =
        Worked::new("EN 1993-1-8:2005 5.2.3", "strength against that of the beam", joint / beam, Unit::Number, formula);
    out.push(share.information(topic, sense));
    let initial = &a.stiffness.initial;
    out.push(initial.clone().information(Topic::Stiffness, sense));
    out.push(for_elastic_analysis(initial.value, Joins::BeamToColumn).information(Topic::Stiffness, sense));
    out
}

fn ductility(e: &EndPlate) -> Vec<Check> {
    let (d, fub) = (e.bolt.d, e.grade.fub);
    let parts = [
        ("end plate", Clamped { d, fub, thickness: e.thickness, fy: e.plate_steel.fy }),
        ("column flange", Clamped { d, fub, thickness: e.column.tf, fy: e.column_steel.fy }),
    ];
    parts.iter().flat_map(|(part, c)| [rotation_capacity(part, c), plastic_distribution(part, c)]).collect()
}

#[cfg(test)]
mod tests;
