//! Dimensions and steels of a bolted end-plate joint, between a beam and a column flange or between
//! two beams.

use super::sloped_end::SlopedEnd;
use crate::check::within;
use crate::error::{CheckError, not_negative, positive};
use crate::eurocode::i_section::Section;
use crate::subject::Sense;
use bracket_joint::assembly::ColumnEnds;
use serde::{Deserialize, Serialize};

/// The column. Strengths are nominal, of the thickness of the flange.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Column {
    /// Its section.
    pub section: Section,
    /// Nominal yield strength \[MPa\].
    pub fy: f64,
    /// From the beam's axis to the upper end \[mm\]; `None`: the column continues.
    pub above: Option<f64>,
    /// From the beam's axis to the lower end \[mm\]; `None`: the column continues.
    pub below: Option<f64>,
    /// Thickness of the stiffeners on both sides of the web, level with both beam flanges \[mm\]; 0
    /// for none.
    pub stiffener: f64,
    /// Throat of the welds between stiffener and column flange \[mm\]; 0 for a butt weld.
    pub stiffener_throat: f64,
    /// Number of supplementary web plates: 0, 1 or 2.
    pub doublers: u32,
    /// Width b_s of a supplementary web plate \[mm\].
    pub doubler_width: f64,
    /// Largest longitudinal compressive stress of the column at the web's root \[MPa\].
    pub longitudinal: f64,
}

impl Column {
    /// Where the column really ends.
    pub fn ends(&self) -> ColumnEnds {
        ColumnEnds { above: self.above, below: self.below }
    }

    /// Refuses values for which the formulas have no meaning.
    fn check(&self) -> Result<(), CheckError> {
        not_negative("root radius of the column [mm]", self.section.r)?;
        not_negative("design root radius of the column [mm]", self.section.root)?;
        for end in self.above.into_iter().chain(self.below) {
            positive("distance of the beam axis from an end of the column [mm]", end)?;
        }
        positive("clear depth of the column web [mm]", self.section.clear_depth())?;
        positive("yield strength of the column [MPa]", self.fy)?;
        for (name, value) in [
            ("stiffener of the column [mm]", self.stiffener),
            ("weld of the stiffener [mm]", self.stiffener_throat),
            ("width of the web plate [mm]", self.doubler_width),
            ("longitudinal stress of the column [MPa]", self.longitudinal),
        ] {
            not_negative(name, value)?;
        }
        if within(self.longitudinal, self.fy) {
            return Ok(());
        }
        let quantity = "longitudinal stress of the column [MPa]";
        Err(CheckError::OutOfRange {
            quantity,
            value: self.longitudinal,
            limit: "it must be at most f_y",
        })
    }
}

/// The beam. Strengths are nominal, of a haunched beam the lower ones of beam and haunch.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Beam {
    /// Its section.
    pub section: Section,
    /// Nominal yield strength \[MPa\].
    pub fy: f64,
    /// Throat of the fillet welds of its flanges \[mm\]; 0 for a butt weld.
    pub flange_throat: f64,
    /// Throat of the fillet welds of its web \[mm\]; 0 for a butt weld.
    pub web_throat: f64,
    /// Shear force beside the moment \[N\]; above half of V_pl,Rd it reduces M_c,Rd.
    pub shear: f64,
    /// Slope and haunch at the plate; `None`: the beam is normal to the plate.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub sloped: Option<SlopedEnd>,
}

/// The end plate; z from the beam's axis, or from the middle of the depth of a [`SlopedEnd`], up
/// positive.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Plate {
    /// Thickness \[mm\].
    pub thickness: f64,
    /// Width \[mm\].
    pub width: f64,
    /// Lower edge \[mm\].
    pub bottom: f64,
    /// Upper edge \[mm\].
    pub top: f64,
    /// Nominal yield strength \[MPa\].
    pub fy: f64,
}

/// Two columns of bolts.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Bolts {
    /// Distance of the two columns \[mm\].
    pub gauge: f64,
    /// Rows: z from the beam's axis \[mm\], in any order.
    pub rows: Vec<f64>,
    /// Design tension resistance of one bolt, punching included \[N\].
    pub tension: f64,
    /// Stress area of one bolt \[mm²\].
    pub stress_area: f64,
    /// L_b, elongation length of the bolts \[mm\].
    pub elongation: f64,
    /// d_w of the alternative method for mode 1 \[mm\]; `None` for the first method.
    pub washer: Option<f64>,
    /// True: prying forces are assumed to develop whatever the length of the bolts, as in SCI P398;
    /// false: Table 6.2 decides by L_b*.
    pub always_prying: bool,
}

/// A beam bolted by an end plate to the flange of a column, or to its own continuation. Lengths in
/// mm, strengths in MPa, forces in N.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct EndPlateJoint {
    /// Column; `None`: a splice, the other side is the same plate on the same beam.
    pub column: Option<Column>,
    /// Beam.
    pub beam: Beam,
    /// End plate.
    pub plate: Plate,
    /// Bolts.
    pub bolts: Bolts,
    /// Transformation parameter β of the moments on both sides: 0 equal and opposite, 1 one-sided,
    /// 2 equal and of the same sense.
    pub beta: f64,
    /// Young's modulus \[MPa\].
    pub young: f64,
    /// γ_M0.
    pub gamma_m0: f64,
    /// γ_M1.
    pub gamma_m1: f64,
    /// True: no row may have more than its share of a triangle from the centre of compression to
    /// the outermost row, NA.2.7 of the UK annex.
    #[serde(default)]
    pub triangular: bool,
}

impl EndPlateJoint {
    /// The joint mirrored at the axis of the beam: tension at the bottom becomes tension at the
    /// top.
    #[must_use]
    pub fn mirrored(&self) -> Self {
        let mut j = self.clone();
        if let (Some(turned), Some(c)) = (&mut j.column, &self.column) {
            let ends = c.ends().mirrored();
            (turned.above, turned.below) = (ends.above, ends.below);
        }
        (j.plate.bottom, j.plate.top) = (-self.plate.top, -self.plate.bottom);
        j.beam.sloped = j.beam.sloped.map(SlopedEnd::mirrored);
        j.bolts.rows.iter_mut().for_each(|z| *z = -*z);
        j
    }

    /// The joint turned so that the tension of a sense of bending is at the top.
    #[must_use]
    pub fn turned(&self, sense: Sense) -> Self {
        match sense {
            Sense::Top => self.clone(),
            Sense::Bottom => self.mirrored(),
        }
    }

    /// Refuses values for which the formulas have no meaning.
    pub fn check(&self) -> Result<(), CheckError> {
        let (c, b, p, k) = (self.column.as_ref(), &self.beam, &self.plate, &self.bolts);
        let sections = c.map(|c| (&c.section, COLUMN)).into_iter().chain([(&b.section, BEAM)]);
        for (s, names) in sections {
            let sizes = [s.h, s.b, s.tw, s.tf, s.area, s.w_pl, s.w_el, s.i];
            names.into_iter().zip(sizes).try_for_each(|(name, size)| positive(name, size))?;
        }
        not_negative("root radius of the beam [mm]", b.section.r)?;
        not_negative("design root radius of the beam [mm]", b.section.root)?;
        not_negative("shear force of the beam [N]", b.shear)?;
        positive("clear depth of the beam web [mm]", b.section.clear_depth())?;
        for (name, value) in [
            ("yield strength of the beam [MPa]", b.fy),
            ("yield strength of the plate [MPa]", p.fy),
            ("thickness of the plate [mm]", p.thickness),
            ("width of the plate [mm]", p.width),
            ("gauge of the bolts [mm]", k.gauge),
            ("tension resistance of a bolt [N]", k.tension),
            ("stress area of a bolt [mm2]", k.stress_area),
            ("elongation length of a bolt [mm]", k.elongation),
            ("Young's modulus [MPa]", self.young),
            ("gamma_M0", self.gamma_m0),
            ("gamma_M1", self.gamma_m1),
        ] {
            positive(name, value)?;
        }
        for (name, value) in [
            ("weld of the beam flange [mm]", b.flange_throat),
            ("weld of the beam web [mm]", b.web_throat),
        ] {
            not_negative(name, value)?;
        }
        let range = |quantity, value: f64, ok: bool, limit| {
            if ok { Ok(()) } else { Err(CheckError::OutOfRange { quantity, value, limit }) }
        };
        range(
            "beta",
            self.beta,
            (0.0..=2.0).contains(&self.beta),
            "it lies between 0 and 2 (5.3(7))",
        )?;
        c.map_or(Ok(()), Column::check)?;
        let half = 0.5 * b.depth();
        range(
            "upper edge of the plate [mm]",
            p.top,
            p.top.is_finite() && within(half, p.top),
            "it must cover the beam",
        )?;
        range(
            "lower edge of the plate [mm]",
            p.bottom,
            p.bottom.is_finite() && within(half, -p.bottom),
            "it must cover the beam",
        )?;
        let width = c.map_or(p.width, |c| p.width.min(c.section.b));
        range(
            "gauge of the bolts [mm]",
            k.gauge,
            !within(width, k.gauge),
            "it must be less than plate and column flange are wide",
        )?;
        range(
            "number of rows",
            k.rows.len() as f64,
            !k.rows.is_empty(),
            "there must be one row at least",
        )?;
        for (i, &z) in k.rows.iter().enumerate() {
            range("row of bolts [mm]", z, z > p.bottom && z < p.top, "it must lie on the plate")?;
            let on_column =
                c.is_none_or(|c| c.ends().nearest(z).is_none_or(|distance| distance > 0.0));
            range("row of bolts [mm]", z, on_column, "it must lie on the column")?;
            range("row of bolts [mm]", z, !k.rows[..i].contains(&z), "the same row stands twice")?;
        }
        Ok(())
    }
}

const COLUMN: [&str; 8] = [
    "depth of the column [mm]",
    "width of the column [mm]",
    "web of the column [mm]",
    "flange of the column [mm]",
    "area of the column [mm2]",
    "plastic modulus of the column [mm3]",
    "elastic modulus of the column [mm3]",
    "second moment of the column [mm4]",
];
const BEAM: [&str; 8] = [
    "depth of the beam [mm]",
    "width of the beam [mm]",
    "web of the beam [mm]",
    "flange of the beam [mm]",
    "area of the beam [mm2]",
    "plastic modulus of the beam [mm3]",
    "elastic modulus of the beam [mm3]",
    "second moment of the beam [mm4]",
];
