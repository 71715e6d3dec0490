//! Solves the cases of a run: bounds, forces and polygon, without a verdict.

use crate::driver::adaptive::Adapted;
use crate::driver::case::{Case, not_analysed, refuse_idle, stems};
use crate::driver::limits::Limits;
use crate::driver::load_steps::add_load_steps;
use crate::driver::pass_entry::lower_stress;
use crate::driver::passes::Kept;
use crate::driver::polygon::Directions;
use crate::driver::queue::Queue;
use crate::driver::setup::RunSetup;
use crate::driver::solved::{Models, RunSink, Solved, SolvedCase};
use bracket_base::diag::Diagnostics;
use bracket_base::say;
use bracket_base::words::Text;
use bracket_codes::route::NextMesh;
use bracket_codes::verdict::Verdict;
use bracket_engine::analysis::dispatch::AnalysisPass;
use bracket_engine::certify::faces::contact_faces;
use bracket_engine::certify::fields::DisplacementField;
use bracket_engine::model::{AnalysisKind, AnalysisModel};
use bracket_engine::solve::Patterns;
use bracket_report::console::log::Log;
use bracket_report::markdown::report_data::ModelTraits;
use bracket_report::result::buckled::Buckled;
use bracket_report::result::evidence::Side;
use bracket_report::result::forces::static_forces;
use bracket_report::result::preload::mark_halved;
use bracket_report::result::result_file::{CaseResult, ResultFile};
use std::sync::Arc;

/// Analyses the cases in turn and hands each to `sink`.
pub fn solve(
    cases: Vec<Case>,
    setup: &RunSetup,
    limits: &Limits,
    sink: &mut dyn RunSink,
    log: &Arc<Log>,
) -> Result<Solved, Diagnostics> {
    cases.iter().try_for_each(refuse_idle)?;
    let symmetry = cases.first().map_or(1, |c| c.model.symmetry);
    let mut result = ResultFile::new(setup.input_hash.clone(), symmetry, Verdict::None);
    result.warnings.clone_from(&setup.warnings);
    let asked: Vec<String> = cases.iter().map(|c| c.name.clone()).collect();
    result.asked.clone_from(&asked);
    let traits = ModelTraits { facets: true, symmetry: symmetry > 1, ..ModelTraits::default() };
    let mut solved = Solved { result, models: Models { traits, notes: Vec::new() } };
    let stems = stems(&cases);
    let cases_asked: Vec<(String, AnalysisKind)> =
        cases.iter().map(|c| (c.name.clone(), c.model.analysis)).collect();
    let mut directions = Directions::among(&cases, setup.polygon.as_ref());
    // the first mesh is the same for all cases
    let patterns = Patterns::default();
    let kept: Vec<_> = cases.iter().map(|c| (c.model_file.clone(), c.direction)).collect();
    let mut queue = Queue::new(cases, &patterns, setup, limits, log);
    if let Some(time) = limits.time {
        queue.lower_bounds(time)?;
        queue.upper_bounds()?;
    }
    for (i, (model_file, direction)) in kept.into_iter().enumerate() {
        if setup.decide && refused(&solved.result.cases, &cases_asked[i]) {
            log.line(format!(
                "{}: limit analysis refuses the load, so that {} analysis has no answer",
                cases_asked[i].0,
                cases_asked[i].1.word()
            ));
            continue;
        }
        if limits.interrupt.asked() && i > 0 && queue.untouched(i) {
            solved.result.warnings.push(not_analysed(&asked[i..]));
            break;
        }
        let begun = queue.take(i)?;
        if let Some(model) = begun.model() {
            note_traits(model, &mut solved.models);
        }
        let now = log.seconds();
        let until = limits
            .time
            .map_or(f64::INFINITY, |t| now + (t - now).max(0.0) / (asked.len() - i) as f64);
        let mut adapted = begun.end(until, &setup.refinement, limits)?;
        let modes = complete(&mut adapted, setup, log);
        let (stem, alone) = (stems[i].as_str(), asked.len() == 1);
        add_load_steps(&mut adapted, (setup, stem), until, limits, sink, log)?;
        let case =
            SolvedCase { adapted: &adapted, stem, model_file: &model_file, alone, modes: &modes };
        sink.solved(&case, setup)?;
        let Adapted { entry, upper, .. } = adapted;
        if let (Some(directions), Some(direction)) = (&mut directions, direction) {
            directions.add(direction, &entry, &upper);
        }
        solved.result.cases.push(entry);
    }
    let result = &mut solved.result;
    result.warnings.extend(without_bounds(&result.cases));
    result.polygon = directions.and_then(Directions::polygon);
    Ok(solved)
}

/// Whether limit analysis has proved that a load cannot be carried, so that elastoplastic analysis
/// of it has no answer: there is no equilibrium.
pub fn refused(solved: &[CaseResult], (name, kind): &(String, AnalysisKind)) -> bool {
    let above = |c: &CaseResult| c.factor_bounds().1.is_some_and(|u| u < 1.0);
    *kind == AnalysisKind::Elastoplastic && solved.iter().any(|c| c.name == *name && above(c))
}

/// Adds to the entry of a case what its fields show: a warning if a program did not fit into the
/// memory, preloads of halved bolts, the forces of the static field, and the numbers of the route
/// of analysis. Returns the buckling modes.
pub fn complete(adapted: &mut Adapted, setup: &RunSetup, log: &Log) -> Vec<DisplacementField> {
    let RunSetup { mirror, bolts, .. } = setup;
    let Adapted { entry, upper, lower, .. } = adapted;
    if upper.outcome.runs().iter().any(|(_, run)| run.refusal.is_some()) {
        entry.warnings.push(say!(
            "both bounds need {}, or more memory; `bounds` in a model file asks for one of them \
             alone",
            setup.refinement.coarser
        ));
    }
    let best = lower.as_ref().unwrap_or(upper);
    mark_halved(&mut entry.preload, &best.model, mirror);
    let stress = lower_stress(&best.outcome, entry).filter(|_| !bolts.is_empty());
    let forces =
        stress.map(|(stress, factor)| static_forces(&best.model, stress, factor, bolts, mirror));
    entry.static_forces = forces;
    // the two passes are one, and the last in order of tets
    let tets = entry.evidence.as_ref().map(|e| e.tets);
    let measured = lower.is_none() && tets == Some(upper.model.mesh.tets.len());
    if let (Some(plan), Some([upper, lower])) = (&setup.evidence, sides(upper, best))
        && entry.analysis == AnalysisKind::Elastoplastic
    {
        // from the fields that are stored; those of the finest mesh are measured already
        if !measured {
            entry.evidence = Some(plan.measure(upper, lower));
        }
        // where another step is open they change nothing
        if plan.next_mesh(&entry.evidence_of_meshes()) == NextMesh::None {
            log.stage("critical factors of buckling");
            match plan.critical(upper, lower) {
                Ok(Buckled { factors, shapes }) => {
                    entry.critical = Some(factors);
                    return shapes;
                }
                Err(why) => entry.critical_unknown = Some(why),
            }
        }
    }
    Vec::new()
}

/// The passes of both bounds of an energy.
fn sides<'a>(upper: &'a Kept, lower: &'a Kept) -> Option<[Side<'a>; 2]> {
    let side = |kept: &'a Kept| match &kept.outcome {
        AnalysisPass::Energy(pass) => Some(Side { model: &kept.model, pass }),
        AnalysisPass::Factor(_) => None,
    };
    Some([side(upper)?, side(lower)?])
}

/// The warning about the analyses that ended without any bound.
pub fn without_bounds(cases: &[CaseResult]) -> Option<Text> {
    let bare = cases.iter().filter(|c| c.lower.is_none() && c.upper.is_none());
    let named = bare.map(|c| {
        let kind = c.analysis.word();
        match c.ended_by() {
            Some(status) => say!("{} ({}, {})", &c.name, kind, status),
            None => say!("{} ({})", &c.name, kind),
        }
    });
    let named = Text::joined("; ", named);
    (!named.is_empty()).then(|| say!("not analysed, without any bound: {}", named))
}

/// Adds the traits and notes of a model to those of the run.
pub fn note_traits(model: &AnalysisModel, models: &mut Models) {
    let contacts = contact_faces(model);
    let traits = &mut models.traits;
    traits.contact |= !contacts.is_empty();
    traits.friction |= model.has_friction();
    traits.coulomb |= model.has_coulomb_friction();
    traits.preload |= model.has_preload();
    traits.initial_gap |= contacts.iter().any(|f| !f.law.gap.is_zero());
    for note in &model.notes {
        if !models.notes.contains(note) {
            models.notes.push(note.clone());
        }
    }
}
