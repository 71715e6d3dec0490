//! `bracket mesh`: its files, its exit codes, and no incomplete files after an error.

use bracket::mesh::topology::FaceTable;
use bracket::mesh::{TetMesh, msh, msh_write};
use std::path::Path;
use std::process::{Command, Output};

const LAP: &str = include_str!("../data/lap_joint.json");

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

/// With these sizes gmsh makes a sliver of 0.00° where the fillet of the column ends. It is mended,
/// and the mesh is not made again.
#[test]
fn a_mesh_with_a_flat_tet_is_mended() {
    let joint = include_str!("../../examples/one_sided_unstiffened/joint.yaml");
    let joint = joint.replace("kind: limit", "kind: elastic");
    let dir = tempfile::tempdir().expect("temporary folder");
    std::fs::write(dir.path().join("joint.yaml"), joint).expect("written");
    let run = bracket(dir.path(), None, &["mesh", "joint.yaml", "--size-factor", "1.3"]);
    let text = String::from_utf8_lossy(&run.stderr).into_owned();
    assert_eq!(run.status.code(), Some(0), "{text}");
    assert!(text.contains("mended ") && !text.contains("meshing again"), "{text}");
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

/// Two outer triangles of one body that share an edge, lie in a plane and make a convex square: a
/// tet of their four nodes has no volume.
fn lid(mesh: &TetMesh) -> ([u32; 4], usize) {
    let table = FaceTable::new(&mesh.tets);
    let outer: Vec<_> = table.faces().filter(|r| r.len() == 1).map(|r| r[0]).collect();
    let at = |n: u32| mesh.nodes[n as usize];
    let doubled = |t: [u32; 3]| {
        let [a, b, c] = t.map(at);
        let (u, v): ([f64; 3], [f64; 3]) =
            (std::array::from_fn(|k| b[k] - a[k]), std::array::from_fn(|k| c[k] - a[k]));
        let n = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
        n.iter().map(|c| c * c).sum::<f64>().sqrt()
    };
    let level = |t: &[u32; 3]| {
        // the plates lie in planes of z; the load's and the support's faces do not
        let z = t.map(|n| at(n)[2]);
        z[0] == z[1] && z[1] == z[2]
    };
    for p in outer.iter().filter(|p| level(&p.key)) {
        for q in outer.iter().filter(|q| level(&q.key) && q.key != p.key) {
            let common: Vec<u32> = p.key.into_iter().filter(|n| q.key.contains(n)).collect();
            let rest = |key: [u32; 3]| key.into_iter().find(|n| !common.contains(n));
            let ([a, c], Some(b), Some(d)) = (&common[..], rest(p.key), rest(q.key)) else {
                continue;
            };
            let halves = [doubled([*a, b, d]), doubled([*c, b, d])];
            let whole = doubled(p.key) + doubled(q.key);
            if halves.iter().all(|h| *h > 1.0) && (halves[0] + halves[1] - whole).abs() < 1e-9 {
                return ([*a, b, *c, d], p.tet as usize);
            }
        }
    }
    panic!("no two such triangles");
}

/// A mesher that leaves a tet without volume on a flat facet: the tet is removed, the mesh agrees
/// with the joint, and progress, table and JSON give the number of mended tets.
#[test]
#[cfg(unix)]
fn the_flat_tet_of_a_false_mesher_is_mended_and_reported() {
    let dir = folder(LAP);
    let run = bracket(dir.path(), None, &["mesh", "lap.json", "--no-step", "--out", "good"]);
    assert_eq!(run.status.code(), Some(0), "{}", String::from_utf8_lossy(&run.stderr));
    let good = msh::read(&dir.path().join("good/mesh.msh")).expect("mesh");
    let mut bad = TetMesh { faces: Vec::new(), ..good.clone() };
    let (tet, owner) = lid(&good);
    bad.tets.push(tet);
    bad.tet_body.push(good.tet_body[owner]);
    if !bad.tet_region.is_empty() {
        bad.tet_region.push(good.tet_region[owner]);
    }
    std::fs::write(dir.path().join("bad.msh"), msh_write::text(&bad)).expect("written");
    let script = dir.path().join("false_gmsh.sh");
    let body = "[ \"$1\" = --version ] && echo 4.15.2 && exit 0\ncp \"$0.msh\" joint_raw.msh\n";
    std::fs::write(&script, body).expect("written");
    std::fs::rename(dir.path().join("bad.msh"), dir.path().join("false_gmsh.sh.msh"))
        .expect("moved");
    let mesher = serde_json::json!(["sh", script]).to_string();
    let run = bracket(dir.path(), Some(&mesher), &["mesh", "lap.json", "--no-step"]);
    let text = String::from_utf8_lossy(&run.stderr).into_owned();
    assert_eq!(run.status.code(), Some(0), "{text}");
    assert!(text.contains("mended 1 flat tet: smallest dihedral angle 0.00° before"), "{text}");
    assert!(!text.contains("meshing again"), "{text}");
    let mended = msh::read(&dir.path().join("lap/mesh.msh")).expect("mesh");
    assert_eq!(mended.tets.len(), good.tets.len());
    let read = |name: &str| std::fs::read_to_string(dir.path().join(name)).expect("table");
    let table: serde_json::Value = serde_json::from_str(&read("lap/quality.json")).expect("JSON");
    let rows = table["quality"].as_array().expect("one entry a body");
    assert_eq!(rows.iter().filter_map(|b| b["mended"].as_u64()).sum::<u64>(), 1);
    assert!(read("lap/quality.txt").lines().next().is_some_and(|l| l.ends_with("mended")));
    assert!(!read("good/quality.txt").contains("mended"));
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
