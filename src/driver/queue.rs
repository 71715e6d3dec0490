//! The order in which the cases of a run are analysed. Under a time limit each limit analysis gets
//! its lower bound before any mesh is refined, because a lower bound decides.

use crate::driver::adaptive::Begun;
use crate::driver::case::Case;
use crate::driver::limits::Limits;
use crate::driver::passes::{Share, lost};
use crate::driver::setup::{Refinement, RunSetup};
use bracket_base::diag::Diagnostics;
use bracket_engine::model::AnalysisKind;
use bracket_engine::solve::{Patterns, StopRules};
use bracket_report::console::log::Log;
use bracket_report::result::evidence::EvidencePlan;
use std::sync::Arc;

/// Part of a case's share of the time that both bounds on the first mesh may be forecast to take. A
/// forecast is right within a factor of two.
const SURE: f64 = 0.5;

/// A case of the queue.
enum Place<'a, 'r> {
    Waiting(Box<Case<'r>>),
    Begun(Box<Begun<'a, 'r>>),
    Taken,
}

/// The cases of a run, in the order in which they were asked for.
pub struct Queue<'a, 'r> {
    places: Vec<Place<'a, 'r>>,
    patterns: &'a Patterns,
    /// How far the meshes are refined.
    refinement: Refinement,
    limits: &'a Limits,
    log: &'a Arc<Log>,
    /// What is measured for the route of analysis.
    evidence: Option<&'a EvidencePlan>,
    /// Whether only a verdict is asked for.
    decide: bool,
    /// No case was analysed before.
    first: bool,
}

impl<'a, 'r> Queue<'a, 'r> {
    /// The cases, none of which is analysed yet.
    pub fn new(
        cases: Vec<Case<'r>>,
        patterns: &'a Patterns,
        setup: &'a RunSetup,
        limits: &'a Limits,
        log: &'a Arc<Log>,
    ) -> Self {
        let (refinement, evidence) = (setup.refinement, setup.evidence.as_ref());
        let decide = setup.decide;
        let places = cases.into_iter().map(|c| Place::Waiting(Box::new(c))).collect();
        Self { places, patterns, refinement, limits, log, evidence, decide, first: true }
    }

    /// Computes the lower bound of every limit analysis of a load case on the first mesh; `time`:
    /// limit of the run on the clock of the log \[s\]. Where the time suffices for certain, the
    /// upper bound is computed beside it.
    pub fn lower_bounds(&mut self, time: f64) -> Result<(), Diagnostics> {
        let decides = |p: &Place| match p {
            Place::Waiting(c) => c.model.analysis == AnalysisKind::Limit && c.direction.is_none(),
            _ => false,
        };
        let wanted: Vec<usize> =
            (0..self.places.len()).filter(|i| decides(&self.places[*i])).collect();
        let mut sure = true;
        for (k, i) in wanted.iter().enumerate() {
            // the first case always has an answer, an interrupted one too
            if self.limits.interrupt.asked() && !self.first {
                break;
            }
            let share = (time - self.log.seconds()).max(0.0) / (wanted.len() - k) as f64;
            let begun = self.begin(*i, if sure { SURE * share } else { 0.0 })?;
            sure &= !begun.wants_upper();
        }
        Ok(())
    }

    /// Computes the upper bounds on the first mesh that are still to come.
    pub fn upper_bounds(&mut self) -> Result<(), Diagnostics> {
        for place in &mut self.places {
            if self.limits.interrupt.asked() {
                break;
            }
            if let Place::Begun(begun) = place {
                begun.add_upper()?;
            }
        }
        Ok(())
    }

    /// True if neither this case nor one behind it has been analysed.
    pub fn untouched(&self, i: usize) -> bool {
        self.places[i..].iter().all(|p| matches!(p, Place::Waiting(_)))
    }

    /// A case on its first mesh; each case can be taken once.
    pub fn take(&mut self, i: usize) -> Result<Begun<'a, 'r>, Diagnostics> {
        if matches!(self.places[i], Place::Waiting(_)) {
            self.begin(i, f64::INFINITY)?;
        }
        match std::mem::replace(&mut self.places[i], Place::Taken) {
            Place::Begun(begun) => Ok(*begun),
            _ => Err(lost(&format!("case {i}")).into()),
        }
    }

    /// Analyses a waiting case on the first mesh.
    fn begin(&mut self, i: usize, both_within: f64) -> Result<&Begun<'a, 'r>, Diagnostics> {
        let place = &mut self.places[i];
        if let Place::Waiting(case) = std::mem::replace(place, Place::Taken) {
            let first = std::mem::take(&mut self.first);
            // an elastic analysis has no part in a verdict by analysis
            let decide = self.decide && case.model.analysis != AnalysisKind::Elastic;
            let first_stop = match (self.refinement.refines(), case.direction) {
                (false, Some(_)) => StopRules::of_direction(),
                (refined, _) => StopRules::on_mesh(refined),
            };
            let share = Share {
                until: f64::INFINITY,
                both_within,
                first_stop,
                patterns: self.patterns,
                evidence: self.evidence,
                decide,
            };
            let begun =
                Begun::new(*case, first, share, self.refinement.coarser, self.limits, self.log)?;
            *place = Place::Begun(Box::new(begun));
        }
        match place {
            Place::Begun(begun) => Ok(begun),
            _ => Err(lost(&format!("case {i}")).into()),
        }
    }
}
