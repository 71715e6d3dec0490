//! Sloping and haunched beams: random joints against a second implementation, and the limits in
//! which a rafter is a beam.

mod loaded;
mod random;
mod second;

use super::fixture::{ONE, joint};
use crate::check::{CheckId, Status};
use crate::component_method::sloped_end::{EndFlange, SlopedEnd};
use crate::component_method::{Summed, assess};
use crate::design_code::build;
use crate::end_plate::component_joint::component_joint;
use crate::end_plate::hand_checks;
use crate::subject::Sense;
use bracket_base::yaml;
use bracket_joint::assembly::{EndPlate, Facts, Rafter};
use bracket_joint::catalog::Catalog;
use bracket_joint::spec::ConnectionSpec;
use random::{Random, haunched};
use second::second;
use std::path::Path;

/// IPE300 on HEB200 with welds of 6 and 4 mm, under a load case.
pub(super) fn plain(load: &str) -> EndPlate {
    let text = joint("flange_weld: 6, web_weld: 4", load);
    let spec = yaml::parse::<ConnectionSpec>(&text, Path::new("joint.yaml")).expect("a spec");
    let catalog = Catalog::builtin().expect("the shipped catalogue is sound");
    let joint = build(&spec, Path::new("."), &catalog).expect("a joint");
    joint.facts.as_ref().and_then(Facts::end_plate).expect("an end plate").clone()
}

fn same(what: &str, a: f64, b: f64, worst: &mut f64) {
    let difference = (a - b).abs() / a.abs().max(b.abs()).max(1.0);
    *worst = worst.max(difference);
    assert!(difference <= 1e-9, "{what}: {a}, by the second implementation {b}");
}

/// Row forces, limits, M_c,Rd and M_j,Rd of random joints of a rafter with slope and haunch, in
/// both senses of bending, are those of the second implementation.
#[test]
fn random_haunched_joints_agree_with_the_second_implementation() {
    let catalog = Catalog::builtin().expect("the shipped catalogue is sound");
    let (base, mut n) = (plain(ONE), Random(7));
    let (mut covered, mut joints, mut worst) = (0, 0, 0.0);
    for _ in 0..400 {
        let e = haunched(&base, &catalog, &mut n);
        let mut any = false;
        for (sense, beta) in [(Sense::Top, 1.0), (Sense::Bottom, 1.0), (Sense::Top, 0.7)] {
            let joint = component_joint(&e, beta);
            let Ok(found) = assess(&joint.turned(sense)) else { continue };
            let (bolt, long) = (joint.bolts.tension, joint.bolts.elongation);
            let other = second(&e, sense == Sense::Top, beta, bolt, long);
            assert_eq!(found.rows.len(), other.rows.len());
            for (a, b) in found.rows.iter().zip(&other.rows) {
                same("z of a row", a.z, b[0], &mut worst);
                same("force of a row", a.force, b[1], &mut worst);
            }
            let limit = |of| found.limit(of).map_or(f64::NAN, |l| l.value);
            same("column web", limit(Summed::ColumnWeb), other.column_web, &mut worst);
            same("beam flange", limit(Summed::BeamFlange), other.flange, &mut worst);
            same("panel", limit(Summed::Panel), other.panel / beta, &mut worst);
            same("M_c,Rd", found.beam_moment.value, other.beam, &mut worst);
            same("M_j,Rd", found.moment.value, other.moment, &mut worst);
            covered += 1;
            any = true;
        }
        joints += usize::from(any);
    }
    println!("{joints} joints, {covered} senses, largest difference {worst:.1e}");
    assert!(joints >= 200 && covered >= 500, "{joints} joints, {covered} senses were covered");
}

/// A rafter without slope and haunch, as deep as the beam, is the beam: all checks are the same,
/// and so is the component method of an end that is given as sloped by 0.
#[test]
fn a_rafter_without_slope_and_haunch_is_a_beam() {
    let load = "{name: A, end: beam_right, at: bolt_plane, My: 60 kN m, Vz: -80 kN, N: -400 kN}";
    let e = plain(load);
    let mut level = e.clone();
    level.rafter = Some(Box::new(Rafter { slope: 0.0, depth: e.beam.h, haunch: None }));
    assert_eq!(hand_checks(&e), hand_checks(&level));
    let joint = component_joint(&e, 1.0);
    let mut sloped = joint.clone();
    let b = joint.beam.section;
    let flange = EndFlange { thickness: b.tf, width: b.b, slope: 0.0 };
    sloped.beam.sloped = Some(SlopedEnd { depth: b.h, upper: flange, lower: flange, haunch: None });
    for sense in [Sense::Top, Sense::Bottom] {
        let [a, b] = [&joint, &sloped].map(|j| assess(&j.turned(sense)).expect("covered"));
        assert_eq!(a.moment.value, b.moment.value);
        assert_eq!(a.stiffness.initial.value, b.stiffness.initial.value);
        let forces = |x: &crate::component_method::Assessment| {
            x.rows.iter().map(|r| r.force).collect::<Vec<_>>()
        };
        assert_eq!(forces(&a), forces(&b));
        let limits = |x: &crate::component_method::Assessment| {
            x.limits.iter().map(|l| l.worked.value).collect::<Vec<_>>()
        };
        assert_eq!(limits(&a), limits(&b));
    }
    let [a, b] =
        [&joint, &sloped].map(|j| crate::component_method::Equilibrium::new(j).expect("covered"));
    assert_eq!((a.tension, a.compression, a.middles), (b.tension, b.compression, b.middles));
}

/// A row on the beam's own flange above the haunch is refused, and each rule of 6.2.6.7(2) fails on
/// its own.
#[test]
fn rows_on_the_inner_flange_and_rules_of_the_haunch() {
    let catalog = Catalog::builtin().expect("the shipped catalogue is sound");
    let mut e = random::of_ipe300(&plain(ONE), &catalog);
    assert!(assess(&component_joint(&e, 1.0)).is_ok());
    let face = e.depth() / 2.0 - e.beam.h / e.rafter.as_ref().expect("a rafter").slope.cos();
    let row = e.rows.len() - 1;
    let kept = e.rows[row];
    e.rows[row] = face + 3.0;
    let fault = assess(&component_joint(&e, 1.0)).expect_err("on the flange");
    assert!(fault.text().to_string().contains("stands on the beam flange"), "{fault}");
    e.rows[row] = kept;
    let failed = |e: &EndPlate| {
        let checks = hand_checks(e).checks;
        let rules = [
            CheckId::HaunchSteel,
            CheckId::HaunchFlangeThickness,
            CheckId::HaunchFlangeWidth,
            CheckId::HaunchWebThickness,
            CheckId::HaunchAngle,
        ];
        let of = |id: CheckId| checks.iter().find(|c| c.id() == id).expect("a rule").status;
        rules.into_iter().filter(|id| of(*id) == Status::Failed).collect::<Vec<_>>()
    };
    assert_eq!(failed(&e), []);
    type Change<'a> = (&'a dyn Fn(&mut bracket_joint::assembly::Haunch), CheckId);
    let weaker = |h: &mut bracket_joint::assembly::Haunch| {
        h.steel.grade = "S185".into();
        h.steel.fy = bracket_joint::strength::Nominal::new(185.0);
    };
    let changes: [Change<'_>; 5] = [
        (&weaker, CheckId::HaunchSteel),
        (&|h| h.flange = 10.0, CheckId::HaunchFlangeThickness),
        (&|h| h.width = 140.0, CheckId::HaunchFlangeWidth),
        (&|h| h.web = 7.0, CheckId::HaunchWebThickness),
        (&|h| h.angle = 46f64.to_radians(), CheckId::HaunchAngle),
    ];
    for (change, id) in changes {
        let mut other = e.clone();
        change(other.rafter.as_mut().and_then(|r| r.haunch.as_mut()).expect("a haunch"));
        assert_eq!(failed(&other), [id]);
    }
}

/// Turned upside down a joint keeps its results: the sense of bending is turned with it.
#[test]
fn a_mirrored_haunch_is_a_haunch_above() {
    let catalog = Catalog::builtin().expect("the shipped catalogue is sound");
    let e = random::of_ipe300(&plain(ONE), &catalog);
    let joint = component_joint(&e, 1.0);
    assert_eq!(joint.mirrored().mirrored(), joint);
    let [hogging, sagging] = [Sense::Top, Sense::Bottom].map(|s| joint.turned(s));
    // the centre of compression is the middle of the haunch flange, then that of the upper one
    let r = e.rafter.as_deref().expect("a rafter");
    let h = r.haunch.as_ref().expect("a haunch");
    let of = |j: &crate::component_method::EndPlateJoint| {
        let a = assess(j).expect("covered");
        a.rows[0].z - a.rows[0].lever
    };
    let low = -0.5 * (r.depth - h.flange / (r.slope + h.angle).cos());
    let high = 0.5 * (r.depth - e.beam.tf / r.slope.cos());
    assert!((of(&hogging) - low).abs() < 1e-9 && (of(&sagging) + high).abs() < 1e-9);
}
