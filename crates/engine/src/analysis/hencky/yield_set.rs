//! The set of tets with yield conditions of one program, which grows from solve to solve.

use crate::analysis::hencky::programs::{Motion, ROUNDING, Recovered};
use crate::analysis::program_outcome::ProgramOutcome;
use crate::certify::bracket::{LowerBound, UpperBound};
use crate::certify::faces::contact_faces;
use crate::certify::fields::StressField;
use crate::certify::limit_certificate::hidden_at;
use crate::certify::measures::largest;
use crate::mesh::numbering::FaceNumbering;
use crate::model::AnalysisModel;
use crate::solve::SolveStatus;
use bracket_base::say;

/// Utilisation by the elastic stress from which a tet gets a yield condition.
const FIRST: f64 = 0.6;
/// Utilisation from which the tets that share a face with a tet get one too: they take over what
/// the tet loses by yielding.
const AROUND: f64 = 0.9;
/// Utilisation from which further tets join in later solves, when some are beyond yield; after the
/// last one all tets join.
const LATER: [f64; 4] = [0.8, 0.7, 0.5, 0.3];
/// Margin below the yield surface over the utilisation that a residual of [`ROUNDING`] may hide.
/// Measured on a joint of 7 000 tets: bringing a solution into equilibrium adds about ten times
/// that utilisation to the largest one.
const CORRECTION: f64 = 30.0;
/// Largest margin below the yield surface until a solution has needed a larger one.
const MOST_FIRST: f64 = 1e-4;
/// Largest stress over the largest yield strength, taken for the margin while no solution is known:
/// pressure under bolt heads exceeds the yield strength.
const STRESS: f64 = 4.0;
/// Relative margin below the yield surface that the static program leaves for the correction that
/// brings its stress into equilibrium: the first one and the largest one.
const MARGIN: [f64; 2] = [2e-7, 1e-3];
/// Dissipation over the energy, of tets without flow in the program, below which another solve is
/// not worth its time.
const WORTH: f64 = 1e-6;

/// Margin for a stress whose equilibrium up to rounding hides the utilisation `hidden`.
fn margin(hidden: f64) -> f64 {
    (CORRECTION * hidden).min(MOST_FIRST)
}

/// For each tet: its body has a yield strength.
fn can_yield(model: &AnalysisModel) -> Vec<bool> {
    let radii = model.yield_radii();
    model.mesh.tet_body.iter().map(|body| radii[*body as usize].is_some()).collect()
}

/// One program from solve to solve.
pub(super) struct Side<A> {
    /// Tets with a yield condition.
    pub(super) yields: Vec<bool>,
    /// The next solve is an elastic one with low accuracy: the first.
    pub(super) rough: bool,
    /// Relative margin below the yield surface.
    pub(super) margin: f64,
    /// Outcome of all solves so far.
    pub(super) outcome: Option<ProgramOutcome>,
    /// The last certified field and its bound.
    pub(super) answer: Option<A>,
    /// No further solve is needed or possible.
    pub(super) done: bool,
}

pub(super) type KinematicSide = Side<(Motion, UpperBound)>;
pub(super) type StaticSide = Side<(StressField, LowerBound)>;

/// The yield conditions of the first solve.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum First {
    /// None: it shows where they are needed.
    Nowhere,
    /// In every tet that can yield.
    Everywhere,
}

impl First {
    /// The ones that cost less in all: without contact an elastic solve is a linear system of
    /// equations, with contact it is a cone program already.
    pub(super) fn of(model: &AnalysisModel) -> Self {
        if contact_faces(model).is_empty() { First::Nowhere } else { First::Everywhere }
    }
}

impl<A> Side<A> {
    pub(super) fn new(model: &AnalysisModel, requested: bool, first: First) -> Self {
        let (yields, needed) = match first {
            First::Nowhere => (vec![false; model.mesh.tets.len()], 0.0),
            First::Everywhere => {
                let stress = STRESS * largest(model.yield_radii().into_iter().flatten());
                (can_yield(model), margin(hidden_at(model, stress, ROUNDING)))
            }
        };
        Self {
            yields,
            rough: first == First::Nowhere,
            margin: needed.max(MARGIN[0]),
            outcome: None,
            answer: None,
            done: !requested,
        }
    }

    /// Number of tets with a yield condition.
    pub(super) fn count(&self) -> usize {
        self.yields.iter().filter(|y| **y).count()
    }

    /// Adds the outcome of another solve: the cost of all, the status of the last.
    fn add_outcome(&mut self, outcome: ProgramOutcome) {
        let Some(earlier) = self.outcome.take() else {
            self.outcome = Some(outcome);
            return;
        };
        let mut trace = earlier.trace;
        trace.extend(outcome.trace);
        self.outcome = Some(ProgramOutcome {
            iterations: earlier.iterations + outcome.iterations,
            assembly_seconds: earlier.assembly_seconds + outcome.assembly_seconds,
            solve_seconds: earlier.solve_seconds + outcome.solve_seconds,
            certify_seconds: earlier.certify_seconds + outcome.certify_seconds,
            rounds: earlier.rounds + 1,
            handed_over: earlier.handed_over.max(outcome.handed_over),
            trace,
            ..outcome
        });
    }

    /// Adds the tets whose utilisation reaches a threshold, and the neighbours of those near yield.
    /// The threshold falls with every solve.
    fn grow(&mut self, model: &AnalysisModel, used: &[f64]) {
        let rounds = self.outcome.as_ref().map_or(0, |o| o.rounds as usize);
        let least = match self.count() {
            0 => FIRST,
            _ => LATER.get(rounds.saturating_sub(2)).copied().unwrap_or(0.0),
        };
        let mut joins: Vec<bool> = used.iter().map(|u| *u >= least).collect();
        for &(a, b) in &FaceNumbering::new(&model.mesh).tets {
            let Some(b) = b else { continue };
            let (a, b) = (a as usize, b as usize);
            joins[a] |= used[b] >= AROUND;
            joins[b] |= used[a] >= AROUND;
        }
        for ((yields, joins), can) in self.yields.iter_mut().zip(joins).zip(can_yield(model)) {
            *yields |= joins && can;
        }
    }

    /// Handles a solve that ended without a field.
    fn without_field(&mut self, status: SolveStatus) {
        use SolveStatus::{Interrupted, TimeLimit, TooLarge};
        // a rough solve is tried again with full accuracy
        self.done = !std::mem::take(&mut self.rough)
            || matches!(status, Interrupted | TimeLimit | TooLarge);
    }
}

impl KinematicSide {
    /// Adds a solve of the kinematic program.
    pub(super) fn add_solve(
        &mut self,
        model: &AnalysisModel,
        outcome: ProgramOutcome,
        recovered: Option<Recovered<Motion, UpperBound>>,
    ) {
        let Some(recovered) = recovered else {
            self.without_field(outcome.status);
            // a bound of an earlier solve stands, unless the program is unbounded
            if self.answer.is_none() || outcome.status == SolveStatus::Unbounded {
                self.add_outcome(outcome);
                self.answer = None;
            }
            return;
        };
        self.add_outcome(outcome);
        self.rough = false;
        self.done = recovered.certified.is_some() && recovered.beyond <= WORTH;
        if recovered.certified.is_some() {
            self.answer = recovered.certified;
        }
        if !self.done {
            self.grow(model, &recovered.used);
        }
    }
}

impl StaticSide {
    /// Adds a solve of the static program.
    pub(super) fn add_solve(
        &mut self,
        model: &AnalysisModel,
        outcome: ProgramOutcome,
        recovered: Option<Recovered<StressField, LowerBound>>,
    ) {
        let Some(recovered) = recovered else {
            self.without_field(outcome.status);
            self.add_outcome(outcome);
            return;
        };
        self.add_outcome(outcome);
        self.rough = false;
        let Some((field, bound)) = recovered.certified else {
            self.margin = self.margin.max(margin(recovered.hidden));
            self.grow(model, &recovered.used);
            return;
        };
        let over = bound.certificate().yields.unwrap_or(0.0);
        let mut tets = self.yields.iter().zip(&recovered.used);
        let outside = tets.any(|(y, u)| !y && *u > 1.0 - 2.0 * self.margin);
        if over <= 0.0 {
            self.answer = Some((field, bound));
            self.done = true;
        } else if !outside {
            // no tet to add: the margin was too small for the residual of the solver
            self.margin = (4.0 * self.margin).max(4.0 * over);
            if self.margin > MARGIN[1] {
                self.done = true;
                let over = format!("{over:.1e}");
                let words = say!("its stress exceeds the yield strength by {} of it", over);
                self.outcome.iter_mut().for_each(|o| o.trouble = Some(words.clone()));
            }
            return;
        }
        if !self.done {
            self.grow(model, &recovered.used);
        }
    }
}
