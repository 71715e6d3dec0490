//! The beam: flange and web in compression, web in tension. EN 1993-1-8:2005 6.2.6.7 and 6.2.6.8.

use crate::check::{CheckId, Unit, within};
use crate::eurocode::i_section::Section;
use crate::eurocode::section::{
    Class, Slenderness, epsilon, modulus_beside_shear, shear_reduction,
};
use crate::eurocode::yielding::plastic_shear;
use crate::formula::{Number, Traced};
use crate::worked::Worked;

/// Depth of a beam above which its web may contribute at most a fifth of the compression \[mm\],
/// 6.2.6.7(1).
const DEEP: f64 = 600.0;

/// Slenderness of the beam for the component method: the outstand of the flange counts from the
/// root radius of the geometry.
pub fn slenderness(beam: &Section) -> Slenderness {
    Slenderness::new(beam, beam.root)
}

/// Class of the beam in pure bending.
///
/// # Source
/// EN 1993-1-1:2005 Table 5.2.
pub fn class(beam: &Section, fy: f64) -> Class {
    slenderness(beam).class(beam, fy, 0.0)
}

/// Design resistance M_c,Rd of the beam to bending beside a shear force \[N\], without axial force
/// \[N mm\]: plastic in classes 1 and 2, elastic in class 3; in class 4 with the stress up to which
/// the section is still of class 3.
///
/// This is M_c,Rd of the component beam flange in compression. The check of the beam itself, with
/// its axial force, is `eurocode::section::CrossSection::bending_6_2_10`. Here ρ is limited to 1.
///
/// # Source
/// EN 1993-1-1:2005 6.2.5, Table 5.2; 5.5.2(9) for class 4: c/t ≤ 14 ε √(f_y/σ) and 124 ε √(f_y/σ);
/// 6.2.8(2) to (5) for V_Ed > 0.5 V_pl,Rd (classes 3 and 4: the whole moment is reduced by 1 − ρ,
/// on the safe side).
pub fn bending_6_2_8(beam: &Section, fy: f64, shear: f64, gamma_m0: f64) -> Worked {
    let (c, eps) = (slenderness(beam), epsilon(fy));
    let (flange, web) = (c.flange / eps, c.web / eps);
    let class = class(beam, fy);
    let stress = match class {
        Class::Slender => fy * (14.0 / flange).powi(2).min((124.0 / web).powi(2)).min(1.0),
        _ => fy,
    };
    let modulus = match class {
        Class::Plastic => Traced::number("W_pl", beam.w_pl),
        Class::Elastic | Class::Slender => Traced::number("W_el", beam.w_el),
    };
    let strength = Traced::stress(if class == Class::Slender { "σ" } else { "f_y" }, stress);
    let gamma = Traced::number("γ_M0", gamma_m0);
    let ratio = shear / plastic_shear(beam.shear_area(), fy, gamma_m0);
    let rho = Traced::number("ρ", shear_reduction(ratio).min(1.0));
    let (symbol, moment) = match class {
        Class::Plastic if ratio > 0.5 => {
            let web = Traced::area("A_w", beam.web_depth() * beam.tw);
            let modulus = modulus_beside_shear(modulus, rho, web, Traced::length("t_w", beam.tw));
            let left = modulus * strength / gamma;
            // a web that is more than the section leaves nothing
            ("M_V,Rd", if left.value() < 0.0 { left.max(Traced::from(0.0)) } else { left })
        }
        Class::Elastic | Class::Slender if ratio > 0.5 => {
            ("M_c,Rd", modulus * strength / gamma * (Traced::from(1.0) - rho))
        }
        _ => ("M_c,Rd", modulus * strength / gamma),
    };
    let mut worked = Worked::of(
        "EN 1993-1-1:2005 6.2.5",
        CheckId::BeamMomentResistance,
        symbol,
        moment,
        Unit::Moment,
    )
    .with("c/(t ε) of the flange", flange, Unit::Number)
    .with("c/(t ε) of the web", web, Unit::Number);
    if shear > 0.0 {
        worked = worked.with("V_Ed/V_pl,Rd", ratio, Unit::Number);
    }
    worked
}

/// Design resistance of flange and web of the beam in compression \[N\].
///
/// `F_c,fb,Rd = M_c,Rd/(h − t_fb)`; above 600 mm of depth the web contributes at most 20 %: F ≤ b
/// t_f f_y/(0.8 γ_M0).
///
/// # Source
/// EN 1993-1-8:2005 6.2.6.7(1), formula 6.21.
pub fn flange_compression(beam: &Section, moment: f64, fy: f64, gamma_m0: f64) -> Worked {
    let (h, tf) = (Traced::length("h", beam.h), Traced::length("t_fb", beam.tf));
    let lever = beam.h - beam.tf;
    let mut force = Traced::symbol("M_c,Rd", moment, Unit::Moment) / (h - tf.clone());
    if !within(beam.h, DEEP) {
        let limit = Traced::length("b", beam.b) * tf * Traced::stress("f_y", fy)
            / (Traced::from(0.8) * Traced::number("γ_M0", gamma_m0));
        if limit.value() < force.value() {
            force = limit;
        }
    }
    let id = CheckId::BeamFlangeCompression;
    Worked::of("EN 1993-1-8:2005 6.2.6.7", id, "F_c,fb,Rd", force, Unit::Force)
        .with("M_c,Rd", moment, Unit::Moment)
        .with("h − t_fb", lever, Unit::Length)
}

/// Design resistance of the beam web in tension \[N\]; `effective_width` is ℓ_eff of the T-stub of
/// the end plate. Not for a row outside the tension flange.
///
/// `F_t,wb,Rd = b_eff t_wb f_y/γ_M0`.
///
/// # Source
/// EN 1993-1-8:2005 6.2.6.8(1), formula 6.22.
pub fn web_tension(effective_width: f64, web: f64, fy: f64, gamma_m0: f64) -> Worked {
    let value = Traced::length("b_eff", effective_width)
        * Traced::length("t_wb", web)
        * Traced::stress("f_y", fy)
        / Traced::number("γ_M0", gamma_m0);
    let id = CheckId::BeamWebTension;
    Worked::of("EN 1993-1-8:2005 6.2.6.8", id, "F_t,wb,Rd", value, Unit::Force)
        .with("b_eff", effective_width, Unit::Length)
        .with("t_w", web, Unit::Length)
        .with("f_y", fy, Unit::Stress)
}
