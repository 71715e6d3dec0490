//! Load cases of a sweep whose rows or axes say from which table, and which rows of it, they come.
//!
//! The tables are read when the sweep is planned. The plan holds the lists, so that all its parts
//! compute with the same load cases.

use super::dimension::Dimension;
use super::spec_path::SpecPath;
use bracket_base::diag::{Diagnostic, Diagnostics, Place};
use bracket_base::yaml::PlaceIndex;
use bracket_joint::forces::ForceTables;
use bracket_joint::spec::load_table::LoadTable;
use bracket_joint::spec::table_loads::listed;
use serde::{Deserialize, Serialize};
use serde_json::{Value, json};
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

/// Keys of a table of load cases.
const KEYS: [&str; 12] = [
    "table", "sheet", "mapping", "columns", "member", "node", "station", "flip", "cases", "state",
    "end", "at",
];

/// Faults that are reported at once; a wrong column has one in every row.
const SHOWN: usize = 5;

/// Lists of load cases by the `loads` of a spec from which they are read.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct LoadLists(BTreeMap<String, Value>);

/// The `loads` of a spec that names a table, with the place of each of its keys.
pub struct NamedTable<'a> {
    /// The value of `loads`.
    pub loads: Value,
    /// The place of a path of the spec.
    pub place: Box<dyn Fn(&str) -> Place + 'a>,
}

/// Whether a path is a key of a table of load cases.
pub fn is_key(path: &SpecPath) -> bool {
    let mut parts = path.text().split('.');
    parts.next() == Some("loads")
        && parts.next().is_some_and(|p| KEYS.contains(&p.split('[').next().unwrap_or_default()))
}

/// Whether the rows or axes say which table the load cases come from. A base spec with a list has
/// load cases that may be called like such a key; an empty list makes way for the table.
pub fn vary(base: &mut Value, dimensions: &[Dimension]) -> bool {
    if !dimensions.iter().any(|d| d.paths.iter().any(is_key)) {
        return false;
    }
    match base.get_mut("loads") {
        Some(Value::Array(list)) if !list.is_empty() => false,
        Some(loads @ Value::Array(_)) => {
            *loads = Value::Null;
            true
        }
        _ => true,
    }
}

impl LoadLists {
    /// True if no `loads` names a table.
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// Puts the list in place of the table that a spec names.
    pub fn put(&self, spec: &mut Value) {
        if let Some(loads) = spec.get_mut("loads")
            && let Some(list) = self.0.get(&loads.to_string())
        {
            *loads = list.clone();
        }
    }

    /// Reads the tables, each file once; paths start from `folder`. Returns their files too.
    pub fn read<'a>(
        named: impl Iterator<Item = NamedTable<'a>>,
        folder: &Path,
    ) -> Result<(Self, Vec<PathBuf>), Diagnostics> {
        let (mut lists, mut files) = (BTreeMap::new(), Vec::new());
        let (mut tables, mut faults) = (ForceTables::default(), Vec::new());
        for NamedTable { loads, place } in named {
            let key = loads.to_string();
            // what is no table is a fault of the case
            let Ok(table) = LoadTable::deserialize(&loads) else { continue };
            if lists.contains_key(&key) {
                continue;
            }
            let file = folder.join(&table.table);
            match one(&mut tables, &table, &file, &place) {
                Ok(list) => {
                    lists.insert(key, list);
                    files.push(file);
                }
                Err(found) => faults.extend(found.iter().cloned()),
            }
            if faults.len() >= SHOWN {
                break;
            }
        }
        Diagnostics::refuse(faults)?;
        files.sort_unstable();
        files.dedup();
        Ok((Self(lists), files))
    }
}

fn one(
    tables: &mut ForceTables,
    table: &LoadTable,
    file: &Path,
    place: &dyn Fn(&str) -> Place,
) -> Result<Value, Diagnostics> {
    if !file.exists() {
        let message = format!("there is no table `{}`", file.display());
        let help = "paths of tables start from the folder of the base spec";
        let d = Diagnostic::input("loads/table", message).help(help);
        return Err(Diagnostic { place: place("loads.table"), ..d }.into());
    }
    let list = listed(tables, table, file, place)?;
    Ok(list.into_iter().map(|(_, load)| json!(load)).collect())
}

/// The load cases of the table that a base spec names, if any, in its place; and the file.
pub fn of_base(
    mut base: Value,
    index: &PlaceIndex,
    folder: &Path,
) -> Result<(Value, Vec<PathBuf>), Diagnostics> {
    let Some(loads @ Value::Object(_)) = base.get_mut("loads") else {
        return Ok((base, Vec::new()));
    };
    let table = LoadTable::deserialize(&*loads).map_err(|e| {
        let help = "`bracket check` of the base spec says more";
        let d = Diagnostic::input("sweep/base", format!("the loads of the base spec: {e}"));
        Diagnostic { place: index.place("loads"), ..d.help(help) }
    })?;
    let file = folder.join(&table.table);
    *loads = one(&mut ForceTables::default(), &table, &file, &|path| index.place(path))?;
    Ok((base, vec![file]))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_list_of_the_base_is_no_table() {
        let path = SpecPath::parse("loads.member").expect("a path");
        let what = "the table".to_string();
        let rows = [Dimension {
            what,
            table: true,
            paths: vec![path],
            notes: Vec::new(),
            steps: Vec::new(),
        }];
        for (mut base, is) in [
            (json!({}), true),
            (json!({"loads": []}), true),
            (json!({"loads": {"table": "forces.csv"}}), true),
            (json!({"loads": [{"name": "member"}]}), false),
        ] {
            assert_eq!(vary(&mut base, &rows), is, "{base}");
            assert!(!vary(&mut base, &[]));
        }
    }

    #[test]
    fn keys_of_a_table() {
        for (path, is) in [
            ("loads.table", true),
            ("loads.columns.My", true),
            ("loads.cases[0]", true),
            ("loads.ULS1.My", false),
            ("loads[0].name", false),
            ("members.beam.profile", false),
        ] {
            assert_eq!(is_key(&SpecPath::parse(path).expect("a path")), is, "{path}");
        }
    }
}
