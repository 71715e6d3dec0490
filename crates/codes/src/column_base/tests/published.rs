//! Published bases.

use super::fixture::base;
use crate::column_base::compression::whole;
use crate::column_base::effective_area::ring;
use crate::column_base::moment_resistance;
use crate::eurocode::concrete::{additional_width, f_cd, f_jd};
use crate::eurocode::welds::{WeldedSteel, simplified};
use bracket_joint::strength::Nominal;

fn near(got: f64, want: f64, part: f64) {
    assert!((got / want - 1.0).abs() <= part, "{got} is not {want}");
}

/// Wald et al., JRC 2014: f_jd 13.3, c 43.7, A_eff 66 722 mm², N_Rd 887 kN.
#[test]
fn he200b_in_compression() {
    let worked = whole(&base());
    let step = |symbol| worked.step(symbol).expect("a step");
    near(step("f_jd"), 13.3, 0.01);
    near(step("c"), 43.7, 0.01);
    near(step("A_eff"), 66_722.0, 0.01);
    near(worked.value, 887e3, 0.01);
}

/// SCI P358 example 4: CHS273x5, plate 400x400x20 of S275, C30, α_cc 0.85, β_j k_j = 1: f_jd 17,
/// N_Rd 1376 kN.
#[test]
fn circular_hollow_section() {
    let strength = f_jd(1.0, 1.0, f_cd(0.85, 30.0, 1.5));
    near(strength, 17.0, 1e-12);
    let c = additional_width(20.0, 265.0, strength, 1.0);
    let [outer, inner] = ring(273.0, 5.0, [400.0; 2], c);
    let area = std::f64::consts::FRAC_PI_4 * (outer * outer - inner * inner);
    near(strength * area, 1376e3, 0.01);
}

/// Steel Buildings in Europe, Part 5, 6.5: C30/37 with β_j k_j = 1 gives f_jd 20; t 45 of f_y 255
/// gives c 93; a 5.6 mm weld of S275 has 1248 N/mm.
#[test]
fn steel_buildings_in_europe() {
    let strength = f_jd(1.0, 1.0, f_cd(1.0, 30.0, 1.5));
    near(strength, 20.0, 1e-12);
    near(additional_width(45.0, 255.0, strength, 1.0), 93.0, 0.01);
    let steel = WeldedSteel { fu: Nominal::new(410.0), beta_w: 0.85, gamma_m2: 1.25 };
    near(simplified(5.6, &steel).value, 1248.0, 0.01);
}

/// HE200B on a plate of 30 mm and C16/20 carries about 110 kNm beside 500 kN: a rough check, as the
/// anchors of the source are not known here.
#[test]
fn moment_beside_compression() {
    let mut e = base();
    e.thickness = 30.0;
    e.foundation.f_ck = Nominal::new(16.0);
    let moment = moment_resistance(&e, -500e3, 1.0).expect("a moment");
    assert!((70e6..150e6).contains(&moment), "{moment}");
}
