//! Slip on held faces in limit analysis: faces of yielding bodies where supports hold the normal
//! direction and at least one tangential one.
//!
//! Any stress inside the yield surface has a traction of at most k = f_y/√3 along a face. Over a
//! held face where `n·v = 0`, its power against velocities v is therefore at most `k ∫ ‖v_T‖`, v_T
//! the held tangential components. The certificate of the upper bound requires `n·v = 0` at the six
//! Bernstein coefficients, hence everywhere on the face, and adds an upper bound of that integral.
//! Where v vanishes the term is zero. Faces that are also loaded, rigid or in contact must be at
//! rest in all their held components.

use crate::certify::faces::{FaceKey, roles};
use crate::certify::fields::StressField;
use crate::certify::measures::largest;
use crate::certify::tractions::stress_at;
use crate::certify::welds::mean_norm;
use crate::elements::space::{FACE_EDGES, Tet10Space};
use crate::mesh::tet::FACES;
use crate::model::AnalysisModel;
use crate::model::loads::Loads;
use bracket_base::math::Sum;
use bracket_base::math::mandel;
use bracket_base::math::quadrature::{TRIANGLE_4, triangle_p2};
use bracket_base::math::vec3::{self, V3};
use std::collections::{BTreeMap, BTreeSet};

/// Number of times the faces are subdivided for the dissipation.
const SUBDIVISIONS: u32 = 2;
/// A component of the unit normal below this is rounding.
const ROUNDING: f64 = 1e-9;

/// A face held by a support on which a body may slip.
#[derive(Clone, Debug, PartialEq)]
pub struct SlipFace {
    /// Tet and local face.
    pub at: FaceKey,
    /// Number of the first support that holds it.
    pub support: usize,
    /// Vertices, outward order.
    pub nodes: [u32; 3],
    /// Components held by supports.
    pub held: [bool; 3],
    /// Direction of the normal in these components, length 1.
    pub normal: V3,
    /// Area \[mm²\].
    pub area: f64,
    /// Largest traction along the face, k = f_y/√3 \[MPa\].
    pub strength: f64,
}

/// Every slip face of the model, ordered by tet and local face.
pub fn slip_faces(model: &AnalysisModel) -> Vec<SlipFace> {
    let mut first: BTreeMap<FaceKey, usize> = BTreeMap::new();
    for (i, s) in model.supports.iter().enumerate() {
        s.faces.iter().for_each(|f| _ = first.entry((f.tet, f.local)).or_insert(i));
    }
    let rigid: BTreeSet<FaceKey> =
        model.rigid.iter().flat_map(|r| &r.faces).map(|f| (f.tet, f.local)).collect();
    let roles = roles(model, Loads::ALL);
    let slip = |(&at, &support): (&FaceKey, &usize)| -> Option<SlipFace> {
        let role = roles.get(&at)?;
        let alone = role.loads.is_empty() && !role.contact && !role.cut && !rigid.contains(&at);
        let tet = at.0 as usize;
        let body = model.mesh.tet_body[tet] as usize;
        let fy = model.materials[model.body_material[body] as usize].fy?;
        let nodes = FACES[at.1 as usize].map(|i| model.mesh.tets[tet][i]);
        let area = vec3::area_vector(&nodes.map(|n| model.mesh.nodes[n as usize]));
        let size = vec3::norm(area);
        let held = role.reaction;
        let off = largest((0..3).filter(|&d| !held[d]).map(|d| area[d].abs() / size));
        let several = held.iter().filter(|h| **h).count() > 1;
        (alone && several && off <= ROUNDING).then(|| SlipFace {
            at,
            support,
            nodes,
            held,
            normal: vec3::unit(std::array::from_fn(|d| if held[d] { area[d] } else { 0.0 })),
            area: size,
            strength: fy / 3.0f64.sqrt(),
        })
    };
    first.iter().filter_map(slip).collect()
}

impl SlipFace {
    /// Velocities of the six nodes.
    fn velocities(&self, space: &Tet10Space, u: &[V3]) -> [V3; 6] {
        space.triangle(self.nodes).map(|n| u[n])
    }

    /// Normal part of a velocity.
    pub(crate) fn across(&self, v: V3) -> f64 {
        vec3::dot(self.normal, v)
    }

    /// Held tangential part of a velocity.
    fn along(&self, v: V3) -> V3 {
        let across = self.across(v);
        std::array::from_fn(|d| if self.held[d] { v[d] - across * self.normal[d] } else { 0.0 })
    }

    /// Dissipation, an upper bound \[N mm per unit of time\].
    pub fn dissipation(&self, space: &Tet10Space, u: &[V3]) -> f64 {
        let tangential = self.velocities(space, u).map(|v| self.along(v));
        self.strength * self.area * mean_norm(&tangential, SUBDIVISIONS)
    }

    /// Power of the traction of a stress field against the velocities, `∫ σn·v` \[N mm per unit of
    /// time\].
    pub fn power(
        &self,
        model: &AnalysisModel,
        space: &Tet10Space,
        s: &StressField,
        u: &[V3],
    ) -> f64 {
        let n = vec3::unit(vec3::area_vector(&self.nodes.map(|n| model.mesh.nodes[n as usize])));
        let t = stress_at(model, s, self.at, self.nodes).map(|s| mandel::traction(&s, n));
        let v = self.velocities(space, u);
        let terms = TRIANGLE_4.iter().map(|(l, w)| {
            let shape = triangle_p2(*l);
            let v = (0..6).fold([0.0; 3], |s, i| vec3::along(s, shape[i], v[i]));
            let t = (0..3).fold([0.0; 3], |s, i| vec3::along(s, l[i], t[i]));
            w * self.area * vec3::dot(t, v)
        });
        terms.sum()
    }
}

/// Dissipation of the slip on each support, an upper bound \[N mm per unit of time\].
pub fn dissipations(model: &AnalysisModel, space: &Tet10Space, u: &[V3]) -> Vec<f64> {
    let mut out = vec![Sum::default(); model.supports.len()];
    for face in slip_faces(model) {
        out[face.support].add(face.dissipation(space, u));
    }
    out.iter().map(|d| d.value()).collect()
}

/// `∫ k` over the faces that slip \[N\]. Faces at rest can stay so when residuals are removed.
pub fn capacity(model: &AnalysisModel, space: &Tet10Space, u: &[V3]) -> f64 {
    let faces = slip_faces(model).into_iter().filter(|f| f.dissipation(space, u) > 0.0);
    Sum::of(faces.map(|f| f.strength * f.area))
}

/// Largest velocity that supports do not allow: the normal part of the Bernstein coefficients on
/// slip faces, the held components at the nodes of other faces.
pub fn off_supports(model: &AnalysisModel, space: &Tet10Space, u: &[V3]) -> f64 {
    let faces: BTreeMap<FaceKey, SlipFace> =
        slip_faces(model).into_iter().map(|f| (f.at, f)).collect();
    let mut off = 0.0f64;
    for face in faces.values() {
        let v = face.velocities(space, u).map(|v| face.across(v));
        let edges = FACE_EDGES.iter().enumerate();
        let middles = edges.map(|(e, &[p, q])| 2.0 * v[3 + e] - 0.5 * (v[p] + v[q]));
        off = off.max(largest(v[..3].iter().copied().chain(middles).map(f64::abs)));
    }
    for s in &model.supports {
        for f in s.faces.iter().filter(|f| !faces.contains_key(&(f.tet, f.local))) {
            let nodes = FACES[f.local as usize].map(|i| model.mesh.tets[f.tet as usize][i]);
            for n in space.triangle(nodes) {
                off = off.max(largest((0..3).filter(|&d| s.fix[d]).map(|d| u[n][d].abs())));
            }
        }
    }
    off
}
