//! The chosen joints as specs of their own, each with its report.

use super::choice::Decision;
use super::dimension::words;
use super::merged::Merged;
use super::plan::Plan;
use super::row::Record;
use super::screen::Kit;
use super::sweep_folder::{SweepFolder, write_whole};
use super::worker::absolute;
use crate::driver::check_spec::check_spec;
use crate::driver::interrupt::Interrupt;
use crate::driver::spec_input::SpecInput;
use bracket_base::diag::Diagnostics;
use bracket_base::yaml;
use bracket_report::console::log::Log;
use bracket_report::result::file_names::file_stem;
use bracket_report::result::result_file::RESULT_FILE;
use bracket_report::sheet::PDF_FILE;
use serde_json::Value;
use std::fs;
use std::path::Path;

/// Folder of the chosen joints in that of a sweep, and the stem of the spec of the only one.
const FOLDER: &str = "chosen";

/// Chosen joints with a report; each takes some tenths of a second.
const MOST_REPORTS: usize = 100;

/// A chosen joint and its files, relative to the folder of the sweep.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ChosenJoint {
    /// What distinguishes it from the other joints of the sweep: `plate.thickness = 12,
    /// bolts.size = M20`.
    pub values: String,
    /// Its spec.
    pub spec: String,
    /// Its printed report; absent beyond the first hundred.
    pub report: Option<String>,
}

/// Writes spec and report of the chosen joint of every group; `None` for a group without one.
pub fn write(
    plan: &Plan,
    merged: &Merged,
    kit: &Kit,
    folder: &SweepFolder,
    log: &Log,
) -> Result<Vec<Option<ChosenJoint>>, Diagnostics> {
    clear(&folder.path().join(FOLDER));
    let single = merged.decisions.len() == 1;
    let mut out = Vec::with_capacity(merged.decisions.len());
    for (i, decision) in merged.decisions.iter().enumerate() {
        let stem = match single {
            true => FOLDER.to_owned(),
            false => format!("{FOLDER}/{}", stem_of(merged, i)),
        };
        let joint = one(plan, merged, kit, folder, (decision, &stem), i < MOST_REPORTS)?;
        if let Some(joint) = &joint {
            log.line(format!("chosen: {}: {}", joint.values, joint.spec));
        }
        out.push(joint);
    }
    Ok(out)
}

/// File name of a group, unique among those of the sweep.
fn stem_of(merged: &Merged, group: usize) -> String {
    let stem = |d: &Decision| match file_stem(&d.group) {
        empty if empty.is_empty() => "group".to_owned(),
        stem => stem,
    };
    let mine = stem(&merged.decisions[group]);
    let same = |d: &&Decision| stem(d).eq_ignore_ascii_case(&mine);
    match merged.decisions[..group].iter().filter(same).count() {
        0 => mine,
        n => format!("{mine}-{}", n + 1),
    }
}

fn one(
    plan: &Plan,
    merged: &Merged,
    kit: &Kit,
    folder: &SweepFolder,
    (decision, stem): (&Decision, &str),
    reported: bool,
) -> Result<Option<ChosenJoint>, Diagnostics> {
    let Some(choice) = decision.choice() else { return Ok(None) };
    let (case, header) = (&plan.cases[choice.case], &plan.header);
    let mut spec = kit.spec(&header.expansion, case.index)?;
    let values = values(plan, &spec, case.index);
    title(&mut spec, if values.is_empty() { &case.name } else { &values });
    let text = yaml::to_string(&absolute(spec, &header.folder))?;
    let file = format!("{stem}.yaml");
    let path = folder.path().join(&file);
    write_whole(&path, text.as_bytes())?;
    let record = merged.records[choice.case].as_ref();
    // a joint with finite elements has its report
    let report = match record.filter(|r| r.result).map(Record::folder) {
        Some(of_case) => Some(format!("{of_case}/{PDF_FILE}")),
        None if reported => {
            let place = folder.path().join(stem);
            let (catalog, spec) = (header.catalog.clone(), SpecInput::read(&path)?);
            check_spec(&SpecInput { catalog, ..spec }, &place, true, &Interrupt::default())?;
            Some(format!("{stem}/{PDF_FILE}"))
        }
        None => None,
    };
    Ok(Some(ChosenJoint { values, spec: file, report }))
}

/// The varied values of a combination and those of `set`, with their paths.
fn values(plan: &Plan, spec: &Value, index: u64) -> String {
    let expansion = &plan.header.expansion;
    let varied = expansion.values(index).into_iter();
    let varied = varied.filter(|(_, value)| !value.is_empty());
    let mut all: Vec<String> = varied.map(|(path, v)| format!("{path} = {v}")).collect();
    let set = expansion
        .derived
        .iter()
        .filter_map(|d| Some(format!("{} = {}", d.path.text(), words(d.path.get(spec)?))));
    all.extend(set);
    all.join(", ")
}

/// Adds what a joint is to the title of its report.
pub fn title(spec: &mut Value, name: &str) {
    let title = spec["project"]["title"].as_str().map(str::to_owned);
    let title = title.map_or_else(|| name.to_string(), |t| format!("{t}: {name}"));
    if spec["project"].is_null() {
        spec["project"] = serde_json::json!({});
    }
    spec["project"]["title"] = title.into();
}

/// Removes the specs and reports of an earlier choice, and nothing else.
fn clear(folder: &Path) {
    for entry in fs::read_dir(folder).into_iter().flatten().flatten() {
        let path = entry.path();
        if path.join(RESULT_FILE).is_file() {
            let _ = fs::remove_dir_all(&path);
        } else if path.is_file() && path.extension().is_some_and(|e| e == "yaml") {
            let _ = fs::remove_file(&path);
        }
    }
}

/// Removes the files of a choice that a sweep has no longer.
pub fn remove(folder: &SweepFolder) {
    let place = folder.path().join(FOLDER);
    clear(&place);
    if place.join(RESULT_FILE).is_file() {
        let _ = fs::remove_dir_all(&place);
    }
    let _ = fs::remove_file(place.with_extension("yaml"));
}
