//! The hand checks of a bolted end plate, from the values of a resolved spec.
//!
//! Detailing is checked and can fail. With actions at member ends, what they ask of bolts, plates
//! and welds is checked as well (`loaded.rs`) and the component method is held against the analysis
//! (`comparison.rs`). Without them resistances, the component method and stiffness are information:
//! what acts on a bolt is not known from pressures on sections.

use super::check::{Check, Status, Step, Topic, Unit, Worked, number as n};
use super::component_method::column_web::{STIFFENER_SLENDERNESS, epsilon};
use super::component_method::equilibrium::SMALL_AXIAL;
use super::component_method::joint::{Beam, Bolts, Column, Plate, Section};
use super::component_method::rows::Component;
use super::component_method::stiffness::{Joins, for_elastic_analysis};
use super::component_method::{Assessment, EndPlateJoint, assess};
use super::ductility::{Clamped, panel_in_shear, plastic_distribution, rotation_capacity};
use super::eurocode::bearing::{Across, Along, Bearing};
use super::eurocode::bolt_length;
use super::eurocode::bolts::{ShearPlane, shear_resistance, tension_resistance};
use super::eurocode::punching::{mean_diameter, punching_resistance};
use super::eurocode::spacing::{Pattern, pattern_checks, washer_check, wrench_check};
use super::eurocode::welds::{WeldedSteel, full_strength_throat};
use crate::assembly::{ColumnSide, EndPlate};
use std::f64::consts::SQRT_2;

mod assumptions;
mod beam_checks;
mod case;
mod class_checks;
mod comparison;
mod diagram;
mod loaded;
mod rotation;
mod slip_checks;
mod stiffener_checks;
mod tying;
mod weld_checks;

pub use comparison::Comparison;
pub use diagram::{MomentAxial, moment_axial};
pub use rotation::{FrameClass, JointStiffness, PureMoment};

/// Washers of a bolt, one under the head and one under the nut.
const WASHERS: u32 = 2;

/// The checks of a connection, and what could not be checked.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct HandChecks {
    /// The checks, by topic.
    pub checks: Vec<Check>,
    /// Why a part of them is missing.
    pub notes: Vec<String>,
    /// What the component method says of each load case with actions at a member end.
    pub comparisons: Vec<Comparison>,
    /// The load cases that are one moment, whose rotation gives the stiffness of the joint.
    pub moments: Vec<PureMoment>,
    /// Why the verdict of a limit analysis may not be OK: no rule of rotation capacity holds.
    pub brittle: Option<String>,
    /// Load cases in which a component may buckle: the component method binds there, whatever a
    /// limit analysis says.
    pub unstable: Vec<String>,
    /// Load cases at serviceability: of them only slip is checked.
    pub serviceability: Vec<String>,
}

impl HandChecks {
    /// Whether a check failed.
    pub fn failed(&self) -> bool {
        self.checks.iter().any(|c| c.status == Status::Failed)
    }
}

/// All hand checks of an end plate.
pub fn hand_checks(e: &EndPlate) -> HandChecks {
    let mut out = HandChecks { checks: detailing(e), ..HandChecks::default() };
    out.checks.extend(bolts(e));
    out.checks.extend(welds(e));
    out.checks.extend(stiffener_checks::rib_weld(e));
    out.checks.extend(slip_checks::assembly(e));
    out.checks.extend(tying::tying(e));
    out.checks.extend(assumptions::assumptions(e));
    out.checks.extend(assumptions::no_weld_strength(e));
    let unseen = |(case, why): &(String, String)| {
        let (clause, title) = ("EN 1993-1-8:2005 6.2", "loads that the checks do not hold");
        Check::undecided(Topic::ComponentMethod, "joint", clause, title, why.clone()).of_case(case)
    };
    out.checks.extend(e.unseen.iter().map(unseen));
    // of every sense: the parts whose bending limits a row, and whether a web panel that governs
    // may turn
    let mut turning: Vec<(Sense, Vec<&str>, bool)> = Vec::new();
    out.notes.extend(left_out(e));
    for (sense, beta) in senses(e) {
        match assess(&sense.of(&joint(e, beta))) {
            Ok(a) => {
                let several = senses(e).iter().filter(|s| s.0 == sense).count() > 1;
                let subject = if several {
                    format!("{}, β = {}", sense.words(), n(beta))
                } else {
                    sense.words().into()
                };
                out.checks.extend(component_method(
                    &subject,
                    sense == Sense::Bottom,
                    e.column.is_some(),
                    &a,
                ));
                out.checks.extend(weld_checks::not_the_weakest(e, &subject, sense, &a));
                let bending = a.rows.iter().filter_map(|r| r.bending_of()).collect();
                let mut panel = false;
                if let Some(c) = e.column.as_ref().filter(|_| a.shear_governs()) {
                    let section = &c.section;
                    let clear = Section::from(section).clear_depth();
                    let rule = panel_in_shear(
                        &format!("column web panel, {subject}"),
                        clear,
                        section.tw,
                        c.steel.fy,
                    );
                    panel = rule.status == Status::Ok;
                    out.checks.push(rule);
                }
                turning.push((sense, bending, panel));
            }
            Err(fault) => out.notes.push(format!("component method, {}: {fault}", sense.words())),
        }
    }
    let bending: Vec<&str> = turning.iter().flat_map(|t| t.1.iter().copied()).collect();
    let rules = ductility(e, &bending);
    // a rule counts for the sense it holds in; senses without load ask for none
    let ductile = |sense: Sense| {
        let of = |bending: &[&str]| ductility(e, bending).iter().any(|c| c.status == Status::Ok);
        let each: Vec<_> = turning.iter().filter(|t| t.0 == sense).collect();
        if each.is_empty() { of(&[]) } else { each.iter().all(|t| t.2 || of(&t.1)) }
    };
    let mut loaded: Vec<Sense> =
        e.actions.iter().map(|a| Sense::of_moment(a.at(1.0)[1][1])).collect();
    if loaded.is_empty() {
        loaded = vec![Sense::Top, Sense::Bottom];
    }
    if !loaded.into_iter().all(ductile) {
        out.brittle = Some(brittle(&rules));
    }
    out.checks.extend(rules);
    let service = e.actions.iter().filter(|a| !a.state.is_ultimate());
    out.serviceability.extend(service.map(|a| a.case.clone()));
    loaded::checks(e, &mut out);
    out.checks.sort_by_key(|c| c.topic);
    out
}

/// Which way a moment bends the joint.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Sense {
    /// Tension at the top.
    Top,
    /// Tension at the bottom.
    Bottom,
}

impl Sense {
    fn words(self) -> &'static str {
        match self {
            Sense::Top => "tension at the top",
            Sense::Bottom => "tension at the bottom",
        }
    }

    /// The joint with its tension at the top.
    fn of(self, joint: &EndPlateJoint) -> EndPlateJoint {
        match self {
            Sense::Top => joint.clone(),
            Sense::Bottom => joint.mirrored(),
        }
    }

    /// That of a moment My of a member end.
    fn of_moment(my: f64) -> Self {
        if my < 0.0 { Sense::Bottom } else { Sense::Top }
    }
}

/// Senses of bending and β to show: those of the load cases, and the template's β for a sense no
/// case has.
fn senses(e: &EndPlate) -> Vec<(Sense, f64)> {
    let mut out: Vec<(Sense, f64)> = Vec::new();
    for a in &e.actions {
        let entry = (Sense::of_moment(a.at(1.0)[1][1]), loaded::beta(e, a));
        if !out.contains(&entry) {
            out.push(entry);
        }
    }
    for sense in [Sense::Top, Sense::Bottom] {
        if out.iter().all(|o| o.0 != sense) {
            out.push((sense, e.column.as_ref().map_or(0.0, |c| c.beta)));
        }
    }
    out.sort_by(|a, b| {
        (a.0 == Sense::Bottom).cmp(&(b.0 == Sense::Bottom)).then(a.1.total_cmp(&b.1))
    });
    out
}

/// What the component method leaves out, on the safe side.
fn left_out(e: &EndPlate) -> Vec<String> {
    let mut out = Vec::new();
    if e.rib > 0.0 {
        out.push(
            "component method: the rib is left out, on the safe side (EN 1993-1-8 has no formula \
             for it)"
                .into(),
        );
    }
    if let Some(c) = e.column.as_ref().filter(|c| c.doubler > 0.0) {
        out.extend(
            doubler_fault(c)
                .map(|why| format!("component method: the web doubler is left out: {why}")),
        );
    }
    out
}

/// Why a supplementary web plate does not count.
///
/// # Source
/// EN 1993-1-8:2005 6.2.6.1, supplementary web plates (from paragraph 6 on): b_s ≤ 40 ε t_s, t_s ≥
/// t_wc.
fn doubler_fault(c: &ColumnSide) -> Option<String> {
    let (s, width) = (&c.section, doubler_width(c));
    let widest = 40.0 * epsilon(c.steel.fy) * c.doubler;
    if c.doubler < s.tw {
        return Some(format!(
            "t_s = {} mm is less than t_wc = {} mm (6.2.6.1)",
            n(c.doubler),
            n(s.tw)
        ));
    }
    let words =
        || format!("b_s = {} mm is more than 40 ε t_s = {} mm (6.2.6.1)", n(width), n(widest));
    (width > widest).then(words)
}

/// b_s: the plate is as wide as the web is flat.
fn doubler_width(c: &ColumnSide) -> f64 {
    Section::from(&c.section).clear_depth()
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
    pitches.fold(None, |range: Option<[f64; 2]>, p| {
        Some(range.map_or([p, p], |[a, b]| [a.min(p), b.max(p)]))
    })
}

/// Smallest distance of a row from an upper and a lower end.
fn end_distance(e: &EndPlate, bottom: f64, top: f64) -> f64 {
    e.rows.iter().map(|z| (top - z).min(z - bottom)).fold(f64::INFINITY, f64::min)
}

fn detailing(e: &EndPlate) -> Vec<Check> {
    let (b, d) = (&e.bolt, e.bolt.d);
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
    let mut out = pattern_checks("end plate", &plate);
    if let Some(c) = &e.column {
        // pitch and gauge are those of the plate; the ends of the column are far
        let free = |end: Option<f64>| end.unwrap_or(f64::INFINITY);
        let end = end_distance(e, -free(c.below), free(c.above));
        let e1 = (end < 4.0 * thinner + 40.0).then_some(end);
        let flange =
            Pattern { e1, e2: Some(0.5 * (c.section.b - outermost)), p1: None, p2: None, ..plate };
        out.extend(pattern_checks("column flange", &flange));
        out.extend(overhang(e, c));
    }
    let stiffener = e.column.as_ref().map_or(0.0, |c| c.stiffener);
    let leg = |throat: f64| SQRT_2 * throat;
    let (outer, inner) = (0.5 * e.beam.h, 0.5 * e.beam.h - e.beam.tf);
    for z in from_top(e) {
        let a = z.abs();
        let mut room = if a > outer { a - outer } else { inner - a } - leg(e.flange_throat);
        if stiffener > 0.0 {
            room = room.min((a - 0.5 * (outer + inner)).abs() - 0.5 * stiffener);
        }
        out.push(wrench_check(&format!("row at z = {} mm, flanges and stiffeners", n(z)), room, d));
    }
    out.push(wrench_check("beam web", 0.5 * (e.gauge - e.beam.tw) - leg(e.web_throat), d));
    if let Some(c) = &e.column {
        let to_web = 0.5 * (e.gauge - c.section.tw);
        out.push(wrench_check("column web", to_web, d));
        out.push(washer_check("column flange", to_web, b.washer_outer, c.section.r));
        if c.stiffener > 0.0 {
            out.push(stiffener_slenderness(c));
        }
    }
    let grip = grip(e);
    let least = bolt_length::least_length(b, grip, WASHERS);
    let stocked = stocked_length(e);
    let subject = format!("{} {}, {} washers", b.size, e.grade.grade, WASHERS);
    let mut length = least.information(Topic::Detailing, subject.clone());
    if let Some(l) = stocked {
        let count = e.bolt_count();
        let each = if e.column.is_some() { "each end plate" } else { "the splice" };
        length.formula += &format!("; order {} × {}, {count} for {each}", b.size, n(l));
        length.values.push(Step { symbol: "l".into(), value: l, unit: Unit::Length });
    }
    out.push(length);
    out.extend(stocked.map(|l| bolt_length::shank_check(&subject, b, l, grip, WASHERS)));
    out
}

/// A plate wider than the column's flange, which bears on the flange alone: allowed, but seldom
/// meant. Nothing where it fits.
///
/// # Source
/// EN 1993-1-8:2005 Figure 6.8(b): e_min is then the edge distance in the column's flange.
fn overhang(e: &EndPlate, c: &ColumnSide) -> Option<Check> {
    let what = (
        "EN 1993-1-8:2005 Figure 6.8",
        "end plate no wider than the column flange, where it bears",
    );
    let rule = (c.section.b, format!("b_fc of {}", c.section.name));
    let check = Check::at_most(
        (Topic::Detailing, "end plate"),
        what,
        "b_p",
        rule,
        e.width,
        Status::Warning,
    );
    (check.status != Status::Ok).then_some(check)
}

/// Thickness of what the end plate is bolted to.
fn other_thickness(e: &EndPlate) -> f64 {
    e.column.as_ref().map_or(e.thickness, |c| c.section.tf)
}

/// Thickness of what the bolts clamp.
pub fn grip(e: &EndPlate) -> f64 {
    e.thickness + other_thickness(e)
}

/// Nominal length of the bolts: the shortest stocked one that reaches through; `None` beyond the
/// longest.
pub fn stocked_length(e: &EndPlate) -> Option<f64> {
    bolt_length::stocked_length(bolt_length::least_length(&e.bolt, grip(e), WASHERS).value)
}

/// Whether the stiffeners of the column can buckle about their weld: `c/t_s ≤ 13 ε` is 9.2.1(8),
/// I_T/I_p ≥ 5.3 f_y/E, of a flat bar; a warning here, and undecided under a load that presses them
/// (`Stability`).
///
/// # Source
/// EN 1993-1-5:2006 9.2.1(8).
fn stiffener_slenderness(c: &ColumnSide) -> Check {
    let limit = STIFFENER_SLENDERNESS * epsilon(c.steel.fy);
    let outstand = 0.5 * (c.section.b - c.section.tw);
    let rule = (limit * c.stiffener, format!("13 ε t_s = {} · {}", n(limit), n(c.stiffener)));
    let title = ("EN 1993-1-5:2006 9.2.1", "outstand of the stiffener");
    Check::at_most(
        (Topic::Detailing, "column stiffener"),
        title,
        "c",
        rule,
        outstand,
        Status::Warning,
    )
}

/// The parts that lie on the bolts: name, thickness, steel's ultimate strength, width.
fn bearing_parts(e: &EndPlate) -> Vec<(&'static str, f64, f64, f64)> {
    let plate = ("end plate", e.thickness, e.plate_steel.fu, e.width);
    let flange =
        e.column.as_ref().map(|c| ("column flange", c.section.tf, c.steel.fu, c.section.b));
    [plate].into_iter().chain(flange).collect()
}

/// Bearing of a part on one bolt under a vertical force.
fn bearing(e: &EndPlate, along: Along, (thickness, fu, width): (f64, f64, f64)) -> Worked {
    let across = Across::Edge { e2: 0.5 * (width - e.gauge), p2: Some(e.gauge) };
    let place = Bearing {
        along,
        across,
        hole: slip_checks::hole(e).0,
        d: e.bolt.d,
        d0: e.hole,
        thickness,
        fu,
        fub: e.grade.fub,
    };
    place.resistance(e.factors.gamma_m2)
}

fn bolts(e: &EndPlate) -> Vec<Check> {
    let (b, g, gamma) = (&e.bolt, &e.grade, e.factors.gamma_m2);
    let subject = format!("{} {}", b.size, g.grade);
    let tension = tension_resistance(b, g, false, gamma);
    let shear = shear_resistance(b, g, ShearPlane::Thread, 1.0, gamma);
    let mut out = Vec::new();
    out.push(tension.information(Topic::Bolts, subject.clone()));
    out.push(shear.information(Topic::Bolts, format!("{subject}, thread in the shear plane")));
    let end = end_distance(e, e.bottom, e.top);
    for (part, thickness, fu, width) in bearing_parts(e) {
        out.push(
            punching_resistance(mean_diameter(b), thickness, fu, gamma)
                .information(Topic::Bolts, part),
        );
        let at = |along, words: &str| {
            let subject = format!("{part}, {words}, vertical force");
            bearing(e, along, (thickness, fu, width)).information(Topic::Bolts, subject)
        };
        // the ends of the column are far
        out.extend((part == "end plate").then(|| at(Along::End { e1: end }, "end bolt")));
        out.extend(pitches(e).map(|[p1, _]| at(Along::Inner { p1 }, "inner bolt")));
    }
    out
}

/// The steel the welds of the beam are designed for: the weaker of the parts joined. Grades without
/// β_w have no fillet welds by this code.
fn welded(e: &EndPlate) -> Option<WeldedSteel> {
    let weaker = e.beam_steel.weaker(&e.plate_steel);
    Some(WeldedSteel { fu: weaker.fu, beta_w: weaker.beta_w?, gamma_m2: e.factors.gamma_m2 })
}

fn welds(e: &EndPlate) -> Vec<Check> {
    let Some(steel) = welded(e) else { return Vec::new() };
    [("beam flange", e.beam.tf), ("beam web", e.beam.tw)]
        .into_iter()
        .map(|(part, t)| {
            full_strength_throat(t, e.beam_steel.fy, e.factors.gamma_m0, &steel)
                .information(Topic::Welds, part)
        })
        .collect()
}

/// F_t,Rd of a bolt with the punching of the plates it holds \[N\].
fn bolt_tension(e: &EndPlate) -> f64 {
    let dm = mean_diameter(&e.bolt);
    let punching =
        |(_, t, fu, _): (_, f64, f64, _)| punching_resistance(dm, t, fu, e.factors.gamma_m2).value;
    let tension = tension_resistance(&e.bolt, &e.grade, false, e.factors.gamma_m2).value;
    bearing_parts(e).into_iter().map(punching).fold(tension, f64::min)
}

/// The joint of the component method.
fn joint(e: &EndPlate, beta: f64) -> EndPlateJoint {
    let column = e.column.as_ref().map(|c| {
        let counts = c.doubler > 0.0 && doubler_fault(c).is_none();
        Column {
            section: (&c.section).into(),
            fy: c.steel.fy,
            above: c.above,
            below: c.below,
            stiffener: c.stiffener,
            stiffener_throat: c.stiffener_throat,
            doublers: u32::from(counts),
            doubler_width: if counts { doubler_width(c) } else { 0.0 },
            longitudinal: c.longitudinal.unwrap_or(0.0),
        }
    });
    EndPlateJoint {
        column,
        beam: Beam {
            section: (&e.beam).into(),
            fy: e.beam_steel.fy,
            flange_throat: e.flange_throat,
            web_throat: e.web_throat,
            shear: 0.0,
        },
        plate: Plate {
            thickness: e.thickness,
            width: e.width,
            bottom: e.bottom,
            top: e.top,
            fy: e.plate_steel.fy,
        },
        bolts: Bolts {
            gauge: e.gauge,
            rows: e.rows.clone(),
            tension: bolt_tension(e),
            stress_area: e.bolt.stress_area,
            elongation: bolt_length::elongation_length(&e.bolt, grip(e), WASHERS),
            washer: None,
            always_prying: e.always_prying,
        },
        beta,
        young: e.beam_steel.e,
        gamma_m0: e.factors.gamma_m0,
        gamma_m1: e.factors.gamma_m1,
    }
}

/// The tables of one sense of bending.
fn component_method(sense: &str, mirrored: bool, column: bool, a: &Assessment) -> Vec<Check> {
    let topic = Topic::ComponentMethod;
    let mut out = Vec::new();
    for (r, row) in a.rows.iter().enumerate() {
        let z = if mirrored { -row.z } else { row.z };
        let subject = format!("{sense}, row {} at z = {} mm", r + 1, n(z));
        // the component that limits the row shows its numbers
        let name = row.limited_by.split(',').next().unwrap_or_default();
        let of = |c: &&Component| c.name == name;
        let groups = row.groups.iter().map(|g| &g.component);
        let shown = if row.limited_by.contains("rows") {
            groups.rev().find(of)
        } else {
            row.alone.iter().find(of)
        };
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
    out.extend(a.limits.iter().map(|l| l.worked.clone().information(topic, sense)));
    out.push(a.moment.clone().information(topic, sense));
    let (joint, beam) = (a.moment.value, a.beam_moment.value);
    let formula =
        format!("M_j,Rd/M_c,Rd = {}/{}", Unit::Moment.show(joint), Unit::Moment.show(beam));
    let share = Worked::new(
        "EN 1993-1-8:2005 5.2.3",
        "strength against that of the beam",
        joint / beam,
        Unit::Number,
        formula,
    );
    out.push(share.information(topic, sense));
    let initial = &a.stiffness.initial;
    out.push(initial.clone().information(Topic::Stiffness, sense));
    let joins = if column { Joins::BeamToColumn } else { Joins::Other };
    out.push(for_elastic_analysis(initial.value, joins).information(Topic::Stiffness, sense));
    out
}

/// The rules of plate and column flange: one of them that holds makes the joint ductile. Those of
/// 6.4.2 hold for S235, S275 and S355 and for axial forces up to 5 % of N_pl,Rd (6.4.2(1)), where
/// bending of that part limits a row (6.4.2(2)).
fn ductility(e: &EndPlate, bending: &[&str]) -> Vec<Check> {
    let (d, fub) = (e.bolt.d, e.grade.fub);
    let plate = ("end plate", Clamped { d, fub, thickness: e.thickness, fy: e.plate_steel.fy });
    let flange = |c: &ColumnSide| {
        ("column flange", Clamped { d, fub, thickness: c.section.tf, fy: c.steel.fy })
    };
    let parts = [plate].into_iter().chain(e.column.as_ref().map(flange));
    let plastic = 1e2 * e.beam.area * e.beam_steel.fy / e.factors.gamma_m0;
    let axial = e.actions.iter().map(|a| a.at(1.0)[0][0].abs()).fold(0.0, f64::max);
    let steels = [Some(&e.plate_steel), Some(&e.beam_steel), e.column.as_ref().map(|c| &c.steel)];
    let beyond = steels
        .into_iter()
        .flatten()
        .find(|s| !EN_6_4_2_STEELS.iter().any(|g| s.grade.starts_with(g)));
    let left = match beyond {
        Some(steel) => Some(format!("6.4.2 does not cover {}", steel.grade)),
        None if axial > SMALL_AXIAL * plastic => {
            Some(format!("6.4.2 does not cover N_Ed = {} > 0.05 N_pl,Rd", Unit::Force.show(axial)))
        }
        None => None,
    };
    let rules = |(part, c)| {
        let mut by_code = rotation_capacity(part, &c);
        let other =
            (!bending.contains(&part)).then(|| format!("bending of the {part} limits no row"));
        if let Some(why) = left.as_ref().or(other.as_ref()) {
            by_code.formula += &format!("; {why}");
            by_code.status = Status::Warning;
        }
        [by_code, plastic_distribution(part, &c)]
    };
    parts.flat_map(rules).collect()
}

/// Grades that the rules of rotation capacity are made for, EN 1993-1-8:2005 6.4.2(1).
const EN_6_4_2_STEELS: [&str; 3] = ["S235", "S275", "S355"];

/// Why the verdict of a limit analysis may not be OK, with the numbers of the rules that are
/// missed.
fn brittle(rules: &[Check]) -> String {
    let each: Vec<String> =
        rules.iter().map(|c| format!("{}: {} ({})", c.subject, c.formula, c.clause)).collect();
    format!(
        "no rule of rotation capacity holds, so that bolts may break before the rows have yielded \
         as limit analysis takes them to: {}; design with the component method, whose rows below \
         one with more than 1.9 F_t,Rd grow with their lever arms (6.2.7.2(9)), or elastically",
        each.join("; ")
    )
}

#[cfg(test)]
mod member_end_tests;
#[cfg(test)]
mod tests;
