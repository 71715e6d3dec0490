//! Concrete under a base plate: EN 1992-1-1:2004 3.1.6 and 6.7, EN 1993-1-8:2005 6.2.5.

use crate::check::{CheckId, within};
use crate::formula::{Number, Traced};
use crate::unit::Unit;
use crate::worked::Worked;
use bracket_joint::assembly::Foundation;
use bracket_joint::spec::code::ConcreteFactors;

/// Foundation joint material coefficient β_j, EN 1993-1-8:2005 6.2.5(7).
pub const BETA_J: f64 = 2.0 / 3.0;
/// Largest concentration factor, EN 1992-1-1:2004 6.7(2).
const LARGEST_FACTOR: f64 = 3.0;
/// Least strength of grout over that of the concrete, EN 1993-1-8:2005 6.2.5(7).
const LEAST_GROUT: f64 = 0.2;
/// Largest thickness of grout over the smaller width of the plate, EN 1993-1-8:2005 6.2.5(7).
const THICKEST_GROUT: f64 = 0.2;
/// Thickness above which grout is as strong as the concrete \[mm\], EN 1993-1-8:2005 6.2.5(7).
const THICK_GROUT: f64 = 50.0;

/// Design strength of concrete, `f_cd = α_cc f_ck/γ_c` \[MPa\].
///
/// # Source
/// EN 1992-1-1:2004 3.1.6(1), formula 3.15.
pub fn f_cd<N: Number>(alpha_cc: N, f_ck: N, gamma_c: N) -> N {
    alpha_cc * f_ck / gamma_c
}

/// Design bearing strength `f_jd = β_j k_j f_cd` \[MPa\].
///
/// # Source
/// EN 1993-1-8:2005 6.2.5(7), formula 6.6, with F_Rdu of EN 1992-1-1:2004 6.7(2).
pub fn f_jd<N: Number>(beta_j: N, k_j: N, f_cd: N) -> N {
    beta_j * k_j * f_cd
}

/// Additional bearing width of a plate, `c = t √(f_y/(3 f_jd γ_M0))` \[mm\].
///
/// # Source
/// EN 1993-1-8:2005 6.2.5(4), formula 6.5.
pub fn additional_width<N: Number>(t: N, f_y: N, f_jd: N, gamma_m0: N) -> N {
    t * (f_y / (N::from(3.0) * f_jd * gamma_m0)).sqrt()
}

/// Concentration factor `k_j = √(A_c1/A_c0)` of a loaded area with the shape of the plate: `1 +
/// 2 e/L` in either direction with the smaller edge distance, `1 + h/max(L)`, at most 3; a plate at
/// the edge of its block has 1.
///
/// # Source
/// EN 1992-1-1:2004 6.7(2), Figure 6.29: similar shape, centres in line, height h ≥ b2 − b1 and
/// d2 − d1.
pub fn k_j<N: Number>(plate: [N; 2], edges: [N; 2], depth: N) -> N {
    let n = N::from;
    let [a, b] = plate;
    let [e_a, e_b] = edges;
    let across = n(1.0) + n(2.0) * e_a / a.clone();
    let along = n(1.0) + n(2.0) * e_b / b.clone();
    (n(1.0) + depth / a.max(b)).min(across).min(along).min(n(LARGEST_FACTOR))
}

/// The smaller edge distance in each direction, not below 0 \[mm\].
fn edges(of: &Foundation) -> [f64; 2] {
    of.edge.map(|[low, high]| low.min(high).max(0.0))
}

/// Why β_j = 2/3 does not hold for the grout; `None` where it does.
///
/// # Source
/// EN 1993-1-8:2005 6.2.5(7).
pub fn grout_fault(of: &Foundation) -> Option<&'static str> {
    if of.grout == 0.0 {
        return None;
    }
    let (grout, concrete) = (of.grout_strength.mpa(), of.f_ck.mpa());
    let width = of.plate[0].min(of.plate[1]);
    if !within(LEAST_GROUT * concrete, grout) {
        Some("the grout is weaker than 0.2 f_ck of the concrete: β_j = 2/3 does not hold")
    } else if !within(of.grout, THICKEST_GROUT * width) {
        Some(
            "the grout is thicker than 0.2 times the smaller width of the plate: β_j = 2/3 does \
             not hold",
        )
    } else if of.grout > THICK_GROUT && !within(concrete, grout) {
        Some(
            "the grout is thicker than 50 mm and weaker than the concrete: β_j = 2/3 does not hold",
        )
    } else {
        None
    }
}

/// f_jd under a base plate \[MPa\], with its derivation. Where β_j = 2/3 does not hold
/// ([`grout_fault`]), no more than the strength of the grout alone; a check says that the code has
/// no value.
///
/// # Source
/// [`f_jd`], [`k_j`], [`f_cd`].
pub fn bearing_strength(of: &Foundation, factors: ConcreteFactors) -> Worked {
    let [alpha, gamma] =
        [("α_cc", factors.alpha_cc), ("γ_c", factors.gamma_c)].map(|(s, v)| Traced::number(s, v));
    let strength = |f: f64, symbols: [&'static str; 2]| {
        let f_ck = Traced::stress(symbols[0], f);
        f_cd(alpha.clone(), f_ck, gamma.clone()).named(symbols[1], Unit::Stress)
    };
    let plate = [("L_x", of.plate[0]), ("L_y", of.plate[1])].map(|(s, v)| Traced::length(s, v));
    let edges = edges(of);
    let edges = [("e_x", edges[0]), ("e_y", edges[1])].map(|(s, v)| Traced::length(s, v));
    let k = k_j(plate, edges, Traced::length("h_b", of.depth)).named("k_j", Unit::Number);
    let f_cd = strength(of.f_ck.mpa(), ["f_ck", "f_cd"]);
    let beta = Traced::number("β_j", BETA_J);
    let value = f_jd(beta, k.clone(), f_cd.clone());
    let (clause, id) = ("EN 1993-1-8:2005 6.2.5(7); EN 1992-1-1:2004 6.7", CheckId::BaseStrength);
    let lines = crate::formula::Derivation::default()
        .then(crate::formula::Formula::new("f_cd", f_cd, Unit::Stress))
        .then(crate::formula::Formula::new("k_j", k, Unit::Number));
    let worked = Worked::of(clause, id, "f_jd", value.clone(), Unit::Stress).after(lines).after(
        "L_x, L_y: sides of the plate; e_x, e_y: its distances to the edges of the block; h_b: \
         depth of the block (EN 1992-1-1, Figure 6.29)",
    );
    match grout_fault(of) {
        None => worked,
        Some(_) => {
            let whole = worked.traced();
            let grout = strength(of.grout_strength.mpa(), ["f_ck,grout", "f_cd,grout"]);
            worked.becomes("f_jd,red", whole.min(grout))
        }
    }
}

/// Secant modulus of concrete, `E_cm = 22 ((f_ck + 8)/10)^0.3` GPa \[MPa\].
///
/// # Source
/// EN 1992-1-1:2004 Table 3.1.
pub fn e_cm<N: Number>(f_ck: N) -> N {
    let n = N::from;
    n(22_000.0) * ((f_ck + n(8.0)) / n(10.0)).powf(n(0.3))
}

/// Resistance of an anchor to shear, `F_2,vb,Rd = α_b f_ub A_s/γ_M2` with α_b = 0.44 − 0.0003 f_yb
/// \[N\]; f_yb from 235 to 640 MPa.
///
/// # Source
/// EN 1993-1-8:2005 6.2.2(7), formula 6.2.
pub fn f_vb_rd<N: Number>(f_yb: N, f_ub: N, a_s: N, gamma_m2: N) -> N {
    let alpha = (N::from(0.44) - N::from(0.0003) * f_yb).named("α_b", Unit::Number);
    alpha * f_ub * a_s / gamma_m2
}

/// Range of f_yb of [`f_vb_rd`] \[MPa\].
pub const ANCHOR_YIELD: [f64; 2] = [235.0, 640.0];
