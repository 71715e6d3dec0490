//! Tied interfaces along which bodies may slip, in limit analysis.
//!
//! Two bodies are tied where they share faces and no entry of `interfaces` opens these. A slip
//! costs `k ∫ ‖v_T‖`, k = f_y/√3 of the weaker body. Faces whose normal is not along a coordinate
//! axis stay closed: without a slip the upper bound is valid too.

use super::claims::Claims;
use crate::mesh::TetMesh;
use crate::mesh::split::{OpenPair, TetFace};
use crate::mesh::topology::FaceTable;
use crate::model::analysis::{FacePair, Material, Tie};
use bracket_base::math::mandel::yield_radius;
use bracket_base::math::vec3;
use std::collections::BTreeMap;

/// A tie before the nodes are split.
pub(super) struct Tied {
    name: String,
    strength: f64,
    /// Side A and side B of each face.
    pub faces: Vec<[TetFace; 2]>,
}

/// The tied interfaces of a mesh on which bodies may slip.
pub(super) fn ties(
    mesh: &TetMesh,
    table: &FaceTable,
    claims: &Claims,
    materials: &[Material],
    body_material: &[u32],
) -> Vec<Tied> {
    let body = |f: TetFace| mesh.tet_body[f.tet as usize] as usize;
    let mut pairs: BTreeMap<(usize, usize), Vec<[TetFace; 2]>> = BTreeMap::new();
    for rows in table.faces() {
        let [p, q] = rows else { continue };
        let (p, q) = (TetFace::from(p), TetFace::from(q));
        if body(p) == body(q) || claims.is_open(p.min(q)) {
            continue;
        }
        let corners = rows[0].key.map(|n| mesh.nodes[n as usize]);
        if vec3::axis_of(vec3::unit(vec3::area_vector(&corners))).is_none() {
            continue;
        }
        let [a, b] = if body(p) < body(q) { [p, q] } else { [q, p] };
        pairs.entry((body(a), body(b))).or_default().push([a, b]);
    }
    let fy = |body: usize| materials.get(*body_material.get(body)? as usize)?.fy;
    let tie = |((a, b), faces): ((usize, usize), Vec<[TetFace; 2]>)| {
        let weaker = [fy(a), fy(b)].into_iter().flatten().reduce(f64::min)?;
        let name = format!("{}-{}", mesh.bodies[a], mesh.bodies[b]);
        Some(Tied { name, strength: yield_radius(weaker) / 2.0f64.sqrt(), faces })
    };
    pairs.into_iter().filter_map(tie).collect()
}

/// The ties once the nodes are split; `pairs` are in their order.
pub(super) fn opened(ties: Vec<Tied>, pairs: &[OpenPair]) -> Vec<Tie> {
    let mut rest = pairs;
    let tie = |t: Tied| {
        let (mine, others) = rest.split_at(t.faces.len());
        rest = others;
        Tie { name: t.name, strength: t.strength, faces: mine.iter().map(FacePair::from).collect() }
    };
    ties.into_iter().map(tie).collect()
}
