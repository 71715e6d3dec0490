//! Certificates of load factors, computed from the stored field and the model alone.
//!
//! Lower bound: a stress field in equilibrium with `factor · live + dead`, inside yield surface and
//! friction cones, with no pressure above the strength of ground that crushes. Upper bound:
//! velocities that keep the volume and satisfy supports and contact law; the factor is
//! `(dissipation − power of dead loads) / power of live loads`. The dissipation includes that of
//! slip on held faces ([`crate::certify::slip`]) and along ties ([`crate::certify::ties`]), that of
//! ground that crushes ([`crate::certify::crushing`]), and the cost of motions across cuts whose
//! resultants are limited ([`crate::certify::cut_limits`]). In limit analysis initial gaps count as
//! closed, and bodies without a yield strength are rigid.
//!
//! Equations hold to rounding only. An exactly admissible stress or velocity lies nearby; its
//! distance, estimated from the residuals, is the `cover` of the certificate. A bound must include
//! this allowance.

use crate::certify::certificate::{add_work, certify_stress};
use crate::certify::dissipation::mean_norm;
use crate::certify::faces::{contact_faces, weld_faces};
use crate::certify::fields::StressField;
use crate::certify::measures::{largest, largest_of_each, ratio};
use crate::certify::rigid_fit::fit_rigid;
use crate::certify::slip;
use crate::certify::ties;
use crate::certify::velocity_field::Piece;
use crate::certify::velocity_field::VelocityField;
use crate::certify::velocity_field::pieces;
use crate::certify::welds;
use crate::certify::{crushing, cut_limits};
use crate::elements::space::{FACE_EDGES, Tet10Space};
use crate::elements::tet10;
use crate::model::AnalysisModel;
use crate::model::loads::{Loads, face_corners};
use bracket_base::math::Sum;
use bracket_base::math::mandel::{self, Mandel, deviator};
use bracket_base::math::quadrature::TETRAHEDRON_2;
use bracket_base::math::vec3::{self, V3};
use rayon::prelude::*;

/// Power of the live loads, over that with all of them along the largest velocity, that rounding
/// explains.
const NO_WORK: f64 = 1e-10;

/// Certificate of a stress field in limit analysis.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct LowerCertificate {
    /// Load factor of the loads in equilibrium with the field.
    pub factor: f64,
    /// max |div σ + b| h / max |σ|.
    pub equilibrium: f64,
    /// max |Δt| / max |t|, see [`crate::certify::certificate::StaticCertificate::traction_jump`].
    pub traction_jump: f64,
    /// Largest violation of a friction cone / max(|r|, |t|); `None` without contact.
    pub contact: Option<f64>,
    /// Largest contact pressure \[MPa\]; `None` without contact.
    pub peak_pressure: Option<f64>,
    /// max ‖dev σ‖ / (√(2/3) f_y) over bodies that yield; 0 without any.
    pub utilisation: f64,
    /// Part where the largest utilisation is reached.
    pub limiting_part: Option<u32>,
    /// Largest traction of a weld over its strength; `None` without welds.
    pub weld: Option<f64>,
    /// Largest utilisation of a resultant limit; `None` without limits.
    pub resultant: Option<f64>,
    /// Largest pressure on crushing ground over its strength; `None` without such ground.
    pub ground: Option<f64>,
    /// Allowance for the residuals, as a utilisation: a field in exact equilibrium differs by no
    /// more.
    pub cover: f64,
    /// Fraction of the given field that is left after it was drawn inside the yield surface; 1 when
    /// it was used unchanged.
    pub scaled_by: f64,
}

impl LowerCertificate {
    /// Largest utilisation of yield surfaces, welds, resultant limits and crushing ground; NaN if
    /// one of them is.
    pub fn worst(&self) -> f64 {
        let others = [self.weld, self.resultant, self.ground].into_iter().flatten();
        others.fold(self.utilisation, |worst, u| if u.is_nan() || u > worst { u } else { worst })
    }
}

/// Certificate of velocities in limit analysis.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct UpperCertificate {
    /// (dissipation − power of dead loads) / power of live loads.
    pub factor: f64,
    /// max |tr ε| h / max |u| in bodies that yield.
    pub volume: f64,
    /// max ‖ε‖ h / max |u| in the others.
    pub rigid: f64,
    /// max |u − u_d| / max |u| on supports and rigid faces; on slip faces the normal part, at ties
    /// that of the jump; across cuts the difference from the motions of the limits.
    pub compatibility: f64,
    /// Largest violation of the contact law by a Bernstein coefficient / max |u|; `None` without
    /// contact, or where all ground crushes.
    pub contact: Option<f64>,
    /// Smallest margin `g_N − μ‖g_T‖` of a Bernstein coefficient \[mm per unit of time\]; `None`
    /// without contact.
    pub smallest_margin: Option<f64>,
    /// Dissipation of each part, an upper bound \[N mm per unit of time\].
    pub dissipation: Vec<f64>,
    /// Dissipation of each weld, an upper bound \[N mm per unit of time\].
    pub welds: Vec<f64>,
    /// Dissipation of the slip on each support, an upper bound \[N mm per unit of time\].
    pub supports: Vec<f64>,
    /// Dissipation of the slip along each tie, an upper bound \[N mm per unit of time\].
    pub ties: Vec<f64>,
    /// Dissipation of each contact with the ground, an upper bound; empty without crushing ground
    /// \[N mm per unit of time\].
    pub ground: Vec<f64>,
    /// Cost of the motion of each resultant limit \[N mm per unit of time\].
    pub resultants: Vec<f64>,
    /// Power of the live loads \[N mm per unit of time\]; 0 where it is rounding.
    pub live_power: f64,
    /// Power of the dead loads \[N mm per unit of time\].
    pub dead_power: f64,
    /// Allowance for the residuals, as a load factor: exactly admissible velocities nearby give at
    /// most `factor + cover`.
    pub cover: f64,
}

/// Ratio of the extent of the model to the size of its smallest element.
fn slenderness(model: &AnalysisModel) -> f64 {
    let (lo, hi) = model.mesh.nodes.iter().fold(([f64::MAX; 3], [f64::MIN; 3]), |(lo, hi), x| {
        (std::array::from_fn(|d| lo[d].min(x[d])), std::array::from_fn(|d| hi[d].max(x[d])))
    });
    let smallest = (0..model.mesh.tets.len())
        .map(|e| model.mesh.volume(e))
        .fold(f64::INFINITY, f64::min)
        .cbrt();
    vec3::norm(vec3::sub(hi, lo)) / smallest
}

/// Largest utilisation of the yield surface and the tet where it is reached; NaN if any stress is
/// NaN or infinite.
pub fn utilisation(model: &AnalysisModel, field: &StressField) -> (f64, Option<usize>) {
    let radii = model.yield_radii();
    let mut worst = (0.0, None);
    for (e, stress) in field.points.iter().enumerate() {
        if !stress.iter().flatten().flatten().all(|x| x.is_finite()) {
            return (f64::NAN, Some(e));
        }
        let Some(radius) = radii[model.mesh.tet_body[e] as usize] else { continue };
        let here = largest(stress.iter().flatten().map(|s| length(&deviator(s)) / radius));
        if here > worst.0 {
            worst = (here, Some(e));
        }
    }
    worst
}

/// Allowance, as a utilisation, for the largest relative residual of a stress field's equilibrium:
/// a field in exact equilibrium differs by no more.
pub fn hidden_utilisation(model: &AnalysisModel, field: &StressField, residual: f64) -> f64 {
    hidden_at(model, largest(field.points.iter().flatten().flatten().map(mandel::norm)), residual)
}

/// [`hidden_utilisation`] of a field whose largest stress is `stress` \[MPa\].
pub fn hidden_at(model: &AnalysisModel, stress: f64, residual: f64) -> f64 {
    // unbalanced forces of one sign on every face add up over L/h faces and bend a section one
    // element deep with the lever arm L
    let limits = model.resultant_limits.iter().map(|l| model.mean_strength(l));
    let welds = model.welds.iter().map(|w| w.strength);
    let ground = model.ground.iter().filter_map(|g| g.strength);
    let interfaces = welds.chain(limits).chain(ground);
    let strengths = model.yield_radii().into_iter().flatten().chain(interfaces);
    let weakest = strengths.fold(f64::INFINITY, f64::min);
    6.0 * slenderness(model).powi(2) * residual * stress / weakest
}

fn length(s: &[f64; 5]) -> f64 {
    s.iter().map(|x| x * x).sum::<f64>().sqrt()
}

/// Certifies a stress field as a lower bound: in equilibrium with `factor · live + dead`.
pub fn certify_lower(model: &AnalysisModel, field: &StressField, factor: f64) -> LowerCertificate {
    let base = certify_stress(model, field, Loads::at(factor));
    let (utilisation, tet) = utilisation(model, field);
    let residual = largest([base.equilibrium, base.traction_jump, base.contact.unwrap_or(0.0)]);
    LowerCertificate {
        factor,
        equilibrium: base.equilibrium,
        traction_jump: base.traction_jump,
        contact: base.contact,
        peak_pressure: base.peak_pressure,
        utilisation,
        limiting_part: tet.map(|e| model.tet_part[e]),
        weld: base.weld,
        resultant: largest_of_each(&cut_limits::utilisations(model, field)),
        ground: largest_of_each(&crushing::utilisations(model, field, Loads::at(factor))),
        cover: hidden_utilisation(model, field, residual),
        scaled_by: 1.0,
    }
}

/// Contribution of one tet to an upper bound.
struct Share {
    trace: f64,
    strain: f64,
    dissipation: f64,
    power: f64,
    dead: f64,
}

fn share_of(
    pieces: &[Piece],
    radius: Option<f64>,
    [live, dead]: [V3; 2],
    subdivisions: u32,
) -> Share {
    let mut share = Share { trace: 0.0, strain: 0.0, dissipation: 0.0, power: 0.0, dead: 0.0 };
    let h = pieces.iter().map(|p| p.volume).sum::<f64>().cbrt();
    for p in pieces {
        let strains: [Mandel; 4] = tet10::vertex_strains(&p.corners, &p.velocities);
        match radius {
            Some(radius) => {
                share.trace =
                    share.trace.max(h * largest(strains.map(|e| (e[0] + e[1] + e[2]).abs())));
                share.dissipation += p.volume * radius * mean_norm(&strains, subdivisions);
            }
            None => share.strain = share.strain.max(h * largest(strains.map(|e| mandel::norm(&e)))),
        }
        if live != [0.0; 3] || dead != [0.0; 3] {
            for (l, w) in TETRAHEDRON_2 {
                let shape = tet10::shape(l);
                let at = (0..10)
                    .fold([0.0; 3], |s, i| vec3::add(s, vec3::scale(shape[i], p.velocities[i])));
                share.power += w * p.volume * vec3::dot(live, at);
                share.dead += w * p.volume * vec3::dot(dead, at);
            }
        }
    }
    share
}

/// Dissipation per volume in each tet, an upper bound \[N mm/mm³ per unit of time\].
pub fn dissipation_densities(
    model: &AnalysisModel,
    field: &VelocityField,
    subdivisions: u32,
) -> Vec<f64> {
    let space = Tet10Space::new(&model.mesh);
    let radii = model.yield_radii();
    (0..model.mesh.tets.len())
        .into_par_iter()
        .map(|e| {
            let radius = radii[model.mesh.tet_body[e] as usize];
            let pieces = pieces(model, &space, field, radius.is_some(), e);
            share_of(&pieces, radius, [[0.0; 3]; 2], subdivisions).dissipation
                / model.mesh.volume(e)
        })
        .collect()
}

/// Certifies velocities as an upper bound; each subdivision of the dissipation rule brings the
/// bound nearer to the value of the field itself.
pub fn certify_upper(
    model: &AnalysisModel,
    field: &VelocityField,
    subdivisions: u32,
) -> UpperCertificate {
    let mesh = &model.mesh;
    let space = Tet10Space::new(mesh);
    let u = &field.nodes.u;
    let max_u = largest(u.iter().map(|x| vec3::norm(*x)));
    let radii = model.yield_radii();
    let bodies = [model.body_forces(Loads::LIVE), model.body_forces(Loads::DEAD)];
    let shares: Vec<Share> = (0..mesh.tets.len())
        .into_par_iter()
        .map(|e| {
            let body = mesh.tet_body[e] as usize;
            let pieces = pieces(model, &space, field, radii[body].is_some(), e);
            share_of(&pieces, radii[body], [bodies[0][body], bodies[1][body]], subdivisions)
        })
        .collect();
    let mut dissipation = vec![Sum::default(); model.parts.len()];
    let (mut live, mut dead) = (Sum::default(), Sum::default());
    for (share, part) in shares.iter().zip(&model.tet_part) {
        dissipation[*part as usize].add(share.dissipation);
        live.add(share.power);
        dead.add(share.dead);
    }
    for load in &model.surface_loads {
        let power = if load.dead { &mut dead } else { &mut live };
        add_work(model, &space, u, load, power);
    }
    let mut off = slip::off_supports(model, &space, u)
        .max(ties::opening(model, &space, u))
        .max(cut_limits::mismatch(model, &space, field));
    for r in &model.rigid {
        let (motion, error) = fit_rigid(model, &space, u, r);
        off = off.max(error);
        for i in 0..6 {
            live.add(motion[i] * r.action[i]);
            dead.add(motion[i] * r.dead_action[i]);
        }
    }
    // `largest` skips NaN
    let finite = u.iter().flatten().all(|x| x.is_finite());
    let margin = smallest_margin(model, &space, u);
    let violation = margin.map(|m| (-m).max(0.0));
    let trace = largest(shares.iter().map(|s| s.trace));
    let strain = largest(shares.iter().map(|s| s.strain));
    let welds = welds::dissipations(model, u);
    let supports = slip::dissipations(model, &space, u);
    let ties = ties::dissipations(model, &space, u);
    let ground = crushing::dissipations(model, &space, u);
    let resultants = cut_limits::costs(model, field);
    let interfaces = [&welds, &supports, &ties, &ground, &resultants].into_iter().flatten();
    let total = Sum::of(dissipation.iter().map(|d| d.value()).chain(interfaces.copied()));
    // the flow that removes a volume change is larger by the inf-sup constant, about 10 in a
    // compact body and more in a slender one; every other residual moves a neighbouring element in
    // the same way
    let residual = trace + strain + off + violation.unwrap_or(0.0);
    let smallest =
        (0..mesh.tets.len()).map(|e| mesh.volume(e)).fold(f64::INFINITY, f64::min).cbrt();
    let capacity = Sum::of(
        (0..mesh.tets.len())
            .map(|e| mesh.volume(e) * radii[mesh.tet_body[e] as usize].unwrap_or(0.0)),
    );
    let weld_capacity =
        Sum::of(weld_faces(model).iter().map(|f| f.law.strength * f.normal(model).1));
    let slip_capacity = slip::capacity(model, &space, u) + ties::capacity(model, &space, u);
    let limits = Sum::of(model.resultant_limits.iter().map(|l| l.at_most));
    let interfaces = weld_capacity + slip_capacity + crushing::capacity(model) + limits;
    let capacity = capacity / smallest + interfaces;
    let hidden = 10.0 * slenderness(model) * residual * capacity;
    let rounding = 1e-13 * (total + dead.value().abs());
    // a motion on which the loads do no work has rounding in their direction, which proves nothing
    let live = live.value();
    let live = if live.abs() > NO_WORK * max_u * live_force(model) { live } else { 0.0 };
    UpperCertificate {
        factor: if finite { (total - dead.value()) / live } else { f64::NAN },
        volume: ratio(trace, max_u),
        rigid: ratio(strain, max_u),
        compatibility: ratio(off, max_u),
        contact: violation.map(|v| ratio(v, max_u)),
        smallest_margin: margin,
        dissipation: dissipation.iter().map(|d| d.value()).collect(),
        welds,
        supports,
        ties,
        ground,
        resultants,
        live_power: live,
        dead_power: dead.value(),
        cover: (hidden + rounding) / live.abs(),
    }
}

/// Sum of the sizes of all live loads, moments over the reach of their faces \[N\].
fn live_force(model: &AnalysisModel) -> f64 {
    let mut force = Sum::default();
    for load in model.surface_loads.iter().filter(|l| !l.dead) {
        for f in &load.faces {
            let corners = face_corners(&model.mesh, f);
            let area = vec3::area_vector(&corners);
            let n = vec3::unit(area);
            let traction = largest(corners.map(|x| vec3::norm(load.at(x, n))));
            force.add(vec3::norm(area) * traction);
        }
    }
    for r in &model.rigid {
        let [x, y, z, mx, my, mz] = r.action;
        let corners = r.faces.iter().flat_map(|f| face_corners(&model.mesh, f));
        let reach = largest(corners.map(|x| vec3::norm(vec3::sub(x, r.at))));
        force.add(vec3::norm([x, y, z]) + ratio(vec3::norm([mx, my, mz]), reach));
    }
    let bodies = model.body_forces(Loads::LIVE);
    for (e, body) in model.mesh.tet_body.iter().enumerate() {
        force.add(model.mesh.volume(e) * vec3::norm(bodies[*body as usize]));
    }
    force.value()
}

/// Smallest margin `g_N − μ‖g_T‖` of the Bernstein coefficients of all contact faces, each with its
/// own normal; initial gaps count as closed. Crushing ground yields to any motion.
fn smallest_margin(model: &AnalysisModel, space: &Tet10Space, u: &[V3]) -> Option<f64> {
    let resisting =
        contact_faces(model).into_iter().filter(|f| model.crushing_strength(f.of).is_none());
    let margins = resisting.flat_map(|f| {
        let (n, _) = f.normal(model);
        let a = space.triangle(f.nodes_a);
        let b = f.b.map(|(_, nodes)| space.triangle(nodes));
        let jump = move |i: usize| vec3::sub(b.map_or([0.0; 3], |b| u[b[i]]), u[a[i]]);
        let mu = f.law.mu;
        (0..6).map(move |i| {
            let g = if i < 3 {
                jump(i)
            } else {
                let [p, q] = FACE_EDGES[i - 3];
                let ends = vec3::scale(0.5, vec3::add(jump(p), jump(q)));
                vec3::sub(vec3::scale(2.0, jump(i)), ends)
            };
            let gn = vec3::dot(g, n);
            gn - mu * vec3::norm(vec3::sub(g, vec3::scale(gn, n)))
        })
    });
    margins.reduce(f64::min)
}
