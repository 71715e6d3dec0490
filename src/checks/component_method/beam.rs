//! The beam: flange and web in compression, web in tension. EN 1993-1-8:2005 6.2.6.7 and 6.2.6.8.

use super::column_web::epsilon;
use super::joint::Section;
use crate::checks::check::{Unit, Worked, number as n};
use crate::checks::error::CheckError;

/// Depth of a beam above which its web may take no more than a fifth of the compression \[mm\], 6.2.6.7(1).
const DEEP: f64 = 600.0;

/// Design moment resistance of the beam's cross-section \[N mm\]: plastic in classes 1 and 2, elastic in class 3.
///
/// # Source
/// EN 1993-1-1:2005 6.2.5, Table 5.2: flange c/t ≤ 10 ε and web c/t ≤ 83 ε plastic, 14 ε and 124 ε elastic.
pub fn moment_resistance(beam: &Section, fy: f64, gamma_m0: f64) -> Result<Worked, CheckError> {
    let eps = epsilon(fy);
    let flange = (0.5 * (beam.b - beam.tw) - beam.r) / beam.tf;
    let web = beam.clear_depth() / beam.tw;
    let (symbol, modulus) = if flange <= 10.0 * eps && web <= 83.0 * eps {
        ("W_pl", beam.w_pl)
    } else if flange <= 14.0 * eps && web <= 124.0 * eps {
        ("W_el", beam.w_el)
    } else {
        return Err(CheckError::NotCovered {
            what: format!("the beam is of class 4: flange c/t = {}, web c/t = {}", n(flange), n(web)),
            clause: "EN 1993-1-8:2005 6.2.6.7(1)",
        });
    };
    let value = modulus * fy / gamma_m0;
    let formula = format!("M_c,Rd = {symbol} f_y/γ_M0 = {} · {}/{}", n(modulus), n(fy), n(gamma_m0));
    Ok(Worked::new("EN 1993-1-1:2005 6.2.5", "moment resistance of the beam", value, Unit::Moment, formula)
        .with("c/t of the flange", flange, Unit::Number)
        .with("c/t of the web", web, Unit::Number))
}

/// Design resistance of flange and web of the beam in compression \[N\].
///
/// `F_c,fb,Rd = M_c,Rd/(h − t_fb)`; above 600 mm of depth the web's share is 20 % at most: F ≤ b t_f f_y/(0.8 γ_M0).
///
/// # Source
/// EN 1993-1-8:2005 6.2.6.7(1), formula 6.21.
pub fn flange_compression(beam: &Section, moment: f64, fy: f64, gamma_m0: f64) -> Worked {
    let lever = beam.h - beam.tf;
    let whole = moment / lever;
    let limit = if beam.h > DEEP { beam.b * beam.tf * fy / (0.8 * gamma_m0) } else { f64::INFINITY };
    let formula = if limit < whole {
        format!("F_c,fb,Rd = b t_f f_y/(0.8 γ_M0) = {} · {} · {}/(0.8 · {})", n(beam.b), n(beam.tf), n(fy), n(gamma_m0))
    } else {
        format!("F_c,fb,Rd = M_c,Rd/(h − t_fb) = {}/({} − {})", Unit::Moment.show(moment), n(beam.h), n(beam.tf))
    };
    let title = "beam flange and web in compression";
    Worked::new("EN 1993-1-8:2005 6.2.6.7", title, whole.min(limit), Unit::Force, formula)
}

/// Design resistance of the beam web in tension \[N\]; `effective_width` is ℓ_eff of the T-stub of the end plate. Not for a row
/// outside the tension flange.
///
/// `F_t,wb,Rd = b_eff t_wb f_y/γ_M0`.
///
/// # Source
/// EN 1993-1-8:2005 6.2.6.8(1), formula 6.22.
pub fn web_tension(effective_width: f64, web: f64, fy: f64, gamma_m0: f64) -> Worked {
    let value = effective_width * web * fy / gamma_m0;
    let formula =
        format!("F_t,wb,Rd = b_eff t_wb f_y/γ_M0 = {} · {} · {}/{}", n(effective_width), n(web), n(fy), n(gamma_m0));
    Worked::new("EN 1993-1-8:2005 6.2.6.8", "beam web in tension", value, Unit::Force, formula).with(
        "b_eff",
        effective_width,
        Unit::Length,
    )
}
