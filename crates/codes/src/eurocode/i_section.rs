//! Dimensions of a rolled I or H section.

use bracket_joint::catalog::IProfile;
use serde::{Deserialize, Serialize};

/// A rolled I or H section \[mm, mm², mm³, mm⁴\].
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Section {
    /// Depth.
    pub h: f64,
    /// Flange width.
    pub b: f64,
    /// Web thickness.
    pub tw: f64,
    /// Flange thickness.
    pub tf: f64,
    /// Root radius that belongs to the area: enters A_v.
    pub r: f64,
    /// Root radius of the geometry (m, s, clear depths). For W shapes that of k_des, because the
    /// fillet that their area implies is not the rolled one; otherwise `r`.
    pub root: f64,
    /// Area.
    pub area: f64,
    /// Plastic section modulus about the strong axis.
    pub w_pl: f64,
    /// Elastic section modulus about the strong axis.
    pub w_el: f64,
    /// Second moment of area about the strong axis.
    pub i: f64,
}

impl Section {
    /// Clear depth of the web between the roots, d = h − 2 (t_f + r) \[mm\].
    pub fn clear_depth(&self) -> f64 {
        self.h - 2.0 * (self.tf + self.root)
    }

    /// Depth of the web between the flanges, h_w = h − 2 t_f \[mm\].
    pub fn web_depth(&self) -> f64 {
        self.h - 2.0 * self.tf
    }

    /// Shear area along the web \[mm²\], `A_v = A − 2 b t_f + (t_w + 2 r) t_f`, at least η h_w t_w
    /// with η = 1.
    ///
    /// # Source
    /// EN 1993-1-1:2005 6.2.6(3)a.
    pub fn shear_area(&self) -> f64 {
        (self.area - 2.0 * self.b * self.tf + (self.tw + 2.0 * self.r) * self.tf)
            .max(self.web_depth() * self.tw)
    }
}

impl From<&IProfile> for Section {
    fn from(p: &IProfile) -> Self {
        Self {
            h: p.h,
            b: p.b,
            tw: p.tw,
            tf: p.tf,
            r: p.r,
            root: p.r_detailing.unwrap_or(p.r),
            area: 1e2 * p.area,
            w_pl: 1e3 * p.w_pl_y,
            w_el: 1e3 * p.w_el_y,
            i: 1e4 * p.i_y,
        }
    }
}
