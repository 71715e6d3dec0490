//! The rules of `ARCHITECTURE.md` that a machine can check.
#![allow(clippy::unwrap_used)]

mod circles;
mod modules;
mod text;
mod the_checks_can_fail;
mod tokens;

use circles::{circles, described, reached};
use modules::{Modules, module_of};
use std::fs;
use text::{columns, machine_path, root, rust_files, tracked};
use tokens::{names_crate, tokens, without_tests};

/// The stages in the order of the data flow. A stage may use itself and earlier stages.
const STAGES: [&str; 19] = [
    "spec", "catalog", "assembly", "geometry", "mesh", "elements", "model", "certify", "programs",
    "solve", "recover", "analysis", "refine", "checks", "result", "report", "driver", "batch",
    "cli",
];

/// Modules below all stages. Any stage may use them. They may use only each other.
const FOUNDATION: [&str; 5] = ["diag", "diag_render", "text_file", "units", "math"];

/// Maximum length of a Rust file in lines.
const LONGEST: usize = 450;

/// Files that are longer, each with the reason.
const ARGUED: [(&str, &str); 1] =
    [("tests/cli/wrong_specs.rs", "a table: a row for each wrong spec and the message it gets")];

/// Maximum length of a line in characters.
const WIDEST: usize = 100;

/// Crates that only certain places may name, and these places.
const CONFINED: [(&str, &[&str]); 7] = [
    ("serde_yaml", &["src/spec/yaml"]),
    ("saphyr", &["src/spec/yaml"]),
    ("parry3d_f64", &["src/geometry/proximity"]),
    ("clarabel", &["src/solve/"]),
    ("faer", &["src/solve/sparse/dense", "src/math/dense"]),
    ("microlp", &["src/checks/component_method/equilibrium"]),
    ("clap", &["src/cli/", "src/main.rs"]),
];

/// The source files of the library with their text.
fn library() -> Vec<(String, String)> {
    rust_files(&["src"])
}

/// The reason why code in `room` may not use `path`, which lies in the room `target`. `None` if it
/// may.
fn backward(room: &str, target: &str, path: &str) -> Option<String> {
    if FOUNDATION.contains(&target) {
        return None;
    }
    if FOUNDATION.contains(&room) {
        return Some(format!("{room} lies below every stage and uses {path}"));
    }
    let place = |name: &str| STAGES.iter().position(|s| *s == name);
    match (place(room), place(target)) {
        (Some(from), Some(to)) if to <= from => None,
        (Some(_), Some(_)) => Some(format!("{room} uses {path} of {target}, a later stage")),
        (None, _) => Some(format!("{room} is no stage of ARCHITECTURE.md")),
        (_, None) => Some(format!("{room} uses {path}, which is in no stage of ARCHITECTURE.md")),
    }
}

fn assert_none(faults: Vec<String>) {
    assert!(faults.is_empty(), "\n{}", faults.join("\n"));
}

#[test]
fn dependencies_point_one_way() {
    let mut faults = Vec::new();
    for (module, used) in Modules::read(&library()).rooms() {
        let room = module.split("::").next().unwrap();
        for (target, path) in used {
            faults.extend(backward(room, &target, &path).map(|why| format!("{module}: {why}")));
        }
    }
    assert_none(faults);
}

#[test]
fn no_circles_of_imports() {
    let graph = Modules::read(&library()).graph();
    assert!(graph.len() > 100, "the modules are found");
    assert_none(circles(&graph).iter().map(|circle| described(&graph, circle)).collect());
}

/// The certificates share no code with the solver or with the programs that it solves, not even
/// through other modules.
#[test]
fn certify_is_independent_of_the_solver_and_its_programs() {
    let graph = Modules::read(&library()).graph();
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
    for (file, text) in rust_files(&["src", "tests", "benches"]) {
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
    for (file, text) in rust_files(&["src", "tests", "benches"]) {
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
    let files = library();
    let modules = Modules::read(&files);
    let mut faults = Vec::new();
    for (file, text) in files.iter().filter(|(file, _)| modules.contains(&module_of(file))) {
        let (code, _) = without_tests(&tokens(text));
        for (name, places) in CONFINED {
            if !places.iter().any(|p| file.starts_with(p)) && names_crate(&code, name) {
                faults.push(format!("{file} names `{name}`, which belongs to {places:?}"));
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

/// `ARCHITECTURE.md` shows every room that exists.
#[test]
fn the_map_names_every_module() {
    let map = fs::read_to_string(root().join("ARCHITECTURE.md")).expect("ARCHITECTURE.md");
    let library = fs::read_to_string(root().join("src/lib.rs")).expect("src/lib.rs");
    let mut faults = Vec::new();
    for module in
        library.lines().filter_map(|l| l.strip_prefix("pub mod ")).map(|m| m.trim_end_matches(';'))
    {
        if !STAGES.contains(&module) && !FOUNDATION.contains(&module) {
            faults.push(format!("src/lib.rs has `{module}`, which this test does not know"));
        }
        if ![format!("{module}/"), format!("{module}.rs")].iter().any(|m| map.contains(m)) {
            faults.push(format!("ARCHITECTURE.md does not show `{module}`"));
        }
    }
    assert_none(faults);
}
