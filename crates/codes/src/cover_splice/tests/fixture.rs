//! A splice and look-ups that the tests share.

use crate::check::{Check, CheckId, Status};
use crate::cover_splice::splice_checks;
use bracket_joint::assembly::{CoverPlate, CoverSplice, PlaneActions, SpliceUse, SplicedMember};
use bracket_joint::catalog::Catalog;
use bracket_joint::spec::code::{ConcreteFactors, FySource, PartialFactors};
use bracket_joint::spec::connection::BoltCategory;
use bracket_joint::spec::loads::LimitState;
use bracket_joint::strength::{Nominal, Strength};
use std::sync::LazyLock;

pub(super) static CATALOG: LazyLock<Catalog> =
    LazyLock::new(|| Catalog::builtin().expect("the shipped catalogue is sound"));

pub(super) const RECOMMENDED: PartialFactors = PartialFactors {
    gamma_m0: 1.0,
    gamma_m1: 1.0,
    gamma_m2: 1.25,
    gamma_m3: 1.25,
    gamma_m3_ser: 1.1,
    gamma_m7: 1.1,
    concrete: ConcreteFactors::RECOMMENDED,
};

/// A steel of the catalogue at a thickness.
pub(super) fn steel(name: &str, thickness: f64) -> Strength {
    let steel = CATALOG.steel(name).expect("a steel");
    Strength {
        grade: name.into(),
        fy: Nominal::new(steel.fy(thickness).expect("f_y")),
        fu: Nominal::new(steel.fu(thickness).expect("f_u")),
        e: steel.e,
        beta_w: steel.beta_w,
    }
}

/// A steel with given strengths \[MPa\].
pub(super) fn plain(fy: f64, fu: f64) -> Strength {
    Strength {
        grade: "S275".into(),
        fy: Nominal::new(fy),
        fu: Nominal::new(fu),
        e: 210_000.0,
        beta_w: Some(0.85),
    }
}

pub(super) fn member(profile: &str, steel: Strength) -> SplicedMember {
    SplicedMember {
        section: CATALOG.profile(profile).expect("a profile").clone(),
        flange_steel: steel.clone(),
        web_steel: steel,
        axis: 0.0,
        packs: [0.0; 2],
        inner_packs: 0.0,
        web_packs: 0.0,
    }
}

/// Actions `N`, `Vz` \[N\] and `My` \[N mm\] of a load case.
pub(super) fn actions(case: &str, [n, vz, my]: [f64; 3], state: LimitState) -> PlaneActions {
    PlaneActions {
        case: case.into(),
        end: "splice".into(),
        live: [[n, 0.0, vz], [0.0, my, 0.0]],
        dead: [[0.0; 3]; 2],
        state,
        outward: 1.0,
        from_node: 0.0,
        above_node: 0.0,
    }
}

/// The published splice of UB 457 x 191 x 67 (see `published.rs`).
pub(super) fn splice() -> CoverSplice {
    let s275 = plain(275.0, 410.0);
    let beam = member("UB457x191x67", s275.clone());
    let cover =
        |thickness, width, length| CoverPlate { thickness, width, length, steel: s275.clone() };
    CoverSplice {
        used: SpliceUse::Beam,
        left: beam.clone(),
        right: beam,
        gap: 10.0,
        outer: cover(12.0, 180.0, 570.0),
        inner: None,
        web: cover(10.0, 340.0, 420.0),
        web_middle: 0.0,
        flange_rows: vec![65.0, 145.0, 225.0],
        gauges: vec![120.0],
        web_rows: vec![-120.0, 0.0, 120.0],
        web_columns: vec![75.0, 160.0],
        bolt: CATALOG.bolt("HR M20").or_else(|_| CATALOG.bolt("M20")).expect("a size").clone(),
        grade: CATALOG.bolt_grade("8.8").expect("a grade").clone(),
        hole: 22.0,
        flange_grip: 24.7,
        web_grip: 28.5,
        not_checked: Vec::new(),
        actions: vec![
            actions("ULS", [-150e3, -150e3, 200e6], LimitState::Ultimate),
            actions("SLS", [-100e3, -100e3, 133e6], LimitState::Serviceability),
        ],
        preload: Some(0.7 * 800.0 * 245.0),
        category: Some(BoltCategory::B),
        mu: 0.5,
        unseen: Vec::new(),
        annex: None,
        fy_source: FySource::Table31,
        factors: RECOMMENDED,
    }
}

/// The check of a case with an id whose subject ends with some words.
pub(super) fn find(e: &CoverSplice, case: &str, id: CheckId, subject: &str) -> Check {
    let all = splice_checks(e).checks;
    let fits = |c: &&Check| {
        c.case.as_deref() == Some(case)
            && c.id() == id
            && c.subject.to_string().ends_with(&format!("splice, {subject}"))
    };
    let found = all.iter().find(fits);
    found.cloned().unwrap_or_else(|| {
        let of_id = all.iter().filter(|c| c.id() == id).map(|c| c.subject.to_string());
        panic!("no `{}` of `{subject}` in {:?}", id.title(), of_id.collect::<Vec<_>>())
    })
}

/// Demand and resistance of such a check in kN.
pub(super) fn numbers(e: &CoverSplice, case: &str, id: CheckId, subject: &str) -> [f64; 2] {
    let check = find(e, case, id, subject);
    [check.demand, check.resistance].map(|x| 1e-3 * x.expect("a number"))
}

pub(super) fn near(got: f64, want: f64, part: f64) {
    assert!((got / want - 1.0).abs() <= part, "{got} is not {want}");
}

/// The checks that are open or failed, as text.
pub(super) fn open(e: &CoverSplice) -> Vec<String> {
    let bad = |c: &&Check| matches!(c.status, Status::Undecided | Status::Failed);
    splice_checks(e).checks.iter().filter(bad).map(|c| c.sentence().to_string()).collect()
}
