//! The spec of each joint of an import, built once: a profile, a size or a parameter that no joint
//! can have is found before the folder is written.

use super::end_loads::EndLoads;
use super::joint_row::JointRow;
use super::joints_table::JointsTable;
use crate::batch::expansion::{Expansion, typed};
use crate::batch::screen::Kit;
use bracket_base::diag::{Diagnostic, Diagnostics};
use bracket_joint::catalog::Catalog;
use bracket_joint::spec::connection::ConnectionSpec;
use bracket_joint::spec::load_table::Loads;
use std::collections::BTreeMap;
use std::path::Path;

/// Faults that are reported at once; one of the base spec is in every joint.
const SHOWN: usize = 5;

/// Builds each joint; returns the specs in the order of the table. `folder`: that of the base spec.
pub fn build(
    expansion: &Expansion,
    table: &JointsTable,
    loads: &[EndLoads],
    (folder, catalog): (&Path, Catalog),
) -> Result<Vec<ConnectionSpec>, Diagnostics> {
    let path_fault = |e| Diagnostics::from(Diagnostic::input("sweep/path", e));
    let mut specs = Vec::new();
    for (i, of_joint) in loads.iter().enumerate() {
        let value = expansion.varied(i as u64).map_err(path_fault)?;
        let mut spec = typed(&value, &expansion.file)?;
        spec.loads = Loads::from(of_joint.listed());
        specs.push(spec);
    }
    let templates: BTreeMap<&str, &ConnectionSpec> =
        specs.iter().map(|s| (s.template.as_str(), s)).collect();
    let templates = templates.into_values().cloned().collect();
    let kit = Kit::new(folder, &expansion.file, catalog, templates);
    // a fault of the base spec is in many joints: it is told once, with the first of them
    let mut found: Vec<(&JointRow, Diagnostic, usize)> = Vec::new();
    for (row, spec) in table.rows.iter().zip(&specs) {
        let Err(d) = kit.joint(spec.clone()) else { continue };
        let same = |f: &(&JointRow, Diagnostic, usize)| {
            f.1.message == d.message && f.1.place.path == d.place.path
        };
        match found.iter().position(same) {
            Some(i) => found[i].2 += 1,
            None if found.len() < SHOWN => found.push((row, *d, 0)),
            None => {}
        }
    }
    let fault = |(row, d, more): (&JointRow, Diagnostic, usize)| {
        let others = match more {
            0 => String::new(),
            n => format!(" (and {n} more)"),
        };
        let message = format!("joint `{}`{others}: {}", row.name, d.message);
        // the line of the joint, with the path of the spec that is at fault
        let place = row.place(&table.file, d.place.path.as_deref().unwrap_or("joint"));
        Diagnostic { message, place, ..d }
    };
    let faults = found.into_iter().map(fault).collect();
    Diagnostics::refuse(faults)?;
    Ok(specs)
}
