//! Certificates of the elastic energy bounds, computed from the fields and the model alone.
//!
//! A certificate shares nothing with the solver, and with the programs only the model itself (mesh,
//! loads, shape functions). Strain energy is computed at Gauss points and work by direct
//! quadrature; equilibrium, tractions and contact are computed from the stored values, face by
//! face. The identity Σ contributions = gap, asserted in every run, ties both certificates
//! together.

use crate::certify::cut_limits;
use crate::certify::elastic_ground;
use crate::certify::faces::{
    FaceKey, FaceRole, InterfaceFace, contact_faces, roles, tie_faces, weld_faces,
};
use crate::certify::fields::{DisplacementField, StressField};
use crate::certify::measures::{largest, largest_of_each, ratio};
use crate::certify::rigid_fit::fit_rigid;
use crate::certify::tractions::{at_barycentric, contact_tractions, face_stress, stress_at};
use crate::certify::welds;
use crate::elements::geometry::gradients;
use crate::elements::space::{FACE_EDGES, Tet10Space};
use crate::elements::super_element::{SuperElement, integrate};
use crate::elements::tet10;
use crate::mesh::numbering::FaceNumbering;
use crate::mesh::tet::FACES;
use crate::model::AnalysisModel;
use crate::model::analysis::{RigidFace, SurfaceLoad};
use crate::model::loads::{Loads, face_corners, face_nodes};
use crate::model::opening::bernstein_at;
use bracket_base::math::Sum;
use bracket_base::math::mandel::{self, Mandel};
use bracket_base::math::quadrature::{TETRAHEDRON_2, TRIANGLE_4, triangle_p2};
use bracket_base::math::vec3::{self, V3};
use std::collections::BTreeMap;

/// Certificate of a stress field.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct StaticCertificate {
    /// Complementary energy Π_c of the meshed part \[N mm\].
    pub energy: f64,
    /// max |div σ + b| h / max |σ|.
    pub equilibrium: f64,
    /// max |Δt| / max |t|: inner faces, tied faces, loaded and free faces, both sides of contacts,
    /// resultants on rigid faces.
    pub traction_jump: f64,
    /// Largest violation of a friction cone / max(|r|, |t|); `None` without contact.
    pub contact: Option<f64>,
    /// Largest contact pressure \[MPa\]; `None` without contact.
    pub peak_pressure: Option<f64>,
    /// Largest traction of a weld over its strength; `None` without welds.
    pub weld: Option<f64>,
    /// Largest utilisation of the yield strength including the residuals' allowance, minus 1;
    /// `None` where nothing yields.
    pub yields: Option<f64>,
    /// `½ ∫ σ:C⁻¹:σ` alone \[N mm\], the reference of the gap where the energy may vanish; `None`
    /// without preload.
    pub strain_energy: Option<f64>,
    /// Tension of each preloaded bolt in its cut \[N\].
    pub tensions: Vec<f64>,
}

/// Certificate of a displacement field.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct KinematicCertificate {
    /// Potential energy Π_p of the meshed part \[N mm\].
    pub energy: f64,
    /// Work of the loads \[N mm\].
    pub work: f64,
    /// max |u − u_d| / max |u| on supports and rigid faces.
    pub compatibility: f64,
    /// Largest violation of the contact law by a Bernstein coefficient / max(|g|, |g₀|), g₀ the
    /// initial gap and shift; `None` without contact other than with elastic ground.
    pub contact: Option<f64>,
    /// Smallest margin of a Bernstein coefficient `g_N + g₀ − μ‖g_T‖` \[mm\]; `None` without
    /// contact other than with elastic ground.
    pub smallest_margin: Option<f64>,
    /// Largest normal gap between faces in contact, initial gap included \[mm\]; `None` without
    /// contact.
    pub largest_gap: Option<f64>,
    /// Largest contact pressure of the displacement's stress at face vertices \[MPa\], an estimate.
    pub peak_pressure: Option<f64>,
    /// Dissipation of each weld, an upper bound \[N mm\]; part of the energy.
    pub welds: Vec<f64>,
}

/// Certifies a stress field under the given loads.
pub fn certify_stress(
    model: &AnalysisModel,
    field: &StressField,
    loads: Loads,
) -> StaticCertificate {
    let mesh = &model.mesh;
    let materials = model.stiffnesses();
    let body = model.body_forces(loads);
    let max_stress = largest(field.points.iter().flatten().flatten().map(mandel::norm));
    let mut energy = Sum::default();
    let mut imbalance = 0.0f64;
    let mut jump = 0.0f64;
    for (e, s) in field.points.iter().enumerate() {
        let corners = mesh.corners(e);
        let volume = mesh.volume(e);
        let b = mesh.tet_body[e] as usize;
        energy.add(0.5 * integrate(volume, &materials[b], s, s));
        let h = volume.cbrt();
        let points = SuperElement::points(&corners);
        for k in 0..4 {
            let g = gradients(&points[k]);
            let div = (0..4).fold(body[b], |d, p| vec3::add(d, mandel::traction(&s[k][p], g[p])));
            imbalance = imbalance.max(vec3::norm(div) * h);
        }
        for k in 0..4 {
            for l in k + 1..4 {
                jump = jump.max(inner_jump(&points, s, k, l));
            }
        }
    }
    let roles = roles(model, loads);
    let faces = FaceNumbering::new(mesh);
    let mut max_traction = 0.0f64;
    for e in 0..mesh.tets.len() {
        for k in 0..4 {
            let (first, second) = faces.tets[faces.of_tet[e][k] as usize];
            let corners = FACES[k].map(|i| mesh.nodes[mesh.tets[e][i] as usize]);
            let area = vec3::area_vector(&corners);
            let n = vec3::scale(1.0 / vec3::norm(area), area);
            let t = face_stress(field, e, k).map(|s| mandel::traction(&s, n));
            max_traction = max_traction.max(largest(t.map(vec3::norm)));
            match second {
                Some(other) if first as usize == e => {
                    let o = other as usize;
                    let local =
                        (0..4).find(|&l| faces.of_tet[o][l] == faces.of_tet[e][k]).unwrap_or(0);
                    let nodes = FACES[k].map(|i| mesh.tets[e][i]);
                    let s = stress_at(model, field, (other, local as u8), nodes);
                    for i in 0..3 {
                        jump = jump.max(vec3::norm(vec3::sub(t[i], mandel::traction(&s[i], n))));
                    }
                }
                Some(_) => {}
                None => {
                    let role = roles.get(&(e as u32, k as u8));
                    if role.is_some_and(|r| r.contact || r.cut) {
                        continue;
                    }
                    for i in 0..3 {
                        let wanted = role.map_or([0.0; 3], |r| r.load(corners[i], n));
                        let d = vec3::sub(t[i], wanted);
                        for c in (0..3).filter(|&c| !role.is_some_and(|r| r.reaction[c])) {
                            jump = jump.max(d[c].abs());
                        }
                    }
                }
            }
        }
    }
    for rigid in &model.rigid {
        jump = jump.max(rigid_resultant_error(model, field, rigid, &roles, loads));
    }
    let strain_energy = energy.value();
    let mut tensions = Vec::with_capacity(model.preload.len());
    for bolt in &model.preload {
        let (resultant, torn) = cut_limits::through(model, field, &bolt.faces);
        let tension = vec3::dot(resultant, bolt.axis);
        energy.add(-bolt.closure.unwrap_or(0.0) * tension);
        jump = jump.max(torn);
        tensions.push(tension);
    }
    let (mut cone, mut max_r, mut peak) = (0.0f64, 0.0f64, 0.0f64);
    let contacts = contact_faces(model);
    for f in weld_faces(model) {
        let r = contact_tractions(model, field, &f, roles.get(&(f.a.tet, f.a.local)));
        jump = jump.max(sides_differ(model, field, &f, &r));
    }
    let at_tie = |f| sides_differ(model, field, f, &contact_tractions(model, field, f, None));
    let torn = model.cuts.iter().map(|c| cut_limits::through(model, field, &c.faces).1);
    jump = jump.max(largest(torn));
    jump = jump.max(largest(tie_faces(model).iter().map(at_tie)));
    for f in &contacts {
        let r = contact_tractions(model, field, f, roles.get(&(f.a.tet, f.a.local)));
        let (n, area) = f.normal(model);
        jump = jump.max(sides_differ(model, field, f, &r));
        for x in r {
            let rn = vec3::dot(x, n);
            let rt = vec3::norm(vec3::sub(x, vec3::scale(rn, n)));
            cone = cone.max(rt - f.law.mu * rn).max(-rn);
            max_r = max_r.max(vec3::norm(x));
            peak = peak.max(rn);
        }
        let opening = f.opening(model);
        for (l, w) in TRIANGLE_4 {
            energy.add(w * area * vec3::dot(at_barycentric(&r, l), n) * bernstein_at(&opening, l));
        }
        energy.add(elastic_ground::complementary_energy_of(model, f, &r));
    }
    let contact = !contacts.is_empty();
    StaticCertificate {
        energy: energy.value(),
        equilibrium: ratio(imbalance, max_stress),
        traction_jump: ratio(jump, max_traction),
        // open contacts carry only rounding of the stress: relative to the larger of the two
        contact: contact.then(|| ratio(cone, max_r.max(max_traction))),
        peak_pressure: contact.then_some(peak),
        weld: largest_of_each(&welds::utilisations(model, field)),
        yields: None,
        strain_energy: model.has_preload().then_some(strain_energy),
        tensions,
    }
}

/// Largest difference between the traction r of side A of an interface and that of side B \[MPa\].
fn sides_differ<L>(
    model: &AnalysisModel,
    field: &StressField,
    face: &InterfaceFace<'_, L>,
    r: &[V3; 3],
) -> f64 {
    let Some((b, nodes_b)) = face.b else { return 0.0 };
    let (n, _) = face.normal(model);
    let other = stress_at(model, field, (b.tet, b.local), nodes_b);
    // t_B = σ_B (−n) must be +r
    largest(
        (0..3).map(|i| {
            vec3::norm(vec3::sub(mandel::traction(&other[i], vec3::scale(-1.0, n)), r[i]))
        }),
    )
}

/// Largest traction jump on the inner face between subtets k and l.
fn inner_jump(points: &[[V3; 4]; 4], s: &[[Mandel; 4]; 4], k: usize, l: usize) -> f64 {
    let shared: Vec<usize> = (0..4).filter(|&m| m != k && m != l).collect();
    let at = |t: usize, m: usize| FACES[t].iter().position(|&v| v == m).unwrap_or(3);
    let pairs =
        [(at(k, shared[0]), at(l, shared[0])), (at(k, shared[1]), at(l, shared[1])), (3, 3)];
    let a = vec3::area_vector(&[points[k][pairs[0].0], points[k][pairs[1].0], points[k][3]]);
    let n = vec3::scale(1.0 / vec3::norm(a), a);
    largest(pairs.map(|(p, q)| {
        vec3::norm(vec3::sub(mandel::traction(&s[k][p], n), mandel::traction(&s[l][q], n)))
    }))
}

/// Resultant of the tractions on a rigid face against its action, as a traction \[MPa\]: per area,
/// moments per area and reach.
fn rigid_resultant_error(
    model: &AnalysisModel,
    field: &StressField,
    rigid: &RigidFace,
    roles: &BTreeMap<FaceKey, FaceRole>,
    loads: Loads,
) -> f64 {
    let action = loads.action(rigid);
    let mut got = [Sum::default(); 6];
    let (mut total, mut reach) = (0.0, 0.0f64);
    for f in &rigid.faces {
        let nodes = face_nodes(&model.mesh, f);
        let corners = nodes.map(|n| model.mesh.nodes[n as usize]);
        let area = vec3::area_vector(&corners);
        let size = vec3::norm(area);
        let n = vec3::scale(1.0 / size, area);
        let t = stress_at(model, field, (f.tet, f.local), nodes).map(|s| mandel::traction(&s, n));
        // the face carries loads on itself in addition to the action
        let role = roles.get(&(f.tet, f.local));
        let t: [V3; 3] = std::array::from_fn(|i| {
            vec3::sub(t[i], role.map_or([0.0; 3], |r| r.load(corners[i], n)))
        });
        total += size;
        reach = reach.max(largest(corners.map(|x| vec3::norm(vec3::sub(x, rigid.at)))));
        for (l, w) in TRIANGLE_4 {
            let mut t = at_barycentric(&t, l);
            // the other components carry no traction of the rigid motion
            (0..3).filter(|&d| !rigid.components[d]).for_each(|d| t[d] = 0.0);
            let m = vec3::cross(vec3::sub(at_barycentric(&corners, l), rigid.at), t);
            for d in 0..3 {
                got[d].add(w * size * t[d]);
                got[3 + d].add(w * size * m[d]);
            }
        }
    }
    largest((0..6).filter(|&i| rigid.free[i]).map(|i| {
        let per = if i < 3 { total } else { total * reach };
        (got[i].value() - action[i]).abs() / per
    }))
}

/// Adds the work of a surface load on the displacements (or velocities) u \[N mm\].
pub(crate) fn add_work(
    model: &AnalysisModel,
    space: &Tet10Space,
    u: &[V3],
    load: &SurfaceLoad,
    work: &mut Sum,
) {
    for f in &load.faces {
        let corners = face_corners(&model.mesh, f);
        let nodes = space.triangle(face_nodes(&model.mesh, f)).map(|n| u[n]);
        let area = vec3::area_vector(&corners);
        let size = vec3::norm(area);
        let n = vec3::scale(1.0 / size, area);
        for (l, w) in TRIANGLE_4 {
            let shape = triangle_p2(l);
            let at = (0..6).fold([0.0; 3], |s, i| vec3::add(s, vec3::scale(shape[i], nodes[i])));
            work.add(w * size * vec3::dot(load.at(at_barycentric(&corners, l), n), at));
        }
    }
}

/// Largest component of the displacement (or velocity) u that a support fixes.
pub(crate) fn off_supports(model: &AnalysisModel, space: &Tet10Space, u: &[V3]) -> f64 {
    let mut off = 0.0f64;
    for s in &model.supports {
        for n in s.faces.iter().flat_map(|f| space.triangle(face_nodes(&model.mesh, f))) {
            (0..3).filter(|&d| s.fix[d]).for_each(|d| off = off.max(u[n][d].abs()));
        }
    }
    off
}

/// Certifies a displacement field.
pub fn certify_displacement(
    model: &AnalysisModel,
    field: &DisplacementField,
) -> KinematicCertificate {
    let mesh = &model.mesh;
    let space = Tet10Space::new(mesh);
    let materials = model.stiffnesses();
    let body = model.body_forces(Loads::ALL);
    let u = &field.u;
    let inside = |e: usize, strain_energy: &mut Sum, work: &mut Sum| {
        let nodes = space.tet(mesh, e).map(|n| u[n]);
        let volume = mesh.volume(e);
        let g = gradients(&mesh.corners(e));
        let b = mesh.tet_body[e] as usize;
        for (l, w) in TETRAHEDRON_2 {
            let eps = tet10::strain(&g, l, &nodes);
            strain_energy.add(0.5 * w * volume * mandel::dot(&eps, &materials[b].stress(&eps)));
            let shape = tet10::shape(l);
            let at = (0..10).fold([0.0; 3], |s, i| vec3::add(s, vec3::scale(shape[i], nodes[i])));
            work.add(w * volume * vec3::dot(body[b], at));
        }
    };
    let stress = |e: usize, face: usize| {
        let strains = tet10::vertex_strains(&mesh.corners(e), &space.tet(mesh, e).map(|n| u[n]));
        FACES[face].map(|v| materials[mesh.tet_body[e] as usize].stress(&strains[v]))
    };
    certify_motion(model, &space, u, &inside, &stress)
}

/// Certifies nodal displacements u; `inside` adds the energy stored in a tet and the work of its
/// body forces, `stress` gives the stress at the vertices of one of its faces.
pub(crate) fn certify_motion(
    model: &AnalysisModel,
    space: &Tet10Space,
    u: &[V3],
    inside: &dyn Fn(usize, &mut Sum, &mut Sum),
    stress: &dyn Fn(usize, usize) -> [Mandel; 3],
) -> KinematicCertificate {
    let max_u = largest(u.iter().map(|x| vec3::norm(*x)));
    let (mut strain_energy, mut work) = (Sum::default(), Sum::default());
    for e in 0..model.mesh.tets.len() {
        inside(e, &mut strain_energy, &mut work);
    }
    for load in &model.surface_loads {
        add_work(model, space, u, load, &mut work);
    }
    let mut off = off_supports(model, space, u);
    for bolt in &model.preload {
        let closed = vec3::scale(bolt.closure.unwrap_or(0.0), bolt.axis);
        for f in &bolt.faces {
            let sides = space.triangle(f.nodes_a).into_iter().zip(space.triangle(f.nodes_b));
            off = off.max(largest(
                sides.map(|(a, b)| vec3::norm(vec3::add(vec3::sub(u[b], u[a]), closed))),
            ));
        }
    }
    for r in &model.rigid {
        let (motion, error) = fit_rigid(model, space, u, r);
        off = off.max(error);
        let action = Loads::ALL.action(r);
        (0..6).for_each(|i| work.add(motion[i] * action[i]));
    }
    let (mut margin, mut max_g, mut max_gap) = (f64::INFINITY, 0.0f64, 0.0f64);
    let contacts = contact_faces(model);
    for f in &contacts {
        // Bernstein coefficients, with the normal of the face itself
        let (n, _) = f.normal(model);
        let opening = f.opening(model);
        let a = space.triangle(f.nodes_a);
        let b = f.b.map(|(_, nodes)| space.triangle(nodes));
        let jump = |i: usize| vec3::sub(b.map_or([0.0; 3], |b| u[b[i]]), u[a[i]]);
        for i in 0..6 {
            let (g, gap) = if i < 3 {
                (jump(i), opening[i])
            } else {
                let [p, q] = FACE_EDGES[i - 3];
                let ends = vec3::scale(0.5, vec3::add(jump(p), jump(q)));
                (vec3::sub(vec3::scale(2.0, jump(i)), ends), opening[i])
            };
            let gn = vec3::dot(g, n);
            let gt = vec3::norm(vec3::sub(g, vec3::scale(gn, n)));
            if model.ground_stiffness(f.of).is_none() {
                margin = margin.min(gn + gap - f.law.mu * gt);
            }
            max_g = max_g.max(vec3::norm(g)).max(gap.abs());
            if i < 3 {
                max_gap = max_gap.max(gn + gap);
            }
        }
    }
    let contact = !contacts.is_empty();
    // elastic ground gives way to any displacement
    let hard = contacts.iter().any(|f| model.ground_stiffness(f.of).is_none());
    let welds = welds::dissipations(model, u);
    welds.iter().for_each(|d| strain_energy.add(*d));
    contacts.iter().for_each(|f| strain_energy.add(elastic_ground::energy_of(model, space, f, u)));
    KinematicCertificate {
        energy: strain_energy.value() - work.value(),
        welds,
        work: work.value(),
        compatibility: ratio(off, max_u),
        contact: hard.then(|| ratio((-margin).max(0.0), max_g)),
        smallest_margin: hard.then_some(margin),
        largest_gap: contact.then_some(max_gap),
        peak_pressure: contact.then(|| displacement_pressure(model, stress)),
    }
}

/// Largest pressure of the displacement's stress on contact faces, either side \[MPa\].
fn displacement_pressure(
    model: &AnalysisModel,
    stress: &dyn Fn(usize, usize) -> [Mandel; 3],
) -> f64 {
    let mut peak = 0.0f64;
    for f in contact_faces(model) {
        let (n, _) = f.normal(model);
        for side in [Some(f.a), f.b.map(|b| b.0)].into_iter().flatten() {
            for s in stress(side.tet as usize, side.local as usize) {
                peak = peak.max(-vec3::dot(mandel::traction(&s, n), n));
            }
        }
    }
    peak
}
