//! Bases and look-ups that the tests share.

use bracket_joint::assembly::{BaseSection, BaseShear, ColumnBase, Foundation, PlaneActions};
use bracket_joint::catalog::Catalog;
use bracket_joint::spec::code::{ConcreteFactors, FySource, PartialFactors};
use bracket_joint::spec::loads::LimitState;
use bracket_joint::spec::welds::WeldEnds;
use bracket_joint::strength::{Nominal, Strength};
use std::sync::LazyLock;

static CATALOG: LazyLock<Catalog> =
    LazyLock::new(|| Catalog::builtin().expect("the shipped catalogue is sound"));

fn s235() -> Strength {
    Strength {
        grade: "S235".into(),
        fy: Nominal::new(235.0),
        fu: Nominal::new(360.0),
        e: 210_000.0,
        beta_w: Some(0.8),
    }
}

/// A load case with N, Vz \[N\] and My \[N mm\].
pub(super) fn actions([n, vz, my]: [f64; 3]) -> PlaneActions {
    PlaneActions {
        case: "ULS".into(),
        end: "column".into(),
        live: [[n, 0.0, vz], [0.0, my, 0.0]],
        dead: [[0.0; 3]; 2],
        state: LimitState::Ultimate,
        outward: 1.0,
        from_node: 0.0,
        above_node: 0.0,
    }
}

/// HE200B on a plate 340x340x18 of S235, concrete C12/15, k_j = 2.5, M20 8.8 at ±140 mm.
pub(in crate::column_base) fn base() -> ColumnBase {
    let plate = [340.0, 340.0];
    ColumnBase {
        section: BaseSection::I(Box::new(CATALOG.profile("HE200B").expect("a profile").clone())),
        flange_steel: s235(),
        web_steel: s235(),
        thickness: 18.0,
        plate_steel: s235(),
        plate,
        offset: 0.0,
        foundation: Foundation {
            rigid: false,
            f_ck: Nominal::new(12.0),
            plate,
            edge: [[255.0; 2]; 2],
            depth: 800.0,
            grout: 30.0,
            grout_strength: Nominal::new(12.0),
            friction: 0.2,
        },
        rows: vec![-140.0, 140.0],
        across: vec![-110.0, 110.0],
        bolt: CATALOG.bolt("M20").expect("a size").clone(),
        grade: CATALOG.bolt_grade("8.8").expect("a grade").clone(),
        hole: 22.0,
        elastic_length: 230.0,
        flange_throat: 6.0,
        web_throat: 4.0,
        ends: WeldEnds::AllRound,
        shear: BaseShear { anchors: true, nib: false },
        anchorage_checked: true,
        not_checked: Vec::new(),
        actions: Vec::new(),
        unseen: Vec::new(),
        annex: None,
        fy_source: FySource::Table31,
        factors: PartialFactors {
            gamma_m0: 1.0,
            gamma_m1: 1.0,
            gamma_m2: 1.25,
            gamma_m3: 1.25,
            gamma_m3_ser: 1.1,
            gamma_m7: 1.1,
            concrete: ConcreteFactors::RECOMMENDED,
        },
        concrete: ConcreteFactors::RECOMMENDED,
    }
}
