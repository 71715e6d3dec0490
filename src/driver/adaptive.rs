//! Adaptive passes: successively better meshes until the target gap or a limit is reached. The
//! result consists of the best bounds of all passes.

use crate::diag::Diagnostics;
use crate::driver::case::Case;
use crate::driver::context::RunContext;
use crate::driver::limits::Limits;
use crate::driver::pass_run::too_large;
use crate::driver::passes::{Kept, Mesh, Passes, Share, joined, lost};
use crate::driver::sequence::Sequence;
use crate::model::file::Bounds;
use crate::refine::plan::Stop;
use crate::report::console::log::Log;
use crate::report::figures::percent_up;
use crate::result::combine::{PassResult, best};
use crate::result::result_file::{CaseResult, HistoryRow};
use crate::spec::analysis::AnalysisKind;
use std::sync::Arc;

/// The result of all passes of a case.
pub struct Adapted {
    /// The entry of the result, with one row of history per pass.
    pub entry: CaseResult,
    /// The pass with the best upper bound.
    pub upper: Kept,
    /// The pass with the best lower bound, if it is a different pass.
    pub lower: Option<Kept>,
    /// The pass with the best lower bound without friction, if it is neither of them.
    frictionless: Option<Kept>,
    /// Index of the pass with that bound.
    frictionless_index: usize,
}

impl Adapted {
    /// True if a lower bound is on the first mesh and the upper bound on another one.
    pub fn keeps_first_mesh(&self) -> bool {
        let beside = [self.lower.as_ref(), self.frictionless()];
        self.upper.made.is_some() && beside.into_iter().flatten().any(|k| k.made.is_none())
    }

    /// The pass with the best lower bound without friction, if it is not the one with the best
    /// lower bound.
    pub fn frictionless(&self) -> Option<&Kept> {
        let at = self.frictionless_index;
        if self.lower.as_ref().unwrap_or(&self.upper).index == at {
            return None;
        }
        [Some(&self.upper), self.frictionless.as_ref()]
            .into_iter()
            .flatten()
            .find(|k| k.index == at)
    }
}

/// Analyses a case on successive meshes. `first` means that no case was analysed before; a program
/// that does not fit into the memory then ends the run.
///
/// The first mesh serves both bounds. In limit analysis each bound then gets meshes of its own.
pub fn analyse(
    case: Case,
    first: bool,
    share: &Share,
    context: &RunContext,
    limits: &Limits,
    log: &Arc<Log>,
) -> Result<Adapted, Diagnostics> {
    let Case { name, model, remesh, mesh_seconds, .. } = case;
    let mut passes =
        Passes { name: &name, limits, log, share, entries: Vec::new(), kept: Vec::new() };
    let Some(found) =
        passes.run(Mesh { model, made: None, seconds: mesh_seconds, predicted: None })?
    else {
        return Err(lost(&name).into());
    };
    let (outcome, model) = (&found.outcome, &found.model);
    let runs = outcome.runs();
    // there are no programs if the answer was proved without them
    if first && !runs.is_empty() && runs.iter().all(|(_, run)| run.refusal.is_some()) {
        return Err(too_large(&name, outcome, context).into());
    }
    let mut stop = None;
    if let (Some(adapt), Some(remesher)) = (&context.adapt, remesh) {
        let both = model.bounds == Bounds::Both && outcome.contributions().is_some();
        let mut tracks = match model.analysis {
            AnalysisKind::Limit if both => vec![
                Sequence::new(Bounds::Static, remesher.twin()),
                Sequence::new(Bounds::Kinematic, remesher),
            ],
            _ if both => vec![Sequence::new(Bounds::Both, remesher)],
            _ => Vec::new(),
        };
        stop = passes.adapt(&mut tracks, adapt)?;
    }
    finish(&name, passes.entries, passes.kept, stop, context, limits)
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
    entry.history = entries.iter().flat_map(|e| rows(&e.entry, entry.is_strict())).collect();
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
            shortfall(stop, entry.analysis, context, limits)
        ));
    }
    let Some(b) = best(&entries) else { return Err(lost(name).into()) };
    // a pass is kept as soon as it is the best; a bound without its fields and mesh is not reported
    let mut take = |index: usize| {
        let place = kept.iter().position(|k| k.index == index);
        place.map(|i| kept.swap_remove(i)).ok_or_else(|| Diagnostics::from(lost(name)))
    };
    let upper = take(b.upper)?;
    let lower = if b.lower == b.upper { None } else { Some(take(b.lower)?) };
    let apart = ![b.lower, b.upper].contains(&b.frictionless);
    let frictionless = if apart { Some(take(b.frictionless)?) } else { None };
    Ok(Adapted { entry, upper, lower, frictionless, frictionless_index: b.frictionless })
}

/// The rows of a pass in the history of the answer. Beside strict bounds, the numbers of a mesh
/// without a certificate would read as bounds: they are left out.
fn rows(pass: &CaseResult, strict: bool) -> Vec<HistoryRow> {
    let mut rows = pass.history.clone();
    if strict && !pass.is_strict() {
        rows.iter_mut().for_each(|r| (r.lower, r.upper, r.gap) = (None, None, None));
    }
    rows
}

/// The reason why the target gap was missed, with the remedy.
fn shortfall(
    stop: Option<Stop>,
    kind: AnalysisKind,
    context: &RunContext,
    limits: &Limits,
) -> String {
    let max_passes = context.adapt.map_or(1, |a| a.max_passes);
    match stop {
        _ if limits.interrupt.asked() => "the run was interrupted".into(),
        Some(Stop::Passes) | None if max_passes == 1 => {
            format!("a finer mesh is needed ({})", context.finer)
        }
        Some(Stop::Passes) => {
            let each = if kind == AnalysisKind::Limit { " for each bound" } else { "" };
            format!("{max_passes} meshes were allowed{each} (`max_passes`)")
        }
        Some(Stop::Tets) => "no mesh within `max_macro_tets` would reduce it much".into(),
        Some(Stop::Time) => "the remaining `time_limit` allows no further mesh".into(),
        Some(Stop::Memory) => "no finer mesh fits into the memory".into(),
        Some(Stop::Nothing) => {
            "no element contributes to the gap, so no finer mesh reduces it".into()
        }
        Some(Stop::SameMesh) => "the remesher makes no finer mesh".into(),
        Some(Stop::Target) | None => format!("a finer mesh is needed ({})", context.finer),
    }
}
