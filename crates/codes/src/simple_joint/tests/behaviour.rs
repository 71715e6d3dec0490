//! How the checks react: monotony, symmetry, what stays undecided, what binds.

use super::fixture::{actions, fin_plate, found, header_plate, one, steel, under};
use super::second_implementation::{Dice, random};
use crate::check::{Binding, Check, CheckId, Status};
use crate::simple_joint::simple_checks;
use crate::subject::Part;
use bracket_joint::assembly::{Notch, SimpleJoint, SimpleKind, SupportElement};
use bracket_joint::spec::connection::BoltCategory;
use bracket_joint::spec::loads::LimitState;

const KINDS: [SimpleKind; 2] = [SimpleKind::FinPlate, SimpleKind::HeaderPlate];

/// Utilisations of strength under load, in order.
fn used(e: &SimpleJoint) -> Vec<(CheckId, f64)> {
    let checks = simple_checks(e).checks;
    let strong = checks.iter().filter(|c| c.case.is_some() && !c.is_limit());
    strong.filter_map(|c| Some((c.id(), c.utilisation?))).collect()
}

/// The largest utilisation of each id.
fn worst(e: &SimpleJoint, id: CheckId) -> Option<f64> {
    used(e).into_iter().filter(|(i, _)| *i == id).map(|u| u.1).reduce(f64::max)
}

/// Changes that never raise a utilisation.
fn stronger(e: &SimpleJoint, way: usize) -> SimpleJoint {
    let mut out = e.clone();
    match way {
        0 => out.thickness *= 1.1,
        1 => out.throat *= 1.1,
        2 => out.grade.fub *= 1.1,
        3 => {
            let web = out.beam.h - 2.0 * out.beam.tf;
            out.beam.area += 0.01 * web * 0.1 * out.beam.tw;
            out.beam.tw *= 1.1;
        }
        4 => out.support.section.tw *= 1.1,
        _ => out.bolt.stress_area *= 1.1,
    }
    out
}

#[test]
fn a_stronger_part_never_raises_a_utilisation() {
    for kind in KINDS {
        for seed in 1000..1060 {
            let e = random(kind, &mut Dice::new(seed));
            for way in 0..6 {
                let after = stronger(&e, way);
                for (id, before) in used(&e) {
                    // a thicker plate makes a T-stub stiffer, a wider web or weld its arm m
                    // and its effective length shorter: prying may grow; 3.7(1) counts the
                    // least of the bolts for all where one of them carries less in shear
                    let apart: &[usize] = match id {
                        CheckId::BoltShearAndTension | CheckId::TStub => &[0, 1, 3],
                        CheckId::BearingOfGroup => &[0, 2],
                        _ => &[],
                    };
                    if apart.contains(&way) {
                        continue;
                    }
                    // a long plate that becomes a short one has no such check any more
                    let (Some(now), Some(most)) = (worst(&after, id), worst(&e, id)) else {
                        continue;
                    };
                    assert!(now <= most * (1.0 + 1e-9), "{kind:?} {seed} {way} {id:?}: {before}");
                }
            }
        }
    }
}

#[test]
fn a_larger_force_uses_more() {
    for kind in KINDS {
        for seed in 2000..2060 {
            let e = random(kind, &mut Dice::new(seed));
            let mut more = e.clone();
            for part in more.actions[0].live.iter_mut().flatten() {
                *part *= 1.2;
            }
            for (id, _) in used(&e) {
                let (Some(now), Some(before)) = (worst(&more, id), worst(&e, id)) else { continue };
                assert!(now >= 1.2 * before * (1.0 - 1e-9), "{kind:?} {seed} {id:?}");
            }
        }
    }
}

/// A joint upside down under the opposite vertical force uses the same.
#[test]
fn upside_down_is_the_same() {
    for kind in KINDS {
        for seed in 3000..3060 {
            let e = random(kind, &mut Dice::new(seed));
            let mut turned = e.clone();
            (turned.top, turned.bottom) = (-e.bottom, -e.top);
            turned.rows = e.rows.iter().rev().map(|z| -z).collect();
            turned.notches.reverse();
            let [force, moment] = &mut turned.actions[0].live;
            force[2] = -force[2];
            moment[1] = -moment[1];
            let sort = |e: &SimpleJoint| {
                let mut all = used(e);
                all.sort_by(|a, b| a.0.cmp(&b.0).then(a.1.total_cmp(&b.1)));
                all
            };
            for (a, b) in sort(&e).into_iter().zip(sort(&turned)) {
                assert_eq!(a.0, b.0, "{kind:?} {seed}");
                assert!((a.1 - b.1).abs() <= 1e-9 * a.1, "{kind:?} {seed} {a:?} {b:?}");
            }
        }
    }
}

/// Actions without a formula stay open, with a step, and an analysis may decide them.
#[test]
fn actions_without_a_formula_are_undecided() {
    let open = |e: SimpleJoint, id: CheckId| {
        let checks = simple_checks(&e).checks;
        let all: Vec<Check> = checks.into_iter().filter(|c| c.id() == id).collect();
        assert_eq!(all.len(), 1, "{id:?}");
        let check = &all[0];
        assert_eq!((check.status, check.binding), (Status::Undecided, Binding::Open), "{id:?}");
        assert!(check.open().is_some(), "{id:?}");
    };
    for e in [fin_plate(), header_plate()] {
        let with = |force: [f64; 3], moment: [f64; 3]| SimpleJoint {
            actions: vec![actions(force, moment)],
            ..e.clone()
        };
        open(with([0.0, 1e4, 0.0], [0.0; 3]), CheckId::ShearAcross);
        open(with([0.0; 3], [1e6, 0.0, 0.0]), CheckId::TorsionOfJoint);
        open(with([0.0; 3], [0.0, 0.0, 1e6]), CheckId::WeakAxisOfJoint);
        open(with([-1e5, 0.0, 0.0], [0.0; 3]), CheckId::PushedPlate);
    }
    open(under(header_plate(), [0.0, -100.0, 10.0]), CheckId::MomentOfPinned);
    let fin = simple_checks(&under(fin_plate(), [0.0, -100.0, 10.0])).checks;
    assert!(fin.iter().all(|c| c.id() != CheckId::MomentOfPinned));
    // tension of a support whose bending has no formula here
    open(under(header_plate(), [50.0, -100.0, 0.0]), CheckId::SupportTension);
    let mut on_web = under(fin_plate(), [50.0, -100.0, 0.0]);
    on_web.support.element = SupportElement::ColumnWeb;
    open(on_web, CheckId::SupportTension);
}

#[test]
fn without_a_load_the_resistances_are_information() {
    for e in [fin_plate(), header_plate()] {
        let out = simple_checks(&e);
        let gross = out.checks.iter().filter(|c| c.id() == CheckId::GrossShear);
        assert!(gross.clone().count() > 0);
        assert!(gross.clone().all(|c| c.status == Status::Information && c.resistance.is_some()));
        assert!(out.checks.iter().all(|c| c.case.is_none()));
        assert_eq!(out.brittle, None);
    }
}

#[test]
fn serviceability_checks_slip_alone() {
    for mut e in [fin_plate(), header_plate()] {
        e = under(e, [0.0, -100.0, 0.0]);
        e.actions[0].state = LimitState::Serviceability;
        (e.preload, e.category, e.mu) = (Some(137e3), Some(BoltCategory::B), 0.4);
        let out = simple_checks(&e);
        assert_eq!(out.serviceability, ["LC1"]);
        let of_case: Vec<&Check> = out.checks.iter().filter(|c| c.case.is_some()).collect();
        assert_eq!(of_case.len(), 1);
        assert_eq!(of_case[0].id(), CheckId::SlipServiceability);
        // 100 kN on 10 or 12 bolts; 0.4 · 137/1.1 = 49.8 kN each
        let bolts = (e.rows.len() * e.columns.len()) as f64;
        let used = of_case[0].utilisation.expect("a utilisation");
        assert!((used - 100e3 / bolts / (0.4 * 137e3 / 1.1)).abs() < 1e-9, "{used}");
    }
}

/// The web that a fin plate stands on: t_p ≤ t_w f_u/(f_y,p γ_M2) suffices, and proves nothing
/// where it is not met.
#[test]
fn a_thick_fin_plate_on_a_thin_web_stays_undecided() {
    let mut e = under(fin_plate(), [0.0, -100.0, -8.0]);
    e.support.element = SupportElement::ColumnWeb;
    e.support.section.tw = 8.0;
    let status = |e: &SimpleJoint| {
        one(&simple_checks(e).checks, CheckId::SupportPunching, Part::ColumnWeb).status
    };
    // 8 · 430/(275 · 1.25) = 10.007 mm
    assert_eq!(status(&e), Status::Ok);
    e.thickness = 10.01;
    assert_eq!(status(&e), Status::Undecided);
    e.support.element = SupportElement::ColumnFlange;
    let checks = simple_checks(&e).checks;
    assert!(checks.iter().all(|c| c.id() != CheckId::SupportPunching));
}

/// S275: 0.5 d; one line of bolts needs one ply that gives way, two lines both.
#[test]
fn rotation_of_a_pinned_joint() {
    let mut e = fin_plate();
    let brittle = |e: &SimpleJoint| simple_checks(e).brittle.is_some();
    assert!(!brittle(&e), "t_p = 10 = 0.5 · 20, t_w = 9");
    e.thickness = 10.1;
    assert!(brittle(&e), "two lines");
    e.columns = vec![80.0];
    assert!(!brittle(&e), "one line: the web is thin enough");
    e.plate_steel = steel("S355", 10.1);
    e.beam_steel = steel("S355", 9.0);
    assert!(brittle(&e), "0.42 · 20 = 8.4 < 9");
    // header plate: 20/2.8 √(800/275) = 12.18
    let mut e = header_plate();
    e.support.section.tf = 30.0;
    assert!(!brittle(&e));
    e.thickness = 12.2;
    assert!(brittle(&e));
    e.support.section.tf = 12.1;
    assert!(!brittle(&e), "the flange gives way");
}

/// A notch beyond the limits of local stability is not proved unstable.
#[test]
fn long_notches_stay_undecided() {
    let mut e = under(fin_plate(), [0.0, -100.0, -8.0]);
    let with = |e: &mut SimpleJoint, length, depth| e.notches[0] = Notch { length, depth };
    let status = |e: &SimpleJoint, id| one(&simple_checks(e).checks, id, Part::BeamWeb).status;
    // h_b/t_w = 60.8 > 54.3: 160000 · 547/60.8³ = 389.8 mm
    with(&mut e, 389.0, 50.0);
    assert_eq!(status(&e, CheckId::NotchLength), Status::Ok);
    with(&mut e, 390.5, 50.0);
    assert_eq!(status(&e, CheckId::NotchLength), Status::Undecided);
    assert_eq!(status(&e, CheckId::NotchDepth), Status::Ok);
    with(&mut e, 200.0, 274.0);
    assert_eq!(status(&e, CheckId::NotchDepth), Status::Undecided);
    // both flanges: h/5 = 109.4
    with(&mut e, 200.0, 50.0);
    e.notches[1] = Notch { length: 200.0, depth: 110.0 };
    assert_eq!(status(&e, CheckId::NotchDepth), Status::Undecided);
}

/// What a limit analysis knows as well becomes information beside it; bolts, net sections, blocks,
/// welds and stability bind.
#[test]
fn bindings() {
    let checks = simple_checks(&under(fin_plate(), [0.0, -350.0, -28.0])).checks;
    for (id, part, binding) in [
        (CheckId::GrossShear, Part::FinPlate, Binding::Strength),
        (CheckId::GrossShear, Part::BeamWeb, Binding::Strength),
        (CheckId::NetShear, Part::FinPlate, Binding::Beside),
        (CheckId::BlockTearing, Part::BeamWeb, Binding::Beside),
        (CheckId::BoltInGroup, Part::Bolts, Binding::Beside),
        (CheckId::PlateBuckling, Part::FinPlate, Binding::Beside),
    ] {
        assert_eq!(one(&checks, id, part).binding, binding, "{id:?}");
    }
    assert_eq!(found(&checks, CheckId::WebAtPlate, Part::BeamWeb).len(), 0);
}

/// h_w/t_w = 515.6/7 = 73.7 is more than 72 ε = 66.6 of S275: shear buckling binds as stability.
#[test]
fn a_slender_web_may_buckle_in_shear() {
    let mut e = under(fin_plate(), [0.0, -100.0, -8.0]);
    let buckling = |e: &SimpleJoint| {
        let checks = simple_checks(e).checks;
        found(&checks, CheckId::BeamShearBuckling, Part::BeamWeb).first().and_then(|c| c.resistance)
    };
    assert_eq!(buckling(&e), None);
    e.beam.tw = 7.0;
    let lambda = 515.6 / (86.4 * 7.0 * (235.0f64 / 275.0).sqrt());
    let want = 0.83 / lambda * 515.6 * 7.0 * 275.0 / 3f64.sqrt();
    assert!((buckling(&e).expect("a slender web") / want - 1.0).abs() < 1e-9);
}
