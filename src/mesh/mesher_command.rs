//! Finds the commands of the mesher gmsh and the remesher Mmg.

use super::mesher_error::{MesherError, REMESHER_VARIABLE, VARIABLE};
use std::ffi::OsString;
use std::fs::File;
use std::io::Read;
use std::path::{Path, PathBuf};

/// The command of gmsh: the environment variable, then a project-local venv, then PATH.
pub fn find_gmsh() -> Result<Vec<OsString>, MesherError> {
    if let Some(command) = from_variable(VARIABLE)? {
        return Ok(command);
    }
    let in_venv = venvs().find_map(|venv| {
        let (python, gmsh) = (venv.join("bin/python"), venv.join("bin/gmsh"));
        (python.exists() && gmsh.exists()).then(|| vec![python.into(), gmsh.into()])
    });
    in_venv.or_else(|| on_path(&["gmsh"])).ok_or(MesherError::Missing)
}

/// The command of Mmg's `mmg3d`: the environment variable, then the executable that the Python
/// wheel mmgpy carries in a project-local venv, then PATH.
pub fn find_mmg() -> Result<Vec<OsString>, MesherError> {
    if let Some(command) = from_variable(REMESHER_VARIABLE)? {
        return Ok(command);
    }
    // the scripts in `bin` need further Python packages, the executable itself needs none
    let in_venv = venvs().find_map(|venv| {
        let versions = std::fs::read_dir(venv.join("lib")).ok()?;
        let mut found: Vec<PathBuf> = versions
            .filter_map(|v| Some(v.ok()?.path().join("site-packages/mmgpy/bin/mmg3d_O3")))
            .filter(|p| p.is_file())
            .collect();
        found.sort();
        found.pop().map(|p| vec![p.into()])
    });
    in_venv.or_else(|| on_path(&["mmg3d_O3", "mmg3d"])).ok_or(MesherError::NoRemesher)
}

/// The folders `.venv` above the current folder and above the program.
fn venvs() -> impl Iterator<Item = PathBuf> {
    let exe = std::env::current_exe().ok();
    let starts = [std::env::current_dir().ok(), exe.and_then(|e| Some(e.parent()?.to_path_buf()))];
    starts
        .into_iter()
        .flatten()
        .flat_map(|start| start.ancestors().map(|dir| dir.join(".venv")).collect::<Vec<_>>())
}

/// The first of the files on PATH.
fn on_path(names: &[&str]) -> Option<Vec<OsString>> {
    let path = std::env::var_os("PATH").unwrap_or_default();
    let file =
        |name: &&str| std::env::split_paths(&path).map(|dir| dir.join(name)).find(|p| p.is_file());
    names.iter().find_map(file).map(|p| command_of_file(&p))
}

/// The command in an environment variable, if it is set.
fn from_variable(variable: &'static str) -> Result<Option<Vec<OsString>>, MesherError> {
    let value = std::env::var_os(variable).filter(|v| !v.is_empty());
    value.map(|v| parse_command(variable, &v.to_string_lossy())).transpose()
}

fn parse_command(variable: &'static str, value: &str) -> Result<Vec<OsString>, MesherError> {
    let bad = || MesherError::BadVariable { variable, value: value.to_string() };
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

/// The command that runs a file. Commands of Python wheels are scripts that ask `env` for Python,
/// which finds the wrong one if no venv is activated. They are therefore run with the Python in
/// their own folder.
fn command_of_file(file: &Path) -> Vec<OsString> {
    let mut head = [0u8; 64];
    let n = File::open(file).and_then(|mut f| f.read(&mut head)).unwrap_or(0);
    let first = String::from_utf8_lossy(&head[..n]);
    let python = file.with_file_name("python3");
    if first.starts_with("#!")
        && first.lines().next().is_some_and(|l| l.contains("python"))
        && python.exists()
    {
        vec![python.into(), file.into()]
    } else {
        vec![file.into()]
    }
}
