//! Reads a connection spec from its file, with its catalogue and its joint.

use crate::driver::demands::demands;
use bracket_base::diag::{Diagnostic, Diagnostics};
use bracket_base::text_file;
use bracket_base::yaml::{self, Parsed};
use bracket_codes::{Check, design_code, joint_checks};
use bracket_engine::model::AnalysisKind;
use bracket_joint::assembly::template_file::{Templates, stored_name};
use bracket_joint::assembly::{Joint, LoadedTemplate};
use bracket_joint::catalog::{Catalog, CatalogError};
use bracket_joint::model_file;
use bracket_joint::spec::analysis::Combinations;
use bracket_joint::spec::connection::ConnectionSpec;
use bracket_joint::spec::polygon::PolygonFault;
use bracket_joint::spec::table_loads::{expand, written};
use bracket_report::result::folder::ResultFolder;
use std::path::Path;

/// A spec, its text and the joint it describes.
pub struct SpecFile {
    /// The text of the file.
    pub text: String,
    /// The spec with its places; its loads include the directions of its polygon.
    pub spec: Parsed<ConnectionSpec>,
    /// The joint.
    pub joint: Joint,
    /// The catalogue used to resolve the spec.
    pub catalog: Catalog,
    /// The texts of the user's own templates, in the order in which they extend each other.
    pub templates: Vec<String>,
    /// The load cases of the table that the spec names, in Bracket's own form.
    pub load_table: Option<String>,
    /// Whether the run makes what a verdict by analysis needs, and no more.
    pub decide: bool,
}

/// Load cases up to which limit analysis is run for each by default.
const EACH: usize = 12;

/// Folder inside a result folder with the templates and tables of the user, so that `verify` can
/// read the spec there.
const STORED: &str = "input";
/// Folder inside it with the tables.
const STORED_TABLES: &str = "catalog";
/// File inside it with the load cases of a table.
const STORED_LOADS: &str = "loads.csv";

impl SpecFile {
    /// The kinds of analysis to run.
    pub fn kinds(&self) -> Vec<AnalysisKind> {
        self.spec.value.analysis.kinds(self.decide)
    }

    /// The kinds that stand for one in place of those of the spec: limit analysis brings what a
    /// verdict needs.
    pub fn kinds_for(&self, kind: AnalysisKind) -> Vec<AnalysisKind> {
        match kind {
            AnalysisKind::Limit if self.decide => vec![kind, AnalysisKind::Elastoplastic],
            _ => vec![kind],
        }
    }

    /// Whether the bolts of this kind of analysis stay elastic although plates yield.
    pub fn elastic_bolts(&self, kind: AnalysisKind) -> bool {
        self.spec.value.analysis.elastic_bolts(kind, self.decide)
    }

    /// Whether limit analysis is run for as few load cases as bound all of them. Other kinds of
    /// analysis, a polygon and estimates under Coulomb's law need each case itself.
    pub fn covers(&self, kinds: &[AnalysisKind]) -> bool {
        let many = || model_file::cases(&self.joint.assembly).len() > EACH;
        self.needs_each(kinds).is_none()
            && match self.spec.value.analysis.combinations {
                Some(Combinations::Covered) => true,
                Some(Combinations::Each) => false,
                None => many(),
            }
    }

    /// What makes an analysis of each load case necessary; `None` where limit analyses of some may
    /// bound the others.
    pub fn needs_each(&self, kinds: &[AnalysisKind]) -> Option<&'static str> {
        let spec = &self.spec.value;
        if *kinds != [AnalysisKind::Limit] {
            Some("another kind of analysis than `limit`")
        } else if spec.polygon.is_some() {
            Some("a polygon")
        } else if spec.analysis.coulomb_estimate {
            Some("`coulomb_estimate`")
        } else {
            None
        }
    }

    /// Writes the user's own templates and tables into a result folder.
    pub fn store(&self, folder: &ResultFolder) -> Result<(), Diagnostics> {
        for (i, text) in self.templates.iter().enumerate() {
            folder.write(&format!("{STORED}/{}", stored_name(i)), text.as_bytes())?;
        }
        for (name, text) in self.catalog.own_tables() {
            folder.write(&format!("{STORED}/{STORED_TABLES}/{name}"), text.as_bytes())?;
        }
        if let Some(loads) = &self.load_table {
            folder.write(&format!("{STORED}/{STORED_LOADS}"), loads.as_bytes())?;
        }
        Ok(())
    }
}

/// Reads a spec and builds its joint. `catalog_dir` is the folder of `--catalog`, which takes
/// precedence over `catalog` in the spec.
pub fn read(path: &Path, catalog_dir: Option<&Path>) -> Result<SpecFile, Diagnostics> {
    parse(&text(path)?, path, catalog_dir)
}

/// The text of a spec.
pub fn text(path: &Path) -> Result<String, Diagnostics> {
    let text = text_file::read(path, |e| {
        Diagnostic::input("spec/read", format!("the spec `{}` cannot be read: {e}", path.display()))
            .file(path)
            .help("check the path; `bracket new TEMPLATE -o FILE` writes a starter spec")
    })?;
    Ok(text)
}

/// The spec with this text. Its templates and tables are looked up beside `path`.
pub fn parse(text: &str, path: &Path, catalog_dir: Option<&Path>) -> Result<SpecFile, Diagnostics> {
    let base = path.parent().unwrap_or(Path::new(""));
    with_templates(text, path, catalog_dir, Templates::Beside(base), None)
}

/// The spec of a result folder, with the templates and tables that [`SpecFile::store`] wrote there.
pub fn stored(text: &str, name: &str, folder: &Path) -> Result<SpecFile, Diagnostics> {
    let (own, path) = (folder.join(STORED), folder.join(name));
    let tables = Some(own.join(STORED_TABLES)).filter(|t| t.is_dir());
    let loads = own.join(STORED_LOADS);
    with_templates(text, &path, tables.as_deref(), Templates::Stored(&own), Some(&loads))
}

fn with_templates(
    text: &str,
    path: &Path,
    catalog_dir: Option<&Path>,
    templates: Templates<'_>,
    stored_loads: Option<&Path>,
) -> Result<SpecFile, Diagnostics> {
    let mut spec = yaml::parse::<ConnectionSpec>(text, path).map_err(|faults| {
        if yaml::top_level(text, &["mesh", "bodies"]) {
            let hint = "this looks like a model file: `bracket analyse` reads it";
            return faults.into_first().help(hint).into();
        }
        let what = match () {
            () if is_json(text) && !yaml::top_level(text, &["template"]) => "a JSON file",
            () if path.extension().is_some_and(|e| e.eq_ignore_ascii_case("csv")) => {
                "a table (CSV)"
            }
            () => return faults,
        };
        Diagnostics::from(text_file::not_ours(what, path))
    })?;
    let base = path.parent().unwrap_or(Path::new(""));
    let of_table = expand(&mut spec, base, stored_loads)?;
    let value = &mut spec.value;
    let load_table = of_table.then(|| written(&value.loads));
    if let Some(polygon) = &value.polygon {
        let directions = polygon.loads(&value.loads).map_err(|faults| {
            let reported = |f: PolygonFault| {
                let mut d = Diagnostic::input("spec/value", f.problem).help(f.help);
                d.place = spec.index.place(&f.path);
                d
            };
            faults.map(reported)
        })?;
        value.loads.extend(directions);
    }
    let catalog = open_catalog(&spec, base, catalog_dir)?;
    let template = LoadedTemplate::read(&spec, templates)?;
    let joint = design_code::build_from(&spec, &template, &catalog)?;
    let templates = template.own_texts().to_vec();
    let decide = spec.value.analysis.decide.unwrap_or_else(|| lacks_method(&spec.value, &joint));
    Ok(SpecFile { text: text.into(), spec, joint, catalog, templates, load_table, decide })
}

/// Whether a limit analysis is asked for of loads for which the code has no method.
fn lacks_method(spec: &ConnectionSpec, joint: &Joint) -> bool {
    let asked = spec.analysis.kind.0.contains(&AnalysisKind::Limit);
    let without = || match joint.facts {
        None => true,
        Some(_) => joint_checks(joint).checks.iter().any(Check::is_without_method),
    };
    asked && !demands(&spec.loads).is_empty() && without()
}

/// True for a text that a program wrote as JSON.
fn is_json(text: &str) -> bool {
    text.trim_start().starts_with(['{', '['])
        && serde_json::from_str::<serde_json::Value>(text).is_ok()
}

/// The built-in catalogue together with the folder of the option or of the spec.
fn open_catalog(
    spec: &Parsed<ConnectionSpec>,
    base: &Path,
    catalog_dir: Option<&Path>,
) -> Result<Catalog, Diagnostics> {
    let of_spec = spec.value.catalog.as_deref();
    if of_spec.is_some_and(|dir| dir.as_os_str().is_empty()) {
        let mut d = Diagnostic::input("spec/value", "`catalog` names no folder").help(
            "write the folder with your .csv tables, relative to the spec, or leave the key out",
        );
        d.place = spec.index.place("catalog");
        return Err(d.into());
    }
    let read = match (catalog_dir, of_spec) {
        (Some(dir), _) => Catalog::with_dir(dir),
        (None, Some(dir)) => Catalog::with_dir(&base.join(dir)),
        (None, None) => Catalog::builtin(),
    };
    read.map_err(|fault| {
        let folder_itself = matches!(fault, CatalogError::Io { .. } | CatalogError::Empty { .. });
        let mut d = Diagnostic::from(fault);
        // a fault of the folder is reported where the folder is named, a fault of a table in the
        // table
        if let (true, None, Some(dir)) = (folder_itself, catalog_dir, of_spec) {
            d.message = format!("`catalog: {}`: {}", dir.display(), d.message);
            d.place = spec.index.place("catalog");
        }
        d.into()
    })
}

/// A warning of the catalogue in one line: place and message.
pub fn catalog_warning(w: &Diagnostic) -> String {
    let file = w.place.file.as_ref().map(|f| format!("{}: ", f.display())).unwrap_or_default();
    let line = w.place.line.map(|l| format!("line {l}: ")).unwrap_or_default();
    format!("warning[{}]: {file}{line}{w}", w.code)
}

#[cfg(test)]
mod tests {
    use super::*;

    const JOINT: &str = include_str!("../../examples/paper_joint/joint.yaml");
    const PROFILES: &str = "# source: mill sheet \
                            7\nname,series,standard,h_mm,b_mm,tw_mm,tf_mm,r_mm,mass_kg_per_m,\
                            A_cm2,Iy_cm4,Iz_cm4,Wel_y_cm3,Wpl_y_cm3,Wel_z_cm3,Wpl_z_cm3\nMY200,\
                            own,works drawing,200,200,9,15,18,61.3,78.1,5696,2003,569.6,642.5,200.\
                            3,305.8\n";

    /// A folder with `joint.yaml` (the paper's joint, with its own column) and the given tables.
    fn folder(catalog: &str, tables: &[(&str, &str)]) -> tempfile::TempDir {
        let dir = tempfile::tempdir().expect("a folder");
        let spec = format!("{catalog}{}", JOINT.replace("profile: HEB200", "profile: MY200"));
        std::fs::write(dir.path().join("joint.yaml"), spec).expect("written");
        for (name, text) in tables {
            let file = dir.path().join(name);
            std::fs::create_dir_all(file.parent().expect("a folder")).expect("made");
            std::fs::write(file, text).expect("written");
        }
        dir
    }

    fn fault(dir: &tempfile::TempDir, option: Option<&Path>) -> Diagnostic {
        read(&dir.path().join("joint.yaml"), option).map(drop).expect_err("refused").into_first()
    }

    #[test]
    fn a_folder_is_read_from_the_spec_and_the_option_wins() {
        let dir = folder("catalog: mine\n", &[("mine/p.csv", PROFILES)]);
        let read_it = |option: Option<&Path>| read(&dir.path().join("joint.yaml"), option);
        assert_eq!(
            read_it(None).unwrap_or_else(|e| panic!("{e:#?}")).joint.catalogue[1].1,
            "MY200"
        );
        let other = tempfile::tempdir().expect("a folder");
        std::fs::write(other.path().join("p.csv"), PROFILES.replace("MY200", "MY201"))
            .expect("written");
        let d = read_it(Some(other.path())).map(drop).expect_err("MY200 is not there").into_first();
        assert!(
            d.message.contains("`MY200` is not in the catalogue, the nearest is `MY201`"),
            "{d:#?}"
        );
    }

    #[test]
    fn without_a_folder_the_unknown_name_says_how_to_add_one() {
        let d = fault(&folder("", &[("mine/p.csv", PROFILES)]), None);
        assert_eq!(
            (d.code, d.place.path.as_deref()),
            ("catalog/unknown-name", Some("members.column.profile"))
        );
        assert!(d.help.as_deref().is_some_and(|h| h.contains("`--catalog DIR`")), "{d:#?}");
    }

    #[test]
    fn wrong_folders_are_refused_where_they_are_named() {
        let table = ("mine/p.csv", PROFILES);
        for (catalog, code, words) in [
            (
                "catalog: yours\n",
                "catalog/unreadable",
                "`catalog: yours`: cannot read the catalogue",
            ),
            ("catalog: mine/p.csv\n", "catalog/unreadable", "`catalog: mine/p.csv`"),
            ("catalog: empty\n", "catalog/empty", "holds no .csv file"),
            ("catalog: ''\n", "spec/value", "names no folder"),
            ("catalog: 5\n", "catalog/unreadable", "`catalog: 5`"),
            ("catalog: [mine]\n", "yaml/type", "expected a text"),
        ] {
            let d = fault(&folder(catalog, &[table, ("empty/readme.txt", "")]), None);
            assert!(
                d.code == code && d.message.contains(words) && d.help.is_some(),
                "{catalog}{d:#?}"
            );
            assert_eq!(
                (d.place.path.as_deref(), d.place.line),
                (Some("catalog"), Some(1)),
                "{catalog}{d:#?}"
            );
        }
        let dir = folder("catalog: mine\n", &[table]);
        let d = fault(&dir, Some(Path::new("nowhere")));
        assert_eq!(
            (d.code, d.place.file.as_deref()),
            ("catalog/unreadable", Some(Path::new("nowhere"))),
            "{d:#?}"
        );
    }

    #[test]
    fn a_fault_of_a_table_is_reported_in_the_table() {
        for (old, new, code) in [
            ("MY200,own", "HEB200,own", "catalog/duplicate-name"),
            (",9,15,", ",9;15,", "catalog/not-csv"),
            (",200,200,", ",200,20 cm,", "catalog/bad-cell"),
            ("tw_mm", "t_web_mm", "catalog/missing-column"),
        ] {
            let d = fault(
                &folder("catalog: mine\n", &[("mine/p.csv", &PROFILES.replacen(old, new, 1))]),
                None,
            );
            assert_eq!(d.code, code, "{d:#?}");
            assert!(d.place.file.as_ref().is_some_and(|f| f.ends_with("mine/p.csv")), "{d:#?}");
        }
    }
}
