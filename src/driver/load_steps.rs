//! The load steps of elastoplastic analysis, on the mesh of the upper bound of the case.

use crate::driver::adaptive::Adapted;
use crate::driver::limits::Limits;
use crate::driver::pass_entry::pass_entry;
use crate::driver::pass_run::{Terms, run_pass};
use crate::driver::setup::RunSetup;
use crate::driver::solved::RunSink;
use bracket_base::diag::Diagnostics;
use bracket_codes::route::BoltSections;
use bracket_engine::analysis::dispatch::AnalysisPass;
use bracket_engine::model::{AnalysisKind, AnalysisModel};
use bracket_engine::solve::{Patterns, StopRules};
use bracket_report::console::log::Log;
use bracket_report::result::evidence::Side;
use bracket_report::result::load_step::without_steps;
use bracket_report::result::preload::close_cuts;
use bracket_report::result::step_bounds::{add_loads, step_of, step_of_case};
use std::sync::Arc;

/// Analyses the load steps that the spec asks for and adds them to the entry of the case; those
/// for which the time does not suffice are left out with a warning. The step at load factor 1 is
/// the analysis of the case. `until`: time on the clock of the log \[s\].
pub fn add_load_steps(
    adapted: &mut Adapted,
    (setup, stem): (&RunSetup, &str),
    until: f64,
    limits: &Limits,
    sink: &mut dyn RunSink,
    log: &Arc<Log>,
) -> Result<(), Diagnostics> {
    let Adapted { entry, upper, .. } = adapted;
    if entry.analysis != AnalysisKind::Elastoplastic {
        return Ok(());
    }
    // the steps are of one structure: with the closures of the case
    let mut base = upper.model.clone();
    close_cuts(&mut base, &entry.preload);
    let loose = base.preload.iter().any(|p| p.closure.is_none());
    // the mesh of the case, whose matrices have the same patterns at every load
    let patterns = Patterns::default();
    let (mut steps, mut left_out) = (Vec::new(), Vec::new());
    for (i, &factor) in setup.load_steps.iter().enumerate() {
        if factor == 1.0 {
            steps.push(step_of_case(entry));
            continue;
        }
        if loose || limits.interrupt.asked() || log.seconds() >= until {
            left_out.push(factor);
            continue;
        }
        let model = base.at_load_factor(factor);
        log.stage(format!("load step {factor}"));
        let terms = Terms {
            until,
            answer_from: None,
            both_within: f64::INFINITY,
            stop: StopRules::default(),
            patterns: &patterns,
        };
        let pass = run_pass(&entry.name, &model, &terms, limits, log)?;
        let found = pass_entry(&pass, &entry.name, &model, None);
        steps.push(step_of(factor, &found, bolts(setup, &model, &pass)));
        sink.step((stem, i + 1), &model, &pass)?;
    }
    if !left_out.is_empty() {
        entry.warnings.push(without_steps(&left_out));
    }
    add_loads(&mut steps, &base, entry.problem);
    entry.load_steps = steps;
    Ok(())
}

/// The forces in the sections of the bolts, where they are measured.
fn bolts(setup: &RunSetup, model: &AnalysisModel, pass: &AnalysisPass) -> Vec<BoltSections> {
    let (Some(plan), AnalysisPass::Energy(pass)) = (&setup.evidence, pass) else {
        return Vec::new();
    };
    let side = Side { model, pass };
    plan.bolts(side, side)
}
