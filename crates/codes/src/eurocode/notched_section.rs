//! What notches leave of the section of a rolled beam: a tee, or a web alone.

use super::i_section::Section;
use super::yielding::plastic_shear;
use crate::check::CheckId;
use crate::formula::Traced;
use crate::unit::Unit;
use crate::worked::Worked;

/// Web of a beam with the flanges that notches leave. Root fillets do not count in it, on the safe
/// side. Lengths in mm; z from the axis of the whole beam, positive upwards.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NotchedSection {
    /// Upper edge of what is left.
    pub top: f64,
    /// Lower edge.
    pub bottom: f64,
    /// Thickness of the web.
    pub tw: f64,
    /// Width and thickness of the flanges that are left: upper, lower.
    pub flanges: [Option<[f64; 2]>; 2],
    /// Root radius that enters the shear area beside a flange.
    pub r: f64,
}

impl NotchedSection {
    /// What notches of these depths \[mm\] leave of a section; 0: no notch. A notch takes the whole
    /// flange.
    pub fn new(s: &Section, depths: [f64; 2]) -> Self {
        let flange = |depth: f64| (depth <= 0.0).then_some([s.b, s.tf]);
        Self {
            top: 0.5 * s.h - depths[0].max(0.0),
            bottom: -0.5 * s.h + depths[1].max(0.0),
            tw: s.tw,
            flanges: depths.map(flange),
            r: s.r,
        }
    }

    /// Height of what is left.
    pub fn height(&self) -> f64 {
        self.top - self.bottom
    }

    /// Area, height and position of the rectangles: web between the flanges that are left, flanges.
    fn rectangles(&self) -> Vec<[f64; 3]> {
        let [upper, lower] = self.flanges.map(|f| f.map_or(0.0, |[_, t]| t));
        let (top, bottom) = (self.top - upper, self.bottom + lower);
        let mut out = vec![[self.tw * (top - bottom), top - bottom, 0.5 * (top + bottom)]];
        let mut flange = |f: Option<[f64; 2]>, z: f64| {
            out.extend(f.map(|[b, t]| [b * t, t, z - z.signum() * 0.5 * t]));
        };
        flange(self.flanges[0], self.top);
        flange(self.flanges[1], self.bottom);
        out
    }

    /// Area \[mm²\].
    pub fn area(&self) -> f64 {
        self.rectangles().iter().map(|r| r[0]).sum()
    }

    /// z of the centroid.
    pub fn centroid(&self) -> f64 {
        self.rectangles().iter().map(|r| r[0] * r[2]).sum::<f64>() / self.area()
    }

    /// Elastic section modulus of the farther edge \[mm³\].
    pub fn modulus(&self) -> f64 {
        let z = self.centroid();
        let of =
            |[area, height, at]: &[f64; 3]| area * (height * height / 12.0 + (at - z) * (at - z));
        let inertia: f64 = self.rectangles().iter().map(of).sum();
        inertia / (self.top - z).max(z - self.bottom)
    }

    /// Shear area \[mm²\]: the web, and beside each flange that is left `(t_w + 2 r) t_f/2`.
    ///
    /// # Source
    /// Steel Buildings in Europe, Part 5, 3.2.5.1: `A_Tee − b t_f + (t_w + 2 r) t_f/2`, of two
    /// notches `t_w` times the height.
    pub fn shear_area(&self) -> f64 {
        let beside =
            |f: Option<[f64; 2]>| f.map_or(0.0, |[_, t]| 0.5 * (self.tw + 2.0 * self.r) * t);
        let web = self.rectangles().first().map_or(0.0, |r| r[0]);
        web + beside(self.flanges[0]) + beside(self.flanges[1])
    }

    /// Shear resistance of the gross section \[N\], `A_v f_y/(√3 γ_M0)`.
    ///
    /// # Source
    /// Steel Buildings in Europe, Part 5, 3.2.5.1.
    pub fn shear(&self, fy: f64, gamma_m0: f64) -> Worked {
        let a_v = Traced::area("A_v", self.shear_area());
        let (f_y, gamma) = (Traced::stress("f_y", fy), Traced::number("γ_M0", gamma_m0));
        let value = plastic_shear(a_v, f_y, gamma);
        let clause = "Steel Buildings in Europe 5, 3.2.5.1";
        Worked::of(clause, CheckId::GrossShear, "V_Rd,g", value, Unit::Force)
    }
}
