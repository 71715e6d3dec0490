//! The verification of a result folder: its digests, the bounds from their fields, and what follows
//! from the input.

use crate::driver::spec_file::{self, SpecFile};
use crate::driver::verify_cases::{actions_of_cases, frame_differences, mirror};
use crate::driver::verify_mesh::{mesh_path, model_paths, read_model};
use crate::driver::verify_model::of_model;
use crate::driver::verify_spec::of_spec;
use bracket_base::diag::{Diagnostic, Diagnostics};
use bracket_base::yaml;
use bracket_engine::model::AnalysisKind;
use bracket_engine::model::file::ModelFile;
use bracket_joint::assembly::assembly::SymmetryPlane;
use bracket_report::markdown::report_data::{REPORT_DATA_FILE, ReportData};
use bracket_report::result::digests::{self, DIGESTS_FILE, Digests};
use bracket_report::result::evidence::EvidencePlan;
use bracket_report::result::file_names::entry_stem;
use bracket_report::result::result_file::{RESULT_FILE, ResultFile};
use bracket_report::result::verify::{self, Finding, Reference};
use serde_json::Value;
use std::collections::BTreeSet;
use std::path::{Component, Path};

/// Keys of `result.json` whose values no file of a result proves, as `docs/results.md` lists them.
/// `[]` stands for every entry of a list; the keys below a listed one are recorded too.
pub const RECORDED: [&str; 14] = [
    "tool.version",
    "warnings",
    "cases[].warnings",
    "cases[].coulomb_estimate",
    "cases[].fixed_point",
    "cases[].evidence_before",
    "cases[].critical_unknown",
    "cases[].history[].kinematic",
    "cases[].history[].static",
    "cases[].history[].static_frictionless",
    "cases[].history[].seconds",
    "cases[].history[].mesh_seconds",
    "cases[].history[].peak_memory_mib",
    "cases[].history[].predicted",
];

/// What else is recorded, in words.
const RECORDED_TOO: [&str; 5] = [
    "digits of `certificate` below 1e-13",
    "of `history`: sizes and gaps of meshes without a best bound, `so_far` where it is not strict",
    "an upper bound `unbounded` that is not strict",
    "the name of the case of a `model.yaml`, which is that of its folder",
    "reports, pictures and drawings, the fields `strain` and `modes` that pictures are made from; \
     all of report.json but the input",
];

/// The outcome of the verification of a folder.
pub struct Verified {
    /// Every claimed bound.
    pub bounds: Vec<Finding>,
    /// Sentences for the other claims that are refuted.
    pub refuted: Vec<String>,
    /// What was computed again and agrees, unless a sentence of `refuted` says otherwise.
    pub recomputed: Vec<String>,
    /// What stands in the result as the run wrote it: only the digests show that nobody has changed
    /// it since.
    pub recorded: Vec<String>,
}

impl Verified {
    /// True if every claim is confirmed.
    pub fn confirmed(&self) -> bool {
        self.bounds.iter().all(|f| f.confirmed) && self.refuted.is_empty()
    }
}

/// The input of a result, as the folder has it.
enum Input {
    Model(Box<ModelFile>, Box<ReportData>),
    Spec(Box<SpecFile>, Box<ReportData>),
    /// It cannot be read, for this reason.
    Lost(String),
}

/// Verifies the result in a folder.
pub fn verify_folder(folder: &Path) -> Result<Verified, Diagnostics> {
    let text = verify::read(&folder.join(RESULT_FILE))?;
    let result =
        ResultFile::from_json(&String::from_utf8_lossy(&text)).map_err(Diagnostic::from)?;
    let input = input(folder);
    let mut refuted = differences_of_digests(folder, &result);
    refuted.extend(unknown_keys(&text, &result));
    let reference = match &input {
        Input::Model(..) => Some(Reference::default()),
        Input::Spec(spec, _) => {
            let (bolts, mirror) = (spec.joint.bolts.clone(), mirror(spec, &result));
            let planes: Vec<SymmetryPlane> =
                mirror.iter().map(|&axis| SymmetryPlane { axis }).collect();
            let measured = spec.elastic_bolts(AnalysisKind::Elastoplastic);
            let evidence = measured.then(|| EvidencePlan::new(&spec.joint, &planes));
            let load_steps = spec.spec.value.analysis.load_steps.clone();
            let actions = actions_of_cases(folder, &result, spec)?;
            Some(Reference { bolts, mirror, evidence, load_steps, actions })
        }
        Input::Lost(_) => None,
    };
    let verification = verify::verify(folder, &result, reference.as_ref())?;
    let bounds = verification.findings;
    refuted.extend(verification.refuted);
    let mut recomputed = Vec::new();
    if !bounds.is_empty() {
        recomputed.push("the bounds and what follows from their fields".into());
    }
    match &input {
        Input::Model(file, data) => {
            refuted.extend(of_model(folder, &result, file, data));
            let what = "the model, from the input; `input_hash`, from model and mesh; a model has \
                        no demand";
            recomputed.push(what.into());
        }
        Input::Spec(spec, data) => {
            refuted.extend(frame_differences(folder, &result, spec, data));
            refuted.extend(of_spec(&result, spec));
            let what = if result.cases.is_empty() {
                "`checks`, demands and verdicts, from the spec"
            } else {
                "the models, `checks`, demands and verdicts, from the spec; the meshes, compared \
                 with its solids"
            };
            recomputed.push(what.into());
        }
        // who takes the input away could forge everything that follows from it
        Input::Lost(why) => refuted.push(format!(
            "the input cannot be read ({why}): models, checks, demands and verdicts are not \
             confirmed"
        )),
    }
    let keys = format!("the keys {}", RECORDED.map(|key| format!("`{key}`")).join(", "));
    let mut recorded: Vec<String> =
        [keys].into_iter().chain(RECORDED_TOO.map(String::from)).collect();
    if result.cases.is_empty() && !result.asked.is_empty() {
        recorded.push("`input_hash`, because no case is finished".into());
    }
    Ok(Verified { bounds, refuted, recomputed, recorded })
}

/// Reads the input of a result: a spec with its templates and tables, or a model file.
fn input(folder: &Path) -> Input {
    let lost = |faults: Diagnostics| Input::Lost(faults.into_first().message);
    let data = match ReportData::read(folder) {
        Ok(data) => Box::new(data),
        Err(faults) => return lost(faults),
    };
    if data.input.text.trim().is_empty() {
        return Input::Lost(format!("`{REPORT_DATA_FILE}` has none"));
    }
    let path = folder.join(&data.input.name);
    if let Ok(model) = yaml::parse::<ModelFile>(&data.input.text, &path) {
        return Input::Model(Box::new(model.value), data);
    }
    match spec_file::stored(&data.input.text, &data.input.name, folder) {
        Ok(spec) => Input::Spec(Box::new(spec), data),
        Err(faults) => lost(faults),
    }
}

/// A sentence about a key of `result.json` that no result has.
fn unknown_keys(text: &[u8], result: &ResultFile) -> Option<String> {
    let given: Value = serde_json::from_slice(text).ok()?;
    let key = first_unknown(&given, &serde_json::to_value(result).ok()?, "")?;
    Some(format!("`{key}` is no key of {RESULT_FILE}"))
}

/// Path of the first key of `given` that `known` lacks.
fn first_unknown(given: &Value, known: &Value, place: &str) -> Option<String> {
    match (given, known) {
        (Value::Object(given), Value::Object(known)) => given.iter().find_map(|(key, value)| {
            let path = if place.is_empty() { key.clone() } else { format!("{place}.{key}") };
            match known.get(key) {
                Some(known) => first_unknown(value, known, &path),
                // a value that was not computed may be written as null
                None => (!value.is_null()).then_some(path),
            }
        }),
        (Value::Array(given), Value::Array(known)) => {
            let mut pairs = given.iter().zip(known).enumerate();
            pairs.find_map(|(i, (a, b))| first_unknown(a, b, &format!("{place}[{i}]")))
        }
        (Value::Array(_) | Value::Object(_), _) => Some(place.into()),
        _ => None,
    }
}

/// Sentences about the files that are not those of the run.
fn differences_of_digests(folder: &Path, result: &ResultFile) -> Vec<String> {
    match Digests::read(folder) {
        Ok(Some(digests)) => {
            let mut out = digests.differences(folder);
            let files = files_of(folder, result);
            let lost = files.iter().filter(|name| !digests.lists(name));
            out.extend(lost.map(|name| format!("{DIGESTS_FILE} does not list {name}")));
            out
        }
        Ok(None) => vec![format!(
            "{DIGESTS_FILE} is missing: nothing shows that the recorded values are those of the run"
        )],
        Err(e) => vec![format!("{DIGESTS_FILE} cannot be read: {e}")],
    }
}

/// Names of the files that a verification reads.
fn files_of(folder: &Path, result: &ResultFile) -> BTreeSet<String> {
    let mut out = BTreeSet::from([RESULT_FILE.to_owned(), REPORT_DATA_FILE.to_owned()]);
    let kept = |name: &String| name.starts_with("fields/") || name.starts_with("input/");
    out.extend(digests::files(folder).unwrap_or_default().into_iter().filter(kept));
    for (i, case) in result.cases.iter().enumerate() {
        for path in model_paths(folder, &entry_stem(&result.cases[..i], case)) {
            out.extend(name_within(folder, &path));
            if let Ok(model) = read_model(&path) {
                let mesh = mesh_path(&path, &model);
                out.insert(name_within(folder, &mesh).unwrap_or(model.mesh));
            }
        }
    }
    out
}

/// The name of a file relative to the folder, as the digests list it; `None` outside the folder.
fn name_within(folder: &Path, path: &Path) -> Option<String> {
    let mut names: Vec<String> = Vec::new();
    for part in path.strip_prefix(folder).ok()?.components() {
        match part {
            Component::Normal(name) => names.push(name.to_string_lossy().into_owned()),
            Component::ParentDir => _ = names.pop()?,
            Component::CurDir => {}
            Component::RootDir | Component::Prefix(_) => return None,
        }
    }
    Some(names.join("/"))
}
