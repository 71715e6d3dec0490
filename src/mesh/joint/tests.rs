use super::*;
use crate::geometry::fixtures::{lap_joint, paper_joint};

/// Runs only where gmsh is found: the mesher is a separate program, its absence is tested elsewhere.
fn options(dir: &Path) -> MeshOptions {
    MeshOptions::new(dir)
}

fn meshed(assembly: &Assembly, change: impl FnOnce(&mut MeshOptions)) -> JointMesh {
    let dir = tempfile::tempdir().expect("temporary folder");
    let mut o = options(dir.path());
    change(&mut o);
    mesh_joint(assembly, &o, &mut |_| {}).unwrap_or_else(|e| panic!("{e:#?}"))
}

#[test]
fn paper_quarter_has_the_bodies_and_faces_of_the_model() {
    let joint = paper_joint();
    let m = meshed(&joint, |_| {});
    assert_eq!(m.mesh.bodies, ["COLUMN", "BOLT_RP1", "BOLT_RP2", "BOLT_RP3", "PLATE_R", "BEAM_R"]);
    let names: Vec<&str> = m.mesh.faces.iter().map(|f| f.name.as_str()).collect();
    assert_eq!(names, ["SHANK_RP1", "SHANK_RP2", "SHANK_RP3", "SUPPORT_R", "LOAD_TOP", "SYM_X0", "SYM_Y0"]);
    assert_eq!(m.copies, 4);
    println!("{} tets, {} s\n{}", m.mesh.tets.len(), m.mesher_seconds, quality::text(&m.quality));
    println!("{:#?}", m.checks);
}
