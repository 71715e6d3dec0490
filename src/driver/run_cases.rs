//! Analyses the cases of a run, writes their files, and finishes the result.

use crate::driver::adaptive::Adapted;
use crate::driver::case::{Case, not_analysed, refuse_idle, stems};
use crate::driver::case_files::write_passes;
use crate::driver::collapse_pictures::collapse_pictures;
use crate::driver::context::RunContext;
use crate::driver::finish::{Analyses, Finished, finish};
use crate::driver::limits::Limits;
use crate::driver::pass_entry::lower_stress;
use crate::driver::passes::Kept;
use crate::driver::pictures::{contact_pictures, convergence, deformed_picture, mesh_pictures};
use crate::driver::polygon::Directions;
use crate::driver::queue::Queue;
use crate::driver::scene::add_case;
use bracket_base::diag::Diagnostics;
use bracket_codes::verdict::{self, Verdict};
use bracket_engine::certify::faces::contact_faces;
use bracket_engine::model::AnalysisModel;
use bracket_engine::solve::Patterns;
use bracket_report::console::log::Log;
use bracket_report::draw::polygon;
use bracket_report::markdown::report_data::ModelTraits;
use bracket_report::markdown::report_data::PictureRef;
use bracket_report::page::scene::Scene;
use bracket_report::result::demand::Demand;
use bracket_report::result::folder::ResultFolder;
use bracket_report::result::forces::static_forces;
use bracket_report::result::preload::mark_halved;
use bracket_report::result::result_file::CaseResult;
use bracket_report::result::result_file::Quantity;
use bracket_report::result::result_file::ResultFile;
use bracket_report::result::stiffness::joint_stiffness;
use std::sync::Arc;

/// Analyses the cases, writes fields, result and report, and logs the answer.
pub fn run_cases(
    cases: Vec<Case>,
    mut context: RunContext,
    limits: &Limits,
    folder: ResultFolder,
    log: &Arc<Log>,
) -> Result<Finished, Diagnostics> {
    cases.iter().try_for_each(refuse_idle)?;
    let symmetry = cases.first().map_or(1, |c| c.model.symmetry);
    let mut result = ResultFile::new(context.input_hash.clone(), symmetry, Verdict::None);
    result.warnings.clone_from(&context.checks.notes);
    let asked: Vec<String> = cases.iter().map(|c| c.name.clone()).collect();
    result.asked.clone_from(&asked);
    let mut analyses = Analyses {
        scene: Scene::new(&context.mirror),
        traits: ModelTraits { facets: true, symmetry: symmetry > 1, ..ModelTraits::default() },
        ..Analyses::default()
    };
    let stems = stems(&cases);
    let mut directions = Directions::among(&cases, context.polygon.as_ref());
    // the first mesh is the same for all cases
    let patterns = Patterns::default();
    let traits: Vec<_> = cases.iter().map(|c| (c.model_file.clone(), c.direction)).collect();
    let mut queue = Queue::new(cases, &patterns, context.coarser, limits, log);
    if let Some(time) = limits.time {
        queue.lower_bounds(time)?;
        queue.upper_bounds()?;
    }
    for (i, ((model_name, first), direction)) in traits.into_iter().enumerate() {
        if limits.interrupt.asked() && i > 0 && queue.untouched(i) {
            result.warnings.push(not_analysed(&asked[i..]));
            break;
        }
        let begun = queue.take(i)?;
        if let Some(model) = begun.model() {
            note_traits(model, &mut analyses);
        }
        let now = log.seconds();
        let until = limits
            .time
            .map_or(f64::INFINITY, |t| now + (t - now).max(0.0) / (asked.len() - i) as f64);
        let adapted = begun.end(until, &context, limits)?;
        let stem = stems[i].as_str();
        // the first mesh is `mesh.msh`; it stays where something else needs it
        let alone = asked.len() == 1 && !adapted.keeps_first_mesh();
        let mesh_name = if alone { "mesh.msh".into() } else { format!("mesh_{stem}.msh") };
        write_passes(&adapted, &first, [&model_name, &mesh_name], stem, &folder)?;
        let Adapted { mut entry, upper, lower, .. } = adapted;
        let best = lower.as_ref().unwrap_or(&upper);
        judge_case(&mut entry, &upper, direction.is_some(), &context);
        let maps = add_forces(&mut entry, best, &context, stem, &folder)?;
        if let Some((_, _, quality)) = &upper.made
            && analyses.pictures.is_empty()
        {
            context.mesh_quality = quality.clone();
        }
        let pictures = &mut analyses.pictures;
        // they take seconds on large meshes, and none of them is part of a certificate
        if !limits.interrupt.asked() {
            if pictures.is_empty() {
                pictures.extend(mesh_pictures(&upper.model, &context, &folder)?);
            }
            let names = (asked[i].as_str(), stem);
            pictures.extend(collapse_pictures(&upper, best, names, &context, &folder)?);
            let stress = lower_stress(&best.outcome, &entry);
            add_case(&mut analyses.scene, &asked[i], &upper, best, stress);
        }
        if !limits.interrupt.asked() {
            pictures.extend(deformed_picture(
                &upper.outcome,
                &asked[i],
                &upper.model,
                &context,
                stem,
                &folder,
            )?);
        }
        pictures.extend(maps);
        pictures.extend(convergence(&entry, context.adapt.map(|a| a.target_gap), stem, &folder)?);
        if let (Some(directions), Some(direction)) = (&mut directions, direction) {
            directions.add(direction, &entry, &upper);
        }
        result.cases.push(entry);
    }
    result.warnings.extend(without_bounds(&result.cases));
    result.polygon = directions.and_then(Directions::polygon);
    if let Some(polygon) = &result.polygon {
        folder.write("polygon.svg", polygon::drawing(polygon).as_bytes())?;
        let [a, b] = polygon.axes.each_ref().map(|a| a.action.as_str());
        analyses.pictures.insert(
            0,
            PictureRef { file: "polygon.svg".into(), caption: format!("Capacity in {a} and {b}") },
        );
    }
    analyses.interrupt = limits.interrupt.clone();
    finish(result, context, analyses, folder, log)
}

/// The warning about the analyses that ended without any bound.
fn without_bounds(cases: &[CaseResult]) -> Option<String> {
    let bare = cases.iter().filter(|c| c.lower.is_none() && c.upper.is_none());
    let named: Vec<String> = bare
        .map(|c| {
            let why = c.ended_by().map_or_else(String::new, |s| format!(", {s}"));
            format!("{} ({}{why})", c.name, c.analysis.word())
        })
        .collect();
    (!named.is_empty()).then(|| format!("not analysed, without any bound: {}", named.join("; ")))
}

/// Adds the traits and notes of a model to those of the run.
fn note_traits(model: &AnalysisModel, analyses: &mut Analyses) {
    let contacts = contact_faces(model);
    let traits = &mut analyses.traits;
    traits.contact |= !contacts.is_empty();
    traits.friction |= model.has_friction();
    traits.coulomb |= model.has_coulomb_friction();
    traits.preload |= model.has_preload();
    traits.initial_gap |= contacts.iter().any(|f| !f.law.gap.is_zero());
    for note in &model.notes {
        if !analyses.notes.contains(note) {
            analyses.notes.push(note.clone());
        }
    }
}

/// The warning about a joint whose bolts may break before its rows yield.
const NO_ROTATION: &str = "no rule of rotation capacity holds: the lower bound decides nothing, \
                           and plastic global analysis may not rely on the rotation of the joint \
                           (EN 1993-1-8:2005 6.4)";

/// Adds to an entry: a warning if a program did not fit into the memory, the utilisation, and the
/// demand of its load case.
fn judge_case(entry: &mut CaseResult, upper: &Kept, of_polygon: bool, context: &RunContext) {
    if upper.outcome.runs().iter().any(|(_, run)| run.refusal.is_some()) {
        entry.warnings.push(format!(
            "both bounds need {}, or more memory; `bounds` in a model file asks for one of them \
             alone",
            context.coarser
        ));
    }
    entry.utilisation = safe_utilisation(entry);
    let demand = context.input.demands.iter().find(|d| d.case == entry.name && !of_polygon);
    if let Some(demand) = demand {
        let actions = demand.actions.clone();
        let demand = Demand::new(entry, actions, &context.checks);
        if demand.brittle.is_some() {
            entry.warnings.push(NO_ROTATION.into());
        }
        entry.demand = Some(demand);
    }
}

/// Demand over capacity by the strict bounds of a load factor.
pub fn safe_utilisation(entry: &CaseResult) -> Option<[f64; 2]> {
    if entry.quantity != Quantity::LoadFactor {
        return None;
    }
    let (lower, upper) = entry.safe_bounds();
    verdict::utilisation(lower, upper)
}

/// Adds to an entry: preloads of halved bolts, the forces of the static field, and the stiffness of
/// the joint. Returns the pictures of the contact pressures.
fn add_forces(
    entry: &mut CaseResult,
    best: &Kept,
    context: &RunContext,
    stem: &str,
    folder: &ResultFolder,
) -> Result<Vec<PictureRef>, Diagnostics> {
    let RunContext { mirror, bolts, .. } = context;
    mark_halved(&mut entry.preload, &best.model, mirror);
    let mut maps = Vec::new();
    if let Some((stress, factor)) = lower_stress(&best.outcome, entry).filter(|_| !bolts.is_empty())
    {
        let forces = static_forces(&best.model, stress, factor, bolts, mirror);
        let names = (entry.name.as_str(), stem);
        maps = contact_pictures(&best.model, (stress, factor), &forces, mirror, names, folder)?;
        entry.static_forces = Some(forces);
    }
    entry.joint_stiffness = joint_stiffness(entry, &context.checks.moments);
    Ok(maps)
}
