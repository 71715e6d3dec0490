//! Limited resultants of cuts: their utilisation by a stress field, the cost of the motions of a
//! mechanism ([`crate::model::resultant_limit`]).
//!
//! Let a stress be in equilibrium with `λ · live + dead` and within all limits, and let velocities
//! jump by δ across each cut, the same all over it. The power of the stress on the jumps is
//! `Σ_cut R · δ = Σ_limit R_limit · (s along + Σ y_k across_k) ≤ Σ_limit at_most s` where
//! `s ≥ ‖y‖`. So the costs belong to the dissipation of an upper bound.

use crate::certify::fields::StressField;
use crate::certify::measures::largest;
use crate::certify::tractions::stress_at;
use crate::certify::velocity_field::VelocityField;
use crate::elements::space::Tet10Space;
use crate::model::AnalysisModel;
use crate::model::analysis::{BoundaryFace, FacePair};
use bracket_base::math::Sum;
use bracket_base::math::mandel;
use bracket_base::math::vec3::{self, V3};

/// Resultant of a cut, the force of side B on side A \[N\], exact because tractions are linear on a
/// face; and the largest difference of the tractions on its two sides \[MPa\].
pub fn through(model: &AnalysisModel, field: &StressField, faces: &[FacePair]) -> (V3, f64) {
    let (mut sum, mut torn) = ([Sum::default(); 3], 0.0f64);
    for f in faces {
        let area = vec3::area_vector(&f.nodes_a.map(|n| model.mesh.nodes[n as usize]));
        let size = vec3::norm(area);
        let n = vec3::scale(1.0 / size, area);
        let side = |face: &BoundaryFace, nodes| {
            stress_at(model, field, (face.tet, face.local), nodes).map(|s| mandel::traction(&s, n))
        };
        let (a, b) = (side(&f.a, f.nodes_a), side(&f.b, f.nodes_b));
        for i in 0..3 {
            torn = torn.max(vec3::norm(vec3::sub(a[i], b[i])));
            (0..3).for_each(|d| sum[d].add(size / 3.0 * a[i][d]));
        }
    }
    (sum.map(|s| s.value()), torn)
}

/// Resultant of each cut whose resultant is limited \[N\], see [`through`].
pub fn resultants(model: &AnalysisModel, field: &StressField) -> Vec<V3> {
    model.cuts.iter().map(|cut| through(model, field, &cut.faces).0).collect()
}

/// Value of each limit over what it permits; NaN where a resultant is NaN.
pub fn utilisations(model: &AnalysisModel, field: &StressField) -> Vec<f64> {
    let resultants = resultants(model, field);
    let limits = model.resultant_limits.iter();
    limits.map(|limit| limit.value(&resultants) / limit.at_most).collect()
}

/// Cost of the motion of each limit \[N mm per unit of time\]; NaN where the field has other
/// motions than the model has limits.
pub fn costs(model: &AnalysisModel, field: &VelocityField) -> Vec<f64> {
    if field.limit_motions.len() != model.limit_motions() {
        return vec![f64::NAN; model.resultant_limits.len()];
    }
    model.motions_of_limits(&field.limit_motions).map(|(limit, m)| limit.cost(m)).collect()
}

/// Largest difference between the jump of the velocities across a cut and that of the motions, and
/// largest distance of a motion outside its cone \[mm per unit of time\].
pub fn mismatch(model: &AnalysisModel, space: &Tet10Space, field: &VelocityField) -> f64 {
    if field.limit_motions.len() != model.limit_motions() {
        return f64::INFINITY;
    }
    let jumps = model.cut_jumps(&field.limit_motions);
    let mut off = largest(model.motions_of_limits(&field.limit_motions).map(|(l, m)| l.outside(m)));
    for (cut, jump) in model.cuts.iter().zip(jumps) {
        for f in &cut.faces {
            let sides = space.triangle(f.nodes_a).into_iter().zip(space.triangle(f.nodes_b));
            let difference = |(a, b): (usize, usize)| {
                vec3::norm(vec3::sub(vec3::sub(field.nodes.u[b], field.nodes.u[a]), jump))
            };
            off = off.max(largest(sides.map(difference)));
        }
    }
    off
}

/// Contribution of each limit to the gap, `at_most s − R · jump` \[N mm per unit of time\], ≥ 0.
pub fn contributions(
    model: &AnalysisModel,
    velocity: &VelocityField,
    stress: &StressField,
) -> Vec<f64> {
    let resultants = resultants(model, stress);
    let costs = costs(model, velocity);
    if velocity.limit_motions.len() != model.limit_motions() {
        return costs;
    }
    let limits = model.motions_of_limits(&velocity.limit_motions).zip(costs);
    limits.map(|((l, m), cost)| cost - vec3::dot(l.resultant(&resultants), l.jump(m))).collect()
}
