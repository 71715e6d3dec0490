//! Tests of the checks themselves: each check reports what it forbids and accepts what it allows.

use super::HOUSES;
use super::circles::{circles, described, reached};
use super::modules::{Graph, Modules};
use super::text::{columns, machine_path};
use super::tokens::{names_crate, tokens, without_tests};

/// The modules of made-up files.
fn made_up(files: &[(&str, &str)]) -> Modules {
    let owned: Vec<_> = files.iter().map(|(f, t)| (f.to_string(), t.to_string())).collect();
    let library = ("src/lib.rs".to_owned(), String::new());
    Modules::read(&[vec![library], owned].concat())
}

/// The modules that a module uses, in order.
fn used(graph: &Graph, module: &str) -> Vec<String> {
    graph[module].keys().cloned().collect()
}

fn words(text: &str) -> String {
    tokens(text).join(" ")
}

fn untested(text: &str) -> String {
    without_tests(&tokens(text)).0.join(" ")
}

#[test]
fn comments_and_literals_are_no_code() {
    assert_eq!(words("a // b\n/* c /* d */ e */ f"), "a f");
    assert_eq!(words("a(\"b \\\" c\", r#\"d \" e\"#, b\"f\")"), "a ( \" , \" , \" )");
    assert_eq!(words("fn f<'a>(c: char) { c == '{' || c == '\\'' }"), {
        "fn f < > ( c : char ) { c = = \" | | c = = \" }"
    });
    assert_eq!(words("r + b::c"), "r + b :: c");
}

#[test]
fn tests_are_left_out_and_the_code_after_them_is_not() {
    assert_eq!(untested("a; #[cfg(test)] mod tests { use x; fn f() {} } b;"), "a ; b ;");
    assert_eq!(untested("#[cfg(test)]\n#[allow(x)]\nfn f(a: [u8; 4]) -> u8 { 1 } b"), "b");
    assert_eq!(untested("#[cfg(test)] pub use a::{b, c}; d"), "d");
    assert_eq!(untested("struct S { #[cfg(test)] a: u8, b: u8 }"), "struct S { b : u8 }");
    assert_eq!(untested("#[cfg(all(test, unix))] const A: [u8; 1] = [0]; b"), "b");
    assert_eq!(untested("#[cfg(unix)] fn f() {}"), "# [ cfg ( unix ) ] fn f ( ) { }");
    assert_eq!(untested("#![cfg(test)] fn f() {}"), "");
    let code = tokens("#[cfg(test)] pub(crate) mod fixtures; mod a;");
    assert_eq!(without_tests(&code).1, ["fixtures"]);
    // test modules, and modules below them, may use later rooms
    let modules = made_up(&[
        ("src/mesh/mod.rs", "#[cfg(test)] mod tests; pub struct Mesh;"),
        ("src/mesh/tests.rs", "use crate::cli::run; mod more; fn f() {}"),
        ("src/mesh/tests/more.rs", "use crate::cli::run; fn f() {}"),
        ("src/cli/mod.rs", "pub fn run() { crate::mesh::Mesh; }"),
    ]);
    assert_eq!(modules.graph().keys().collect::<Vec<_>>(), ["cli", "mesh"]);
    assert!(circles(&modules.graph()).is_empty());
}

/// Groups, `super`, `self`, bare paths of children, renames, globs and re-exports.
#[test]
fn paths_are_followed_to_the_file_that_has_the_item() {
    let items = "pub struct A; pub fn f() {}";
    let shared = [
        ("src/a/mod.rs", "pub mod b; pub mod c; pub use b::{A, f as g}; pub use c::*;"),
        ("src/a/b.rs", items),
        ("src/a/c.rs", "pub struct C; pub enum Kind { D }"),
    ];
    for (text, targets) in [
        ("use crate::a::{b::A, c::{self, C}};", vec!["a::b", "a::c"]),
        ("use crate::a::A;", vec!["a::b"]),
        ("use crate::a::g as h;", vec!["a::b"]),
        ("use crate::a::C;", vec!["a::c"]),
        ("use crate::a::Kind::*;", vec!["a::c"]),
        ("use crate::a::*; fn x(_: A) {}", vec!["a::b"]),
        ("use crate::a::*; fn x() { b::f(); c::C; }", vec!["a::b", "a::c"]),
        ("use crate::a; fn x() { a::b::f(); }", vec!["a::b"]),
        ("use crate::a::c as other; fn x() { other::C; }", vec!["a::c"]),
        ("use super::a::b;", vec!["a::b"]),
        ("fn x() { crate::a::c::C; self::y(); }", vec!["a::c"]),
        ("mod inner { use super::super::a::c::C; }", vec!["a::c"]),
        ("mod inner { use super::Own; }", vec![]),
        ("use std::fs; fn x() { fs::read(); a.b(); b::f(); }", vec![]),
        ("pub(in crate::a) fn x() {}", vec![]),
    ] {
        let text = format!("{text} pub struct Own;");
        let graph = made_up(&[&shared[..], &[("src/user.rs", text.as_str())]].concat()).graph();
        assert_eq!(used(&graph, "user"), targets, "{text}");
        assert!(!graph.contains_key("a"), "a file that only declares is no module");
    }
}

#[test]
fn parents_and_children_make_circles() {
    let child = ("src/a/b.rs", "use super::Shared; pub fn f(_: Shared) {}");
    let found = |parent: &str| {
        let graph = made_up(&[("src/a.rs", parent), child]).graph();
        circles(&graph).iter().map(|c| described(&graph, c)).collect::<Vec<_>>()
    };
    let text = found("mod b; pub struct Shared; fn g() { b::f(Shared) }");
    assert_eq!(text.len(), 1);
    assert!(text[0].contains("a -> a::b   by a::b::f"), "{text:?}");
    assert!(text[0].contains("a::b -> a   by a::Shared"), "{text:?}");
    assert_eq!(found("mod b; use b::f; pub struct Shared; fn g() { f(Shared) }").len(), 1);
    assert_eq!(found("mod b; pub use b::f; pub struct Shared; fn g() { f(Shared) }").len(), 1);
    // a re-exported name is not used
    assert!(found("mod b; pub use b::f; pub struct Shared;").is_empty());
    let glob = made_up(&[
        ("src/a/mod.rs", "mod b; mod c; use c::Shared; pub fn g() { b::f() }"),
        ("src/a/b.rs", "use super::*; pub fn f() -> Shared {}"),
        ("src/a/c.rs", "pub struct Shared;"),
    ]);
    assert!(circles(&glob.graph()).is_empty(), "`use super::*` leads to what it brings");
}

#[test]
fn circles_are_found_and_shown() {
    let graph = made_up(&[
        ("src/a.rs", "use crate::b::B; struct A;"),
        ("src/b.rs", "use crate::c::C; struct B;"),
        ("src/c.rs", "use crate::a::A; struct C;"),
        ("src/d.rs", "use crate::a::A; use crate::e::E; struct D;"),
        ("src/e.rs", "use super::d::D; struct E;"),
        ("src/f.rs", "use crate::d::D; struct F;"),
    ])
    .graph();
    let found = circles(&graph);
    assert_eq!(found, [vec!["a", "b", "c"], vec!["d", "e"]]);
    let text = described(&graph, &found[1]);
    assert!(text.contains("d -> e   by e::E") && text.contains("e -> d   by d::D"), "{text}");
    assert!(!text.contains("d -> a"), "{text}");
    assert!(reached(&graph, "f").contains("c") && !reached(&graph, "a").contains("f"));
}

#[test]
fn arrows_between_rooms_have_a_direction() {
    let engine = &HOUSES[1];
    let allowed = |from, to| engine.backward(from, to, to).is_none();
    for (from, to) in [
        ("mesh", "model"),
        ("certify", "programs"),
        ("certify", "solve"),
        ("helpers", "mesh"),
        ("mesh", "helpers"),
    ] {
        assert!(!allowed(from, to), "{from} {to}");
    }
    for (from, to) in [("model", "mesh"), ("mesh", "mesh"), ("recover", "certify")] {
        assert!(allowed(from, to), "{from} {to}");
    }
    // a name that one room re-exports from another counts as a use of both
    let rooms = made_up(&[
        ("src/mesh/mod.rs", "use crate::model::Later;"),
        ("src/model/mod.rs", "mod x; pub use x::Later;"),
        ("src/model/x.rs", "pub use crate::solve::Later;"),
        ("src/solve.rs", "pub struct Later;"),
    ])
    .rooms();
    let mesh: Vec<_> = rooms[0].1.iter().map(|(room, _)| room.as_str()).collect();
    assert_eq!((rooms[0].0.as_str(), mesh), ("mesh", vec!["model", "solve"]));
}

#[test]
fn crates_are_seen_in_paths_and_uses() {
    let names = |text: &str, name: &str| names_crate(&tokens(text), name);
    assert!(names("let v = serde_yaml::from_str(t);", "serde_yaml"));
    assert!(names("use clarabel;", "clarabel") && names("use clarabel::solver;", "clarabel"));
    assert!(names("use clap as c;", "clap") && names("extern crate clap;", "clap"));
    assert!(names("#[derive(Clone, clap::Args)] struct A;", "clap"));
    assert!(names("let m: ::faer::Mat<f64>;", "faer"));
    assert!(!names("pub mod clarabel;", "clarabel"));
    assert!(!names("super::clarabel::solve()", "clarabel"));
    assert!(!names("// clap::Args\nlet a = \"clap::Args\";", "clap"));
}

#[test]
fn machine_paths_and_wide_lines_are_seen() {
    for bad in ["/ho@me/me/x", "see /wo@rk/a", "\"/t@mp/a\"", "(/ro@ot/b)", "/Us@ers/x"] {
        assert!(machine_path(&bad.replace('@', "")).is_some(), "{bad}");
    }
    for good in ["target/tmp/a", "https://x.org/home/a", "../work/b", "$root/.venv", "a / root / b"]
    {
        assert!(machine_path(good).is_none(), "{good}");
    }
    assert_eq!(columns("σ ≤ f_y"), 7);
}
