//! `bracket mesh`: its files, its exit codes, and no incomplete files after an error.

use std::path::Path;
use std::process::{Command, Output};

const LAP: &str = include_str!("data/lap_joint.json");

fn bracket(dir: &Path, mesher: Option<&str>, args: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_bracket"));
    command.current_dir(dir).args(args);
    if let Some(m) = mesher {
        command.env("BRACKET_GMSH", m);
    }
    command.output().expect("the program starts")
}

fn names(dir: &Path) -> Vec<String> {
    let mut out: Vec<String> = std::fs::read_dir(dir)
        .expect("folder")
        .map(|e| e.expect("entry").file_name().to_string_lossy().into_owned())
        .collect();
    out.sort();
    out
}

fn folder(spec: &str) -> tempfile::TempDir {
    let dir = tempfile::tempdir().expect("temporary folder");
    std::fs::write(dir.path().join("lap.json"), spec).expect("written");
    dir
}

#[test]
fn writes_geometry_mesh_step_and_table_and_replaces_its_own_folder() {
    let dir = folder(LAP);
    for second in [false, true] {
        if second {
            std::fs::write(dir.path().join("lap/thesis.txt"), "years of work").expect("written");
        }
        let run = bracket(dir.path(), None, &["mesh", "lap.json", "--format", "json", "--quiet"]);
        assert_eq!(run.status.code(), Some(0), "{}", String::from_utf8_lossy(&run.stderr));
        let json: serde_json::Value = serde_json::from_slice(&run.stdout).expect("JSON");
        assert_eq!(json["symmetry"], 2);
        assert_eq!(names(dir.path()), ["lap", "lap.json"]);
        let files = names(&dir.path().join("lap"));
        for file in ["joint.geo", "joint.step", "mesh.msh", "quality.json", "quality.txt"] {
            assert!(files.iter().any(|f| f == file), "{file} in {files:?}");
        }
        assert_eq!(files.iter().any(|f| f == "thesis.txt"), second, "files of the user stay");
    }
}

/// With these sizes gmsh makes a sliver of 0.00° where the fillet of the column ends. Slightly
/// different sizes make none.
#[test]
fn a_mesh_with_a_flat_tet_is_made_again() {
    let joint = include_str!("../examples/one_sided_unstiffened/joint.yaml");
    let joint = joint.replace("kind: limit", "kind: elastic");
    let dir = tempfile::tempdir().expect("temporary folder");
    std::fs::write(dir.path().join("joint.yaml"), joint).expect("written");
    let run = bracket(dir.path(), None, &["mesh", "joint.yaml", "--size-factor", "1.3"]);
    let text = String::from_utf8_lossy(&run.stderr).into_owned();
    assert_eq!(run.status.code(), Some(0), "{text}");
    assert!(text.contains("meshing again"), "{text}");
    let table = std::fs::read_to_string(dir.path().join("joint/quality.json")).expect("table");
    let table: serde_json::Value = serde_json::from_str(&table).expect("JSON");
    let bodies = table["quality"].as_array().expect("one entry a body");
    let worst = bodies.iter().filter_map(|b| b["worst_dihedral"].as_f64()).fold(90.0, f64::min);
    assert!(
        bodies.len() == 5 && (0.5..70.6).contains(&worst),
        "{worst} degrees of {} bodies",
        bodies.len()
    );
}

/// Runs with an input or a mesher that must fail. Checks that no files are left and returns the
/// message.
fn refused(spec: &str, mesher: &str, code: i32) -> String {
    let dir = folder(spec);
    let run = bracket(dir.path(), Some(mesher), &["mesh", "lap.json"]);
    let text = String::from_utf8_lossy(&run.stderr).into_owned();
    assert_eq!(run.status.code(), Some(code), "{text}");
    assert_eq!(names(dir.path()), ["lap.json"]);
    text
}

#[test]
fn missing_mesher_is_exit_4() {
    assert!(refused(LAP, "/nonexistent/gmsh", 4).contains("mesher/start"));
    assert!(refused(LAP, "[1, 2]", 4).contains("mesher/variable"));
}

#[test]
#[cfg(unix)]
fn killed_mesher_is_exit_4_and_leaves_nothing() {
    let script = tempfile::NamedTempFile::new().expect("temporary file");
    std::fs::write(script.path(), "[ \"$1\" = --version ] && echo 4.15.2 && exit 0\nkill -9 $$\n")
        .expect("written");
    let mesher = serde_json::json!(["sh", script.path()]).to_string();
    assert!(refused(LAP, &mesher, 4).contains("mesher/killed"));
}

#[test]
fn broken_assembly_is_exit_2() {
    assert!(refused("{\"name\": 3}", "sh -c :", 2).contains("assembly/parse"));
}

#[test]
fn a_folder_of_someone_else_is_not_replaced() {
    let dir = folder(LAP);
    std::fs::create_dir(dir.path().join("lap")).expect("folder");
    std::fs::write(dir.path().join("lap/thesis.txt"), "years of work").expect("written");
    let run = bracket(dir.path(), None, &["mesh", "lap.json"]);
    assert_eq!(run.status.code(), Some(2));
    assert_eq!(names(&dir.path().join("lap")), ["thesis.txt"]);
}
