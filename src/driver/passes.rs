//! The passes of a case: runs both programs on a mesh, keeps the entries of all passes and the
//! fields of those that are still needed.

use crate::driver::limits::Limits;
use crate::driver::pass_entry::{pass_bounds, pass_entry};
use crate::driver::pass_run::{self, Terms, run_pass};
use bracket_base::diag::{Diagnostic, Diagnostics};
use bracket_codes::route::{Evidence, NextMesh};
use bracket_codes::verdict::Verdict;
use bracket_engine::analysis::dispatch::AnalysisPass;
use bracket_engine::mesh::TetMesh;
use bracket_engine::model::file::{Bounds, ModelFile};
use bracket_engine::model::{AnalysisKind, AnalysisModel};
use bracket_engine::refine::plan::Prediction;
use bracket_engine::solve::{Patterns, StopRules};
use bracket_report::console::log::Log;
use bracket_report::document::table::Table;
use bracket_report::result::combine::{self, PassResult, best};
use bracket_report::result::evidence::{EvidencePlan, Side};
use bracket_report::result::result_file::{CaseResult, FrictionModel, Predicted, SoFar};
use std::sync::Arc;
use std::time::Instant;

/// Load factor of the load that a verdict is asked for.
const LOAD: f64 = 1.0;

/// Code of the fault of a lower bound above an upper one.
pub const CONTRADICTION: &str = "bounds/contradiction";

/// A pass whose fields are kept, with its mesh.
pub struct Kept {
    /// Its bounds and fields.
    pub outcome: AnalysisPass,
    /// The model on its mesh.
    pub model: AnalysisModel,
    /// Mesh, model file and quality; `None` for the first mesh, whose files exist already.
    pub made: Option<(TetMesh, ModelFile, Table)>,
    /// Number of the pass, from 0.
    pub index: usize,
}

/// Data that a case shares with the other cases of the run.
#[derive(Clone, Copy)]
pub struct Share<'a> {
    /// Time on the clock of the log at which the case should end, to leave the other cases their
    /// share \[s\].
    pub until: f64,
    /// Time that both bounds of a limit analysis on the first mesh may take \[s\]; where more is
    /// expected, the lower one is computed alone.
    pub both_within: f64,
    /// When solves on the first mesh end.
    pub first_stop: StopRules,
    /// Sparsity patterns that passes on the first mesh have found.
    pub patterns: &'a Patterns,
    /// What is measured in the fields of elastoplastic analysis, for the route of analysis.
    pub evidence: Option<&'a EvidencePlan>,
    /// True if no mesh is made that a verdict does not need.
    pub decide: bool,
}

/// A mesh to be analysed.
pub struct Mesh {
    /// The model on it.
    pub model: AnalysisModel,
    /// Mesh, model file and quality; `None` for the first mesh.
    pub made: Option<(TetMesh, ModelFile, Table)>,
    /// Wall time of meshing \[s\].
    pub seconds: Option<f64>,
    /// What was expected of it.
    pub predicted: Option<Prediction>,
}

/// The passes of a case.
pub struct Passes<'a> {
    /// Name of the case.
    pub name: String,
    /// Limits of the run.
    pub limits: &'a Limits,
    /// Log of the run.
    pub log: &'a Arc<Log>,
    /// Its time and patterns.
    pub share: Share<'a>,
    /// The entry of every pass.
    pub entries: Vec<PassResult>,
    /// The passes with fields.
    pub kept: Vec<Kept>,
}

impl<'a> Passes<'a> {
    /// A case without passes.
    pub fn new(name: String, share: Share<'a>, limits: &'a Limits, log: &'a Arc<Log>) -> Self {
        Self { name, limits, log, share, entries: Vec::new(), kept: Vec::new() }
    }

    /// Runs the programs on a mesh and keeps entry and fields.
    pub fn run(&mut self, mesh: Mesh) -> Result<Option<&Kept>, Diagnostics> {
        let Mesh { model, made, seconds: mesh_seconds, predicted } = mesh;
        let index = self.entries.len();
        let start = Instant::now();
        // later meshes are used by this case only
        let own = Patterns::default();
        let mut terms = Terms { answer_from: self.answer_from(&model), ..self.first_terms() };
        if index > 0 {
            let Share { until, .. } = self.share;
            let both_within = f64::INFINITY;
            let stop = StopRules::on_mesh(predicted.is_some_and(|p| p.first_of_two));
            terms = Terms { until, both_within, stop, patterns: &own, ..terms };
        }
        let outcome = run_pass(&self.name, &model, &terms, self.limits, self.log)?;
        let mut entry = pass_entry(&outcome, &self.name, &model, mesh_seconds);
        if let Some(row) = entry.history.last_mut() {
            row.seconds = Some(mesh_seconds.unwrap_or(0.0) + start.elapsed().as_secs_f64());
            row.predicted = predicted.map(|p| Predicted {
                macro_tets: p.tets.round() as usize,
                gap: Some(p.gap).filter(|gap| gap.is_finite()),
                seconds: p.seconds,
            });
        }
        if let (Some(plan), AnalysisPass::Energy(pass)) = (self.share.evidence, &outcome)
            && model.analysis == AnalysisKind::Elastoplastic
        {
            self.log.stage("estimates for the route of analysis");
            let side = Side { model: &model, pass };
            entry.evidence = Some(plan.measure(side, side));
        }
        let bounds = pass_bounds(&outcome, &entry);
        self.entries.push(PassResult { entry, bounds });
        self.kept.push(Kept { outcome, model, made, index });
        self.note_so_far(index)?;
        Ok(self.kept.last())
    }

    /// Terms of a pass on the first mesh, which may take all of the time of the run.
    fn first_terms(&self) -> Terms<'a> {
        let Share { both_within, patterns, first_stop: stop, .. } = self.share;
        let until = f64::INFINITY;
        Terms { until, answer_from: None, both_within, stop, patterns }
    }

    /// Adds the upper bound on the first mesh where the lower one was computed alone.
    pub fn add_upper(&mut self) -> Result<(), Diagnostics> {
        let terms = self.first_terms();
        let (Some(kept), Some(first)) = (self.kept.first_mut(), self.entries.first_mut()) else {
            return Ok(());
        };
        if !kept.outcome.wants_upper(&kept.model) {
            return Ok(());
        }
        let start = Instant::now();
        let Kept { outcome, model, .. } = kept;
        pass_run::add_upper(outcome, &self.name, model, &terms, self.limits, self.log)?;
        let before = first.entry.history.last().cloned().unwrap_or_default();
        let mut entry = pass_entry(outcome, &self.name, model, before.mesh_seconds);
        if let Some(row) = entry.history.last_mut() {
            row.seconds = Some(before.seconds.unwrap_or(0.0) + start.elapsed().as_secs_f64());
        }
        let bounds = pass_bounds(outcome, &entry);
        *first = PassResult { entry, bounds };
        self.note_so_far(0)
    }

    /// Notes the best bounds so far in the history of a pass.
    fn note_so_far(&mut self, index: usize) -> Result<(), Diagnostics> {
        let best = self.joined()?;
        if let Some(row) = self.entries[index].entry.history.last_mut() {
            row.so_far = Some(SoFar {
                lower: best.lower,
                upper: best.upper,
                gap: best.gap,
                strict: best.is_strict(),
            });
        }
        Ok(())
    }

    /// Where a mesh for the lower bound alone needs the bound without friction, see
    /// [`bracket_engine::analysis::pass::PassOptions`]: with associated friction it decides the
    /// verdict, and is computed again where it has not reached the load yet.
    fn answer_from(&self, model: &AnalysisModel) -> Option<f64> {
        let best = best(&self.entries).filter(|_| model.bounds == Bounds::Static)?;
        let safe = self.entries[best.frictionless].entry.safe_lower();
        Some(if safe.is_some_and(|l| l >= LOAD) { f64::INFINITY } else { LOAD })
    }

    /// What a verdict asks of the next mesh, where only a verdict is asked for: nothing if strict
    /// bounds decide the load.
    pub fn for_verdict(&self) -> Result<Option<NextMesh>, Diagnostics> {
        if !self.share.decide {
            return Ok(None);
        }
        let (lower, upper) = self.joined()?.factor_bounds();
        let least = self.share.evidence.map_or(1.0, EvidencePlan::least_factor);
        let decided = match Verdict::of(lower, upper) {
            Verdict::Ok => lower >= Some(least),
            verdict => verdict != Verdict::Undecided,
        };
        if decided {
            return Ok(Some(NextMesh::None));
        }
        let asked = |plan: &EvidencePlan| plan.next_mesh(&evidence(&self.entries));
        Ok(Some(self.share.evidence.map_or(NextMesh::Finer, asked)))
    }

    /// The entry with the best bounds so far.
    pub fn joined(&self) -> Result<CaseResult, Diagnostics> {
        joined(&self.name, &self.entries)
    }

    /// Drops the fields of passes without a best bound, except those of the passes in `used`.
    pub fn drop_unused(&mut self, used: &[usize]) {
        let place = best(&self.entries).map_or([0; 3], |b| [b.lower, b.upper, b.frictionless]);
        self.kept.retain(|k| place.contains(&k.index) || used.contains(&k.index));
    }
}

/// What was measured on the meshes of these passes, in order of their tets.
pub fn evidence(entries: &[PassResult]) -> Vec<Evidence> {
    let found = entries.iter().filter_map(|e| e.entry.evidence.clone());
    let mut measured: Vec<Evidence> = found.collect();
    measured.sort_by_key(|e| e.tets);
    measured
}

/// The fault of a pass that cannot be found.
pub fn lost(name: &str) -> Diagnostic {
    Diagnostic::undecided("cli/lost", format!("the best pass of `{name}` was lost"))
}

/// The entry with the best bounds of all passes.
pub fn joined(name: &str, entries: &[PassResult]) -> Result<CaseResult, Diagnostics> {
    let Some(b) = best(entries) else { return Err(lost(name).into()) };
    let upper = entries[b.upper].clone();
    let safe = entries[b.frictionless].entry.frictionless;
    // only with associated friction is it no part of the answer, and may come from a third mesh
    let with_safe = |entry: CaseResult| match entry.problem {
        FrictionModel::Associated => CaseResult { frictionless: safe, ..entry },
        _ => entry,
    };
    if b.upper == b.lower {
        return Ok(with_safe(upper.entry));
    }
    combine::join(upper, entries[b.lower].clone()).map(with_safe).map_err(|e| {
        Diagnostic::undecided(CONTRADICTION, e.to_string())
            .help("the numbers are withheld; try `--solver clarabel`, and report the case")
            .into()
    })
}
