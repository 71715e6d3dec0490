//! A folder to run the program in, and the checks that every refused input must pass.
#![allow(dead_code, missing_docs)]

use bracket::result::digests::{DIGESTS_FILE, Digests};
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

/// The paper's joint: a valid spec that the tests make wrong.
pub const JOINT: &str = include_str!("../../examples/paper_joint/joint.yaml");

/// A change of a result, with the words by which `verify` refutes it.
pub type Edit<'a> = (&'a str, &'a dyn Fn(&mut serde_json::Value));

/// A temporary folder with input files.
pub struct Bench {
    dir: tempfile::TempDir,
}

/// Runs with an expected exit code; returns standard output and standard error.
pub fn expect(bench: &Bench, args: &[&str], code: i32) -> (String, String) {
    let run = bench.run(args);
    let [out, err] = [run.stdout, run.stderr].map(|b| String::from_utf8(b).expect("UTF-8"));
    assert_eq!(run.status.code(), Some(code), "{args:?}\n{out}\n{err}");
    (out, err)
}

impl Bench {
    pub fn new() -> Self {
        Self { dir: tempfile::tempdir().expect("temporary folder") }
    }

    pub fn path(&self) -> &Path {
        self.dir.path()
    }

    pub fn file(self, name: &str, content: impl AsRef<[u8]>) -> Self {
        std::fs::write(self.path().join(name), content).expect("written");
        self
    }

    pub fn read(&self, name: &str) -> String {
        std::fs::read_to_string(self.path().join(name)).unwrap_or_else(|e| panic!("{name}: {e}"))
    }

    pub fn command(&self, args: &[&str]) -> Command {
        let mut command = Command::new(env!("CARGO_BIN_EXE_bracket"));
        command.current_dir(self.path()).env_remove("BRACKET_GMSH").args(args);
        command
    }

    pub fn run(&self, args: &[&str]) -> Output {
        self.command(args).output().expect("the program starts")
    }

    /// Writes the digests of a result folder again, as one who forges a file would. What `verify`
    /// then refutes, it has recomputed.
    pub fn sealed(&self, folder: &str) -> &Self {
        let folder = self.path().join(folder);
        // a folder that does not exist stays so
        if let Ok(digests) = Digests::of(&folder) {
            std::fs::write(folder.join(DIGESTS_FILE), digests.text()).expect("written");
        }
        self
    }

    /// All files below the folder with their bytes, and all empty folders with none.
    pub fn everything(&self) -> BTreeMap<PathBuf, Vec<u8>> {
        let mut found = BTreeMap::new();
        collect(self.path(), self.path(), &mut found);
        found
    }

    /// Another folder with the same files.
    pub fn copy(&self) -> Self {
        let other = Self::new();
        for (name, bytes) in self.everything() {
            let (from, to) = (self.path().join(&name), other.path().join(&name));
            match from.is_dir() {
                true => std::fs::create_dir_all(to).expect("folder"),
                false => std::fs::write(to, bytes).expect("written"),
            }
        }
        other
    }

    /// Changes a copy as one who forges the result in `folder` would and runs `verify`. Returns the
    /// exit code and all that it prints.
    pub fn verify_after(&self, folder: &str, tamper: &dyn Fn(&Bench)) -> (Option<i32>, String) {
        let bench = self.copy();
        tamper(&bench);
        let run = bench.sealed(folder).run(&["verify", folder]);
        let text = [run.stdout, run.stderr].map(|t| String::from_utf8_lossy(&t).into_owned());
        let text = text.concat();
        assert!(!text.contains("panicked"), "{text}");
        (run.status.code(), text)
    }

    /// Creates a mesher that prints a version and then runs `script` (`sh`; the arguments are those
    /// of gmsh). Returns its path.
    pub fn mesher(&self, script: &str) -> String {
        let path = self.path().join("mesher.sh");
        let text = format!("[ \"$1\" = --version ] && {{ echo 4.15.2; exit 0; }}\n{script}\n");
        std::fs::write(&path, text).expect("written");
        serde_json::json!(["sh", path]).to_string()
    }
}

fn collect(root: &Path, dir: &Path, found: &mut BTreeMap<PathBuf, Vec<u8>>) {
    for entry in std::fs::read_dir(dir).expect("folder") {
        let path = entry.expect("entry").path();
        let name = path.strip_prefix(root).expect("below the root").to_path_buf();
        if path.is_dir() {
            found.insert(name, Vec::new());
            collect(root, &path, found);
        } else {
            found.insert(name, std::fs::read(&path).expect("readable"));
        }
    }
}

/// What the error for a refused input must contain: the exit code, the error code, the place as it
/// is printed (empty if the message holds it), words of the message and words of the help.
pub struct Want<'a> {
    pub exit: i32,
    pub code: &'a str,
    pub place: &'a str,
    pub message: &'a str,
    pub cure: &'a str,
}

/// Runs the command. It must end with the exit code and one message that names place and cure. It
/// must print nothing on standard output and change no byte in the folder. The error lists every
/// violation.
pub fn refusal(bench: &Bench, command: &mut Command, want: &Want<'_>) -> Result<String, String> {
    let before = bench.everything();
    let run = command.output().expect("the program starts");
    let text = String::from_utf8_lossy(&run.stderr).into_owned();
    let mut faults = Vec::new();
    if run.status.code() != Some(want.exit) {
        faults.push(format!("exit {:?}, expected {}", run.status.code(), want.exit));
    }
    let titles: Vec<&str> = text.lines().filter(|l| l.starts_with("error")).collect();
    match titles[..] {
        [title] => {
            if !title.starts_with(&format!("error[{}]: ", want.code)) {
                faults.push(format!("code is not {}", want.code));
            }
        }
        _ => faults.push(format!("{} messages", titles.len())),
    }
    let flat = text.split_whitespace().collect::<Vec<_>>().join(" ");
    for (what, words) in [("place", want.place), ("message", want.message), ("cure", want.cure)] {
        if !flat.contains(words) {
            faults.push(format!("lacks the {what} {words:?}"));
        }
    }
    if !text.contains("help: ") {
        faults.push("no cure".into());
    }
    for odd in ["panicked", "unwrap", ".part", "Os {"] {
        if text.contains(odd) {
            faults.push(format!("talks of {odd:?}"));
        }
    }
    if !run.stdout.is_empty() {
        faults.push(format!("says on standard output {:?}", String::from_utf8_lossy(&run.stdout)));
    }
    let after = bench.everything();
    if after != before {
        let names: Vec<_> = after.keys().filter(|k| before.get(*k) != after.get(*k)).collect();
        faults.push(format!(
            "left {names:?}, {} entries before, {} after",
            before.len(),
            after.len()
        ));
    }
    if faults.is_empty() { Ok(text) } else { Err(format!("{}:\n{text}", faults.join("; "))) }
}

/// Fails with a list of all violations in a table of cases.
pub fn none_wrong(results: Vec<(String, Result<String, String>)>) {
    assert!(results.len() > 1, "an empty table proves nothing");
    let wrong: Vec<String> = results
        .into_iter()
        .filter_map(|(name, r)| Some(format!("== {name}: {}", r.err()?)))
        .collect();
    assert!(wrong.is_empty(), "{} wrong\n{}", wrong.len(), wrong.join("\n"));
}
