//! What the model file of a result gives beside its bounds.

use crate::driver::analyse_model::GIVEN_MESH;
use crate::driver::input_hash::model_hash;
use crate::driver::judge::safe_utilisation;
use crate::driver::verify_mesh::{mesh_path, model_paths, read_model};
use crate::driver::verify_spec::compared;
use bracket_base::diag::Diagnostics;
use bracket_base::text_file;
use bracket_codes::verdict::Verdict;
use bracket_engine::mesh::merge::merge_coincident;
use bracket_engine::mesh::msh;
use bracket_engine::mesh::shape::Shape;
use bracket_engine::model::file::{ModelFile, Nodes};
use bracket_report::markdown::report_data::ReportData;
use bracket_report::result::file_names::file_stem;
use bracket_report::result::result_file::ResultFile;
use bracket_report::result::verify::first_difference;
use serde_json::json;
use std::path::{Path, PathBuf};

/// Differences of a result of a model file, which has one case, no checks and no demand.
pub fn of_model(
    folder: &Path,
    result: &ResultFile,
    file: &ModelFile,
    data: &ReportData,
) -> Vec<String> {
    let mut again = result.clone();
    for case in &mut again.cases {
        case.utilisation = safe_utilisation(case);
        case.demand = None;
        case.joint_stiffness = None;
    }
    (again.verdict, again.judgement) = (Verdict::None, None);
    again.checks.clear();
    let mut out = compared(result, &again);
    out.extend(first_difference(&json!(result.symmetry), &json!(file.symmetry), "symmetry"));
    out.extend(first_difference(&json!(result.polygon), &json!(null), "polygon"));
    let ([case], [asked]) = (&result.cases[..], &result.asked[..]) else {
        out.push("the analysis of a model has one entry in `asked` and one in `cases`".into());
        return out;
    };
    // a file called model.yaml gives its case the name of its folder, which the result lacks
    let stem = Path::new(&data.input.name).file_stem().map(|s| file_stem(&s.to_string_lossy()));
    let name = stem.filter(|s| s != "model").unwrap_or_else(|| case.name.clone());
    out.extend(first_difference(
        &json!([&case.name, asked]),
        &json!([name, name]),
        "asked and name",
    ));
    let kinds = [case.analysis, file.analysis].map(|k| json!(k));
    out.extend(first_difference(&kinds[0], &kinds[1], &format!("{}: analysis", case.name)));
    if case.history.len() > 1 && file.adapt.is_none() {
        out.push("`history` has several meshes, and the model asks for one".into());
    }
    let mut meshes = Vec::new();
    for path in model_paths(folder, &file_stem(&case.name)) {
        match read_model(&path) {
            Ok(stored) => {
                out.extend(model_difference(&stored, file, &path));
                meshes.push(mesh_path(&path, &stored));
            }
            Err(faults) => out.push(faults.into_first().message),
        }
    }
    let given =
        if file.adapt.is_some() { Some(folder.join(GIVEN_MESH)) } else { meshes.first().cloned() };
    out.extend(given.and_then(|given| hash_difference(&given, result, data)));
    if file.adapt.is_some() {
        out.extend(shapes_differ(&folder.join(GIVEN_MESH), &meshes));
    }
    out
}

/// Differences between the bodies and faces of the mesh of the input and those of the meshes that
/// adaptation made of it.
fn shapes_differ(given: &Path, meshes: &[PathBuf]) -> Vec<String> {
    // adaptation starts from nodes that the bodies share
    let shape = |path: &Path| -> Result<Shape, Diagnostics> {
        let mut mesh = msh::read(path)?;
        merge_coincident(&mut mesh)?;
        Ok(Shape::of(&mesh))
    };
    let given = match shape(given) {
        Ok(shape) => shape,
        Err(faults) => return vec![faults.into_first().message],
    };
    let difference = |path: &PathBuf| match shape(path) {
        Ok(found) => given.difference(&found).map(|what| {
            let name = path.file_name().unwrap_or_default().to_string_lossy();
            format!("{name}: {what} is not that of the mesh of the input")
        }),
        Err(faults) => Some(faults.into_first().message),
    };
    meshes.iter().filter_map(difference).collect()
}

/// The difference between a stored model and that of the input.
fn model_difference(stored: &ModelFile, given: &ModelFile, path: &Path) -> Option<String> {
    let mut wanted = ModelFile { mesh: stored.mesh.clone(), ..given.clone() };
    // the nodes of a refined mesh are shared
    if given.adapt.is_some() && stored.nodes == Nodes::Shared {
        wanted.nodes = Nodes::Shared;
    }
    let place = path.file_name().unwrap_or_default().to_string_lossy();
    first_difference(&json!(stored), &json!(wanted), &place)
}

/// The difference of the hash of the input, which contains the given mesh.
fn hash_difference(given: &Path, result: &ResultFile, data: &ReportData) -> Option<String> {
    let Ok(mesh) = text_file::bytes(given) else {
        return Some(format!("{} cannot be read", given.display()));
    };
    let found = model_hash(&data.input.text, &mesh);
    first_difference(&json!(result.input_hash), &json!(found), "input_hash")
}
