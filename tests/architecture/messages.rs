//! The messages of every language: one for each text that the program says, and none without one.

use super::assert_none;
use super::read_back::{content, literals};
use super::text::{root, rust_files};
use super::tokens::{tokens_with_literals, without_tests};
use bracket::words::has_words;
use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;

/// Folder of the languages, a folder each.
const LANGUAGES: &str = "crates/report/src/words";

/// A text as Rust and YAML write it between quotation marks.
fn unescaped(text: &str) -> String {
    text.replace("\\\"", "\"").replace("\\n", "\n").replace("\\\\", "\\")
}

/// The messages of a source: in `say!`, as the text of a heading or a paragraph, and in the rooms
/// that make texts also `"…".into()`.
fn said(file: &str, text: &str) -> Vec<String> {
    let (code, _) = without_tests(&tokens_with_literals(text));
    let makes_texts = ROOMS.iter().any(|room| file.starts_with(room));
    let id = |w: &[String]| match w.iter().map(String::as_str).collect::<Vec<_>>()[..] {
        ["say", "!", "(", id, ..] => content(id),
        [".", "heading" | "subheading" | "paragraph", "(", id, ..] => content(id),
        [id, ".", "into", "("] if makes_texts => content(id),
        _ => None,
    };
    code.windows(4).filter_map(id).map(|id| unescaped(&id)).collect()
}

/// Rooms in which a text that becomes something else is one for people.
const ROOMS: [&str; 11] = [
    "crates/codes/src/",
    "crates/report/src/markdown/",
    "crates/report/src/result/case_result.rs",
    "crates/report/src/result/energy_case.rs",
    "crates/report/src/result/limit_case.rs",
    "crates/report/src/summary.rs",
    "src/batch/capacity.rs",
    "src/batch/choice_table.rs",
    "src/batch/summary",
    "src/driver/judge.rs",
    "src/driver/solve.rs",
];

/// The messages of a language by id, with those that stand twice.
struct Language {
    code: String,
    messages: BTreeMap<String, String>,
    twice: Vec<String>,
}

fn languages() -> Vec<Language> {
    let entries = fs::read_dir(root().join(LANGUAGES)).expect("the languages");
    let folders = entries.map(|e| e.expect("an entry").path()).filter(|p| p.is_dir());
    let all: Vec<Language> = folders.map(|folder| language(&folder)).collect();
    assert!(all.iter().any(|l| l.code == "de"), "German is found");
    all
}

fn language(folder: &Path) -> Language {
    let (mut messages, mut twice) = (BTreeMap::new(), Vec::new());
    for file in fs::read_dir(folder).expect("a language") {
        let text = fs::read_to_string(file.expect("a file").path()).expect("UTF-8");
        for line in text.lines().filter(|l| l.starts_with('"')) {
            let (id, message) = line.split_once("\": \"").expect("`\"id\": \"message\"`");
            let message = message.strip_suffix('"').expect("`\"id\": \"message\"`");
            let id = unescaped(&id[1..]);
            if messages.insert(id.clone(), unescaped(message)).is_some() {
                twice.push(id);
            }
        }
    }
    let code = folder.file_name().expect("a name").to_string_lossy().into_owned();
    assert!(messages.len() > 600, "{} messages of {code} are found", messages.len());
    Language { code, messages, twice }
}

/// The numbers of the gaps of a message: `{}` counts on, `{2}` is a number.
fn gaps(message: &str) -> BTreeSet<usize> {
    let pieces = message.split('{').skip(1).filter_map(|p| p.split_once('}')).map(|p| p.0);
    pieces
        .enumerate()
        .filter_map(|(i, p)| if p.is_empty() { Some(i + 1) } else { p.parse().ok() })
        .collect()
}

#[test]
fn every_text_has_its_message_and_every_message_its_text() {
    // ids that need a message with their place, and all texts that may be one
    let mut needed: Vec<(String, String)> = Vec::new();
    let mut texts: BTreeSet<String> = BTreeSet::new();
    let files = rust_files(&["crates", "src"]);
    for (file, text) in files.iter().filter(|(file, _)| !file.contains("/tests/")) {
        texts.extend(literals(text).iter().map(|t| unescaped(t)));
        needed.extend(said(file, text).into_iter().map(|id| (file.clone(), id)));
    }
    for layout in LAYOUTS {
        let text = fs::read_to_string(root().join(layout)).expect("a layout");
        let marked = text.split('⟦').skip(1).filter_map(|t| t.split_once('⟧'));
        needed.extend(marked.map(|(id, _)| (layout.to_owned(), id.to_owned())));
    }
    let data = of_templates().into_iter().chain(of_tables());
    needed.extend(data.map(|id| ("templates and tables".to_owned(), id)));
    needed.retain(|(_, id)| has_words(id));
    texts.extend(needed.iter().map(|(_, id)| id.clone()));
    let mut faults = Vec::new();
    for Language { code, messages, twice } in languages() {
        faults.extend(twice.iter().map(|id| format!("{code}: twice `{id}`")));
        let missing = needed.iter().filter(|(_, id)| !messages.contains_key(id));
        faults.extend(missing.map(|(file, id)| format!("{code}: no message for `{id}` of {file}")));
        let unused = messages.keys().filter(|id| !texts.contains(*id));
        faults.extend(unused.map(|id| format!("{code}: nothing says `{id}`")));
    }
    assert_none(faults);
}

/// Words of the built-in templates, whose gaps are expressions there.
fn of_templates() -> Vec<String> {
    let files = fs::read_dir(root().join("templates")).expect("templates");
    let texts = files.map(|f| fs::read_to_string(f.expect("a file").path()).expect("UTF-8"));
    let words = |line: &str| -> Option<String> {
        let keys = ["label: ", "no_check: "];
        let words = keys.iter().find_map(|key| line.trim_start().strip_prefix(key))?;
        let mut pieces = words.trim_matches('"').split('{');
        let first = pieces.next()?.to_owned();
        Some(pieces.fold(first, |id, p| id + "{}" + p.split_once('}').map_or("", |p| p.1)))
    };
    texts.flat_map(|t| t.lines().filter_map(words).collect::<Vec<_>>()).collect()
}

/// Standards of the built-in tables, as `catalogs/README.md` names them.
fn of_tables() -> Vec<String> {
    let text = fs::read_to_string(root().join("catalogs/README.md")).expect("the tables");
    let rows = text.lines().map(|l| l.split('|').map(str::trim).collect::<Vec<_>>());
    rows.filter(|cells| cells.len() == 7).skip(1).map(|cells| cells[3].to_owned()).collect()
}

/// Layouts and scripts with messages between `⟦` and `⟧`.
const LAYOUTS: [&str; 8] = [
    "crates/report/src/page/viewer/view.html",
    "crates/report/src/page/viewer/page.js",
    "crates/report/src/page/viewer/scene.js",
    "crates/report/src/pdf/common.typ",
    "crates/report/src/pdf/report.typ",
    "crates/report/src/pdf/sweep.typ",
    "src/batch/summary/body.html",
    "src/batch/summary/summary.js",
];

/// A message has the gaps of its id, in an order of its own.
#[test]
fn gaps_agree() {
    let all = languages().into_iter().flat_map(|l| l.messages);
    let faults = all.filter(|(id, message)| gaps(id) != gaps(message));
    assert_none(faults.map(|(id, message)| format!("`{id}` and `{message}`")).collect());
    assert_eq!(gaps("{} of {}"), gaps("{2}: {1}"));
    assert_ne!(gaps("{} of {}"), gaps("{1}: {1}"));
}

#[test]
fn texts_without_a_message_are_found() {
    let source = "fn f() { say!(\"row {} of \\\n   the {}\", a, b); say!(\"{} = {}\", a, b) }";
    assert_eq!(said("crates/joint/src/a.rs", source), ["row {} of the {}", "{} = {}"]);
    let source = "fn f() { doc.heading(\"Answer\"); let a: Text = \"no bound\".into(); }";
    assert_eq!(said("crates/codes/src/a.rs", source), ["Answer", "no bound"]);
    assert!(has_words("row {} of the {}") && !has_words("{} = {} kN m, F_t,Rd"));
}
