//! Rigid motions that neither supports nor frozen contacts resist.
//!
//! Frictionless contact leaves parts loose: a bolt may turn about its axis, a plate may slide
//! between others. Without stiffness such a motion is no buckling mode, but the stiffness matrix is
//! singular. One unknown is held for each of these motions. That is a statically determinate
//! support: it adds no stiffness between parts, as springs against slip would.

use crate::model::AnalysisModel;
use crate::programs::conic::SymmetricCsc;
use crate::programs::constraints;
use crate::programs::elastic_unknowns::ElasticUnknowns;
use bracket_base::math::dense::{Mat, null_space};

/// A motion is loose if the contacts resist it less than this times the motion that they resist
/// most.
const LOOSE: f64 = 1e-10;

/// Unknowns to hold against the loose motions, beyond the pins against free motions of the model.
pub fn pins(
    model: &AnalysisModel,
    unknowns: &ElasticUnknowns,
    contact: &SymmetricCsc,
) -> Vec<usize> {
    let modes = unknowns.contact_modes(model);
    let forces: Vec<Vec<f64>> = modes.iter().map(|m| contact.mul(&m.unknowns)).collect();
    let work = |i: usize, j: usize| {
        modes[i].unknowns.iter().zip(&forces[j]).map(|(u, f)| u * f).sum::<f64>()
    };
    let gram = Mat::from_fn(modes.len(), modes.len(), work);
    let loose = null_space(&gram, LOOSE).into_iter().map(|c| {
        let mut motion = vec![0.0; unknowns.map.n];
        for (mode, c) in modes.iter().zip(&c) {
            motion.iter_mut().zip(&mode.unknowns).for_each(|(m, u)| *m += c * u);
        }
        motion
    });
    constraints::pins(loose.collect(), &unknowns.pins)
}
