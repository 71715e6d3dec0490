//! The analysis model: a split mesh with materials, interfaces, supports and loads attached to its
//! faces.
//!
//! The two inputs meet here: a connection spec is translated into a model, a `MODEL.yaml` of the
//! user describes one.

use super::file::{Bounds, Gap};
use super::opening::ConeShift;
use super::resultant_limit::ResultantLimit;
use crate::mesh::TetMesh;
use crate::mesh::split::{OpenPair, TetFace};
use crate::model::AnalysisKind;
use crate::model::FrictionLaw;
use bracket_base::math::mandel::{Isotropic, yield_radius};
use bracket_base::words::Text;
use std::sync::Arc;

/// An isotropic material.
#[derive(Clone, Debug, PartialEq)]
pub struct Material {
    /// Name in the model file.
    pub name: String,
    /// Young's modulus \[MPa\].
    pub e: f64,
    /// Poisson's ratio.
    pub nu: f64,
    /// Yield strength \[MPa\]; `None`: never yields.
    pub fy: Option<f64>,
}

/// One outer face of one tet.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct BoundaryFace {
    /// The tet.
    pub tet: u32,
    /// Which of its faces: the one opposite local vertex `local`, see [`crate::mesh::tet::FACES`].
    pub local: u8,
}

/// A pair of coincident faces, one on each side of an open interface.
///
/// `nodes_a[i]` and `nodes_b[i]` have bit-equal coordinates; `nodes_a` is ordered so that its
/// normal points out of side A.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct FacePair {
    /// The face on side A.
    pub a: BoundaryFace,
    /// The face on side B.
    pub b: BoundaryFace,
    /// Vertices on side A, outward order.
    pub nodes_a: [u32; 3],
    /// The matching vertices on side B.
    pub nodes_b: [u32; 3],
}

impl From<TetFace> for BoundaryFace {
    fn from(face: TetFace) -> Self {
        Self { tet: face.tet, local: face.local }
    }
}

impl From<&OpenPair> for FacePair {
    fn from(pair: &OpenPair) -> Self {
        let (a, b) = (pair.a.into(), pair.b.into());
        Self { a, b, nodes_a: pair.nodes_a, nodes_b: pair.nodes_b }
    }
}

/// Unilateral contact with Coulomb friction.
///
/// # Sign
/// Gap `g = u_B − u_A` and the initial gap count opening positive along the normal out of A; the
/// traction `r = −σ n` on A is positive in pressure, `‖r_T‖ ≤ μ r_N`.
#[derive(Clone, Debug, PartialEq)]
pub struct ContactLaw {
    /// Friction coefficient, ≥ 0.
    pub mu: f64,
    /// Initial gap \[mm\].
    pub gap: Gap,
    /// Friction law: associated or Coulomb.
    pub friction: FrictionLaw,
}

/// An open interface between two sides of the mesh.
#[derive(Clone, Debug, PartialEq)]
pub struct Interface {
    /// Name in messages: `BOLT-PLATE`, or the name of the face.
    pub name: String,
    /// Its law.
    pub law: ContactLaw,
    /// Its face pairs.
    pub faces: Vec<FacePair>,
}

/// A weld of finite strength: its two sides move together until the traction between them reaches
/// the strength.
#[derive(Clone, Debug, PartialEq)]
pub struct Weld {
    /// Name in messages: `WEB-PLATE`, or the name of the face.
    pub name: String,
    /// Largest magnitude of the traction in any direction \[MPa\], per area of the interface.
    pub strength: f64,
    /// Strength on the throat \[MPa\]; `None`: the model gives the strength on the interface only.
    pub throat_strength: Option<f64>,
    /// Its face pairs.
    pub faces: Vec<FacePair>,
}

/// An interface between two bodies tied together along which the weaker one may slip, in limit
/// analysis: the upper bound has velocities with jumps along the interface. The bodies still carry
/// any traction that their own strength permits.
#[derive(Clone, Debug, PartialEq)]
pub struct Tie {
    /// The two bodies: `BEAM-PLATE`.
    pub name: String,
    /// Largest traction along the interface, k = f_y/√3 of the weaker body \[MPa\].
    pub strength: f64,
    /// Its face pairs; the normal of each is along a coordinate axis.
    pub faces: Vec<FacePair>,
}

/// Contact with the rigid ground (side B, at rest).
#[derive(Clone, Debug, PartialEq)]
pub struct GroundContact {
    /// Name of the face.
    pub name: String,
    /// Its law.
    pub law: ContactLaw,
    /// Pressure at which the ground crushes, in limit analysis \[MPa\]; `None`: it never does.
    pub strength: Option<f64>,
    /// Pressure per closing of elastic ground, in elastic and elastoplastic analysis \[N/mm³\];
    /// `None`: the ground is rigid.
    pub stiffness: Option<f64>,
    /// Its faces.
    pub faces: Vec<BoundaryFace>,
}

/// A support by component.
#[derive(Clone, Debug, PartialEq)]
pub struct Support {
    /// Name of the face.
    pub name: String,
    /// Which of x, y, z are held at zero.
    pub fix: [bool; 3],
    /// Its faces.
    pub faces: Vec<BoundaryFace>,
}

/// A face that follows a rigid motion `u = U + θ × (x − at)` in some components.
#[derive(Clone, Debug, PartialEq)]
pub struct RigidFace {
    /// Name of the face.
    pub name: String,
    /// Which of x, y, z follow the motion; the others are traction-free.
    pub components: [bool; 3],
    /// Which of ux, uy, uz, rx, ry, rz are free; the rest are held at zero.
    pub free: [bool; 6],
    /// Reference point \[mm\].
    pub at: [f64; 3],
    /// Force and moment about `at` carried by the free motions, times the load factor \[N, N mm\].
    pub action: [f64; 6],
    /// The same, not multiplied.
    pub dead_action: [f64; 6],
    /// Its faces.
    pub faces: Vec<BoundaryFace>,
}

/// A traction field over faces: `t(x) = traction0 + gradient·x`, or `−p n`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Traction {
    /// `t = traction0 + gradient·x` \[MPa, MPa/mm\].
    Linear {
        /// Traction at the origin.
        traction0: [f64; 3],
        /// `gradient[i][j] = ∂t_i/∂x_j`.
        gradient: [[f64; 3]; 3],
    },
    /// `t = −p n` with n the outward normal \[MPa\].
    Pressure(f64),
}

impl Traction {
    /// True when it is zero everywhere.
    pub fn is_zero(&self) -> bool {
        match self {
            Traction::Linear { traction0, gradient } => {
                *traction0 == [0.0; 3] && *gradient == [[0.0; 3]; 3]
            }
            Traction::Pressure(p) => *p == 0.0,
        }
    }
}

/// A load on faces.
#[derive(Clone, Debug, PartialEq)]
pub struct SurfaceLoad {
    /// Name of the face.
    pub name: String,
    /// True: not multiplied by the load factor.
    pub dead: bool,
    /// The traction.
    pub traction: Traction,
    /// Its faces.
    pub faces: Vec<BoundaryFace>,
}

/// A constant force per volume on one body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BodyLoad {
    /// The body.
    pub body: u32,
    /// True: not multiplied by the load factor.
    pub dead: bool,
    /// Force \[N/mm³\].
    pub force: [f64; 3],
}

/// A rigid motion of the whole assembly that nothing resists and on which no load works: one
/// `[U, θ]` (rotation about the origin, \[mm, rad\]) per part. The programs remove it by holding
/// one dof per mode.
#[derive(Clone, Debug, PartialEq)]
pub struct FreeMode {
    /// `motions[p]` is the motion of part `p`.
    pub motions: Vec<[f64; 6]>,
}

/// A preloaded bolt: a cut severs its shank, and the preload draws one side towards the other along
/// the axis, `u_B − u_A = −δ a`.
#[derive(Clone, Debug, PartialEq)]
pub struct Preload {
    /// Body of the bolt.
    pub body: String,
    /// Name of the cut.
    pub cut: String,
    /// Unit direction a of the shank; the normals out of side A point along it.
    pub axis: [f64; 3],
    /// Preload: the tension in the cut under preload and dead loads alone \[N\], > 0.
    pub force: f64,
    /// Prescribed relative closure δ of the cut \[mm\]; `None`: an unknown, driven by the preload.
    pub closure: Option<f64>,
    /// The faces of the cut; none in limit analysis, where preload has no effect.
    pub faces: Vec<FacePair>,
}

/// A cross-section of a body whose resultant may be limited.
#[derive(Clone, Debug, PartialEq)]
pub struct Cut {
    /// Name of the physical surface.
    pub name: String,
    /// Its face pairs, side A first; none where the kind of analysis has no resultant limits.
    pub faces: Vec<FacePair>,
}

/// Everything the two programs need.
#[derive(Clone, Debug, PartialEq)]
pub struct AnalysisModel {
    /// Kind of analysis.
    pub analysis: AnalysisKind,
    /// Bounds to compute.
    pub bounds: Bounds,
    /// Limit analysis: estimate the load factor under Coulomb's law as well.
    pub coulomb_estimate: bool,
    /// The mesh, split along open interfaces; shared by the load cases of one joint and by models
    /// derived from this one.
    pub mesh: Arc<TetMesh>,
    /// Materials.
    pub materials: Vec<Material>,
    /// Material of each body.
    pub body_material: Vec<u32>,
    /// Part of each tet: bodies tied together are one part.
    pub tet_part: Vec<u32>,
    /// Names of the parts (their bodies joined by `+`).
    pub parts: Vec<String>,
    /// Open interfaces.
    pub interfaces: Vec<Interface>,
    /// Welds of finite strength.
    pub welds: Vec<Weld>,
    /// Limit analysis: tied interfaces along which bodies may slip.
    pub ties: Vec<Tie>,
    /// Contacts with rigid ground.
    pub ground: Vec<GroundContact>,
    /// Shift of the contact cones, fixed during a step of the fixed-point iteration for Coulomb
    /// friction.
    pub shift: ConeShift,
    /// Supports.
    pub supports: Vec<Support>,
    /// Rigid faces.
    pub rigid: Vec<RigidFace>,
    /// Preloaded bolts.
    pub preload: Vec<Preload>,
    /// Cross-sections whose resultants are limited.
    pub cuts: Vec<Cut>,
    /// Limits on these resultants, in limit analysis.
    pub resultant_limits: Vec<ResultantLimit>,
    /// Surface loads.
    pub surface_loads: Vec<SurfaceLoad>,
    /// Body loads.
    pub body_loads: Vec<BodyLoad>,
    /// Rigid motions that nothing resists and on which no load works.
    pub free_modes: Vec<FreeMode>,
    /// Number of copies of the meshed part that make the structure.
    pub symmetry: u32,
    /// Assumptions and warnings of the reader, for the report.
    pub notes: Vec<Text>,
}

impl AnalysisModel {
    /// Shares the mesh of another model if both meshes are equal.
    pub fn share_mesh(&mut self, other: &Self) {
        if self.mesh == other.mesh {
            self.mesh = other.mesh.clone();
        }
    }

    /// The faces of all welds, weld by weld, each with the strength of its weld \[MPa\].
    pub fn weld_faces(&self) -> impl Iterator<Item = (f64, &FacePair)> {
        self.welds.iter().flat_map(|w| w.faces.iter().map(|f| (w.strength, f)))
    }

    /// The faces of all cuts: those of preloaded bolts and those whose resultants are limited.
    pub fn cut_faces(&self) -> impl Iterator<Item = &FacePair> {
        let preloaded = self.preload.iter().flat_map(|p| &p.faces);
        preloaded.chain(self.cuts.iter().flat_map(|c| &c.faces))
    }

    /// The faces of all ties, tie by tie, each with the strength of its tie \[MPa\].
    pub fn tie_faces(&self) -> impl Iterator<Item = (f64, &FacePair)> {
        self.ties.iter().flat_map(|t| t.faces.iter().map(|f| (t.strength, f)))
    }

    /// Elastic stiffness of each body.
    pub fn stiffnesses(&self) -> Vec<Isotropic> {
        self.body_material
            .iter()
            .map(|&m| {
                let m = &self.materials[m as usize];
                Isotropic::new(m.e, m.nu)
            })
            .collect()
    }

    /// Radius of the yield surface `‖dev σ‖ ≤ √(2/3) f_y` of each body \[MPa\]; `None`: never
    /// yields.
    pub fn yield_radii(&self) -> Vec<Option<f64>> {
        let radius = |m: &u32| self.materials[*m as usize].fy.map(yield_radius);
        self.body_material.iter().map(radius).collect()
    }

    /// Part of each node.
    pub fn node_parts(&self) -> Vec<u32> {
        let mut part = vec![0; self.mesh.nodes.len()];
        for (t, &p) in self.mesh.tets.iter().zip(&self.tet_part) {
            t.iter().for_each(|&n| part[n as usize] = p);
        }
        part
    }
}
