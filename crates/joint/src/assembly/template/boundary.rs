//! Template entries of faces that carry loads and supports, and of distances between parts.

use super::common::{Axis, Loop, RectangleEntry};
use super::parts::BoxEntry;
use crate::spec::expr::Expr;
use crate::spec::loads::ActionPoint;
use schemars::JsonSchema;
use serde::Deserialize;
use std::collections::BTreeMap;

/// A face that loads can name.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SectionEntry {
    /// Name, as a load says it.
    pub name: String,
    /// What it is.
    pub about: String,
    /// Its part.
    pub part: String,
    /// +1 or −1: direction of the outward normal along the axis.
    pub outward: i8,
    /// Where.
    pub face: RectangleEntry,
    /// True when edges of the part do not bound it.
    #[serde(default)]
    pub imprint: bool,
}

/// A member end that N, V, M and T can act on. The member's own axes: x′ along `outward`, out of
/// the joint; z′ along `depth`; y′ = z′ × x′. The end section stays plane.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct EndEntry {
    /// Name, as a load says it.
    pub name: String,
    /// Loops.
    #[serde(default, rename = "for")]
    pub each: Vec<Loop>,
    /// Only where this holds.
    pub when: Option<Expr>,
    /// What it is.
    pub about: String,
    /// Its part.
    pub part: String,
    /// +1 or −1: direction of the outward normal along the face's axis.
    pub outward: Expr,
    /// Direction of the section's depth, upwards.
    pub depth: Axis,
    /// Angle by which the member rises against the face's normal, along `depth`; absent: none. x′
    /// and z′ are turned by it about y′.
    pub slope: Option<Expr>,
    /// Where the end section is.
    pub face: RectangleEntry,
    /// Points that `at` can name: `node`, `column_face`, `bolt_plane`.
    pub points: BTreeMap<ActionPoint, [Expr; 3]>,
}

impl EndEntry {
    /// The names that the entry can produce, whatever its `when`.
    pub fn names(&self) -> Vec<String> {
        self.each.iter().fold(vec![self.name.clone()], |names, l| {
            let fill = |label: &String| {
                names.iter().map(|n| n.replace(&format!("{{#{}}}", l.each), label)).collect()
            };
            l.labels.iter().flat_map(|label| -> Vec<String> { fill(label) }).collect()
        })
    }

    /// The values that `at` can take.
    pub fn point_words(&self) -> Vec<&'static str> {
        self.points.keys().map(|p| p.word()).collect()
    }
}

/// A support.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SupportEntry {
    /// Name of the face.
    pub name: String,
    /// Loops.
    #[serde(default, rename = "for")]
    pub each: Vec<Loop>,
    /// Only where this holds.
    pub when: Option<Expr>,
    /// Its part.
    pub part: String,
    /// Where.
    pub face: RectangleEntry,
    /// Components held.
    #[serde(default)]
    pub fix: Vec<Axis>,
    /// The concrete that the face stands on, in place of `fix`: contact without friction, up to the
    /// design bearing strength in limit analysis.
    pub ground: Option<GroundEntry>,
    /// True when edges of the part do not bound it.
    #[serde(default)]
    pub imprint: bool,
}

/// A concrete block with a layer of grout under a base plate. Pairs stand in the order of the
/// plate's two axes.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct GroundEntry {
    /// Characteristic cylinder strength f_ck of the concrete, a number of MPa.
    pub f_ck: Expr,
    /// Lengths of the base plate.
    pub plate: [Expr; 2],
    /// Distance from each edge of the plate to the edge of the block, in the negative and the
    /// positive direction of each axis.
    pub edge: [[Expr; 2]; 2],
    /// Depth of the block.
    pub depth: Expr,
    /// Thickness of the grout.
    pub grout: Expr,
    /// Characteristic strength of the grout, a number of MPa.
    pub grout_strength: Expr,
    /// Coefficient of friction C_f,d between plate and grout.
    pub friction: Expr,
    /// True where the ground does not settle in elastic and elastoplastic analysis; absent: it has
    /// the stiffness that the design code gives it.
    pub rigid: Option<Expr>,
}

/// The reaction to shear and torsion of a plate that lies in x and y: tractions on its four edges,
/// even along them, with their resultant in a given plane.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ShearReactionEntry {
    /// The part of the plate.
    pub part: String,
    /// The plate.
    #[serde(rename = "box")]
    pub block: BoxEntry,
    /// Height of the plane of the resultant.
    pub level: Expr,
}

/// Two parts that must stay apart.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ClearanceEntry {
    /// Loops.
    #[serde(default, rename = "for")]
    pub each: Vec<Loop>,
    /// Only where this holds.
    pub when: Option<Expr>,
    /// The two parts.
    pub between: [String; 2],
    /// Smallest distance.
    pub min: Expr,
    /// What needs the room.
    pub reason: String,
}
