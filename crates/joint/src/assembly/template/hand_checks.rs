//! The `hand_checks` of a template: they assign names of the template to the quantities of the
//! code.

use crate::spec::expr::Expr;
use schemars::JsonSchema;
use serde::Deserialize;

/// The kind of an entry of an end plate.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum EndPlateKind {
    /// A bolted end plate.
    #[default]
    EndPlate,
}

/// The entry of a template: which of its names are what the code means. Lengths unless said.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct EndPlateEntry {
    /// `end_plate`, or absent. It stands first.
    #[serde(default)]
    pub kind: EndPlateKind,
    /// Member role of the column; absent: a splice, the plate is bolted to the same plate on the
    /// other beam.
    pub column: Option<String>,
    /// Member role of the beam.
    pub beam: String,
    /// Whose steel the plate has: the first of these that the spec gives (`plate` or a member
    /// role).
    pub steel: Vec<String>,
    /// Thickness of the plate.
    pub thickness: Expr,
    /// Width of the plate.
    pub width: Expr,
    /// Lower edge of the plate, from the beam's axis.
    pub bottom: Expr,
    /// Upper edge of the plate, from the beam's axis.
    pub top: Expr,
    /// Distance of the two columns of bolts.
    pub gauge: Expr,
    /// Distance of the two outer columns of bolts of rows with four; zero or absent: two bolts in a
    /// row.
    pub outer_gauge: Option<Expr>,
    /// The list parameter that holds the rows, from the beam's axis.
    pub rows: String,
    /// Diameter of the holes.
    pub hole: Expr,
    /// From the beam's axis to where the column really ends above; zero or absent: it continues
    /// beyond the model.
    pub column_above: Option<Expr>,
    /// From the beam's axis to where the column really ends below; zero or absent: it continues
    /// beyond the model.
    pub column_below: Option<Expr>,
    /// Thickness of the stiffeners of the column level with both beam flanges; zero or absent for
    /// none.
    pub stiffener: Option<Expr>,
    /// Thickness of a supplementary plate on one side of the column web, as wide as the web is flat
    /// and as high as the end plate; zero or absent for none.
    pub doubler: Option<Expr>,
    /// Throat of the fillet welds on either side of each stiffener, to web and flanges of the
    /// column; zero or absent: butt welds.
    pub stiffener_throat: Option<Expr>,
    /// How much of a stiffener is cut away at the root of the column; absent: the root radius and 5
    /// mm.
    pub stiffener_clip: Option<Expr>,
    /// Throat of the fillet welds round the supplementary web plate; zero or absent: butt welds.
    pub doubler_throat: Option<Expr>,
    /// Thickness of a rib between the beam flange and the plate; zero or absent for none.
    pub rib: Option<Expr>,
    /// Throat of the fillet welds on either side of the rib; zero or absent: butt welds.
    pub rib_throat: Option<Expr>,
    /// Throat of the fillet welds of the beam's flanges; absent: butt welds.
    pub flange_throat: Option<Expr>,
    /// Throat of the fillet welds of the beam's web; absent: butt welds.
    pub web_throat: Option<Expr>,
    /// Length of beam that bends between the section that carries the actions and the plates, in a
    /// splice with that of the held beam: its rotation is not the joint's. Absent: the analysis
    /// gives no stiffness of the joint.
    pub bending_length: Option<Expr>,
    /// β of EN 1993-1-8 5.3(7), a number: 0 equal and opposite moments on both sides, 1 a beam on
    /// one side alone. Load cases with actions at `ends` have their own.
    pub beta: Option<Expr>,
    /// The slope and the haunch of the beam; absent: its axis is normal to the plate. z of all
    /// other values is then measured from the middle of the depth at the plate, and `bolt_plane` of
    /// the ends lies there.
    pub rafter: Option<RafterEntry>,
    /// Member ends that are joined by such a plate each; every one has a point `bolt_plane`.
    #[serde(default)]
    pub ends: Vec<String>,
}

/// The slope and the haunch of a beam.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct RafterEntry {
    /// Angle between the beam's axis and the normal of the plate; positive: the beam rises out of
    /// the joint.
    pub slope: Expr,
    /// Depth at the plate, along it, between the outer faces of the upper and the lower flange.
    pub depth: Expr,
    /// The haunch below the beam.
    pub haunch: Option<HaunchEntry>,
}

/// A haunch of a web and a flange below the beam.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct HaunchEntry {
    /// Only where this holds.
    pub when: Option<Expr>,
    /// Length from the plate to the tip, along the lower flange of the beam.
    pub length: Expr,
    /// Angle between the haunch flange and the beam's axis.
    pub angle: Expr,
    /// Thickness of its flange.
    pub flange: Expr,
    /// Width of its flange.
    pub width: Expr,
    /// Thickness of its web.
    pub web: Expr,
    /// Whose steel it has: the first of these that the spec gives (`plate` or a member role).
    pub steel: Vec<String>,
    /// Throat of the fillet welds on both sides of its web to the flange of the beam; zero or
    /// absent: butt welds.
    pub seam_throat: Option<Expr>,
    /// Thickness of the stiffeners of the beam's web at its tip; zero or absent: none.
    pub stiffener: Option<Expr>,
}
