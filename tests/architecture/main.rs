//! The rules of `ARCHITECTURE.md` that a machine can check.
#![allow(clippy::unwrap_used)]

mod circles;
mod messages;
mod modules;
mod read_back;
mod spoken;
mod text;
mod the_checks_can_fail;
mod tokens;

use circles::{circles, described, reached};
use modules::{Modules, module_of};
use std::fs;
use std::sync::LazyLock;
use text::{columns, machine_path, root, rust_files, tracked};
use tokens::{names_crate, tokens, without_tests};

/// A crate of the workspace.
struct House {
    /// Folder of its `src`; `""` is the top level.
    folder: String,
    /// Name of its package.
    package: String,
    /// Its rooms in the order of the data flow. A room may use itself and earlier rooms.
    rooms: Vec<String>,
}

/// The crates with their rooms in the order of the arrows: the table of `ARCHITECTURE.md`. A crate
/// may use earlier crates only.
static HOUSES: LazyLock<Vec<House>> = LazyLock::new(|| {
    let map = fs::read_to_string(root().join("ARCHITECTURE.md")).expect("ARCHITECTURE.md");
    let rows = map.lines().filter_map(|l| l.strip_prefix("| `")?.split_once("src/` | "));
    let house = |(folder, row): (&str, &str)| House {
        folder: folder.to_owned(),
        package: match folder.strip_prefix("crates/") {
            Some(name) => format!("bracket-{}", name.trim_end_matches('/')),
            None => "bracket".to_owned(),
        },
        rooms: row.split('`').skip(1).step_by(2).map(str::to_owned).collect(),
    };
    let houses: Vec<House> = rows.map(house).collect();
    assert_eq!(houses.len(), 7, "the crates of ARCHITECTURE.md are found");
    houses
});

/// Maximum length of a Rust file in lines.
const LONGEST: usize = 450;

/// Files that are longer, each with the reason.
const ARGUED: [(&str, &str); 1] = [(
    "tests/commands/wrong_inputs/wrong_specs.rs",
    "a table: a row for each wrong spec and the message it gets",
)];

/// Maximum length of a line in characters.
const WIDEST: usize = 100;

/// Foreign crates that only certain places may name, and these places.
const CONFINED: [(&str, &[&str]); 8] = [
    ("serde_yaml", &["crates/base/src/yaml"]),
    ("saphyr", &["crates/base/src/yaml"]),
    ("parry3d_f64", &["crates/joint/src/geometry/proximity"]),
    ("clarabel", &["crates/engine/src/solve/"]),
    ("faer", &["crates/engine/src/solve/sparse/dense", "crates/base/src/math/dense"]),
    ("microlp", &["crates/codes/src/component_method/equilibrium", "crates/base/src/math/gauge"]),
    ("typst", &["crates/typeset/src/"]),
    ("clap", &["src/cli/", "src/main.rs"]),
];

impl House {
    /// The source files with their text, named as seen from the folder of the crate.
    fn files(&self) -> Vec<(String, String)> {
        let named = |(file, text): (String, String)| (file[self.folder.len()..].to_owned(), text);
        rust_files(&[&format!("{}src", self.folder)]).into_iter().map(named).collect()
    }

    fn modules(&self) -> Modules {
        Modules::read(&self.files())
    }

    /// The reason why code in `room` may not use `path`, which lies in the room `target`. `None` if
    /// it may.
    fn backward(&self, room: &str, target: &str, path: &str) -> Option<String> {
        let place = |name: &str| self.rooms.iter().position(|s| *s == name);
        match (place(room), place(target)) {
            (Some(from), Some(to)) if to <= from => None,
            (Some(_), Some(_)) => Some(format!("{room} uses {path} of {target}, a later room")),
            (None, _) => Some(format!("{room} is no room of ARCHITECTURE.md")),
            (_, None) => Some(format!("{room} uses {path}, which is in no room of it")),
        }
    }
}

fn assert_none(faults: Vec<String>) {
    assert!(faults.is_empty(), "\n{}", faults.join("\n"));
}

#[test]
fn rooms_use_earlier_rooms_only() {
    let mut faults = Vec::new();
    for house in HOUSES.iter() {
        for (module, used) in house.modules().rooms() {
            let room = module.split("::").next().unwrap();
            for (target, path) in used {
                let why = house.backward(room, &target, &path);
                faults.extend(why.map(|why| format!("{}{module}: {why}", house.folder)));
            }
        }
    }
    assert_none(faults);
}

/// Cargo refuses circles of crates. This keeps their order: the engine knows no joint, the joint no
/// design code.
#[test]
fn crates_use_earlier_crates_only() {
    let mut faults = Vec::new();
    for (i, house) in HOUSES.iter().enumerate() {
        let file = format!("{}Cargo.toml", house.folder);
        let manifest = fs::read_to_string(root().join(&file)).expect("manifest");
        let (_, package) = manifest.split_once("[package]").expect("a package");
        assert!(package.contains(&format!("name = \"{}\"", house.package)), "{file}");
        let (_, after) = package.split_once("[dependencies]").expect("dependencies");
        let after = after.split("\n[").next().expect("the section");
        let known = |name: &str| HOUSES[..i].iter().any(|h| h.package == name);
        for line in after.lines().filter(|l| l.starts_with("bracket")) {
            let name = line.split(['.', ' ', '=']).next().unwrap();
            if !known(name) {
                faults.push(format!("{file} uses {name}, which is not an earlier crate"));
            }
        }
    }
    assert_none(faults);
}

#[test]
fn no_circles_of_imports() {
    let mut faults = Vec::new();
    let mut modules = 0;
    for house in HOUSES.iter() {
        let graph = house.modules().graph();
        assert!(graph.len() >= house.rooms.len(), "the modules of {} are found", house.package);
        modules += graph.len();
        faults.extend(circles(&graph).iter().map(|circle| described(&graph, circle)));
    }
    assert!(modules > 400, "only {modules} modules are found");
    assert_none(faults);
}

/// The certificates share no code with the solver or with the programs that it solves, not even
/// through other modules.
#[test]
fn certify_is_independent_of_the_solver_and_its_programs() {
    let graph = HOUSES[1].modules().graph();
    let mut faults = Vec::new();
    let certify: Vec<&String> = graph.keys().filter(|m| m.starts_with("certify::")).collect();
    assert!(!certify.is_empty(), "the certificates are found");
    for module in certify {
        for target in reached(&graph, module) {
            if ["solve", "programs"].contains(&target.split("::").next().unwrap()) {
                faults.push(format!("{module} uses {target}, directly or through others"));
            }
        }
    }
    assert_none(faults);
}

#[test]
fn files_stay_short() {
    let mut faults = Vec::new();
    for (file, text) in rust_files(&["crates", "src", "tests", "benches"]) {
        let lines = text.lines().count();
        let argued = ARGUED.iter().any(|(f, _)| *f == file);
        if lines > LONGEST && !argued {
            faults.push(format!(
                "{file}: {lines} lines, at most {LONGEST} (one noun a file; or argue it in ARGUED)"
            ));
        }
        if lines <= LONGEST && argued {
            faults.push(format!("{file}: {lines} lines need no entry in ARGUED"));
        }
    }
    assert_none(faults);
}

#[test]
fn lines_stay_narrow() {
    let mut faults = Vec::new();
    for (file, text) in rust_files(&["crates", "src", "tests", "benches"]) {
        for (i, line) in text.lines().enumerate().filter(|(_, l)| columns(l) > WIDEST) {
            faults.push(format!("{file} line {}: {} columns", i + 1, columns(line)));
        }
    }
    assert_none(faults);
}

/// A crate that may be replaced one day is named in one place only. Unit tests are exempt: they may
/// use crates as oracles that the code may not use.
#[test]
fn crates_stay_in_their_rooms() {
    let mut faults = Vec::new();
    for house in HOUSES.iter() {
        let files = house.files();
        let modules = Modules::read(&files);
        for (file, text) in files.iter().filter(|(file, _)| modules.contains(&module_of(file))) {
            let (code, _) = without_tests(&tokens(text));
            let file = format!("{}{file}", house.folder);
            for (name, places) in CONFINED {
                if !places.iter().any(|p| file.starts_with(p)) && names_crate(&code, name) {
                    faults.push(format!("{file} names `{name}`, which belongs to {places:?}"));
                }
            }
        }
    }
    assert_none(faults);
}

#[test]
fn no_machine_paths_in_text() {
    let mut faults = Vec::new();
    for file in tracked() {
        let Ok(text) = fs::read_to_string(root().join(&file)) else { continue };
        for (i, line) in text.lines().enumerate() {
            faults.extend(machine_path(line).map(|p| format!("{file} line {}: {p}", i + 1)));
        }
    }
    assert_none(faults);
}

/// `ARCHITECTURE.md` shows every room, and no other.
#[test]
fn the_map_names_every_room() {
    let mut faults = Vec::new();
    for house in HOUSES.iter() {
        let file = format!("{}src/lib.rs", house.folder);
        let library = fs::read_to_string(root().join(&file)).expect("lib.rs");
        let modules = library.lines().filter_map(|l| l.strip_prefix("pub mod "));
        let modules: Vec<&str> = modules.map(|m| m.trim_end_matches(';')).collect();
        let hidden = modules.iter().filter(|m| !house.rooms.iter().any(|r| r == *m));
        faults.extend(hidden.map(|m| format!("ARCHITECTURE.md does not show `{m}` of {file}")));
        let gone = house.rooms.iter().filter(|r| !modules.contains(&r.as_str()));
        faults.extend(gone.map(|r| format!("ARCHITECTURE.md shows `{r}`, which {file} has not")));
    }
    assert_none(faults);
}
