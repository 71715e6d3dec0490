//! Runs both programs of a case on one mesh and logs the progress.

use crate::driver::limits::Limits;
use bracket_base::diag::{Diagnostic, Diagnostics};
use bracket_engine::analysis::dispatch::AnalysisPass;
use bracket_engine::analysis::event::Progress;
use bracket_engine::analysis::memory::{Limit, room};
use bracket_engine::analysis::pass::PassOptions;
use bracket_engine::analysis::program::Program;
use bracket_engine::analysis::program_outcome::InsufficientMemory;
use bracket_engine::certify::faces::contact_faces;
use bracket_engine::model::AnalysisKind;
use bracket_engine::model::AnalysisModel;
use bracket_engine::solve::{Patterns, SolveOptions, StopRules};
use bracket_report::console::log::Log;
use bracket_report::console::progress;
use bracket_report::result::refusal::refusal_words;
use std::sync::Arc;

/// The fault of a case whose programs all exceed the memory; `coarser`: advice on a coarser mesh.
pub fn too_large(name: &str, pass: &AnalysisPass, coarser: &str) -> Diagnostic {
    let refused: Vec<(Program, InsufficientMemory)> =
        pass.runs().into_iter().filter_map(|(p, run)| Some((p, run.refusal?))).collect();
    let each =
        refused.iter().map(|(p, r)| format!("the {} program {}", p.name(), refusal_words(r)));
    let message =
        format!("`{name}` does not fit into the memory: {}", each.collect::<Vec<_>>().join("; "));
    let asked = refused.iter().any(|(_, r)| r.room.limit != Limit::Machine);
    let larger = if asked { ", a larger --memory-limit" } else { "" };
    Diagnostic::environment("run/memory", message)
        .help(format!("use {coarser}{larger} or a machine with more memory; nothing was written"))
}

/// Limits of one pass beside those of the run.
pub struct Terms<'a> {
    /// Time on the log's clock at which solves end \[s\].
    pub until: f64,
    /// See [`PassOptions`].
    pub answer_from: Option<f64>,
    /// See [`PassOptions`] \[s\].
    pub both_within: f64,
    /// When its solves end.
    pub stop: StopRules,
    /// The sparsity patterns that earlier passes on this mesh have found.
    pub patterns: &'a Patterns,
}

/// Runs the programs of a case on one mesh.
pub fn run_pass(
    name: &str,
    model: &AnalysisModel,
    terms: &Terms<'_>,
    limits: &Limits,
    log: &Arc<Log>,
) -> Result<AnalysisPass, Diagnostics> {
    let name = with_kind(name, model);
    log.line(format!(
        "{}: {} tets, {} contact faces, {} part{}",
        name,
        model.mesh.tets.len(),
        contact_faces(model).len(),
        model.parts.len(),
        if model.parts.len() == 1 { "" } else { "s" }
    ));
    let (options, progress) = options(name, model, terms, limits, log);
    AnalysisPass::run(model, &options, &progress).map_err(|e| Diagnostic::from(e).into())
}

/// Adds the upper bound to a pass that has computed the lower one alone.
pub fn add_upper(
    pass: &mut AnalysisPass,
    name: &str,
    model: &AnalysisModel,
    terms: &Terms<'_>,
    limits: &Limits,
    log: &Arc<Log>,
) -> Result<(), Diagnostics> {
    let (options, progress) = options(with_kind(name, model), model, terms, limits, log);
    pass.add_upper(model, &options, &progress).map_err(|e| Diagnostic::from(e).into())
}

/// The name of a case with its kind of analysis: one load case may have several.
fn with_kind(name: &str, model: &AnalysisModel) -> String {
    let kind = match model.analysis {
        AnalysisKind::Limit => " (limit)",
        AnalysisKind::Elastoplastic => " (elastoplastic)",
        AnalysisKind::Elastic => "",
    };
    format!("{name}{kind}")
}

/// The options of a pass, and the log of its progress.
fn options(
    name: String,
    model: &AnalysisModel,
    terms: &Terms<'_>,
    limits: &Limits,
    log: &Arc<Log>,
) -> (PassOptions, Progress) {
    // a solve that cannot finish in the remaining time ends with status `time limit`
    let left = (limits.time.unwrap_or(f64::INFINITY).min(terms.until) - log.seconds()).max(0.0);
    let interrupt = Some(limits.interrupt.flag());
    let patterns = terms.patterns.clone();
    let solve = SolveOptions {
        solver: limits.solver,
        time_limit: left,
        interrupt,
        patterns,
        stop: terms.stop,
        ..SolveOptions::default()
    };
    let (shown, tolerance) = (log.clone(), AnalysisPass::tolerance(model, &solve));
    let progress: Progress =
        Arc::new(move |program, event| progress::note(&shown, &name, tolerance, program, event));
    let memory = limits.memory;
    let options = PassOptions {
        solve,
        room: Arc::new(move || room(memory)),
        answer_from: terms.answer_from,
        both_within: terms.both_within,
    };
    (options, progress)
}
