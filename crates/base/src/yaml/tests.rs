use super::*;
use serde::Deserialize;
use std::collections::BTreeMap;

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct Bolt {
    size: String,
    rows: Vec<f64>,
}

#[derive(Debug, Deserialize)]
#[serde(rename_all = "snake_case")]
enum Kind {
    Elastic,
    Limit,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct Doc {
    title: String,
    #[serde(default)]
    bolts: Vec<Bolt>,
    #[serde(default)]
    sizes: BTreeMap<String, f64>,
    #[serde(default)]
    kind: Option<Kind>,
}

fn read(text: &str) -> Result<Parsed<Doc>, Diagnostics> {
    parse(text, Path::new("joint.yaml"))
}

const GOOD: &str = "title: a\nbolts:\n  - size: M16\n    rows: [1, 2.5]\n  - {size: M18, rows: \
                    [3, -4]}\nsizes: {b: 1}\n";

#[test]
fn values_and_places() {
    let p = read(GOOD).expect("good");
    assert_eq!(p.value.title, "a");
    assert_eq!(p.value.bolts[1].rows, [3.0, -4.0]);
    assert_eq!(p.value.sizes["b"], 1.0);
    assert_eq!(p.value.bolts[0].size, "M16");
    let at = |path: &str| {
        let p = p.index.place(path);
        (p.line.expect("line"), p.column.expect("column"))
    };
    assert_eq!(at("title"), (1, 8));
    assert_eq!(at("bolts"), (2, 1));
    assert_eq!(at("bolts[0].rows[1]"), (4, 15));
    assert_eq!(at("bolts[1]"), (5, 5));
    assert_eq!(at("bolts[1].rows[1]"), (5, 27));
    // a path that does not exist has the place of its nearest parent
    assert_eq!(at("bolts[1].grade.name"), (5, 5));
    assert_eq!(at("nothing"), (1, 1));
    assert_eq!(p.index.place("bolts[1].grade").path.as_deref(), Some("bolts[1].grade"));
}

#[test]
fn kinds_are_read() {
    let kind = |word: &str| read(&format!("title: a\nkind: {word}\n")).expect("good").value.kind;
    assert!(matches!(kind("elastic"), Some(Kind::Elastic)));
    assert!(matches!(kind("limit"), Some(Kind::Limit)));
}

/// Text, code, line, column, part of the message, part of the help.
const WRONG: &[(&str, &str, usize, usize, &str, &str)] = &[
    (
        "title: a\nbolt: []\n",
        "yaml/unknown-key",
        2,
        7,
        "did you mean `bolts`?",
        "title, bolts, sizes, kind",
    ),
    (
        "title: a\nbolts:\n  - size: M16\n    row: [1]\n",
        "yaml/unknown-key",
        4,
        10,
        "unknown key `row` in `bolts[0]`",
        "size, rows",
    ),
    (
        "title: a\nbolts:\n  - {size: M16}\n",
        "yaml/missing-key",
        3,
        5,
        "`bolts[0]` lacks the key `rows`",
        "add `rows",
    ),
    ("bolts: []\n", "yaml/missing-key", 1, 1, "lacks the key `title`", "add `title"),
    ("title: a\ntitle: b\n", "yaml/duplicate-key", 2, 1, "`title` stands twice", "keep one"),
    (
        "title: a\nsizes:\n  x: 1\n  y: 2\n  x: 3\n",
        "yaml/duplicate-key",
        5,
        3,
        "`x` in `sizes` stands twice",
        "keep one",
    ),
    (
        "title: a\nsizes: {x: 1, y: .nan}\n",
        "yaml/not-finite",
        2,
        18,
        "`sizes.y` is not a finite number",
        "finite",
    ),
    ("title: a\nsizes: {x: -.inf}\n", "yaml/not-finite", 2, 12, "`sizes.x`", "finite"),
    (
        "title: a\nsizes: {x: NaN}\n",
        "yaml/type",
        2,
        12,
        "expected a number without a unit",
        "kind of value",
    ),
    (
        "title: a\nkind: elastik\n",
        "yaml/unknown-value",
        2,
        7,
        "did you mean `elastic`?",
        "elastic, limit",
    ),
    ("title: a\nsizes: {x: }\n", "yaml/type", 2, 10, "nothing, expected a number", "kind of value"),
    ("- a\n", "yaml/type", 1, 1, "a list, expected keys with values", "kind of value"),
    ("title: a\nbolts: 3\n", "yaml/type", 2, 8, "expected a list", "kind of value"),
    ("title: [a\nbolts: 3\n", "yaml/syntax", 2, 0, "not valid YAML", "brackets"),
    ("title: a\n\tbolts: 3\n", "yaml/tab", 2, 1, "line 2 is indented with a tab", "blanks"),
    (
        "title: a\nsizes:\n  x: 1\n  \ty: 2\n",
        "yaml/tab",
        4,
        3,
        "line 4 is indented with a tab",
        "blanks",
    ),
    ("# a\n\t# b\ntitle: [a\nbolts: 3\n", "yaml/syntax", 0, 0, "not valid YAML", "brackets"),
    (
        "title: a\nsizes: {x: 20,5 mm, y: 1}\n",
        "yaml/comma",
        2,
        0,
        "`5 mm` becomes a key of its own",
        "`20.5 mm`, not `20,5 mm`",
    ),
    (
        "title: a\nsizes: {x: 20,5, y: 1,5}\n",
        "yaml/comma",
        2,
        0,
        "the comma before `5`",
        "a point before its decimals",
    ),
    (
        "title: a\nsizes: {x: 0,3 }\n",
        "yaml/comma",
        2,
        0,
        "the comma before `3`",
        "a point before its decimals",
    ),
    ("title: a\nsizes:\n  x: 0,3\n", "yaml/type", 3, 6, "expected a number", "its decimals: `0.3`"),
    ("title: a\nsizes:\n  x: 1,200\n", "yaml/type", 3, 6, "expected a number", "kind of value"),
    ("title: !x a\n", "yaml/tag", 1, 0, "tags", "remove the tag"),
    ("title: a\n---\ntitle: b\n", "yaml/documents", 0, 0, "more than one", "one document"),
    ("# nothing\n\n", "yaml/empty", 0, 0, "empty", "starter"),
];

#[test]
fn wrong_files_name_place_and_cure() {
    for (text, code, line, column, message, help) in WRONG {
        let faults = read(text).expect_err(text);
        let d = &faults.first();
        assert_eq!(d.code, *code, "{text}: {d:?}");
        assert_eq!(d.place.file.as_deref(), Some(Path::new("joint.yaml")), "{text}");
        if *line > 0 {
            assert_eq!(d.place.line, Some(*line), "{text}: {d:?}");
        }
        if *column > 0 {
            assert_eq!(d.place.column, Some(*column), "{text}: {d:?}");
        }
        assert!(d.message.contains(message), "{text}: {d:?}");
        assert!(d.help.as_deref().unwrap_or("").contains(help), "{text}: {d:?}");
        assert_eq!(faults.exit_code(), 2);
    }
}

#[test]
fn alias_bombs_are_refused() {
    // nine levels of ten: a thousand million strings
    let mut bomb = "title: a\na0: &a0 [x,x,x,x,x,x,x,x,x,x]\n".to_string();
    for i in 1..10 {
        let items = vec![format!("*a{}", i - 1); 10].join(",");
        bomb += &format!("a{i}: &a{i} [{items}]\n");
    }
    assert_eq!(read(&bomb).expect_err("bomb").first().code, "yaml/too-large");
    // one long list used many times: few aliases, many values
    let long =
        format!("l: &l [{}]\nm: [{}]\n", vec!["1"; 3000].join(","), vec!["*l"; 3000].join(","));
    assert_eq!(read(&long).expect_err("long").first().code, "yaml/too-large");
    // harmless aliases are accepted
    assert!(read("title: &t a\nbolts: [{size: *t, rows: []}]\n").is_ok());
}

#[test]
fn deep_nesting_is_refused() {
    for n in [200, 100_000] {
        let text = format!("title: {}1{}", "[".repeat(n), "]".repeat(n));
        assert_eq!(read(&text).expect_err("deep").first().code, "yaml/too-deep");
    }
}

/// The reader of the crate takes minutes for brackets nested this deep, and does so within keys
/// and lists too.
#[test]
fn deep_nesting_is_refused_before_it_is_read() {
    for text in [
        format!("title: {}", "[".repeat(100_000)),
        format!("a: 1\nsizes: {}", "{x: ".repeat(100_000)),
        format!("sizes: {}", "[a, ".repeat(100_000)),
    ] {
        let fault = read(&text).expect_err("deep").into_first();
        assert_eq!(fault.code, "yaml/too-deep");
        let line = 1 + usize::from(text.starts_with("a:"));
        assert_eq!(fault.place.line, Some(line), "found by the first look at the characters");
    }
}

/// A report sets a name of 200 000 characters in 18 s.
#[test]
fn a_long_text_is_refused() {
    let text = |n: usize| format!("title: a\nbolts: [{{size: {}, rows: []}}]\n", "x".repeat(n));
    assert!(read(&text(10_000)).is_ok());
    let fault = read(&text(10_001)).expect_err("too long").into_first();
    assert_eq!((fault.code, fault.place.line), ("yaml/long-text", Some(2)));
    let message = "`bolts[0].size` is a text of 10001 bytes, at most 10000 are read";
    assert_eq!(fault.message, message);
}

#[test]
fn a_long_list_is_not_blamed_on_aliases() {
    let list = |entry: &str, n: usize| format!("title: a\nsizes: [{}]\n", entry.repeat(n));
    let fault = read(&list("1,", 1_100_000)).expect_err("too many").into_first();
    assert_eq!(fault.code, "yaml/too-large");
    assert_eq!(fault.message, "the file has more than a million values");
    let anchor = format!("x: &a [{}]\n", "1,".repeat(1000));
    let fault = read(&(anchor + &list("*a,", 1100))).expect_err("too many").into_first();
    assert!(fault.message.contains("aliases"), "{fault}");
}

/// JSON writes an emoji as two escapes.
#[test]
fn surrogate_pairs_are_one_character() {
    let parsed = read(r#"title: "a \ud83d\ude00 b""#).expect("read");
    assert_eq!(parsed.value.title, "a \u{1f600} b");
    assert_eq!(read(r#"title: "\ud83d""#).expect_err("half a pair").first().code, "yaml/syntax");
}

#[test]
fn several_faults_are_told_at_once() {
    let faults = read("title: a\nsizes: {x: .nan, x: 1, y: .inf}\n").expect_err("three faults");
    assert_eq!(faults.iter().len(), 3);
}

#[test]
fn written_values_read_back() {
    let text = to_string(&BTreeMap::from([("title", "x: y")])).expect("write");
    assert_eq!(read(&text).expect("read").value.title, "x: y");
}

proptest::proptest! {
    #![proptest_config(proptest::prelude::ProptestConfig::with_cases(400))]
    #[test]
    fn mutated_files_never_panic(
        cut in 0usize..90,
        put in "[\\PC\\n\\t:&*!\\[\\]{}\"'#|>-]{0,6}",
        len in 0usize..8,
    ) {
        let cut = cut.min(GOOD.len());
        let end = (cut + len).min(GOOD.len());
        let _ = read(&format!("{}{put}{}", &GOOD[..cut], &GOOD[end..]));
    }
}

#[test]
fn keys_of_the_top_level_are_found_in_every_form() {
    for text in ["template: t\na: 1", "{\"template\": \"t\"}", "{a: 1, template: t}"] {
        assert!(top_level(text, &["template"]), "{text}");
        assert!(!top_level(text, &["mesh"]), "{text}");
        assert!(!top_level(text, &["template", "mesh"]), "{text}");
    }
    assert!(!top_level("a: {template: t}", &["template"]));
    // not a document: the error that follows says what kind of file it looks like
    assert!(top_level("mesh: [\nbodies: x", &["mesh", "bodies"]));
    // too large to be read as a document: only words at the begin of a line are keys
    let large = format!("{{template: t}} #{}", " ".repeat(LARGEST));
    assert!(!top_level(&large, &["template"]));
    assert!(top_level(&format!("{large}\ntemplate: t"), &["template"]));
}

#[test]
fn very_many_entries_between_braces_are_refused_at_once() {
    let entries = |n: usize| format!("a: {{b: 0{}}}", ", c: 0".repeat(n));
    let scan = |text: &str| Scan::of(text).exceeded.map(|e| e.0);
    assert_eq!(scan(&entries(10_000)), None);
    assert_eq!(scan(&entries(10_001)), Some(Limit::Entries));
    // lists are read in time, and braces in texts are no braces
    assert_eq!(scan(&format!("a: [0{}]", ", 0".repeat(20_000))), None);
    assert_eq!(scan(&format!("a: \"{{{}\"", ", ".repeat(20_000))), None);
    let refused = parse::<BTreeMap<String, f64>>(&entries(200_000), Path::new("f.yaml"));
    let code = refused.map(|_| ()).expect_err("too many").into_first().code;
    assert_eq!(code, "yaml/too-large");
}

#[test]
fn more_than_a_million_values_are_refused_before_they_are_read() {
    let scan = |text: &str| Scan::of(text).exceeded.map(|e| e.0);
    let forms: [fn(usize) -> String; 3] = [
        |n| format!("a: [0{}]", ", 0".repeat(n - 2)),
        |n| format!("a:\n{}", "- 0\n".repeat(n - 1)),
        |n| "a: 0\n".repeat(n),
    ];
    for form in forms {
        assert_eq!(scan(&form(1_000_000)), None);
        assert_eq!(scan(&form(1_000_002)), Some(Limit::Values));
        let refused = parse::<BTreeMap<String, f64>>(&form(1_000_002), Path::new("f.yaml"));
        let fault = refused.map(|_| ()).expect_err("too many").into_first();
        assert_eq!(fault.message, "the file has more than a million values");
    }
    // neither texts nor comments are values
    for text in ["a: \"", "# ", "a: |\n  "] {
        assert_eq!(scan(&format!("{text}{}\"", "[0, 0] ".repeat(400_000))), None, "{text}");
    }
}
