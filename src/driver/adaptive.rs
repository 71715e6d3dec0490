//! Adaptive passes: successively better meshes until the target gap or a limit is reached. The
//! result consists of the best bounds of all passes.

use crate::driver::case::Case;
use crate::driver::limits::Limits;
use crate::driver::pass_run::too_large;
use crate::driver::passes::{Kept, Mesh, Passes, Share, evidence, joined, lost};
use crate::driver::remesh::Remesh;
use crate::driver::sequence::Sequence;
use crate::driver::setup::Refinement;
use bracket_base::diag::Diagnostics;
use bracket_base::say;
use bracket_base::words::Text;
use bracket_engine::model::AnalysisKind;
use bracket_engine::model::AnalysisModel;
use bracket_engine::model::file::Bounds;
use bracket_engine::refine::plan::Stop;
use bracket_report::console::log::Log;
use bracket_report::figures::percent_up;
use bracket_report::result::combine::{PassResult, best};
use bracket_report::result::result_file::{CaseResult, HistoryRow};
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

/// A case that is analysed on its first mesh.
pub struct Begun<'a, 'r> {
    passes: Passes<'a>,
    remesh: Option<Box<dyn Remesh<'r> + 'r>>,
}

impl<'a, 'r> Begun<'a, 'r> {
    /// Analyses a case on its first mesh. `first` means that no case was analysed before; a program
    /// that does not fit into the memory then ends the run, with the advice `coarser`.
    pub fn new(
        case: Case<'r>,
        first: bool,
        share: Share<'a>,
        coarser: &str,
        limits: &'a Limits,
        log: &'a Arc<Log>,
    ) -> Result<Self, Diagnostics> {
        let Case { name, model, remesh, mesh_seconds, .. } = case;
        let mut passes = Passes::new(name, share, limits, log);
        let found =
            passes.run(Mesh { model, made: None, seconds: mesh_seconds, predicted: None })?;
        let refused = found.is_some_and(|kept| {
            let runs = kept.outcome.runs();
            // there are no programs if the answer was proved without them
            !runs.is_empty() && runs.iter().all(|(_, run)| run.refusal.is_some())
        });
        match passes.kept.last() {
            None => Err(lost(&passes.name).into()),
            Some(kept) if first && refused => {
                Err(too_large(&passes.name, &kept.outcome, coarser).into())
            }
            Some(_) => Ok(Self { passes, remesh }),
        }
    }

    /// The model on the first mesh; `None` once its fields were dropped.
    pub fn model(&self) -> Option<&AnalysisModel> {
        self.passes.kept.first().map(|k| &k.model)
    }

    /// True if the lower bound was computed alone and the upper one is still to come.
    pub fn wants_upper(&self) -> bool {
        self.passes.kept.first().is_some_and(|k| k.outcome.wants_upper(&k.model))
    }

    /// Adds the upper bound on the first mesh where it is still to come.
    pub fn add_upper(&mut self) -> Result<(), Diagnostics> {
        self.passes.add_upper()
    }

    /// Analyses the case on successive meshes until the target gap or a limit is reached; `until`:
    /// see [`Share`].
    ///
    /// The first mesh serves both bounds. In limit analysis each bound then gets meshes of its own.
    pub fn end(
        self,
        until: f64,
        refinement: &Refinement,
        limits: &Limits,
    ) -> Result<Adapted, Diagnostics> {
        let Self { mut passes, remesh } = self;
        passes.share.until = until;
        let mut stop = None;
        if let (Some(adapt), Some(remesher), Some(kept)) =
            (&refinement.adapt, remesh, passes.kept.first())
        {
            let Kept { outcome, model, .. } = kept;
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
        let Passes { name, entries, kept, .. } = passes;
        finish(&name, entries, kept, stop, refinement, limits)
    }
}

fn finish(
    name: &str,
    entries: Vec<PassResult>,
    mut kept: Vec<Kept>,
    stop: Option<Stop>,
    refinement: &Refinement,
    limits: &Limits,
) -> Result<Adapted, Diagnostics> {
    let mut entry = joined(name, &entries)?;
    entry.history = entries.iter().flat_map(|e| rows(&e.entry, entry.is_strict())).collect();
    let mut measured = evidence(&entries);
    entry.evidence = measured.pop();
    entry.evidence_before = measured;
    if let Some(last) = entries.last() {
        let new: Vec<Text> =
            last.entry.warnings.iter().filter(|w| !entry.warnings.contains(w)).cloned().collect();
        entry.warnings.extend(new.into_iter().map(|w| say!("mesh {}: {}", entries.len(), w)));
    }
    if let (Some(gap), Some(adapt)) = (entry.gap, &refinement.adapt)
        && gap > adapt.target_gap
    {
        entry.warnings.push(say!(
            "the gap is {}, the target {}: {}",
            percent_up(gap),
            percent_up(adapt.target_gap),
            shortfall(stop, entry.analysis, refinement, limits)
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
    refinement: &Refinement,
    limits: &Limits,
) -> Text {
    let max_passes = refinement.adapt.map_or(1, |a| a.max_passes);
    match stop {
        _ if limits.interrupt.asked() => "the run was interrupted".into(),
        Some(Stop::Passes) | None if max_passes == 1 => {
            say!("a finer mesh is needed ({})", refinement.finer)
        }
        Some(Stop::Passes) => {
            let each = if kind == AnalysisKind::Limit { " for each bound" } else { "" };
            say!("{} meshes were allowed{} (`max_passes`)", max_passes, each)
        }
        Some(Stop::Tets) => "no mesh within `max_macro_tets` would reduce it much".into(),
        Some(Stop::Time) => "the remaining `time_limit` allows no further mesh".into(),
        Some(Stop::Memory) => "no finer mesh fits into the memory".into(),
        Some(Stop::Nothing) => {
            "no element contributes to the gap, so no finer mesh reduces it".into()
        }
        Some(Stop::Decided) => "the meshes decide the load, and `decide` asks for no more".into(),
        Some(Stop::SameMesh) => "the remesher makes no finer mesh".into(),
        Some(Stop::Target) | None => say!("a finer mesh is needed ({})", refinement.finer),
    }
}
