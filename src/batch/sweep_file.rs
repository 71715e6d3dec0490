//! Reads a sweep file with everything it names: base spec, catalogue, table.

use super::axis;
use super::derived::Derived;
use super::dimension::{Dimension, words};
use super::expansion::{Expansion, canonical, covers};
use super::load_lists::{self, LoadLists};
use super::sweep::{CapacityTable, Sweep, Then, meshes};
use super::table;
use bracket_base::diag::{Diagnostic, Diagnostics};
use bracket_base::text_file;
use bracket_base::yaml::{self, Parsed, PlaceIndex};
use bracket_joint::catalog::Catalog;
use serde_json::Value;
use std::path::{Path, PathBuf};

/// A sweep that was read and whose values are sound one by one.
pub struct SweepFile {
    /// The sweep with its places.
    pub sweep: Parsed<Sweep>,
    /// Its cases.
    pub expansion: Expansion,
    /// Folder from which the paths of the base spec are resolved.
    pub folder: PathBuf,
    /// The catalogue folder of the option or of the spec.
    pub catalog_folder: Option<PathBuf>,
    /// The catalogue.
    pub catalog: Catalog,
    /// The tables of load cases that were read.
    pub load_tables: Vec<PathBuf>,
}

/// The catalogue of a folder, or the built-in one.
pub fn open_catalog(folder: Option<&Path>) -> Result<Catalog, Diagnostics> {
    let read = match folder {
        Some(dir) => Catalog::with_dir(dir),
        None => Catalog::builtin(),
    };
    read.map_err(|e| Diagnostic::from(e).into())
}

impl SweepFile {
    /// Reads a sweep. `catalog` is the folder of `--catalog`, which takes precedence over that of
    /// the base spec.
    pub fn read(path: &Path, catalog: Option<&Path>) -> Result<Self, Diagnostics> {
        let text = text_file::read(path, |e| {
            Diagnostic::input(
                "sweep/read",
                format!("the sweep `{}` cannot be read: {e}", path.display()),
            )
            .file(path)
            .help("check the path; docs/guide.md shows a sweep")
        })?;
        let sweep = yaml::parse::<Sweep>(&text, path)?;
        let here = path.parent().unwrap_or(Path::new(""));
        let (mut base, base_index, file, folder) = base(&sweep, here)?;
        let of_spec = base.get("catalog").and_then(Value::as_str).map(|dir| folder.join(dir));
        let catalog_folder = catalog.map(Path::to_path_buf).or(of_spec);
        let catalog = open_catalog(catalog_folder.as_deref())?;
        let mut dimensions: Vec<Dimension> = Vec::new();
        if let Some(table) = &sweep.value.table {
            dimensions.push(table::read(&here.join(table))?);
        }
        let mut faults = Vec::new();
        for (key, value) in &sweep.value.axes {
            match axis::dimension(key, value, &catalog, &sweep.index) {
                Ok(d) => dimensions.push(d),
                Err(d) => faults.push(*d),
            }
        }
        Diagnostics::refuse(faults)?;
        let at = |message: String, path: &str, help: &str| {
            let d = Diagnostic::input("sweep/value", message).help(help);
            Diagnostics::from(Diagnostic { place: sweep.index.place(path), ..d })
        };
        if dimensions.is_empty() {
            let help = "give `axes` (paths of the spec with lists of values), a `table`, or both";
            return Err(at("the sweep varies nothing".into(), "", help));
        }
        if let (Some(Then { .. }), None) = (sweep.value.then, sweep.value.first) {
            let help = "add `first: checks`: they decide which cases are analysed";
            return Err(at("`then` needs the checks".into(), "then", help));
        }
        for t in &sweep.value.tables {
            for p in [&t.rows, &t.columns].into_iter().chain(t.only.keys()) {
                if let Some(hint) = not_varied(p, &dimensions) {
                    let message = format!(
                        "the table `{}` is over `{p}`, which nothing varies{hint}",
                        t.title
                    );
                    return Err(at(message, "tables", "write a path of `axes` or of the table"));
                }
            }
        }
        if let Some(choose) = &sweep.value.choose {
            if sweep.value.first.is_none() {
                let help = "add `first: checks`: they say which joints can be chosen";
                return Err(at("`choose` needs the checks".into(), "choose", help));
            }
            let expects = |d: &Dimension| d.steps.iter().any(|s| s.expect.is_some());
            if dimensions.iter().any(expects) {
                let message = "the table expects verdicts, and `choose` leaves joints undecided";
                let help = "leave out the column `expect`, and write `expect: [chosen == groups]`";
                return Err(at(message.into(), "choose", help));
            }
            for p in choose.per.iter().flatten() {
                if let Some(hint) = not_varied(p, &dimensions) {
                    let message =
                        format!("`choose.per` has `{p}`, which no axis and no column varies{hint}");
                    let help = "write paths of `axes` or of the table; without `per` each row of \
                                the table is a group";
                    return Err(at(message, "choose.per", help));
                }
                if choose.per.iter().flatten().filter(|q| *q == p).count() > 1 {
                    let message = format!("`choose.per` has `{p}` twice");
                    return Err(at(message, "choose.per", "write each path once"));
                }
            }
        }
        let mut derived = Vec::new();
        for (key, value) in &sweep.value.set {
            derived.push(Derived::read(key, value, &sweep.index)?);
        }
        let named_by_rows = load_lists::vary(&mut base, &dimensions);
        let (base, mut load_tables) = match named_by_rows {
            true => (base, Vec::new()),
            false => load_lists::of_base(base, &base_index, &folder)?,
        };
        one_place_each(&dimensions, &derived, &base)
            .and_then(|()| tables_have_cases(&sweep.value.tables, &dimensions))
            .map_err(|(message, path, help)| at(message, &path, help))?;
        sweep.value.limits.memory(0).map_err(|f| {
            let message = f.into_first().message.replace("--memory-limit", "`limits.memory`");
            at(message, "limits.memory", "write a number with its unit: `8GiB`")
        })?;
        if sweep.value.limits.threads == Some(0) {
            return Err(at("`limits.threads` is 0".into(), "limits.threads", "write 1 or more"));
        }
        let loads = LoadLists::default();
        let mut expansion = Expansion { base, file, dimensions, derived, loads };
        expansion.settle(&base_index)?;
        if named_by_rows {
            let named = expansion.load_tables(&base_index);
            let (lists, files) = LoadLists::read(named, &folder)?;
            (expansion.loads, load_tables) = (lists, files);
        }
        Ok(Self { sweep, expansion, folder, catalog_folder, catalog, load_tables })
    }

    /// Whether cases are meshed.
    pub fn meshes(&self) -> bool {
        meshes(self.sweep.value.first, self.sweep.value.then)
    }
}

/// A hint at a path that is meant, if nothing varies `path`.
fn not_varied(path: &str, dimensions: &[Dimension]) -> Option<String> {
    let all = || dimensions.iter().flat_map(|d| d.paths.iter().map(|p| p.text()));
    all().all(|p| p != path).then(|| bracket_base::diag::did_you_mean(path, all()))
}

/// A fault of a sweep: message, path in the sweep file, help.
type Fault = (String, String, &'static str);

/// Refuses a path that two places write, in whatever spelling: one value would be lost.
fn one_place_each(
    dimensions: &[Dimension],
    derived: &[Derived],
    base: &Value,
) -> Result<(), Fault> {
    let of_dimensions =
        dimensions.iter().flat_map(|d| d.paths.iter().map(|p| (p, d.what.as_str(), "axes")));
    let of_set = derived.iter().map(|d| (&d.path, "`set`", "set"));
    let all: Vec<_> = of_dimensions.chain(of_set).collect();
    let plain: Vec<String> = all.iter().map(|(p, ..)| canonical(p.text(), base)).collect();
    for (i, (path, what, key)) in all.iter().enumerate() {
        if plain[i] == "catalog" {
            let message = "`catalog` is one folder for the whole sweep".to_string();
            let help = "give `--catalog DIR`, or `catalog` in the base spec";
            return Err((message, format!("{key}.{path}"), help));
        }
        let other = (0..i).find(|k| covers(&plain[*k], &plain[i]) || covers(&plain[i], &plain[*k]));
        if let Some(k) = other {
            let message = format!("`{path}` is varied by {} and by {what}", all[k].1);
            return Err((message, format!("{key}.{path}"), "vary a path in one place only"));
        }
    }
    for d in derived {
        let used = d.names();
        let names = |o: &&Derived| used.iter().any(|n| covers(o.path.text(), n));
        if let Some(other) = derived.iter().find(names) {
            let message = format!("`set.{}` uses `{}`, which `set` changes", d.path, other.path);
            let help = "write the expression of the other value in its place";
            return Err((message, format!("set.{}", d.path), help));
        }
    }
    Ok(())
}

/// Refuses a capacity table that no case can be in.
fn tables_have_cases(tables: &[CapacityTable], dimensions: &[Dimension]) -> Result<(), Fault> {
    for t in tables {
        for (path, value) in &t.only {
            let has = dimensions.iter().any(|d| {
                let k = d.paths.iter().position(|p| p.text() == path);
                k.is_some_and(|k| {
                    d.steps.iter().any(|s| s.values[k].as_ref().map(words) == Some(words(value)))
                })
            });
            if !has {
                let message = format!(
                    "the table `{}` is of `{path}: {}`, which no case has",
                    t.title,
                    words(value)
                );
                return Err((message, "tables".into(), "write the value as the axis writes it"));
            }
        }
    }
    Ok(())
}

/// The base spec: its value, its places, its file and its folder.
fn base(
    sweep: &Parsed<Sweep>,
    here: &Path,
) -> Result<(Value, PlaceIndex, PathBuf, PathBuf), Diagnostics> {
    let fault = |message: String, help: &str| {
        let d = Diagnostic::input("sweep/base", message).help(help);
        Diagnostics::from(Diagnostic { place: sweep.index.place("base"), ..d })
    };
    match &sweep.value.base {
        Value::String(name) => {
            let file = here.join(name);
            let text = text_file::read(&file, |e| {
                let message = format!("the base spec `{}` cannot be read: {e}", file.display());
                let d = Diagnostic::input("sweep/base", message)
                    .help("`base` is a path relative to the sweep file");
                Diagnostic { place: sweep.index.place("base"), ..d }
            })?;
            let parsed = yaml::parse::<Value>(&text, &file)?;
            if !parsed.value.is_object() {
                return Err(fault(format!("`{name}` is no spec"), "name a connection spec"));
            }
            let folder = file.parent().unwrap_or(Path::new("")).to_path_buf();
            Ok((parsed.value, parsed.index, file, folder))
        }
        spec @ Value::Object(_) => {
            let file = sweep.index.place("base").file.unwrap_or_default();
            Ok((spec.clone(), PlaceIndex::new(&file), file, here.to_path_buf()))
        }
        _ => Err(fault(
            "`base` is neither the path of a spec nor a spec".into(),
            "write `base: joint.yaml`, or the keys of a spec below `base:`",
        )),
    }
}
