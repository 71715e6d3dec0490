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

/// The command of a variable's value: a file, whose path may contain blanks, or a list of words.
fn parse_command(variable: &'static str, value: &str) -> Result<Vec<OsString>, MesherError> {
    let bad = || MesherError::BadVariable { variable, value: value.to_string() };
    if Path::new(value).is_file() {
        return Ok(command_of_file(Path::new(value)));
    }
    let words: Vec<String> = if value.trim_start().starts_with('[') {
        serde_json::from_str(value).map_err(|_| bad())?
    } else {
        value.split_whitespace().map(str::to_string).collect()
    };
    if words.first().is_none_or(|w| w.is_empty()) {
        return Err(bad());
    }
    if let [file] = words.as_slice() {
        let file = Path::new(file);
        if file.is_file() {
            return Ok(command_of_file(file));
        }
    }
    Ok(words.into_iter().map(OsString::from).collect())
}

/// The command that runs a file. Commands of Python wheels are scripts that ask `env` for Python,
/// which finds the wrong one if no venv is activated, or name an interpreter that is elsewhere.
/// They are therefore run with the Python in their own folder, or in that of the file that a link
/// leads to.
fn command_of_file(file: &Path) -> Vec<OsString> {
    let mut head = [0u8; 512];
    let n = File::open(file).and_then(|mut f| f.read(&mut head)).unwrap_or(0);
    let first = String::from_utf8_lossy(&head[..n]);
    let script =
        first.starts_with("#!") && first.lines().next().is_some_and(|l| l.contains("python"));
    let folders = [Some(file.to_owned()), file.canonicalize().ok()];
    let pythons = folders
        .into_iter()
        .flatten()
        .flat_map(|f| ["python3", "python"].map(|name| f.with_file_name(name)));
    match pythons.into_iter().find(|p| script && p.exists()) {
        Some(python) => vec![python.into(), file.into()],
        None => vec![file.into()],
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Four files: a script of a wheel beside its Python, a link to it from elsewhere, a script
    /// without Python beside it, a program.
    #[test]
    #[cfg(unix)]
    fn a_script_of_a_wheel_runs_with_the_python_beside_it() {
        let dir = tempfile::tempdir().expect("a folder");
        let at = |name: &str| dir.path().join(name);
        for folder in ["my venv", "elsewhere"] {
            std::fs::create_dir(at(folder)).expect("made");
        }
        let script = "#!/usr/bin/env python\nimport gmsh\n";
        for (name, text) in [
            ("my venv/gmsh", script),
            ("my venv/python3", ""),
            ("elsewhere/gmsh", script),
            ("program", "\x7fELF"),
        ] {
            std::fs::write(at(name), text).expect("written");
        }
        std::os::unix::fs::symlink(at("my venv/gmsh"), at("link")).expect("linked");
        let command = |value: &str| parse_command(VARIABLE, value).expect("a command");
        let of = |name: &str| command(at(name).to_str().expect("a path"));
        let python = at("my venv/python3").canonicalize().expect("there");
        assert_eq!(of("my venv/gmsh"), [at("my venv/python3"), at("my venv/gmsh")]);
        assert_eq!(of("link"), [python, at("link")]);
        assert_eq!(of("elsewhere/gmsh"), [at("elsewhere/gmsh")]);
        assert_eq!(of("program"), [at("program")]);
        let listed = serde_json::to_string(&[at("my venv/gmsh")]).expect("JSON");
        assert_eq!(command(&listed).len(), 2);
        assert_eq!(command("nice -n 5 gmsh"), ["nice", "-n", "5", "gmsh"]);
    }
}
