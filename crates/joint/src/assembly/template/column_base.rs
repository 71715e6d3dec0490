//! The `hand_checks` of a column base.

use crate::spec::expr::Expr;
use schemars::JsonSchema;
use serde::Deserialize;

/// The kind of an entry of a column base.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum BaseKind {
    /// A plate on concrete, with anchors.
    ColumnBase,
}

/// The entry of a template: which of its names are what the code means. Lengths unless said; x is
/// measured from the axis of the column along the depth of its section, y across. The concrete and
/// the sizes of the plate are those of the support with `ground`.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ColumnBaseEntry {
    /// It stands first.
    pub kind: BaseKind,
    /// Member role of the column.
    pub column: String,
    /// Whose steel the plate has: the first of these that the spec gives (`plate` or a member
    /// role).
    pub steel: Vec<String>,
    /// Thickness of the plate.
    pub thickness: Expr,
    /// x of the middle of the plate; absent: 0.
    pub offset: Option<Expr>,
    /// The list parameter that holds x of the anchor rows.
    pub anchors: String,
    /// y of the anchors of a row. Equal values count once.
    pub anchor_y: Vec<Expr>,
    /// Diameter of the holes.
    pub hole: Expr,
    /// Length of an anchor that stretches; absent: 8 d, grout, plate, washer and half of the nut.
    pub elastic_length: Option<Expr>,
    /// Throat of the fillet welds of the column's flanges; zero or absent: butt welds.
    pub flange_throat: Option<Expr>,
    /// Throat of the fillet welds of the column's web; zero or absent: butt welds.
    pub web_throat: Option<Expr>,
    /// True where the anchors carry shear beside friction; absent: false.
    pub by_anchors: Option<Expr>,
    /// True where a nib under the plate carries shear; absent: false.
    pub nib: Option<Expr>,
    /// True where the engineer has checked the anchorage in the concrete by EN 1992-4; absent:
    /// false.
    pub anchorage_checked: Option<Expr>,
    /// The end of the column, which has a point `bolt_plane` on its axis at the underside of the
    /// plate.
    pub ends: Vec<String>,
}
