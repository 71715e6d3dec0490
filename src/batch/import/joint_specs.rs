//! The spec of each joint of an import, built once: a profile, a size or a parameter that no joint
//! can have is found before the folder is written.

use super::end_loads::EndLoads;
use super::joints_table::JointsTable;
use crate::batch::expansion::{Expansion, typed};
use crate::batch::screen::Kit;
use bracket_base::diag::{Diagnostic, Diagnostics, Place};
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
    let mut faults = Vec::new();
    for (row, spec) in table.rows.iter().zip(&specs) {
        let Err(d) = kit.joint(spec.clone()) else { continue };
        let at = d.place.path.clone().unwrap_or_default();
        let message = format!("joint `{}`: {}", row.name, d.message);
        // the line of the joint, with the path of the spec that is at fault
        let place: Place = row.place(&table.file, if at.is_empty() { "joint" } else { &at });
        faults.push(Diagnostic { message, place, ..*d });
        if faults.len() == SHOWN {
            break;
        }
    }
    Diagnostics::refuse(faults)?;
    Ok(specs)
}
