//! Tests with gmsh: the two fixtures are meshed, named and checked. Tests without gmsh: every way
//! in which a mesher can fail, with fake mesher scripts.

use super::*;
use crate::assembly::assembly::Surface;
use crate::geometry::fixtures::{lap_joint, move_part, paper_joint};
use bracket_base::diag::Diagnostic;

fn meshed(assembly: &Assembly, change: impl FnOnce(&mut MeshOptions)) -> JointMesh {
    let dir = tempfile::tempdir().expect("temporary folder");
    let mut o = MeshOptions::new(dir.path());
    change(&mut o);
    mesh_joint(assembly, &o, &mut |_| {}).unwrap_or_else(|e| panic!("{e:#?}"))
}

/// The study for the choice of the default sizes; prints one row per size factor.
#[test]
#[ignore = "a measurement, not a check: run with --nocapture"]
fn measure_paper_quarter() {
    let joint = paper_joint();
    let out = std::env::var("MEASURE_OUT").ok();
    let number = |key: &str, default: f64| {
        std::env::var(key).ok().and_then(|v| v.parse().ok()).unwrap_or(default)
    };
    let mut joint = joint;
    for p in &mut joint.parts {
        let key = match p.role {
            crate::assembly::assembly::PartRole::Member if p.name == "COLUMN" => "COLUMN",
            crate::assembly::assembly::PartRole::Member => "BEAM",
            crate::assembly::assembly::PartRole::Plate => "PLATE",
            crate::assembly::assembly::PartRole::Bolt => "BOLT",
        };
        p.size = number(key, p.size);
    }
    let d = SizeRule::default();
    for factor in std::env::var("FACTORS").unwrap_or("1".into()).split(',') {
        let m = meshed(&joint, |o| {
            o.layers = number("LAYERS", 1.0) > 0.0;
            o.sizes = SizeRule {
                factor: factor.parse().expect("number"),
                growth: number("GROWTH", d.growth),
                across_footprint: number("FOOT", d.across_footprint),
                span_growth: number("SPAN_GROWTH", d.span_growth),
                span_limit: number("SPAN_LIMIT", d.span_limit),
                at_hinges: d.at_hinges,
            };
        });
        println!(
            "factor {factor}: {} tets, {:.2} s\n{}",
            m.mesh.tets.len(),
            m.mesher_seconds,
            quality::text(&m.quality)
        );
        if let Some(out) = &out {
            msh_write::write(&m.mesh, Path::new(&format!("{out}_{factor}.msh"))).expect("written");
        }
    }
}

#[test]
fn paper_quarter_has_the_bodies_and_faces_of_the_model() {
    let joint = paper_joint();
    let m = meshed(&joint, |_| {});
    assert_eq!(m.mesh.bodies, ["COLUMN", "BOLT_RP1", "BOLT_RP2", "BOLT_RP3", "PLATE_R", "BEAM_R"]);
    let names: Vec<&str> = m.mesh.faces.iter().map(|f| f.name.as_str()).collect();
    assert_eq!(
        names,
        ["SHANK_RP1", "SHANK_RP2", "SHANK_RP3", "SUPPORT_R", "LOAD_TOP", "SYM_X0", "SYM_Y0"]
    );
    assert_eq!(m.copies, 4);
    assert!((13_000..=18_000).contains(&m.mesh.tets.len()), "{}", m.mesh.tets.len());
    // Values computed by hand: the support footprint 15 × 85, and the plate's back without three
    // holes, the column's fillets and the gap beside it. Half of the column's web and flanges at x
    // = 0 with stiffeners is checked in `naming`.
    let area = |name: &str| m.checks.areas.iter().find(|a| a.name == name).expect("checked").meshed;
    assert!((area("SUPPORT_R") - 1275.0).abs() < 1e-6);
    let plate_on_column = 90.0 * 450.0 - 3.0 * std::f64::consts::PI * 81.0;
    assert!((area("COLUMN / PLATE_R") / plate_on_column - 1.0).abs() < 1e-6);
    // Quarter of HEB200's area, 7808 mm² (catalogue)
    assert!((area("LOAD_TOP") / (7808.0 / 4.0) - 1.0).abs() < 1e-3);
    // Half of IPE360's area, 7273 mm²
    assert!((area("PLATE_R / BEAM_R") / (7273.0 / 2.0) - 1.0).abs() < 1e-3);
}

#[test]
fn same_assembly_gives_the_same_bytes() {
    let joint = lap_joint();
    let text = || msh_write::text(&meshed(&joint, |_| {}).mesh);
    assert_eq!(text(), text());
}

#[test]
fn mid_planes_are_planes_of_the_mesh() {
    // Cut at mid-thickness: each half of the 10 mm plates has exactly half the volume.
    for (layers, expected) in [(true, true), (false, false)] {
        let m = meshed(&lap_joint(), |o| o.layers = layers).mesh;
        let upper = m.bodies.iter().position(|b| b == "UPPER").expect("kept");
        let crossed = (0..m.tets.len()).filter(|&e| m.tet_body[e] as usize == upper).any(|e| {
            let z = m.corners(e).map(|x| x[2]);
            z.iter().any(|z| *z < 5.0 - 1e-6) && z.iter().any(|z| *z > 5.0 + 1e-6)
        });
        assert_eq!(!crossed, expected, "layers {layers}");
    }
}

#[test]
fn full_joint_is_twice_the_half() {
    let joint = lap_joint();
    let volume = |full: bool| {
        meshed(&joint, |o| o.full = full).quality.iter().map(|q| q.volume).sum::<f64>()
    };
    assert!((volume(true) / volume(false) - 2.0).abs() < 1e-9);
}

#[test]
fn step_file_holds_every_part_as_a_solid() {
    let dir = tempfile::tempdir().expect("temporary folder");
    let path = dir.path().join("lap.step");
    write_step(&lap_joint(), &MeshOptions::new(dir.path().join("work")), &path)
        .unwrap_or_else(|e| panic!("{e:#?}"));
    let text = std::fs::read_to_string(&path).expect("written");
    assert_eq!(text.matches("MANIFOLD_SOLID_BREP").count(), 3);
    assert!(text.contains("CYLINDRICAL_SURFACE"), "true circles");
    assert!(text.contains(".MILLI."), "millimetres");
}

/// The message for a face outside its part states where the face was searched for and where the
/// part lies.
#[test]
fn an_absent_face_is_told_with_its_place_and_that_of_the_part() {
    let mut joint = lap_joint();
    let face = joint.faces.first_mut().expect("a face");
    let Surface::Plane { at, .. } = &mut face.surface else { panic!("a plane") };
    *at += 7.25;
    let (name, part, plane) = (
        face.name.clone(),
        face.part.clone(),
        format!("on the plane x = {at} mm, y from -30 to 30 mm"),
    );
    let dir = tempfile::tempdir().expect("temporary folder");
    let faults = mesh_joint(&joint, &MeshOptions::new(dir.path()), &mut |_| {})
        .expect_err("the face is beside its part");
    let d = faults
        .iter()
        .find(|d| d.code == "mesh/face-empty")
        .unwrap_or_else(|| panic!("{faults:#?}"));
    for words in [&name, &part, &plane] {
        assert!(d.message.contains(words), "{words}: {}", d.message);
    }
    let help = d.help.as_deref().unwrap_or_default();
    assert!(help.contains("the part reaches x from ") && help.contains("move the face"), "{help}");
    // the message describes a mantle as a cylinder
    let mantle =
        Surface::Mantle { base: [1.0, 2.0, 3.0], axis: [0.0, 0.0, 1.0], radius: 9.0, length: 40.0 };
    let words = crate::meshing::naming::surface::looked_for(&mantle);
    assert_eq!(
        words,
        "on the cylinder of radius 9 mm from (1, 2, 3) mm along (0, 0, 1), 40 mm long"
    );
}

#[test]
fn clash_stops_before_the_mesher_runs() {
    let mut joint = lap_joint();
    move_part(&mut joint, "BOLT", [0.0, 0.0, -3.0]);
    let dir = tempfile::tempdir().expect("temporary folder");
    let fake = fake(dir.path(), "exit 7");
    let d = failure(&joint, dir.path(), Some(fake), 5.0);
    assert_eq!((d.code, d.fault.exit_code()), ("geometry/clash", 2));
}

/// A shell script that answers `--version` and otherwise runs the given commands.
#[cfg(unix)]
fn fake(dir: &Path, body: &str) -> Mesher {
    let script = dir.join("fake_gmsh.sh");
    std::fs::write(
        &script,
        format!("if [ \"$1\" = --version ]; then echo 4.15.2; exit 0; fi\n{body}\n"),
    )
    .expect("written");
    Mesher::with_command(vec!["sh".into(), script.into()]).unwrap_or_else(|e| panic!("{e}"))
}

fn failure(assembly: &Assembly, dir: &Path, mesher: Option<Mesher>, seconds: f64) -> Diagnostic {
    let mut o = MeshOptions::new(dir.join("work"));
    o.mesher = mesher;
    o.time_limit = Duration::from_secs_f64(seconds);
    let error = mesh_joint(assembly, &o, &mut |_| {}).expect_err("must fail");
    assert!(!dir.join("work/mesh.msh").exists());
    error.into_first()
}

#[cfg(unix)]
fn with_fake(body: &str, seconds: f64) -> Diagnostic {
    let dir = tempfile::tempdir().expect("temporary folder");
    let mesher = fake(dir.path(), body);
    failure(&lap_joint(), dir.path(), Some(mesher), seconds)
}

#[test]
#[cfg(unix)]
fn time_limit_kills_the_mesher() {
    let started = Instant::now();
    let d = with_fake("exec sleep 60", 0.2);
    assert!(started.elapsed() < Duration::from_secs(20));
    assert_eq!((d.code, d.fault.exit_code()), ("mesher/time", 4));
    assert!(d.help.is_some());
}

#[test]
#[cfg(unix)]
fn killed_mesher_is_told_from_a_failed_one() {
    let d = with_fake("kill -9 $$", 10.0);
    assert_eq!((d.code, d.fault.exit_code()), ("mesher/killed", 4));
    assert!(d.message.contains("signal 9"), "{}", d.message);
    // a crash of the program, or of the one behind a shell
    for crash in ["kill -11 $$", "exit 134", "exit 139"] {
        assert_eq!(with_fake(crash, 10.0).code, "mesher/crashed", "{crash}");
    }
    assert_eq!(with_fake("exit 130", 10.0).code, "mesher/failed");
    let d = with_fake("echo 'Error   : Could not fuse' >&2; exit 1", 10.0);
    assert_eq!(d.code, "mesher/failed");
    assert!(
        d.message.contains("exit code 1") && d.message.contains("Could not fuse"),
        "{}",
        d.message
    );
}

/// Errors while meshing are tried again, with other algorithms and sizes; those of the geometry
/// come again each time and are reported at once.
#[test]
#[cfg(unix)]
fn only_errors_of_meshing_are_tried_again() {
    let runs = |body: &str| {
        let dir = tempfile::tempdir().expect("temporary folder");
        let mesher = fake(dir.path(), &format!("echo run >> ../runs\n{body}"));
        let d = failure(&lap_joint(), dir.path(), Some(mesher), 20.0);
        let runs = std::fs::read_to_string(dir.path().join("runs")).expect("runs");
        (d.code, runs.lines().count())
    };
    assert_eq!(runs("echo 'Error   : Could not fuse'"), ("mesher/failed", 1));
    let meshing = "echo 'Info    : Meshing 1D...'; echo 'Error   : PLC Error'";
    assert_eq!(runs(meshing), ("mesher/failed", 6));
}

/// Sizes far above those of the parts end at the width of each part.
#[test]
fn sizes_larger_than_the_parts_are_meshed() {
    for factor in [8.0, 20.0, 1000.0] {
        let m = meshed(&lap_joint(), |o| o.sizes.factor = factor);
        assert!(m.worst_dihedral() >= mend::FLAT, "{factor}: {}", quality::text(&m.quality));
    }
}

#[test]
#[cfg(unix)]
fn success_is_not_believed() {
    // Exit code 0 in each case: errors in the log, a lost volume, no file, an empty file, half a
    // file.
    let d = with_fake("echo 'Error   : PLC Error'; exit 0", 10.0);
    assert!(d.code == "mesher/failed" && d.message.contains("PLC Error"), "{}", d.message);
    let d = with_fake("echo 'Warning : Skipping unknown volume 3'; exit 0", 10.0);
    assert!(d.code == "mesher/failed" && d.message.contains("unknown volume 3"), "{}", d.message);
    let d = with_fake("exit 0", 10.0);
    assert!(d.code == "mesher/no-output" && d.message.contains("absent"), "{}", d.message);
    let d = with_fake(": > joint_raw.msh", 10.0);
    assert!(d.code == "mesher/no-output" && d.message.contains("empty"), "{}", d.message);
    let d = with_fake(
        "printf '$MeshFormat\\n2.2 0 8\\n$EndMeshFormat\\n$Nodes\\n4\\n1 0 0 0\\n' > joint_raw.msh",
        10.0,
    );
    assert!(d.code == "mesher/no-output" && d.message.contains("cut off"), "{}", d.message);
    assert_eq!(d.fault.exit_code(), 4);
}

#[test]
#[cfg(target_os = "linux")]
fn full_disk_is_named() {
    // The script's output goes to the device that is always full, as the output of gmsh would on a
    // full disk.
    let d = with_fake("cat /dev/zero > /dev/full", 10.0);
    assert_eq!((d.code, d.fault.exit_code()), ("mesher/disk", 4));
}

#[test]
#[cfg(unix)]
fn body_lost_by_the_mesher_is_named() {
    // A valid mesh with one tet, in one of the three parts.
    let body = "cat > joint_raw.msh <<'END'
$MeshFormat
2.2 0 8
$EndMeshFormat
$PhysicalNames
1
3 1 \"UPPER\"
$EndPhysicalNames
$Nodes
4
1 0 0 0
2 1 0 0
3 0 1 0
4 0 0 1
$EndNodes
$Elements
1
1 4 2 1 1 1 2 3 4
$EndElements
END";
    let d = with_fake(body, 10.0);
    assert_eq!((d.code, d.fault.exit_code()), ("mesh/body-lost", 2));
    assert!(d.message.contains("LOWER"), "{}", d.message);
}

#[test]
fn mesher_that_does_not_exist_sends_to_the_doctor() {
    let error = Mesher::with_command(vec!["/nonexistent/gmsh".into()]).expect_err("absent");
    let d = Diagnostic::from(error);
    assert_eq!((d.code, d.fault.exit_code()), ("mesher/start", 4));
    assert!(d.help.is_some_and(|h| h.contains("bracket doctor")));
}

#[test]
#[cfg(unix)]
fn old_or_mute_mesher_is_refused() {
    let dir = tempfile::tempdir().expect("temporary folder");
    let ask = |text: &str| {
        let script = dir.path().join("v.sh");
        std::fs::write(&script, text).expect("written");
        Diagnostic::from(
            Mesher::with_command(vec!["sh".into(), script.into()]).expect_err("refused"),
        )
    };
    assert_eq!(ask("echo 3.0.6 >&2").code, "mesher/old");
    assert_eq!(ask("echo no such module; exit 1").code, "mesher/version");
}

/// The command-line tests mesh this file; the test fails if the fixture changes but the file does
/// not.
#[test]
fn json_fixture_is_the_lap_joint() {
    let text = include_str!("../../../../../tests/data/lap_joint.json");
    assert_eq!(serde_json::from_str::<Assembly>(text).expect("valid"), lap_joint());
}
