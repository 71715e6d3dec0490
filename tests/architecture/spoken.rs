//! Rooms above the engine decide by data, never by words that they made for people.

use super::assert_none;
use super::read_back::{constants, literals, read_back};
use super::text::{root, rust_files};
use super::tokens::{tokens_with_literals, without_tests};
use std::fs;

/// Files whose words are the titles, subjects and components that reports print.
const TABLES: [&str; 5] = [
    "crates/codes/src/check/check_id.rs",
    "crates/codes/src/subject/part.rs",
    "crates/codes/src/subject/place.rs",
    "crates/codes/src/subject/sense.rs",
    "crates/codes/src/subject/frame.rs",
];

/// Comparisons that are allowed, with the file, the text and the reason.
const ARGUED: [(&str, &str, &str); 8] = [
    ("crates/codes/src/end_plate/slip_checks.rs", "ISO 4014", "a system of the bolt table"),
    ("crates/report/src/words/picture.rs", "<text ", "the SVG format"),
    ("crates/report/src/words/picture.rs", "viewBox=\\\"0 0 ", "the SVG format"),
    ("src/batch/choice.rs", "bolts", "a name in an expression of the user"),
    ("src/batch/choice.rs", "rib", "a key of a spec"),
    ("src/batch/import/joints_table.rs", "joint", "a header of the user's table"),
    ("src/batch/import/template_ends.rs", "column", "a role of a template"),
    ("src/driver/verify_cases.rs", "command line", "the origin of a value in result.json"),
];

fn words() -> Vec<String> {
    let of = |file: &&str| literals(&fs::read_to_string(root().join(file)).expect("a table"));
    let all: Vec<String> = TABLES.iter().flat_map(of).filter(|w| !w.contains('{')).collect();
    assert!(all.len() > 130, "the words of the tables are found");
    all
}

#[test]
fn nothing_reads_back_what_people_read() {
    let words = words();
    let files = rust_files(&["crates/codes/src", "crates/report/src", "src"]);
    let tested = |file: &str| file.contains("/tests/") || file.ends_with("tests.rs");
    let files: Vec<_> = files.into_iter().filter(|(file, _)| !tested(file)).collect();
    let names = files
        .iter()
        .flat_map(|(_, text)| constants(&without_tests(&tokens_with_literals(text)).0, &words))
        .collect();
    let mut found: Vec<(&str, String)> = Vec::new();
    for (file, text) in &files {
        found.extend(read_back(text, &words, &names).into_iter().map(|t| (file.as_str(), t)));
    }
    let argued =
        |(file, text): &&(&str, String)| ARGUED.iter().any(|(f, t, _)| f == file && t == text);
    let mut faults: Vec<String> = found
        .iter()
        .filter(|f| !argued(f))
        .map(|(file, text)| format!("{file} compares with `{text}`, which people read"))
        .collect();
    for (file, text, _) in &ARGUED {
        if !found.iter().any(|(f, t)| f == file && t == text) {
            faults.push(format!("{file} needs no entry for `{text}` in ARGUED"));
        }
    }
    assert_none(faults);
}

#[test]
fn comparisons_with_words_are_found() {
    let words = ["rib".to_owned()];
    let names = [("ALL".to_owned(), "all cases".to_owned())].into();
    let found = |text: &str| read_back(text, &words, &names);
    for text in [
        "fn f() { if a == \"end plate\" {} }",
        "fn f() { if \"end plate\" != *a {} }",
        "fn f() { a.contains(\"end plate\") }",
        "fn f() { a.strip_prefix(\"mode \") }",
        "fn f() { [\"x\", \"end plate\"].contains(&a) }",
        "fn f() { a.starts_with([\"end plate\"]) }",
        "fn f() { match a { \"x\" => 1, \"y\" | \"end plate\" => 2, _ => 3 } }",
        "fn f() { match a { (\"end plate\", _) if b => 1, _ => 3 } }",
        "fn f() { matches!(a, \"x\" | \"end plate\") }",
        "fn f() { a == \"rib\" }",
        "fn f() { a.clause == ALL }",
    ] {
        assert_eq!(found(text).len(), 1, "{text}: {:?}", found(text));
    }
    for text in [
        "fn f() { a == \"end_plate\" || a.contains(\"ribs\") || a.starts_with(\"# \") }",
        "fn f() { let a = \"end plate\"; g(\"end plate\") }",
        "fn f() { match a { A => \"end plate\", B => g(\"end plate\") } }",
        "fn f() { matches!(a, \"x\" | \"y\") && b.contains(&format!(\"{a} of\")) }",
        "#[cfg(test)] mod tests { fn f() { a == \"end plate\" } }",
        "fn f() -> &str { ALL } fn g() { if a.kind == ALL_KINDS {} }",
    ] {
        assert!(found(text).is_empty(), "{text}: {:?}", found(text));
    }
}
