//! Slip on held faces in limit analysis.
//!
//! A von Mises body may slip along a face that a support holds: the traction there is at most
//! k = f_y/√3 along the face. Velocities of the upper bound therefore keep the normal velocity zero
//! on such a face, and their tangential part v_T costs `k ∫ ‖v_T‖ dA`. Continuous velocities that
//! vanish on the whole face omit these mechanisms, on any mesh.
//!
//! # Which faces
//! Faces of bodies with a yield strength on which supports hold the normal direction and at least
//! one tangential one. Only held tangential components cost; along the others the face is free of
//! traction. Faces that are also loaded, rigid or in contact, and faces where only the normal or
//! only tangential components are held, keep all their held components at zero.
//!
//! # Why the bound is strict
//! Let σ be a stress field in equilibrium with `λ · live + dead` and inside the yield surface, and
//! v velocities that are continuous in the body. The power of σ is
//! `∫ σ:ε(v) = λ P_live + P_dead + ∫ σn·v`, the last integral over the held faces. There v has no
//! normal part, and σn no part along components that are not held, so that `−σn·v ≤ k ‖v_T‖`. With
//! `σ:ε ≤ π(ε)`: `λ P_live ≤ ∫ π(ε) + k ∫ ‖v_T‖ − P_dead`. (The slip is the limit of a thin layer
//! of the body's own material, sheared against the wall.) The integrals run over faces, each with
//! its own normal. Edges have no area: where a slip face meets a free face, a contact or a
//! weld, nothing more is required than the conditions of that face. Where it meets faces that hold
//! their points (symmetry planes, other slip faces, rigid faces), a point on the edge satisfies the
//! conditions of all its faces.
//!
//! # Discretisation
//! v is quadratic on a face, so its norm is at most the norms of its six Bernstein coefficients
//! weighted with the Bernstein polynomials, each of mean 1/6: the element of
//! [`crate::programs::weld_face`] without normal component.

use crate::elements::space::Tet10Space;
use crate::model::AnalysisModel;
use crate::model::analysis::BoundaryFace;
use crate::model::loads::{face_corners, face_nodes};
use crate::programs::constraints::FacePoints;
use crate::programs::weld_face::{Form, Jump, bernstein};
use bracket_base::math::vec3::{self, V3};
use std::collections::{BTreeMap, BTreeSet};

/// Sines of angles below this are rounding of the coordinates: such directions are parallel.
const PARALLEL: f64 = 1e-12;

/// A face on which a body may slip.
#[derive(Clone, Debug, PartialEq)]
pub struct SlipFace {
    /// The face.
    pub face: BoundaryFace,
    /// Its outward unit normal.
    pub normal: V3,
    /// Its area \[mm²\].
    pub area: f64,
    /// Unit vectors of the held tangential directions, one or two.
    pub along: Vec<V3>,
    /// Largest traction along the face, k = f_y/√3 \[MPa\].
    pub strength: f64,
}

/// The slip faces of a model.
pub fn slip_faces(model: &AnalysisModel) -> Vec<SlipFace> {
    let key = |f: &BoundaryFace| (f.tet, f.local);
    let mut held: BTreeMap<(u32, u8), [bool; 3]> = BTreeMap::new();
    for s in &model.supports {
        for f in &s.faces {
            let fix = held.entry(key(f)).or_default();
            (0..3).for_each(|d| fix[d] |= s.fix[d]);
        }
    }
    let loads = model.surface_loads.iter().flat_map(|l| &l.faces);
    let rigid = model.rigid.iter().flat_map(|r| &r.faces);
    let ground = model.ground.iter().flat_map(|g| &g.faces);
    let contacts = model.interfaces.iter().flat_map(|i| &i.faces);
    let pairs = contacts.chain(model.welds.iter().flat_map(|w| &w.faces));
    let others = loads.chain(rigid).chain(ground).map(key);
    let taken: BTreeSet<_> = others.chain(pairs.flat_map(|f| [key(&f.a), key(&f.b)])).collect();
    let radii = model.yield_radii();
    let slip = |(at, fix): ((u32, u8), [bool; 3])| -> Option<SlipFace> {
        let radius = radii[model.mesh.tet_body[at.0 as usize] as usize]?;
        let face = BoundaryFace { tet: at.0, local: at.1 };
        let area = vec3::area_vector(&face_corners(&model.mesh, &face));
        let normal = without_rounding(vec3::unit(area));
        let along = held_tangents(normal, fix)?;
        let (area, strength) = (vec3::norm(area), radius / 2.0f64.sqrt());
        (!taken.contains(&at)).then_some(SlipFace { face, normal, area, along, strength })
    };
    held.into_iter().filter_map(slip).collect()
}

/// A unit vector without the components that are rounding.
fn without_rounding(n: V3) -> V3 {
    vec3::unit(n.map(|c| if c.abs() > PARALLEL { c } else { 0.0 }))
}

/// The held directions along a face with the unit normal `n`; `None` where the normal is not held,
/// or nothing else is.
fn held_tangents(n: V3, fix: [bool; 3]) -> Option<Vec<V3>> {
    if (0..3).any(|d| !fix[d] && n[d] != 0.0) {
        return None;
    }
    match (0..3).filter(|&d| !fix[d]).collect::<Vec<_>>()[..] {
        [] => {
            let (a, b) = vec3::tangents(n);
            Some(vec![a, b])
        }
        [free] => {
            let axis: V3 = std::array::from_fn(|d| f64::from(u8::from(d == free)));
            Some(vec![vec3::cross(axis, n)])
        }
        _ => None,
    }
}

impl SlipFace {
    /// The Bernstein coefficients of the held tangential velocity, each times its weight in the
    /// integral if `weighted`, on nodal velocities.
    pub fn jumps(&self, model: &AnalysisModel, space: &Tet10Space, weighted: bool) -> Vec<Jump> {
        let weight = if weighted { self.area / 6.0 } else { 1.0 };
        let nodes = space.triangle(face_nodes(&model.mesh, &self.face));
        let form = |i: usize, t: Option<&V3>| -> Form {
            let Some(&t) = t else { return Form::new() };
            let terms = bernstein(i)
                .into_iter()
                .flat_map(|(k, w)| (0..3).map(move |d| (3 * nodes[k] + d, weight * w * t[d])));
            terms.filter(|(_, w)| *w != 0.0).collect()
        };
        (0..6).map(|i| [0, 1, 2].map(|c| form(i, self.along.get(c)))).collect()
    }
}

/// What supports hold at the points of a program: components, and oblique directions.
#[derive(Clone, Debug, Default)]
pub struct HeldPoints {
    /// Held components of each point.
    pub fixed: Vec<[bool; 3]>,
    /// Points held along directions that are no coordinate axes: the velocity as a combination of
    /// its own components, `v = M v`. A component with `M[d][d] = 1` is free, the others follow.
    pub oblique: BTreeMap<usize, [V3; 3]>,
}

impl HeldPoints {
    /// The held points with the given slip faces; `moved` is true for points of rigid faces and
    /// bodies. Oblique faces hold such points in all their components.
    pub fn new(
        model: &AnalysisModel,
        points: &impl FacePoints,
        slips: &[SlipFace],
        moved: impl Fn(usize) -> bool,
    ) -> Self {
        let slip: BTreeSet<_> = slips.iter().map(|s| (s.face.tet, s.face.local)).collect();
        let mut glued = vec![[false; 3]; points.count()];
        let mut fixed = glued.clone();
        for s in &model.supports {
            for f in &s.faces {
                let slips = slip.contains(&(f.tet, f.local));
                for p in points.points(f) {
                    (0..3).for_each(|d| glued[p][d] |= s.fix[d]);
                    (0..3).for_each(|d| fixed[p][d] |= s.fix[d] && !slips);
                }
            }
        }
        let mut normals: BTreeMap<usize, Vec<V3>> = BTreeMap::new();
        for s in slips {
            points.points(&s.face).into_iter().for_each(|p| {
                normals.entry(p).or_default().push(s.normal);
            });
        }
        let mut out = Self { fixed, oblique: BTreeMap::new() };
        for (p, normals) in normals {
            match held_span(out.fixed[p], &normals) {
                Held::Components(held) => out.fixed[p] = held,
                Held::Oblique(_) if moved(p) => out.fixed[p] = glued[p],
                Held::Oblique(velocity) => _ = out.oblique.insert(p, velocity),
            }
        }
        out
    }
}

/// Directions held at a point.
enum Held {
    /// Coordinate axes.
    Components([bool; 3]),
    /// Others: the velocity as in [`HeldPoints::oblique`].
    Oblique([V3; 3]),
}

/// The span of coordinate axes and unit normals.
fn held_span(fixed: [bool; 3], normals: &[V3]) -> Held {
    let axis = |d: usize| -> V3 { std::array::from_fn(|i| f64::from(u8::from(i == d))) };
    let mut basis: Vec<V3> = (0..3).filter(|&d| fixed[d]).map(axis).collect();
    for &n in normals {
        // twice: the first remainder of nearly parallel normals is not orthogonal to rounding
        let rest = |n: V3| basis.iter().fold(n, |r, b| vec3::along(r, -vec3::dot(r, *b), *b));
        let r = rest(n);
        if vec3::norm(r) > PARALLEL {
            let b = without_rounding(vec3::unit(rest(vec3::unit(r))));
            basis.push(b);
        }
    }
    if basis.len() >= 3 {
        return Held::Components([true; 3]);
    }
    // the projection on the span is diagonal when coordinate axes span it
    let entry = |i: usize, j: usize| basis.iter().map(|b| b[i] * b[j]).sum::<f64>();
    if [(0, 1), (1, 2), (0, 2)].iter().all(|&(i, j)| entry(i, j).abs() <= PARALLEL) {
        return Held::Components(std::array::from_fn(|d| entry(d, d) > 0.5));
    }
    let largest = |v: V3| (0..3).fold(0, |k, d| if v[d].abs() > v[k].abs() { d } else { k });
    match basis[..] {
        [n] => {
            let k = largest(n);
            let mut velocity = [axis(0), axis(1), axis(2)];
            velocity[k] = std::array::from_fn(|d| if d == k { 0.0 } else { -n[d] / n[k] });
            Held::Oblique(velocity)
        }
        [a, b, ..] => {
            let t = without_rounding(vec3::unit(vec3::cross(a, b)));
            let k = largest(t);
            Held::Oblique(std::array::from_fn(|d| vec3::scale(t[d] / t[k], axis(k))))
        }
        [] => Held::Components(fixed),
    }
}
