//! The data of a simple joint for the hand checks: a beam whose web is bolted to a fin plate, or
//! welded to a partial-depth (header) plate that is bolted to the support.

use super::actions::PlaneActions;
use super::content::NotChecked;
use super::end_plate::UnseenLoad;
use crate::catalog::{BoltGrade, BoltSize, IProfile};
use crate::spec::code::{FySource, PartialFactors};
use crate::spec::connection::BoltCategory;
use crate::spec::welds::WeldSpec;
use crate::strength::Strength;
use serde::Serialize;

/// What the plate does.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum SimpleKind {
    /// A plate in the plane of the beam: welded to the support, bolted to the web of the beam in
    /// one shear plane.
    FinPlate,
    /// A plate across the beam, lower than the beam: welded to the web of the beam, bolted to the
    /// support.
    HeaderPlate,
}

/// The element of the support that the plate stands on.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum SupportElement {
    /// A flange of a column.
    ColumnFlange,
    /// The web of a column.
    ColumnWeb,
    /// The web of a beam.
    BeamWeb,
}

/// What a simple joint is fixed to.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Support {
    /// The element on which the plate stands.
    pub element: SupportElement,
    /// Its section.
    pub section: IProfile,
    /// Its steel, at the thickness of the element.
    pub steel: Strength,
}

impl Support {
    /// Thickness of the element on which the plate stands \[mm\].
    pub fn thickness(&self) -> f64 {
        match self.element {
            SupportElement::ColumnFlange => self.section.tf,
            SupportElement::ColumnWeb | SupportElement::BeamWeb => self.section.tw,
        }
    }
}

/// A piece cut out of a corner of the beam's end. Zero lengths: no notch.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct Notch {
    /// Along the beam, from its end \[mm\].
    pub length: f64,
    /// Down, or up, from the outer face of the flange \[mm\].
    pub depth: f64,
}

/// A simple joint. Lengths in mm; x is measured from the face of the support along the beam, z from
/// the axis of the beam, positive upwards.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct SimpleJoint {
    /// What the plate does.
    pub kind: SimpleKind,
    /// The support.
    pub support: Support,
    /// Section of the beam.
    pub beam: IProfile,
    /// Steel of the beam at the thickness of its web.
    pub beam_steel: Strength,
    /// Steel of the plate.
    pub plate_steel: Strength,
    /// Size of the bolts.
    pub bolt: BoltSize,
    /// Grade of the bolts.
    pub grade: BoltGrade,
    /// Thickness of the plate.
    pub thickness: f64,
    /// Width of the plate: of a fin plate along the beam, of a header plate across it.
    pub width: f64,
    /// z of the lower edge of the plate.
    pub bottom: f64,
    /// z of the upper edge of the plate.
    pub top: f64,
    /// z of the bolt rows, from the highest down.
    pub rows: Vec<f64>,
    /// The bolts of a row: of a fin plate their x, rising; of a header plate their y, rising.
    pub columns: Vec<f64>,
    /// Diameter of the holes.
    pub hole: f64,
    /// x of the end of the beam: the gap of a fin plate, the thickness of a header plate.
    pub beam_start: f64,
    /// Notches at the upper and the lower flange.
    pub notches: [Notch; 2],
    /// Throat of the fillet welds on either side: of a fin plate to the support, of a header plate
    /// to the web of the beam; 0: butt welds.
    pub throat: f64,
    /// Thickness that the bolts clamp; the largest, if they differ.
    pub grip: f64,
    /// What the geometry has and the checks do not cover.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub not_checked: Vec<NotChecked>,
    /// Actions at the centre of the bolt group of a fin plate, at the face of the support of a
    /// header plate: one entry per load case.
    pub actions: Vec<PlaneActions>,
    /// Preload of a bolt \[N\]; `None`: the bolts are not preloaded.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub preload: Option<f64>,
    /// Category of the bolts, if the spec gives it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub category: Option<BoltCategory>,
    /// Friction coefficient of the contact surfaces.
    pub mu: f64,
    /// Loads that the checks leave out.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub unseen: Vec<UnseenLoad>,
    /// How the fillet welds are made.
    #[serde(skip_serializing_if = "WeldSpec::is_default")]
    pub welds: WeldSpec,
    /// National annex, as the catalogue names it; `None`: the recommended values.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub annex: Option<String>,
    /// Table that the yield strengths come from.
    pub fy_source: FySource,
    /// Partial factors of the design code.
    #[serde(flatten)]
    pub factors: PartialFactors,
}

impl SimpleJoint {
    /// x of the centre of the bolt group of a fin plate; 0 for a header plate, whose bolts pass the
    /// face of the support \[mm\].
    pub fn centre(&self) -> f64 {
        match self.kind {
            SimpleKind::FinPlate => {
                self.columns.iter().sum::<f64>() / self.columns.len().max(1) as f64
            }
            SimpleKind::HeaderPlate => 0.0,
        }
    }

    /// Height of the plate \[mm\].
    pub fn height(&self) -> f64 {
        self.top - self.bottom
    }
}
