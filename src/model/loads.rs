//! Loads: which of them count and how much, tractions on faces, forces in bodies.

use super::analysis::{AnalysisModel, BoundaryFace, ContactLaw, RigidFace, SurfaceLoad, Traction};
use crate::math::vec3::{self, V3};
use crate::mesh::TetMesh;
use crate::mesh::tet::FACES;
use crate::model::ModelError;
use crate::spec::friction::FrictionLaw;

/// How much of the live and of the dead loads counts.
///
/// In limit analysis the load factor multiplies the live loads alone: `factor · live + dead`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Loads {
    /// Multiplies the loads that carry the load factor.
    pub live: f64,
    /// Multiplies the loads that do not.
    pub dead: f64,
}

impl Loads {
    /// Every load as it stands: the elastic analyses.
    pub const ALL: Self = Self { live: 1.0, dead: 1.0 };
    /// What the load factor multiplies, alone.
    pub const LIVE: Self = Self { live: 1.0, dead: 0.0 };
    /// What it does not, alone.
    pub const DEAD: Self = Self { live: 0.0, dead: 1.0 };

    /// `factor · live + dead`.
    pub fn at(factor: f64) -> Self {
        Self { live: factor, dead: 1.0 }
    }

    /// How much a load counts.
    pub fn share(self, dead: bool) -> f64 {
        if dead { self.dead } else { self.live }
    }

    /// What acts on a rigid face: force and moment \[N, N mm\].
    pub fn action(self, rigid: &RigidFace) -> [f64; 6] {
        std::array::from_fn(|i| self.live * rigid.action[i] + self.dead * rigid.dead_action[i])
    }
}

/// Corner nodes of a boundary face, outward order.
pub fn face_nodes(mesh: &TetMesh, f: &BoundaryFace) -> [u32; 3] {
    FACES[f.local as usize].map(|i| mesh.tets[f.tet as usize][i])
}

/// Coordinates of the corners of a boundary face, outward order \[mm\].
pub fn face_corners(mesh: &TetMesh, f: &BoundaryFace) -> [V3; 3] {
    face_nodes(mesh, f).map(|n| mesh.nodes[n as usize])
}

impl SurfaceLoad {
    /// The traction at `x` on a face with outward unit normal `n` \[MPa\].
    pub fn at(&self, x: V3, n: V3) -> V3 {
        match self.traction {
            Traction::Linear { traction0, gradient } => {
                vec3::add(traction0, vec3::mul(&gradient, x))
            }
            Traction::Pressure(p) => vec3::scale(-p, n),
        }
    }
}

impl AnalysisModel {
    /// Force per volume of each body \[N/mm³\].
    pub fn body_forces(&self, loads: Loads) -> Vec<V3> {
        let mut f = vec![[0.0; 3]; self.mesh.bodies.len()];
        for load in &self.body_loads {
            let more = vec3::scale(loads.share(load.dead), load.force);
            f[load.body as usize] = vec3::add(f[load.body as usize], more);
        }
        f
    }

    /// True when some load does not carry the load factor.
    pub fn has_dead_loads(&self) -> bool {
        self.surface_loads.iter().any(|l| l.dead)
            || self.body_loads.iter().any(|l| l.dead)
            || self.rigid.iter().any(|r| r.dead_action.iter().any(|a| *a != 0.0))
    }

    /// What limit analysis asks of a model: something that can give way, a live load, and no live
    /// force per volume. Bodies without a yield strength are rigid.
    pub fn check_limit_analysis(&self) -> Result<(), ModelError> {
        let name = |body: usize| self.mesh.bodies[body].clone();
        let slips =
            !(self.interfaces.is_empty() && self.welds.is_empty() && self.ground.is_empty());
        if self.yield_radii().iter().all(Option::is_none) && !slips {
            return Err(ModelError::NothingYields);
        }
        if let Some(load) = self.body_loads.iter().find(|l| !l.dead) {
            return Err(ModelError::LiveBodyForce(name(load.body as usize)));
        }
        let live = self.surface_loads.iter().any(|l| !l.dead);
        if !live && self.rigid.iter().all(|r| r.action.iter().all(|a| *a == 0.0)) {
            return Err(ModelError::NoLiveLoad);
        }
        Ok(())
    }

    /// True when some bolt is preloaded; in limit analysis preload drops out.
    pub fn has_preload(&self) -> bool {
        !self.preload.is_empty()
    }

    /// True when some contact has friction.
    pub fn has_friction(&self) -> bool {
        self.interfaces.iter().any(|i| i.law.mu > 0.0) || self.ground.iter().any(|g| g.law.mu > 0.0)
    }

    /// Whether some contact with friction follows Coulomb's law.
    pub fn has_coulomb(&self) -> bool {
        let coulomb = |l: &ContactLaw| l.mu > 0.0 && l.friction == FrictionLaw::Coulomb;
        self.interfaces.iter().any(|i| coulomb(&i.law))
            || self.ground.iter().any(|g| coulomb(&g.law))
    }

    /// The model with every contact smooth.
    pub fn without_friction(&self) -> Self {
        let mut smooth = self.clone();
        smooth.interfaces.iter_mut().for_each(|i| i.law.mu = 0.0);
        smooth.ground.iter_mut().for_each(|g| g.law.mu = 0.0);
        smooth
    }

    /// The model under its dead loads alone.
    pub fn without_live_loads(&self) -> Self {
        let mut dead = self.clone();
        dead.surface_loads.retain(|l| l.dead);
        dead.body_loads.retain(|l| l.dead);
        dead.rigid.iter_mut().for_each(|r| r.action = [0.0; 6]);
        dead
    }

    /// Stiffness of the material of each body.
    pub fn stiffnesses(&self) -> Vec<crate::math::mandel::Isotropic> {
        self.body_material
            .iter()
            .map(|&m| {
                let m = &self.materials[m as usize];
                crate::math::mandel::Isotropic::new(m.e, m.nu)
            })
            .collect()
    }

    /// Radius of the yield surface `‖dev σ‖ ≤ √(2/3) f_y` of each body \[MPa\]; `None`: never
    /// yields.
    pub fn yield_radii(&self) -> Vec<Option<f64>> {
        let radius =
            |m: &u32| self.materials[*m as usize].fy.map(crate::math::mandel::yield_radius);
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
