//! Finds the command of the mesher gmsh.

use super::mesher_error::{MesherError, VARIABLE};
use std::ffi::OsString;
use std::fs::File;
use std::io::Read;
use std::path::Path;

/// The command of gmsh: the environment variable, then a project-local venv, then PATH.
pub fn find_command() -> Result<Vec<OsString>, MesherError> {
    if let Some(value) = std::env::var_os(VARIABLE).filter(|v| !v.is_empty()) {
        return parse_command(&value.to_string_lossy());
    }
    let exe = std::env::current_exe().ok();
    let starts = [
        std::env::current_dir().ok(),
        exe.as_deref().and_then(Path::parent).map(Path::to_path_buf),
    ];
    for start in starts.into_iter().flatten() {
        for dir in start.ancestors() {
            let bin = dir.join(".venv").join("bin");
            let (python, gmsh) = (bin.join("python"), bin.join("gmsh"));
            if python.exists() && gmsh.exists() {
                return Ok(vec![python.into(), gmsh.into()]);
            }
        }
    }
    let path = std::env::var_os("PATH").unwrap_or_default();
    std::env::split_paths(&path)
        .map(|dir| dir.join("gmsh"))
        .find(|p| p.is_file())
        .map(|p| command_of_file(&p))
        .ok_or(MesherError::Missing)
}

/// The command in the environment variable.
fn parse_command(value: &str) -> Result<Vec<OsString>, MesherError> {
    let bad = || MesherError::BadVariable { value: value.to_string() };
    let words: Vec<String> = if value.trim_start().starts_with('[') {
        serde_json::from_str(value).map_err(|_| bad())?
    } else {
        value.split_whitespace().map(str::to_string).collect()
    };
    if words.first().is_none_or(|w| w.is_empty()) {
        return Err(bad());
    }
    Ok(words.into_iter().map(OsString::from).collect())
}

/// The command that runs a `gmsh` file. The `gmsh` of the Python wheel is a script that asks `env`
/// for Python, which finds the wrong one if no venv is activated. It is therefore run with the
/// Python in its own folder.
fn command_of_file(gmsh: &Path) -> Vec<OsString> {
    let mut head = [0u8; 64];
    let n = File::open(gmsh).and_then(|mut f| f.read(&mut head)).unwrap_or(0);
    let first = String::from_utf8_lossy(&head[..n]);
    let python = gmsh.with_file_name("python3");
    if first.starts_with("#!")
        && first.lines().next().is_some_and(|l| l.contains("python"))
        && python.exists()
    {
        vec![python.into(), gmsh.into()]
    } else {
        vec![gmsh.into()]
    }
}
