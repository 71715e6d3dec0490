//! `MODEL.yaml` (docs/contract.md): the input of `bracket analyse`, which `bracket run` also writes
//! for its own analyses.

use crate::model::AnalysisKind;
use crate::model::FrictionLaw;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// A whole `MODEL.yaml`. Units: mm, N, MPa, N mm.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ModelFile {
    /// gmsh 2.2 or 4.1 ASCII file of 4-node tets, path relative to this file.
    pub mesh: String,
    /// `shared`: bodies share nodes, the reader splits them; `split`: already split, coincident
    /// nodes are paired.
    #[serde(default)]
    pub nodes: Nodes,
    /// Which pair of programs to solve.
    pub analysis: AnalysisKind,
    /// Which bounds to compute.
    #[serde(default)]
    pub bounds: Bounds,
    /// Limit analysis with `friction: coulomb`: estimate the load factor under Coulomb's law by a
    /// fixed point, which solves the kinematic program up to ten times more.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub coulomb_estimate: bool,
    /// Materials by name.
    pub materials: BTreeMap<String, MaterialEntry>,
    /// Material of every physical volume.
    pub bodies: BTreeMap<String, String>,
    /// Interfaces that are not tied.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub interfaces: Vec<InterfaceEntry>,
    /// Supports by component, or rigid ground in contact.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub supports: Vec<SupportEntry>,
    /// Faces that move as rigid bodies.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub rigid: Vec<RigidEntry>,
    /// Loads multiplied by the load factor.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub loads: Vec<LoadEntry>,
    /// Loads not multiplied.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub dead: Vec<LoadEntry>,
    /// Preloaded bolts.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub preload: Vec<PreloadEntry>,
    /// Cross-sections of bodies whose resultants `resultant_limits` names.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub cuts: Vec<CutEntry>,
    /// Limit analysis: limits on the forces through cuts.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub resultant_limits: Vec<ResultantLimitEntry>,
    /// Mesh adaptation; absent: the given mesh only.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub adapt: Option<AdaptEntry>,
    /// How many copies of the meshed part make the structure (1, 2, 4 or 8).
    #[serde(default = "one", skip_serializing_if = "is_one")]
    pub symmetry: u32,
}

fn one() -> u32 {
    1
}
fn is_one(n: &u32) -> bool {
    *n == 1
}

/// How interfaces are stored in the mesh file.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Nodes {
    /// Bodies share nodes.
    #[default]
    Shared,
    /// Each side has its own, coincident nodes.
    Split,
}

/// Which bounds are computed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Bounds {
    /// Both programs.
    #[default]
    Both,
    /// Displacements only: the upper bound.
    Kinematic,
    /// Stresses only: the lower bound.
    Static,
}

/// An isotropic material.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct MaterialEntry {
    /// Young's modulus \[MPa\], 1e-9 to 1e15.
    #[serde(rename = "E")]
    pub e: f64,
    /// Poisson's ratio, −1 < ν ≤ 0.49999.
    pub nu: f64,
    /// Yield strength \[MPa\], 1e-9 to 1e9; absent: never yields.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub fy: Option<f64>,
}

/// Law of an interface.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Law {
    /// Unilateral contact with friction.
    Contact,
    /// No relative motion.
    Tied,
    /// Tied with a bounded traction.
    Weld,
}

/// An initial gap, open positive \[mm\].
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(untagged)]
pub enum Gap {
    /// The same everywhere.
    Constant(f64),
    /// Quadratic polynomial of global coordinates:
    /// `c + g·x + gxx x² + gyy y² + gzz z² + gyz yz + gxz xz + gxy xy`.
    Quadratic {
        /// `[c, gx, gy, gz, gxx, gyy, gzz, gyz, gxz, gxy]`.
        quadratic: [f64; 10],
    },
}

impl Default for Gap {
    fn default() -> Self {
        Gap::Constant(0.0)
    }
}

impl Gap {
    /// The gap at a point \[mm\].
    pub fn at(&self, x: [f64; 3]) -> f64 {
        match self {
            Gap::Constant(g) => *g,
            Gap::Quadratic { quadratic: q } => {
                q[0] + q[1] * x[0]
                    + q[2] * x[1]
                    + q[3] * x[2]
                    + q[4] * x[0] * x[0]
                    + q[5] * x[1] * x[1]
                    + q[6] * x[2] * x[2]
                    + q[7] * x[1] * x[2]
                    + q[8] * x[0] * x[2]
                    + q[9] * x[0] * x[1]
            }
        }
    }

    /// True when the gap is zero everywhere.
    pub fn is_zero(&self) -> bool {
        match self {
            Gap::Constant(g) => *g == 0.0,
            Gap::Quadratic { quadratic } => quadratic.iter().all(|c| *c == 0.0),
        }
    }
}

/// One interface between two bodies.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct InterfaceEntry {
    /// The two bodies; the normal points out of the first.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub between: Option<[String; 2]>,
    /// A physical surface that narrows or replaces `between`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub face: Option<String>,
    /// contact, tied or weld.
    pub law: Law,
    /// Friction coefficient, ≥ 0 (0: frictionless). Required for contact.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub mu: Option<f64>,
    /// Initial gap \[mm\].
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub gap: Option<Gap>,
    /// Friction law.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub friction: Option<FrictionLaw>,
    /// Weld throat \[mm\].
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub throat: Option<f64>,
    /// Thickness of the attached plate \[mm\].
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub thickness: Option<f64>,
    /// Strength of the weld on its throat \[MPa\].
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub strength: Option<f64>,
    /// Strength of the interface per unit area \[MPa\], instead of throat, thickness and strength.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub strength_traction: Option<f64>,
}

/// A coordinate axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Axis {
    /// Global x.
    X,
    /// Global y.
    Y,
    /// Global z.
    Z,
}

/// A support: `fix` components, or `law: contact` against rigid ground.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SupportEntry {
    /// Physical surface.
    pub face: String,
    /// Components held at zero.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub fix: Vec<Axis>,
    /// `contact`: rigid ground.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub law: Option<Law>,
    /// Friction coefficient of the ground.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub mu: Option<f64>,
    /// Initial gap to the ground \[mm\].
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub gap: Option<Gap>,
    /// Pressure at which the ground crushes, in limit analysis \[MPa\]; without it the ground is
    /// rigid.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub strength: Option<f64>,
    /// Pressure per settlement of elastic ground (Winkler), in elastic and elastoplastic analysis
    /// \[N/mm³\]; without it the ground is rigid.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub stiffness: Option<f64>,
    /// Friction law of the ground.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub friction: Option<FrictionLaw>,
}

/// A motion of a rigid face.
#[derive(
    Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize, JsonSchema,
)]
#[serde(rename_all = "snake_case")]
pub enum Motion {
    /// Translation along x.
    Ux,
    /// Translation along y.
    Uy,
    /// Translation along z.
    Uz,
    /// Rotation about x.
    Rx,
    /// Rotation about y.
    Ry,
    /// Rotation about z.
    Rz,
}

/// A face that moves as a rigid body in the listed components.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct RigidEntry {
    /// Physical surface.
    pub face: String,
    /// Components that follow the rigid motion; the others are traction-free.
    pub components: Vec<Axis>,
    /// Motions that are free and carry the given force and moment; the rest are held at zero.
    #[serde(default)]
    pub free: Vec<Motion>,
    /// Reference point of rotation and moment \[mm\].
    #[serde(default)]
    pub at: [f64; 3],
    /// Force on the face, times the load factor \[N\].
    #[serde(default)]
    pub force: [f64; 3],
    /// Moment on the face about `at`, times the load factor \[N mm\].
    #[serde(default)]
    pub moment: [f64; 3],
    /// Force on the face, not multiplied \[N\].
    #[serde(default)]
    pub dead_force: [f64; 3],
    /// Moment on the face about `at`, not multiplied \[N mm\].
    #[serde(default)]
    pub dead_moment: [f64; 3],
}

impl RigidEntry {
    /// Force and moment times the load factor \[N, N mm\].
    pub fn action(&self) -> [f64; 6] {
        six(self.force, self.moment)
    }

    /// Force and moment that are not multiplied \[N, N mm\].
    pub fn dead_action(&self) -> [f64; 6] {
        six(self.dead_force, self.dead_moment)
    }
}

fn six(f: [f64; 3], m: [f64; 3]) -> [f64; 6] {
    [f[0], f[1], f[2], m[0], m[1], m[2]]
}

/// A traction varying linearly with global position: `t = traction0 + gradient·x`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct LinearTraction {
    /// Traction at the origin \[MPa\].
    pub traction0: [f64; 3],
    /// `gradient[i][j] = ∂t_i/∂x_j` \[MPa/mm\].
    pub gradient: [[f64; 3]; 3],
}

/// A load on a face (`traction`, `pressure` or `linear`) or on a body (`force`).
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct LoadEntry {
    /// Physical surface.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub face: Option<String>,
    /// Body, or `ALL`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub body: Option<String>,
    /// Constant traction \[MPa\].
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub traction: Option<[f64; 3]>,
    /// Pressure \[MPa\], positive pushes on the face: t = −p n.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub pressure: Option<f64>,
    /// Linear traction.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub linear: Option<LinearTraction>,
    /// Body force \[N/mm³\].
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub force: Option<[f64; 3]>,
}

/// A preloaded bolt.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PreloadEntry {
    /// Body of the bolt.
    pub body: String,
    /// Physical surface of interior mesh faces that severs the shank.
    pub cut: String,
    /// Direction of the shank.
    pub axis: [f64; 3],
    /// Preload of the meshed part of the bolt \[N\], > 0: the tension in the cut before the loads
    /// come.
    pub force: f64,
}

/// A cross-section of a body.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct CutEntry {
    /// The body.
    pub body: String,
    /// Physical surface of interior mesh faces that severs the body.
    pub cut: String,
    /// Direction out of side A; the resultant is the force of side B on side A, so that tension is
    /// positive along it.
    pub axis: [f64; 3],
}

/// A limit on forces through cuts: `along · R + ‖across R‖ ≤ at_most`, R the sum of the resultants
/// of `cuts` less that of `minus`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ResultantLimitEntry {
    /// Name in messages and results.
    pub name: String,
    /// Cuts whose resultants are added.
    pub cuts: Vec<String>,
    /// Cuts whose resultants are subtracted.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub minus: Vec<String>,
    /// Factors of the linear part.
    #[serde(default, skip_serializing_if = "is_zero")]
    pub along: [f64; 3],
    /// Rows of the norm, at most three.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub across: Vec<[f64; 3]>,
    /// Largest value \[N\], > 0.
    pub at_most: f64,
}

fn is_zero(v: &[f64; 3]) -> bool {
    *v == [0.0; 3]
}

/// Limits of mesh adaptation.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct AdaptEntry {
    /// Relative gap at which to stop, 0 < target < 1.
    pub target_gap: f64,
    /// Number of meshes at most.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub max_passes: Option<u32>,
    /// Macro tets at most.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub max_macro_tets: Option<usize>,
}
