//! Every text of the user goes through every face of the program and stays text: no element, link,
//! formula or command to a terminal comes of it.

use crate::bench::Bench;
use serde_json::Value;
use std::process::Command;

/// Texts that one of the faces would read as something else.
fn hostile() -> Vec<String> {
    let mut out: Vec<String> = [
        "<script>alert(1)</script><img src=x onerror=alert(1)></title><b>bold</b>",
        "t [c](javascript:alert) ![i](http://evil.example/x.png) [a][b] [d]: http://evil.example",
        "http://evil.example https://evil.example www.evil.example",
        "**b** *i* _i_ ~~s~~ `c | a\\| b | c",
        "# head &#42; &lt;b&gt; &amp;",
        "#panic(1) $x$ *b* @ref <label> #eval(\"1\") \\ ] [",
        "=cmd|' /C calc'!A0",
        "+1+cmd|x",
        "@SUM(1)",
        "-2+cmd|x",
        "a\u{1b}[31mred\u{1b}]0;title\u{7} \u{9b}31m \u{9d}0;x\u{9c} \u{8}",
        "b\u{202e}abc\u{202c} \u{2066}x\u{2069} \u{200e}\u{200f}\u{61c} \u{2028}x\u{2029}",
        "one\nverdict: FORGED\r\n| a | b |\n# head",
        "emoji 😀 漢字",
    ]
    .map(String::from)
    .into();
    out.push("long ".repeat(100));
    out
}

/// YAML, and JSON too, of a text. Emoji are written as pairs, as many programs do.
fn quoted(text: &str) -> String {
    let units = text.encode_utf16().map(|u| format!("\\u{u:04x}"));
    format!("\"{}\"", units.collect::<String>())
}

/// A cell of CSV.
fn cell(text: &str) -> String {
    format!("\"{}\"", text.replace('"', "\"\""))
}

/// A joint with the text in all places that take one: title block, load case, template, catalogue.
fn bench(text: &str) -> Bench {
    let t = quoted(text);
    let template = format!(
        "extends: beam_to_column_end_plate\nname: own\ntitle: {t}\nabout: {t}\nmembers: [base, \
         {{role: column, about: {t}}}]\nparameters: [base, {{name: rib, about: {t}}}]\nparts: \
         [base, {{name: COLUMN, label: {t}}}]\nchecks: [base, {{name: plate_covers_beam, say: \
         {t}, help: {t}}}]\n"
    );
    let line = text.replace(['\n', '\r'], " ");
    let steels = format!(
        "# source: {line}\nstandard,grade,fy_t_le_40_MPa,fu_t_le_40_MPa,fy_t_40_to_80_MPa,\
         fu_t_40_to_80_MPa,E_MPa,nu,density_kg_per_m3,beta_w\n{0},S999,235,360,215,360,210000,\
         0.3,7850,0.8\nown,{0},235,360,215,360,210000,0.3,7850,0.8\n",
        cell(text)
    );
    let bench = Bench::new().file("own.yaml", template).file("joint.yaml", spec(&t, "15"));
    std::fs::create_dir(bench.path().join("own")).expect("made");
    bench.file("own/steel_grades.csv", steels)
}

fn spec(t: &str, thickness: &str) -> String {
    format!(
        "project: {{title: {t}, number: {t}, author: {t}, checker: {t}, revision: {t}}}\n\
         template: ./own.yaml\ncatalog: own\nmembers: {{column: {{profile: HEB140, steel: S999}}, \
         beam: {{profile: IPE270, steel: S235}}}}\nplate: {{thickness: {thickness}}}\nbolts: \
         {{size: M16, grade: \"8.8\", rows: [-85, 85, 170]}}\nloads: [{{name: {t}, end: \
         beam_right, at: column_face, My: 20 kN m, Vz: 10 kN}}]\n"
    )
}

/// Nothing commands a terminal or turns the direction of writing.
fn plain(face: &str, text: &str) {
    let turns = |c: char| {
        "\u{61c}\u{200e}\u{200f}\u{2028}\u{2029}".contains(c)
            || ('\u{202a}'..='\u{202e}').contains(&c)
            || ('\u{2066}'..='\u{2069}').contains(&c)
    };
    let bad = text.chars().find(|c| (c.is_control() && !"\n\t\u{c}".contains(*c)) || turns(*c));
    assert_eq!(bad, None, "{face}: {text}");
}

/// What a terminal shows: no line of the user's looks like one of the program's.
fn terminal(face: &str, text: &str) {
    plain(face, text);
    assert!(!text.lines().any(|l| l.starts_with("verdict: FORGED")), "{face}: {text}");
}

fn markdown(face: &str, text: &str) {
    plain(face, text);
    // the input is echoed in a block of code
    let text = text.split("```").step_by(2).collect::<String>();
    for mark in [
        "<script",
        "<img",
        "<b>",
        "](javascript",
        "](http",
        "http://evil",
        "https://evil",
        "www.evil",
        "**b**",
        " *i*",
        " _i_",
        "~~s~~",
        "&#42;",
        "[a][b]",
        "\n# head",
        "\n| a | b |",
        "]: http",
    ] {
        assert!(!text.contains(mark), "{face} has {mark}: {text}");
    }
}

fn html(face: &str, text: &str) {
    plain(face, text);
    for mark in ["<script>alert", "<img src=x", "<b>bold", "href=\"javascript", "src=\"http"] {
        assert!(!text.contains(mark), "{face} has {mark}");
    }
}

fn csv(face: &str, text: &str) {
    let mut reader = csv::ReaderBuilder::new().has_headers(false).from_reader(text.as_bytes());
    for record in reader.records() {
        for cell in record.expect("CSV").iter() {
            let number = |c: &str| c[1..].starts_with(|c: char| c.is_ascii_digit());
            let negative = cell.starts_with('-') && (!number(cell) || cell.contains('|'));
            assert!(!cell.starts_with(['=', '+', '@', '\t', '\r']) && !negative, "{face}: {cell}");
            plain(face, cell);
        }
    }
}

/// Standard output and standard error of a command, which must not end by a panic or by bad input.
fn said(bench: &Bench, args: &[&str], codes: &[i32]) -> String {
    let run = bench.run(args);
    let [out, err] = [run.stdout, run.stderr].map(|b| String::from_utf8(b).expect("UTF-8"));
    let code = run.status.code();
    assert!(code.is_some_and(|c| codes.contains(&c)), "{args:?} {code:?}\n{out}\n{err}");
    out + &err
}

/// Letters and digits: what is left of a text in a PDF.
fn bare(text: &str) -> String {
    text.chars().filter(|c| c.is_ascii_alphanumeric()).collect()
}

fn pdf(bench: &Bench, file: &str, holds: &str) {
    let run = Command::new("pdftotext").current_dir(bench.path()).args([file, "-"]).output();
    let run = run.unwrap_or_else(|e| panic!("pdftotext (package poppler-utils): {e}"));
    let text = String::from_utf8_lossy(&run.stdout).into_owned();
    plain(file, &text);
    // narrow columns set a long text in pieces
    let begin: String = bare(holds).chars().take(9).collect();
    assert!(bare(&text).contains(&begin), "{holds}: {text}");
}

#[test]
fn every_text_of_a_joint_stays_text_in_every_face() {
    for text in hostile() {
        let bench = bench(&text);
        terminal("check", &said(&bench, &["check", "joint.yaml", "--out", "r"], &[1, 3]));
        let files = std::fs::read_dir(bench.path().join("r")).expect("the folder");
        let mut seen = 0;
        for file in files.map(|f| f.expect("a file").file_name().to_string_lossy().into_owned()) {
            let read = || bench.read(&format!("r/{file}"));
            match file.rsplit('.').next().unwrap_or_default() {
                "md" => markdown(&file, &read()),
                "html" | "svg" => html(&file, &read()),
                "txt" => terminal(&file, &read()),
                // data for programs
                "json" => drop(serde_json::from_str::<Value>(&read()).expect("JSON")),
                _ => continue,
            }
            seen += 1;
        }
        assert!(seen >= 7, "{seen} files of text");
        let echoed = if text.starts_with("long") { "long long" } else { text.as_str() };
        let echoed = echoed.split(['\u{1b}', '\u{9b}']).next().unwrap_or_default();
        pdf(&bench, "r/report.pdf", echoed);
        said(&bench, &["report", "r", "--full", "--out", "full.pdf"], &[0]);
        pdf(&bench, "full.pdf", echoed);
        terminal("verify", &said(&bench, &["verify", "r"], &[0, 1]));
        // a forger may write anything into the result
        let forged = bench
            .read("r/result.json")
            .replace("\"by_code\"", &format!("{}:1,\"by_code\"", quoted(&text)));
        let bench = bench.file("r/result.json", forged);
        terminal("verify", &said(&bench, &["verify", "r"], &[0, 1, 2]));
        terminal("templates", &said(&bench, &["templates", "./own.yaml"], &[0]));
        for args in [
            &["catalog", "--dir", "own", "list", "steels"][..],
            &["catalog", "--dir", "own", "show", "S999"],
        ] {
            terminal("catalog", &said(&bench, args, &[0, 2]));
        }
        // messages of refusal show the texts of spec and template
        let t = quoted(&text);
        let bench = bench.file("wrong.yaml", spec(&t, "15, z: [0, 10]"));
        terminal("refusal", &said(&bench, &["check", "wrong.yaml"], &[2]));
        let bench = bench.file("wrong.yaml", spec(&t, &t));
        terminal("refusal", &said(&bench, &["check", "wrong.yaml"], &[2]));
    }
}

/// The names of a sweep: its rows, axes, tables and the title of its base.
#[test]
fn every_text_of_a_sweep_stays_text_in_every_face() {
    for text in hostile() {
        let t = quoted(&text);
        let base = spec(&t, "15")
            .replace(
                "template: ./own.yaml\ncatalog: own\n",
                "template: \
            beam_to_column_end_plate\n",
            )
            .replace("S999", "S235");
        let table =
            format!("name,project.number,plate.thickness\n{0},{0},15\nB2,{0},18\n", cell(&text));
        let sweep = format!(
            "base: joint.yaml\ntable: rows.csv\naxes: {{project.revision: [{t}, B]}}\nfirst: \
             checks\ntables:\n  - {{title: {t}, rows: project.revision, columns: \
             plate.thickness, action: My}}\n"
        );
        let bench = Bench::new().file("joint.yaml", base).file("rows.csv", table);
        let bench = bench.file("sweep.yaml", sweep);
        terminal("batch", &said(&bench, &["batch", "sweep.yaml"], &[0, 1]));
        markdown("tables.md", &bench.read("sweep/tables.md"));
        html("summary.html", &bench.read("sweep/summary.html"));
        csv("results.csv", &bench.read("sweep/results.csv"));
        let shown = text.split(['\u{1b}', '\u{9b}', 'l']).next().unwrap_or_default();
        pdf(&bench, "sweep/summary.pdf", shown);
        terminal("status", &said(&bench, &["batch", "status", "sweep"], &[0]));
    }
}
