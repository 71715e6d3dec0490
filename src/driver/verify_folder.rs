//! The verification of a result folder: its digests, the bounds from their fields, and what follows
//! from the input.

use crate::diag::{Diagnostic, Diagnostics};
use crate::driver::spec_file::{self, SpecFile};
use crate::driver::verify_cases::{frame_differences, mirror};
use crate::driver::verify_model::of_model;
use crate::driver::verify_spec::of_spec;
use crate::model::file::ModelFile;
use crate::report::markdown::report_data::{REPORT_DATA_FILE, ReportData};
use crate::result::digests::{DIGESTS_FILE, Digests};
use crate::result::result_file::{RESULT_FILE, ResultFile};
use crate::result::verify::{self, Finding, Reference};
use crate::spec::yaml;
use std::path::Path;

/// Keys of `result.json` whose values no file of a result proves, as `docs/results.md` lists them.
/// `[]` stands for every entry of a list; the keys below a listed one are recorded too.
pub const RECORDED: [&str; 12] = [
    "tool.version",
    "warnings",
    "cases[].warnings",
    "cases[].coulomb_estimate",
    "cases[].fixed_point",
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
    "`input_hash` of a model whose first mesh was refined",
    "reports, pictures and drawings; all of report.json but the input",
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
    let mut refuted = differences_of_digests(folder);
    let reference = match &input {
        Input::Model(..) => Some(Reference::default()),
        Input::Spec(spec, _) => {
            let (bolts, mirror) = (spec.joint.bolts.clone(), mirror(spec, &result));
            Some(Reference { bolts, mirror })
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
            recomputed.push("the model, from the input; a model has no demand".into());
        }
        Input::Spec(spec, data) => {
            refuted.extend(frame_differences(folder, &result, spec, data));
            refuted.extend(of_spec(&result, spec));
            let what = "the models, `checks`, demands and verdicts, from the spec; the meshes, \
                        compared with its solids";
            recomputed.push(what.into());
        }
        // who takes the input away could forge everything that follows from it
        Input::Lost(why) => refuted.push(format!(
            "the input cannot be read ({why}): models, checks, demands and verdicts are not \
             confirmed"
        )),
    }
    let keys = format!("the keys {}", RECORDED.map(|key| format!("`{key}`")).join(", "));
    let recorded = [keys].into_iter().chain(RECORDED_TOO.map(String::from)).collect();
    Ok(Verified { bounds, refuted, recomputed, recorded })
}

/// Reads the input of a result: a spec with its templates and tables, or a model file.
fn input(folder: &Path) -> Input {
    let lost = |faults: Diagnostics| Input::Lost(faults.into_first().message);
    let data = match ReportData::read(folder) {
        Ok(data) => Box::new(data),
        Err(faults) => return lost(faults),
    };
    if data.input_text.trim().is_empty() {
        return Input::Lost(format!("`{REPORT_DATA_FILE}` has none"));
    }
    let path = folder.join(&data.input_name);
    if let Ok(model) = yaml::parse::<ModelFile>(&data.input_text, &path) {
        return Input::Model(Box::new(model.value), data);
    }
    match spec_file::stored(&data.input_text, &data.input_name, folder) {
        Ok(spec) => Input::Spec(Box::new(spec), data),
        Err(faults) => lost(faults),
    }
}

/// Sentences about the files that are not those of the run.
fn differences_of_digests(folder: &Path) -> Vec<String> {
    match Digests::read(folder) {
        Ok(Some(digests)) => {
            let mut out = digests.differences(folder);
            if !digests.lists(RESULT_FILE) {
                out.push(format!("{DIGESTS_FILE} does not list {RESULT_FILE}"));
            }
            out
        }
        Ok(None) => vec![format!(
            "{DIGESTS_FILE} is missing: nothing shows that the recorded values are those of the run"
        )],
        Err(e) => vec![format!("{DIGESTS_FILE} cannot be read: {e}")],
    }
}
