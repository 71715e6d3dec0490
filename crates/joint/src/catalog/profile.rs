//! Rolled I and H sections.

use super::error::CatalogError;
use super::name::profile_key;
use super::source::Source;
use super::table::{Columns, Entry, RawTable, Row};
use bracket_base::units::limits;
use serde::Serialize;
use std::f64::consts::PI;

/// A rolled I or H section with nominal dimensions and tabulated properties.
///
/// # Units
/// Dimensions are in mm, properties in the units of the tables (cm², cm³, cm⁴, cm⁶), mass in kg/m.
/// Axis y is the strong axis (parallel to the flanges), z the weak axis (EN 1993 convention).
///
/// # Source
/// `source` gives file and line; the source of the file is documented in `catalogs/README.md`.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct IProfile {
    /// Name in the catalogue, for example `HEB200`.
    pub name: String,
    /// Series, for example `HEB`, `IPE`, `UB`, `W`.
    pub series: String,
    /// Standard of the dimensions.
    pub standard: String,
    /// Depth \[mm\].
    pub h: f64,
    /// Flange width \[mm\].
    pub b: f64,
    /// Web thickness \[mm\].
    pub tw: f64,
    /// Flange thickness \[mm\].
    pub tf: f64,
    /// Root radius \[mm\], may be 0. For W shapes it is the radius that reproduces the tabulated
    /// area.
    pub r: f64,
    /// Root radius implied by the design value k_des \[mm\]; W shapes only.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub r_detailing: Option<f64>,
    /// Mass per length \[kg/m\].
    pub mass: f64,
    /// Area \[cm²\], as tabulated.
    pub area: f64,
    /// Second moment of area about the strong axis \[cm⁴\], as tabulated.
    pub i_y: f64,
    /// Second moment of area about the weak axis \[cm⁴\], as tabulated.
    pub i_z: f64,
    /// Elastic section modulus about the strong axis \[cm³\].
    pub w_el_y: f64,
    /// Plastic section modulus about the strong axis \[cm³\].
    pub w_pl_y: f64,
    /// Elastic section modulus about the weak axis \[cm³\].
    pub w_el_z: f64,
    /// Plastic section modulus about the weak axis \[cm³\].
    pub w_pl_z: f64,
    /// Torsion constant \[cm⁴\], accurate to 5 %; only if the source tabulates it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub i_t: Option<f64>,
    /// Warping constant \[cm⁶\], accurate to 5 %; only if the source tabulates it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub i_w: Option<f64>,
    /// True if properties were computed from the dimensions instead of read from a table.
    pub computed: bool,
    /// File and line of the row.
    pub source: Source,
}

/// Largest relative difference between tabulated and recomputed section properties that is accepted
/// without a warning (0.5 %).
pub const PROPERTY_TOLERANCE: f64 = 0.005;

/// The same for the other properties (2 %): tables round them more coarsely.
pub const COARSE_TOLERANCE: f64 = 0.02;

/// Density of steel \[kg/m³\], EN 1991-1-1 Table A.4 as used in practice.
pub(super) const DENSITY: f64 = 7850.0;

/// Difference from which on a row is refused (10 %): a digit or a unit is wrong.
const CONTRADICTION: f64 = 0.1;

impl IProfile {
    pub(super) const COLUMNS: Columns = Columns {
        kind: "I profiles",
        needed: &[
            "name",
            "series",
            "standard",
            "h_mm",
            "b_mm",
            "tw_mm",
            "tf_mm",
            "mass_kg_per_m",
            "A_cm2",
            "Iy_cm4",
            "Iz_cm4",
            "Wel_y_cm3",
            "Wpl_y_cm3",
            "Wel_z_cm3",
            "Wpl_z_cm3",
        ],
        optional: &["r_mm", "r_area_mm", "r_kdes_mm", "It_cm4", "Iw_cm6", "props"],
    };

    /// Area of the outline with exact quarter-circle fillets \[mm²\].
    pub fn outline_area(&self) -> f64 {
        2.0 * self.b * self.tf + (self.h - 2.0 * self.tf) * self.tw + 4.0 * fillet_area(self.r)
    }

    /// Second moment of area of the outline about the strong axis, with exact quarter-circle
    /// fillets \[mm⁴\].
    ///
    /// # Source
    /// Each fillet is a square of side r less a quarter disc. Its second moment about the inner
    /// face of the flange is (1 − 5π/16) r⁴, and its centroid lies (10 − 3π)/(12 − 3π) r from that
    /// face. The parallel-axis theorem gives the rest.
    pub fn outline_i_y(&self) -> f64 {
        let clear = self.h - 2.0 * self.tf;
        let plates = (self.b * self.h.powi(3) - (self.b - self.tw) * clear.powi(3)) / 12.0;
        plates + self.fillets_i(clear / 2.0 - fillet_offset(self.r))
    }

    /// The same about the weak axis \[mm⁴\].
    pub fn outline_i_z(&self) -> f64 {
        let clear = self.h - 2.0 * self.tf;
        let plates = (2.0 * self.tf * self.b.powi(3) + clear * self.tw.powi(3)) / 12.0;
        plates + self.fillets_i(self.tw / 2.0 + fillet_offset(self.r))
    }

    /// Second moment of area of the four fillets about an axis at this distance of their centroids
    /// \[mm⁴\].
    fn fillets_i(&self, distance: f64) -> f64 {
        let (area, offset) = (fillet_area(self.r), fillet_offset(self.r));
        let own = (1.0 - 5.0 * PI / 16.0) * self.r.powi(4) - area * offset * offset;
        4.0 * (own + area * distance.powi(2))
    }

    /// Plastic section modulus of the outline about the strong axis \[mm³\].
    pub fn outline_w_pl_y(&self) -> f64 {
        let half = self.h / 2.0 - self.tf;
        self.b * self.tf * (self.h - self.tf)
            + self.tw * half * half
            + 4.0 * fillet_area(self.r) * (half - fillet_offset(self.r))
    }

    /// Plastic section modulus of the outline about the weak axis \[mm³\].
    pub fn outline_w_pl_z(&self) -> f64 {
        self.tf * self.b * self.b / 2.0
            + (self.h - 2.0 * self.tf) * self.tw * self.tw / 4.0
            + 4.0 * fillet_area(self.r) * (self.tw / 2.0 + fillet_offset(self.r))
    }

    /// Torsion constant \[mm⁴\]: the tabulated one, else that of three thin rectangles without the
    /// fillets, which is smaller.
    pub fn torsion_constant(&self) -> f64 {
        let clear = self.h - 2.0 * self.tf;
        let thin = (2.0 * self.b * self.tf.powi(3) + clear * self.tw.powi(3)) / 3.0;
        self.i_t.map_or(thin, |tabulated| 1e4 * tabulated)
    }

    /// Column, tabulated value and value of the outline of every property, in the units of the
    /// table.
    pub fn properties(&self) -> [(&'static str, f64, f64); 7] {
        let (i_y, i_z) = (self.outline_i_y(), self.outline_i_z());
        [
            ("A_cm2", self.area, self.outline_area() / 1e2),
            ("Iy_cm4", self.i_y, i_y / 1e4),
            ("Iz_cm4", self.i_z, i_z / 1e4),
            ("Wel_y_cm3", self.w_el_y, 2e-3 * i_y / self.h),
            ("Wpl_y_cm3", self.w_pl_y, self.outline_w_pl_y() / 1e3),
            ("Wel_z_cm3", self.w_el_z, 2e-3 * i_z / self.b),
            ("Wpl_z_cm3", self.w_pl_z, self.outline_w_pl_z() / 1e3),
        ]
    }

    /// The property with a number of [`Self::properties`].
    fn property(&mut self, i: usize) -> &mut f64 {
        match i {
            0 => &mut self.area,
            1 => &mut self.i_y,
            2 => &mut self.i_z,
            3 => &mut self.w_el_y,
            4 => &mut self.w_pl_y,
            5 => &mut self.w_el_z,
            _ => &mut self.w_pl_z,
        }
    }

    /// Relative differences (outline − tabulated)/tabulated of the area and of the second moment of
    /// area about the strong axis.
    pub fn mismatch(&self) -> [f64; 2] {
        [
            self.outline_area() / (100.0 * self.area) - 1.0,
            self.outline_i_y() / (1.0e4 * self.i_y) - 1.0,
        ]
    }

    /// Reads all rows of a table.
    pub(super) fn read(table: &RawTable) -> Result<Vec<Self>, CatalogError> {
        table.check(Self::COLUMNS)?;
        if !table.has("r_mm") && !table.has("r_area_mm") {
            let file = table.rows().next().map_or_else(String::new, |r| r.source().file);
            let hint = " (nor `r_area_mm`)".to_owned();
            return Err(CatalogError::MissingColumn {
                file,
                kind: Self::COLUMNS.kind,
                column: "r_mm",
                hint,
            });
        }
        table.rows().map(|row| Self::from_row(table, &row)).collect()
    }

    fn from_row(table: &RawTable, row: &Row<'_>) -> Result<Self, CatalogError> {
        let radius = if table.has("r_area_mm") { "r_area_mm" } else { "r_mm" };
        let optional =
            |column| if table.has(column) { row.positive_or_empty(column) } else { Ok(None) };
        let filled = |column| row.positive_or_empty(column);
        let mut profile = Self {
            name: row.text("name")?,
            series: row.text("series")?,
            standard: row.text("standard")?,
            h: row.positive("h_mm")?,
            b: row.positive("b_mm")?,
            tw: row.positive("tw_mm")?,
            tf: row.positive("tf_mm")?,
            r: row.not_negative(radius)?,
            r_detailing: optional("r_kdes_mm")?,
            // what the table leaves empty follows from the outline, below
            mass: 0.0,
            area: 0.0,
            i_y: 0.0,
            i_z: 0.0,
            w_el_y: 0.0,
            w_pl_y: 0.0,
            w_el_z: 0.0,
            w_pl_z: 0.0,
            i_t: optional("It_cm4")?,
            i_w: optional("Iw_cm6")?,
            computed: match table.has("props").then(|| row.text("props")).transpose()?.as_deref() {
                None | Some("tabulated") => false,
                Some("computed") => true,
                Some(other) => {
                    return Err(row.fault(
                        "props",
                        format!("`{other}` is neither `tabulated` nor `computed`"),
                    ));
                }
            },
            source: row.source(),
        };
        if profile.h <= 2.0 * (profile.tf + profile.r) {
            let least = 2.0 * (profile.tf + profile.r);
            return Err(
                row.fault("h_mm", format!("{} must exceed 2 (tf + r) = {least}", profile.h))
            );
        }
        if profile.b <= profile.tw + 2.0 * profile.r {
            let least = profile.tw + 2.0 * profile.r;
            return Err(row.fault("b_mm", format!("{} must exceed tw + 2 r = {least}", profile.b)));
        }
        for (i, (column, _, outline)) in profile.properties().into_iter().enumerate() {
            let given = filled(column)?;
            profile.computed |= given.is_none();
            *profile.property(i) = given.unwrap_or(outline);
        }
        let mass = DENSITY * 1e-4 * profile.area;
        profile.mass = filled("mass_kg_per_m")?.unwrap_or(mass);
        if (profile.mass / mass - 1.0).abs() > CONTRADICTION {
            let problem = format!(
                "{} contradicts the area of this row, which gives {mass:.4}; at most {} % may lie \
                 between them",
                profile.mass,
                100.0 * CONTRADICTION
            );
            return Err(row.fault("mass_kg_per_m", problem));
        }
        for (column, given, outline) in profile.properties() {
            if (outline / given - 1.0).abs() > CONTRADICTION {
                return Err(row.fault(
                    column,
                    format!(
                        "{given} contradicts the dimensions of this row, which give {outline:.4}; \
                         at most {} % may lie between them",
                        100.0 * CONTRADICTION
                    ),
                ));
            }
        }
        // the rules for thin rectangles leave out the fillets
        let thin = Self { i_t: None, ..profile.clone() }.torsion_constant();
        if let Some(given) = profile.i_t
            && !limits::within(1e4 * given / thin, &(0.5..=3.0))
        {
            let thin = 1e-4 * thin;
            let problem = format!(
                "{given} contradicts the dimensions of this row: the rectangles of flanges and \
                 web give {thin:.4}"
            );
            return Err(row.fault("It_cm4", problem));
        }
        Ok(profile)
    }
}

/// Distance of the centroid of a fillet from the two faces that it joins \[mm\].
fn fillet_offset(r: f64) -> f64 {
    r * (10.0 - 3.0 * PI) / (12.0 - 3.0 * PI)
}

/// Area between a root corner and its quarter circle \[mm²\].
fn fillet_area(r: f64) -> f64 {
    (1.0 - PI / 4.0) * r * r
}

impl Entry for IProfile {
    const NOUN: &'static str = "profile";
    const KIND: &'static str = "profiles";
    const SIZED: bool = true;
    fn name(&self) -> String {
        self.name.clone()
    }
    fn key(name: &str) -> String {
        profile_key(name)
    }
    fn source(&self) -> &Source {
        &self.source
    }
}
