//! Members and plates of a template: unions of profiles and boxes.

use super::common::{Axis, Loop};
use crate::spec::expr::Expr;
use schemars::JsonSchema;
use serde::Deserialize;

/// Role of a part in a template.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum RoleEntry {
    /// A rolled member.
    Member,
    /// A plate.
    Plate,
}

/// A member or plate.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PartEntry {
    /// Identifier.
    pub name: String,
    /// Words for messages.
    pub label: String,
    /// What it is.
    pub role: RoleEntry,
    /// Loops.
    #[serde(default, rename = "for")]
    pub each: Vec<Loop>,
    /// Only where this holds.
    pub when: Option<Expr>,
    /// Whose steel: the first of these that the spec gives (`plate` or a member role).
    pub steel: Vec<String>,
    /// Thickness that decides its yield strength.
    pub thickness: Expr,
    /// Element size for `size: auto`.
    pub size: Expr,
    /// Why it needs no check by code; the report says so. Without it, a part that `hand_checks`
    /// does not describe leaves the verdict by code undecided.
    pub no_check: Option<String>,
    /// The solids it is made of, united.
    pub solids: Vec<SolidEntry>,
}

/// One solid of a part: a profile, a box or a prism.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SolidEntry {
    /// Loops.
    #[serde(default, rename = "for")]
    pub each: Vec<Loop>,
    /// Only where this holds.
    pub when: Option<Expr>,
    /// A rolled section; or
    pub profile: Option<ProfileEntry>,
    /// a box; or
    #[serde(default, rename = "box")]
    pub cuboid: Option<BoxEntry>,
    /// a plate with an outline.
    pub prism: Option<PrismEntry>,
    /// Turns the solid about a line. Its own values, and `mid`, are those before the turn; `cut`
    /// comes after it.
    pub turn: Option<TurnEntry>,
    /// Words for lists, if they are not those of the part.
    pub label: Option<String>,
    /// Why it needs no check by code, as for the part.
    pub no_check: Option<String>,
    /// How its plane at mid-thickness differs from the box's own extent.
    pub mid: Option<MidEntry>,
    /// Boxes that are cut out of it, such as the notches of a beam.
    #[serde(default)]
    pub cut: Vec<CutEntry>,
}

/// A box that is cut out of a solid. It may reach beyond the solid.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct CutEntry {
    /// Loops.
    #[serde(default, rename = "for")]
    pub each: Vec<Loop>,
    /// Only where this holds.
    pub when: Option<Expr>,
    /// Its extent.
    #[serde(rename = "box")]
    pub cuboid: BoxEntry,
}

/// A plate with an outline of straight edges.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PrismEntry {
    /// Direction of the thickness.
    pub axis: Axis,
    /// One face along the axis.
    pub from: Expr,
    /// The other face.
    pub to: Expr,
    /// Corners in order, each with its coordinates on the two other axes in the order x, y, z.
    pub outline: Vec<[Expr; 2]>,
}

/// A turn about a line along a coordinate axis.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct TurnEntry {
    /// Direction of the line.
    pub about: Axis,
    /// The angle, right-handed: about y, a positive one lowers what points along x.
    pub by: Expr,
    /// A point of the line; absent: the origin.
    pub at: Option<[Expr; 3]>,
}

/// A length of rolled section.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ProfileEntry {
    /// Member role.
    pub member: String,
    /// Axis of the member.
    pub along: Axis,
    /// Direction of the section's depth.
    pub depth: Axis,
    /// One end along the axis.
    pub from: Expr,
    /// The other end.
    pub to: Expr,
    /// Position of the member's axis, x, y, z; the component along the axis is ignored. Of an angle
    /// it is the heel, of a channel the middle of the back of its web.
    pub centre: Option<[Expr; 3]>,
    /// Axes along which the legs of an angle or the flanges of a channel point the other way;
    /// absent: they point to where the axes point.
    #[serde(default)]
    pub flip: Vec<Axis>,
}

/// A box; the order of the two ends does not matter.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct BoxEntry {
    /// Extent along x.
    pub x: [Expr; 2],
    /// Extent along y.
    pub y: [Expr; 2],
    /// Extent along z.
    pub z: [Expr; 2],
}

/// The plane at mid-thickness of a box: normal axis, and extents that differ from the box's.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct MidEntry {
    /// Direction of the thickness.
    pub axis: Axis,
    /// Extent along x.
    pub x: Option<[Expr; 2]>,
    /// Extent along y.
    pub y: Option<[Expr; 2]>,
    /// Extent along z.
    pub z: Option<[Expr; 2]>,
}
