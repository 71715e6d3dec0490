//! Load factors that are proved without any program: without limit, or zero.

use crate::analysis::limit::pass::LimitPass;
use crate::analysis::limit::programs::dead_stress;
use crate::analysis::pass::PassError;
use crate::certify::LowerFactor;
use crate::certify::fields::StressField;
use crate::certify::limit_certificate::certify_lower;
use crate::certify::velocity_field::VelocityField;
use crate::model::AnalysisModel;
use crate::recover::elastic::RecoverError;
use crate::recover::moving_parts::mechanism;
use crate::recover::{free_mechanism, unlimited};
use crate::solve::Patterns;
use bracket_base::words::Text;

/// The parts that velocities move.
pub(super) fn moving_parts(model: &AnalysisModel, field: &VelocityField) -> Text {
    mechanism(model, model.node_parts().into_iter().zip(field.nodes.u.iter().copied()))
}

/// The pass of a load factor without limit or of zero; `None` where neither can be proved.
pub(super) fn without_programs(
    model: &AnalysisModel,
    patterns: &Patterns,
) -> Result<Option<LimitPass>, PassError> {
    model.check_limit_analysis()?;
    let dead = || dead_stress(model, patterns).transpose();
    // where a proof fails, the programs decide
    let unproved = |e: RecoverError| match e {
        RecoverError::Model(e) => Err(PassError::from(e)),
        _ => Ok(()),
    };
    match unlimited::find(model, dead) {
        Ok(Some(unlimited)) => {
            return Ok(Some(LimitPass { unlimited: Some(unlimited), ..LimitPass::default() }));
        }
        Ok(None) => {}
        Err(e) => unproved(e)?,
    }
    let free = match free_mechanism::find(model) {
        Ok(Some(free)) => free,
        Ok(None) => return Ok(None),
        Err(e) => return unproved(e).map(|()| None),
    };
    let mut pass = LimitPass {
        moves: Some(moving_parts(model, &free.field)),
        free: Some(free),
        ..LimitPass::default()
    };
    let stress = if model.has_dead_loads() {
        dead().unwrap_or(None)
    } else {
        Some(StressField::none(model.mesh.tets.len()))
    };
    if let Some(stress) = stress {
        let lower = LowerFactor::new(certify_lower(model, &stress, 0.0));
        if lower.is_strict() {
            // without stress there is no friction either
            if model.has_friction() && !model.has_dead_loads() {
                (pass.frictionless, pass.frictionless_stress) =
                    (Some(lower.clone()), Some(stress.clone()));
            }
            (pass.lower, pass.stress) = (Some(lower), Some(stress));
        }
    }
    Ok(Some(pass))
}
