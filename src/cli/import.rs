//! `bracket import`: forces of a frame program and a table of joints.

use super::catalog_options::CatalogOptions;
use super::common::{CommandResult, Common, Format};
use crate::batch::import::forces_file::ForcesFile;
use crate::batch::import::imported::{Imported, ImportedJoint, Request, import};
use crate::driver::interrupt::Interrupt;
use bracket_base::diag::{ExitStatus, in_line};
use bracket_joint::forces::Program;
use bracket_report::console::log::Log;
use bracket_report::console::out;
use clap::builder::PossibleValuesParser;
use serde_json::{Value, json};
use std::path::PathBuf;
use std::sync::Arc;

/// Effect of the first Ctrl-C, as the log announces it.
const WHEN_INTERRUPTED: &str = "nothing is written";

/// What the numbers beside the joints are.
const NOTE: &str = "
N_Ed, M_Ed, V: largest forces of the column beside the joint in the ultimate limit state; the sweep
has N_Ed and M_Ed.
residual: what the members leave at the node in the worst load case, as a vertical force (up) and as
a moment in the plane. It is the load at the node itself, which is in no table of members. The z
axis of the column points to the side that leaves less. residuals.csv has all load cases.
";

/// From the forces of a frame program to a sweep of all its joints.
#[derive(Debug, clap::Args)]
pub struct ImportArgs {
    /// Forces of members: CSV, a workbook, or a container of IDEA StatiCa (IOM, XML).
    #[arg(value_name = "FORCES")]
    pub forces: PathBuf,
    /// Table of the joints, one a row: `joint`, `end`, `member`, `station`, and paths of the spec.
    #[arg(long, value_name = "JOINTS")]
    pub joints: PathBuf,
    /// Spec that all joints start from; its loads are replaced.
    #[arg(long, value_name = "SPEC")]
    pub base: PathBuf,
    /// Folder for the sweep; it must not exist, or be one of an earlier import.
    #[arg(long, short, value_name = "DIR")]
    pub out: PathBuf,
    /// Sheet of the workbook with the forces.
    #[arg(long, value_name = "NAME")]
    pub sheet: Option<String>,
    /// Program whose headers, axes and signs the forces have (default: those of Bracket).
    #[arg(long, value_parser = PossibleValuesParser::new(Program::ALL.map(Program::word)))]
    pub mapping: Option<String>,
    /// Only load cases of this pattern, `*` stands for any letters; may be given several times.
    #[arg(long, value_name = "PATTERN")]
    pub cases: Vec<String>,
    /// Load cases of the serviceability limit state; the others are ultimate.
    #[arg(long, value_name = "PATTERN")]
    pub sls: Vec<String>,
    /// Catalogue.
    #[command(flatten)]
    pub catalog: CatalogOptions,
}

impl ImportArgs {
    fn request(&self) -> Request {
        let word = self.mapping.as_deref();
        let forces = ForcesFile {
            file: self.forces.clone(),
            sheet: self.sheet.clone(),
            mapping: Program::ALL.into_iter().find(|p| Some(p.word()) == word),
            cases: self.cases.clone(),
            sls: self.sls.clone(),
        };
        Request {
            forces,
            joints: self.joints.clone(),
            base: self.base.clone(),
            catalog: self.catalog.catalog.clone(),
            out: self.out.clone(),
        }
    }

    /// The command that checks the joints.
    fn next(&self, imported: &Imported) -> String {
        let catalog = self.catalog.folder().map(|dir| format!(" --catalog {}", dir.display()));
        format!("bracket batch {}{}", imported.sweep.display(), catalog.unwrap_or_default())
    }
}

/// Runs `bracket import`.
pub fn run(args: &ImportArgs, common: &Common) -> CommandResult {
    let interrupt = Interrupt::watch()?;
    let log = Arc::new(Log::new(common.quiet));
    let imported = import(&args.request(), |folder| {
        interrupt.begin(&log, WHEN_INTERRUPTED, folder.give_up());
    })?;
    imported.doubts.iter().for_each(|d| log.line(format!("warning: {d}")));
    let next = args.next(&imported);
    match common.format {
        Format::Json => out::json(&data(&imported, &next))?,
        Format::Text => out::text(&page(&imported, &next))?,
    }
    Ok(ExitStatus::Ok)
}

/// A force or moment in kN or kN m, rounded.
fn rounded(value: f64, unit: f64) -> f64 {
    // a zero has no sign
    (value / unit * 100.0).round() / 100.0 + 0.0
}

fn data(imported: &Imported, next: &str) -> Value {
    let joint = |j: &ImportedJoint| {
        let mut of = json!({"joint": j.name, "load_cases": j.cases});
        if let Some(c) = &j.column {
            let [axial, shear] = [c.axial, c.shear].map(|v| v / 1e3);
            of["column"] = json!({"N_Ed_kN": axial, "M_Ed_kNm": c.moment / 1e6, "V_kN": shear});
        }
        if let Some(r) = &j.residuals {
            let vertical = &r.vertical;
            of["vertical_residual"] = json!({"kN": vertical.value / 1e3, "case": vertical.case});
            if let Some(m) = &r.moment {
                of["moment_residual"] = json!({"kNm": m.value / 1e6, "case": m.case});
            }
        }
        of
    };
    let joints: Vec<Value> = imported.joints.iter().map(joint).collect();
    json!({"joints": joints, "sweep": imported.sweep, "next": next,
        "warnings": imported.doubts, "profiles_of_model": imported.of_model})
}

fn page(imported: &Imported, next: &str) -> String {
    let dash = || "-".to_string();
    let row = |j: &ImportedJoint| -> Vec<String> {
        let column = j.column.as_ref().map(|c| {
            [(c.axial, 1e3), (c.moment, 1e6), (c.shear, 1e3)]
                .map(|(v, u)| rounded(v, u).to_string())
        });
        let vertical = j
            .residuals
            .as_ref()
            .map(|r| [rounded(r.vertical.value, 1e3).to_string(), r.vertical.case.clone()]);
        let moment = j.residuals.as_ref().and_then(|r| r.moment.as_ref());
        let moment = moment.map(|m| [rounded(m.value, 1e6).to_string(), m.case.clone()]);
        let mut cells = vec![j.name.clone(), j.cases.to_string()];
        cells.extend(column.unwrap_or_else(|| [dash(), dash(), dash()]));
        cells.extend(vertical.unwrap_or_else(|| [dash(), dash()]));
        cells.extend(moment.unwrap_or_else(|| [dash(), dash()]));
        cells
    };
    let head = [
        "joint",
        "load cases",
        "N_Ed [kN]",
        "M_Ed [kN m]",
        "V [kN]",
        "residual [kN]",
        "in",
        "residual [kN m]",
        "in",
    ];
    let rows: Vec<Vec<String>> = imported.joints.iter().map(row).collect();
    let mut text = out::columns(&head, &rows);
    let of_column = imported.joints.iter().any(|j| j.column.is_some());
    if of_column {
        text += NOTE;
    }
    if imported.of_model > 0 {
        let n = imported.of_model;
        text += &format!("\nprofiles and steels from the model: {}\n", joints(n));
    }
    let all = joints(imported.joints.len());
    format!(
        "{text}\n{all} in {}\nnext: {}\n",
        in_line(&imported.sweep.display().to_string()),
        in_line(next)
    )
}

fn joints(n: usize) -> String {
    if n == 1 { "1 joint".into() } else { format!("{n} joints") }
}
