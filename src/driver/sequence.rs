//! The meshes of a case after the first, each made where the last pass shows the largest error.

use crate::driver::passes::{CONTRADICTION, Mesh, Passes};
use crate::driver::remesh::{Made, Remesh};
use bracket_base::diag::Diagnostics;
use bracket_base::say;
use bracket_codes::route::NextMesh;
use bracket_engine::analysis::memory::room;
use bracket_engine::analysis::program::Program;
use bracket_engine::model::AnalysisModel;
use bracket_engine::model::file::Bounds;
use bracket_engine::refine::optimum::Design;
use bracket_engine::refine::plan::{self, Budget, Next, Prediction, Step, Stop};
use bracket_engine::refine::rates;
use bracket_engine::refine::track::{self, Track};
use bracket_report::console::pace::about;
use bracket_report::figures::{Rounding, fixed, percent_up};
use bracket_report::result::history::HistoryRow;
use bracket_report::result::result_file::{FrictionModel, Upper};

/// Meshes made one after the other by one remesher.
pub struct Sequence<'a> {
    track: Track,
    remesher: Box<dyn Remesh<'a> + 'a>,
    /// Index of its last pass.
    last: usize,
    /// No further mesh could be made, or the last one gave no bound.
    failed: bool,
    /// Its last mesh was made for a larger one to follow.
    goes_on: bool,
}

impl<'a> Sequence<'a> {
    /// A sequence that starts from the first mesh.
    pub fn new(bounds: Bounds, remesher: Box<dyn Remesh<'a> + 'a>) -> Self {
        Self { track: Track::new(bounds), remesher, last: 0, failed: false, goes_on: false }
    }

    /// Its share of the gap of the bracket.
    fn gap(&self) -> f64 {
        self.track.steps.last().map_or(0.0, |s| s.gap)
    }
}

/// Part of the remaining time for the first of the tracks `waiting`. The others of them, and those
/// that had their turn and are to make a larger mesh, need the rest. Each has a time in proportion
/// to its error, which makes the sum of the errors least: an error falls with a power of the time.
fn part(tracks: &[Sequence], waiting: &[usize]) -> f64 {
    let [first, ..] = waiting else { return 0.0 };
    let goes_on = |i: &usize| waiting.contains(i) || tracks[*i].goes_on;
    let going: Vec<usize> =
        (0..tracks.len()).filter(|i| !tracks[*i].failed && goes_on(i)).collect();
    let share = tracks[*first].gap() / going.iter().map(|i| tracks[*i].gap()).sum::<f64>();
    if share.is_finite() { share } else { 1.0 / going.len() as f64 }
}

impl Passes<'_> {
    /// Makes and analyses meshes until the target or a limit is reached. Returns the reason for
    /// which no track made a further mesh.
    pub fn adapt(
        &mut self,
        tracks: &mut [Sequence],
        adapt: &plan::Limits,
    ) -> Result<Option<Stop>, Diagnostics> {
        for sequence in tracks.iter_mut() {
            if !self.count(sequence, None) {
                return Ok(None);
            }
        }
        // whether a mesh may take all of the remaining time: no track found one within its part
        let mut whole = false;
        loop {
            let mut stop = None;
            let mut refined = false;
            // whether a track would make a mesh with more time
            let mut timed = false;
            // the tracks that shared the time of this round
            let shared = tracks.iter().filter(|t| !t.failed).count();
            let mut order: Vec<usize> = (0..tracks.len()).collect();
            if whole {
                order.sort_by(|a, b| tracks[*b].gap().total_cmp(&tracks[*a].gap()));
            }
            for (turn, &i) in order.iter().enumerate() {
                if self.limits.interrupt.asked() {
                    return Ok(None);
                }
                // the other track may go on
                if tracks[i].failed {
                    continue;
                }
                let best = self.divide(tracks)?;
                let part = if whole { 1.0 } else { part(tracks, &order[turn..]) };
                match self.refine(&mut tracks[i], adapt, best, part)? {
                    Refined::Mesh => refined = true,
                    // of both reasons the one that another mesh could remove
                    Refined::Stop(why) => {
                        timed |= why == Stop::Time;
                        stop = stop.filter(|s| *s != Stop::Target).or(Some(why));
                    }
                    Refined::Failed => tracks[i].failed = true,
                }
                let last: Vec<usize> = tracks.iter().map(|t| t.last).collect();
                self.drop_unused(&last);
            }
            if !refined && (whole || shared < 2 || !timed) {
                return Ok(stop);
            }
            whole = !refined;
        }
    }

    /// Analyses a further mesh. False if its bounds contradict those of the earlier meshes: they
    /// are left out, with a warning, and what was certified before remains.
    fn run_beside(&mut self, mesh: Mesh) -> Result<bool, Diagnostics> {
        let passes = self.entries.len();
        let Err(faults) = self.run(mesh).map(|_| ()) else { return Ok(true) };
        if faults.first().code != CONTRADICTION {
            return Err(faults);
        }
        self.entries.truncate(passes);
        self.kept.retain(|k| k.index < passes);
        let why = faults.into_first().message;
        self.log.line(format!("{}: mesh {} is left out: {why}", self.name, passes + 1));
        if let Some(last) = self.entries.last_mut() {
            last.entry.warnings.push(say!(
                "mesh {} is left out: its bounds contradict those of the earlier meshes: {}",
                passes + 1,
                &why
            ));
        }
        Ok(false)
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
        // the first mesh of two tracks is shared: each counts its own programs
        let seconds = row.map_or(0.0, |row| {
            let own = match bounds {
                Bounds::Both => return row.seconds.unwrap_or(0.0),
                // later meshes compute the bound that answers
                Bounds::Static if pass.entry.problem == FrictionModel::Coulomb => {
                    row.static_frictionless.as_ref()
                }
                Bounds::Static => row.static_.as_ref(),
                Bounds::Kinematic => row.kinematic.as_ref(),
            };
            row.mesh_seconds.unwrap_or(0.0) + own.map_or(0.0, |r| alone(row) * r.seconds)
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
        let best = self.joined()?;
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
        let asked = self.for_verdict()?;
        if let Some(NextMesh::None | NextMesh::Hopeless) = asked {
            return Ok(Refined::Stop(Stop::Decided));
        }
        // the gap of a bound's own track may exceed the target when that of the bracket does not;
        // two meshes for a verdict are made whatever the gap
        if best_gap <= adapt.target_gap && !self.share.decide {
            return Ok(Refined::Stop(Stop::Target));
        }
        let Sequence { track, remesher, last, goes_on, .. } = sequence;
        let (name, log) = (self.name.clone(), self.log);
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
        let realised = |wanted: &[f64]| remesher.realised(wanted, &estimate.directions);
        let own_gap = if track.bounds == Bounds::Both { best_gap } else { present.gap };
        let coarser = asked == Some(NextMesh::Coarser) && track.bounds == Bounds::Both;
        let (choice, curve) = if self.share.decide && track.bounds == Bounds::Both {
            let next = for_estimates(&present, coarser, &budget, adapt, self.entries.len());
            // a coarser mesh is even: no curve chooses its elements
            let finer = || estimate.curve(FINER * present.tets as f64, &realised);
            (next, (!coarser).then(finer))
        } else {
            plan::next(&track.steps, own_gap, adapt, &budget, remesher.loss(), &mut |most| {
                estimate.curve(most, &realised)
            })
        };
        *goes_on = matches!(choice, Next::Refine(p) if p.first_of_two);
        let p = match choice {
            Next::Refine(p) => p,
            Next::Stop(why) => return Ok(Refined::Stop(why)),
        };
        let order = plan::order(&track.steps, p.tets);
        let design = match curve {
            // as the present one in all places, so that only the size of its elements differs
            _ if coarser => Design {
                wanted: vec![COARSER; present.tets],
                directions: estimate.directions.clone(),
                tets: order,
                gap: 1.0,
            },
            Some(curve) => estimate.with_tets(&curve, order, &realised),
            None => return Ok(Refined::Failed),
        };
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
            gap_words(best_gap),
            whose(track.bounds),
            fixed(p.tets, 0, Rounding::Nearest),
            gap_words(of_bracket),
            about(p.seconds)
        ));
        let p = Prediction { tets: design.tets * p.tets / order, ..p };
        // strains are those of the displacement
        let bounds = if coarser { Bounds::Kinematic } else { track.bounds };
        let mesh = match remesher.remesh(&design, self.share.until - log.seconds(), log) {
            Ok(Made { model, mesh, file, quality, seconds }) => Mesh {
                model: AnalysisModel { bounds, ..model },
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
                    e.entry.warnings.push(say!("there was no finer mesh: {}", &why));
                }
                return Ok(Refined::Failed);
            }
        };
        let before = self.kept.iter().find(|k| k.index == *last);
        if before.is_some_and(|k| k.model.mesh == mesh.model.mesh) {
            return Ok(Refined::Stop(Stop::SameMesh));
        }
        if !self.run_beside(mesh)? {
            return Ok(Refined::Failed);
        }
        if coarser {
            return Ok(Refined::Mesh);
        }
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

/// Tets of the next mesh over those of the present one, where a verdict asks for two meshes whose
/// estimates agree, and not for a narrow bracket.
const FINER: f64 = 1.3;
/// The same for a coarser mesh to compare with.
const COARSER: f64 = 0.5;
/// Time of the kinematic program alone on it, over that of both programs on the present mesh.
const COARSER_SECONDS: f64 = 0.3;
/// Exponent of the time of a pass in its number of tets, the largest that was found.
const TIME_EXPONENT: f64 = 2.0;

/// The next mesh for estimates, a coarser or a finer one.
fn for_estimates(
    present: &Step,
    coarser: bool,
    budget: &Budget,
    adapt: &plan::Limits,
    passes: usize,
) -> Next {
    let [growth, time] = match coarser {
        true => [COARSER, COARSER_SECONDS],
        false => [FINER, FINER.powf(TIME_EXPONENT)],
    };
    let (tets, seconds) = (growth * present.tets as f64, time * present.seconds);
    let gap = present.gap;
    match () {
        _ if passes >= adapt.max_passes as usize => Next::Stop(Stop::Passes),
        _ if tets > adapt.max_macro_tets as f64 => Next::Stop(Stop::Tets),
        _ if seconds > budget.seconds => Next::Stop(Stop::Time),
        () => Next::Refine(Prediction { tets, gap, ideal_gap: gap, seconds, first_of_two: false }),
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

/// Time that a program of a pass takes alone, over its time in the pass: programs that run side by
/// side slow each other down.
fn alone(row: &HistoryRow) -> f64 {
    let runs = [&row.kinematic, &row.static_, &row.static_frictionless];
    let sum: f64 = runs.into_iter().flatten().map(|r| r.seconds).sum();
    let wall = row.seconds.filter(|_| sum > 0.0);
    wall.map_or(1.0, |s| ((s - row.mesh_seconds.unwrap_or(0.0)) / sum).clamp(0.5, 1.0))
}

/// The bound that a mesh is made for, as text.
fn whose(bounds: Bounds) -> &'static str {
    match bounds {
        Bounds::Both => "",
        Bounds::Static => " of the lower bound",
        Bounds::Kinematic => " of the upper bound",
    }
}

/// A gap for the log. It is open while a bound is missing or the lower bound is zero.
fn gap_words(gap: f64) -> String {
    if gap.is_finite() { percent_up(gap) } else { "open".into() }
}

#[cfg(test)]
mod tests;
