//! The zone of the column web under a compressed flange of the beam, as far as the column reaches:
//! EN 1993-1-8:2005 6.2.6.2.

use super::column_web::{CompressedWeb, compressed_thickness, shear_interaction};
use super::joint::{Column, EndPlateJoint};
use crate::check::{CheckId, Unit, within};
use crate::eurocode::section::epsilon;
use crate::formula::Traced;
use crate::worked::Worked;
use bracket_joint::assembly::Way;
use std::f64::consts::{PI, SQRT_2};

/// Web beside a stiffener that acts with it, over ε t_w, EN 1993-1-5:2006 9.1(2).
const WEB_OF_STIFFENER: f64 = 15.0;

/// Effective width of the web in compression under a bolted end plate and a rolled column that
/// continues \[mm\].
///
/// `b_eff = t_fb + 2√2 a_p + 5 (t_fc + s) + s_p`, s = r_c; s_p = 2 t_p where the plate reaches far
/// enough beyond the weld of the compressed flange, t_p at least (spread at 45° through the plate).
/// t_fb and the legs of the welds are those along the plate. The overhang of the lower edge counts
/// for both flanges.
///
/// # Source
/// EN 1993-1-8:2005 6.2.6.2(1), formula 6.11.
pub fn compressed_width(joint: &EndPlateJoint, c: &Column, flange: Way) -> f64 {
    let (b, plate) = (&joint.beam, &joint.plate);
    // the plate beyond the outer face of the compressed flange
    let overhang = -0.5 * b.depth() - plate.bottom;
    let [outer, inner] = [true, false].map(|outer| b.leg(flange, outer) * b.flange_throat);
    // beside the lower edge no flange has a longer leg
    let spread =
        plate.thickness + (overhang - SQRT_2 * b.flange_throat).clamp(0.0, plate.thickness);
    b.along(flange) + (outer + inner) + 5.0 * (c.section.tf + c.section.root) + spread
}

/// A zone of the column web in compression, `width` \[mm\].
pub(super) fn zone(
    joint: &EndPlateJoint,
    c: &Column,
    width: f64,
    shear_area: f64,
) -> CompressedWeb {
    let s = &c.section;
    CompressedWeb {
        effective_width: width,
        web: compressed_thickness(s.tw, c.doublers),
        clear_depth: s.clear_depth(),
        fy: c.fy,
        young: joint.young,
        omega: shear_interaction(joint.beta, width, s.tw, shear_area),
        longitudinal: c.longitudinal,
        gamma_m0: joint.gamma_m0,
        gamma_m1: joint.gamma_m1,
    }
}

/// A pair of stiffeners level with a flange of the beam. Lengths in mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StiffenerPair {
    /// Width on each side of the web.
    pub outstand: f64,
    /// Thickness.
    pub thickness: f64,
    /// Web above and below the pair: up to the end of the column, or halfway to the other pair.
    pub beside: [f64; 2],
}

/// The zone under one flange of the beam.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CompressedZone {
    /// The web alone, cut where the column ends.
    pub web: CompressedWeb,
    /// Its stiffeners.
    pub stiffeners: Option<StiffenerPair>,
}

impl CompressedZone {
    /// The zone of the upper flange (`Way::Up`) or of the lower one; `shear_area` A_vc \[mm²\].
    pub fn new(joint: &EndPlateJoint, c: &Column, flange: Way, shear_area: f64) -> Self {
        let apart = joint.beam.lever();
        let half = 0.5 * compressed_width(joint, c, flange);
        let width = half + beyond(joint, c, flange, half);
        let stiffeners = (c.stiffener > 0.0).then(|| StiffenerPair {
            outstand: 0.5 * (c.section.b - c.section.tw),
            thickness: c.stiffener,
            beside: [
                (beyond(joint, c, flange, f64::INFINITY) - 0.5 * c.stiffener).max(0.0),
                (0.5 * (apart - c.stiffener)).max(0.0),
            ],
        });
        Self { web: zone(joint, c, width, shear_area), stiffeners }
    }

    /// Resistance, never less than that of the web alone.
    pub fn resistance(&self) -> Worked {
        let bare = self.web.resistance();
        match self.stiffeners.map(|pair| self.web.stiffened(&pair)) {
            Some(cross) if cross.value > bare.value => cross,
            _ => bare,
        }
    }
}

/// Length of web beyond the middle of a flange of the beam, of a `wanted` one \[mm\].
pub(super) fn beyond(joint: &EndPlateJoint, c: &Column, flange: Way, wanted: f64) -> f64 {
    c.ends().reach(joint.beam.middle(flange), flange, wanted)
}

impl CompressedWeb {
    /// Design resistance of a pair of transverse stiffeners with the web beside them: 15 ε t_w on
    /// either side, as far as there is web, buckling out of the plane of the web over 0.75 of its
    /// depth by curve c.
    ///
    /// # Source
    /// EN 1993-1-8:2005 6.2.6.2(4); EN 1993-1-5:2006 9.1(2) and 9.4; EN 1993-1-1:2005 6.3.1.
    pub fn stiffened(&self, pair: &StiffenerPair) -> Worked {
        let most = WEB_OF_STIFFENER * epsilon(self.fy) * self.web;
        let beside: f64 = pair.beside.iter().map(|w| w.min(most)).sum();
        let area = 2.0 * pair.outstand * pair.thickness + (beside + pair.thickness) * self.web;
        let width = 2.0 * pair.outstand + self.web;
        let inertia = pair.thickness * width.powi(3) / 12.0 + beside * self.web.powi(3) / 12.0;
        let radius = (inertia / area).sqrt();
        let lambda1 = PI * (self.young / self.fy).sqrt();
        let slenderness = 0.75 * self.clear_depth / (radius * lambda1);
        let phi = 0.5 * (1.0 + 0.49 * (slenderness - 0.2) + slenderness * slenderness);
        let stocky = within(slenderness, 0.2);
        let chi = if stocky {
            1.0
        } else {
            (1.0 / (phi + (phi * phi - slenderness * slenderness).sqrt())).min(1.0)
        };
        let gamma = match stocky {
            true => Traced::number("γ_M0", self.gamma_m0),
            false => Traced::number("γ_M1", self.gamma_m1),
        };
        let force =
            Traced::number("χ", chi) * Traced::area("A_eff", area) * Traced::stress("f_y", self.fy)
                / gamma;
        Worked::of(
            "EN 1993-1-8:2005 6.2.6.2(4), EN 1993-1-5:2006 9.4",
            CheckId::StiffenedWebCompression,
            "F_c,wc,Rd",
            force,
            Unit::Force,
        )
        .with("A_eff", area, Unit::Area)
        .with("web beside the stiffeners", beside, Unit::Length)
        .with("λ̄", slenderness, Unit::Number)
        .with("χ", chi, Unit::Number)
    }
}
