//! Limit analysis on one mesh: strict bounds of the load factor.
//!
//! A load factor without limit, or of zero, is proved without any program (`proof`). Otherwise both
//! programs run (`programs`); with friction the static one runs again without friction, and
//! under Coulomb's law a fixed point estimates the load factor (`coulomb`).

mod coulomb;
mod pass;
mod programs;
mod proof;

use crate::analysis::engine::{both, kinematic_alone, static_alone};
use crate::analysis::event::{Event, Progress};
use crate::analysis::pass::{PassError, PassOptions};
use crate::analysis::program::Program;
use crate::model::file::Bounds;
use crate::model::{AnalysisModel, resolve};
use crate::recover::free_mechanism;
use bracket_base::math::vec3::V3;
pub use coulomb::CoulombEstimate;
pub use pass::LimitPass;
use programs::{LimitKinematic, LimitStatic};
pub use programs::{NO_LIMIT, SUBDIVISIONS, velocity};
use std::time::Instant;

/// Load factor of the load that a verdict is asked for.
const LOAD: f64 = 1.0;

/// Runs both programs, and the static one without friction where there is friction; none where a
/// load factor without limit or of zero can be proved. Where the time is not sure to suffice for
/// both ([`PassOptions::both_within`]), only the lower bound that answers is computed.
pub fn run(
    model: &AnalysisModel,
    options: &PassOptions,
    progress: &Progress,
) -> Result<LimitPass, PassError> {
    if let Some(pass) = proof::without_programs(model, &options.solve.patterns)? {
        return Ok(pass);
    }
    if (options.both_within > 0.0 || model.bounds != Bounds::Both)
        && let Some(pass) = programs(model, options, progress)?
    {
        return Ok(pass);
    }
    let lower = AnalysisModel { bounds: Bounds::Static, coulomb_estimate: false, ..model.clone() };
    let answer_from = options.answer_from.or(Some(LOAD));
    let options = PassOptions { answer_from, ..options.clone() };
    // one program alone always runs
    Ok(programs(&lower, &options, progress)?.unwrap_or_default())
}

/// Runs the programs of the bounds that the model requests; `None` where both would take too long.
fn programs(
    model: &AnalysisModel,
    options: &PassOptions,
    progress: &Progress,
) -> Result<Option<LimitPass>, PassError> {
    let start = Instant::now();
    // under Coulomb's law the lower bound without friction answers
    let without_alone = options.answer_from.is_some()
        && model.has_coulomb_friction()
        && model.bounds == Bounds::Static;
    let (kinematic, statics) = if without_alone {
        (None, None)
    } else {
        both(model, options, progress, LimitKinematic::new, LimitStatic::new)?
    };
    if kinematic.is_none() && statics.is_none() && !without_alone {
        return Ok(None);
    }
    let mut pass = LimitPass::default();
    if let Some(k) = kinematic {
        pass.add_kinematic(k);
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
    pass.join()?;
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
            Err(e) => pass.slides = Some(e.text()),
        }
    }
    complete(&mut pass, model, &options.remaining(start), progress)?;
    Ok(Some(pass))
}

/// True if a pass has the lower bound alone of two that the model requests.
pub fn wants_upper(pass: &LimitPass, model: &AnalysisModel) -> bool {
    let proved = pass.unlimited.is_some() || pass.free.is_some();
    model.bounds == Bounds::Both && pass.kinematic.is_none() && !proved
}

/// Adds the upper bound to a pass that has the lower one alone.
pub fn add_upper(
    pass: &mut LimitPass,
    model: &AnalysisModel,
    options: &PassOptions,
    progress: &Progress,
) -> Result<(), PassError> {
    let start = Instant::now();
    let found = kinematic_alone(model, options, progress, || LimitKinematic::new(model))?;
    if let Some(k) = found {
        pass.add_kinematic(k);
    }
    pass.join()?;
    complete(pass, model, &options.remaining(start), progress)
}

/// Adds what follows from both bounds: the estimate under Coulomb's law and the contributions.
fn complete(
    pass: &mut LimitPass,
    model: &AnalysisModel,
    options: &PassOptions,
    progress: &Progress,
) -> Result<(), PassError> {
    // without a solution under associated friction there is nothing to start the estimate from
    let failed = pass.kinematic.is_some() && pass.velocity.is_none();
    if model.coulomb_estimate
        && model.has_coulomb_friction()
        && !failed
        && !options.solve.interrupted()
    {
        let velocity = pass.velocity.as_ref();
        let found = coulomb::estimate(model, velocity, options, progress)?;
        pass.coulomb_estimate = Some(pass.within_bounds(found));
    }
    pass.add_contributions(model)
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
    pass.join()?;
    Ok(found)
}
