//! Load factors without limit: a stress field that carries the live loads alone and nowhere comes
//! nearer to yield.
//!
//! Let a field be in equilibrium with the live loads alone, its contact tractions inside their
//! cones and its deviator zero in every body that yields, and no traction in any weld of finite
//! strength. Any multiple of it may then be added to an admissible field of the dead loads: the
//! yield surface sees no difference and cones are convex. So every load factor can be carried,
//! under Coulomb's law as well, for such a field presses contacts without any shear.
//!
//! Without a deviator `σ = −p I`, and equilibrium makes `p = c + b·x` with b the live body force.
//! Tractions are continuous, so that c is one number in each body and its connected pieces: all
//! that is to be found, by least squares on the faces.

use crate::certify::certificate::{TOLERANCE, certify_stress, contact_tractions, largest, ratio};
use crate::certify::faces::{FaceRole, contact_faces, roles, weld_faces};
use crate::certify::fields::StressField;
use crate::certify::limit_certificate::{LowerCertificate, certify_lower};
use crate::elements::super_element::SuperElement;
use crate::math::dense::pseudo_solve;
use crate::math::mandel::{self, deviator};
use crate::math::quadrature::TRIANGLE_4;
use crate::math::vec3::{self, V3};
use crate::mesh::numbering::FaceNumbering;
use crate::mesh::tet::FACES;
use crate::model::AnalysisModel;
use crate::model::loads::{Loads, face_corners};
use faer::Mat;

/// What a field that carries the live loads alone proves: with strict residuals the load factor has
/// no limit.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct UnlimitedCertificate {
    /// max |div σ + b| h / max |σ|, b the live body force.
    pub equilibrium: f64,
    /// max |Δt| / max |t|, see [`crate::certify::certificate::StaticCertificate::traction_jump`].
    pub traction_jump: f64,
    /// Largest violation of a friction cone / max(|r|, |t|); `None` without contact.
    pub contact: Option<f64>,
    /// max ‖dev σ‖ / max |σ| in bodies that yield.
    pub deviator: f64,
    /// max |t| / max |σ| over welds of finite strength, which must carry nothing; `None` without
    /// welds.
    pub weld: Option<f64>,
    /// What the field of the dead loads alone proves; `None` where there are none, or no field of
    /// theirs is given.
    pub dead: Option<LowerCertificate>,
    /// Dead loads without a field of theirs: nothing is proved.
    pub unproved: bool,
}

impl UnlimitedCertificate {
    /// True when every residual is within [`TOLERANCE`] and the dead loads are carried.
    pub fn is_strict(&self) -> bool {
        let residuals = [
            Some(self.equilibrium),
            Some(self.traction_jump),
            self.contact,
            Some(self.deviator),
            self.weld,
        ];
        let dead = self
            .dead
            .as_ref()
            .is_none_or(|d| crate::certify::LowerFactor::new(d.clone()).is_strict());
        residuals.into_iter().flatten().all(|r| r <= TOLERANCE) && dead && !self.unproved
    }
}

/// A load factor without limit.
#[derive(Clone, Debug, PartialEq)]
pub struct Unlimited {
    /// A field in equilibrium with the live loads alone.
    pub field: StressField,
    /// A field of the dead loads alone, where there are any.
    pub dead: Option<StressField>,
    /// What they prove.
    pub certificate: UnlimitedCertificate,
}

/// Certifies a field that carries the live loads alone, and one of the dead loads where there are
/// any.
pub fn certify_unlimited(
    model: &AnalysisModel,
    field: &StressField,
    dead: Option<&StressField>,
) -> UnlimitedCertificate {
    let base = certify_stress(model, field, Loads::LIVE);
    let size = largest(field.points.iter().flatten().flatten().map(mandel::norm));
    let yields: Vec<bool> = model.yield_radii().iter().map(Option::is_some).collect();
    let of_tets =
        field.points.iter().zip(&model.mesh.tet_body).filter(|(_, body)| yields[**body as usize]);
    let shear = largest(
        of_tets
            .flat_map(|(s, _)| s.iter().flatten())
            .map(|s| deviator(s).iter().map(|x| x * x).sum()),
    );
    let finite = field.points.iter().flatten().flatten().flatten().all(|x| x.is_finite());
    let loaded = model.has_dead_loads();
    let roles = roles(model, Loads::LIVE);
    UnlimitedCertificate {
        equilibrium: if finite { base.equilibrium } else { f64::NAN },
        traction_jump: base.traction_jump,
        contact: base.contact,
        deviator: ratio(shear.sqrt(), size),
        weld: (!model.welds.is_empty()).then(|| {
            let tractions = weld_faces(model).into_iter().flat_map(|f| {
                let role = roles.get(&(f.a.tet, f.a.local));
                contact_tractions(model, field, &f, role).map(vec3::norm)
            });
            ratio(largest(tractions), size)
        }),
        dead: dead.filter(|_| loaded).map(|d| certify_lower(model, d, 0.0)),
        unproved: loaded && dead.is_none(),
    }
}

/// The pressures that carry the live loads alone; `None` where there are none. `dead` is asked for
/// a strictly admissible field of the dead loads only where there are pressures and dead loads.
pub fn find<E>(
    model: &AnalysisModel,
    dead: impl FnOnce() -> Result<Option<StressField>, E>,
) -> Result<Option<Unlimited>, E> {
    // what a rigid body carries is no pressure
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

/// Tets of one body joined by their faces: the piece of each tet, and how many there are.
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
    // the part of the pressure that body forces give
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
    // a weld may carry no multiple of anything: no pressure on either side, but for loads on the
    // face itself
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

/// The equations that the resultants on a rigid face are its live action, as tractions.
fn add_resultants(
    model: &AnalysisModel,
    rigid: &crate::model::analysis::RigidFace,
    roles: &std::collections::BTreeMap<crate::certify::faces::FaceKey, FaceRole>,
    piece: &[usize],
    own: &impl Fn(usize, V3) -> f64,
    normal: &mut Normal,
) {
    let action = Loads::LIVE.action(rigid);
    // resultants of a unit pressure in each piece, and of what is known
    let mut rows = vec![std::collections::BTreeMap::<usize, f64>::new(); 6];
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
