//! The documents agree with the program: they explain every key of `result.json`, the specs of the
//! guide are valid, links lead to existing targets, and the README is short.

use bracket::batch::results_table::{Column, columns};
use serde_json::Value;
use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

/// Maximum number of lines of the README, which users read in one go.
const README_LINES: usize = 150;

/// The type that is written as `result.json`.
const RESULT_TYPE: &str = "ResultFile";

fn root() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR"))
}

fn read(path: &str) -> String {
    fs::read_to_string(root().join(path)).unwrap_or_else(|e| panic!("{path}: {e}"))
}

/// All files with this ending below a folder, as paths relative to the root.
fn files(folder: &str, ending: &str) -> Vec<String> {
    let mut found = Vec::new();
    let entries = fs::read_dir(root().join(folder)).expect(folder);
    let mut entries: Vec<_> = entries.map(|e| e.expect("entry")).collect();
    entries.sort_by_key(fs::DirEntry::file_name);
    for entry in entries {
        let path = format!("{folder}/{}", entry.file_name().to_string_lossy());
        if entry.path().is_dir() {
            found.extend(files(&path, ending));
        } else if path.ends_with(ending) {
            found.push(path);
        }
    }
    found
}

/// The words in backticks. A path such as `cases[].gap` or `joint.lower` gives each of its parts.
fn explained(document: &str) -> BTreeSet<String> {
    let spans = document.lines().flat_map(|line| line.split('`').skip(1).step_by(2));
    let parts = spans.flat_map(|span| span.split('.')).map(|part| part.trim_end_matches("[]"));
    parts.map(str::to_owned).collect()
}

/// All keys of a JSON document. Names given by the user are never keys of `result.json`.
fn keys(value: &Value, found: &mut BTreeSet<String>) {
    match value {
        Value::Object(map) => {
            for (key, value) in map {
                found.insert(key.clone());
                keys(value, found);
            }
        }
        Value::Array(items) => items.iter().for_each(|item| keys(item, found)),
        _ => {}
    }
}

/// A type of the source that serde writes: the names of its fields or variants, and the types in
/// it.
#[derive(Clone, Debug, Default)]
struct Written {
    file: String,
    names: BTreeSet<String>,
    types: BTreeSet<String>,
}

fn snake(name: &str) -> String {
    let mut out = String::new();
    for c in name.chars() {
        if c.is_uppercase() && !out.is_empty() {
            out.push('_');
        }
        out.extend(c.to_lowercase());
    }
    out
}

/// The name after `rename = "` in the attributes of a field.
fn renamed(attributes: &str) -> Option<String> {
    let (_, rest) = attributes.split_once("rename = \"")?;
    rest.split('"').next().map(str::to_owned)
}

/// Types of a source file that derive `Serialize` and `Deserialize`, by name. The parser
/// expects the format of rustfmt: one field or variant per line and the closing brace in the first
/// column.
fn written(file: &str, source: &str, found: &mut BTreeMap<String, Vec<Written>>) {
    let mut derives = String::new();
    let mut lines = source.lines();
    while let Some(line) = lines.next() {
        if line.starts_with("#[") {
            derives.push_str(line);
            continue;
        }
        let line = line.strip_prefix("pub ").unwrap_or(line);
        let of_struct = line.strip_prefix("struct ");
        let head = of_struct.or_else(|| line.strip_prefix("enum "));
        let serde = derives.contains("Serialize") && derives.contains("Deserialize");
        let container = std::mem::take(&mut derives);
        let Some(head) = head.filter(|h| serde && h.ends_with('{')) else { continue };
        let name: String = head.chars().take_while(|c| c.is_alphanumeric()).collect();
        let mut entry = Written { file: file.to_owned(), ..Written::default() };
        // serde writes another type in its place
        let (_, other) = container.split_once("into = \"").unwrap_or_default();
        entry.types.extend(other.split('"').next().filter(|t| !t.is_empty()).map(str::to_owned));
        let mut attributes = String::new();
        for line in lines.by_ref().take_while(|line| *line != "}") {
            let line = line.trim();
            if line.starts_with("//") || line.is_empty() {
                continue;
            }
            if line.starts_with("#[") {
                attributes.push_str(line);
                continue;
            }
            let attributes = std::mem::take(&mut attributes);
            let letters = line.trim_start_matches("pub ").chars();
            let word: String = letters.take_while(|c| c.is_alphanumeric() || *c == '_').collect();
            let skipped = attributes.contains("serde(skip)");
            if word.is_empty() || skipped || !other.is_empty() {
                continue;
            }
            let is_field = of_struct.is_some();
            let plain = if is_field { word } else { snake(&word) };
            let rest = line.split_once(if is_field { ": " } else { "(" }).map_or("", |(_, t)| t);
            // serde writes only the contents of the variants of an untagged enum
            if !container.contains("untagged") {
                entry.names.insert(renamed(&attributes).unwrap_or(plain));
            }
            let types = rest.split(|c: char| !c.is_alphanumeric()).filter(|t| !t.is_empty());
            entry.types.extend(types.map(str::to_owned));
        }
        found.entry(name).or_default().push(entry);
    }
}

/// The names that serde can write into `result.json`, each with the type it belongs to.
fn names_of_the_source() -> BTreeMap<String, String> {
    let mut all = BTreeMap::new();
    for file in ["src", "crates"].iter().flat_map(|f| files(f, ".rs")) {
        written(&file, &read(&file), &mut all);
    }
    assert!(all.contains_key(RESULT_TYPE), "no type {RESULT_TYPE}: has result.json another root?");
    let mut names = BTreeMap::new();
    let mut seen = BTreeSet::new();
    let mut todo = vec![(RESULT_TYPE.to_owned(), String::new())];
    while let Some((name, user)) = todo.pop() {
        let Some(candidates) = all.get(&name) else { continue };
        // of several types with the name the one in the same file is meant, else that of the same
        // crate, else each of them
        let of_crate = |file: &str| file.split("/src/").next().map(str::to_owned);
        let same: [&dyn Fn(&Written) -> bool; 3] =
            [&|w| w.file == user, &|w| of_crate(&w.file) == of_crate(&user), &|_| true];
        let chosen = |of: &&dyn Fn(&Written) -> bool| -> Vec<&Written> {
            candidates.iter().filter(|w| of(w)).collect()
        };
        let meant = same.iter().map(chosen).find(|some| !some.is_empty()).unwrap_or_default();
        for w in meant {
            if seen.insert((name.clone(), w.file.clone())) {
                names.extend(w.names.iter().map(|n| (n.clone(), format!("{name} in {}", w.file))));
                todo.extend(w.types.iter().map(|t| (t.clone(), w.file.clone())));
            }
        }
    }
    names
}

/// docs/results.md explains every key that the source can write and every key of the golden result.
#[test]
fn every_key_of_a_result_is_explained() {
    let explained = explained(&read("docs/results.md"));
    let golden: Value = serde_json::from_str(&read("tests/golden/result.json")).expect("JSON");
    let mut found = BTreeSet::new();
    keys(&golden, &mut found);
    let source = names_of_the_source();
    for key in ["cases", "half_plane", "static", "yield", "N mm/rad", "semi_rigid"] {
        assert!(source.contains_key(key), "the reader of the source missed `{key}`");
    }
    let unread: Vec<&String> = found.iter().filter(|k| !source.contains_key(*k)).collect();
    assert!(unread.is_empty(), "keys that the reader of the source missed: {unread:?}");
    let missing: Vec<String> = source
        .iter()
        .filter(|(key, _)| !explained.contains(*key))
        .map(|(key, place)| format!("`{key}` of {place}"))
        .collect();
    assert!(missing.is_empty(), "docs/results.md does not explain {missing:#?}");
}

#[test]
fn every_column_of_a_sweep_is_explained() {
    let explained = explained(&read("docs/contract.md"));
    let missing: Vec<String> =
        columns().map(Column::header).filter(|header| !explained.contains(header)).collect();
    assert!(missing.is_empty(), "not explained in docs/contract.md: {missing:?}");
}

#[test]
fn the_readme_is_short() {
    let lines = read("README.md").lines().count();
    assert!(lines <= README_LINES, "README.md has {lines} lines, more than {README_LINES}");
}

/// The documents for users.
fn documents() -> Vec<String> {
    let mut out = ["README.md", "CHANGELOG.md", "ARCHITECTURE.md"].map(str::to_owned).to_vec();
    for folder in ["docs", "examples", "catalogs", "templates", "benches"] {
        out.extend(files(folder, ".md"));
    }
    out
}

/// The anchor that common renderers give a heading: lower case, `-` for spaces, no punctuation.
fn anchor(heading: &str) -> String {
    let kept = heading.to_lowercase();
    let kept = kept.chars().filter(|c| c.is_alphanumeric() || " -_".contains(*c));
    kept.map(|c| if c == ' ' { '-' } else { c }).collect()
}

/// Lines outside fenced blocks.
fn prose(text: &str) -> Vec<&str> {
    let mut fenced = false;
    let outside = |line: &&str| {
        let fence = line.trim_start().starts_with("```");
        fenced ^= fence;
        !fenced && !fence
    };
    text.lines().filter(outside).collect()
}

/// The anchors of a document.
fn anchors(text: &str) -> Vec<String> {
    let headings = prose(text).into_iter().filter(|line| line.starts_with('#'));
    headings.map(|line| anchor(line.trim_start_matches('#').trim())).collect()
}

/// Whether a relative link of a document leads to a file, and to a heading if it names one.
fn leads_somewhere(document: &str, target: &str) -> bool {
    let (path, heading) = target.split_once('#').unwrap_or((target, ""));
    let mut place = root().join(document);
    if !path.is_empty() {
        place = place.parent().expect("a file has a folder").join(path);
    }
    match fs::read_to_string(&place) {
        Ok(text) => heading.is_empty() || anchors(&text).iter().any(|a| a == heading),
        Err(_) => heading.is_empty() && place.exists(),
    }
}

#[test]
fn relative_links_lead_to_files_and_headings() {
    let mut broken = Vec::new();
    for document in documents() {
        let text = read(&document);
        let links = prose(&text).into_iter().flat_map(|line| line.split("](").skip(1));
        for target in links.filter_map(|rest| rest.split(')').next()) {
            if !target.contains("://") && !leads_somewhere(&document, target) {
                broken.push(format!("{document}: {target}"));
            }
        }
    }
    assert!(broken.is_empty(), "links that lead nowhere: {broken:#?}");
}

/// The YAML blocks of a document.
fn yaml_blocks(text: &str) -> Vec<String> {
    let blocks = text.split("```yaml\n").skip(1);
    blocks.filter_map(|rest| rest.split("\n```").next()).map(str::to_owned).collect()
}

/// The top-level keys of a block, each with its lines.
fn entries(block: &str) -> BTreeMap<String, String> {
    let mut out: BTreeMap<String, String> = BTreeMap::new();
    let mut key = String::new();
    for line in block.lines() {
        if !line.starts_with([' ', '#', '-']) {
            key = line.split(':').next().unwrap_or("").to_owned();
        }
        *out.entry(key.clone()).or_default() += &format!("{line}\n");
    }
    out
}

/// A fragment in the guide replaces the keys of the first spec. The program accepts every spec that
/// results.
#[test]
fn the_specs_of_the_documents_are_valid() {
    let guide = read("docs/guide.md");
    let base = entries(&yaml_blocks(&guide)[0]);
    assert!(base.contains_key("template"), "the guide begins with a whole spec");
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("documents");
    // whatever an earlier version left there
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).expect("folder");
    let (mut tried, mut sweeps) = (0, 0);
    // the table of the section on load cases
    let forces = "Member No.;Node No.;Location x [m];LC/CO;N [kN];V-z [kN];M-y [kNm]\n\
                  12;3;0;CO1;5;20;-30\n12;3;0;CO91;5;15;-20\n12;3;0;GRAV;4;10;-15\n";
    fs::write(folder.join("forces.csv"), forces).expect("written");
    for block in yaml_blocks(&guide).into_iter().chain(yaml_blocks(&read("README.md"))) {
        let mut spec = entries(&block);
        if spec.contains_key("mesh") {
            continue;
        }
        if spec.contains_key("axes") {
            let text: String = base.clone().into_values().collect();
            fs::write(folder.join("joint.yaml"), text).expect("written");
            fs::write(folder.join("joints.csv"), "name,plate.width [mm]\nA,200\n")
                .expect("written");
            fs::write(folder.join("sweep.yaml"), &block).expect("written");
            let mut command = Command::new(env!("CARGO_BIN_EXE_bracket"));
            command.args(["batch", "plan", "sweep.yaml"]).current_dir(&folder);
            let run = command.output().expect("runs");
            assert!(run.status.success(), "{block}\n{}", String::from_utf8_lossy(&run.stderr));
            sweeps += 1;
            continue;
        }
        if !spec.contains_key("template") {
            spec = base.clone().into_iter().chain(spec).collect();
        }
        let file = folder.join(format!("spec_{tried}.yaml"));
        fs::write(&file, spec.into_values().collect::<String>()).expect("written");
        let mut command = Command::new(env!("CARGO_BIN_EXE_bracket"));
        let run = command.arg("check").arg(&file).output().expect("runs");
        let said = String::from_utf8_lossy(&run.stderr);
        let code = run.status.code();
        assert!(matches!(code, Some(0 | 1 | 3)), "exit code {code:?} of\n{block}\n{said}");
        tried += 1;
    }
    assert!(tried >= 10, "only {tried} specs were found");
    assert!(sweeps >= 1, "no sweep was found");
}

/// Only one table lists the exit codes, so that no second table can contradict it.
#[test]
fn the_exit_codes_stand_in_one_table() {
    let rows = |d: &String, start: &str| read(d).lines().any(|line| line.starts_with(start));
    // a table of exit codes has a row for code 0; benchmark cases have codes too
    let is_table = |d: &String| rows(d, "| code |") && rows(d, "| 0 |");
    let with: Vec<String> = documents().into_iter().filter(is_table).collect();
    assert_eq!(with, ["README.md"]);
}
