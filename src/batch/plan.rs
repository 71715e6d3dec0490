//! The plan of a sweep: its cases with their keys, in a folder that holds all a run needs.

use super::case::{Case, common, key, own_tables, shared};
use super::expansion::{Expansion, canonical, covers, typed};
use super::row::Record;
use super::screen::Kit;
use super::sweep::{CapacityTable, CaseLimits, Choose, First, Then, meshes};
use super::sweep_file::{SweepFile, open_catalog};
use bracket_base::diag::{Diagnostic, Diagnostics};
use bracket_base::yaml::PlaceIndex;
use bracket_joint::assembly::names;
use bracket_joint::spec::connection::ConnectionSpec;
use bracket_joint::spec::expr::{Expr, Value};
use bracket_report::result::result_file::Tool;
use rayon::prelude::*;
use serde::{Deserialize, Serialize};
use std::collections::{BTreeMap, BTreeSet, HashMap};
use std::path::{Path, PathBuf};

/// Version of the form of a plan.
pub const SCHEMA: u32 = 1;

/// Largest number of combinations of a sweep.
pub const MOST: u64 = 10_000_000;

/// What a run needs besides the cases.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Header {
    /// [`SCHEMA`].
    pub schema: u32,
    /// The program that made the plan.
    pub tool: Tool,
    /// Hash of the file with the cases.
    pub cases: String,
    /// Hash of what all keys contain: templates, tables of the user, versions.
    pub inputs: String,
    /// Version of the mesher that the keys contain; empty if no case is meshed.
    pub mesher: String,
    /// The sweep file, to recognise the folder of another sweep.
    pub sweep: PathBuf,
    /// The files that the plan was made of, with the hashes of their content.
    #[serde(default)]
    pub sources: Vec<(PathBuf, String)>,
    /// Folder from which the paths of the spec are resolved.
    pub folder: PathBuf,
    /// Catalogue folder of the user.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub catalog: Option<PathBuf>,
    /// The combinations.
    pub expansion: Expansion,
    /// What every case gets first.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub first: Option<First>,
    /// Which cases get finite elements after the checks.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub then: Option<Then>,
    /// Which joint of each group is chosen.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub choose: Option<Choose>,
    /// Conditions on the outcome.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub expect: Vec<String>,
    /// Capacity tables.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub tables: Vec<CapacityTable>,
    /// Limits of a case with finite elements.
    pub limits: CaseLimits,
    /// Combinations that a condition dropped.
    pub dropped: u64,
}

/// A plan.
#[derive(Clone, Debug)]
pub struct Plan {
    /// What a run needs besides the cases.
    pub header: Header,
    /// The cases.
    pub cases: Vec<Case>,
    /// Remarks for the user, such as equal rows.
    pub remarks: Vec<String>,
}

/// One combination: `None` if a condition drops it.
type Planned = Result<Option<Case>, Box<Diagnostic>>;

impl Plan {
    /// Plans a sweep. `mesher` is the version of the mesher, empty if no case is meshed.
    pub fn new(path: &Path, file: SweepFile, mesher: &str) -> Result<Self, Diagnostics> {
        let count = file.expansion.count().filter(|n| *n <= MOST).ok_or_else(|| too_many(&file))?;
        let kit = kit(&file.expansion, &file.folder, file.catalog)?;
        derived_fit(&file.expansion, &kit, &file.sweep.index)?;
        let value = &file.sweep.value;
        let limit = value.then.is_some();
        let shared = shared(mesher, limit, &own_tables(file.catalog_folder.as_deref()));
        let commons = commons(&kit, &shared);
        let sweep = &file.sweep;
        let conditions = &sweep.value.conditions;
        let planned: Vec<Planned> = (0..count)
            .into_par_iter()
            .map(|index| {
                plan_case(index, &file.expansion, conditions, &kit, &commons, &sweep.index)
            })
            .collect();
        let mut cases = Vec::new();
        for case in planned {
            cases.extend(case?);
        }
        if cases.is_empty() {
            let message = format!("`where` drops all {count} combinations");
            let d = Diagnostic::input("sweep/empty", message)
                .help("loosen a condition, or give other values");
            return Err(Diagnostic { place: sweep.index.place("where"), ..d }.into());
        }
        let dropped = count - cases.len() as u64;
        let here = path.parent().unwrap_or(Path::new(""));
        let table = value.table.as_ref().map(|t| here.join(t));
        let mut sources = vec![path.to_path_buf(), file.expansion.file.clone()];
        sources.extend(table);
        sources.extend(file.load_tables);
        sources.dedup();
        let remarks = unique(&mut cases);
        // the folder of a file in the current folder is empty
        let absolute = |p: &Path| {
            let p = if p.as_os_str().is_empty() { Path::new(".") } else { p };
            std::path::absolute(p).unwrap_or_else(|_| p.to_path_buf())
        };
        let header = Header {
            cases: String::new(),
            inputs: digest(&commons),
            schema: SCHEMA,
            tool: Tool::this(),
            mesher: mesher.into(),
            sources: sources.iter().map(|f| (absolute(f), content(f))).collect(),
            sweep: absolute(path),
            folder: absolute(&file.folder),
            catalog: file.catalog_folder.as_deref().map(absolute),
            first: value.first,
            then: value.then,
            choose: value.choose.clone(),
            expect: value.expect.iter().map(|e| e.text().to_string()).collect(),
            tables: value.tables.clone(),
            limits: value.limits.clone(),
            expansion: file.expansion,
            dropped,
        };
        Ok(Self { header, cases, remarks })
    }
}

/// Refuses values of `set` that the spec cannot take, such as those of a key that does not exist.
fn derived_fit(
    expansion: &Expansion,
    kit: &Kit,
    places: &PlaceIndex,
) -> Result<(), Box<Diagnostic>> {
    // another fault of the first combination is reported with its case
    let Ok(spec) = kit.spec(expansion, 0) else { return Ok(()) };
    let Err(fault) = typed(&spec, &kit.file) else { return Ok(()) };
    let at = fault.place.path.clone().unwrap_or_default();
    let own = expansion.derived.iter().find(|d| {
        let path = canonical(d.path.text(), &expansion.base);
        covers(&path, &at) || (!at.is_empty() && covers(&at, &path))
    });
    match own {
        Some(d) => {
            let place = places.place(&format!("set.{}", d.path));
            let message = format!("`set.{}`: {}", d.path, fault.message);
            Err(Box::new(Diagnostic { place, message, ..*fault }))
        }
        None => Ok(()),
    }
}

/// Hash of the content of a file.
fn content(file: &Path) -> String {
    bracket_base::text_file::bytes(file)
        .map(|b| blake3::hash(&b).to_hex().to_string())
        .unwrap_or_default()
}

/// The part of a key that all cases with a template share, for each template.
fn commons<'a>(kit: &'a Kit, shared: &str) -> BTreeMap<&'a str, String> {
    let known =
        kit.templates.iter().filter_map(|(name, t)| Some((name.as_str(), t.as_ref().ok()?)));
    known.map(|(name, template)| (name, common(template, shared))).collect()
}

/// Hash of what all keys of a plan contain.
fn digest(commons: &BTreeMap<&str, String>) -> String {
    blake3::hash(format!("{commons:?}").as_bytes()).to_hex().to_string()
}

impl Header {
    /// Catalogue and templates of the plan. Refuses those that changed since: the keys would not
    /// name what is computed. `mesher` is the version of the mesher of this machine.
    pub fn kit(&self, mesher: &str) -> Result<Kit, Diagnostics> {
        let catalog = open_catalog(self.catalog.as_deref())?;
        let kit = kit(&self.expansion, &self.folder, catalog)?;
        let own = own_tables(self.catalog.as_deref());
        let commons = commons(&kit, &shared(mesher, self.then.is_some(), &own));
        if digest(&commons) != self.inputs {
            let message = "a template, a table of the catalogue, the program or the mesher is not \
                           the one of the plan";
            let help = "plan the sweep again; cases that are still the same stay finished";
            return Err(Diagnostic::input("sweep/changed", message).help(help).into());
        }
        Ok(kit)
    }

    /// The files that are there and no longer what the plan was made of.
    pub fn changed(&self) -> Vec<&Path> {
        let differs = |(file, hash): &&(PathBuf, String)| file.is_file() && content(file) != *hash;
        self.sources.iter().filter(differs).map(|(file, _)| file.as_path()).collect()
    }

    /// Whether a case with these checks gets finite elements. What a binding check rejects cannot
    /// be chosen, so it gets none where a joint is chosen.
    pub fn wants(&self, checked: &Record) -> bool {
        let chosen = self.choose.is_none() || !checked.rejected;
        chosen && self.then.is_some_and(|then| checked.wants(then.limit))
    }

    /// Whether cases are meshed.
    pub fn meshes(&self) -> bool {
        meshes(self.first, self.then)
    }
}

/// Catalogue and templates of an expansion.
fn kit(
    expansion: &Expansion,
    folder: &Path,
    catalog: bracket_joint::catalog::Catalog,
) -> Result<Kit, Diagnostics> {
    // the template may be varied too: one spec for each name
    let mut specs: BTreeMap<String, ConnectionSpec> = BTreeMap::new();
    let first = expansion.varied(0).and_then(|s| typed(&s, &expansion.file).map_err(|d| d.message));
    let Ok(first) = first else {
        return Ok(Kit::new(folder, &expansion.file, catalog, Vec::new()));
    };
    // an empty cell stands for the template of the base
    let of_base = expansion.base.get("template");
    let varied = expansion.dimensions.iter().flat_map(|d| {
        let k = d.paths.iter().position(|p| p.text() == "template");
        k.map(|k| d.steps.iter().filter_map(move |s| s.values[k].as_ref().or(of_base)?.as_str()))
            .into_iter()
            .flatten()
    });
    for name in varied {
        let spec = ConnectionSpec { template: name.into(), ..first.clone() };
        specs.insert(name.into(), spec);
    }
    specs.insert(first.template.clone(), first);
    let kit = Kit::new(folder, &expansion.file, catalog, specs.into_values().collect());
    match kit.templates.values().find_map(|t| t.as_ref().err()) {
        Some(d) if kit.templates.len() == 1 => Err(d.clone().into()),
        _ => Ok(kit),
    }
}

fn too_many(file: &SweepFile) -> Diagnostics {
    let each: Vec<String> = file
        .expansion
        .dimensions
        .iter()
        .map(|d| format!("{} has {}", d.what, d.steps.len()))
        .collect();
    let message = format!("more than {MOST} combinations: {}", each.join(", "));
    let d = Diagnostic::input("sweep/size", message)
        .help("give fewer values, or link paths that change together with commas");
    Diagnostic { place: file.sweep.index.place("axes"), ..d }.into()
}

fn plan_case(
    index: u64,
    expansion: &Expansion,
    conditions: &[Expr],
    kit: &Kit,
    commons: &BTreeMap<&str, String>,
    places: &PlaceIndex,
) -> Planned {
    let name = expansion.name(index);
    let spec = match kit.spec(expansion, index) {
        // a name that `set` does not know is unknown in every case
        Err(d) if d.code == "sweep/set" => {
            return Err(Diagnostic { place: places.place("set"), ..*d }.into());
        }
        Err(_) => expansion.varied(index).map_err(|e| Diagnostic::input("sweep/path", e))?,
        Ok(spec) => spec,
    };
    let Ok(spec) = typed(&spec, &expansion.file) else {
        // a combination of sound values that is unsound together: it becomes bad input
        let text = format!("{} {spec}", env!("CARGO_PKG_VERSION"));
        let key = blake3::hash(text.as_bytes()).to_hex()[..32].to_string();
        return Ok(Some(Case { index, name, key }));
    };
    if !conditions.is_empty() && !holds(&spec, conditions, kit, places)? {
        return Ok(None);
    }
    let common = commons.get(spec.template.as_str()).map_or("", String::as_str);
    let key = key(&spec, common);
    Ok(Some(Case { index, name, key }))
}

/// Whether all conditions hold. A spec whose names have no values is kept: its check reports why.
fn holds(
    spec: &ConnectionSpec,
    conditions: &[Expr],
    kit: &Kit,
    places: &PlaceIndex,
) -> Result<bool, Box<Diagnostic>> {
    let Ok(template) = kit.template(spec) else { return Ok(true) };
    let Ok(scope) = names(spec, template, &kit.catalog) else { return Ok(true) };
    let mut lookup = |name: &str| -> Result<Value, String> {
        scope.get(name).or_else(|why| {
            // in the spec the bolts stand under `bolts`, in templates a bolt is `bolt`
            let other = name.strip_prefix("bolts.").map(|rest| scope.get(&format!("bolt.{rest}")));
            other.and_then(Result::ok).ok_or(why)
        })
    };
    for (i, condition) in conditions.iter().enumerate() {
        let truth = condition.eval_truth(&mut lookup).map_err(|e| {
            let d = Diagnostic::input("sweep/where", e.to_string()).help(
                "conditions use the names of the template (`bracket templates NAME`): \
                 `plate.thickness >= bolt.d / 2`",
            );
            Diagnostic { place: places.place(&format!("where[{i}]")), ..d }
        })?;
        if !truth {
            return Ok(false);
        }
    }
    Ok(true)
}

/// Makes the names unique; reports names for the same joint.
fn unique(cases: &mut [Case]) -> Vec<String> {
    let mut seen: HashMap<String, u32> = HashMap::with_capacity(cases.len());
    for case in cases.iter_mut() {
        let n = seen.entry(case.name.clone()).or_default();
        *n += 1;
        if *n > 1 {
            case.name = format!("{} ({n})", case.name);
        }
    }
    let mut first: HashMap<&str, &str> = HashMap::with_capacity(cases.len());
    let mut same = BTreeSet::new();
    for case in cases.iter() {
        match first.get(case.key.as_str()) {
            Some(name) => drop(same.insert(format!("`{}` and `{name}`", case.name))),
            None => drop(first.insert(&case.key, &case.name)),
        }
    }
    let count = same.len();
    let shown: Vec<String> = same.into_iter().take(3).collect();
    match count {
        0 => Vec::new(),
        n if n > shown.len() => {
            vec![format!("{n} cases repeat another joint, for example {}", shown.join(", "))]
        }
        _ => vec![format!("the same joint, computed once: {}", shown.join(", "))],
    }
}
