//! What `bracket check` answers.
#![allow(dead_code)]

use crate::bench::Bench;
use serde_json::Value;
use std::path::Path;

/// The folder of the inputs.
const CASES: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/cases");

/// The answer of the program to a spec.
pub struct Answer {
    /// Exit code.
    pub code: i32,
    /// Standard output and standard error.
    pub said: String,
    /// `result.json`; null where the program wrote none.
    pub result: Value,
    /// `report.md`; empty where the program wrote none.
    pub report: String,
    /// The folder with the input and the result in `out`.
    pub bench: Bench,
}

impl Answer {
    /// The answer of `bracket check` to an input of `tests/cases`. The program finds everything
    /// else in that folder beside it.
    pub fn of(name: &str) -> Self {
        let text = std::fs::read(Path::new(CASES).join(name)).expect("a file of tests/cases");
        Self::among_the_cases(name, text)
    }

    /// The answer of `bracket check` to a spec.
    pub fn to(text: &str) -> Self {
        Self::among_the_cases("joint.yaml", text.into())
    }

    /// An input of `tests/cases` as text, for changes.
    pub fn input(name: &str) -> String {
        std::fs::read_to_string(Path::new(CASES).join(name)).expect("a file of tests/cases")
    }

    fn among_the_cases(name: &str, text: Vec<u8>) -> Self {
        let bench = Bench::new();
        copy(Path::new(CASES), bench.path());
        Self::from(bench.file(name, text), &["check", name, "--out", "out"])
    }

    /// The answer to a command that writes into the folder `out`.
    pub fn from(bench: Bench, command: &[&str]) -> Self {
        let run = bench.run(command);
        let [out, err] = [run.stdout, run.stderr].map(|b| String::from_utf8_lossy(&b).into_owned());
        let file = |name: &str| std::fs::read_to_string(bench.path().join("out").join(name)).ok();
        Self {
            code: run.status.code().expect("no signal"),
            said: out + &err,
            result: file("result.json")
                .map_or(Value::Null, |t| serde_json::from_str(&t).expect("JSON")),
            report: file("report.md").unwrap_or_default(),
            bench,
        }
    }

    /// The verdict of all cases: `ok`, `not_ok`, `undecided`, `none`.
    pub fn verdict(&self) -> &str {
        self.result["verdict"].as_str().unwrap_or("no result")
    }

    /// The checks.
    pub fn checks(&self) -> &[Value] {
        self.result["checks"].as_array().map_or(&[], Vec::as_slice)
    }

    /// The checks with a title.
    pub fn titled(&self, title: &str) -> Vec<&Value> {
        self.checks().iter().filter(|c| c["title"] == title).collect()
    }
}

fn copy(from: &Path, to: &Path) {
    for entry in std::fs::read_dir(from).expect("a folder") {
        let entry = entry.expect("an entry");
        let target = to.join(entry.file_name());
        if entry.path().is_dir() {
            std::fs::create_dir(&target).expect("a new folder");
            copy(&entry.path(), &target);
        } else {
            std::fs::copy(entry.path(), target).expect("copied");
        }
    }
}
