//! Files of a case in the result folder: model, mesh and fields of the passes with the best bounds.

use crate::driver::adaptive::Adapted;
use crate::driver::passes::Kept;
use bracket_base::diag::{Diagnostic, Diagnostics};
use bracket_base::yaml;
use bracket_engine::analysis::dispatch::AnalysisPass;
use bracket_engine::analysis::limit;
use bracket_engine::certify::fields::DisplacementField;
use bracket_engine::certify::limit_certificate::dissipation_densities;
use bracket_engine::mesh::msh_write;
use bracket_engine::model::file::ModelFile;
use bracket_engine::model::{AnalysisKind, AnalysisModel};
use bracket_report::result::case_result::CaseResult;
use bracket_report::result::fields::field_files::{
    displacement_grid, lower_grid, shift_grid, stress_grid, velocity_grid, yielding_stress_grid,
};
use bracket_report::result::fields::plastic_file::plastic_grid;
use bracket_report::result::fields::route_files::{modes_grid, strain_grid};
use bracket_report::result::fields::vtu::VtuGrid;
use bracket_report::result::file_names::{DEAD_FIELD, LIVE_FIELD};
use bracket_report::result::folder::ResultFolder;

/// Writes models, meshes and fields of the passes with the best bounds. `first` is the model file
/// of the first mesh; `[model, mesh]` are the names of the model file and of the mesh file of a
/// mesh that is not the first.
pub fn write_passes(
    adapted: &Adapted,
    first: &ModelFile,
    [model, mesh]: [&str; 2],
    stem: &str,
    folder: &ResultFolder,
) -> Result<(), Diagnostics> {
    let Adapted { upper, lower, .. } = adapted;
    let frictionless = adapted.frictionless();
    let here = frictionless.is_none();
    write_model(upper, first, ["", model, mesh], folder)?;
    let statics = lower.is_none();
    write_fields(
        (&upper.outcome, &upper.model),
        (stem, ""),
        folder,
        [true, statics, statics && here],
    )?;
    // bounds on other meshes: their models are written beside their fields
    for (pass, kind, fields) in [
        (lower.as_ref(), "static", [false, true, here]),
        (frictionless, "static_frictionless", [false, false, true]),
    ] {
        let Some(pass) = pass else { continue };
        let [model, mesh] = ["yaml", "msh"].map(|end| format!("{stem}_{kind}.{end}"));
        write_model(pass, first, ["fields/", &model, &mesh], folder)?;
        write_fields((&pass.outcome, &pass.model), (stem, ""), folder, fields)?;
    }
    Ok(())
}

/// Writes the fields of the route of analysis: strains at the vertices of the model's mesh, and
/// buckling modes on it.
pub fn write_route(
    model: &AnalysisModel,
    (strains, modes): (Option<&[f64]>, &[DisplacementField]),
    (entry, stem): (&CaseResult, &str),
    folder: &ResultFolder,
) -> Result<(), Diagnostics> {
    let factors = entry.critical.as_ref().map_or(&[][..], |c| &c.fine);
    let strains = strains.map(|s| ("strain", strain_grid(model, s)));
    let modes = modes_grid(model, modes, factors).map(|grid| ("modes", grid));
    for (kind, grid) in strains.into_iter().chain(modes) {
        let bytes = grid.to_bytes().map_err(Diagnostic::from)?;
        folder.write(&format!("fields/{stem}_{kind}.vtu"), &bytes)?;
    }
    Ok(())
}

/// Writes the model file of a pass, and its mesh. The first mesh is in the folder already and is
/// not written again.
fn write_model(
    pass: &Kept,
    first: &ModelFile,
    [place, file, mesh]: [&str; 3],
    folder: &ResultFolder,
) -> Result<(), Diagnostics> {
    let text = match &pass.made {
        Some((tets, model, _)) => {
            folder.write(&format!("{place}{mesh}"), msh_write::text(tets).as_bytes())?;
            yaml::to_string(&ModelFile { mesh: mesh.into(), ..model.clone() })?
        }
        // the first mesh is one folder above the fields
        None if place.is_empty() => yaml::to_string(first)?,
        None => {
            yaml::to_string(&ModelFile { mesh: format!("../{}", first.mesh), ..first.clone() })?
        }
    };
    Ok(folder.write(&format!("{place}{file}"), text.as_bytes())?)
}

/// Writes the fields of the kinematic and of the static program, and of the static one without
/// friction, each only if requested; `suffix`: end of the file names of a load step.
pub fn write_fields(
    (pass, model): (&AnalysisPass, &AnalysisModel),
    (stem, suffix): (&str, &str),
    folder: &ResultFolder,
    [kinematic, statics, frictionless]: [bool; 3],
) -> Result<(), Diagnostics> {
    let write = |kind: &str, grid: VtuGrid| -> Result<(), Diagnostics> {
        let bytes = grid.to_bytes().map_err(Diagnostic::from)?;
        Ok(folder.write(&format!("fields/{stem}_{kind}{suffix}.vtu"), &bytes)?)
    };
    match pass {
        AnalysisPass::Energy(p) => {
            let contributions = p.contributions.as_ref().map(|c| &c.elements[..]);
            if let Some(u) = p.plastic.as_ref().filter(|_| kinematic) {
                write("kinematic", plastic_grid(model, u, contributions))?;
            } else if let Some(u) = p.displacement.as_ref().filter(|_| kinematic) {
                write("kinematic", displacement_grid(model, u, contributions))?;
            }
            if let Some(s) = p.stress.as_ref().filter(|_| statics) {
                let yields = model.analysis == AnalysisKind::Elastoplastic;
                write(
                    "static",
                    if yields { yielding_stress_grid(model, s) } else { stress_grid(model, s) },
                )?;
            }
            if !p.shift.faces.is_empty() {
                write("shift", shift_grid(model, &p.shift))?;
            }
        }
        AnalysisPass::Factor(p) => {
            if let Some(v) = p.velocity.as_ref().filter(|_| kinematic) {
                let densities = dissipation_densities(model, v, limit::SUBDIVISIONS);
                write("kinematic", velocity_grid(model, v, densities))?;
            }
            if let Some(free) = &p.free {
                let densities = vec![0.0; model.mesh.tets.len()];
                write("kinematic", velocity_grid(model, &free.field, densities))?;
            }
            if let Some(u) = &p.unlimited {
                write(LIVE_FIELD, stress_grid(model, &u.field))?;
                if let Some(dead) = &u.dead {
                    write(DEAD_FIELD, lower_grid(model, dead, 0.0))?;
                }
            }
            for (kind, asked, stress, bound) in [
                ("static", statics, &p.stress, &p.lower),
                ("static_frictionless", frictionless, &p.frictionless_stress, &p.frictionless),
            ] {
                if let (true, Some(s), Some(b)) = (asked, stress, bound) {
                    write(kind, lower_grid(model, s, b.certificate().factor))?;
                }
            }
        }
    }
    Ok(())
}
