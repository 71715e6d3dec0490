//! Passes on ever better meshes until the gap asked for is reached or a limit ends it; the best
//! bounds of all are the result.

use crate::analysis::memory::room;
use crate::diag::{Diagnostic, Diagnostics};
use crate::driver::analysis_pass::AnalysisPass;
use crate::driver::case::{Case, Limits, RunContext, run_pass, too_large};
use crate::driver::remesh::Made;
use crate::mesh::TetMesh;
use crate::model::AnalysisModel;
use crate::model::file::ModelFile;
use crate::refine::plan::{self, Left, Next, Prediction, Step, Stop};
use crate::refine::rates;
use crate::report::console::log::Log;
use crate::report::console::pace::about;
use crate::report::figures::{Rounding, fixed, percent_up};
use crate::report::markdown::page::Table;
use crate::result::combine::{self, best};
use crate::result::data::{CaseResult, Predicted};
use crate::solve::Patterns;
use std::sync::Arc;
use std::time::Instant;

/// A pass that is kept, with its mesh.
pub struct Kept {
    /// What it left.
    pub outcome: AnalysisPass,
    /// The model on its mesh.
    pub model: AnalysisModel,
    /// Where it is not the first mesh: the mesh, the model file and the quality.
    pub made: Option<(TetMesh, ModelFile, Table)>,
    /// Its place among the passes.
    index: usize,
}

/// What the passes of a case leave.
pub struct Adapted {
    /// The entry of the result, one row of history a pass.
    pub entry: CaseResult,
    /// The pass with the best upper bound.
    pub upper: Kept,
    /// The pass with the best lower bound, where it is another one.
    pub lower: Option<Kept>,
}

/// What a case shares with the others.
pub struct Share<'a> {
    /// Seconds on the clock of the log at which it should be done with, if the cases that follow
    /// are to have theirs.
    pub until: f64,
    /// What passes on the first mesh have found.
    pub patterns: &'a Patterns,
}

/// Analyses a case, mesh after mesh. `first`: nothing was analysed before, so what does not fit
/// ends the run.
pub fn analyse(
    case: Case,
    first: bool,
    share: &Share,
    context: &RunContext,
    limits: &Limits,
    log: &Arc<Log>,
) -> Result<Adapted, Diagnostics> {
    let Case { name, model, mut remesh, mesh_seconds, .. } = case;
    let mut entries: Vec<CaseResult> = Vec::new();
    let mut steps: Vec<Step> = Vec::new();
    let mut kept: Vec<Kept> = Vec::new();
    let mut next = (model, None, mesh_seconds, None::<Prediction>);
    let mut stop = None;
    loop {
        let (model, made, mesh_seconds, predicted) = next;
        let index = entries.len();
        let start = Instant::now();
        let until = if index == 0 { f64::INFINITY } else { share.until };
        // every later mesh is this case's own
        let own = Patterns::default();
        let patterns = if index == 0 { share.patterns } else { &own };
        let outcome = run_pass(&name, &model, until, patterns, limits, log)?;
        let runs = outcome.runs();
        // no program had to run where an answer is proved without one
        if index == 0
            && first
            && !runs.is_empty()
            && runs.iter().all(|(_, run)| run.refusal.is_some())
        {
            return Err(too_large(&name, &outcome, context).into());
        }
        let seconds = mesh_seconds.unwrap_or(0.0) + start.elapsed().as_secs_f64();
        let mut entry = outcome.entry(&name, &model, mesh_seconds);
        if let Some(row) = entry.history.last_mut() {
            row.seconds = Some(seconds);
            row.predicted = predicted.map(|p| Predicted {
                macro_tets: p.tets.round() as usize,
                gap: p.gap,
                seconds: p.seconds,
            });
        }
        let strict = entry.certificate.is_some_and(|c| c.strict);
        let step =
            entry.gap.filter(|_| strict && outcome.contributions().is_some()).map(|gap| Step {
                tets: model.mesh.tets.len(),
                gap,
                seconds,
                bytes: outcome
                    .runs()
                    .iter()
                    .filter_map(|(_, r)| r.forecast)
                    .map(|f| f.bytes)
                    .max()
                    .unwrap_or(0),
                predicted,
            });
        entries.push(entry);
        kept.push(Kept { outcome, model, made, index });
        let place = best(&entries).map_or([index; 2], |b| [b.lower, b.upper]);
        // fields of a pass that gives neither bound are not needed any more, but the last pass says
        // where to refine
        kept.retain(|k| place.contains(&k.index) || k.index == index);
        let (Some(adapt), Some(remesher)) = (&context.adapt, &mut remesh) else { break };
        let Some(step) = step else {
            if index > 0 {
                log.line(format!(
                    "{name}: mesh {}: no strict bracket, the result is that of the meshes before",
                    index + 1
                ));
            }
            break;
        };
        let tets = step.tets;
        steps.push(step);
        if limits.interrupt.asked() {
            break;
        }
        let best_gap = joined(&name, &entries)?.gap.unwrap_or(f64::INFINITY);
        let left = Left {
            seconds: share.until - log.seconds(),
            bytes: room(limits.memory).map(|r| r.bytes),
        };
        let Some(last) = kept.iter().find(|k| k.index == index) else { break };
        let estimate = last
            .outcome
            .contributions()
            .map(|c| rates::estimate(&last.model, c, last.outcome.yield_multiplier_share()));
        let Some(estimate) = estimate else { break };
        let realised = |wanted: &[f64]| remesher.realised(wanted);
        let (choice, curve) =
            plan::next(&steps, best_gap, adapt, &left, &mut |most| estimate.curve(most, &realised));
        let (Next::Refine(p), Some(curve)) = (choice, curve) else {
            if let Next::Stop(why) = choice {
                stop = Some(why);
            }
            break;
        };
        log.line(format!(
            "{name}: mesh {}: {} tets, gap {}; the next one is to have {} tets and a gap of {}, \
             in {}",
            index + 1,
            fixed(tets as f64, 0, Rounding::Nearest),
            percent_up(steps[steps.len() - 1].gap),
            fixed(p.tets, 0, Rounding::Nearest),
            percent_up(p.gap),
            about(p.seconds)
        ));
        let order = plan::order(&steps, p.tets);
        let design = estimate.with_tets(&curve, order, &realised);
        let p = Prediction { tets: design.tets * p.tets / order, ..p };
        match remesher.remesh(&design, share.until - log.seconds(), log) {
            Ok(Made { model, mesh, file, quality, seconds }) => {
                next = (model, Some((mesh, file, quality)), Some(seconds), Some(p));
            }
            Err(faults) => {
                // what is certified stays, whatever becomes of the next mesh
                let why = faults.into_first().message;
                log.line(format!("{name}: no further mesh: {why}"));
                if let Some(e) = entries.last_mut().filter(|_| !limits.interrupt.asked()) {
                    e.warnings.push(format!("there was no finer mesh: {why}"));
                }
                break;
            }
        }
    }
    finish(&name, entries, kept, stop, context, limits)
}

fn lost(name: &str) -> Diagnostic {
    Diagnostic::undecided("cli/lost", format!("the best pass of `{name}` was lost"))
}

fn joined(name: &str, entries: &[CaseResult]) -> Result<CaseResult, Diagnostics> {
    let Some(b) = best(entries) else { return Err(lost(name).into()) };
    let upper = entries[b.upper].clone();
    if b.upper == b.lower {
        return Ok(upper);
    }
    combine::join(upper, entries[b.lower].clone()).map_err(|e| {
        Diagnostic::undecided("bounds/contradiction", e.to_string())
            .help("the numbers are withheld; try `--solver clarabel`, and report the case")
            .into()
    })
}

fn finish(
    name: &str,
    entries: Vec<CaseResult>,
    mut kept: Vec<Kept>,
    stop: Option<Stop>,
    context: &RunContext,
    limits: &Limits,
) -> Result<Adapted, Diagnostics> {
    let mut entry = joined(name, &entries)?;
    entry.history = entries.iter().flat_map(|e| e.history.iter().cloned()).collect();
    if let Some(last) = entries.last() {
        let new: Vec<String> =
            last.warnings.iter().filter(|w| !entry.warnings.contains(w)).cloned().collect();
        entry.warnings.extend(new.into_iter().map(|w| format!("mesh {}: {w}", entries.len())));
    }
    if let (Some(gap), Some(adapt)) = (entry.gap, &context.adapt)
        && gap > adapt.target_gap
    {
        entry.warnings.push(format!(
            "the gap is {}, the target {}: {}",
            percent_up(gap),
            percent_up(adapt.target_gap),
            shortfall(stop, entries.len(), context, limits)
        ));
    }
    let Some(b) = best(&entries) else { return Err(lost(name).into()) };
    let mut take =
        |index: usize| kept.iter().position(|k| k.index == index).map(|i| kept.swap_remove(i));
    let upper = take(b.upper);
    let lower = if b.lower == b.upper { None } else { take(b.lower) };
    // both were kept when they became the best
    let Some(upper) = upper else {
        return Err(lost(name).into());
    };
    Ok(Adapted { entry, upper, lower })
}

/// Why the target was missed, and what helps.
fn shortfall(stop: Option<Stop>, passes: usize, context: &RunContext, limits: &Limits) -> String {
    let max_passes = context.adapt.map_or(1, |a| a.max_passes);
    match stop {
        _ if limits.interrupt.asked() => "the run was interrupted".into(),
        Some(Stop::Passes) | None if max_passes == 1 => {
            format!("a finer mesh is needed ({})", context.finer)
        }
        Some(Stop::Passes) => format!("{passes} meshes were allowed (`max_passes`)"),
        Some(Stop::Tets) => "no mesh within `max_macro_tets` would narrow it much".into(),
        Some(Stop::Time) => "no further mesh fits into `time_limit`".into(),
        Some(Stop::Memory) => "no finer mesh fits into the memory".into(),
        Some(Stop::Nothing) => "no element contributes to it, so no mesh narrows it".into(),
        Some(Stop::Target) | None => format!("a finer mesh is needed ({})", context.finer),
    }
}
