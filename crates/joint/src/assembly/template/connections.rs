//! Template entries of the connections between parts: bolts, contacts, welds.

use super::common::{Axis, Loop, RectangleEntry};
use crate::spec::expr::Expr;
use schemars::JsonSchema;
use serde::Deserialize;

/// A bolt with hexagon head and nut, from the bearing face of the head through parts to that of the
/// nut.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct BoltEntry {
    /// Identifier.
    pub name: String,
    /// Words for messages.
    pub label: String,
    /// Loops.
    #[serde(default, rename = "for")]
    pub each: Vec<Loop>,
    /// Only where this holds.
    pub when: Option<Expr>,
    /// Axis of the shank.
    pub axis: Axis,
    /// +1 or −1: direction from head to nut along the axis.
    pub toward: Expr,
    /// Centre of the head's bearing face.
    pub head: [Expr; 3],
    /// Axis on which corners of the hexagons lie.
    pub corner: Axis,
    /// An anchor: in place of a head the shank goes on by this length from `head` and is held at
    /// its end, in the concrete. Absent: a bolt.
    pub anchor: Option<Expr>,
    /// The parts it passes, from the head on.
    pub through: Vec<GripEntry>,
    /// True: the head is in contact with the first part; false: glued to it.
    pub head_contact: Expr,
    /// The same for the nut and the last part.
    pub nut_contact: Expr,
    /// Initial gap between shank and hole all round.
    pub shank_gap: Expr,
    /// Element size for `size: auto`.
    pub size: Expr,
}

/// One part a bolt passes.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct GripEntry {
    /// Its name.
    pub part: String,
    /// Its thickness along the shank.
    pub thickness: Expr,
}

/// An open interface.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ContactEntry {
    /// Name of the surface.
    pub name: String,
    /// Loops.
    #[serde(default, rename = "for")]
    pub each: Vec<Loop>,
    /// Only where this holds.
    pub when: Option<Expr>,
    /// The two parts; the normal points out of the first.
    pub between: [String; 2],
    /// Where.
    pub face: RectangleEntry,
    /// Initial gap.
    pub gap: Option<Expr>,
}

/// Fillet welds along both sides of a plate.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct WeldEntry {
    /// Name of the surface.
    pub name: String,
    /// Loops.
    #[serde(default, rename = "for")]
    pub each: Vec<Loop>,
    /// Only where this holds.
    pub when: Option<Expr>,
    /// The two parts, parts of members or plates; the weld is as strong as the weaker steel lets it
    /// be.
    pub between: [String; 2],
    /// Where.
    pub face: RectangleEntry,
    /// True when edges of the parts do not bound it.
    #[serde(default)]
    pub imprint: bool,
    /// Throat of each weld; 0 mm: full penetration, the parts are tied.
    pub throat: Expr,
    /// Area of the interface over half of the length of its welds: the thickness of a plate with a
    /// weld on either side.
    pub thickness: Expr,
    /// Length of all its welds, where `face` is more than the area of the interface; without:
    /// twice the area of `face` over `thickness`.
    pub length: Option<Expr>,
    /// True: one weld round the outside of a hollow section.
    #[serde(default)]
    pub closed: bool,
}
