//! The data of a column base for the hand checks: a column on a plate with anchors, on grout and
//! concrete.

use super::actions::PlaneActions;
use super::content::NotChecked;
use super::end_plate::UnseenLoad;
use super::foundation::Foundation;
use crate::catalog::{BoltGrade, BoltSize, IProfile};
use crate::spec::code::{ConcreteFactors, FySource, PartialFactors};
use crate::spec::welds::WeldEnds;
use crate::strength::Strength;
use serde::Serialize;

/// The section of a column. Lengths in mm.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum BaseSection {
    /// A rolled I or H section, its depth along x.
    I(Box<IProfile>),
    /// A rectangular hollow section, its depth along x.
    Rectangular {
        /// Depth and width.
        size: [f64; 2],
        /// Thickness of the wall.
        t: f64,
        /// Outer and inner radius of the corners.
        radii: [f64; 2],
    },
    /// A circular hollow section.
    Circular {
        /// Diameter.
        d: f64,
        /// Thickness of the wall.
        t: f64,
    },
}

/// What carries the shear force beside friction.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
pub struct BaseShear {
    /// The anchors.
    pub anchors: bool,
    /// A nib under the plate.
    pub nib: bool,
}

/// A column base. Lengths in mm; x is measured from the axis of the column along the depth of its
/// section, y across.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ColumnBase {
    /// The column's section.
    pub section: BaseSection,
    /// Steel of the column at the thickness of its flange.
    pub flange_steel: Strength,
    /// Steel of the column at the thickness of its web.
    pub web_steel: Strength,
    /// Thickness of the plate.
    pub thickness: f64,
    /// Steel of the plate at its thickness.
    pub plate_steel: Strength,
    /// Length of the plate along x and along y.
    pub plate: [f64; 2],
    /// x of the middle of the plate.
    pub offset: f64,
    /// Concrete and grout under the plate.
    pub foundation: Foundation,
    /// x of the anchor rows, rising.
    pub rows: Vec<f64>,
    /// y of the anchors of a row, rising.
    pub across: Vec<f64>,
    /// Size of the anchors.
    pub bolt: BoltSize,
    /// Grade of the anchors.
    pub grade: BoltGrade,
    /// Diameter of the holes.
    pub hole: f64,
    /// Length L_b of an anchor that stretches.
    pub elastic_length: f64,
    /// Throat of the fillet welds of the flanges; 0: butt welds.
    pub flange_throat: f64,
    /// Throat of the fillet welds of the web; 0: butt welds.
    pub web_throat: f64,
    /// Ends of the welds.
    pub ends: WeldEnds,
    /// What carries the shear force beside friction.
    pub shear: BaseShear,
    /// True if the engineer has checked the anchorage in the concrete by EN 1992-4.
    pub anchorage_checked: bool,
    /// What the geometry has and the checks do not cover.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub not_checked: Vec<NotChecked>,
    /// Actions on the axis of the column at the underside of the plate: one entry per load case.
    pub actions: Vec<PlaneActions>,
    /// Loads that the checks leave out.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub unseen: Vec<UnseenLoad>,
    /// National annex, as the catalogue names it; `None`: the recommended values.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub annex: Option<String>,
    /// Table that the yield strengths come from.
    pub fy_source: FySource,
    /// Partial factors of the design code.
    #[serde(flatten)]
    pub factors: PartialFactors,
    /// Factors of the concrete.
    pub concrete: ConcreteFactors,
}

impl ColumnBase {
    /// Number of anchors.
    pub fn anchors(&self) -> usize {
        self.rows.len() * self.across.len()
    }

    /// Distance of the edge of the plate from the column's axis on the side of positive x (`side`
    /// 1), or of negative x (−1).
    pub fn to_edge(&self, side: f64) -> f64 {
        0.5 * self.plate[0] + side * self.offset
    }
}
