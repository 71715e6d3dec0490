//! What the spec of a result says about the result as a whole: its cases, symmetry, meshes, models
//! and polygon, and the hash of its input.

use crate::driver::case::not_analysed;
use crate::driver::combinations::{actions_of, groups};
use crate::driver::input_hash::{checked_hash, spec_hash};
use crate::driver::meshing::Extent;
use crate::driver::overrides::{COMMAND_LINE, KIND, SIZE_FACTOR};
use crate::driver::solve::refused;
use crate::driver::spec_cases::{AskedCase, asked_cases};
use crate::driver::spec_checks::analysis_kinds;
use crate::driver::spec_file::SpecFile;
use crate::driver::verify_mesh::{Meshes, mesh_path, model_paths, read_model};
use bracket_base::diag::Diagnostics;
use bracket_base::yaml;
use bracket_engine::certify::half_space::Actions;
use bracket_engine::mesh::msh;
use bracket_engine::model::AnalysisKind;
use bracket_engine::model::file::ModelFile;
use bracket_joint::geometry::Scene;
use bracket_joint::spec::polygon::PolygonSpec;
use bracket_report::markdown::report_data::ReportData;
use bracket_report::result::case_result::CaseResult;
use bracket_report::result::demand::ActionValue;
use bracket_report::result::file_names::entry_stem;
use bracket_report::result::proved_by::Direction;
use bracket_report::result::result_file::ResultFile;
use bracket_report::result::verify::first_difference;
use serde_json::{Value, json};
use std::path::Path;

/// The meshed part of the joint of a result: the whole joint if the result has one copy of it.
fn scene<'a>(spec: &'a SpecFile, result: &ResultFile) -> Scene<'a> {
    Scene::new(&spec.joint.assembly, result.symmetry == 1)
}

/// Axes of the planes of symmetry that a result uses.
pub fn mirror(spec: &SpecFile, result: &ResultFile) -> Vec<usize> {
    scene(spec, result).symmetry.iter().map(|p| p.axis).collect()
}

/// Every kind of analysis.
const KINDS: [AnalysisKind; 3] =
    [AnalysisKind::Elastic, AnalysisKind::Elastoplastic, AnalysisKind::Limit];

/// The analyses that a run was asked for: by its spec, and by the options that the report names.
struct Asked<'a> {
    kinds: Vec<AnalysisKind>,
    size_factor: f64,
    polygon: Option<&'a PolygonSpec>,
    cases: Vec<AskedCase>,
}

impl<'a> Asked<'a> {
    fn new(spec: &'a SpecFile, data: &ReportData) -> Result<Self, Diagnostics> {
        let option = |name: &str| {
            let mut given = data.input.resolved.iter();
            given.find(|r| r.name == name && r.origin == COMMAND_LINE).map(|r| r.value.to_string())
        };
        let word = option(KIND);
        let kinds = match word {
            // a word of no kind leaves no case, which the comparison refutes
            Some(ref word) => {
                let kind = KINDS.into_iter().find(|k| k.word() == word);
                kind.map_or_else(Vec::new, |kind| spec.kinds_for(kind))
            }
            None => analysis_kinds(spec)?,
        };
        let limit = word.is_none() || kinds.first() == Some(&AnalysisKind::Limit);
        let polygon = spec.spec.value.polygon.as_ref().filter(|_| limit);
        let cases = asked_cases(spec, &kinds, polygon);
        let size_factor = option(SIZE_FACTOR).and_then(|f| f.parse().ok()).unwrap_or(1.0);
        Ok(Self { kinds, size_factor, polygon, cases })
    }
}

/// Sentences about what the spec gives otherwise.
pub fn frame_differences(
    folder: &Path,
    result: &ResultFile,
    spec: &SpecFile,
    data: &ReportData,
) -> Vec<String> {
    let found = if result.asked.is_empty() && result.cases.is_empty() {
        checks_alone(folder, result, spec)
    } else {
        Asked::new(spec, data).and_then(|asked| of_run(folder, result, spec, &asked))
    };
    found.unwrap_or_else(|faults| vec![faults.into_first().message])
}

/// Differences of a result without analyses.
fn checks_alone(
    folder: &Path,
    result: &ResultFile,
    spec: &SpecFile,
) -> Result<Vec<String>, Diagnostics> {
    let mut out = Vec::new();
    if folder.join("model.yaml").exists() {
        out.push("there is a model, and `asked` names no analysis".to_owned());
    }
    let hash = checked_hash(spec)?;
    let given = [json!(result.symmetry), json!(result.input_hash), json!(result.polygon)];
    let found = [json!(1), json!(hash), json!(null)];
    for ((given, found), name) in
        given.iter().zip(&found).zip(["symmetry", "input_hash", "polygon"])
    {
        out.extend(first_difference(given, found, name));
    }
    Ok(out)
}

/// Differences of a result with analyses.
fn of_run(
    folder: &Path,
    result: &ResultFile,
    spec: &SpecFile,
    asked: &Asked<'_>,
) -> Result<Vec<String>, Diagnostics> {
    let scene = scene(spec, result);
    let mut out = Vec::new();
    let mut pair = |given: &Value, found: &Value, name: &str| {
        out.extend(first_difference(given, found, name));
    };
    let names: Vec<&String> = asked.cases.iter().map(|c| &c.of.case).collect();
    pair(&json!(result.asked), &json!(names), "asked");
    // what a run leaves out that asks for a verdict alone
    let decide = spec.decide;
    let of = |c: &&AskedCase| (c.of.case.clone(), c.of.kind);
    let directions = directions(result, spec);
    let made: Vec<&AskedCase> = asked
        .cases
        .iter()
        .filter(|c| !(decide && refused(&result.cases, &of(c))))
        .chain(&directions)
        .collect();
    let count = result.cases.len().min(made.len());
    let entries: Vec<_> = result.cases.iter().map(|c| (&c.name, c.analysis)).collect();
    let wanted: Vec<_> = made[..count].iter().map(|c| (&c.of.case, c.of.kind)).collect();
    pair(&json!(entries), &json!(wanted), "cases: name and analysis");
    pair(&json!(result.symmetry), &json!(scene.copies()), "symmetry");
    if let Some(next) = made.get(count) {
        let first = asked.cases.iter().position(|c| std::ptr::eq(c, *next)).unwrap_or(0);
        let missing: Vec<String> = names[first..].iter().map(|n| n.to_string()).collect();
        if !result.warnings.contains(&not_analysed(&missing)) {
            out.push(format!("`cases` lacks {}, and no warning says why", missing.join(", ")));
        }
    }
    out.extend(polygon_differences(result, asked));
    let mut meshes = Meshes::new(&scene);
    for (i, case) in result.cases.iter().enumerate().filter(|(_, c)| c.proved_by.is_none()) {
        let stem = entry_stem(&result.cases[..i], case);
        let of_case = made.iter().find(|c| c.of.case == case.name && c.of.kind == case.analysis);
        let Some(of_case) = of_case else { continue };
        match meshes.models_differ(folder, &stem, of_case, spec) {
            Ok(found) => out.extend(found),
            Err(faults) => out.push(format!("{}: {}", case.name, faults.into_first().message)),
        }
    }
    if let Some(mesh) = meshes.any() {
        let model = |c: &AskedCase| c.model_file(spec, mesh, &scene.symmetry);
        out.extend(proof_differences(result, spec.covers(&asked.kinds), &made, &model));
        let models =
            asked.cases.iter().map(|c| yaml::to_string(&c.model_file(spec, mesh, &scene.symmetry)));
        let models = models.collect::<Result<Vec<_>, _>>()?;
        let extent = Extent { full: result.symmetry == 1, size_factor: asked.size_factor };
        let hash = spec_hash(spec, &asked.kinds, extent, &models);
        out.extend(first_difference(&json!(result.input_hash), &json!(hash), "input_hash"));
    }
    Ok(out)
}

/// The directions that a result has analysed beside its load cases.
fn directions(result: &ResultFile, spec: &SpecFile) -> Vec<AskedCase> {
    let of = |d: &Direction| AskedCase {
        like: Some((d.like.clone(), d.actions.clone())),
        ..AskedCase::limit(spec, &d.name)
    };
    result.directions.iter().map(of).collect()
}

/// Differences of the load cases without an analysis of their own: each must have the model of the
/// analyses that prove its bounds, but for the actions.
fn proof_differences(
    result: &ResultFile,
    covers: bool,
    made: &[&AskedCase],
    model: &dyn Fn(&AskedCase) -> ModelFile,
) -> Vec<String> {
    let derived = result.cases.iter().filter_map(|c| Some((c, c.proved_by.as_ref()?)));
    let of = |name: &String| made.iter().find(|c| c.of.case == *name).map(|c| model(c));
    let mut out = Vec::new();
    for (case, proved_by) in derived {
        if !covers {
            out.push(format!("{}: the spec asks for its analysis", case.name));
        }
        let used = proved_by.lower.iter().map(|w| &w.analysis).chain(&proved_by.upper);
        for name in used {
            let pair = of(&case.name).zip(of(name)).map(|(a, b)| groups(&[a, b]).len());
            if pair != Some(1) {
                out.push(format!("{}: {name} has another model than it", case.name));
            }
        }
    }
    out
}

/// The actions of the load cases whose bounds come from analyses of others.
pub fn actions_of_cases(
    folder: &Path,
    result: &ResultFile,
    spec: &SpecFile,
) -> Result<Vec<(String, Actions)>, Diagnostics> {
    let derived = || result.cases.iter().filter(|c| c.proved_by.is_some());
    let run = result.cases.iter().position(|c| c.proved_by.is_none());
    let Some(run) = run.filter(|_| derived().next().is_some()) else { return Ok(Vec::new()) };
    let stem = entry_stem(&result.cases[..run], &result.cases[run]);
    let path = model_paths(folder, &stem).swap_remove(0);
    let mesh = msh::read(&mesh_path(&path, &read_model(&path)?))?;
    let planes = scene(spec, result).symmetry;
    let of = |c: &CaseResult| {
        let file = AskedCase::limit(spec, &c.name).model_file(spec, &mesh, &planes);
        (c.name.clone(), actions_of(&file))
    };
    Ok(derived().map(of).collect())
}

/// Differences of the polygon's names, axes and directions. Its numbers follow from the fields.
fn polygon_differences(result: &ResultFile, asked: &Asked<'_>) -> Vec<String> {
    let wanted = asked.polygon.and_then(|p| Some((p, p.axes()?)));
    let (claimed, (spec, axes)) = match (&result.polygon, wanted) {
        (None, None) => return Vec::new(),
        (Some(claimed), Some(wanted)) => (claimed, wanted),
        (Some(_), None) => return vec!["polygon: the spec asks for none".into()],
        (None, Some(_)) => return vec!["polygon is missing".into()],
    };
    let axes = axes.map(|(action, size)| {
        let unit = ActionValue::of(action, size);
        json!({"action": action.word(), "unit": unit})
    });
    let analysed = |c: &&AskedCase| result.cases.iter().any(|r| r.name == c.of.case);
    let directions = asked.cases.iter().filter(|c| c.direction.is_some()).filter(analysed);
    let directions: Vec<_> = directions.map(|c| (&c.of.case, c.direction)).collect();
    let given: Vec<_> = claimed.points.iter().map(|p| (&p.case, p.direction)).collect();
    let pairs = [
        ("polygon.end", json!(claimed.end), json!(spec.end)),
        ("polygon.at", json!(claimed.at), json!(spec.at.word())),
        ("polygon.axes", json!(claimed.axes), json!(axes)),
        ("polygon.points: case and direction", json!(given), json!(directions)),
    ];
    pairs.into_iter().filter_map(|(name, a, b)| first_difference(&a, &b, name)).collect()
}
