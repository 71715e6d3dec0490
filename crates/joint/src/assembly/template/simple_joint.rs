//! The `hand_checks` of a simple joint: a fin plate or a header plate.

use crate::spec::expr::Expr;
use schemars::JsonSchema;
use serde::Deserialize;

/// The kind of an entry of a simple joint.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum PlateKind {
    /// On the support, bolted to the web of the beam.
    FinPlate,
    /// Lower than the beam, welded to its web and bolted to the support.
    HeaderPlate,
}

/// The entry of a template: which of its names are what the code means. Lengths unless said.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SimpleJointEntry {
    /// What the plate does. It stands first.
    pub kind: PlateKind,
    /// Member role of the support.
    pub support: String,
    /// True or false: the plate stands on the web of the support; absent: on its flange.
    pub to_web: Option<Expr>,
    /// True if the support is a beam; the plate then stands on its web.
    #[serde(default)]
    pub support_is_beam: bool,
    /// Member role of the beam.
    pub beam: String,
    /// Whose steel the plate has: the first of these that the spec gives (`plate` or a member
    /// role).
    pub steel: Vec<String>,
    /// Thickness of the plate.
    pub thickness: Expr,
    /// Width of the plate: of a fin plate along the beam, of a header plate across it.
    pub width: Expr,
    /// Lower edge of the plate, from the beam's axis.
    pub bottom: Expr,
    /// Upper edge of the plate, from the beam's axis.
    pub top: Expr,
    /// The list parameter that holds the rows, from the beam's axis.
    pub rows: String,
    /// The bolts of a row: of a fin plate from the face of the support along the beam, of a header
    /// plate across the beam from its axis. Equal values count once.
    pub columns: Vec<Expr>,
    /// Diameter of the holes.
    pub hole: Expr,
    /// From the face of the support to the end of the beam.
    pub beam_start: Expr,
    /// Length and depth of the notch at the upper flange; absent or zero: none.
    pub upper_notch: Option<[Expr; 2]>,
    /// Length and depth of the notch at the lower flange; absent or zero: none.
    pub lower_notch: Option<[Expr; 2]>,
    /// Throat of the fillet welds on either side: of a fin plate to the support, of a header plate
    /// to the web of the beam; zero or absent: butt welds.
    pub throat: Option<Expr>,
    /// Member ends that are joined by such a plate; every one has a point `bolt_plane`: the centre
    /// of the bolts of a fin plate, the face of the support of a header plate.
    pub ends: Vec<String>,
}
