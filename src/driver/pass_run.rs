//! Runs both programs of a case on one mesh and logs the progress.

use crate::analysis::dispatch::AnalysisPass;
use crate::analysis::event::Progress;
use crate::analysis::memory::{Limit, room};
use crate::analysis::pass::PassOptions;
use crate::analysis::program::Program;
use crate::analysis::program_outcome::InsufficientMemory;
use crate::certify::faces::contact_faces;
use crate::diag::{Diagnostic, Diagnostics};
use crate::driver::context::RunContext;
use crate::driver::limits::Limits;
use crate::model::AnalysisModel;
use crate::report::console::log::Log;
use crate::report::console::progress;
use crate::result::refusal::refusal_words;
use crate::solve::{Patterns, SolveOptions};
use crate::spec::analysis::AnalysisKind;
use std::sync::Arc;

/// The fault of a case whose programs all exceed the memory.
pub fn too_large(name: &str, pass: &AnalysisPass, context: &RunContext) -> Diagnostic {
    let refused: Vec<(Program, InsufficientMemory)> =
        pass.runs().into_iter().filter_map(|(p, run)| Some((p, run.refusal?))).collect();
    let each =
        refused.iter().map(|(p, r)| format!("the {} program {}", p.name(), refusal_words(r)));
    let message =
        format!("`{name}` does not fit into the memory: {}", each.collect::<Vec<_>>().join("; "));
    let asked = refused.iter().any(|(_, r)| r.room.limit != Limit::Machine);
    let larger = if asked { ", a larger --memory-limit" } else { "" };
    Diagnostic::environment("run/memory", message).help(format!(
        "use {}{larger} or a machine with more memory; nothing was written",
        context.coarser
    ))
}

/// Runs both programs of a case on one mesh. `until` is the time on the log's clock at which solves
/// end \[s\]. `patterns` are the sparsity patterns that earlier passes on this mesh have found;
/// `answer_from`: see [`PassOptions`].
pub fn run_pass(
    name: &str,
    model: &AnalysisModel,
    until: f64,
    answer_from: Option<f64>,
    patterns: &Patterns,
    limits: &Limits,
    log: &Arc<Log>,
) -> Result<AnalysisPass, Diagnostics> {
    // one load case may have several kinds of analysis
    let kind = match model.analysis {
        AnalysisKind::Limit => " (limit)",
        AnalysisKind::Elastoplastic => " (elastoplastic)",
        AnalysisKind::Elastic => "",
    };
    let name = format!("{name}{kind}");
    log.line(format!(
        "{}: {} tets, {} contact faces, {} part{}",
        name,
        model.mesh.tets.len(),
        contact_faces(model).len(),
        model.parts.len(),
        if model.parts.len() == 1 { "" } else { "s" }
    ));
    // a solve that cannot finish in the remaining time ends with status `time limit`
    let left = (limits.time.unwrap_or(f64::INFINITY).min(until) - log.seconds()).max(0.0);
    let interrupt = Some(limits.interrupt.flag());
    let patterns = patterns.clone();
    let solve = SolveOptions {
        solver: limits.solver,
        time_limit: left,
        interrupt,
        patterns,
        ..SolveOptions::default()
    };
    let (shown, name, tolerance) = (log.clone(), name, AnalysisPass::tolerance(model, &solve));
    let progress: Progress =
        Arc::new(move |program, event| progress::note(&shown, &name, tolerance, program, event));
    let memory = limits.memory;
    let options = PassOptions { solve, room: Arc::new(move || room(memory)), answer_from };
    AnalysisPass::run(model, &options, &progress).map_err(|e| Diagnostic::from(e).into())
}
