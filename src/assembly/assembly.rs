//! The assembly: parts with their solids, materials, interfaces, supports and loads, in global
//! coordinates.
//!
//! Produced from spec + template + catalogue; consumed by `geometry` (solids → CAD script), `mesh`
//! and `model`.

use crate::spec::friction::FrictionLaw;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// One edge of a closed planar outline, from the previous point to `to`.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum OutlineEdge {
    /// Straight to `to` \[mm\].
    Line {
        /// End point in the outline's plane.
        to: [f64; 2],
    },
    /// Circular arc (< 180°) about `centre` to `to` \[mm\].
    Arc {
        /// End point in the outline's plane.
        to: [f64; 2],
        /// Centre in the outline's plane.
        centre: [f64; 2],
    },
}

/// A solid as a tree of primitives and booleans; global coordinates \[mm\].
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Solid {
    /// Axis-parallel box.
    Box {
        /// Lowest corner.
        min: [f64; 3],
        /// Highest corner.
        max: [f64; 3],
    },
    /// An outline extruded along `u × v`.
    Prism {
        /// Origin of the outline's plane.
        origin: [f64; 3],
        /// Unit vector of the outline's first coordinate.
        u: [f64; 3],
        /// Unit vector of the outline's second coordinate.
        v: [f64; 3],
        /// First point of the outline; the last edge must end here.
        start: [f64; 2],
        /// The edges, counter-clockwise seen from the tip of `u × v`.
        edges: Vec<OutlineEdge>,
        /// Length along `u × v`, > 0.
        length: f64,
    },
    /// A circular cylinder; meshed as a regular prism of `segments` sides with the area of the
    /// circle.
    Cylinder {
        /// Centre of the first end.
        base: [f64; 3],
        /// Unit axis.
        axis: [f64; 3],
        /// Nominal radius.
        radius: f64,
        /// Length along the axis, > 0.
        length: f64,
        /// Sides of the meshed circle, even, 12 … 48.
        segments: u32,
    },
    /// All of them fused.
    Union(Vec<Solid>),
    /// The first without the others.
    Difference(Vec<Solid>),
}

/// What a part is, for sizes, layers, messages and colours.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum PartRole {
    /// A rolled member with its stiffeners.
    Member,
    /// An end plate.
    Plate,
    /// A bolt with head and nut.
    Bolt,
}

/// A plane piece that cuts a part at mid-thickness, so that the mesh has a plane there.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct MidPlane {
    /// Normal axis, 0 = x, 1 = y, 2 = z.
    pub axis: usize,
    /// Coordinate of the plane along `axis` \[mm\].
    pub at: f64,
    /// Extent of the piece: lowest corner (its `axis` coordinate is ignored) \[mm\].
    pub min: [f64; 3],
    /// Extent of the piece: highest corner \[mm\].
    pub max: [f64; 3],
}

/// Elastic constants and strength of a part's material.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct PartMaterial {
    /// Young's modulus \[MPa\].
    pub e: f64,
    /// Poisson's ratio.
    pub nu: f64,
    /// Design yield strength \[MPa\]; `None`: never yields.
    pub fy: Option<f64>,
}

/// One body of the joint.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Part {
    /// Identifier, `[A-Z][A-Z0-9_]*`; the physical volume's name.
    pub name: String,
    /// Words for messages: `end plate of the right beam`.
    pub label: String,
    /// What it is.
    pub role: PartRole,
    /// Key into [`Assembly::materials`].
    pub material: String,
    /// Its shape, before symmetry cuts it.
    pub solid: Solid,
    /// Pieces its bounding boxes for clash checks are made of: convex solids whose union covers the
    /// part closely.
    pub convex: Vec<Solid>,
    /// Mid-thickness planes.
    pub mid_planes: Vec<MidPlane>,
    /// Wanted element size \[mm\].
    pub size: f64,
}

/// An open interface, found in the mesh as the faces shared by two parts (and lying on `surface`,
/// if given).
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct InterfaceRule {
    /// The two parts; the normal points out of the first.
    pub between: [String; 2],
    /// Restricts the interface to this surface; its name becomes a physical surface.
    pub surface: Option<(String, Surface)>,
    /// Friction coefficient.
    pub mu: f64,
    /// Friction law.
    pub friction: FrictionLaw,
    /// Initial gap, open positive \[mm\].
    pub gap: f64,
}

/// Fillet welds along both sides of a plate on another part, as an interface of finite strength.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct WeldRule {
    /// Name, the physical surface's.
    pub name: String,
    /// The two parts; the normal points out of the first.
    pub between: [String; 2],
    /// Where they meet.
    pub surface: Surface,
    /// True when edges of the parts do not bound it and it must be imprinted.
    pub imprint: bool,
    /// Throat of each weld \[mm\].
    pub throat: f64,
    /// Area of the interface over half of the length of its welds \[mm\]: the thickness of a plate
    /// with a weld on either side.
    pub thickness: f64,
    /// Strength f_u/(√3 β_w γ_M2) on the throat \[MPa\].
    pub strength: f64,
}

/// A piece of surface found by coordinates.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Surface {
    /// The part of the plane `x[axis] = at` inside the box.
    Plane {
        /// Normal axis, 0 = x, 1 = y, 2 = z.
        axis: usize,
        /// Coordinate \[mm\].
        at: f64,
        /// Lowest corner of the box \[mm\].
        min: [f64; 3],
        /// Highest corner of the box \[mm\].
        max: [f64; 3],
    },
    /// The mantle of a cylinder (all facet vertices within 3 % of the radius, between its ends).
    Mantle {
        /// Centre of the first end \[mm\].
        base: [f64; 3],
        /// Unit axis.
        axis: [f64; 3],
        /// Nominal radius \[mm\].
        radius: f64,
        /// Length \[mm\].
        length: f64,
    },
}

/// A named outer face of a part.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct FaceRule {
    /// Identifier, the physical surface's name.
    pub name: String,
    /// Part it belongs to.
    pub part: String,
    /// Where it is.
    pub surface: Surface,
    /// True when the rectangle is not bounded by edges of the part and must be imprinted (a load or
    /// support footprint).
    pub imprint: bool,
}

/// A preloaded bolt: its shank is cut, and drawn together there.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct BoltPreload {
    /// The bolt's part.
    pub part: String,
    /// Name of the cut, a physical surface inside the shank.
    pub cut: String,
    /// Where the cut is: a plane across the shank, wider than it.
    pub surface: Surface,
    /// Unit vector along the shank.
    pub axis: [f64; 3],
    /// Preload of the whole bolt \[N\].
    pub force: f64,
}

/// A support on a named face.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct FaceSupport {
    /// Key into [`Assembly::faces`].
    pub face: String,
    /// Which of x, y, z are held at zero.
    pub fix: [bool; 3],
}

/// What acts on a named face.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Action {
    /// Constant traction \[MPa\].
    Traction([f64; 3]),
    /// Force and moment on a section that stays plane and keeps its shape. Global axes, moments
    /// right-handed.
    Resultant {
        /// Point the force passes through and the moment is taken about \[mm\].
        at: [f64; 3],
        /// Force \[N\].
        force: [f64; 3],
        /// Moment \[N mm\].
        moment: [f64; 3],
    },
}

/// A load on a named face, of a load case.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct FaceLoad {
    /// Key into [`Assembly::faces`].
    pub face: String,
    /// Load case.
    pub case: String,
    /// What acts.
    pub action: Action,
    /// Not multiplied by the load factor.
    pub dead: bool,
}

/// A symmetry plane `x[axis] = 0` of geometry, supports and loads; the side with positive
/// coordinates is kept.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct SymmetryPlane {
    /// Normal axis, 0 = x, 1 = y, 2 = z.
    pub axis: usize,
}

/// A joint ready for geometry and meshing. Coordinates: x along the beams, y across, z up along the
/// column \[mm\].
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Assembly {
    /// Name of the joint.
    pub name: String,
    /// The parts.
    pub parts: Vec<Part>,
    /// Materials by name.
    pub materials: BTreeMap<String, PartMaterial>,
    /// Open interfaces; parts that touch and are not named here are tied.
    pub interfaces: Vec<InterfaceRule>,
    /// Named outer faces.
    pub faces: Vec<FaceRule>,
    /// Supports.
    pub supports: Vec<FaceSupport>,
    /// Loads.
    pub loads: Vec<FaceLoad>,
    /// Planes the whole joint (geometry, supports, loads) is symmetric about, as detected.
    pub symmetry: Vec<SymmetryPlane>,
    /// Wanted clearances beyond contact, checked before meshing.
    pub clearances: Vec<Clearance>,
    /// Fillet welds with a throat.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub welds: Vec<WeldRule>,
    /// Preloaded bolts.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub preloads: Vec<BoltPreload>,
}

/// Two parts that must stay apart by at least `min`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Clearance {
    /// The two parts.
    pub between: [String; 2],
    /// Smallest allowed distance \[mm\].
    pub min: f64,
    /// What needs the room: `bolt pitch`, `wrench`.
    pub reason: String,
}
