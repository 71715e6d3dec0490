//! Limit analysis on one mesh: strict bounds of the load factor.
//!
//! A load factor without limit, or of zero, is proved without any program (`proof`). Otherwise both
//! programs run (`programs`); with friction the static one runs again without friction, and
//! under Coulomb's law a fixed point estimates the load factor (`coulomb`).

mod coulomb;
mod pass;
mod programs;
mod proof;

use crate::analysis::engine::{both, static_alone};
use crate::analysis::event::{Event, Progress};
use crate::analysis::pass::{PassError, PassOptions};
use crate::analysis::program::Program;
use crate::certify::FactorBracket;
use crate::math::vec3::V3;
use crate::model::file::Bounds;
use crate::model::{AnalysisModel, resolve};
use crate::recover::free_mechanism;
pub use coulomb::CoulombEstimate;
pub use pass::LimitPass;
use programs::{LimitKinematic, LimitStatic};
pub use programs::{NO_LIMIT, SUBDIVISIONS, velocity};
use std::time::Instant;

/// Runs both programs, and the static one without friction where there is friction; none where a
/// load factor without limit or of zero can be proved.
pub fn run(
    model: &AnalysisModel,
    options: &PassOptions,
    progress: &Progress,
) -> Result<LimitPass, PassError> {
    let start = Instant::now();
    if let Some(pass) = proof::without_programs(model, &options.solve.patterns)? {
        return Ok(pass);
    }
    // under Coulomb's law the lower bound without friction answers
    let without_alone = options.answer_from.is_some()
        && model.has_coulomb_friction()
        && model.bounds == Bounds::Static;
    let (kinematic, statics) = if without_alone {
        (None, None)
    } else {
        both(model, options, progress, LimitKinematic::new, LimitStatic::new)?
    };
    let mut pass = LimitPass::default();
    if let Some(k) = kinematic {
        pass.kinematic = Some(k.outcome);
        if let Some((field, bound)) = k.answer {
            pass.velocity = Some(field);
            pass.upper = Some(bound);
        }
    }
    let fits = match &statics {
        Some(s) => s.outcome.refusal.is_none(),
        None => without_alone,
    };
    if let Some(s) = statics {
        pass.statics = Some(s.outcome);
        if let Some(lower) = s.answer {
            pass.stress = Some(lower.stress);
            pass.lower = Some(lower.bound);
            pass.yield_multiplier_share = Some(lower.yield_multiplier_share);
            pass.static_velocities = Some(lower.velocities);
        }
    }
    if let (Some(l), Some(u)) = (&pass.lower, &pass.upper) {
        pass.bracket = Some(FactorBracket::new(l.clone(), u.clone())?);
    }
    let reached = |at: f64| pass.lower.as_ref().is_some_and(|l| l.value() >= at);
    let wanted = model.has_coulomb_friction() || options.answer_from.is_none_or(reached);
    if model.has_friction() && fits && wanted && !options.solve.interrupted() {
        match resolve::without_friction(model) {
            Ok(smooth) => {
                let smooth = AnalysisModel { bounds: Bounds::Static, ..smooth };
                let found =
                    add_frictionless(&mut pass, &smooth, &options.remaining(start), progress)?;
                if let Some((share, velocities)) = found
                    && model.has_coulomb_friction()
                {
                    pass.yield_multiplier_share = Some(share);
                    pass.static_velocities = Some(velocities);
                }
            }
            Err(e) => pass.slides = Some(e.into_first().message),
        }
    }
    // without a solution under associated friction there is nothing to start the estimate from
    let failed = pass.kinematic.is_some() && pass.velocity.is_none();
    if model.coulomb_estimate
        && model.has_coulomb_friction()
        && !failed
        && !options.solve.interrupted()
    {
        let velocity = pass.velocity.as_ref();
        let found = coulomb::estimate(model, velocity, &options.remaining(start), progress)?;
        pass.coulomb_estimate = Some(pass.within_bounds(found));
    }
    pass.add_contributions(model)?;
    Ok(pass)
}

/// The static program's own mechanism: shares of the yield multipliers and velocities of the
/// vertices.
type OwnMechanism = (Vec<f64>, Vec<V3>);

/// Adds the lower bound of the model without friction; returns its shares of the yield multipliers
/// and its velocities.
fn add_frictionless(
    pass: &mut LimitPass,
    smooth: &AnalysisModel,
    options: &PassOptions,
    progress: &Progress,
) -> Result<Option<OwnMechanism>, PassError> {
    if let Ok(Some(free)) = free_mechanism::find(smooth) {
        pass.slides = Some(proof::moving_parts(smooth, &free.field));
        return Ok(None);
    }
    progress(Program::Static, Event::Frictionless);
    let statics = static_alone(smooth, options, progress, || LimitStatic::new(smooth))?;
    let mut found = None;
    if let Some(s) = statics {
        pass.frictionless_run = Some(s.outcome);
        if let Some(lower) = s.answer {
            pass.frictionless_stress = Some(lower.stress);
            pass.frictionless = Some(lower.bound);
            found = Some((lower.yield_multiplier_share, lower.velocities));
        }
    }
    if let (Some(l), Some(u)) = (&pass.frictionless, &pass.upper) {
        pass.coulomb = Some(FactorBracket::new(l.clone(), u.clone())?);
    }
    Ok(found)
}
