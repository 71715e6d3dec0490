//! The beam: flange and web in compression, web in tension. EN 1993-1-8:2005 6.2.6.7 and 6.2.6.8.

use super::column_web::{epsilon, shear_area};
use super::joint::Section;
use crate::checks::check::{Unit, Worked, number as n};

/// Depth of a beam above which its web may take no more than a fifth of the compression \[mm\],
/// 6.2.6.7(1).
const DEEP: f64 = 600.0;

/// Class of a cross-section in bending.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Class {
    /// 1 or 2: the plastic moment is reached.
    Plastic,
    /// 3: the outermost fibre yields.
    Elastic,
    /// 4: it buckles before.
    Slender,
}

/// Slenderness of the compressed flange and of the web in bending over ε: c/(t ε).
fn outstands(beam: &Section, fy: f64) -> (f64, f64) {
    let eps = epsilon(fy);
    let flange = (0.5 * (beam.b - beam.tw) - beam.root) / beam.tf;
    (flange / eps, beam.clear_depth() / beam.tw / eps)
}

/// Class of the beam in bending.
///
/// # Source
/// EN 1993-1-1:2005 Table 5.2: flange c/t ≤ 10 ε and web c/t ≤ 83 ε class 2, 14 ε and 124 ε class
/// 3.
pub fn class(beam: &Section, fy: f64) -> Class {
    let (flange, web) = outstands(beam, fy);
    if flange <= 10.0 && web <= 83.0 {
        Class::Plastic
    } else if flange <= 14.0 && web <= 124.0 {
        Class::Elastic
    } else {
        Class::Slender
    }
}

/// V_pl,Rd of the beam \[N\].
///
/// # Source
/// EN 1993-1-1:2005 6.2.6(2) and (3), formula 6.18.
pub fn plastic_shear(beam: &Section, fy: f64, gamma_m0: f64) -> f64 {
    shear_area(beam.area, beam.b, beam.h, beam.tf, beam.tw, beam.r, 0.0) * fy
        / (3f64.sqrt() * gamma_m0)
}

/// Design moment resistance of the beam's cross-section \[N mm\] beside a shear force \[N\]:
/// plastic in classes 1 and 2, elastic in class 3; in class 4 the stress up to which the section is
/// still of class 3.
///
/// # Source
/// EN 1993-1-1:2005 6.2.5, Table 5.2; 5.5.2(9) for class 4: c/t ≤ 14 ε √(f_y/σ) and 124 ε √(f_y/σ);
/// 6.2.8(2) to (5) for V_Ed > 0.5 V_pl,Rd (classes 3 and 4: the whole moment is reduced by 1 − ρ,
/// on the safe side).
pub fn moment_resistance(beam: &Section, fy: f64, shear: f64, gamma_m0: f64) -> Worked {
    let (flange, web) = outstands(beam, fy);
    let class = class(beam, fy);
    let stress = match class {
        Class::Slender => fy * (14.0 / flange).powi(2).min((124.0 / web).powi(2)).min(1.0),
        _ => fy,
    };
    let (symbol, modulus) =
        if class == Class::Plastic { ("W_pl", beam.w_pl) } else { ("W_el", beam.w_el) };
    let whole = modulus * stress / gamma_m0;
    let strength = if class == Class::Slender { "σ" } else { "f_y" };
    let mut formula = format!(
        "M_c,Rd = {symbol} {strength}/γ_M0 = {} · {}/{}",
        n(modulus),
        n(stress),
        n(gamma_m0)
    );
    let ratio = shear / plastic_shear(beam, fy, gamma_m0);
    let mut value = whole;
    if ratio > 0.5 {
        let rho = (2.0 * ratio - 1.0).powi(2).min(1.0);
        let web_area = (beam.h - 2.0 * beam.tf) * beam.tw;
        value = match class {
            Class::Plastic => {
                let reduced = modulus - rho * web_area * web_area / (4.0 * beam.tw);
                formula = format!(
                    "M_V,Rd = (W_pl − ρ A_w²/(4 t_w)) f_y/γ_M0 = ({} − {} · {}²/(4 · {})) · {}/{}",
                    n(modulus),
                    n(rho),
                    n(web_area),
                    n(beam.tw),
                    n(fy),
                    n(gamma_m0)
                );
                (reduced * fy / gamma_m0).clamp(0.0, whole)
            }
            Class::Elastic | Class::Slender => {
                formula += &format!(" · (1 − ρ = {})", n(1.0 - rho));
                whole * (1.0 - rho)
            }
        };
    }
    let mut worked = Worked::new(
        "EN 1993-1-1:2005 6.2.5",
        "moment resistance of the beam",
        value,
        Unit::Moment,
        formula,
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
/// `F_c,fb,Rd = M_c,Rd/(h − t_fb)`; above 600 mm of depth the web's share is 20 % at most: F ≤ b
/// t_f f_y/(0.8 γ_M0).
///
/// # Source
/// EN 1993-1-8:2005 6.2.6.7(1), formula 6.21.
pub fn flange_compression(beam: &Section, moment: f64, fy: f64, gamma_m0: f64) -> Worked {
    let lever = beam.h - beam.tf;
    let whole = moment / lever;
    let limit =
        if beam.h > DEEP { beam.b * beam.tf * fy / (0.8 * gamma_m0) } else { f64::INFINITY };
    let formula = if limit < whole {
        format!(
            "F_c,fb,Rd = b t_f f_y/(0.8 γ_M0) = {} · {} · {}/(0.8 · {})",
            n(beam.b),
            n(beam.tf),
            n(fy),
            n(gamma_m0)
        )
    } else {
        format!(
            "F_c,fb,Rd = M_c,Rd/(h − t_fb) = {}/({} − {})",
            Unit::Moment.show(moment),
            n(beam.h),
            n(beam.tf)
        )
    };
    let title = "beam flange and web in compression";
    Worked::new("EN 1993-1-8:2005 6.2.6.7", title, whole.min(limit), Unit::Force, formula)
}

/// Design resistance of the beam web in tension \[N\]; `effective_width` is ℓ_eff of the T-stub of
/// the end plate. Not for a row outside the tension flange.
///
/// `F_t,wb,Rd = b_eff t_wb f_y/γ_M0`.
///
/// # Source
/// EN 1993-1-8:2005 6.2.6.8(1), formula 6.22.
pub fn web_tension(effective_width: f64, web: f64, fy: f64, gamma_m0: f64) -> Worked {
    let value = effective_width * web * fy / gamma_m0;
    let formula = format!(
        "F_t,wb,Rd = b_eff t_wb f_y/γ_M0 = {} · {} · {}/{}",
        n(effective_width),
        n(web),
        n(fy),
        n(gamma_m0)
    );
    Worked::new("EN 1993-1-8:2005 6.2.6.8", "beam web in tension", value, Unit::Force, formula)
        .with("b_eff", effective_width, Unit::Length)
}
