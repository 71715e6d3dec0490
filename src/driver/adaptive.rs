//! Adaptive passes: successively better meshes until the target gap or a limit is reached. The
//! result consists of the best bounds of all passes.

use crate::analysis::dispatch::AnalysisPass;
use crate::analysis::memory::room;
use crate::diag::{Diagnostic, Diagnostics};
use crate::driver::case::Case;
use crate::driver::context::RunContext;
use crate::driver::limits::Limits;
use crate::driver::pass_entry::{pass_bounds, pass_entry};
use crate::driver::pass_run::{run_pass, too_large};
use crate::driver::remesh::Made;
use crate::mesh::TetMesh;
use crate::model::AnalysisModel;
use crate::model::file::ModelFile;
use crate::refine::directions::second_derivatives;
use crate::refine::optimum::Estimate;
use crate::refine::plan::{self, Budget, Next, Prediction, Step, Stop};
use crate::refine::rates;
use crate::report::console::log::Log;
use crate::report::console::pace::about;
use crate::report::figures::{Rounding, fixed, percent_up};
use crate::report::markdown::report_data::Table;
use crate::result::combine::{self, PassResult, best};
use crate::result::result_file::CaseResult;
use crate::result::result_file::Predicted;
use crate::solve::Patterns;
use std::sync::Arc;
use std::time::Instant;

/// A pass whose fields are kept, with its mesh.
pub struct Kept {
    /// Its bounds and fields.
    pub outcome: AnalysisPass,
    /// The model on its mesh.
    pub model: AnalysisModel,
    /// Mesh, model file and quality; `None` for the first mesh, whose files exist already.
    pub made: Option<(TetMesh, ModelFile, Table)>,
    /// Number of the pass, from 0.
    index: usize,
}

/// The result of all passes of a case.
pub struct Adapted {
    /// The entry of the result, with one row of history per pass.
    pub entry: CaseResult,
    /// The pass with the best upper bound.
    pub upper: Kept,
    /// The pass with the best lower bound, if it is a different pass.
    pub lower: Option<Kept>,
}

/// Data that a case shares with the other cases of the run.
pub struct Share<'a> {
    /// Time on the clock of the log at which the case should end, to leave the other cases their
    /// share \[s\].
    pub until: f64,
    /// Sparsity patterns that passes on the first mesh have found.
    pub patterns: &'a Patterns,
}

/// Analyses a case on successive meshes. `first` means that no case was analysed before; a program
/// that does not fit into the memory then ends the run.
pub fn analyse(
    case: Case,
    first: bool,
    share: &Share,
    context: &RunContext,
    limits: &Limits,
    log: &Arc<Log>,
) -> Result<Adapted, Diagnostics> {
    let Case { name, model, mut remesh, mesh_seconds, .. } = case;
    let mut entries: Vec<PassResult> = Vec::new();
    let mut steps: Vec<Step> = Vec::new();
    let mut kept: Vec<Kept> = Vec::new();
    let mut next = (model, None, mesh_seconds, None::<Prediction>);
    let mut stop = None;
    loop {
        let (model, made, mesh_seconds, predicted) = next;
        let index = entries.len();
        let start = Instant::now();
        let until = if index == 0 { f64::INFINITY } else { share.until };
        // later meshes are used by this case only
        let own = Patterns::default();
        let patterns = if index == 0 { share.patterns } else { &own };
        let outcome = run_pass(&name, &model, until, patterns, limits, log)?;
        let runs = outcome.runs();
        // there are no programs if the answer was proved without them
        if index == 0
            && first
            && !runs.is_empty()
            && runs.iter().all(|(_, run)| run.refusal.is_some())
        {
            return Err(too_large(&name, &outcome, context).into());
        }
        let seconds = mesh_seconds.unwrap_or(0.0) + start.elapsed().as_secs_f64();
        let mut entry = pass_entry(&outcome, &name, &model, mesh_seconds);
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
        let bounds = pass_bounds(&outcome, &entry);
        entries.push(PassResult { entry, bounds });
        kept.push(Kept { outcome, model, made, index });
        let place = best(&entries).map_or([index; 2], |b| [b.lower, b.upper]);
        // fields of a pass without a best bound are dropped, except those of the last pass, which
        // show where to refine
        kept.retain(|k| place.contains(&k.index) || k.index == index);
        let (Some(adapt), Some(remesher)) = (&context.adapt, &mut remesh) else { break };
        let Some(step) = step else {
            if index > 0 {
                log.line(format!(
                    "{name}: mesh {}: no strict bracket; the result uses the earlier meshes",
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
        let left = Budget {
            seconds: share.until - log.seconds(),
            bytes: room(limits.memory).map(|r| r.bytes),
        };
        let Some(last) = kept.iter().find(|k| k.index == index) else { break };
        let estimate = last
            .outcome
            .contributions()
            .map(|c| rates::estimate(&last.model, c, last.outcome.yield_multiplier_share()))
            .map(|e| match last.outcome.kinematic_field() {
                Some(u) => {
                    Estimate { directions: second_derivatives(&last.model.mesh, u), ..e }
                }
                None => e,
            });
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
            "{name}: mesh {}: {} tets, gap {}; forecast for the next mesh: {} tets, gap {}, in {}",
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
                // the certified bounds remain valid without the next mesh
                let why = faults.into_first().message;
                log.line(format!("{name}: no further mesh: {why}"));
                if let Some(e) = entries.last_mut().filter(|_| !limits.interrupt.asked()) {
                    e.entry.warnings.push(format!("there was no finer mesh: {why}"));
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

fn joined(name: &str, entries: &[PassResult]) -> Result<CaseResult, Diagnostics> {
    let Some(b) = best(entries) else { return Err(lost(name).into()) };
    let upper = entries[b.upper].clone();
    if b.upper == b.lower {
        return Ok(upper.entry);
    }
    combine::join(upper, entries[b.lower].clone()).map_err(|e| {
        Diagnostic::undecided("bounds/contradiction", e.to_string())
            .help("the numbers are withheld; try `--solver clarabel`, and report the case")
            .into()
    })
}

fn finish(
    name: &str,
    entries: Vec<PassResult>,
    mut kept: Vec<Kept>,
    stop: Option<Stop>,
    context: &RunContext,
    limits: &Limits,
) -> Result<Adapted, Diagnostics> {
    let mut entry = joined(name, &entries)?;
    entry.history = entries.iter().flat_map(|e| e.entry.history.iter().cloned()).collect();
    if let Some(last) = entries.last() {
        let new: Vec<String> =
            last.entry.warnings.iter().filter(|w| !entry.warnings.contains(w)).cloned().collect();
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
    // both passes have been kept since they became the best
    let Some(upper) = upper else {
        return Err(lost(name).into());
    };
    Ok(Adapted { entry, upper, lower })
}

/// The reason why the target gap was missed, with the remedy.
fn shortfall(stop: Option<Stop>, passes: usize, context: &RunContext, limits: &Limits) -> String {
    let max_passes = context.adapt.map_or(1, |a| a.max_passes);
    match stop {
        _ if limits.interrupt.asked() => "the run was interrupted".into(),
        Some(Stop::Passes) | None if max_passes == 1 => {
            format!("a finer mesh is needed ({})", context.finer)
        }
        Some(Stop::Passes) => format!("{passes} meshes were allowed (`max_passes`)"),
        Some(Stop::Tets) => "no mesh within `max_macro_tets` would reduce it much".into(),
        Some(Stop::Time) => "the remaining `time_limit` allows no further mesh".into(),
        Some(Stop::Memory) => "no finer mesh fits into the memory".into(),
        Some(Stop::Nothing) => {
            "no element contributes to the gap, so no finer mesh reduces it".into()
        }
        Some(Stop::Target) | None => format!("a finer mesh is needed ({})", context.finer),
    }
}
