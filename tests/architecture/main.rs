//! The rules of `ARCHITECTURE.md` that a machine can check.

use std::fs;
use std::path::{Path, PathBuf};

/// The stages in the order of the data flow; a stage uses itself and earlier ones.
const STAGES: [&str; 13] = [
    "spec", "catalog", "assembly", "geometry", "mesh", "model", "solve", "bounds", "adapt",
    "checks", "report", "batch", "cli",
];

/// Below everything: any stage may use them, they use only each other.
const FOUNDATION: [&str; 5] = ["diag", "diag_render", "text_file", "units", "math"];

/// Longest source file in lines.
const LONGEST: usize = 600;

/// Files that are longer for a stated reason.
const ARGUED: [(&str, &str); 0] = [];

/// Crates that one place alone may name, and that place.
const CONFINED: [(&str, &str); 5] = [
    ("serde_yaml", "src/spec/yaml"),
    ("saphyr", "src/spec/yaml"),
    ("parry3d_f64", "src/geometry/proximity"),
    ("clarabel", "src/solve/"),
    ("microlp", "src/checks/component_method/equilibrium"),
];

/// Folders that are no part of the project's text.
const SKIPPED: [&str; 5] = ["target", ".git", ".venv", "results", "__pycache__"];

fn root() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR"))
}

/// Every file below `dir`, as path relative to the root with `/`, in order.
fn files(dir: &Path, found: &mut Vec<String>) {
    let mut entries: Vec<_> =
        fs::read_dir(dir).expect("folder").map(|e| e.expect("entry").path()).collect();
    entries.sort();
    for path in entries {
        let name = path.file_name().and_then(|n| n.to_str()).expect("UTF-8 name");
        if path.is_dir() {
            if !SKIPPED.contains(&name) {
                files(&path, found);
            }
        } else {
            let relative = path.strip_prefix(root()).expect("below the root");
            found.push(
                relative
                    .components()
                    .map(|c| c.as_os_str().to_string_lossy())
                    .collect::<Vec<_>>()
                    .join("/"),
            );
        }
    }
}

fn sources() -> Vec<(String, String)> {
    let mut found = Vec::new();
    files(&root().join("src"), &mut found);
    found.retain(|f| f.ends_with(".rs"));
    assert!(found.len() > 10, "the sources are found");
    found
        .into_iter()
        .map(|f| (f.clone(), fs::read_to_string(root().join(&f)).expect("UTF-8 source")))
        .collect()
}

/// The text without comments and without unit tests, which may look at later stages.
fn code(text: &str) -> String {
    text.lines()
        .take_while(|l| l.trim() != "#[cfg(test)]")
        .map(|l| l.split("//").next().unwrap_or_default())
        .collect::<Vec<_>>()
        .join("\n")
}

/// Paths after `crate::`, two steps deep: `mesh::tet`, `diag`; groups in braces are opened.
fn used(code: &str) -> Vec<String> {
    let mut paths = Vec::new();
    for (at, _) in code.match_indices("crate::") {
        let before = code[..at].chars().next_back();
        if before.is_some_and(|c| c == '$' || c == '_' || c.is_alphanumeric()) {
            continue;
        }
        open(&code[at + "crate::".len()..], "", &mut paths);
    }
    paths
}

fn open(text: &str, prefix: &str, paths: &mut Vec<String>) {
    if let Some(group) = text.strip_prefix('{') {
        let mut depth = 0;
        let mut start = 0;
        for (i, c) in group.char_indices() {
            match c {
                '{' => depth += 1,
                '}' if depth > 0 => depth -= 1,
                ',' | '}' if depth == 0 => {
                    open(group[start..i].trim(), prefix, paths);
                    start = i + 1;
                    if c == '}' {
                        return;
                    }
                }
                _ => {}
            }
        }
        return;
    }
    let word: String = text.chars().take_while(|c| c.is_alphanumeric() || *c == '_').collect();
    let rest = &text[word.len()..];
    match rest.strip_prefix("::") {
        Some(rest) if prefix.is_empty() => open(rest, &word, paths),
        _ if prefix.is_empty() => paths.push(word),
        _ => paths.push(format!("{prefix}::{word}")),
    }
}

/// Why a file of `stage` may not use `path`; nothing if it may.
fn backward(stage: &str, path: &str) -> Option<String> {
    let target = path.split("::").next().unwrap_or_default();
    if FOUNDATION.contains(&target) || path.starts_with("spec::yaml") && STAGES.contains(&stage) {
        return None;
    }
    if FOUNDATION.contains(&stage) {
        return Some(format!("{stage} lies below every stage and uses {path}"));
    }
    let place = |name: &str| STAGES.iter().position(|s| *s == name);
    match (place(stage), place(target)) {
        (Some(from), Some(to)) if to <= from => None,
        (Some(_), Some(_)) => Some(format!("{stage} uses {path}, a later stage")),
        (None, _) => Some(format!("{stage} is no stage of ARCHITECTURE.md")),
        (_, None) => Some(format!("{stage} uses {path}, which is no stage of ARCHITECTURE.md")),
    }
}

#[test]
fn dependencies_point_one_way() {
    let mut faults = Vec::new();
    for (file, text) in sources() {
        let stage =
            file.trim_start_matches("src/").split(['/', '.']).next().unwrap_or_default().to_owned();
        if stage == "lib" || stage == "main" {
            continue;
        }
        for path in used(&code(&text)) {
            faults.extend(backward(&stage, &path).map(|why| format!("{file}: {why}")));
        }
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

#[test]
fn files_stay_short() {
    let long: Vec<String> = sources()
        .into_iter()
        .filter(|(file, _)| !ARGUED.iter().any(|(f, _)| f == file))
        .map(|(file, text)| (file, text.lines().count()))
        .filter(|(_, lines)| *lines > LONGEST)
        .map(|(file, lines)| {
            format!(
                "{file}: {lines} lines, at most {LONGEST} (one noun a file; or argue it in ARGUED)"
            )
        })
        .collect();
    assert!(long.is_empty(), "{}", long.join("\n"));
}

#[test]
fn crates_stay_in_their_rooms() {
    let mut faults = Vec::new();
    for (file, text) in sources() {
        for (name, place) in CONFINED {
            if !file.starts_with(place) && names_crate(&code(&text), name) {
                faults.push(format!("{file} names `{name}`, which belongs to {place}"));
            }
        }
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

/// Whether code names a crate in a path or a `use`: `serde_yaml::…`, `use serde_yaml;`, never
/// `self::clarabel`.
fn names_crate(code: &str, name: &str) -> bool {
    let word = |c: char| c.is_alphanumeric() || c == '_';
    code.match_indices(name).any(|(at, _)| {
        let (before, after) = (&code[..at], &code[at + name.len()..]);
        let inner = before.ends_with(word) || before.ends_with("::") && !before.ends_with(" ::");
        let line = before.rsplit('\n').next().unwrap_or_default().trim_start();
        let used = line.starts_with("use ") || line.starts_with("extern crate ");
        !inner
            && !after.starts_with(word)
            && (after.starts_with("::") || used && after.starts_with([';', ' ']))
    })
}

/// A path of somebody's machine: a home, root or scratch folder at the start of a path.
fn machine_path(line: &str) -> Option<String> {
    ["home", "root", "tmp", "work", "Users"].iter().map(|d| format!("/{d}/")).find(|p| {
        line.match_indices(p.as_str()).any(|(at, _)| {
            !line[..at].ends_with(|c: char| {
                c.is_alphanumeric() || matches!(c, '_' | '-' | '.' | '/' | '}' | '*')
            })
        })
    })
}

/// The files under version control; without git, every file of the folder.
fn tracked() -> Vec<String> {
    let git =
        std::process::Command::new("git").arg("-C").arg(root()).args(["ls-files", "-z"]).output();
    let mut found = match git {
        Ok(out) if out.status.success() && !out.stdout.is_empty() => {
            out.stdout.split(|b| *b == 0).map(|f| String::from_utf8_lossy(f).into_owned()).collect()
        }
        _ => {
            let mut found = Vec::new();
            files(&root(), &mut found);
            found
        }
    };
    found.retain(|f| !f.is_empty());
    assert!(found.iter().any(|f| f == "Cargo.toml"), "the project's files are found");
    found
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
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

/// The map shows every room that exists.
#[test]
fn the_map_names_every_module() {
    let map = fs::read_to_string(root().join("ARCHITECTURE.md")).expect("ARCHITECTURE.md");
    let library = fs::read_to_string(root().join("src/lib.rs")).expect("src/lib.rs");
    for module in
        library.lines().filter_map(|l| l.strip_prefix("pub mod ")).map(|m| m.trim_end_matches(';'))
    {
        let known = STAGES.contains(&module) || FOUNDATION.contains(&module);
        assert!(known, "src/lib.rs has `{module}`, which this test does not know");
        let shown = [format!("{module}/"), format!("{module}.rs")].iter().any(|m| map.contains(m));
        assert!(shown, "ARCHITECTURE.md does not show `{module}`");
    }
}

/// The checks themselves: each fires on what it forbids and is silent on what it allows.
#[test]
fn the_checks_can_fail() {
    let text = "use crate::diag::X;\nuse crate::{mesh::{tet, msh}, model::analysis::A};\nlet a = \
                crate::cli::run();\n// crate::batch\n#[cfg(test)]\nuse crate::report::B;";
    assert_eq!(
        used(&code(text)),
        ["diag::X", "mesh::tet", "mesh::msh", "model::analysis", "cli::run"]
    );
    assert!(backward("mesh", "cli::run").is_some());
    assert!(backward("mesh", "model::analysis").is_some());
    assert!(backward("model", "mesh::tet").is_none());
    assert!(backward("mesh", "mesh::tet").is_none());
    assert!(backward("solve", "spec::yaml").is_none());
    assert!(backward("catalog", "spec::connection").is_none());
    assert!(backward("spec", "catalog::Catalog").is_some());
    assert!(backward("diag", "mesh::tet").is_some());
    assert!(backward("units", "spec::yaml").is_some());
    assert!(backward("diag", "units::Mm").is_none());
    assert!(backward("helpers", "diag").is_none() && backward("helpers", "mesh").is_some());
    assert!(names_crate("let v = serde_yaml::from_str(t);", "serde_yaml"));
    assert!(
        names_crate("use clarabel;", "clarabel")
            && names_crate("use clarabel::solver;", "clarabel")
    );
    assert!(
        !names_crate("pub mod clarabel;", "clarabel")
            && !names_crate("super::clarabel::solve()", "clarabel")
    );
    for bad in ["/ho@me/me/x", "see /wo@rk/a", "\"/t@mp/a\"", "(/ro@ot/b)", "/Us@ers/x"] {
        assert!(machine_path(&bad.replace('@', "")).is_some(), "{bad}");
    }
    for good in ["target/tmp/a", "https://x.org/home/a", "../work/b", "$root/.venv", "a / root / b"]
    {
        assert!(machine_path(good).is_none(), "{good}");
    }
}
