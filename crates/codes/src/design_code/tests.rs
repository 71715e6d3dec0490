//! Tests of the design code: strengths by hand, factors of a spec, and notes on its grades.

use super::{DesignCode, build};
use crate::eurocode::bolts::tension_resistance;
use bracket_base::diag::Diagnostics;
use bracket_base::yaml;
use bracket_joint::assembly::assembly::{Grip, Ply, Room};
use bracket_joint::assembly::{Facts, Joint};
use bracket_joint::catalog::{BoltSize, Catalog};
use bracket_joint::spec::ConnectionSpec;
use bracket_joint::spec::code::{ConcreteFactors, PartialFactors};
use bracket_joint::strength::{
    BoltShank, Design, DesignStrengths, Nominal, NominalStrength, WeldSteel,
};
use std::f64::consts::PI;
use std::path::Path;

const PAPER: &str = include_str!("../../../../examples/paper_joint/joint.yaml");

fn joint(text: &str) -> Result<Joint, Diagnostics> {
    let spec = yaml::parse::<ConnectionSpec>(text, Path::new("joint.yaml"))?;
    build(&spec, Path::new("."), &Catalog::builtin().expect("the shipped catalogue is sound"))
}

fn ok(text: &str) -> Joint {
    joint(text).unwrap_or_else(|faults| panic!("{faults:#?}"))
}

fn code(gamma_m0: f64, gamma_m2: f64) -> DesignCode {
    DesignCode::En1993_2005(PartialFactors {
        gamma_m0,
        gamma_m1: 1.0,
        gamma_m2,
        gamma_m3: 1.25,
        gamma_m3_ser: 1.1,
        gamma_m7: 1.1,
        concrete: ConcreteFactors::RECOMMENDED,
    })
}

fn near(a: f64, b: f64) {
    assert!((a / b - 1.0).abs() < 1e-6, "{a} is not {b}");
}

/// S235 at t = 10 mm: 235/1.0 and 235/1.1 = 213.636 MPa.
fn strengths(joint: &Joint) -> DesignStrengths {
    DesignCode::of(joint).strengths(&joint.assembly)
}

#[test]
fn plate_of_s235() {
    let catalog = Catalog::builtin().expect("the shipped catalogue is sound");
    let fy = Nominal::new(catalog.steel("S235").expect("listed").fy(10.0).expect("10 mm"));
    assert_eq!(code(1.0, 1.25).yield_strength(fy).mpa(), 235.0);
    near(code(1.1, 1.25).yield_strength(fy).mpa(), 213.636_364);
}

/// 0.9 f_u/γ_M2: S355 with f_u = 490 has 352.8 MPa, less than 355; S275 with 430 has 309.6, more
/// than 275.
#[test]
fn plates_with_holes() {
    let net =
        |fyd: f64, fu: f64| code(1.0, 1.25).net_strength(Design::new(fyd), Nominal::new(fu)).mpa();
    near(net(355.0, 490.0), 352.8);
    near(net(275.0, 430.0), 275.0);
    // the parts of a joint: S235 keeps its yield strength, the beam has no holes
    let strengths = strengths(&ok(PAPER));
    let parts: Vec<&str> = strengths.perforated.keys().map(String::as_str).collect();
    assert!(parts.contains(&"COLUMN") && parts.contains(&"PLATE_R") && !parts.contains(&"BEAM_R"));
}

/// M20 8.8, A_s = 245 mm²: F_t,Rd = 0.9 · 800 · 245/1.25 = 141 120 N over π 20²/4 = 314.159 mm²
/// is 449.199 MPa. The check of the bolt has the same force.
#[test]
fn shank_of_m20_8_8() {
    let catalog = Catalog::builtin().expect("the shipped catalogue is sound");
    let (size, grade) =
        (catalog.bolt("M20").expect("listed"), catalog.bolt_grade("8.8").expect("listed"));
    let shank = BoltShank {
        fub: Nominal::new(grade.fub),
        stress_area: size.stress_area,
        shank_area: PI * size.d * size.d / 4.0,
    };
    let strength = code(1.0, 1.25).shank_strength(&shank).mpa();
    near(strength, 449.199_0);
    near(strength * 314.159_265, 141_120.0);
    assert_eq!(tension_resistance(size, grade, 1.25).value / shank.shank_area, strength);
}

/// S355 of Table 3.1, f_u = 490, β_w = 0.9: 490/(√3 · 0.9 · 1.25) = 251.468 MPa.
#[test]
fn fillet_weld_of_s355() {
    let steel = WeldSteel { fu: Nominal::new(490.0), beta_w: 0.9 };
    near(code(1.0, 1.25).weld_strength(&steel).mpa(), 251.468_117);
}

#[test]
fn what_has_no_nominal_strength_does_not_yield() {
    assert_eq!(code(1.1, 1.25).strength(&NominalStrength::Unlimited), None);
}

/// Every material and every weld of a joint has its design strength; M18 8.8 yields at F_t,Rd =
/// 0.9 · 800 · 192/1.25 = 110 592 N over π 18²/4.
#[test]
fn a_joint_has_all_its_strengths() {
    let joint = ok(&format!("code: {{gamma_M0: 1.1}}\n{PAPER}"));
    let strengths = strengths(&joint);
    assert!(joint.assembly.materials.keys().eq(strengths.materials.keys()));
    assert_eq!(strengths.welds.len(), joint.assembly.welds.len());
    let of = |name: &str| strengths.materials[name].expect("it yields").mpa();
    near(of("S235"), 213.636_364);
    near(of("bolt_M18_8_8") * PI * 81.0, 110_592.0);
}

#[test]
fn grades_of_astm_are_noted_once() {
    assert!(ok(PAPER).notes.is_empty());
    let text = PAPER.replace("S235", "A992").replace("\"8.8\"", "A325");
    let notes = ok(&text).notes;
    assert_eq!(notes.len(), 1, "{notes:#?}");
    let note = notes[0].to_string();
    assert!(note.starts_with(
        "grades of ASTM standards (A992, bolts A325): the checks are those of EN 1993-1-8"
    ));
    assert!(note.contains("AISC 360 are not in this edition"));
}

/// The code's faults stand among those of the rest of the spec.
#[test]
fn faults_of_the_code_are_told_with_the_others() {
    let text = PAPER.replace("size: M18", "size: M999").replace("mu: 0.3", "mu: 9");
    let faults = joint(&format!("code: {{gamma_M0: 9}}\n{text}")).map(drop).expect_err("three");
    let paths: Vec<&str> = faults.iter().filter_map(|d| d.place.path.as_deref()).collect();
    assert_eq!(paths, ["bolts.size", "code.gamma_M0", "friction.mu"]);
}

fn with_code(code: &str) -> String {
    format!("code: {code}\n{PAPER}")
}

fn origins(code: &str) -> Vec<(String, String, String)> {
    let all = ok(&with_code(code)).resolved.into_iter().filter(|r| r.name.starts_with("code."));
    all.map(|r| (r.name, r.value.to_string(), r.origin.unwrap_or_default().to_string())).collect()
}

#[test]
fn what_is_given_wins_over_the_annex_and_the_annex_over_the_recommended_value() {
    let six = |text: &str| {
        let joint = ok(text);
        let f = &joint.facts.as_ref().and_then(Facts::end_plate).expect("hand checks").factors;
        [f.gamma_m0, f.gamma_m1, f.gamma_m2, f.gamma_m3, f.gamma_m3_ser, f.gamma_m7]
    };
    assert_eq!(six(PAPER), [1.0, 1.0, 1.25, 1.25, 1.1, 1.1]);
    let german = with_code("{annex: Germany, gamma_M2: 1.3}");
    assert_eq!(six(&german), [1.0, 1.1, 1.3, 1.25, 1.1, 1.1]);
    let all = "{gamma_M0: 1.01, gamma_M1: 1.02, gamma_M2: 1.03, gamma_M3: 1.04, gamma_M3_ser: \
               1.05, gamma_M7: 1.06}";
    assert_eq!(six(&with_code(all)), [1.01, 1.02, 1.03, 1.04, 1.05, 1.06]);
}

/// A factor below the recommended one gives a warning; one that an annex raises does not.
#[test]
fn a_factor_below_the_recommended_one_is_a_warning() {
    let notes = |code: &str| ok(&with_code(code)).notes;
    let words =
        "gamma_M2 = 1.1 is below the recommended 1.25: resistances are larger than by EN 1993";
    assert_eq!(notes("{gamma_M2: 1.1}"), [words]);
    assert!(notes("{}").is_empty() && notes("{annex: DE, gamma_M0: 1.0}").is_empty());
}

#[test]
fn every_factor_tells_where_it_comes_from() {
    let plain = origins("{}");
    assert_eq!(plain.len(), 6);
    assert!(plain.iter().all(|(_, _, o)| o.starts_with("recommended (EN 1993-1-")), "{plain:#?}");
    assert_eq!(plain, origins("{annex: recommended}"));
    let norway = origins("{annex: NO, gamma_M1: 1}");
    let told: Vec<&str> = norway.iter().map(|(_, _, o)| o.as_str()).collect();
    assert!(told[0].starts_with("annex NO (NS-EN 1993-1-1/NA; unverified"), "{told:#?}");
    assert_eq!(told[1], "given, in place of annex NO");
    assert!(told[3].ends_with("the row of annex NO leaves it out: check the annex"), "{told:#?}");
}

#[test]
fn wrong_factors_and_annexes_name_place_and_limit() {
    for (code, place, words) in [
        ("{gamma_M1: 0}", "code.gamma_M1", "`code.gamma_M1` is 0; allowed: 0.5 to 3"),
        ("{gamma_M3: -1.25}", "code.gamma_M3", "is -1.25; allowed: 0.5 to 3"),
        ("{gamma_M3_ser: 3.01}", "code.gamma_M3_ser", "is 3.01; allowed: 0.5 to 3"),
        ("{gamma_M7: 11}", "code.gamma_M7", "is 11; allowed: 0.5 to 3"),
        ("{gamma_M7: .nan}", "code.gamma_M7", "finite"),
        ("{gamma_M1: 1,1}", "code.1", "`20.5 mm`, not `20,5 mm`"),
        ("{gamma_M1: '1,1'}", "code.gamma_M1", "expected a number without a unit"),
        ("{gamma_M3ser: 1.1}", "code.gamma_M3ser", "did you mean `gamma_M3_ser`?"),
        ("{gamma_m1: 1.1}", "code.gamma_m1", "did you mean `gamma_M1`?"),
        ("{annex: XX}", "code.annex", "national annex `XX` is not in the catalogue"),
        ("{annex: XX}", "code.annex", "(known: recommended, UK, DE, FR, NL, NO, AT, BE,"),
        ("{annex: recomended}", "code.annex", "did you mean `recommended`?"),
        ("{annex: [DE]}", "code.annex", "expected a text"),
    ] {
        let d = joint(&with_code(code)).map(drop).expect_err(code).into_first();
        let told = format!("{} {}", d.message, d.help.clone().unwrap_or_default());
        assert!(told.contains(words), "{code}: {d:#?}");
        assert_eq!(d.place.path.as_deref(), Some(place), "{code}: {d:#?}");
    }
}

/// M20 8.8 and 10.9 in two plates of S235, t = 12 and 20 mm, with holes of 22 mm: F_t,Rd = 141.12
/// kN, F_v,Rd = 94.08 kN (10.9: α_v = 0.5, 98 kN), B_p,Rd = 0.6 π d_m t f_u/γ_M2, F_b,Rd by
/// direction.
#[test]
fn grip_of_m20() {
    let catalog = Catalog::builtin().expect("the shipped catalogue is sound");
    let size = catalog.bolt("M20").expect("listed");
    let room = Room {
        edge: [[30.0, 120.0], [40.0, 160.0]],
        pitch: [[f64::INFINITY, 90.0], [f64::INFINITY, 70.0]],
        oblique: false,
    };
    let ply = |thickness: f64, room: Option<Room>| Ply {
        part: "P".into(),
        thickness,
        fu: Nominal::new(360.0),
        room,
    };
    let grip = |grade: &str, hole: f64, extent: f64| Grip {
        part: "B".into(),
        axis: [1.0, 0.0, 0.0],
        size: size.clone(),
        grade: catalog.bolt_grade(grade).expect("listed").clone(),
        hole,
        extent,
        anchored: false,
        plies: vec![ply(12.0, Some(room)), ply(20.0, None)],
    };
    let of = |grip: &Grip| code(1.0, 1.25).bolt_limits(grip);
    let found = of(&grip("8.8", 22.0, 100.0));
    near(found.tension, 141_120.0);
    near(found.shear, 94_080.0);
    near(found.shank.mpa(), 94_080.0 * 3f64.sqrt() / 314.159_265);
    let d_m = 0.5 * (size.head_width + size.head_corners);
    let each = 0.6 * PI * d_m.min(nut_diameter(size)) * 360.0 / 1.25;
    near(found.punching[0], each * 12.0);
    near(found.punching[1], each * 20.0);
    // toward −y: e1 = 30: α_b = 30/66, k1: e2 = 40: 2.5, p2 = 70: 1.4 · 70/22 − 1.7 = 2.7545
    let by = |alpha: f64, k1: f64| k1 * alpha * 360.0 * 20.0 * 12.0 / 1.25;
    let [[left, right], [down, up]] = found.bearing[0].expect("a plate");
    near(left, by(30.0 / 66.0, 2.5));
    // toward +y: e1 = 120, but p1 = 90: 90/66 − 1/4 > 1
    near(right, by(1.0, 2.5));
    // along z: e2 = 30: 2.8 · 30/22 − 1.7 = 2.118182; e1 = 40; e1 = 160, p1 = 70: 70/66 − 1/4
    near(down, by(40.0 / 66.0, 2.118_181_818));
    near(up, by(70.0 / 66.0 - 0.25, 2.118_181_818));
    assert_eq!(found.bearing[1], None);
    let strong = of(&grip("10.9", 22.0, 100.0));
    near(strong.shear, 98_000.0);
    near(strong.shank.mpa(), 176_400.0 / 314.159_265);
    // a long joint: β_Lf = 1 − (500 − 300)/4000; an oversize hole, p2 = 70: 1.4 · 70/24 − 1.7; one
    // beyond
    near(of(&grip("8.8", 22.0, 500.0)).shear, 94_080.0 * 0.95);
    let wide = of(&grip("8.8", 24.0, 100.0)).bearing[0].expect("known");
    near(wide[0][0], 0.8 * by(30.0 / 72.0, 2.383_333_333));
    assert_eq!(of(&grip("8.8", 30.0, 100.0)).bearing[0], None);
    // 4.6: a shank that carried F_v,Rd by its yield would be stronger in bending than f_yb
    near(of(&grip("4.6", 22.0, 0.0)).shank.mpa(), 240.0);
}

/// Mean diameter of the nut, its corners in the proportion of the head's.
fn nut_diameter(size: &BoltSize) -> f64 {
    0.5 * size.nut_width * (1.0 + size.head_corners / size.head_width)
}
