//! Angles, channels and hollow sections.

use super::error::CatalogError;
use super::name::profile_key;
use super::profile::{DENSITY, IProfile};
use super::source::Source;
use super::table::{Columns, Entry, RawTable, Row};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::f64::consts::PI;

/// Kind of a section.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum SectionKind {
    /// I and H sections.
    I,
    /// Angles.
    Angle,
    /// Channels.
    Channel,
    /// Rectangular and square hollow sections.
    Rhs,
    /// Circular hollow sections.
    Chs,
}

impl SectionKind {
    /// All kinds, with the word of a template and that of a message.
    pub const ALL: [(Self, &'static str, &'static str); 5] = [
        (Self::I, "i", "an I or H section"),
        (Self::Angle, "angle", "an angle"),
        (Self::Channel, "channel", "a channel"),
        (Self::Rhs, "rhs", "a rectangular hollow section"),
        (Self::Chs, "chs", "a circular hollow section"),
    ];

    /// The kind without its article.
    pub fn noun(self) -> &'static str {
        self.words().split_once(' ').map_or("", |(_, noun)| noun)
    }

    /// The kind in a message, with its article.
    pub fn words(self) -> &'static str {
        Self::ALL.iter().find(|k| k.0 == self).map_or("", |k| k.2)
    }
}

/// Dimensions of a section \[mm\].
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Shape {
    /// Two legs.
    Angle {
        /// Depth, the longer leg.
        h: f64,
        /// Width.
        b: f64,
        /// Thickness.
        t: f64,
        /// Root radius.
        r: f64,
        /// Toe radius.
        toe: f64,
    },
    /// A web with two flanges on one side.
    Channel {
        /// Depth, the longer leg.
        h: f64,
        /// Width.
        b: f64,
        /// Thickness of the web.
        tw: f64,
        /// Thickness of the flange, halfway along a tapered one.
        tf: f64,
        /// Root radius.
        r: f64,
        /// Toe radius.
        toe: f64,
        /// Fall of the inner face of the flange towards the toe, as a fraction.
        slope: f64,
    },
    /// A rectangular hollow section.
    Rhs {
        /// Depth, the longer leg.
        h: f64,
        /// Width.
        b: f64,
        /// Thickness.
        t: f64,
        /// Outer radius of the corners.
        outer: f64,
        /// Inner radius of the corners.
        inner: f64,
    },
    /// A circular hollow section.
    Chs {
        /// Diameter.
        d: f64,
        /// Thickness.
        t: f64,
    },
}

/// An angle, a channel or a hollow section.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ShapedProfile {
    /// Name in the catalogue, for example `L100x10` or `RHS200x100x8`.
    pub name: String,
    /// Standard of the dimensions.
    pub standard: String,
    /// Dimensions \[mm\].
    pub shape: Shape,
    /// Mass per length \[kg/m\].
    pub mass: f64,
    /// Area \[cm²\].
    pub area: f64,
    /// Plastic section modulus about the strong axis \[cm³\], where the table has it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub w_pl_y: Option<f64>,
    /// File and line of the row.
    pub source: Source,
}

/// A section of the catalogue.
#[derive(Clone, Copy, Debug)]
pub enum Section<'a> {
    /// I or H.
    I(&'a IProfile),
    /// Any other one.
    Shaped(&'a ShapedProfile),
}

impl<'a> Section<'a> {
    /// Its name.
    pub fn name(self) -> &'a str {
        match self {
            Section::I(p) => &p.name,
            Section::Shaped(p) => &p.name,
        }
    }

    /// Its kind.
    pub fn kind(self) -> SectionKind {
        match self {
            Section::I(_) => SectionKind::I,
            Section::Shaped(p) => p.kind(),
        }
    }

    /// Dimensions for expressions \[mm\]. Every kind has all of them: depth `h`, width `b`,
    /// thickness of the web `tw` and of the flange `tf`, root radius `r`, largest thickness `t`,
    /// largest overall dimension `d` (of a CHS its diameter).
    pub fn dimensions(self) -> [(&'static str, f64); 7] {
        let (h, b, tw, tf, r) = match self {
            Section::I(p) => (p.h, p.b, p.tw, p.tf, p.r),
            Section::Shaped(p) => match p.shape {
                Shape::Angle { h, b, t, r, .. } => (h, b, t, t, r),
                Shape::Channel { h, b, tw, tf, r, .. } => (h, b, tw, tf, r),
                Shape::Rhs { h, b, t, inner, .. } => (h, b, t, t, inner),
                Shape::Chs { d, t } => (d, d, t, t, 0.0),
            },
        };
        [("h", h), ("b", b), ("tw", tw), ("tf", tf), ("r", r), ("t", tw.max(tf)), ("d", h.max(b))]
    }
}

impl ShapedProfile {
    const ANGLES: Columns = Columns {
        kind: "angles",
        needed: &["name", "standard", "h_mm", "b_mm", "t_mm", "r1_mm", "r2_mm", "A_cm2"],
        optional: &[
            "mass_kg_per_m",
            "cy_mm",
            "cz_mm",
            "Iy_cm4",
            "Iz_cm4",
            "Iu_cm4",
            "Iv_cm4",
            "tan_alpha",
        ],
    };
    const CHANNELS: Columns = Columns {
        kind: "channels",
        needed: &[
            "name",
            "standard",
            "h_mm",
            "b_mm",
            "tw_mm",
            "tf_mm",
            "r1_mm",
            "r2_mm",
            "flange_slope_percent",
            "A_cm2",
        ],
        optional: &["series", "mass_kg_per_m", "Iy_cm4", "Iz_cm4", "Wpl_y_cm3", "props"],
    };
    const RECTANGULAR: Columns = Columns {
        kind: "hollow sections",
        needed: &["name", "standard", "h_mm", "b_mm", "t_mm", "ro_mm", "ri_mm", "A_cm2"],
        optional: &[
            "shape",
            "mass_kg_per_m",
            "Iy_cm4",
            "Iz_cm4",
            "Wel_y_cm3",
            "Wpl_y_cm3",
            "It_cm4",
            "forming",
        ],
    };
    const CIRCULAR: Columns = Columns {
        kind: "circular hollow sections",
        needed: &["name", "standard", "d_mm", "t_mm"],
        optional: &[],
    };

    /// Its kind.
    pub fn kind(&self) -> SectionKind {
        match self.shape {
            Shape::Angle { .. } => SectionKind::Angle,
            Shape::Channel { .. } => SectionKind::Channel,
            Shape::Rhs { .. } => SectionKind::Rhs,
            Shape::Chs { .. } => SectionKind::Chs,
        }
    }

    /// Reads all rows of a table, whose columns tell the kind.
    pub(super) fn read(table: &RawTable) -> Result<Vec<Self>, CatalogError> {
        let (columns, shape): (_, ReadShape) = if table.has("tan_alpha") {
            (Self::ANGLES, angle)
        } else if table.has("flange_slope_percent") {
            (Self::CHANNELS, channel)
        } else if table.has("d_mm") {
            (Self::CIRCULAR, circular)
        } else {
            (Self::RECTANGULAR, rectangular)
        };
        table.check(columns)?;
        let filled = |row: &Row<'_>, column: &str| match table.has(column) {
            true => row.positive_or_empty(column),
            false => Ok(None),
        };
        let of = |row: Row<'_>| {
            let shape = shape(&row)?;
            let round = |d: f64, t: f64| {
                (PI * t * (d - t) / 1e2, (d.powi(3) - (d - 2.0 * t).powi(3)) / 6e3)
            };
            let (area, w_pl_y) = match shape {
                Shape::Chs { d, t } => (round(d, t).0, Some(round(d, t).1)),
                _ => (row.positive("A_cm2")?, filled(&row, "Wpl_y_cm3")?),
            };
            Ok(Self {
                name: row.text("name")?,
                standard: row.text("standard")?,
                shape,
                mass: filled(&row, "mass_kg_per_m")?.unwrap_or(DENSITY * 1e-4 * area),
                area,
                w_pl_y,
                source: row.source(),
            })
        };
        table.rows().map(of).collect()
    }
}

/// Reads the dimensions of a row.
type ReadShape = fn(&Row<'_>) -> Result<Shape, CatalogError>;

fn angle(row: &Row<'_>) -> Result<Shape, CatalogError> {
    let (h, b, t) = (row.positive("h_mm")?, row.positive("b_mm")?, row.positive("t_mm")?);
    let (r, toe) = (row.not_negative("r1_mm")?, row.not_negative("r2_mm")?);
    match t + r + toe < h.min(b) && toe <= t {
        true => Ok(Shape::Angle { h, b, t, r, toe }),
        false => Err(row.fault(
            "t_mm",
            format!("t + r1 + r2 = {} must be less than each leg, and r2 at most t", t + r + toe),
        )),
    }
}

fn channel(row: &Row<'_>) -> Result<Shape, CatalogError> {
    let (h, b) = (row.positive("h_mm")?, row.positive("b_mm")?);
    let (tw, tf) = (row.positive("tw_mm")?, row.positive("tf_mm")?);
    let (r, slope) = (row.not_negative("r1_mm")?, row.not_negative("flange_slope_percent")? / 1e2);
    let toe = row.positive_or_empty("r2_mm")?.unwrap_or(0.0);
    let room =
        2.0 * (tf + r + 0.5 * slope * b) < h && tw + r + toe < b && 0.5 * slope * b + toe < tf;
    match room {
        true => Ok(Shape::Channel { h, b, tw, tf, r, toe, slope }),
        false => Err(row.fault(
            "tf_mm",
            format!("{tf} leaves no room for the radii and the slope of the flange"),
        )),
    }
}

fn rectangular(row: &Row<'_>) -> Result<Shape, CatalogError> {
    let (h, b, t) = (row.positive("h_mm")?, row.positive("b_mm")?, row.positive("t_mm")?);
    let (outer, inner) = (row.positive("ro_mm")?, row.positive("ri_mm")?);
    match 2.0 * outer < h.min(b) && inner < outer && t + inner < 0.5 * h.min(b) {
        true => Ok(Shape::Rhs { h, b, t, outer, inner }),
        false => Err(row.fault(
            "ro_mm",
            format!("{outer} must be above ri = {inner} and below half of each side"),
        )),
    }
}

fn circular(row: &Row<'_>) -> Result<Shape, CatalogError> {
    let (d, t) = (row.positive("d_mm")?, row.positive("t_mm")?);
    match 2.0 * t < d {
        true => Ok(Shape::Chs { d, t }),
        false => Err(row.fault("t_mm", format!("{t} must be below half of the diameter {d}"))),
    }
}

impl Entry for ShapedProfile {
    const NOUN: &'static str = "section";
    const KIND: &'static str = "sections";
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
