//! What the model file of a result gives beside its bounds.

use crate::checks::verdict::Verdict;
use crate::driver::input_hash::model_hash;
use crate::driver::run_cases::safe_utilisation;
use crate::driver::verify_mesh::{model_paths, read_model};
use crate::driver::verify_spec::compared;
use crate::model::file::{ModelFile, Nodes};
use crate::report::markdown::report_data::ReportData;
use crate::result::case_result::CaseResult;
use crate::result::file_names::file_stem;
use crate::result::result_file::ResultFile;
use crate::result::verify::first_difference;
use serde_json::json;
use std::path::Path;

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
    let stem = Path::new(&data.input_name).file_stem().map(|s| file_stem(&s.to_string_lossy()));
    let name = stem.filter(|s| s != "model").unwrap_or_else(|| case.name.clone());
    out.extend(first_difference(
        &json!([&case.name, asked]),
        &json!([name, name]),
        "asked and name",
    ));
    let kinds = [case.analysis, file.analysis].map(|k| json!(k));
    out.extend(first_difference(&kinds[0], &kinds[1], &format!("{}: analysis", case.name)));
    for path in model_paths(folder, &file_stem(&case.name)) {
        match read_model(&path) {
            Ok(stored) => out.extend(model_difference(&stored, file, case, &path)),
            Err(faults) => out.push(faults.into_first().message),
        }
    }
    out.extend(hash_difference(folder, result, data, case));
    out
}

/// The difference between a stored model and that of the input.
fn model_difference(
    stored: &ModelFile,
    given: &ModelFile,
    case: &CaseResult,
    path: &Path,
) -> Option<String> {
    let mut wanted = ModelFile { mesh: stored.mesh.clone(), ..given.clone() };
    // the nodes of a refined mesh are shared
    if case.history.len() > 1 && stored.nodes == Nodes::Shared {
        wanted.nodes = Nodes::Shared;
    }
    let place = path.file_name().unwrap_or_default().to_string_lossy();
    first_difference(&json!(stored), &json!(wanted), &place)
}

/// The difference of the hash of the input. After refinement `mesh.msh` may be another mesh than
/// that of the input.
fn hash_difference(
    folder: &Path,
    result: &ResultFile,
    data: &ReportData,
    case: &CaseResult,
) -> Option<String> {
    let Ok(mesh) = std::fs::read(folder.join("mesh.msh")) else {
        return Some("mesh.msh cannot be read".into());
    };
    let found = model_hash(&data.input_text, &mesh);
    let refined = case.history.len() > 1;
    if refined {
        None
    } else {
        first_difference(&json!(result.input_hash), &json!(found), "input_hash")
    }
}
