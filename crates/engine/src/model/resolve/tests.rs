use super::*;
use crate::mesh::fixtures::{cubes, explode, msh_text, name};
use crate::mesh::tet::signed_volume;
use crate::model::FrictionLaw;
use crate::model::analysis::Traction;
use crate::model::file::Gap;

mod loose;
mod wrong;
mod wrong_preload;

/// Four cubes in a row along x, bodies A (two cubes), B, C, on a floor at z = 0.
pub(super) fn row() -> TetMesh {
    let mut m = cubes(&[([0, 0, 0], "A"), ([1, 0, 0], "A"), ([2, 0, 0], "B"), ([3, 0, 0], "C")]);
    for (face, axis, at) in [
        ("LEFT", 0, 0.0),
        ("INSIDE", 0, 10.0),
        ("AB", 0, 20.0),
        ("BC", 0, 30.0),
        ("RIGHT", 0, 40.0),
        ("FLOOR", 2, 0.0),
    ] {
        name(&mut m, face, |x| x[axis] == at);
    }
    m
}

pub(super) const GOOD: &str = "mesh: m.msh
analysis: elastic
materials: {steel: {E: 210000, nu: 0.3}}
bodies: {A: steel, B: steel, C: steel}
interfaces:
  - {between: [B, A], law: contact, mu: 0.3, friction: associated}
supports:
  - {face: LEFT, fix: [x, y, z]}
loads:
  - {face: RIGHT, traction: [-1, 0, 0]}
";

pub(super) fn model(mesh: TetMesh, text: &str) -> Result<AnalysisModel, Diagnostics> {
    let parsed = yaml::parse::<ModelFile>(text, Path::new("model.yaml"))?;
    resolve(&parsed.value, mesh, &|path| parsed.index.place(path))
}

#[test]
fn a_good_model() {
    let m = model(row(), GOOD).expect("good");
    assert_eq!(m.parts, ["A", "B+C"]);
    assert_eq!(m.mesh.nodes.len(), row().nodes.len() + 4);
    assert_eq!((m.interfaces.len(), m.interfaces[0].name.as_str()), (1, "B-A"));
    // side A is the first body of `between`, and its normal points out of it
    for f in &m.interfaces[0].faces {
        assert_eq!(m.mesh.bodies[m.mesh.tet_body[f.a.tet as usize] as usize], "B");
        let x = f.nodes_a.map(|n| m.mesh.nodes[n as usize]);
        let centre = m.mesh.nodes[m.mesh.tets[f.a.tet as usize][f.a.local as usize] as usize];
        assert!(signed_volume(&[x[0], x[1], x[2], centre]) < 0.0);
    }
    assert_eq!(m.supports[0].faces.len(), 2);
    assert_eq!(
        m.surface_loads[0].traction,
        Traction::Linear { traction0: [-1.0, 0.0, 0.0], gradient: [[0.0; 3]; 3] }
    );
    assert!(m.free_modes.is_empty() && m.notes.is_empty(), "{:?}", m.notes);
}

#[test]
fn face_narrows_or_replaces_between() {
    let with = |entry: &str| {
        model(
            row(),
            &GOOD.replace("{between: [B, A], law: contact, mu: 0.3, friction: associated}", entry),
        )
    };
    // a face alone: side A is the first body of the mesh
    let m = with("{face: AB, law: contact, mu: 0.3, friction: associated}").expect("face alone");
    assert_eq!((m.interfaces[0].name.as_str(), m.interfaces[0].faces.len()), ("AB", 2));
    assert_eq!(m.mesh.tet_body[m.interfaces[0].faces[0].a.tet as usize], 0);
    // a face that holds more than the pair is cut down to the pair
    let mut mesh = row();
    name(&mut mesh, "BOTH", |x| x[0] == 20.0 || x[0] == 30.0 || x[0] == 0.0);
    let text = GOOD.replace("{between: [B, A],", "{between: [B, A], face: BOTH,");
    let m = model(mesh.clone(), &text).expect("narrowed");
    assert_eq!(m.interfaces[0].faces.len(), 2);
    assert_eq!(m.parts, ["A", "B+C"]);
    // half of the faces of a pair: the other half stays tied
    mesh.faces
        .last_mut()
        .expect("BOTH")
        .triangles
        .retain(|t| t.iter().all(|n| mesh.nodes[*n as usize][0] == 20.0));
    mesh.faces.last_mut().expect("BOTH").triangles.truncate(1);
    let m = model(mesh, &text).expect("half");
    assert_eq!((m.interfaces[0].faces.len(), m.parts.len()), (1, 1));
    assert_eq!(m.parts, ["A+B+C"]);
}

#[test]
fn a_mesh_that_came_split_gives_the_same_model() {
    let whole = model(row(), GOOD).expect("shared");
    let text = GOOD.replace("analysis:", "nodes: split\nanalysis:");
    let m = model(explode(&row()), &text).expect("split");
    assert_eq!(
        (&m.parts, m.interfaces[0].faces.len()),
        (&whole.parts, whole.interfaces[0].faces.len())
    );
    assert_eq!(m.mesh.nodes.len(), whole.mesh.nodes.len());
    // the name may mark the side of either body, or both
    let by_face = text.replace("{between: [B, A],", "{face: AB,");
    let mut other = explode(&row());
    let twins: Vec<[u32; 3]> = other.faces[2].triangles.clone();
    let last = other.nodes.clone();
    other.faces[2].triangles.extend(twins.iter().map(|t| {
        t.map(|n| {
            let x = last[n as usize];
            last.iter().rposition(|y| *y == x).expect("twin") as u32
        })
    }));
    assert_eq!(other.faces[2].triangles.len(), 4);
    let m = model(other, &by_face).expect("both sides named");
    assert_eq!(m.interfaces[0].faces.len(), 2);
}

#[test]
fn everything_the_contract_lets_one_write() {
    let text = "mesh: m.msh
analysis: elastic
bounds: static
materials: {steel: {E: 210000, nu: 0.3, fy: 235}, soft: {E: 1000, nu: 0.49}}
bodies: {A: steel, B: soft, C: steel}
interfaces:
  - {between: [A, B], law: contact, mu: 0, gap: {quadratic: [0, 0, 0, 0, 0, 1.0e-3, 0, 0, 0, 0]}}
  - {between: [B, C], law: tied}
supports:
  - {face: LEFT, fix: [y, z]}
  - {face: FLOOR, law: contact, mu: 0.2, gap: 0.5}
rigid:
  - {face: RIGHT, components: [x, y, z], free: [rz, ux], at: [40, 5, 5], force: [-7, 0, 0], \
                dead_moment: [0, 0, 9]}
loads:
  - {face: LEFT, pressure: 2}
  - {face: LEFT, linear: {traction0: [1, 0, 0], gradient: [[0, 0, 0.1], [0, 0, 0], [0, 0, 0]]}}
dead:
  - {body: ALL, force: [0, 0, -7.7e-5]}
  - {body: B, force: [1, 0, 0]}
symmetry: 4
adapt: {target_gap: 0.05}
";
    let m = model(row(), text).expect("rich");
    assert_eq!(
        m.materials.iter().map(|m| (m.name.as_str(), m.fy)).collect::<Vec<_>>(),
        [("soft", None), ("steel", Some(235.0))]
    );
    assert_eq!(m.body_material, [1, 0, 1]);
    assert_eq!(m.symmetry, 4);
    assert_eq!(
        (m.ground[0].law.mu, &m.ground[0].law.gap, m.ground[0].faces.len()),
        (0.2, &Gap::Constant(0.5), 8)
    );
    assert_eq!(m.ground[0].law.friction, FrictionLaw::Associated);
    assert_eq!(m.rigid[0].free, [true, false, false, false, false, true]);
    assert_eq!(
        (m.rigid[0].action, m.rigid[0].dead_action),
        ([-7.0, 0.0, 0.0, 0.0, 0.0, 0.0], [0.0, 0.0, 0.0, 0.0, 0.0, 9.0])
    );
    assert_eq!(m.surface_loads[0].traction, Traction::Pressure(2.0));
    assert_eq!(m.body_loads.len(), 4);
    assert!(m.body_loads.iter().all(|l| l.dead));
    assert!(
        m.notes.iter().any(|n| n.to_string().contains("associated friction is used")),
        "{:?}",
        m.notes
    );
}

#[test]
fn units_that_look_wrong_are_noted() {
    let mut metres = row();
    metres.nodes.iter_mut().flatten().for_each(|c| *c /= 1000.0);
    let m = model(metres, GOOD).expect("metres");
    assert!(
        m.notes[0].to_string().contains("0.04 mm")
            && m.notes[0].to_string().contains("scale them to mm"),
        "{:?}",
        m.notes
    );
    let m = model(row(), &GOOD.replace("210000", "2.1e11")).expect("Pa");
    assert!(m.notes[0].to_string().contains("divide by 1e6"), "{:?}", m.notes);
}

/// The reference meshes: 565 and 1 965 contact triangles by the reference program, two parts.
#[test]
fn reference_joints() {
    for (folder, counts) in [("9k", [379, 42, 72, 72]), ("33k", [1507, 144, 160, 154])] {
        let path = format!(
            "{}/../../tests/data/paper_quarter_{folder}/model.yaml",
            env!("CARGO_MANIFEST_DIR")
        );
        let m = load_model(Path::new(&path)).expect("reference model");
        assert_eq!(m.parts, ["COLUMN", "BEAM_R+PLATE_R+BOLT_RP1+BOLT_RP2+BOLT_RP3"]);
        assert_eq!(m.interfaces.iter().map(|i| i.faces.len()).collect::<Vec<_>>(), counts);
        assert!(m.free_modes.is_empty() && m.notes.is_empty(), "{:?}", m.notes);
        for f in m.interfaces.iter().flat_map(|i| &i.faces) {
            for (a, b) in f.nodes_a.iter().zip(f.nodes_b) {
                assert_eq!(m.mesh.nodes[*a as usize], m.mesh.nodes[b as usize]);
            }
        }
        // outer faces of the quarter on both sides: every node belongs to a tet
        let mut used = vec![false; m.mesh.nodes.len()];
        m.mesh.tets.iter().flatten().for_each(|n| used[*n as usize] = true);
        assert!(used.iter().all(|u| *u));
    }
}

#[test]
fn files_are_read_together() {
    let dir = tempfile::tempdir().expect("folder");
    let at = |name: &str| dir.path().join(name);
    std::fs::write(at("model.yaml"), GOOD).expect("write");
    let d = load_model(&at("model.yaml")).expect_err("no mesh");
    assert_eq!((d.first().code, d.first().place.line), ("model/no-mesh", Some(1)));
    std::fs::write(at("m.msh"), msh_text(&row())).expect("write");
    let m = load_model(&at("model.yaml")).expect("both files");
    assert_eq!(
        m,
        model(row(), GOOD)
            .map(|mut n| {
                n.notes = m.notes.clone();
                n
            })
            .expect("same")
    );
    std::fs::write(at("m.msh"), msh_text(&row()).replace("$EndElements\n", "")).expect("write");
    let d = load_model(&at("model.yaml")).expect_err("cut off");
    assert_eq!((d.first().code, d.exit_code()), ("mesh/truncated", 2));
    assert!(d.first().place.file.as_ref().is_some_and(|f| f.ends_with("m.msh")));
    assert_eq!(load_model(&at("other.yaml")).expect_err("absent").first().code, "model/read");
}

/// Every number of copies that a joint with up to three planes of symmetry can have is accepted.
#[test]
fn a_joint_with_any_number_of_symmetry_planes_is_accepted() {
    for copies in [1, 2, 4, 8] {
        let m = model(row(), &GOOD.replace("loads:", &format!("symmetry: {copies}\nloads:")));
        assert_eq!(m.unwrap_or_else(|e| panic!("{copies}: {e:#?}")).symmetry, copies);
    }
}
