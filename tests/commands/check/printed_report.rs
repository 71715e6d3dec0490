//! `report.pdf`: what a reader finds in it, equal bytes, hostile texts, and refused folders.

use crate::bench::expect;
use crate::bench::{Bench, Want, none_wrong, refusal};
use serde_json::Value;
use std::process::Command;

/// HEB140 and IPE270 with M16 under 20 kN m.
const JOINT: &str = "template: beam_to_column_end_plate\nmembers: {column: {profile: HEB140, \
                     steel: S235}, beam: {profile: IPE270, steel: S235}}\nplate: {thickness: \
                     15}\nbolts: {size: M16, grade: \"8.8\", rows: [-85, 85, 170]}\nloads: \
                     [{name: ULS1, end: beam_right, at: column_face, My: 20 kN m, Vz: 10 kN}]\n";

const PROJECT: &str = "project: {title: Joint 7, number: P-12, author: A. Ray, checker: B. Lee, \
                       date: 2026-11-23, revision: C}\n";

fn bench(project: &str) -> Bench {
    Bench::new().file("joint.yaml", format!("{project}{JOINT}"))
}

/// Standard output of a program that reads PDF files; `scripts/setup.sh --test` installs it.
fn read(program: &str, bench: &Bench, args: &[&str]) -> String {
    let run = Command::new(program).current_dir(bench.path()).args(args).output();
    let run = run.unwrap_or_else(|e| panic!("{program} (package poppler-utils): {e}"));
    String::from_utf8_lossy(&run.stdout).into_owned()
}

/// Letters and digits of a text: what is left of it when subscripts and line breaks are set.
fn bare(text: &str) -> String {
    text.chars().filter(|c| c.is_alphanumeric()).collect()
}

fn text(bench: &Bench, file: &str) -> String {
    bare(&read("pdftotext", bench, &[file, "-"]))
}

/// `u` with as many digits as the summary prints.
fn number(u: f64) -> String {
    bracket::report::figures::utilisation(u, bracket::report::figures::Rounding::Nearest)
}

#[test]
fn a_reader_finds_verdict_and_every_check() {
    let bench = bench(PROJECT);
    expect(&bench, &["check", "joint.yaml", "--out", "r"], 0);
    let info = read("pdfinfo", &bench, &["r/report.pdf"]);
    for line in ["Joint 7", "A. Ray", "A4"] {
        assert!(info.contains(line), "{line}: {info}");
    }
    let result: Value = serde_json::from_str(&bench.read("r/result.json")).expect("JSON");
    let short = text(&bench, "r/report.pdf");
    let reason = result["judgement"]["reason"].as_str().expect("reason");
    for words in ["Joint 7", "P-12", "A. Ray", "B. Lee", "revision C", "page 1 of", "OK", reason] {
        assert!(short.contains(&bare(words)), "{words}");
    }
    assert!(short.contains(&bare(&result["input_hash"].as_str().expect("hash")[..16])));
    expect(&bench, &["report", "r", "--full", "--paper", "letter", "--out", "full.pdf"], 0);
    assert!(read("pdfinfo", &bench, &["full.pdf"]).contains("letter"));
    let full = text(&bench, "full.pdf");
    let numbers = read("pdftotext", &bench, &["full.pdf", "-"]);
    let checks = result["checks"].as_array().expect("checks");
    assert!(checks.len() > 30);
    for check in checks {
        let get = |key: &str| check[key].as_str().unwrap_or_default();
        assert!(full.contains(&bare(get("title"))), "{check}");
        // subscripts may stand on lines of their own in the text, numbers do not
        let digit = |c: char| c.is_ascii_digit() || c == '.';
        for number in get("formula").split(|c| !digit(c)).filter(|n| n.len() > 1) {
            assert!(numbers.contains(number), "{number} of {}", get("formula"));
        }
        let summed = check["case"].is_string() && check["demand"].is_number();
        if let (true, Some(u)) = (summed, check["utilisation"].as_f64()) {
            assert!(short.contains(&bare(&number(u))), "{check}");
        }
    }
    assert!(full.contains(&bare("beam_to_column_end_plate")), "the input is echoed");
}

/// No text of these reports stays English, and names of the user stay as they are.
#[test]
fn reports_in_german_are_complete() {
    let german = PROJECT.replace("{title", "{language: de, title");
    let bench = bench(&german);
    expect(&bench, &["check", "joint.yaml", "--out", "r"], 0);
    let short = text(&bench, "r/report.pdf");
    for words in ["Nachweise", "Einwirkungen", "Seite 1 von", "Revision C", "beam_right"] {
        assert!(short.contains(&bare(words)), "{words}");
    }
    let report = bench.read("r/report.md");
    assert!(report.contains("## Ergebnis") && report.contains("| Projektnummer | P-12 |"));
    let page = bench.read("r/report.html");
    assert!(page.contains("<html lang=\"de\">") && page.contains("<h2>Nachweise</h2>"), "{page}");
    // the data for programs keep their words
    assert!(bench.read("r/result.json").contains("moment and axial force of the joint"));
    let joint = |name: &str| format!("{}/examples/{name}/joint.yaml", env!("CARGO_MANIFEST_DIR"));
    for name in ["double_sided", "one_sided_stiffened", "paper_joint", "splice_flush"] {
        expect(&bench, &["check", &joint(name), "--out", name], 0);
        let args = ["report", name, "--full", "--language", "de", "--format", "json"];
        let out = bench.run(&args);
        let told: Value = serde_json::from_slice(&out.stdout).expect("JSON");
        assert_eq!(told["untranslated"], serde_json::json!([]), "{name}");
    }
}

#[test]
fn equal_input_gives_equal_bytes_and_an_archival_file() {
    let bench = bench(PROJECT);
    for folder in ["a", "b"] {
        expect(&bench, &["check", "joint.yaml", "--out", folder], 0);
    }
    let bytes = |file: &str| std::fs::read(bench.path().join(file)).expect("written");
    let [a, b] = ["a/report.pdf", "b/report.pdf"].map(bytes);
    assert!(a == b && a.len() < 300_000, "{}", a.len());
    expect(&bench, &["report", "a", "--out", "again.pdf"], 0);
    assert!(bytes("again.pdf") == a);
    let holds =
        |bytes: &[u8], words: &str| bytes.windows(words.len()).any(|w| w == words.as_bytes());
    assert!(holds(&a, "pdfaid:part>2") || holds(&a, "pdfaid:part=\"2\""), "PDF/A-2b");
    // without a date there is none to state
    let undated = self::bench("project: {title: Joint 7}\n");
    expect(&undated, &["check", "joint.yaml", "--out", "a"], 0);
    let plain = std::fs::read(undated.path().join("a/report.pdf")).expect("written");
    assert!(!holds(&plain, "pdfaid"));
}

/// Names of the user give no link, picture or element in any of the faces of a report, and command
/// no terminal.
#[test]
fn names_of_the_user_are_text_in_every_face() {
    let evil = "[c](javascript:x) ![i](http://e/x.png) <b>x</b> \\u001b[31mred \\u202Eabc";
    let spec = format!("project: {{title: \"{evil}\", author: \"{evil}\"}}\n{JOINT}")
        .replace("name: ULS1", &format!("name: \"U{evil}\""));
    let bench = Bench::new().file("joint.yaml", &spec);
    let (out, err) = expect(&bench, &["check", "joint.yaml", "--out", "r"], 0);
    let faces = [("terminal", out + &err), ("log", bench.read("r/log.txt"))];
    let files = ["report.md", "report.html", "drawing.svg", "actions.svg"];
    let files = files.map(|f| (f, bench.read(&format!("r/{f}"))));
    for (face, text) in faces.iter().chain(&files) {
        assert!(!text.contains(['\u{1b}', '\u{202e}']), "{face}: {text}");
    }
    for (face, text) in &files {
        // the input is echoed in a block of code, where nothing is read as a link
        let text = text.split("```").step_by(2).collect::<String>();
        assert!(!text.contains("<b>x"), "{face}: {text}");
        assert!(!text.contains("](javascript") || !face.ends_with("md"), "{face}: {text}");
        assert!(!text.contains("href=\"javascript") && !text.contains("src=\"http"), "{face}");
    }
    assert!(files[0].1.contains("]\\(javascript"), "the name is there: {}", files[0].1);
    // a message of refusal shows it too
    let wrong = spec.replace("thickness: 15", "thickness: 0");
    let bench = bench.file("wrong.yaml", wrong);
    let (_, err) = expect(&bench, &["check", "wrong.yaml"], 2);
    assert!(!err.contains(['\u{1b}', '\u{202e}']), "{err}");
}

/// Texts of the user that look like code, or that the fonts do not have, are set as text.
#[test]
fn hostile_texts_are_text() {
    let long = "W".repeat(600);
    for (title, shown) in [
        ("#set page(width: 1mm) #panic() $x$ *b* _i_", "set page width 1mm panic x b i"),
        ("<script>alert(1)</script> </title>", "script alert 1 script title"),
        ("] #eval(\\\"1+1\\\") [ @ref <label> \\\\", "eval 1 1 ref label"),
        ("![p](drawing.svg) | a | b |", "p drawing svg a b"),
        ("עברית العربية 漢字 😀", ""),
        ("tab\\there \\u0007 bell", "tab here"),
        (&long, "WWWWWWWWWWWWWWWWWWWW"),
    ] {
        for date in ["", ", date: 2026-11-23"] {
            let bench = bench(&format!("project: {{title: \"{title}\"{date}}}\n"));
            expect(&bench, &["check", "joint.yaml", "--out", "r"], 0);
            expect(&bench, &["report", "r", "--full"], 0);
            let page = text(&bench, "r/report.pdf");
            assert!(page.contains(&bare(shown)), "{title}: {}", &page[..300]);
            let pages = read("pdfinfo", &bench, &["r/report.pdf"]);
            let pages: u32 = pages
                .lines()
                .find_map(|l| l.strip_prefix("Pages:"))
                .and_then(|n| n.trim().parse().ok())
                .expect("pages");
            assert!((4..=12).contains(&pages), "{title}: {pages}");
        }
    }
}

#[test]
fn refused_folders_and_files() {
    let done = || {
        let bench = bench("");
        expect(&bench, &["check", "joint.yaml", "--out", "r"], 0);
        bench
    };
    let replaced = |file: &str, from: &str, to: &str| {
        let bench = done();
        let text = bench.read(file).replacen(from, to, 1);
        bench.file(file, text)
    };
    let want = |exit, code, place, message, cure| Want { exit, code, place, message, cure };
    let data = "report/data";
    let run = "bracket run";
    let cases = [
        ("no folder", done(), vec!["x"], want(2, data, "result.json", "cannot be read", run)),
        ("a file", done(), vec!["joint.yaml"], want(2, data, "result.json", "cannot be read", run)),
        (
            "no data",
            {
                let bench = done();
                std::fs::remove_file(bench.path().join("r/report.json")).expect("removed");
                bench
            },
            vec!["r"],
            want(2, data, "report.json", "cannot be read", run),
        ),
        (
            "broken data",
            replaced("r/report.json", "\"project\"", "\"projekt"),
            vec!["r"],
            want(2, data, "report.json", "control character", run),
        ),
        (
            "other data",
            replaced("r/report.json", "\"schedule\"", "\"plan\""),
            vec!["r"],
            want(2, data, "report.json", "schedule", run),
        ),
        (
            "another program",
            replaced("r/result.json", "\"bracket\"", "\"other\""),
            vec!["r"],
            want(2, "report/not-a-result", "result.json", "other", "finished"),
        ),
        (
            "another schema",
            replaced("r/result.json", "\"schema\": 1", "\"schema\": 99"),
            vec!["r"],
            want(2, "report/not-a-result", "result.json", "99", "finished"),
        ),
        (
            "a forged verdict",
            replaced("r/result.json", "\"verdict\": \"ok\"", "\"verdict\": \"none\""),
            vec!["r"],
            want(2, "report/changed", "digests.b3", "result.json is not the file", "verify"),
        ),
        (
            "a changed title",
            replaced("r/report.json", "\"title\"", "\"topic\""),
            vec!["r"],
            want(2, "report/changed", "digests.b3", "report.json is not the file", "verify"),
        ),
        (
            "no list of digests",
            {
                let bench = done();
                std::fs::remove_file(bench.path().join("r/digests.b3")).expect("removed");
                bench
            },
            vec!["r"],
            want(2, "report/changed", "digests.b3", "no list of digests", "verify"),
        ),
        (
            "no folder for the file",
            done(),
            vec!["r", "--out", "x/y.pdf"],
            want(4, "report/write", "x/y.pdf", "cannot be written", "--out"),
        ),
        (
            "a folder as file",
            done(),
            vec!["r", "--out", "r"],
            want(4, "report/write", "r", "cannot be written", "--out"),
        ),
        (
            "a file of the user",
            done(),
            vec!["r", "--out", "joint.yaml"],
            want(2, "cli/report-out", "joint.yaml", "is not a PDF", "an earlier report"),
        ),
        (
            "a file of the result",
            done(),
            vec!["r", "--out", "r/result.json"],
            want(2, "cli/report-out", "r/result.json", "is not a PDF", "an earlier report"),
        ),
        (
            "a device",
            done(),
            vec!["r", "--out", "/dev/full"],
            want(2, "cli/report-out", "/dev/full", "is not a regular file", "an earlier report"),
        ),
        (
            "a broken picture",
            done().file("r/drawing.svg", "<svg"),
            vec!["r", "--out", "x.pdf"],
            want(4, "report/pdf", "", "SVG", "other reports"),
        ),
    ];
    let results = cases.map(|(name, bench, args, want)| {
        let mut command = bench.command(&["report"]);
        command.args(args);
        (name.to_string(), refusal(&bench, &mut command, &want))
    });
    none_wrong(results.into());
    // a picture that is gone leaves its place empty
    let bench = done();
    std::fs::remove_file(bench.path().join("r/drawing.svg")).expect("removed");
    expect(&bench, &["report", "r"], 0);
}

/// Beside a wide table of supports there is no room: the partial factors stand below it, on lines
/// that the page holds.
#[test]
fn partial_factors_stand_below_wide_supports() {
    let base = "template: column_base\nmembers: {column: {profile: HEB200, steel: S235}}\nplate: \
                {thickness: 30}\nbolts: {size: M20, grade: \"8.8\", rows: [-140, 140]}\nloads: \
                [{name: ULS1, end: column, at: bolt_plane, N: -400 kN, My: 30 kN m}]\n";
    let bench = Bench::new().file("base.yaml", base);
    expect(&bench, &["check", "base.yaml", "--out", "r"], 0);
    let lines = read("pdftotext", &bench, &["-layout", "r/report.pdf", "-"]);
    let together = |words: &[&str]| lines.lines().any(|l| words.iter().all(|w| l.contains(w)));
    assert!(together(&["Partial factors and strengths"]), "{lines}");
    assert!(together(&["pressure up to", "MPa; elastic"]), "{lines}");
    assert!(together(&["The strength of a bolt is its tension resistance"]), "{lines}");
}
