//! Simple joints for the tests, with sections, bolts and steels of the catalogue.

use crate::check::{Check, CheckId};
use crate::subject::{Part, Place};
use bracket_joint::assembly::{
    Notch, PlaneActions, SimpleJoint, SimpleKind, Support, SupportElement,
};
use bracket_joint::catalog::Catalog;
use bracket_joint::spec::code::{ConcreteFactors, FySource, PartialFactors};
use bracket_joint::spec::loads::LimitState;
use bracket_joint::spec::welds::WeldSpec;
use bracket_joint::strength::{Nominal, Strength};
use std::sync::LazyLock;

pub static CATALOG: LazyLock<Catalog> =
    LazyLock::new(|| Catalog::builtin().expect("the shipped catalogue is sound"));

/// Recommended partial factors.
pub const FACTORS: PartialFactors = PartialFactors {
    gamma_m0: 1.0,
    gamma_m1: 1.0,
    gamma_m2: 1.25,
    gamma_m3: 1.25,
    gamma_m3_ser: 1.1,
    gamma_m7: 1.1,
    concrete: ConcreteFactors::RECOMMENDED,
};

/// A steel of Table 3.1 at a thickness \[mm\].
pub fn steel(grade: &str, thickness: f64) -> Strength {
    let steel = CATALOG.steel(grade).expect("a grade");
    let of = |value: Result<f64, _>| Nominal::new(value.map_err(|_| ()).expect("a thickness"));
    Strength {
        grade: steel.grade.clone(),
        fy: of(steel.fy_by(FySource::Table31, thickness)),
        fu: of(steel.fu_by(FySource::Table31, thickness)),
        e: steel.e,
        beta_w: steel.beta_w,
    }
}

/// The worked example 3.4 of Steel Buildings in Europe, Part 5.
///
/// IPE A 550 in S275, fin plate 360 × 160 × 10, 5 × 2 M20 8.8, p1 70, p2 60, e1 40, e2 50, e2,b 40,
/// e1,b 90, z 80.
pub fn fin_plate() -> SimpleJoint {
    let beam = CATALOG.profile("IPEA550").expect("a profile").clone();
    let section = CATALOG.profile("HEB300").expect("a profile").clone();
    let first = 0.5 * beam.h - 90.0;
    let support = Support {
        element: SupportElement::ColumnFlange,
        steel: steel("S275", section.tf),
        section,
    };
    SimpleJoint {
        kind: SimpleKind::FinPlate,
        support,
        beam_steel: steel("S275", beam.tw),
        beam,
        plate_steel: steel("S275", 10.0),
        bolt: CATALOG.bolt("M20").expect("a size").clone(),
        grade: CATALOG.bolt_grade("8.8").expect("a grade").clone(),
        thickness: 10.0,
        width: 160.0,
        bottom: first - 320.0,
        top: first + 40.0,
        rows: (0..5).map(|i| first - 70.0 * f64::from(i)).collect(),
        columns: vec![50.0, 110.0],
        hole: 22.0,
        beam_start: 10.0,
        notches: [Notch::default(); 2],
        throat: 5.0,
        grip: 19.0,
        not_checked: Vec::new(),
        actions: Vec::new(),
        preload: None,
        category: None,
        mu: 0.0,
        unseen: Vec::new(),
        welds: WeldSpec::default(),
        annex: None,
        fy_source: FySource::Table31,
        factors: FACTORS,
    }
}

/// The plate of the worked example 2.4 of Steel Buildings in Europe, Part 5, on the same beam: 430
/// × 200 × 12 in S275, 6 × 2 M20 8.8, p1 70, e1 40, e2 30; p3 and the throat so that m = 59.
pub fn header_plate() -> SimpleJoint {
    let fin = fin_plate();
    let first = 0.5 * fin.beam.h - 90.0;
    SimpleJoint {
        kind: SimpleKind::HeaderPlate,
        thickness: 12.0,
        plate_steel: steel("S275", 12.0),
        width: 200.0,
        bottom: first - 390.0,
        top: first + 40.0,
        rows: (0..6).map(|i| first - 70.0 * f64::from(i)).collect(),
        columns: vec![-70.0, 70.0],
        beam_start: 12.0,
        throat: (70.0 - 4.5 - 59.0) / (0.8 * 2f64.sqrt()),
        grip: 31.0,
        ..fin
    }
}

/// The joint under N, Vz \[kN\] and My \[kN m\] at its bolt plane.
pub fn under(mut e: SimpleJoint, [n, vz, my]: [f64; 3]) -> SimpleJoint {
    e.actions = vec![actions([n * 1e3, 0.0, vz * 1e3], [0.0, my * 1e6, 0.0])];
    e
}

/// A load case at the ultimate limit state \[N, N mm\].
pub fn actions(force: [f64; 3], moment: [f64; 3]) -> PlaneActions {
    PlaneActions {
        case: "LC1".into(),
        end: "beam".into(),
        live: [force, moment],
        dead: [[0.0; 3]; 2],
        state: LimitState::Ultimate,
        outward: 1.0,
        from_node: 0.0,
        above_node: 0.0,
    }
}

/// The part that a check is about; `None` of a seam.
pub fn part_of(check: &Check) -> Option<Part> {
    check.subject.places.iter().rev().find_map(|p| match p {
        Place::Part(part) => Some(*part),
        _ => None,
    })
}

/// The checks with an id, of a part.
pub fn found(checks: &[Check], id: CheckId, part: Part) -> Vec<&Check> {
    checks.iter().filter(|c| c.id() == id && part_of(c) == Some(part)).collect()
}

/// The only check with an id, of a part.
pub fn one(checks: &[Check], id: CheckId, part: Part) -> &Check {
    match found(checks, id, part)[..] {
        [check] => check,
        ref all => panic!("{} checks {id:?} of {part:?}", all.len()),
    }
}
