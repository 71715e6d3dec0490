//! Search for a load factor without limit: pressures that carry the live loads alone, see
//! [`crate::certify::unlimited`].
//!
//! Without a deviator the stress is `σ = −p I`, and equilibrium makes `p = c + b·x` with b the live
//! body force. Limit analysis refuses live body forces, so that b = 0 in every run; the terms in b
//! keep the field in equilibrium with any model. Tractions are continuous, so that c is one
//! constant in each connected piece of a body. Least squares on the faces find these constants.

use crate::certify::faces::{FaceKey, FaceRole, contact_faces, roles, tie_faces, weld_faces};
use crate::certify::fields::StressField;
use crate::certify::measures::largest;
use crate::certify::unlimited::{Unlimited, UnlimitedCertificate, certify_unlimited};
use crate::elements::super_element::SuperElement;
use crate::mesh::numbering::FaceNumbering;
use crate::mesh::tet::FACES;
use crate::model::AnalysisModel;
use crate::model::analysis::RigidFace;
use crate::model::loads::{Loads, face_corners};
use bracket_base::math::dense::{Mat, pseudo_solve};
use bracket_base::math::quadrature::TRIANGLE_4;
use bracket_base::math::vec3::{self, V3};
use std::collections::BTreeMap;

/// The pressures that carry the live loads alone; `None` where there are none. `dead` gives a
/// strictly admissible field of the dead loads; it is called only when pressures are found and dead
/// loads act.
pub fn find<E>(
    model: &AnalysisModel,
    dead: impl FnOnce() -> Result<Option<StressField>, E>,
) -> Result<Option<Unlimited>, E> {
    // a rigid body carries more than pressures, and a limited resultant has a limit
    if !model.resultant_limits.is_empty() {
        return Ok(None);
    }
    if model.yield_radii().iter().any(Option::is_none) {
        return Ok(None);
    }
    let field = pressures(model);
    let alone = UnlimitedCertificate { unproved: false, ..certify_unlimited(model, &field, None) };
    if !alone.is_strict() {
        return Ok(None);
    }
    let dead = if model.has_dead_loads() { dead()? } else { None };
    let certificate = certify_unlimited(model, &field, dead.as_ref());
    Ok(certificate.is_strict().then_some(Unlimited { field, dead, certificate }))
}

/// Connected pieces of the bodies, tets joined by their faces: the piece of each tet, and the
/// number of pieces.
fn pieces(model: &AnalysisModel, faces: &FaceNumbering) -> (Vec<usize>, usize) {
    let mesh = &model.mesh;
    let mut piece = vec![usize::MAX; mesh.tets.len()];
    let mut count = 0;
    for first in 0..mesh.tets.len() {
        if piece[first] != usize::MAX {
            continue;
        }
        piece[first] = count;
        let mut next = vec![first];
        while let Some(e) = next.pop() {
            for f in faces.of_tet[e] {
                let (a, b) = faces.tets[f as usize];
                for o in [Some(a), b].into_iter().flatten().map(|o| o as usize) {
                    if piece[o] == usize::MAX && mesh.tet_body[o] == mesh.tet_body[e] {
                        piece[o] = count;
                        next.push(o);
                    }
                }
            }
        }
        count += 1;
    }
    (piece, count)
}

/// Normal equations for the constants of the pieces.
struct Normal {
    gram: Mat<f64>,
    rhs: Mat<f64>,
}

impl Normal {
    /// Adds `weight · (Σ row·c − value)²`.
    fn add(&mut self, weight: f64, row: &[(usize, f64)], value: f64) {
        for &(i, a) in row {
            self.rhs[(i, 0)] += weight * a * value;
            row.iter().for_each(|&(j, b)| self.gram[(i, j)] += weight * a * b);
        }
    }
}

/// The field of pressures that comes nearest to equilibrium with the live loads alone.
fn pressures(model: &AnalysisModel) -> StressField {
    let mesh = &model.mesh;
    let faces = FaceNumbering::new(mesh);
    let (piece, count) = pieces(model, &faces);
    let bodies = model.body_forces(Loads::LIVE);
    // the pressure due to body forces
    let own = |e: usize, x: V3| vec3::dot(bodies[mesh.tet_body[e] as usize], x);
    let roles = roles(model, Loads::LIVE);
    let mut normal = Normal { gram: Mat::zeros(count, count), rhs: Mat::zeros(count, 1) };
    for e in 0..mesh.tets.len() {
        for k in 0..4 {
            let (first, second) = faces.tets[faces.of_tet[e][k] as usize];
            let corners = FACES[k].map(|i| mesh.nodes[mesh.tets[e][i] as usize]);
            let vector = vec3::area_vector(&corners);
            let area = vec3::norm(vector);
            let n = vec3::scale(1.0 / area, vector);
            match second.map(|s| s as usize) {
                Some(other) if first as usize == e && piece[other] != piece[e] => {
                    for x in corners {
                        normal.add(
                            area,
                            &[(piece[e], 1.0), (piece[other], -1.0)],
                            own(other, x) - own(e, x),
                        );
                    }
                }
                Some(_) => {}
                None => {
                    let role = roles.get(&(e as u32, k as u8));
                    if role.is_some_and(|r| r.contact) {
                        continue;
                    }
                    for x in corners {
                        let load = role.map_or([0.0; 3], |r| r.load(x, n));
                        for d in (0..3).filter(|&d| !role.is_some_and(|r| r.reaction[d])) {
                            normal.add(area, &[(piece[e], -n[d])], load[d] + own(e, x) * n[d]);
                        }
                    }
                }
            }
        }
    }
    for f in contact_faces(model) {
        let Some((b, _)) = f.b else { continue };
        let (n, area) = f.normal(model);
        let role = roles.get(&(f.a.tet, f.a.local));
        let (a, b) = (f.a.tet as usize, b.tet as usize);
        for x in f.corners(model) {
            let load = vec3::dot(role.map_or([0.0; 3], |r| r.load(x, n)), n);
            normal.add(area, &[(piece[a], 1.0), (piece[b], -1.0)], own(b, x) - own(a, x) - load);
        }
    }
    for f in tie_faces(model) {
        let Some((b, _)) = f.b else { continue };
        let (_, area) = f.normal(model);
        let (a, b) = (f.a.tet as usize, b.tet as usize);
        for x in f.corners(model) {
            normal.add(area, &[(piece[a], 1.0), (piece[b], -1.0)], own(b, x) - own(a, x));
        }
    }
    // a weld may carry no multiple of any traction: no pressure on either side, except for loads on
    // the face itself
    for f in weld_faces(model) {
        let (n, area) = f.normal(model);
        for (side, sign) in [Some((f.a, 1.0)), f.b.map(|b| (b.0, -1.0))].into_iter().flatten() {
            let role = roles.get(&(side.tet, side.local));
            let tet = side.tet as usize;
            for x in f.corners(model) {
                let load =
                    sign * vec3::dot(role.map_or([0.0; 3], |r| r.load(x, vec3::scale(sign, n))), n);
                normal.add(area, &[(piece[tet], 1.0)], -own(tet, x) - load);
            }
        }
    }
    for rigid in &model.rigid {
        add_resultants(model, rigid, &roles, &piece, &own, &mut normal);
    }
    let constants = pseudo_solve(&normal.gram, &normal.rhs);
    let points = (0..mesh.tets.len())
        .map(|e| {
            let at = SuperElement::points(&mesh.corners(e));
            at.map(|subtet| {
                subtet.map(|x| {
                    let p = constants[(piece[e], 0)] + own(e, x);
                    [-p, -p, -p, 0.0, 0.0, 0.0]
                })
            })
        })
        .collect();
    StressField { points }
}

/// Adds the equations that the resultants on a rigid face equal its live action, as tractions.
fn add_resultants(
    model: &AnalysisModel,
    rigid: &RigidFace,
    roles: &BTreeMap<FaceKey, FaceRole>,
    piece: &[usize],
    own: &impl Fn(usize, V3) -> f64,
    normal: &mut Normal,
) {
    let action = Loads::LIVE.action(rigid);
    // resultants of a unit pressure in each piece, and of the known terms
    let mut rows = vec![BTreeMap::<usize, f64>::new(); 6];
    let mut known = [0.0; 6];
    let (mut total, mut reach) = (0.0, 0.0f64);
    for f in &rigid.faces {
        let corners = face_corners(&model.mesh, f);
        let vector = vec3::area_vector(&corners);
        let size = vec3::norm(vector);
        let n = vec3::scale(1.0 / size, vector);
        let role = roles.get(&(f.tet, f.local));
        total += size;
        reach = reach.max(largest(corners.map(|x| vec3::norm(vec3::sub(x, rigid.at)))));
        for (l, w) in TRIANGLE_4 {
            let x: V3 = std::array::from_fn(|d| (0..3).map(|i| l[i] * corners[i][d]).sum());
            let carried = |t: V3| -> [f64; 6] {
                let t: V3 =
                    std::array::from_fn(
                        |d| if rigid.components[d] { w * size * t[d] } else { 0.0 },
                    );
                let m = vec3::cross(vec3::sub(x, rigid.at), t);
                [t[0], t[1], t[2], m[0], m[1], m[2]]
            };
            let unit = carried(vec3::scale(-1.0, n));
            let load = role.map_or([0.0; 3], |r| r.load(x, n));
            let fixed = carried(vec3::sub(vec3::scale(-own(f.tet as usize, x), n), load));
            for i in 0..6 {
                *rows[i].entry(piece[f.tet as usize]).or_default() += unit[i];
                known[i] += fixed[i];
            }
        }
    }
    for i in (0..6).filter(|&i| rigid.free[i]) {
        let per = if i < 3 { total } else { total * reach };
        let row: Vec<(usize, f64)> = rows[i].iter().map(|(&p, &v)| (p, v / per)).collect();
        normal.add(total, &row, (action[i] - known[i]) / per);
    }
}
