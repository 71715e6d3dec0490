//! Adaptive passes: successively better meshes until the target gap or a limit is reached. The
//! result consists of the best bounds of all passes.

use crate::analysis::dispatch::AnalysisPass;
use crate::analysis::memory::room;
use crate::analysis::program::Program;
use crate::diag::{Diagnostic, Diagnostics};
use crate::driver::case::Case;
use crate::driver::context::RunContext;
use crate::driver::limits::Limits;
use crate::driver::pass_entry::{pass_bounds, pass_entry};
use crate::driver::pass_run::{run_pass, too_large};
use crate::driver::remesh::{Made, Remesh};
use crate::mesh::TetMesh;
use crate::model::AnalysisModel;
use crate::model::file::{Bounds, ModelFile};
use crate::refine::plan::{self, Budget, Next, Prediction, Step, Stop};
use crate::refine::rates;
use crate::refine::track::{self, Track};
use crate::report::console::log::Log;
use crate::report::console::pace::about;
use crate::report::figures::{Rounding, fixed, percent_up};
use crate::report::markdown::report_data::Table;
use crate::result::combine::{self, PassResult, best};
use crate::result::result_file::{CaseResult, Predicted, ProgramRun, SoFar, Upper};
use crate::solve::Patterns;
use crate::spec::analysis::AnalysisKind;
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

/// A mesh to be analysed.
struct Mesh {
    model: AnalysisModel,
    /// Mesh, model file and quality; `None` for the first mesh.
    made: Option<(TetMesh, ModelFile, Table)>,
    /// Wall time of meshing \[s\].
    seconds: Option<f64>,
    predicted: Option<Prediction>,
}

/// Meshes made one after the other by one remesher.
struct Sequence<'a> {
    track: Track,
    remesher: Box<dyn Remesh<'a> + 'a>,
    /// Index of its last pass.
    last: usize,
}

impl<'a> Sequence<'a> {
    fn new(bounds: Bounds, remesher: Box<dyn Remesh<'a> + 'a>) -> Self {
        Self { track: Track::new(bounds), remesher, last: 0 }
    }
}

/// The passes of a case.
struct Passes<'a> {
    name: &'a str,
    limits: &'a Limits,
    log: &'a Arc<Log>,
    share: &'a Share<'a>,
    entries: Vec<PassResult>,
    kept: Vec<Kept>,
}

impl Passes<'_> {
    /// Runs the programs on a mesh and keeps entry and fields.
    fn run(&mut self, mesh: Mesh) -> Result<Option<&Kept>, Diagnostics> {
        let Mesh { model, made, seconds: mesh_seconds, predicted } = mesh;
        let index = self.entries.len();
        let start = Instant::now();
        let until = if index == 0 { f64::INFINITY } else { self.share.until };
        // later meshes are used by this case only
        let own = Patterns::default();
        let patterns = if index == 0 { self.share.patterns } else { &own };
        let outcome = run_pass(self.name, &model, until, patterns, self.limits, self.log)?;
        let mut entry = pass_entry(&outcome, self.name, &model, mesh_seconds);
        if let Some(row) = entry.history.last_mut() {
            row.seconds = Some(mesh_seconds.unwrap_or(0.0) + start.elapsed().as_secs_f64());
            row.predicted = predicted.map(|p| Predicted {
                macro_tets: p.tets.round() as usize,
                gap: p.gap,
                seconds: p.seconds,
            });
        }
        let bounds = pass_bounds(&outcome, &entry);
        self.entries.push(PassResult { entry, bounds });
        self.kept.push(Kept { outcome, model, made, index });
        let best = joined(self.name, &self.entries)?;
        if let Some(row) = self.entries[index].entry.history.last_mut() {
            row.so_far = Some(SoFar {
                lower: best.lower,
                upper: best.upper,
                gap: best.gap,
                strict: best.is_strict(),
            });
        }
        Ok(self.kept.last())
    }

    /// Makes and analyses meshes until the target or a limit is reached. Returns the reason for
    /// which no track made a further mesh.
    fn adapt(
        &mut self,
        tracks: &mut [Sequence],
        adapt: &plan::Limits,
    ) -> Result<Option<Stop>, Diagnostics> {
        for sequence in tracks.iter_mut() {
            if !self.count(sequence, None) {
                return Ok(None);
            }
        }
        loop {
            let mut stop = None;
            let mut refined = false;
            for i in 0..tracks.len() {
                if self.limits.interrupt.asked() {
                    return Ok(None);
                }
                let best = self.divide(tracks)?;
                // the tracks that follow in this round need their part of the time
                let part = 1.0 / (tracks.len() - i) as f64;
                match self.refine(&mut tracks[i], adapt, best, part)? {
                    Refined::Mesh => refined = true,
                    // of both reasons the one that another mesh could remove
                    Refined::Stop(why) => {
                        stop = stop.filter(|s| *s != Stop::Target).or(Some(why));
                    }
                    Refined::Failed => return Ok(None),
                }
                let last: Vec<usize> = tracks.iter().map(|t| t.last).collect();
                let place = best_places(&self.entries);
                self.kept.retain(|k| place.contains(&k.index) || last.contains(&k.index));
            }
            if !refined {
                return Ok(stop);
            }
        }
    }

    /// Counts the last pass in a track; false if it gave no strict bound.
    fn count(&self, sequence: &mut Sequence, predicted: Option<Prediction>) -> bool {
        let index = self.entries.len() - 1;
        let (Some(pass), Some(kept)) = (self.entries.last(), self.kept.last()) else {
            return false;
        };
        let bounds = sequence.track.bounds;
        let value = match bounds {
            Bounds::Static => pass.bounds.lower(),
            _ => pass.bounds.upper().and_then(Upper::finite),
        };
        let row = pass.entry.history.last();
        let programs = |runs: [Option<&ProgramRun>; 2]| {
            runs.into_iter().flatten().map(|r| r.seconds).sum::<f64>()
        };
        // the first mesh of two tracks is shared: each counts its own programs
        let seconds = row.map_or(0.0, |row| {
            let own = match bounds {
                Bounds::Both => return row.seconds.unwrap_or(0.0),
                Bounds::Static => [row.static_.as_ref(), row.static_frictionless.as_ref()],
                Bounds::Kinematic => [row.kinematic.as_ref(), None],
            };
            row.mesh_seconds.unwrap_or(0.0) + programs(own)
        });
        let counts = |program: Program| match bounds {
            Bounds::Both => true,
            Bounds::Static => program == Program::Static,
            Bounds::Kinematic => program == Program::Kinematic,
        };
        let forecasts = kept.outcome.runs().into_iter().filter(|(p, _)| counts(*p));
        let bytes = forecasts.filter_map(|(_, r)| r.forecast).map(|f| f.bytes).max().unwrap_or(0);
        sequence.last = index;
        let (Some(value), true) = (value, pass.entry.is_strict()) else { return false };
        let gap = pass.entry.gap.unwrap_or(f64::INFINITY);
        if bounds == Bounds::Both && gap.is_infinite() {
            return false;
        }
        let tets = kept.model.mesh.tets.len();
        sequence.track.push(Step { tets, gap, seconds, bytes, predicted }, value);
        true
    }

    /// The gap of the best bracket; where each bound has a track, divides it between them.
    fn divide(&self, tracks: &mut [Sequence]) -> Result<f64, Diagnostics> {
        let best = joined(self.name, &self.entries)?;
        let gap = best.gap.unwrap_or(f64::INFINITY);
        if let ([a, b], Some(lower), Some(upper)) =
            (tracks, best.lower, best.upper.and_then(Upper::finite))
        {
            track::divide([&mut a.track, &mut b.track], upper - lower, lower);
        }
        Ok(gap)
    }

    /// Makes and analyses the next mesh of a track, if one is worth it. `best_gap`: gap of the
    /// best bracket; `part`: part of the remaining time that this mesh may take.
    fn refine(
        &mut self,
        sequence: &mut Sequence,
        adapt: &plan::Limits,
        best_gap: f64,
        part: f64,
    ) -> Result<Refined, Diagnostics> {
        let Sequence { track, remesher, last } = sequence;
        let (name, log) = (self.name, self.log);
        let budget = Budget {
            seconds: part * (self.share.until - log.seconds()),
            bytes: room(self.limits.memory).map(|r| r.bytes),
        };
        let estimate = self
            .kept
            .iter()
            .find(|k| k.index == *last)
            .and_then(|k| rates::for_bounds(track.bounds, &k.model, &k.outcome));
        let (Some(estimate), Some(present)) = (estimate, track.steps.last().copied()) else {
            return Ok(Refined::Failed);
        };
        let realised = |wanted: &[f64]| remesher.realised(wanted);
        let own_gap = if track.bounds == Bounds::Both { best_gap } else { present.gap };
        let (choice, curve) = plan::next(&track.steps, own_gap, adapt, &budget, &mut |most| {
            estimate.curve(most, &realised)
        });
        let p = match (choice, &curve) {
            (Next::Refine(p), Some(_)) => p,
            (Next::Stop(why), _) => return Ok(Refined::Stop(why)),
            _ => return Ok(Refined::Failed),
        };
        let Some(curve) = curve else { return Ok(Refined::Failed) };
        // a mesh for one bound changes half of the sum of both gaps
        let of_bracket = match track.bounds {
            Bounds::Both => p.gap,
            _ => best_gap - 0.5 * (present.gap - p.gap),
        };
        log.line(format!(
            "{name}: mesh {}: {} tets, gap {}; forecast for the next mesh{}: {} tets, gap {}, in \
             {}",
            *last + 1,
            fixed(present.tets as f64, 0, Rounding::Nearest),
            percent_up(best_gap),
            whose(track.bounds),
            fixed(p.tets, 0, Rounding::Nearest),
            percent_up(of_bracket),
            about(p.seconds)
        ));
        let order = plan::order(&track.steps, p.tets);
        let design = estimate.with_tets(&curve, order, &realised);
        let p = Prediction { tets: design.tets * p.tets / order, ..p };
        let mesh = match remesher.remesh(&design, self.share.until - log.seconds(), log) {
            Ok(Made { model, mesh, file, quality, seconds }) => Mesh {
                model: AnalysisModel { bounds: track.bounds, ..model },
                made: Some((mesh, file, quality)),
                seconds: Some(seconds),
                predicted: Some(Prediction { gap: of_bracket, ..p }),
            },
            Err(faults) => {
                // the certified bounds remain valid without the next mesh
                let why = faults.into_first().message;
                log.line(format!("{name}: no further mesh: {why}"));
                if let Some(e) = self.entries.last_mut().filter(|_| !self.limits.interrupt.asked())
                {
                    e.entry.warnings.push(format!("there was no finer mesh: {why}"));
                }
                return Ok(Refined::Failed);
            }
        };
        self.run(mesh)?;
        if self.count(sequence, Some(p)) {
            return Ok(Refined::Mesh);
        }
        log.line(format!(
            "{name}: mesh {}: no strict bound; the result uses the earlier meshes",
            self.entries.len()
        ));
        Ok(Refined::Failed)
    }
}

/// What became of the next mesh of a track.
enum Refined {
    /// It was made and gave a bound.
    Mesh,
    /// It was not made, for this reason.
    Stop(Stop),
    /// It could not be made, or gave no bound.
    Failed,
}

/// The bound that a mesh is made for, as text.
fn whose(bounds: Bounds) -> &'static str {
    match bounds {
        Bounds::Both => "",
        Bounds::Static => " of the lower bound",
        Bounds::Kinematic => " of the upper bound",
    }
}

/// Indices of the passes with the best bounds.
fn best_places(entries: &[PassResult]) -> [usize; 2] {
    best(entries).map_or([entries.len() - 1; 2], |b| [b.lower, b.upper])
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
