//! Where a beam meets its end plate: middles, thicknesses and welds of its flanges along the plate.

use super::joint::Beam;
use bracket_joint::assembly::Way;
use std::f64::consts::{FRAC_PI_2, SQRT_2};

impl Beam {
    /// Depth at the plate, along it \[mm\].
    pub fn depth(&self) -> f64 {
        self.sloped.map_or(self.section.h, |s| s.depth)
    }

    /// Thickness of a flange along the plate \[mm\].
    pub fn along(&self, flange: Way) -> f64 {
        self.sloped.map_or(self.section.tf, |s| s.flange(flange).along())
    }

    /// z of the middle of a flange at the plate \[mm\]: where it is compressed, the centre of
    /// compression.
    ///
    /// # Source
    /// EN 1993-1-8:2005 figure 6.15; (c) for a haunch.
    pub fn middle(&self, flange: Way) -> f64 {
        let level = 0.5 * (self.depth() - self.along(flange));
        if flange == Way::Up { level } else { -level }
    }

    /// Distance of the middles of the two flanges along the plate \[mm\].
    pub fn lever(&self) -> f64 {
        self.middle(Way::Up) - self.middle(Way::Down)
    }

    /// Width of the narrower flange \[mm\].
    pub fn least_width(&self) -> f64 {
        self.sloped.map_or(self.section.b, |s| s.upper.width.min(s.lower.width))
    }

    /// Thickness of a flange whose product with width and f_y is its force normal to the plate: t
    /// cos of its slope, the smaller one of a haunched end \[mm\].
    pub fn normal_thickness(&self) -> f64 {
        match &self.sloped {
            Some(s) if s.haunch.is_none() => self.section.tf * s.upper.slope.cos(),
            _ => self.section.tf,
        }
    }

    /// Area that carries an axial force: that of the beam without its haunch \[mm²\].
    pub fn axial_area(&self) -> f64 {
        self.sloped.and_then(|s| s.haunch).map_or(self.section.area, |h| h.area)
    }

    /// Leg along the plate of the fillet weld of a flange over its throat, on the face towards the
    /// edge of the plate (`outer`) or on the other one: √2 at a right angle, `1/cos(ψ/2)` at a
    /// sharper angle ψ, and √2, which is less than the real one, at a blunter one. A shorter leg is
    /// on the safe side in m, m2 and b_eff.
    pub fn leg(&self, flange: Way, outer: bool) -> f64 {
        let slope = self.sloped.map_or(0.0, |s| s.flange(flange).slope);
        // the outer face of the upper flange of a rising beam closes on the plate
        let closes = if outer == (flange == Way::Up) { slope } else { -slope };
        if closes > 0.0 { 1.0 / (0.5 * (FRAC_PI_2 - closes)).cos() } else { SQRT_2 }
    }
}
