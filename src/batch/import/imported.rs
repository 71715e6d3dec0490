//! Imports forces and joints into a folder.

use super::column_forces::ColumnForces;
use super::doubts;
use super::end_loads::{EndLoads, Reader};
use super::equilibrium::{OfCase, Residuals, of_cases};
use super::forces_file::ForcesFile;
use super::import_folder;
use super::joint_specs;
use super::joints_table::JointsTable;
use super::model_members::ModelMembers;
use super::residuals_table;
use super::template_ends::TemplateEnds;
use crate::batch::expansion::Expansion;
use crate::batch::load_lists::LoadLists;
use crate::batch::sweep_file::open_catalog;
use bracket_base::diag::{Diagnostic, Diagnostics};
use bracket_base::text_file;
use bracket_base::xml::is_xml;
use bracket_base::yaml::{self, Parsed, PlaceIndex};
use bracket_joint::assembly::template_file;
use bracket_joint::catalog::Catalog;
use bracket_joint::forces::{ForceTables, Program, iom_model, saf_model};
use bracket_joint::spec::loads::ActionPoint;
use bracket_report::result::folder::ResultFolder;
use serde_json::Value;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

/// What is imported, and where to.
#[derive(Clone, Debug, Default)]
pub struct Request {
    /// The forces.
    pub forces: ForcesFile,
    /// The table of joints.
    pub joints: PathBuf,
    /// The base spec.
    pub base: PathBuf,
    /// Catalogue folder that takes precedence over that of the base spec.
    pub catalog: Option<PathBuf>,
    /// The folder to write.
    pub out: PathBuf,
}

/// A joint of an import.
#[derive(Clone, Debug, PartialEq)]
pub struct ImportedJoint {
    /// Its name.
    pub name: String,
    /// Number of its load cases.
    pub cases: usize,
    /// Forces of the column that the sweep has for it; `None` without a member of the column, or
    /// without checks of it.
    pub column: Option<ColumnForces>,
    /// What the members at the node leave; `None` without a member of the column.
    pub residuals: Option<Residuals>,
}

/// What an import brought.
#[derive(Clone, Debug, PartialEq)]
pub struct Imported {
    /// The joints in the order of the table.
    pub joints: Vec<ImportedJoint>,
    /// The sweep.
    pub sweep: PathBuf,
    /// What is doubted without being refused, each in a sentence.
    pub doubts: Vec<String>,
    /// Joints whose profiles or steels come from the model beside the forces.
    pub of_model: usize,
}

/// The base spec: the value with its places.
fn base(file: &Path) -> Result<Parsed<Value>, Diagnostics> {
    let text = text_file::read(file, |e| {
        Diagnostic::input("import/base", format!("the base spec cannot be read: {e}"))
            .file(file)
            .help("`--base` is the path of a spec; `bracket new TEMPLATE -o FILE` writes a starter")
    })?;
    let parsed = yaml::parse::<Value>(&text, file)?;
    if !parsed.value.is_object() {
        let d = Diagnostic::input("import/base", "this is no spec").file(file);
        return Err(d.help("name a connection spec; `bracket new TEMPLATE` writes one").into());
    }
    Ok(parsed)
}

/// Reads everything and writes the folder. `begun` gets the folder before anything is written.
pub fn import(
    request: &Request,
    begun: impl FnOnce(&ResultFolder),
) -> Result<Imported, Diagnostics> {
    let request = &with_program(request);
    let Parsed { value: spec, index } = base(&request.base)?;
    let from = request.base.parent().unwrap_or(Path::new("")).to_path_buf();
    let of_spec = spec.get("catalog").and_then(Value::as_str).map(|dir| from.join(dir));
    let catalog = open_catalog(request.catalog.as_deref().or(of_spec.as_deref()))?;
    let mut table = JointsTable::read(&request.joints)?;
    if !request.forces.file.is_file() {
        let message = "there is no such table of forces";
        let d = Diagnostic::input("import/forces", message).file(&request.forces.file);
        return Err(d.help("check the path: `bracket import FORCES --joints JOINTS …`").into());
    }
    let settled = |table: &JointsTable| -> Result<Expansion, Diagnostics> {
        let mut expansion = Expansion {
            base: without_loads(&spec),
            file: request.base.clone(),
            dimensions: vec![table.values.clone()],
            derived: Vec::new(),
            loads: LoadLists::default(),
        };
        expansion.settle(&index).map(|()| expansion)
    };
    let templates = templates((&spec, &index), &table, &from)?;
    for (row, template) in table.rows.iter().zip(&templates) {
        template.check(row, &request.joints)?;
    }
    let of_model = of_model(request, &catalog, &mut table, &templates)?;
    let mut reader =
        Reader { forces: &request.forces, joints: &request.joints, tables: ForceTables::default() };
    let loads: Vec<EndLoads> =
        table.rows.iter().map(|row| reader.of(row)).collect::<Result<_, _>>()?;
    let (mut joints, mut sums) = (Vec::new(), Vec::new());
    let mut points: Vec<Vec<(ActionPoint, Option<f64>)>> = Vec::new();
    for (i, (of_joint, template)) in loads.iter().zip(&templates).enumerate() {
        let row = &table.rows[i];
        let ends: Vec<_> = row.ends.iter().map(|e| (e.at, template.side(&e.end))).collect();
        let role = template.checked_column.as_ref();
        let column = role.and_then(|_| ColumnForces::of(of_joint));
        let cases: Vec<OfCase> = of_cases(of_joint, &ends).unwrap_or_default();
        joints.push(ImportedJoint {
            name: row.name.clone(),
            cases: of_joint.cases(),
            column,
            residuals: Residuals::worst(&cases),
        });
        sums.push(cases);
        points.push(ends);
        if let (Some(forces), Some(role)) = (column, role) {
            for (key, text) in forces.values() {
                table.fill(i, &format!("members.{role}.{key}"), &text)?;
            }
        }
    }
    let expansion = settled(&table)?;
    let specs = joint_specs::build(&expansion, &table, &loads, (&from, catalog))?;
    let mut doubts = doubts::used_twice(&table.rows, &request.joints);
    doubts.extend(doubts::lever(&loads));
    for (i, spec) in specs.iter().enumerate() {
        let row = &table.rows[i];
        let role = templates[i].checked_column.as_ref();
        let m_ed = role.and_then(|role| spec.members.get(role)?.m_ed);
        // without members of the column nobody can say whether it goes on
        let through = row.below.is_none() || row.above.is_some();
        doubts.extend(m_ed.and_then(|m| {
            let at = (row, request.joints.as_path());
            doubts::column_moment(at, &loads[i], &points[i], (m.0, through))
        }));
    }
    whole_paths(&mut table, &from);
    let names = table.rows.iter().map(|r| r.name.as_str());
    let residuals = residuals_table::text(names.zip(sums.iter().map(Vec::as_slice)));
    let folder = import_folder::begin(&request.out)?;
    begun(&folder);
    let sweep =
        import_folder::finish(folder, &table, (&loads, residuals.as_deref()), (&spec, &from))?;
    Ok(Imported { joints, sweep, doubts, of_model })
}

/// The request with the program that the file of forces itself names: XML is a container of IOM.
fn with_program(request: &Request) -> Request {
    let mut request = request.clone();
    let forces = &mut request.forces;
    if forces.mapping.is_none() && is_xml(&forces.file) {
        forces.mapping = Some(Program::Iom);
    }
    request
}

/// The spec without its loads, which the import replaces.
fn without_loads(spec: &Value) -> Value {
    let mut spec = spec.clone();
    spec.as_object_mut().map(|keys| keys.remove("loads"));
    spec
}

/// Makes the paths of templates in the table of joints absolute: they start from the folder of the
/// base spec, and the table moves.
fn whole_paths(table: &mut JointsTable, from: &Path) {
    let Some(k) = table.values.paths.iter().position(|p| p.text() == "template") else { return };
    for cells in &mut table.cells {
        if template_file::is_path(&cells[k])
            && let Ok(path) = std::path::absolute(from.join(&cells[k]))
        {
            cells[k] = path.to_string_lossy().into_owned();
        }
    }
}

/// The template of each joint, each read once.
fn templates(
    (spec, index): (&Value, &PlaceIndex),
    table: &JointsTable,
    from: &Path,
) -> Result<Vec<TemplateEnds>, Diagnostics> {
    let mut known: BTreeMap<String, TemplateEnds> = BTreeMap::new();
    let column = table.values.paths.iter().position(|p| p.text() == "template");
    let mut out = Vec::new();
    for (step, row) in table.values.steps.iter().zip(&table.rows) {
        let own = column.and_then(|k| step.values[k].as_ref());
        let name = own.or(spec.get("template")).and_then(Value::as_str);
        // a fault without a file is that of the name
        let place = match own {
            Some(_) => row.place(&table.file, "template"),
            None => index.place("template"),
        };
        let Some(name) = name else {
            let message = format!("joint `{}` has no template", row.name);
            let help = "write `template: NAME` into the base spec; `bracket templates` lists them";
            let d = Diagnostic::input("import/base", message).help(help);
            return Err(Diagnostic { place, ..d }.into());
        };
        if !known.contains_key(name) {
            let placed = |d: Diagnostic| match d.place.file {
                None => Diagnostic { place: place.clone(), ..d },
                Some(_) => d,
            };
            let read = TemplateEnds::read(name, from).map_err(|faults| faults.map(placed))?;
            known.insert(name.into(), read);
        }
        out.extend(known.get(name).cloned());
    }
    Ok(out)
}

/// Fills in profiles and steels from the model of a SAF workbook or an IOM container; returns the
/// number of joints that have some of it.
fn of_model(
    request: &Request,
    catalog: &Catalog,
    table: &mut JointsTable,
    templates: &[TemplateEnds],
) -> Result<usize, Diagnostics> {
    let file = &request.forces.file;
    let model = match request.forces.mapping {
        Some(Program::Saf) => saf_model(file)?,
        Some(Program::Iom) => Some(iom_model(file)?),
        _ => None,
    };
    let Some(model) = model else { return Ok(0) };
    let members = ModelMembers { model: &model, file, catalog };
    let mut filled = 0;
    for (joint, template) in templates.iter().enumerate() {
        filled += usize::from(members.fill(table, joint, template)?);
    }
    Ok(filled)
}
