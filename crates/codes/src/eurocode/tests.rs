//! Each formula of sections 3 and 4 against printed values, named after its clause.

use super::bearing::{Along, Bearing, Hole};
use super::block_tearing::Blocks;
use super::bolts::{long_joint, shear_resistance, tension_resistance};
use super::slip::{SlipHole, preload, slip_resistance};
use super::spacing::{Pattern, pattern_checks, washer_check, wrench_check};
use super::welds::{self, PairForce, ThroatStress, WeldedSteel};
use super::{bolt_length, interaction, punching};
use crate::check::Status;
use crate::subject::Part;
use bracket_joint::catalog::{BoltGrade, BoltSize, Catalog};
use bracket_joint::strength::Nominal;

fn bolt(size: &str, grade: &str) -> (BoltSize, BoltGrade) {
    let catalog = Catalog::builtin().expect("the shipped catalogue is sound");
    (catalog.bolt(size).expect("size").clone(), catalog.bolt_grade(grade).expect("grade").clone())
}

/// `got` in kN has the printed digits.
fn printed(name: &str, got: f64, want: &str) {
    let decimals = want.split('.').nth(1).map_or(0, str::len);
    assert_eq!(format!("{:.decimals$}", got * 1e-3), want, "{name}: {got} N");
}

fn near(got: f64, want: f64) {
    assert!((got - want).abs() <= 1e-12 * want.abs().max(1.0), "{got} is not {want}");
}

/// Printed constants: M16, M20, M24 8.8 and M20, M24 10.9, thread in the shear plane.
#[test]
fn table_3_4_tension_shear_and_3_9_1_preload_of_usual_bolts() {
    let table = [
        ("M16", "8.8", "90.4", "60.3", None),
        ("M20", "8.8", "141.1", "94.1", Some("137.2")),
        ("M24", "8.8", "203.3", "135.6", Some("197.7")),
        ("M20", "10.9", "176.4", "98.0", Some("171.5")),
        ("M24", "10.9", "254.2", "141.2", Some("247.1")),
    ];
    for (size, grade, ft, fv, fp) in table {
        let (b, g) = bolt(size, grade);
        printed(size, tension_resistance(&b, &g, 1.25).value, ft);
        printed(size, shear_resistance(&b, &g, 1.25).value, fv);
        if let Some(fp) = fp {
            printed(size, preload(&b, &g).value, fp);
        }
    }
}

/// M22 10.9 of a printed report: 20 mm of S355, d_m = 38 mm.
#[test]
fn table_3_4_tension_and_punching_of_m22() {
    let (b, g) = bolt("M22", "10.9");
    printed("F_t,Rd", tension_resistance(&b, &g, 1.25).value, "218.2");
    printed("B_p,Rd", punching::punching_resistance(38.0, 20.0, 490.0, 1.25).value, "561.6");
    // across flats 34, across corners at least 37.72: their mean
    near(punching::mean_diameter(&b), 0.5 * (b.head_width + b.head_corners));
    let small_nut = BoltSize { nut_width: 0.9 * b.head_width, ..b.clone() };
    near(punching::mean_diameter(&small_nut), 0.9 * punching::mean_diameter(&b));
}

/// Partial depth end plate of Multi-Storey Steel Buildings, Part 5: 12 M20 8.8, 12 mm S275, d0 22,
/// e1 40, e2 30, p1 70.
#[test]
fn table_3_4_bearing_of_a_partial_depth_end_plate() {
    let (b, g) = bolt("M20", "8.8");
    let shear = shear_resistance(&b, &g, 1.25).value;
    printed("F_v,Rd", shear, "94");
    let at = |along| {
        let place = Bearing {
            along,
            e2: 30.0,
            p2: f64::INFINITY,
            hole: Hole::Normal,
            d: 20.0,
            d0: 22.0,
            thickness: 12.0,
            fu: 430.0,
            fub: 800.0,
        };
        place.resistance(1.25)
    };
    let (end, inner) = (at(Along::End { e1: 40.0 }), at(Along::Inner { p1: 70.0 }));
    printed("end bolt", end.value, "106.0");
    printed("inner bolt", inner.value, "142");
    let step = |w: &crate::Worked, s: &str| {
        w.steps.iter().find(|x| x.symbol == s).map_or(f64::NAN, |x| x.value)
    };
    assert_eq!(format!("{:.2} {:.2}", step(&end, "α_b"), step(&end, "k1")), "0.61 2.12");
}

#[test]
fn table_3_4_bearing_holes_and_columns_of_bolts() {
    let place = Bearing {
        along: Along::Inner { p1: 1000.0 },
        e2: 99.0,
        p2: 50.0,
        hole: Hole::Normal,
        d: 20.0,
        d0: 22.0,
        thickness: 10.0,
        fu: 360.0,
        fub: 800.0,
    };
    // the pitch across the force decides
    let k1: f64 = 1.4 * 50.0 / 22.0 - 1.7;
    near(place.resistance(1.25).value, k1 * 360.0 * 20.0 * 10.0 / 1.25);
    near(
        Bearing { hole: Hole::Oversize, ..place }.resistance(1.25).value,
        0.8 * place.resistance(1.25).value,
    );
    // a wide pitch: k1 = 2.5; a soft bolt: α_b = f_ub/f_u
    let wide = Bearing { p2: 400.0, fub: 270.0, ..place };
    near(wide.resistance(1.25).value, 2.5 * 0.75 * 360.0 * 20.0 * 10.0 / 1.25);
    // below the distances of Table 3.3 the resistance is 0, not negative
    assert_eq!(Bearing { p2: 20.0, ..place }.resistance(1.25).value, 0.0);
}

#[test]
fn clause_3_9_slip_without_and_with_tension() {
    let (b, g) = bolt("M20", "10.9");
    let fp = preload(&b, &g).value;
    let plain = slip_resistance(SlipHole::Normal, 2, 0.5, fp, 0.0, ("γ_M3", 1.25)).value;
    near(plain, 2.0 * 0.5 * 171_500.0 / 1.25);
    let tension = slip_resistance(SlipHole::Normal, 2, 0.5, fp, 100e3, ("γ_M3", 1.25));
    near(tension.value, 2.0 * 0.5 * (171_500.0 - 80_000.0) / 1.25);
    assert_eq!(tension.clause, "EN 1993-1-8:2005 3.9.2(1)");
    assert_eq!(
        slip_resistance(SlipHole::Normal, 1, 0.5, fp, 1e9, ("γ_M3", 1.25)).value,
        0.0,
        "never negative"
    );
    let holes = [(SlipHole::Normal, 1.0), (SlipHole::Oversize, 0.85)];
    for (hole, ks) in holes {
        near(slip_resistance(hole, 1, 0.3, fp, 0.0, ("γ_M3", 1.25)).value / (0.3 * fp / 1.25), ks);
    }
}

#[test]
fn table_3_4_interaction_of_shear_and_tension() {
    let f = |shear, tension| interaction::Forces {
        shear,
        tension,
        shear_resistance: 100.0,
        tension_resistance: 140.0,
    };
    near(interaction::utilisation(&f(50.0, 98.0)).value, 1.0);
    near(interaction::utilisation(&f(0.0, 140.0)).value, 1.0);
    near(interaction::utilisation(&f(0.0, 154.0)).value, 1.1);
    near(interaction::utilisation(&f(100.0, 0.0)).value, 1.0);
}

#[test]
fn table_3_3_least_and_greatest_distances() {
    let pattern = Pattern {
        d0: 20.0,
        thickness: 10.0,
        e1: Some(24.0),
        e2: Some(24.0),
        p1: Some([44.0, 140.0]),
        p2: Some(48.0),
    };
    let statuses = |p: &Pattern| {
        pattern_checks(Part::EndPlate, p).iter().map(|c| c.status).collect::<Vec<_>>()
    };
    assert!(
        statuses(&pattern).iter().all(|s| *s == Status::Ok),
        "{:#?}",
        pattern_checks(Part::EndPlate, &pattern)
    );
    let failed = |p: Pattern| statuses(&p).iter().filter(|s| **s == Status::Failed).count();
    assert_eq!(failed(Pattern { e1: Some(23.9), ..pattern }), 1);
    assert_eq!(failed(Pattern { e2: Some(23.9), ..pattern }), 1);
    assert_eq!(failed(Pattern { p1: Some([43.9, 140.0]), ..pattern }), 1);
    assert_eq!(failed(Pattern { p2: Some(47.9), ..pattern }), 1);
    // the greatest distances warn: 4 t + 40 = 80, min(14 t, 200) = 140
    let far = Pattern {
        e1: Some(81.0),
        e2: Some(81.0),
        p1: Some([44.0, 141.0]),
        p2: Some(141.0),
        ..pattern
    };
    assert_eq!(statuses(&far).iter().filter(|s| **s == Status::Warning).count(), 4);
    assert_eq!(failed(far), 0);
    let alone = Pattern { e1: None, e2: None, p1: None, p2: None, ..pattern };
    assert!(pattern_checks(Part::EndPlate, &alone).is_empty());
}

#[test]
fn practice_room_for_wrench_and_washer() {
    assert_eq!(wrench_check(Part::BoltRows, 41.0, 18.0).status, Status::Ok);
    assert_eq!(wrench_check(Part::BoltRows, 40.9, 18.0).status, Status::Warning);
    assert_eq!(washer_check(Part::ColumnFlange, 35.0, 34.0, 18.0).status, Status::Ok);
    assert_eq!(washer_check(Part::ColumnFlange, 34.9, 34.0, 18.0).status, Status::Warning);
}

#[test]
fn en_1090_2_length_of_a_bolt() {
    // M20: nut 18, washer 3, pitch 2.5; thread 46 up to 125 mm, 52 up to 200, 65 above
    let (b, _) = bolt("M20", "8.8");
    let least = bolt_length::least_length(&b, 40.0, 2).value;
    near(least, 40.0 + 6.0 + b.nut_height + 2.5);
    assert_eq!(bolt_length::stocked_length(least), Some(70.0));
    assert_eq!(bolt_length::stocked_length(70.0), Some(70.0));
    assert_eq!(bolt_length::stocked_length(441.0), None);
    for (length, thread) in [(40.0, 40.0), (100.0, 46.0), (130.0, 52.0), (220.0, 65.0)] {
        near(bolt_length::thread_length(&b, length), thread);
    }
    near(bolt_length::elongation_length(&b, 40.0, 2), 46.0 + 0.5 * (b.head_height + b.nut_height));
    // 70 mm long: 24 mm of shank and a pitch within 46 mm
    assert_eq!(bolt_length::shank_check(Part::Bolts.into(), &b, 70.0, 40.0, 2).status, Status::Ok);
    assert_eq!(
        bolt_length::shank_check(Part::Bolts.into(), &b, 120.0, 70.0, 1).status,
        Status::Failed
    );
}

const S235: WeldedSteel = WeldedSteel { fu: Nominal::new(360.0), beta_w: 0.8, gamma_m2: 1.25 };

#[test]
fn clause_4_5_3_2_directional_method() {
    // σ⊥ = τ⊥ = 180 MPa: √(180² + 3 · 180²) = 360 MPa, which is just f_u/(0.8 · 1.25)
    let stress = ThroatStress { sigma_perp: 180.0, tau_perp: 180.0, tau_par: 0.0 };
    near(welds::directional(&stress, &S235).value, 1.0);
    // σ⊥ alone: 0.9 f_u/γ_M2 = 259.2 MPa decides
    let normal = ThroatStress { sigma_perp: -259.2, ..Default::default() };
    near(welds::directional(&normal, &S235).value, 1.0);
    let along = ThroatStress { tau_par: 360.0 / 3f64.sqrt(), ..Default::default() };
    near(welds::directional(&along, &S235).value, 1.0);
}

/// 150 kN across 180 mm of two welds of 4 mm: 150e3/(2 √2 · 4 · 180) = 73.66 MPa; with 52.08 MPa
/// along them √(73.66² + 3 (73.66² + 52.08²)) = 172.7 MPa of 360 MPa.
#[test]
fn clause_4_5_3_2_a_plate_pulled_and_sheared() {
    let across = 150e3 / (2.0 * 2f64.sqrt() * 4.0 * 180.0);
    assert!((across - 73.66).abs() < 5e-3, "{across}");
    let tau_par = 100e3 / (2.0 * 4.0 * 240.0);
    let stress = ThroatStress { sigma_perp: across, tau_perp: across, tau_par };
    assert!((welds::directional(&stress, &S235).value - 0.4798).abs() < 5e-5);
}

/// Pairs of welds with a throat of 5 mm on a plate of 10 mm, by hand.
#[test]
fn clause_4_5_3_2_pair_of_welds() {
    let used = |force: PairForce| welds::directional_pair(&force, 10.0, 5.0, &S235).value;
    // two welds across the force carry √(3/2) times the value of the simplified method
    let simplified = 2.0 * welds::simplified(5.0, &S235).value;
    for normal in [simplified, -simplified] {
        let pulled = PairForce { normal, ..PairForce::default() };
        near(used(pulled), (2.0f64 / 3.0).sqrt());
        let across = PairForce { across: normal, ..PairForce::default() };
        near(used(across), (2.0f64 / 3.0).sqrt());
        // and along the welds just that value
        near(used(PairForce { along: normal, ..PairForce::default() }), 1.0);
    }
    // n_w = 1000/2 + 2000/10 = 700, q_w = 300/2 = 150, l/2 = 200 N/mm; √2 a = 7.071 mm:
    // σ⊥ = 550/7.071 = 77.78, τ⊥ = 850/7.071 = 120.21, τ∥ = 40 MPa,
    // √(77.78² + 3 (120.21² + 40²)) = 232.8 MPa of 360
    let all = PairForce { normal: 1000.0, across: 300.0, along: 400.0, couple: 2000.0 };
    let worked = welds::directional_pair(&all, 10.0, 5.0, &S235);
    assert!((worked.value - 232.81 / 360.0).abs() < 1e-5, "{}", worked.value);
    assert!((worked.step("σ_eq").expect("a step") - 232.81).abs() < 5e-3);
    for sign in 0..16 {
        let of = |bit: i32, x: f64| if sign >> bit & 1 == 1 { -x } else { x };
        let turned = PairForce {
            normal: of(0, all.normal),
            across: of(1, all.across),
            along: of(2, all.along),
            couple: of(3, all.couple),
        };
        near(used(turned), worked.value);
    }
    // σ⊥ decides where β_w f_u is large: n_w = q_w = 648 N/mm, σ⊥ = 183.3, τ⊥ = 0 of 0.9 · 360/1.25
    let soft = WeldedSteel { beta_w: 0.1, ..S235 };
    let both = PairForce { normal: 1296.0, across: 1296.0, ..PairForce::default() };
    let sigma = 1296.0 / (2f64.sqrt() * 5.0);
    near(welds::directional_pair(&both, 10.0, 5.0, &soft).value, sigma / 259.2);
}

/// The stresses on the throat carry the force: their squares sum to that of the force per area.
#[test]
fn clause_4_5_3_2_stresses_on_the_throat() {
    let [s, t, p] = welds::throat_stresses([300.0, -200.0, 100.0], 4.0);
    near(s * s + t * t + p * p, (9e4 + 4e4 + 1e4) / 16.0);
    assert_eq!(welds::throat_stresses([300.0, 300.0, 0.0], 4.0)[1], 0.0);
}

#[test]
fn clause_4_5_3_3_simplified_method() {
    near(welds::simplified(5.0, &S235).value, 5.0 * 360.0 / 3f64.sqrt());
    // never above the directional method: in transverse tension √(3/2) below it
    let throat = 4.0;
    let force = welds::simplified(throat, &S235).value;
    let s = force / (throat * 2f64.sqrt());
    let stress = ThroatStress { sigma_perp: s, tau_perp: s, tau_par: 0.0 };
    near(welds::directional(&stress, &S235).value, (2.0f64 / 3.0).sqrt());
    // 4 · 360/(√2 · 0.8 · 1.25) = 1018.2 N/mm
    assert!((welds::transverse(throat, &S235).value - 1018.2).abs() < 0.05);
}

/// a ≥ 0.46 t (S235), 0.48 t (S275), 0.55 t (S355 with f_u = 510 MPa; 0.58 t with 490 MPa, as the
/// catalogue has it).
#[test]
fn clause_4_5_3_2_full_strength_double_fillet() {
    let table = [
        (235.0, 360.0, 0.8, "0.46"),
        (275.0, 430.0, 0.85, "0.48"),
        (355.0, 510.0, 0.9, "0.55"),
        (355.0, 490.0, 0.9, "0.58"),
    ];
    for (fy, fu, beta_w, ratio) in table {
        let steel = WeldedSteel { fu: Nominal::new(fu), beta_w, gamma_m2: 1.25 };
        let a = welds::full_strength_throat(10.0, Nominal::new(fy), 1.0, &steel).value;
        assert_eq!(format!("{:.2}", a / 10.0), ratio);
        // and the directional method finds such a weld just used up
        let s = 10.0 * fy / (2.0 * 2f64.sqrt() * a);
        near(
            welds::directional(&ThroatStress { sigma_perp: s, tau_perp: s, tau_par: 0.0 }, &steel)
                .value,
            1.0,
        );
    }
}

#[test]
fn clauses_4_5_1_and_4_5_2_sizes_of_welds() {
    let statuses = |a, l| welds::least_size(Part::BeamWeb, a, l).map(|c| c.status);
    assert_eq!(statuses(3.0, 30.0), [Status::Ok, Status::Ok]);
    assert_eq!(statuses(2.9, 30.0), [Status::Failed, Status::Ok]);
    assert_eq!(statuses(6.0, 35.9), [Status::Ok, Status::Failed]);
}

/// M20: L_j = 300 mm reduces nothing, 500 mm to 1 − 200/4000, 1300 mm and more to 0.75.
#[test]
fn clause_3_8_long_joints() {
    for (length, want) in [(250.0, 1.0), (300.0, 1.0), (500.0, 0.95), (1300.0, 0.75), (9e3, 0.75)] {
        near(long_joint(length, 20.0).value, want);
    }
}

/// Two blocks of a plate of 10 mm, S275 (430 MPa): 30 mm in tension are 2 · 430 · 300/1.25 N =
/// 206.4 kN, 200 mm in shear 2 · 275 · 2000/√3 N = 635.1 kN. A face that the holes use up adds
/// nothing.
#[test]
fn clause_3_10_2_block_tearing() {
    let of = |tension: f64, shear: f64| {
        let blocks = Blocks { count: 2.0, tension, shear, thickness: 10.0, fy: 275.0, fu: 430.0 };
        blocks.resistance(1.0, 1.25).value
    };
    printed("both faces", of(30.0, 200.0), "841.5");
    printed("tension", of(30.0, -5.0), "206.4");
    printed("shear", of(-1.0, 200.0), "635.1");
}
