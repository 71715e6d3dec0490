//! The beam: flange and web in compression, web in tension. EN 1993-1-8:2005 6.2.6.7 and 6.2.6.8.

use super::joint::Beam;
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
    bending(beam, &Plates { of: slenderness(beam), panel: None }, fy, shear, gamma_m0)
}

/// Slenderness of the plates of a beam's end in bending.
struct Plates {
    /// c/t of the flange, and of the web over its whole depth.
    of: Slenderness,
    /// c/t of the web between a flange and one that supports it between them.
    panel: Option<f64>,
}

impl Plates {
    /// Those of the end of a beam.
    fn at_end(b: &Beam) -> Self {
        let of = slenderness(&b.section);
        match b.sloped.and_then(|s| s.haunch) {
            Some(h) => Self {
                of: Slenderness { flange: h.outstand, ..of },
                panel: Some(h.panel / b.section.tw),
            },
            None => Self { of, panel: None },
        }
    }

    /// Class: the web counts with the better of its whole depth in bending and of a panel in
    /// uniform compression.
    fn class(&self, s: &Section, fy: f64) -> Class {
        let Some(panel) = self.panel else { return self.of.class(s, fy, 0.0) };
        let eps = epsilon(fy);
        let web = |bent: f64, pressed: f64| {
            within(self.of.web, bent * eps) || within(panel, pressed * eps)
        };
        if within(self.of.flange, 10.0 * eps) && web(83.0, 38.0) {
            Class::Plastic
        } else if within(self.of.flange, 14.0 * eps) && web(124.0, 42.0) {
            Class::Elastic
        } else {
            Class::Slender
        }
    }

    /// Part of f_y up to which the plates are of class 3, at most 1.
    fn elastic_part(&self, fy: f64) -> f64 {
        let eps = epsilon(fy);
        let bent = (124.0 / (self.of.web / eps)).powi(2);
        let web = self.panel.map_or(bent, |panel| bent.max((42.0 / (panel / eps)).powi(2)));
        (14.0 / (self.of.flange / eps)).powi(2).min(web).min(1.0)
    }
}

/// Class of the end of a beam in pure bending; of a haunched end with the web supported by the
/// beam's own flange between the two webs.
///
/// # Source
/// EN 1993-1-1:2005 Table 5.2. The clear depth of a panel is at most the larger one of the beam's
/// web and of that of the haunch; a panel is taken as compressed uniformly.
pub fn end_class(b: &Beam) -> Class {
    Plates::at_end(b).class(&b.section, b.fy)
}

/// Design resistance M_c,Rd of the end of a beam about the middle of its depth at the plate \[N
/// mm\]: that of the beam, or of the equivalent section of a haunched end, see [`bending_6_2_8`].
pub fn end_bending(b: &Beam, gamma_m0: f64) -> Worked {
    let worked = bending(&b.section, &Plates::at_end(b), b.fy, b.shear, gamma_m0);
    let haunched = b.sloped.is_some_and(|s| s.haunch.is_some());
    if haunched { worked.after(EQUIVALENT) } else { worked }
}

/// What the section of a haunched end is.
pub const EQUIVALENT: &str = "equivalent section at the plate: two flanges of the smaller width \
                              and of the smaller t cos of their slope, the thinner web over the \
                              whole depth, the lower f_y, no root fillets; the web counts by its \
                              whole depth in bending or by the deeper of its two panels, which \
                              the flange between them parts, in compression";

fn bending(beam: &Section, plates: &Plates, fy: f64, shear: f64, gamma_m0: f64) -> Worked {
    let eps = epsilon(fy);
    let (flange, web) = (plates.of.flange / eps, plates.of.web / eps);
    let class = plates.class(beam, fy);
    let stress = match class {
        Class::Slender => fy * plates.elastic_part(fy),
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

/// Design resistance of flange and web of the end of a beam in compression, normal to the plate
/// \[N\].
///
/// `F_c,fb,Rd = M_c,Rd/z_f`, z_f between the middles of the flanges along the plate; above 600 mm
/// of depth the web contributes at most 20 %: F ≤ b t_n f_y/(0.8 γ_M0), t_n = t cos of the slope of
/// the flange.
///
/// # Source
/// EN 1993-1-8:2005 6.2.6.7(1), formula 6.21; the component normal to the plate of the force of an
/// inclined flange.
pub fn end_compression(b: &Beam, moment: f64, gamma_m0: f64) -> Worked {
    if b.sloped.is_none() {
        return flange_compression(&b.section, moment, b.fy, gamma_m0);
    }
    let (lever, t) = (b.lever(), b.normal_thickness());
    let moment = Traced::symbol("M_c,Rd", moment, Unit::Moment);
    let mut force = moment.clone() / Traced::length("z_f", lever);
    if !within(b.depth(), DEEP) {
        let limit = Traced::length("b", b.section.b)
            * Traced::length("t_n", t)
            * Traced::stress("f_y", b.fy)
            / (Traced::from(0.8) * Traced::number("γ_M0", gamma_m0));
        if limit.value() < force.value() {
            force = limit;
        }
    }
    let id = CheckId::BeamFlangeCompression;
    Worked::of("EN 1993-1-8:2005 6.2.6.7", id, "F_c,fb,Rd", force, Unit::Force)
        .after("t_n is t cos of the slope of the flange, z_f lies along the plate")
        .with("M_c,Rd", moment.value(), Unit::Moment)
        .with("z_f", lever, Unit::Length)
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
