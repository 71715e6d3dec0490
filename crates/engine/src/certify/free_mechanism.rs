//! Certificate of collapse at zero load: a mechanism that moves every part rigidly without
//! dissipation.
//!
//! Parts that only contact holds can lift off, or slide and dilate with associated friction,
//! without dissipation. Where the live loads do positive work on such a motion and the dead loads
//! do no work against it, `λ_up = (0 − dead power)/live power ≤ 0`. The certificate is that of an
//! upper bound with every body rigid; it does not depend on how the motion was found.

use crate::certify::faces::{tie_faces, weld_faces};
use crate::certify::limit_certificate::{UpperCertificate, certify_upper};
use crate::certify::load_factor::UpperFactor;
use crate::certify::measures::{largest, ratio};
use crate::certify::velocity_field::VelocityField;
use crate::certify::welds::jumps;
use crate::elements::space::Tet10Space;
use crate::model::AnalysisModel;
use bracket_base::math::vec3;

/// Power of the dead loads against the motion, over that of the live ones, that rounding explains.
const ROUNDING: f64 = 1e-12;

/// A mechanism at zero load.
#[derive(Clone, Debug, PartialEq)]
pub struct FreeMechanism {
    /// Its velocities.
    pub field: VelocityField,
    /// Their certificate, with every body rigid.
    pub certificate: UpperCertificate,
}

/// Certifies velocities as a mechanism at zero load: an upper bound with every body, every weld and
/// the ground rigid, nothing dissipates. A jump at a weld or a tie over the largest velocity counts
/// among the strains of rigid bodies.
pub fn certify_free(model: &AnalysisModel, field: &VelocityField) -> UpperCertificate {
    let mut rigid = model.on_rigid_ground();
    rigid.materials.iter_mut().for_each(|m| m.fy = None);
    rigid.welds.clear();
    rigid.ties.clear();
    let mut certificate = certify_upper(&rigid, field, 0);
    let u = &field.nodes.u;
    let space = Tet10Space::new(&model.mesh);
    let welds = weld_faces(model).into_iter().flat_map(|f| jumps(&space, &f, u));
    let ties = tie_faces(model).into_iter().flat_map(|f| jumps(&space, &f, u));
    let jump = ratio(
        largest(welds.chain(ties).map(vec3::norm)),
        largest(u.iter().map(|x| vec3::norm(*x))),
    );
    certificate.rigid = certificate.rigid.max(jump);
    certificate
}

/// True when the certificate proves that no positive load factor can be carried.
pub fn is_free(certificate: &UpperCertificate) -> bool {
    let strict = UpperFactor::new(certificate.clone()).is_strict();
    strict && certificate.dead_power >= -ROUNDING * certificate.live_power
}
