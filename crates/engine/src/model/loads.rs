//! Loads: factors of live and dead loads, tractions on faces, forces in bodies.

use super::analysis::{AnalysisModel, BoundaryFace, RigidFace, SurfaceLoad, Traction};
use super::error::ModelError;
use crate::mesh::TetMesh;
use crate::mesh::tet::FACES;
use bracket_base::math::vec3::{self, V3};

/// Factors of the live and of the dead loads.
///
/// In limit analysis the load factor multiplies the live loads only: `factor · live + dead`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Loads {
    /// Factor of the loads that carry the load factor.
    pub live: f64,
    /// Factor of the loads that do not.
    pub dead: f64,
}

impl Loads {
    /// Every load with factor 1: the elastic analyses.
    pub const ALL: Self = Self { live: 1.0, dead: 1.0 };
    /// The loads that carry the load factor, alone.
    pub const LIVE: Self = Self { live: 1.0, dead: 0.0 };
    /// The loads that do not, alone.
    pub const DEAD: Self = Self { live: 0.0, dead: 1.0 };

    /// `factor · live + dead`.
    pub fn at(factor: f64) -> Self {
        Self { live: factor, dead: 1.0 }
    }

    /// Factor of a load.
    pub fn share(self, dead: bool) -> f64 {
        if dead { self.dead } else { self.live }
    }

    /// Force and moment on a rigid face \[N, N mm\].
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

    /// True when some load other than zero does not carry the load factor.
    pub fn has_dead_loads(&self) -> bool {
        self.surface_loads.iter().any(|l| l.dead && !l.traction.is_zero())
            || self.body_loads.iter().any(|l| l.dead && l.force != [0.0; 3])
            || self.rigid.iter().any(|r| r.dead_action.iter().any(|a| *a != 0.0))
    }

    /// Checks the requirements of limit analysis: a body that yields or a contact or weld that
    /// gives way, a live load, and no live force per volume. Bodies without a yield strength are
    /// rigid.
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

    /// True when some bolt is preloaded; in limit analysis preload has no effect.
    pub fn has_preload(&self) -> bool {
        !self.preload.is_empty()
    }

    /// The model under `factor` times its live loads; the dead loads stay as they are.
    pub fn at_load_factor(&self, factor: f64) -> Self {
        let mut out = self.clone();
        let scaled = |x: [f64; 3]| vec3::scale(factor, x);
        for load in out.surface_loads.iter_mut().filter(|l| !l.dead) {
            load.traction = match load.traction {
                Traction::Pressure(p) => Traction::Pressure(factor * p),
                Traction::Linear { traction0, gradient } => Traction::Linear {
                    traction0: scaled(traction0),
                    gradient: gradient.map(scaled),
                },
            };
        }
        for load in out.body_loads.iter_mut().filter(|l| !l.dead) {
            load.force = scaled(load.force);
        }
        out.rigid.iter_mut().for_each(|r| r.action = r.action.map(|a| factor * a));
        out
    }

    /// The model with all strengths multiplied: of materials, welds and crushing ground.
    pub fn with_strengths_times(&self, part: f64) -> Self {
        let mut out = self.clone();
        out.materials.iter_mut().for_each(|m| m.fy = m.fy.map(|fy| part * fy));
        out.welds.iter_mut().for_each(|w| w.strength *= part);
        out.ground.iter_mut().for_each(|g| g.strength = g.strength.map(|f| part * f));
        out
    }

    /// The model under its dead loads alone.
    pub fn without_live_loads(&self) -> Self {
        let mut dead = self.clone();
        dead.surface_loads.retain(|l| l.dead);
        dead.body_loads.retain(|l| l.dead);
        dead.rigid.iter_mut().for_each(|r| r.action = [0.0; 6]);
        dead
    }
}
