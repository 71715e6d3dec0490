//! Entries shared by several parts of a template: axes, loops, rectangles.

use crate::spec::expr::Expr;
use schemars::JsonSchema;
use serde::Deserialize;

/// A coordinate axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Axis {
    /// Along the beams.
    X,
    /// Across.
    Y,
    /// Up.
    Z,
}

impl Axis {
    /// Index of the axis: 0, 1, 2.
    pub fn index(self) -> usize {
        self as usize
    }
}

/// One loop; several make nested loops, the last runs fastest.
///
/// In expressions `each` is the value and `each.n` the number from 1; in texts `{#each}` is the
/// label (or the number) and `{@each}` the index from 0.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Loop {
    /// Name of the variable.
    pub each: String,
    /// Its values; or
    #[serde(default)]
    pub values: Vec<Expr>,
    /// the list parameter it runs over.
    pub list: Option<String>,
    /// Labels for names.
    #[serde(default)]
    pub labels: Vec<String>,
}

/// A rectangle on a coordinate plane.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct RectangleEntry {
    /// Normal axis.
    pub axis: Axis,
    /// Coordinate.
    pub at: Expr,
    /// Extent along x.
    pub x: Option<[Expr; 2]>,
    /// Extent along y.
    pub y: Option<[Expr; 2]>,
    /// Extent along z.
    pub z: Option<[Expr; 2]>,
}
