//! Recomputation of the certificate of a finished result from its stored fields and meshes alone.

mod case_files;
mod combinations;
mod derived;
mod differences;
mod energy;
mod factor;
mod finding;
mod grids;
mod history;
mod json_difference;
mod load_steps;
mod measured;

use crate::result::combine::{PassResult, join};
use crate::result::derived_bounds::Run;
use crate::result::energy_case::energy_bounds;
use crate::result::file_names::entry_stem;
use crate::result::limit_case::factor_bounds;
use crate::result::preload::mark_halved;
use crate::result::result_file::CaseResult;
use crate::result::result_file::FrictionModel;
use crate::result::result_file::ResultFile;
use bracket_base::diag::Diagnostics;
use bracket_engine::analysis::energy_pass::EnergyPass;
use bracket_engine::certify::{FactorBracket, UpperFactor};
use bracket_engine::model::resolve::load_model;
use bracket_engine::model::{AnalysisKind, AnalysisModel};
use case_files::CaseFiles;
pub use case_files::read;
use combinations::{proof_difference, runs};
pub use derived::Reference;
use derived::{Proved, case_differences, polygon_differences};
use differences::derived_differences;
pub use finding::Finding;
use history::{MeshSizes, history_differences};
pub use json_difference::first_difference;
use load_steps::verify_steps;
use measured::measured_differences;
use std::path::Path;

/// The outcome of a verification.
pub struct Verification {
    /// Every claimed bound.
    pub findings: Vec<Finding>,
    /// Sentences for the other claims that are refuted.
    pub refuted: Vec<String>,
}

/// Verifies the bounds of the result in a folder and what follows from them. `reference`: what the
/// input gives; without it, nothing that depends on it is compared.
pub fn verify(
    folder: &Path,
    result: &ResultFile,
    reference: Option<&Reference>,
) -> Result<Verification, Diagnostics> {
    let mut findings = Vec::new();
    let mut refuted = Vec::new();
    let mut proved = Vec::new();
    let derived = || result.cases.iter().filter(|c| c.proved_by.is_some());
    let keeps = result.polygon.is_some() || derived().next().is_some();
    let analysed = |c: &(usize, &CaseResult)| c.1.proved_by.is_none();
    for (i, case) in result.cases.iter().enumerate().filter(analysed) {
        let stem = entry_stem(&result.cases[..i], case);
        let (found, (other, of_case)) =
            verify_case(folder, case, &stem, result.symmetry, reference)?;
        findings.extend(found);
        refuted.extend(other);
        if let Some(of_case) = of_case {
            refuted.extend(reference.iter().flat_map(|r| case_differences(case, &of_case, r)));
            proved.extend(keeps.then_some(of_case));
        }
    }
    refuted.extend(result.polygon.iter().flat_map(|claimed| polygon_differences(claimed, &proved)));
    let runs: Vec<Run> = if derived().next().is_some() { runs(&proved) } else { Vec::new() };
    refuted.extend(derived().filter_map(|c| proof_difference(c, &runs, reference)));
    Ok(Verification { findings, refuted })
}

/// Sentences about the differences, and the results that the files of a case have proved.
type Confirmed = (Vec<String>, Option<Proved>);

/// Recomputes the bounds of a case and everything derived from them.
fn verify_case(
    folder: &Path,
    case: &CaseResult,
    stem: &str,
    symmetry: u32,
    reference: Option<&Reference>,
) -> Result<(Vec<Finding>, Confirmed), Diagnostics> {
    let own = folder.join(format!("model_{stem}.yaml"));
    let model = load_model(&if own.exists() { own } else { folder.join("model.yaml") })?;
    // if the better lower bound is on another mesh, that mesh is stored beside its field
    let beside = folder.join("fields").join(format!("{stem}_static.yaml"));
    let other = if beside.exists() { Some(load_model(&beside)?) } else { None };
    let smooth = folder.join("fields").join(format!("{stem}_static_frictionless.yaml"));
    let here = !smooth.exists();
    let mut refuted = Vec::new();
    let mut findings = Vec::new();
    let mut found: Option<PassResult> = None;
    let (mut mechanism, mut carried) = (None, None);
    let mut energies: Vec<(AnalysisModel, EnergyPass)> = Vec::new();
    let sides = match &other {
        None => vec![(&model, [true, true, here])],
        Some(other) => vec![(&model, [true, false, false]), (other, [false, true, here])],
    };
    for (model, wanted) in sides {
        if symmetry != model.symmetry {
            refuted.push(format!(
                "the result claims symmetry {symmetry}, its model has {}",
                model.symmetry
            ));
        }
        let files = CaseFiles { model, case, folder, stem, suffix: "", wanted };
        let (new, side) = match model.analysis {
            AnalysisKind::Limit => {
                let (new, entry, pass) = files.factors(&mut refuted)?;
                let bounds = factor_bounds(&pass, entry.problem);
                let answers = pass.carried(case.problem == FrictionModel::Coulomb);
                let of_answer =
                    answers.map(|(s, b)| (model.clone(), s.clone(), b.certificate().factor));
                carried = of_answer.or(carried);
                let free = pass.free.map(|f| (f.field, UpperFactor::new(f.certificate)));
                mechanism = pass.velocity.zip(pass.upper).or(free).or(mechanism);
                (new, PassResult { entry, bounds })
            }
            _ => {
                let (new, entry, pass) = files.energies(&mut refuted)?;
                let bounds = energy_bounds(&pass);
                let stress = pass.stress.clone();
                carried = stress.map(|s| (model.clone(), s, 1.0)).or(carried);
                energies.push((model.clone(), pass));
                (new, PassResult { entry, bounds })
            }
        };
        findings.extend(new);
        found = Some(match found {
            None => side,
            Some(mut upper) => {
                match join(upper.clone(), side) {
                    Ok(joined) => upper.entry = joined,
                    Err(e) => refuted.push(format!("{}: {e}", case.name)),
                }
                upper
            }
        });
    }
    if !here && let Some(found) = &mut found {
        let model = load_model(&smooth)?;
        let files = CaseFiles {
            model: &model,
            case,
            folder,
            stem,
            suffix: "",
            wanted: [false, false, true],
        };
        let (new, entry, pass) = files.factors(&mut refuted)?;
        findings.extend(new);
        if let (Some(lower), Some((_, upper))) = (pass.frictionless, &mechanism)
            && let Err(e) = FactorBracket::new(lower, upper.clone())
        {
            refuted.push(format!("{}: {e}", case.name));
        }
        found.entry.frictionless = entry.frictionless;
    }
    let Some(PassResult { mut entry, .. }) = found else { return Ok((findings, (refuted, None))) };
    let measured = measured_differences(case, &energies, reference);
    refuted.extend(measured.map(|what| format!("{}: {what}", case.name)));
    if let Some(Reference { mirror, .. }) = reference {
        mark_halved(&mut entry.preload, other.as_ref().unwrap_or(&model), mirror);
    }
    findings.extend(verify_steps((folder, stem), case, &model, reference, &mut refuted)?);
    refuted.extend(derived_differences(case, &entry));
    let (upper, lower) = (MeshSizes::of(&model), other.as_ref().map(MeshSizes::of));
    refuted.extend(history_differences(case, &entry, (&upper, lower.as_ref()), model.bounds));
    Ok((findings, (refuted, Some(Proved { entry, model, mechanism, stress: carried }))))
}
