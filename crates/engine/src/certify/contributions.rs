//! Contributions to the gap: Fenchel's inequality element by element and interface face by
//! interface face.
//!
//! Elastic: `Π_p + Π_c = Σ_K ½ ∫ (σ − Cε):C⁻¹:(σ − Cε) + Σ_contact ∫ r_N (g_N + g₀) + r_T·g_T +
//! Σ_weld (D − ∫ t·g)`. Every term is ≥ 0; D is the dissipation of a weld face, an upper bound of
//! `∫ strength ‖g‖`. Contact with elastic ground adds its energy and its complementary energy.
//!
//! Limit analysis, at unit power of the live loads:
//! `λ_up − λ_low = Σ_K ∫ π(ε) − σ:ε + Σ_contact ∫ r_N g_N + r_T·g_T + Σ_weld (D − ∫ t·g) + Σ_slip
//! (D + ∫ σn·v) + Σ_tie (D − ∫ t·[v]) + Σ_limit (cost − R·jump)`, with dissipations by the rule of
//! the upper bound; slip faces are those of [`crate::certify::slip`], ties those of
//! [`crate::certify::ties`], limits those of [`crate::certify::cut_limits`]. Every term is ≥ 0
//! where the stress is inside the yield surface and within the limits.
//!
//! # Source
//! Ladevèze and Pelle; section 4.1 of the paper, equations (11) and (12).

use crate::certify::faces::{
    ContactFace, InterfaceFace, TieFace, WeldFace, contact_faces, roles, tie_faces, weld_faces,
};
use crate::certify::fields::{DisplacementField, StressField};
use crate::certify::limit_certificate::dissipation_densities;
use crate::certify::plastic_certificate::{dissipated, stress_at_points};
use crate::certify::plastic_field::{PlasticField, at_points, tensor};
use crate::certify::slip::{SlipFace, slip_faces};
use crate::certify::ties;
use crate::certify::tractions::contact_tractions;
use crate::certify::velocity_field::VelocityField;
use crate::certify::velocity_field::pieces;
use crate::certify::welds;
use crate::certify::{crushing, cut_limits, elastic_ground};
use crate::elements::space::Tet10Space;
use crate::elements::super_element::{PointStress, integrate};
use crate::elements::tet10;
use crate::model::AnalysisModel;
use crate::model::loads::Loads;
use crate::model::opening::bernstein_at;
use bracket_base::math::Sum;
use bracket_base::math::mandel::{self, Mandel};
use bracket_base::math::quadrature::{TRIANGLE_4, tetrahedron_mass, triangle_p2};
use bracket_base::math::vec3::{self, V3};
use rayon::prelude::*;

/// The gap of a pair of fields on the meshed part, split over elements and interface faces: energy
/// \[N mm\], or load factor \[1\].
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Contributions {
    /// Contribution of each macro tet.
    pub elements: Vec<f64>,
    /// Contribution of each contact face, in the order of [`contact_faces`].
    pub contacts: Vec<f64>,
    /// Contribution of each weld face, in the order of [`weld_faces`].
    pub welds: Vec<f64>,
    /// Limit analysis: contribution of each held face on which a body may slip, in the order of
    /// [`slip_faces`].
    pub slips: Vec<f64>,
    /// Limit analysis: contribution of each tie face, in the order of [`tie_faces`].
    pub ties: Vec<f64>,
    /// Limit analysis: contribution of each resultant limit.
    pub resultants: Vec<f64>,
}

impl Contributions {
    /// Their sum: `Π_p + Π_c`, or `λ_up − λ_low`.
    pub fn total(&self) -> f64 {
        let faces = self.contacts.iter().chain(&self.welds).chain(&self.slips).chain(&self.ties);
        Sum::of(self.elements.iter().chain(faces).chain(&self.resultants).copied())
    }

    /// Contribution of each macro tet, with those of an interface face halved between the tets at
    /// its two sides, those of a slip face added to its tet and those of a resultant limit spread
    /// over the tets on side A of its cuts.
    pub fn by_tet(&self, model: &AnalysisModel) -> Vec<f64> {
        let mut tets = self.elements.clone();
        let contacts = contact_faces(model).into_iter().map(|f| (f.a, f.b)).zip(&self.contacts);
        let welds = weld_faces(model).into_iter().map(|f| (f.a, f.b)).zip(&self.welds);
        let ties = tie_faces(model).into_iter().map(|f| (f.a, f.b)).zip(&self.ties);
        for ((a, b), c) in contacts.chain(welds).chain(ties) {
            match b {
                Some((b, _)) => {
                    tets[a.tet as usize] += 0.5 * c;
                    tets[b.tet as usize] += 0.5 * c;
                }
                None => tets[a.tet as usize] += c,
            }
        }
        for (limit, c) in model.resultant_limits.iter().zip(&self.resultants) {
            let cuts = limit.cuts.iter().flat_map(|cut| &model.cuts[cut.0].faces);
            let part = c / cuts.clone().count().max(1) as f64;
            cuts.for_each(|f| tets[f.a.tet as usize] += part);
        }
        if !self.slips.is_empty() {
            let faces = slip_faces(model).into_iter().zip(&self.slips);
            faces.for_each(|(f, c)| tets[f.at.0 as usize] += c);
        }
        tets
    }
}

/// Contributions of a displacement and a stress field of elastic analysis.
pub fn contributions(
    model: &AnalysisModel,
    u: &DisplacementField,
    s: &StressField,
) -> Contributions {
    let space = Tet10Space::new(&model.mesh);
    let materials = model.stiffnesses();
    let elements = (0..model.mesh.tets.len())
        .map(|e| {
            let nodes = space.tet(&model.mesh, e).map(|n| u.u[n]);
            let material = &materials[model.mesh.tet_body[e] as usize];
            let v =
                tet10::vertex_strains(&model.mesh.corners(e), &nodes).map(|x| material.stress(&x));
            let difference = minus(&s.points[e], &at_points(&v));
            0.5 * integrate(model.mesh.volume(e), material, &difference, &difference)
        })
        .collect();
    let contacts = contact_work(model, &space, u, s, Loads::ALL, true);
    let welds = weld_work(model, &space, u, s, Loads::ALL);
    Contributions { elements, contacts, welds, ..Contributions::default() }
}

/// Velocities and a stress field of one mesh, each with the data of its certificate.
#[derive(Clone, Copy, Debug)]
pub struct LimitPair<'a> {
    /// The velocities.
    pub velocity: &'a VelocityField,
    /// Power of the live loads on them \[N mm per unit of time\].
    pub live_power: f64,
    /// Subdivisions of the dissipation rule of the upper bound.
    pub subdivisions: u32,
    /// The stresses.
    pub stress: &'a StressField,
    /// The load factor they are in equilibrium with: `factor · live + dead`.
    pub factor: f64,
}

/// Contributions of a pair of limit analysis, per power of the live loads. Up to the residuals they
/// sum to the upper load factor minus the lower one.
pub fn limit_contributions(model: &AnalysisModel, pair: &LimitPair) -> Contributions {
    let LimitPair { velocity: v, live_power, stress: s, factor, subdivisions } = *pair;
    let space = Tet10Space::new(&model.mesh);
    let radii = model.yield_radii();
    let densities = dissipation_densities(model, v, subdivisions);
    let elements = (0..model.mesh.tets.len())
        .into_par_iter()
        .map(|e| {
            let flows = radii[model.mesh.tet_body[e] as usize].is_some();
            let pieces = pieces(model, &space, v, flows, e);
            let volume = model.mesh.volume(e);
            let mut power = Sum::default();
            for k in 0..4 {
                let strains = match &pieces[..] {
                    [plain] => {
                        at_points(&tet10::vertex_strains(&plain.corners, &plain.velocities))[k]
                    }
                    split => tet10::vertex_strains(&split[k].corners, &split[k].velocities),
                };
                power.add(0.25 * volume * mean_product(&s.points[e][k], &strains));
            }
            // a body without a yield strength does not dissipate
            let dissipation = if flows { densities[e] * volume } else { 0.0 };
            (dissipation - power.value()) / live_power
        })
        .collect();
    let u = &v.nodes.u;
    let mut contacts = contact_work(model, &space, &v.nodes, s, Loads::at(factor), false);
    let crushed = crushing::dissipations_of_faces(model, &space, u);
    contacts.iter_mut().zip(crushed).for_each(|(work, crushed)| *work += crushed);
    let mut welds = weld_work(model, &space, &v.nodes, s, Loads::at(factor));
    let slip = |f: &SlipFace| f.dissipation(&space, u) + f.power(model, &space, s, u);
    let mut slips: Vec<f64> = slip_faces(model).iter().map(slip).collect();
    let tie = |f: &TieFace<'_>| {
        let r = contact_tractions(model, s, f, None);
        ties::dissipation_of(model, &space, f, u) + work_on_jump(model, &space, &v.nodes, &r, f)
    };
    let mut ties: Vec<f64> = tie_faces(model).iter().map(tie).collect();
    let mut resultants = cut_limits::contributions(model, v, s);
    let faces = contacts.iter_mut().chain(&mut welds).chain(&mut slips).chain(&mut ties);
    faces.chain(&mut resultants).for_each(|c| *c /= live_power);
    Contributions { elements, contacts, welds, slips, ties, resultants }
}

/// Mean of `σ:ε` over a tet, both linear in it.
fn mean_product(stress: &[Mandel; 4], strain: &[Mandel; 4]) -> f64 {
    let term = |i: usize, j: usize| tetrahedron_mass(i, j) * mandel::dot(&stress[i], &strain[j]);
    (0..4).flat_map(|i| (0..4).map(move |j| (i, j))).map(|(i, j)| term(i, j)).sum()
}

/// Contributions of a displacement with plastic strain p and a stress field, tet by tet
/// `½ ∫ (σ − C(ε − p)):C⁻¹:(σ − C(ε − p)) + ∫ (π(p) − σ:p)`, contact and weld faces as in
/// [`contributions`].
pub fn plastic_contributions(
    model: &AnalysisModel,
    field: &PlasticField,
    s: &StressField,
) -> Contributions {
    let space = Tet10Space::new(&model.mesh);
    let (materials, radii) = (model.stiffnesses(), model.yield_radii());
    let elements = (0..model.mesh.tets.len())
        .into_par_iter()
        .map(|e| {
            let body = model.mesh.tet_body[e] as usize;
            let volume = model.mesh.volume(e);
            let trial = stress_at_points(model, &space, field, &materials[body], e);
            let difference = minus(&s.points[e], &trial);
            let elastic = 0.5 * integrate(volume, &materials[body], &difference, &difference);
            let plastic = field.plastic_at_points(e).map(|p| p.map(|p| tensor(&p)));
            let work: f64 = s.points[e].iter().zip(&plastic).map(|(s, p)| mean_product(s, p)).sum();
            elastic + dissipated(&field.pieces(model, &space, e), radii[body])
                - 0.25 * volume * work
        })
        .collect();
    let contacts = contact_work(model, &space, &field.nodes, s, Loads::ALL, true);
    let welds = weld_work(model, &space, &field.nodes, s, Loads::ALL);
    Contributions { elements, contacts, welds, ..Contributions::default() }
}

fn minus(a: &PointStress, b: &PointStress) -> PointStress {
    std::array::from_fn(|k| {
        std::array::from_fn(|p| std::array::from_fn(|c| a[k][p][c] - b[k][p][c]))
    })
}

/// `∫ r_N (g_N + g₀) + r_T·g_T` of each contact face, with the two energies of elastic ground.
/// Shifts are gaps; without `gaps` initial gaps count as closed.
fn contact_work(
    model: &AnalysisModel,
    space: &Tet10Space,
    u: &DisplacementField,
    s: &StressField,
    loads: Loads,
    gaps: bool,
) -> Vec<f64> {
    let roles = roles(model, loads);
    let work = |f: &ContactFace| -> f64 {
        let r = contact_tractions(model, s, f, roles.get(&(f.a.tet, f.a.local)));
        let (n, area) = f.normal(model);
        let opening = if gaps { f.opening(model) } else { Default::default() };
        let ground = elastic_ground::energy_of(model, space, f, &u.u)
            + elastic_ground::complementary_energy_of(model, f, &r);
        let a = space.triangle(f.nodes_a).map(|n| u.u[n]);
        let b = f.b.map_or([[0.0; 3]; 6], |(_, nodes)| space.triangle(nodes).map(|n| u.u[n]));
        let terms = TRIANGLE_4.iter().map(|(l, w)| {
            let shape = triangle_p2(*l);
            let g = (0..6)
                .fold([0.0; 3], |s, i| vec3::add(s, vec3::scale(shape[i], vec3::sub(b[i], a[i]))));
            let at = |v: &[V3; 3]| -> V3 {
                std::array::from_fn(|d| (0..3).map(|i| l[i] * v[i][d]).sum())
            };
            let r = at(&r);
            w * area * (vec3::dot(r, g) + vec3::dot(r, n) * bernstein_at(&opening, *l))
        });
        ground + terms.sum::<f64>()
    };
    contact_faces(model).iter().map(work).collect()
}

/// `D − ∫ t·g` of each weld face, D its dissipation.
fn weld_work(
    model: &AnalysisModel,
    space: &Tet10Space,
    u: &DisplacementField,
    s: &StressField,
    loads: Loads,
) -> Vec<f64> {
    let roles = roles(model, loads);
    let work = |f: &WeldFace<'_>| {
        let r = contact_tractions(model, s, f, roles.get(&(f.a.tet, f.a.local)));
        welds::dissipation_of(model, space, f, &u.u) + work_on_jump(model, space, u, &r, f)
    };
    weld_faces(model).iter().map(work).collect()
}

/// `∫ r·g` of a traction that is linear on a face, given at its vertices, and the jump of a
/// displacement.
fn work_on_jump<L>(
    model: &AnalysisModel,
    space: &Tet10Space,
    u: &DisplacementField,
    r: &[V3; 3],
    face: &InterfaceFace<'_, L>,
) -> f64 {
    let (_, area) = face.normal(model);
    let g = welds::jumps(space, face, &u.u);
    let terms = TRIANGLE_4.iter().map(|(l, w)| {
        let shape = triangle_p2(*l);
        let g = (0..6).fold([0.0; 3], |s, i| vec3::add(s, vec3::scale(shape[i], g[i])));
        let r: V3 = std::array::from_fn(|d| (0..3).map(|i| l[i] * r[i][d]).sum());
        w * area * vec3::dot(r, g)
    });
    terms.sum()
}
