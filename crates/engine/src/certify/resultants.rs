//! Resultants of contact tractions between bodies, from a stress field.

use crate::certify::faces::contact_faces;
use crate::certify::fields::StressField;
use crate::certify::tractions::contact_tractions;
use crate::model::AnalysisModel;
use bracket_base::math::Sum;
use bracket_base::math::vec3::{self, V3};
use std::collections::BTreeMap;

/// Resultant of the contact between two bodies of the meshed part.
#[derive(Clone, Debug, PartialEq)]
pub struct ContactResultant {
    /// Bodies of the mesh; the second is `None` where it is rigid ground.
    pub between: (u32, Option<u32>),
    /// Force on the first body \[N\], global axes.
    pub force: V3,
    /// Compression ∫ r_N dA \[N\].
    pub compression: f64,
    /// Centre of pressure ∫ r_N x dA / ∫ r_N dA \[mm\]; `None` where nothing presses.
    pub centre: Option<V3>,
    /// Least and largest coordinates of the faces in contact \[mm\].
    pub extent: [V3; 2],
}

#[derive(Default)]
struct Sums {
    force: [Sum; 3],
    compression: Sum,
    moment: [Sum; 3],
    extent: Option<[V3; 2]>,
}

/// The resultants of all pairs of bodies in contact, in the order of the bodies.
///
/// Tractions are linear over each face, so that the integrals are exact: `∫ r = A/3 Σ r_i`,
/// `∫ r_N x = A/12 Σ (1 + δ_ij) r_Ni x_j`. Loads on faces in contact count as carried by the
/// contact.
pub fn contact_resultants(model: &AnalysisModel, field: &StressField) -> Vec<ContactResultant> {
    let mut pairs: BTreeMap<(u32, Option<u32>), Sums> = BTreeMap::new();
    let body = |tet: u32| model.mesh.tet_body[tet as usize];
    for face in contact_faces(model) {
        let sums = pairs.entry((body(face.a.tet), face.b.map(|(b, _)| body(b.tet)))).or_default();
        let (n, area) = face.normal(model);
        let x = face.corners(model);
        let [low, high] = sums.extent.get_or_insert([x[0]; 2]);
        for (k, corner) in x.iter().flat_map(|c| c.iter().enumerate()) {
            (low[k], high[k]) = (low[k].min(*corner), high[k].max(*corner));
        }
        let r = contact_tractions(model, field, &face, None);
        let normal = r.map(|r| vec3::dot(r, n));
        for i in 0..3 {
            sums.compression.add(area / 3.0 * normal[i]);
            for k in 0..3 {
                // r acts on side B; the force on A is opposite
                sums.force[k].add(-area / 3.0 * r[i][k]);
                for j in 0..3 {
                    let weight = if i == j { 2.0 } else { 1.0 };
                    sums.moment[k].add(area / 12.0 * weight * normal[i] * x[j][k]);
                }
            }
        }
    }
    pairs
        .into_iter()
        .map(|(between, s)| {
            let compression = s.compression.value();
            let centre = (compression > 0.0).then(|| s.moment.map(|m| m.value() / compression));
            let force = s.force.map(|f| f.value());
            let extent = s.extent.unwrap_or_default();
            ContactResultant { between, force, compression, centre, extent }
        })
        .collect()
}
