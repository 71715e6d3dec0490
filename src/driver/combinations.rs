//! Limit analysis of many load cases of a joint: as few analyses as bound all of them.
//!
//! The load cases of one model are points in the space of actions. The set that is carried is
//! convex and contains zero, so that an analysis proves more than its own load case
//! (docs/theory.md, section 11). [`plan`] chooses what is analysed next, until every load case is
//! decided or has an analysis of its own.

mod cover;
mod plan;

use crate::driver::adaptive::{Adapted, Begun};
use crate::driver::case::{Case, refuse_idle};
use crate::driver::limits::Limits;
use crate::driver::passes::Share;
use crate::driver::polygon::mechanism;
use crate::driver::setup::RunSetup;
use crate::driver::solve::{complete, note_traits, without_bounds};
use crate::driver::solved::{Models, RunSink, Solved, SolvedCase};
use bracket_base::diag::Diagnostics;
use bracket_codes::verdict::Verdict;
use bracket_engine::certify::half_space::{Actions, HalfSpace, live_actions};
use bracket_engine::model::AnalysisKind;
use bracket_engine::model::file::ModelFile;
use bracket_engine::solve::{Patterns, StopRules};
use bracket_report::console::log::Log;
use bracket_report::markdown::report_data::ModelTraits;
use bracket_report::result::case_result::CaseResult;
use bracket_report::result::derived_bounds::Run;
use bracket_report::result::file_names::{file_stem, stem_of};
use bracket_report::result::proved_by::Direction;
use bracket_report::result::result_file::ResultFile;
use cover::Cover;
pub use cover::{actions_of, groups, with_actions};
use plan::Next;
use std::collections::VecDeque;
use std::sync::Arc;

/// Analyses that a group of load cases is expected to need, for its share of the time.
const EXPECTED: usize = 5;

/// A load case that is to be bounded.
pub struct Wanted {
    /// Its name.
    pub name: String,
    /// Its model on the first mesh.
    pub file: ModelFile,
    /// Utilisation by the code's checks; the order in which cases are analysed.
    pub by_code: f64,
}

/// Makes the case of a model file that is analysed under a name; `first`: no case was before.
pub type Maker<'m, 'r> = &'m dyn Fn(&str, ModelFile, bool) -> Result<Case<'r>, Diagnostics>;

/// Bounds all load cases by as few analyses as suffice, and hands each analysis to `sink`.
pub fn solve_combinations<'r>(
    wanted: &[Wanted],
    maker: Maker<'_, 'r>,
    setup: &RunSetup,
    (limits, log): (&Limits, &Arc<Log>),
    sink: &mut dyn RunSink,
) -> Result<Solved, Diagnostics> {
    let files: Vec<ModelFile> = wanted.iter().map(|w| w.file.clone()).collect();
    let groups = groups(&files);
    let mut runner = Runner {
        maker,
        setup,
        limits,
        log,
        sink,
        patterns: Patterns::default(),
        models: Models::default(),
        runs: 0,
        symmetry: 1,
        open: groups.iter().map(|g| g.len().min(EXPECTED)).sum(),
    };
    let mut entries: Vec<Option<CaseResult>> = vec![None; wanted.len()];
    let (mut directions, mut of_directions) = (Vec::new(), Vec::new());
    for group in &groups {
        let found = runner.group(wanted, group, directions.len())?;
        runner.open = runner.open.saturating_sub(group.len().min(EXPECTED));
        for (&i, entry) in group.iter().zip(found.entries) {
            entries[i] = Some(entry);
        }
        directions.extend(found.directions);
        of_directions.extend(found.of_directions);
    }
    let Runner { models, symmetry, runs, .. } = runner;
    let mut result = ResultFile::new(setup.input_hash.clone(), symmetry, Verdict::None);
    result.warnings.clone_from(&setup.warnings);
    result.asked = wanted.iter().map(|w| w.name.clone()).collect();
    result.cases = entries.into_iter().flatten().chain(of_directions).collect();
    result.directions = directions;
    result.warnings.extend(without_bounds(&result.cases));
    let decided = |c: &&CaseResult| c.by_bounds() != Verdict::Undecided;
    let count = result.cases.iter().take(wanted.len()).filter(decided).count();
    log.line(format!("{runs} limit analyses decide {count} of {} load cases", wanted.len()));
    Ok(Solved { result, models })
}

/// What is known of a group of load cases.
struct Found {
    /// An entry for each of them, in their order.
    entries: Vec<CaseResult>,
    /// The directions that were analysed, and their entries.
    directions: Vec<Direction>,
    of_directions: Vec<CaseResult>,
}

/// The name of a direction, which no load case has.
fn direction_name(wanted: &[Wanted], number: usize) -> String {
    let mut name = format!("direction_{number}");
    while wanted.iter().any(|w| file_stem(&w.name) == name) {
        name.push('_');
    }
    name
}

/// Runs the analyses.
struct Runner<'m, 'r, 's> {
    maker: Maker<'m, 'r>,
    setup: &'s RunSetup,
    limits: &'s Limits,
    log: &'s Arc<Log>,
    sink: &'s mut dyn RunSink,
    patterns: Patterns,
    models: Models,
    /// Number of analyses that ran.
    runs: usize,
    /// Copies of the meshed part.
    symmetry: u32,
    /// Number of analyses that are still expected.
    open: usize,
}

impl Runner<'_, '_, '_> {
    /// Bounds the load cases of a group; `before`: number of directions of earlier groups.
    fn group(
        &mut self,
        wanted: &[Wanted],
        group: &[usize],
        before: usize,
    ) -> Result<Found, Diagnostics> {
        let of = |&i: &usize| (wanted[i].name.clone(), actions_of(&wanted[i].file));
        let mut cover = Cover::new(group.iter().map(of).collect());
        let mut directions: Vec<Direction> = Vec::new();
        let mut pending: VecDeque<Actions> = VecDeque::new();
        // open load cases when the directions were chosen, and their number
        let mut chosen: Option<[usize; 2]> = None;
        let mut cases_only = false;
        loop {
            let mut open = cover.open();
            // a run that ends early has at least one answer
            if open.is_empty() || self.runs > 0 && self.is_over() {
                break;
            }
            open.sort_by(|a, b| wanted[group[*b]].by_code.total_cmp(&wanted[group[*a]].by_code));
            if self.runs > 0 {
                self.log.line(format!("{} load cases are open", open.len()));
            }
            if pending.is_empty() {
                // directions that decide less than as many load cases of their own would: no more
                if let Some([at_first, count]) = chosen.take() {
                    cases_only |= open.len() + count > at_first;
                }
                match plan::next(&cover, &open, cases_only) {
                    Next::Case(k) => {
                        let Wanted { name, file, .. } = &wanted[group[k]];
                        let run = self.run(name, file.clone(), open.len())?;
                        cover.runs.push(run);
                        continue;
                    }
                    Next::Directions(all) => {
                        chosen = Some([open.len(), all.len()]);
                        pending = all.into();
                    }
                }
            }
            let Some(actions) = pending.pop_front() else { break };
            let name = direction_name(wanted, before + directions.len() + 1);
            let file = with_actions(&wanted[group[0]].file, &actions);
            let run = self.run(&name, file, pending.len() + 1)?;
            cover.runs.push(run);
            directions.push(Direction { name, like: cover.name(0).to_owned(), actions });
        }
        let own = |name: &str| cover.runs.iter().find(|r| r.entry.name == name);
        let entry = |i: usize| match own(cover.name(i)) {
            Some(run) => run.entry.clone(),
            None => cover.derive(i),
        };
        let entries = (0..cover.len()).map(entry).collect();
        let of_directions =
            directions.iter().filter_map(|d| Some(own(&d.name)?.entry.clone())).collect();
        Ok(Found { entries, directions, of_directions })
    }

    /// Whether an interrupt or the time ends the run.
    fn is_over(&self) -> bool {
        let late = self.limits.time.is_some_and(|t| self.log.seconds() >= t);
        late || self.limits.interrupt.asked()
    }

    /// Analyses one case; `left`: number of analyses of its group that may be needed at most.
    fn run(&mut self, name: &str, file: ModelFile, left: usize) -> Result<Run, Diagnostics> {
        let Self { setup, limits, log, .. } = *self;
        let case = (self.maker)(name, file, self.runs == 0)?;
        refuse_idle(&case)?;
        let model_file = case.model_file.clone();
        let now = log.seconds();
        let parts = left.min(self.open).max(1) as f64;
        let part = limits.time.map_or(f64::INFINITY, |t| (t - now).max(0.0) / parts);
        log.line(format!("limit analysis of {name}"));
        let share = Share {
            until: now + part,
            both_within: f64::INFINITY,
            first_stop: StopRules::on_mesh(setup.refinement.refines()),
            patterns: &self.patterns,
            evidence: None,
            decide: false,
        };
        let begun = Begun::new(case, self.runs == 0, share, setup.refinement.coarser, limits, log)?;
        if let Some(model) = begun.model() {
            if self.runs == 0 {
                self.symmetry = model.symmetry;
                let symmetry = self.symmetry > 1;
                self.models.traits =
                    ModelTraits { facets: true, symmetry, ..ModelTraits::default() };
            }
            note_traits(model, &mut self.models);
        }
        let mut adapted = begun.end(now + part, &setup.refinement, limits)?;
        let modes = complete(&mut adapted, setup, log);
        let stem = stem_of(name, AnalysisKind::Limit, false);
        let of = SolvedCase {
            adapted: &adapted,
            stem: &stem,
            model_file: &model_file,
            alone: false,
            modes: &modes,
        };
        self.sink.solved(&of, setup)?;
        self.runs += 1;
        let Adapted { entry, upper, .. } = adapted;
        let half_space =
            mechanism(&upper).and_then(|(v, bound)| HalfSpace::new(&upper.model, v, &bound));
        Ok(Run { entry, actions: live_actions(&upper.model), half_space })
    }
}
