//! The assembly in global coordinates: parts with their solids, materials, interfaces, supports and
//! loads.
//!
//! It is built from the spec, the template and the catalogue. `geometry` turns its solids into a
//! CAD script; `mesh` and `model` also read it.

use super::foundation::Foundation;
pub use super::symmetry_plane::SymmetryPlane;
use crate::catalog::{BoltGrade, BoltSize};
use crate::strength::{Nominal, NominalStrength, WeldSteel};
use bracket_engine::model::FrictionLaw;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// One edge of a closed planar outline, from the end of the previous edge to `to`.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum OutlineEdge {
    /// Straight edge to `to` \[mm\].
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

/// A solid as a tree of primitives and Boolean operations, in global coordinates \[mm\].
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
        /// The edges, counter-clockwise when seen from the tip of `u × v`.
        edges: Vec<OutlineEdge>,
        /// Length along `u × v`, > 0.
        length: f64,
    },
    /// A circular cylinder. It is meshed as a regular prism with `segments` sides and the area of
    /// the circle.
    Cylinder {
        /// Centre of the first end.
        base: [f64; 3],
        /// Unit axis.
        axis: [f64; 3],
        /// Nominal radius.
        radius: f64,
        /// Length along the axis, > 0.
        length: f64,
        /// Number of sides of the meshed circle: even, 12 … 48.
        segments: u32,
    },
    /// Union of all the solids.
    Union(Vec<Solid>),
    /// The first solid minus all the others.
    Difference(Vec<Solid>),
}

/// Role of a part; it decides sizes, layers, messages and colours.
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

/// A piece of a plane that cuts a part at mid-thickness. The cut makes the mesh have element faces
/// on that plane.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct MidPlane {
    /// Normal axis, 0 = x, 1 = y, 2 = z.
    pub axis: usize,
    /// Coordinate of the plane along `axis` \[mm\].
    pub at: f64,
    /// Lowest corner of the piece \[mm\]; its `axis` coordinate is ignored.
    pub min: [f64; 3],
    /// Highest corner of the piece \[mm\]; its `axis` coordinate is ignored.
    pub max: [f64; 3],
}

/// Elastic constants and nominal strength of a part's material.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct PartMaterial {
    /// Young's modulus \[MPa\].
    pub e: f64,
    /// Poisson's ratio.
    pub nu: f64,
    /// Nominal strength.
    pub strength: NominalStrength,
    /// Ultimate strength of a rolled steel.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub fu: Option<Nominal>,
}

/// One body of the joint.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Part {
    /// Identifier, `[A-Z][A-Z0-9_]*`; also the name of the physical volume.
    pub name: String,
    /// Description for messages, for example `end plate of the right beam`.
    pub label: String,
    /// Its role.
    pub role: PartRole,
    /// Key into [`Assembly::materials`].
    pub material: String,
    /// Its shape before the symmetry planes cut it.
    pub solid: Solid,
    /// Convex solids whose union covers the part closely. The clash checks compute bounding boxes
    /// from them.
    pub convex: Vec<Solid>,
    /// Mid-thickness planes.
    pub mid_planes: Vec<MidPlane>,
    /// Mid-thickness planes of turned pieces: the corners of convex polygons \[mm\].
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub oblique_planes: Vec<Vec<[f64; 3]>>,
    /// Target element size \[mm\].
    pub size: f64,
}

/// An open interface. In the mesh it consists of the faces shared by the two parts and, if
/// `surface` is given, lying on that surface.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct InterfaceRule {
    /// The two parts; the normal points out of the first.
    pub between: [String; 2],
    /// Restricts the interface to this surface; the name becomes that of a physical surface.
    pub surface: Option<(String, Surface)>,
    /// Friction coefficient.
    pub mu: f64,
    /// Friction law.
    pub friction: FrictionLaw,
    /// Initial gap \[mm\], positive when open.
    pub gap: f64,
}

/// Fillet welds along both sides of a plate on another part, modelled as an interface of finite
/// strength.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct WeldRule {
    /// Name, also that of the physical surface.
    pub name: String,
    /// The two parts; the normal points out of the first.
    pub between: [String; 2],
    /// The surface where the parts meet.
    pub surface: Surface,
    /// True if no edges of the parts bound the surface, so that it must be imprinted.
    pub imprint: bool,
    /// Throat of each weld \[mm\].
    pub throat: f64,
    /// Area of the interface divided by half the length of its welds \[mm\]. For a plate with a
    /// weld on each side this is the thickness of the plate.
    pub thickness: f64,
    /// Length of all of them \[mm\]; none: twice the area of the surface over `thickness`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub length: Option<f64>,
    /// True: one weld round the outside of a hollow section.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub closed: bool,
    /// The weaker steel of the two parts.
    pub steel: WeldSteel,
}

/// A piece of a surface, defined by coordinates.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Surface {
    /// The part of the plane `x[axis] = at` inside a box.
    Plane {
        /// Normal axis, 0 = x, 1 = y, 2 = z.
        axis: usize,
        /// Coordinate of the plane along `axis` \[mm\].
        at: f64,
        /// Lowest corner of the box \[mm\].
        min: [f64; 3],
        /// Highest corner of the box \[mm\].
        max: [f64; 3],
    },
    /// The curved surface of a cylinder: facets between its ends, with all vertices within 3 % of
    /// the radius.
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

impl MidPlane {
    /// Its corners, in order around it \[mm\].
    pub fn corners(&self) -> [[f64; 3]; 4] {
        let [a, b] = [(self.axis + 1) % 3, (self.axis + 2) % 3];
        let corner = |p: f64, q: f64| {
            let mut c = [0.0; 3];
            (c[self.axis], c[a], c[b]) = (self.at, p, q);
            c
        };
        let (low, high) = (self.min, self.max);
        [
            corner(low[a], low[b]),
            corner(high[a], low[b]),
            corner(high[a], high[b]),
            corner(low[a], high[b]),
        ]
    }
}

impl Solid {
    /// A box as a prism along z, from its lowest corner and its lengths along x, y and z \[mm\].
    pub fn rectangle(origin: [f64; 3], [a, b, length]: [f64; 3]) -> Self {
        let corners = [[a, 0.0], [a, b], [0.0, b], [0.0, 0.0]];
        Solid::Prism {
            origin,
            u: [1.0, 0.0, 0.0],
            v: [0.0, 1.0, 0.0],
            start: [0.0; 2],
            edges: corners.map(|to| OutlineEdge::Line { to }).to_vec(),
            length,
        }
    }
}

impl Surface {
    /// Axes of the symmetry planes that pass through a plane piece of surface, and the share of it
    /// on the kept side of all of them.
    pub fn halved_by(&self, planes: &[SymmetryPlane]) -> (Vec<usize>, f64) {
        let through = |axis: &usize| match self {
            Surface::Plane { min, max, .. } => min[*axis] < 0.0 && max[*axis] > 0.0,
            Surface::Mantle { .. } => false,
        };
        let axes: Vec<usize> = planes.iter().map(|p| p.axis).filter(through).collect();
        let share = 0.5_f64.powi(axes.len() as i32);
        (axes, share)
    }
}

/// A named outer face of a part.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct FaceRule {
    /// Identifier, also the name of the physical surface.
    pub name: String,
    /// The part that it belongs to.
    pub part: String,
    /// Position of the face.
    pub surface: Surface,
    /// True if no edges of the part bound the rectangle, so that it must be imprinted (the
    /// footprint of a load or support).
    pub imprint: bool,
}

/// A preloaded bolt. Its shank is cut, and the preload pulls the two sides of the cut together.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct BoltPreload {
    /// The bolt's part.
    pub part: String,
    /// Name of the cut, a physical surface inside the shank.
    pub cut: String,
    /// Surface of the cut: a plane across the shank, wider than the shank.
    pub surface: Surface,
    /// Unit vector along the shank.
    pub axis: [f64; 3],
    /// Preload of the whole bolt \[N\].
    pub force: f64,
}

/// A bolt with the plies that it clamps, from head to nut.
#[derive(Clone, Debug, PartialEq)]
pub struct Grip {
    /// The bolt's part.
    pub part: String,
    /// Unit vector from head to nut, along an axis of the joint.
    pub axis: [f64; 3],
    /// The bolt.
    pub size: BoltSize,
    /// Its grade.
    pub grade: BoltGrade,
    /// Diameter of the holes \[mm\].
    pub hole: f64,
    /// Distance between the bolts of the ply that are farthest apart \[mm\]; the largest of all
    /// plies.
    pub extent: f64,
    /// True for an anchor, held in concrete.
    pub anchored: bool,
    /// The plies, from head to nut.
    pub plies: Vec<Ply>,
}

/// A section of a bolt's shank between two plies.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Section {
    /// The bolt's part.
    pub part: String,
    /// Name, a physical surface inside the shank.
    pub name: String,
    /// A plane across the shank, wider than the shank.
    pub surface: Surface,
}

/// A ply in the grip of a bolt.
#[derive(Clone, Debug, PartialEq)]
pub struct Ply {
    /// Its part.
    pub part: String,
    /// Thickness \[mm\].
    pub thickness: f64,
    /// Ultimate strength of its steel.
    pub fu: Nominal,
    /// The room around the hole; `None` where the hole is in no plate and in no flange or web.
    pub room: Option<Room>,
}

/// Distances from the axis of a hole, on the two axes of the joint across it in rising order, in
/// the negative and the positive direction \[mm\].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Room {
    /// To the edge of the plate, flange or web.
    pub edge: [[f64; 2]; 2],
    /// To the nearest other hole: the part of its distance along the axis. Holes more than 45° off
    /// do not count. Infinite without one.
    pub pitch: [[f64; 2]; 2],
    /// True in a ply that is turned or has an outline: all distances are then the least ones in any
    /// direction, and what follows from them holds for the resultant.
    pub oblique: bool,
}

/// A support on a named face.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct FaceSupport {
    /// Key into [`Assembly::faces`].
    pub face: String,
    /// True for each of x, y, z that is held at zero.
    pub fix: [bool; 3],
    /// The concrete that the face stands on, in place of components that are held; `None`: none.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub ground: Option<Foundation>,
}

/// The load on a named face.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Action {
    /// Constant traction \[MPa\].
    Traction([f64; 3]),
    /// Traction that varies linearly with the position, `t = traction0 + gradient·x`.
    Linear {
        /// Traction at the origin \[MPa\].
        traction0: [f64; 3],
        /// `gradient[i][j] = ∂t_i/∂x_j` \[MPa/mm\].
        gradient: [[f64; 3]; 3],
    },
    /// Force and moment on a section that stays plane and keeps its shape. The axes are global and
    /// moments are right-handed.
    Resultant {
        /// Point through which the force acts and about which the moment is taken \[mm\].
        at: [f64; 3],
        /// Force \[N\].
        force: [f64; 3],
        /// Moment \[N mm\].
        moment: [f64; 3],
    },
}

/// A load on a named face in one load case.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct FaceLoad {
    /// Key into [`Assembly::faces`].
    pub face: String,
    /// Load case.
    pub case: String,
    /// Traction, or force and moment.
    pub action: Action,
    /// True if the load factor does not multiply the load.
    pub dead: bool,
}

/// A joint ready for geometry and meshing. Axes: x along the beams, y across, z up along the column
/// \[mm\].
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Assembly {
    /// Name of the joint.
    pub name: String,
    /// The parts.
    pub parts: Vec<Part>,
    /// Materials by name.
    pub materials: BTreeMap<String, PartMaterial>,
    /// Open interfaces. Parts that touch without an interface or a weld in this assembly are tied.
    pub interfaces: Vec<InterfaceRule>,
    /// Named outer faces.
    pub faces: Vec<FaceRule>,
    /// Supports.
    pub supports: Vec<FaceSupport>,
    /// Loads.
    pub loads: Vec<FaceLoad>,
    /// Detected symmetry planes of the whole joint (geometry, supports and loads).
    pub symmetry: Vec<SymmetryPlane>,
    /// Required clearances between parts that do not touch, checked before meshing.
    pub clearances: Vec<Clearance>,
    /// Fillet welds with a throat above zero.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub welds: Vec<WeldRule>,
    /// Preloaded bolts.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub preloads: Vec<BoltPreload>,
    /// The sections of the shanks, of each bolt from head to nut: one less than its plies.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub sections: Vec<Section>,
    /// The bolts with their plies, for their resistances.
    #[serde(skip)]
    pub grips: Vec<Grip>,
}

/// Two parts with a required distance of at least `min`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Clearance {
    /// The two parts.
    pub between: [String; 2],
    /// Smallest allowed distance \[mm\].
    pub min: f64,
    /// Reason for the distance, for example `bolt pitch` or `wrench`.
    pub reason: String,
}
