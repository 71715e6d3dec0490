//! Elastic, perfectly plastic analysis (Hencky): both programs on one mesh, with yield conditions
//! only where they are needed.
//!
//! An elastic solution shows where the stress can reach yield. The tets there, with some margin,
//! get yield conditions (flow, in the kinematic program); the others stay elastic and cost nothing.
//! The tets that the solution still shows beyond yield join them, and the program is solved again
//! until there are none (`yield_set`). The static field is then admissible at every point and
//! optimal among all fields of the mesh; the kinematic field is admissible in any case.
//!
//! With contact the first solve needs as many iterations as one with yield conditions, so that
//! every tet that can yield gets them at once: one solve a program, three to four times faster than
//! the search on a joint (benches/README.md), and its forecast is that of the whole analysis.
//!
//! Preloaded bolts, which stay elastic, are tightened first (`tightening`).
//!
//! Under Coulomb's law each kinematic solve is a fixed point as in elastic analysis, started from
//! the shift of the one before; the static program then solves the last of these problems.

mod programs;
mod yield_set;

use crate::analysis::energy_pass::EnergyPass;
use crate::analysis::engine::{Both, assemble_and_run};
use crate::analysis::event::{Event, Progress};
use crate::analysis::pass::{PassError, PassOptions};
use crate::analysis::program::Program;
use crate::analysis::tightening::tightened_first;
use crate::model::AnalysisModel;
use crate::model::file::Bounds;
use programs::{HenckyKinematic, HenckyStatic, Motion};
use std::time::Instant;
use yield_set::{First, KinematicSide, Side, StaticSide};

/// Runs both programs; under Coulomb's law one after the other, the static one with the shift of
/// the kinematic one.
pub fn run(
    model: &AnalysisModel,
    options: &PassOptions,
    progress: &Progress,
) -> Result<EnergyPass, PassError> {
    tightened_first(model, options, progress, run_loaded)
}

/// Runs both programs of a model whose bolts, if any, are tightened.
fn run_loaded(
    model: &AnalysisModel,
    options: &PassOptions,
    progress: &Progress,
) -> Result<EnergyPass, PassError> {
    let start = Instant::now();
    let slides = model.has_coulomb_friction();
    let first = First::of(model);
    let mut kinematic = Side::new(model, slides || model.bounds != Bounds::Static, first);
    let mut statics = Side::new(model, !slides && model.bounds != Bounds::Kinematic, first);
    solve(model, options, progress, start, &mut kinematic, &mut statics)?;
    let Some(found) = kinematic.answer.as_ref().and_then(|(motion, _)| motion.shift.clone()) else {
        return join(model, kinematic, statics);
    };
    let shifted = found.shifted(model);
    if model.bounds != Bounds::Kinematic {
        statics = Side::new(model, true, first);
        solve(&shifted, options, progress, start, &mut kinematic, &mut statics)?;
    }
    let pass = join(&shifted, kinematic, statics)?;
    Ok(EnergyPass { fixed_point: Some(found.run), shift: found.shift, ..pass })
}

/// Solves until both sides are done.
fn solve(
    model: &AnalysisModel,
    options: &PassOptions,
    progress: &Progress,
    start: Instant,
    kinematic: &mut KinematicSide,
    statics: &mut StaticSide,
) -> Result<(), PassError> {
    while !(kinematic.done && statics.done) {
        for (program, tets, done) in [
            (Program::Kinematic, kinematic.count(), kinematic.done),
            (Program::Static, statics.count(), statics.done),
        ] {
            if tets > 0 && !done {
                progress(program, Event::Yielding { tets });
            }
        }
        let (k, s): Both<_, _> = assemble_and_run(
            model,
            &options.remaining(start),
            progress,
            (!kinematic.done).then_some(|| {
                let found = kinematic.answer.as_ref().and_then(|(motion, _)| motion.shift.as_ref());
                HenckyKinematic::new(model, &kinematic.yields, kinematic.rough, found)
            }),
            (!statics.done).then_some(|| {
                HenckyStatic::new(model, &statics.yields, statics.margin, statics.rough)
            }),
        )?;
        if let Some(k) = k {
            kinematic.add_solve(model, k.outcome, k.answer);
        }
        if let Some(s) = s {
            statics.add_solve(model, s.outcome, s.answer);
        }
    }
    Ok(())
}

/// Joins the results of both programs.
fn join(
    model: &AnalysisModel,
    kinematic: KinematicSide,
    statics: StaticSide,
) -> Result<EnergyPass, PassError> {
    let mut pass = EnergyPass {
        kinematic: kinematic.outcome,
        statics: statics.outcome,
        ..EnergyPass::default()
    };
    if let Some((Motion { field, .. }, bound)) = kinematic.answer {
        pass.displacement = Some(field.nodes.clone());
        pass.plastic = Some(field);
        pass.upper = Some(bound);
    }
    if let Some((field, bound)) = statics.answer {
        pass.stress = Some(field);
        pass.lower = Some(bound);
    }
    pass.join(model)?;
    Ok(pass)
}
