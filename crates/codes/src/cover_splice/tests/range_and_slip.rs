//! What the checks leave undecided, detailing, and slip by category.

use super::fixture::{CATALOG, actions, find, near, numbers, open, plain, splice};
use crate::check::{CheckId, Status};
use crate::cover_splice::splice_checks;
use bracket_base::say;
use bracket_joint::assembly::{CoverPlate, CoverSplice, InnerCovers, UnseenLoad};
use bracket_joint::spec::connection::BoltCategory;
use bracket_joint::spec::loads::LimitState;

fn ids(e: &CoverSplice, status: Status) -> Vec<CheckId> {
    let of = splice_checks(e).checks.into_iter().filter(|c| c.status == status);
    of.map(|c| c.id()).collect()
}

#[test]
fn actions_without_a_formula_are_undecided() {
    let mut e = splice();
    e.actions[0].live = [[0.0, 5e3, 100e3], [1e6, 50e6, 2e6]];
    let open = ids(&e, Status::Undecided);
    for id in [CheckId::ShearAcross, CheckId::WeakAxisOfJoint, CheckId::TorsionOfJoint] {
        assert_eq!(open.iter().filter(|o| **o == id).count(), 1, "{open:?}");
    }
    assert_eq!(open.len(), 3);
}

#[test]
fn parts_outside_the_rules_are_undecided() {
    let undecided = |change: fn(&mut CoverSplice)| {
        let mut e = splice();
        change(&mut e);
        ids(&e, Status::Undecided)
    };
    assert_eq!(undecided(|e| e.outer.steel = plain(690.0, 770.0)), [CheckId::OutsideRange]);
    // so thin a cover buckles between the bolts as well
    let thin = undecided(|e| e.web.thickness = 2.5);
    assert_eq!(thin, [CheckId::OutsideRange, CheckId::WebCoverBuckling]);
    // holes wider than oversize have neither bearing nor k_s: once, and for two flanges and a web
    let wide = undecided(|e| e.hole = 27.0);
    let slip = CheckId::SlipServiceability;
    assert_eq!(wide, [CheckId::OutsideRange, slip, slip, slip]);
    // no bolts in the web, or one alone
    for rows in [vec![], vec![0.0]] {
        let mut e = splice();
        (e.web_rows, e.web_columns) = (rows, vec![75.0]);
        let open = ids(&e, Status::Undecided);
        assert_eq!(open, [CheckId::SpliceShares; 2], "once a case");
    }
    let unseen = UnseenLoad {
        case: "ULS".into(),
        why: say!("what acts on `{}` beside the member ends is not in the checks", "face"),
        step: "a load at a member end in its place".into(),
    };
    let e = CoverSplice { unseen: vec![unseen], ..splice() };
    assert_eq!(ids(&e, Status::Undecided), [CheckId::LoadsNotHeld]);
}

#[test]
fn distances_below_the_least_ones_fail() {
    let failed = |change: fn(&mut CoverSplice)| {
        let mut e = splice();
        change(&mut e);
        let all = splice_checks(&e).checks;
        let found = all.iter().filter(|c| c.status == Status::Failed && c.case.is_none());
        found.map(|c| (c.subject.to_string(), c.id())).collect::<Vec<_>>()
    };
    assert_eq!(failed(|_| ()), []);
    let one = |part: &str, id| vec![(String::from(part), id)];
    assert_eq!(failed(|e| e.outer.length = 500.0), one("outer cover", CheckId::EndDistance));
    assert_eq!(failed(|e| e.outer.width = 160.0), one("outer cover", CheckId::EdgeDistance));
    assert_eq!(failed(|e| e.web.length = 360.0), one("web covers", CheckId::EdgeDistance));
    assert_eq!(failed(|e| e.web.width = 280.0), one("web covers", CheckId::EndDistance));
    // 30 − 5 from the end of the flange, and 60 across the gap
    let near_gap = failed(|e| e.flange_rows = vec![30.0, 145.0, 225.0]);
    assert_eq!(near_gap, one("flange", CheckId::EndDistance));
}

/// Root fillets of 10.2 mm, 214 mm from the axis to a flange; a washer of 37 mm and a spanner of
/// 45 mm beside the web.
#[test]
fn room_for_covers_washers_and_spanners_is_advice() {
    let warned = |change: fn(&mut CoverSplice)| {
        let mut e = splice();
        change(&mut e);
        let all = splice_checks(&e).checks;
        let found = all
            .iter()
            .filter(|c| c.status == Status::Warning && !c.id().title().contains("exposed"));
        found.map(|c| (c.subject.to_string(), c.id())).collect::<Vec<_>>()
    };
    let usual = warned(|_| ());
    let more = |change: fn(&mut CoverSplice)| -> Vec<(String, CheckId)> {
        warned(change).into_iter().filter(|w| !usual.contains(w)).collect()
    };
    let one = |part: &str, id| vec![(String::from(part), id)];
    assert_eq!(more(|e| e.web.width = 407.0), []);
    assert_eq!(more(|e| e.web.width = 408.0), one("web covers", CheckId::CoverClearOfRoot));
    // (118 − 8.5)/2 − 10 = 44.75 < 45
    assert_eq!(more(|e| e.gauges = vec![118.5]), []);
    let narrow = more(|e| e.gauges = vec![118.0]);
    assert_eq!(narrow, one("flange bolts", CheckId::SpannerClearance));
    // 214 − 170 = 44 < 45
    let high = more(|e| e.web_rows = vec![-120.0, 0.0, 170.0]);
    assert!(high.contains(&(String::from("web bolts"), CheckId::SpannerClearance)), "{high:?}");
}

/// The members themselves: V_pl with A_v = 4094 mm², N_pl, M_pl of 1471 cm³.
#[test]
fn members_carry_the_actions_themselves() {
    let e = splice();
    let of = |id| numbers(&e, "ULS", id, "beam");
    let area = 8550.0 - 2.0 * 189.9 * 12.7 + (8.5 + 20.4) * 12.7;
    near(of(CheckId::BeamShear)[1], 1e-3 * area * 275.0 / 3f64.sqrt(), 1e-9);
    near(of(CheckId::BeamAxial)[1], 8.55 * 275.0, 1e-9);
    near(of(CheckId::BeamAxial)[0], 150.0, 1e-9);
    near(of(CheckId::BeamMoment)[1], 1471.0 * 275.0, 1e-9);
    near(of(CheckId::BeamMoment)[0], 200e3, 1e-9);
    let mut weak = e.clone();
    weak.actions[0].live[1][1] = 500e6;
    let check = find(&weak, "ULS", CheckId::BeamMoment, "beam");
    assert_eq!(check.status, Status::Failed);
}

/// Slip by category: B at serviceability, C at the ultimate limit state, none as a warning.
#[test]
fn slip_follows_the_category() {
    let mut e = splice();
    let slips = |e: &CoverSplice| -> Vec<(CheckId, String)> {
        let all = splice_checks(e).checks;
        let of = [CheckId::SlipUltimate, CheckId::SlipServiceability];
        let found = all.iter().filter(|c| of.contains(&c.id()));
        found.map(|c| (c.id(), c.case.clone().expect("a case"))).collect()
    };
    let (b, c) =
        ((CheckId::SlipServiceability, "SLS".into()), (CheckId::SlipUltimate, "ULS".into()));
    assert_eq!(slips(&e), [b.clone(), b.clone(), b]);
    e.category = Some(BoltCategory::C);
    assert_eq!(slips(&e), [c.clone(), c.clone(), c]);
    // 68.5 kN of a flange bolt against 0.5 · 137.2/1.25
    let got = numbers(&e, "ULS", CheckId::SlipUltimate, "lower flange, flange bolts");
    near(got[1], 0.5 * 137.2 / 1.25, 1e-9);
    let check = find(&e, "ULS", CheckId::SlipUltimate, "lower flange, flange bolts");
    assert_eq!(check.status, Status::Failed);
    // category C: the net section yields, 6.2.3(4)
    let net = numbers(&e, "ULS", CheckId::CoverTension, "upper flange, outer cover");
    near(net[1], 1e-3 * 136.0 * 12.0 * 275.0, 1e-9);
    e.category = Some(BoltCategory::A);
    assert_eq!(slips(&e), []);
    e.category = None;
    let check = find(&e, "ULS", CheckId::SlipUltimate, "lower flange, flange bolts");
    assert_eq!(check.status, Status::Warning);
    e.category = Some(BoltCategory::B);
    e.actions.truncate(1);
    assert_eq!(ids(&e, Status::Undecided), [CheckId::SlipNoCase]);
}

/// Inner covers make two shear planes; outer cover and inner pair carry one half each.
#[test]
fn inner_covers_halve_the_force_of_a_plane() {
    let mut e = splice();
    let plate =
        CoverPlate { thickness: 10.0, width: 70.0, length: 570.0, steel: plain(275.0, 410.0) };
    e.inner = Some(InnerCovers { plate, from: 24.0 });
    let one = numbers(&splice(), "ULS", CheckId::SpliceBoltShear, "lower flange, flange bolts");
    let two = numbers(&e, "ULS", CheckId::SpliceBoltShear, "lower flange, flange bolts");
    near(two[0], one[0], 1e-12);
    near(two[1], 2.0 * one[1], 1e-12);
    for part in ["outer cover", "inner covers"] {
        let whole = numbers(&e, "ULS", CheckId::FlangeTension, "upper flange")[0];
        let part = format!("upper flange, {part}");
        near(numbers(&e, "ULS", CheckId::CoverTension, &part)[0], 0.5 * whole, 1e-12);
    }
    assert_eq!(open(&e), Vec::<String>::new());
}

/// A single row of bolts in one shear plane bears no more than 1.5 f_u d t/γ_M2, 3.6.1(10).
#[test]
fn a_single_lap_joint_with_one_row_bears_less() {
    let mut e = splice();
    e.flange_rows = vec![75.0];
    e.outer.length = 300.0;
    e.actions = vec![actions("ULS", [200e3, 10e3, 0.0], LimitState::Ultimate)];
    let got = numbers(&e, "ULS", CheckId::BearingResistance, "upper flange");
    near(got[1], 1e-3 * 1.5 * 410.0 * 20.0 * 12.7 / 1.25, 1e-9);
    assert_eq!(CATALOG.bolt("M20").expect("a size").d, 20.0);
}
