//! The files of the project as text.

use std::fs;
use std::path::{Path, PathBuf};

/// Folders that do not belong to the text of the project.
const SKIPPED: [&str; 5] = ["target", ".git", ".venv", "results", "__pycache__"];

pub fn root() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR"))
}

/// All files below `dir` in order, as paths relative to the root with `/`.
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
            let parts = relative.components().map(|c| c.as_os_str().to_string_lossy());
            found.push(parts.collect::<Vec<_>>().join("/"));
        }
    }
}

/// All Rust files below the folders, with their text.
pub fn rust_files(folders: &[&str]) -> Vec<(String, String)> {
    let mut found = Vec::new();
    for folder in folders {
        let before = found.len();
        files(&root().join(folder), &mut found);
        assert!(found.len() > before, "the sources of {folder} are found");
    }
    found.retain(|f| f.ends_with(".rs"));
    let read = |f: String| (f.clone(), fs::read_to_string(root().join(&f)).expect("UTF-8 source"));
    found.into_iter().map(read).collect()
}

/// The files under version control; without git, all files of the folder.
pub fn tracked() -> Vec<String> {
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

/// Width of a line in characters.
pub fn columns(line: &str) -> usize {
    line.chars().count()
}

/// A path on a particular machine: a home, root or scratch folder at the start of a path.
pub fn machine_path(line: &str) -> Option<String> {
    ["home", "root", "tmp", "work", "Users"].iter().map(|d| format!("/{d}/")).find(|p| {
        line.match_indices(p.as_str()).any(|(at, _)| {
            !line[..at].ends_with(|c: char| {
                c.is_alphanumeric() || matches!(c, '_' | '-' | '.' | '/' | '}' | '*')
            })
        })
    })
}
