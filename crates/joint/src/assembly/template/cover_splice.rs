//! The `hand_checks` of a splice with cover plates.

use crate::spec::expr::Expr;
use schemars::JsonSchema;
use serde::Deserialize;

/// The kind of an entry of a splice.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum SpliceKind {
    /// Bolted cover plates on flanges and web.
    CoverSplice,
}

/// The entry of a template: which of its names are what the code means. Lengths unless said; along
/// the beam they are measured from the middle of the gap.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct CoverSpliceEntry {
    /// It stands first.
    pub kind: SpliceKind,
    /// Member role of the beam.
    pub beam: String,
    /// Whose steel the covers have: the first of these that the spec gives (`plate` or a member
    /// role).
    pub steel: Vec<String>,
    /// Between the ends of the beams.
    pub gap: Expr,
    /// Thickness and width of the outer flange covers.
    pub outer: [Expr; 2],
    /// Thickness and width of each inner flange cover; absent or zero: none.
    pub inner: Option<[Expr; 2]>,
    /// Half the length of the flange covers.
    pub flange_cover: Expr,
    /// The list parameter that holds the bolts of a flange on one side.
    pub flange_columns: String,
    /// Distance between the two lines of bolts in a flange.
    pub gauge: Expr,
    /// Thickness and height of each web cover.
    pub web: [Expr; 2],
    /// Half the length of the web covers.
    pub web_cover: Expr,
    /// The list parameter that holds the bolt rows of the web, from the beam's axis.
    pub web_rows: String,
    /// The bolt columns of the web on one side. Equal values count once.
    pub web_columns: Vec<Expr>,
    /// Diameter of the holes.
    pub hole: Expr,
    /// Member ends that are joined by the splice; every one has a point `bolt_plane` in the middle
    /// of the gap.
    pub ends: Vec<String>,
}
