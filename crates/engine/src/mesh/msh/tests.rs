use super::*;
use bracket_base::diag::Diagnostic;

const TWO: &str = "$MeshFormat
2.2 0 8
$EndMeshFormat
$PhysicalNames
3
2 5 \"LOAD\"
3 1 \"LEFT\"
3 2 \"RIGHT PART\"
$EndPhysicalNames
$Nodes
6
1 0 0 0
2 1 0 0
3 0 1 0
4 0 0 1
5 0 0 -1
9 7 7 7
$EndNodes
$Elements
4
1 15 2 0 1 1
2 2 2 5 1 1 2 4
3 4 2 1 1 1 2 3 4
4 4 2 2 1 1 2 3 5
$EndElements
";

const TWO_41: &str = "$MeshFormat
4.1 0 8
$EndMeshFormat
$PhysicalNames
3
2 5 \"LOAD\"
3 1 \"LEFT\"
3 2 \"RIGHT PART\"
$EndPhysicalNames
$Entities
1 1 1 2
1 0 0 0 0
1 0 0 0 1 0 0 0 2 1 -1
7 0 0 0 1 0 1 1 5 1 1
1 0 0 0 1 1 1 1 1 1 7
2 0 0 -1 1 1 0 1 2 0
$EndEntities
$Nodes
3 5 10 400000000
0 1 0 1
10
0 0 0
2 7 0 2
20
40
1 0 0
0 0 1
3 1 1 2
30
400000000
0 1 0 0.1 0.2 0.3
0 0 -1 0 0 0
$EndNodes
$Elements
4 4 1 4
0 1 15 1
1 10
2 7 2 1
2 10 20 40
3 1 4 1
3 10 20 30 40
3 2 4 1
4 10 20 30 400000000
$EndElements
";

fn read_text(text: &str) -> Result<(TetMesh, Vec<Text>), MeshError> {
    parse(text.as_bytes(), Path::new("m.msh"))
}

#[test]
fn both_formats_give_the_same_mesh() {
    let (mesh, notes) = read_text(TWO).expect("2.2");
    assert_eq!(mesh.bodies, ["LEFT", "RIGHT PART"]);
    assert_eq!(mesh.tet_body, [0, 1]);
    // the node without a tet is dropped; the inverted second tet is reoriented and reported
    assert_eq!(mesh.nodes.len(), 5);
    assert_eq!(mesh.tets, [[0, 1, 2, 3], [0, 1, 4, 2]]);
    assert!(notes[0].to_string().starts_with("1 of 2 tetrahedra"), "{notes:?}");
    assert_eq!(mesh.faces_named("LOAD").expect("face").triangles, [[0, 1, 3]]);
    let (other, _) = read_text(TWO_41).expect("4.1");
    let by_position = |m: &TetMesh| {
        let mut all: Vec<_> = (0..m.tets.len())
            .map(|e| (m.volume(e), m.tet_body[e], m.corners(e)[0], m.corners(e)[1]))
            .collect();
        all.sort_by(|a, b| a.partial_cmp(b).expect("finite"));
        all
    };
    assert_eq!(by_position(&mesh), by_position(&other));
    assert_eq!(mesh.bodies, other.bodies);
    assert_eq!(other.faces_named("LOAD").expect("face").triangles, [[0, 1, 2]]);
}

#[test]
fn groups_without_a_name_get_one_and_windows_lines_are_read() {
    let (mesh, _) =
        read_text(&TWO.replace("3\n2 5", "2\n2 5").replace("3 1 \"LEFT\"\n", "")).expect("read");
    assert_eq!(mesh.bodies, ["VOLUME_1", "RIGHT PART"]);
    assert!(read_text(&TWO.replace('\n', "\r\n")).is_ok());
}

/// Changes to the 2.2 file: old text, new text, code, line, part of the message, part of the
/// remedy.
const WRONG: &[(&str, &str, &str, usize, &str, &str)] = &[
    ("$MeshFormat\n2.2", "$Mesh\n2.2", "mesh/not-gmsh", 1, "$MeshFormat", "-format msh41"),
    ("2.2 0 8", "2.1 0 8", "mesh/version", 2, "2.1", "Mesh.MshFileVersion"),
    ("2.2 0 8", "2.2 1 8", "mesh/binary", 2, "binary", "Mesh.Binary = 0"),
    ("$EndElements\n", "", "mesh/truncated", 24, "ends inside `$Elements`", "disk"),
    ("4 4 2 2 1 1 2 3 5\n", "", "mesh/malformed", 24, "an element tag", "again"),
    ("3 0 1 0", "3 0 x 0", "mesh/malformed", 14, "a coordinate in `$Nodes`, found `x`", "again"),
    ("3 0 1 0", "3 0 nan 0", "mesh/not-finite", 14, "node 3", "again"),
    ("3 0 1 0", "2 0 1 0", "mesh/repeated", 14, "node 2 is defined twice", "again"),
    ("3 1 \"LEFT\"", "3 2 \"LEFT\"", "mesh/repeated", 8, "RIGHT PART", "again"),
    ("1 2 3 5", "1 2 3 6", "mesh/unknown-node", 24, "element 4 uses node 6", "again"),
    (
        "4 4 2 2 1 1 2 3 5",
        "4 11 2 2 1 1 2 3 5 1 2 3 4 5 1",
        "mesh/order",
        24,
        "element 4 is a 10-node tetrahedron",
        "Mesh.ElementOrder = 1",
    ),
    (
        "2 2 2 5 1 1 2 4",
        "2 9 2 5 1 1 2 4 1 2 3",
        "mesh/order",
        22,
        "6-node triangle",
        "Mesh.ElementOrder = 1",
    ),
    ("4 4 2 2 1 1 2 3 5", "4 5 2 2 1 1 2 3 5 1 2 3 4", "mesh/shape", 24, "hexahedron", "Recombine"),
    ("4 4 2 2 1", "4 4 2 0 1", "mesh/no-body", 24, "tetrahedron 4", "Physical Volume"),
    ("5 0 0 -1", "5 1 1 0", "mesh/flat", 24, "tetrahedron 4 is flat", "Mesh.Optimize"),
    (
        "5 0 0 -1",
        "5 0 0 0.3",
        "mesh/folded",
        24,
        "tetrahedron 4 is inverted or overlaps tetrahedron 3",
        "overlapping",
    ),
    (
        "1 2 3 5\n",
        "2 1 3 4\n",
        "mesh/duplicate",
        24,
        "tetrahedron 4 has the same nodes as tetrahedron 3",
        "second copy",
    ),
    ("1 15 2 0 1 1", "1 2 2 5 1 2 1 4", "mesh/duplicate", 22, "triangle 2", "second copy"),
    ("5 1 1 2 4", "5 1 1 4 5", "mesh/loose-triangle", 22, "`LOAD`", "Physical Surface"),
];

fn diagnostic(text: &str) -> Diagnostic {
    read_text(text).map(|_| ()).expect_err(text).into()
}

#[test]
fn wrong_files_name_element_line_and_cure() {
    for (old, new, code, line, message, help) in WRONG {
        assert!(TWO.contains(old), "{old}");
        let d = diagnostic(&TWO.replacen(old, new, 1));
        assert_eq!((d.code, d.place.line), (*code, Some(*line)), "{new}: {d:?}");
        assert!(d.message.contains(message), "{new}: {d:?}");
        assert!(d.help.as_deref().unwrap_or("").contains(help), "{new}: {d:?}");
        assert_eq!(d.place.file.as_deref(), Some(Path::new("m.msh")));
        assert_eq!(d.fault.exit_code(), 2);
    }
}

#[test]
fn absent_sections_and_tets_are_named() {
    let without = |from: &str, to: &str| {
        let (a, b) = (TWO.find(from).expect("from"), TWO.find(to).expect("to") + to.len() + 1);
        format!("{}{}", &TWO[..a], &TWO[b..])
    };
    let d = diagnostic(&without("$Nodes", "$EndNodes"));
    assert_eq!((d.code, d.message.contains("$Nodes")), ("mesh/missing-section", true));
    let d = diagnostic(&without("$Elements", "$EndElements"));
    assert_eq!((d.code, d.message.contains("$Elements")), ("mesh/missing-section", true));
    let none = TWO
        .replace("3 4 2 1 1 1 2 3 4\n4 4 2 2 1 1 2 3 5\n", "")
        .replace("$Elements\n4", "$Elements\n2");
    assert_eq!(diagnostic(&none).code, "mesh/no-tets");
    let d = diagnostic(&TWO_41.replace("$Entities", "$Other").replace("$EndEntities", "$EndOther"));
    assert_eq!((d.code, d.message.contains("$Entities")), ("mesh/missing-section", true));
    let d = diagnostic(&TWO_41.replace("1 0 0 0 1 1 1 1 1 1 7", "1 0 0 0 1 1 1 2 1 2 1 7"));
    assert_eq!((d.code, d.place.line), ("mesh/two-bodies", Some(15)));
    let d = diagnostic(&TWO_41.replace("3 2 4 1", "3 3 4 1"));
    assert_eq!((d.code, d.place.line), ("mesh/unknown-entity", Some(42)));
    let e = read(Path::new("no/such.msh")).expect_err("absent");
    assert_eq!(Diagnostic::from(e).code, "mesh/read");
}

#[test]
fn slivers_of_a_thousandth_of_a_degree_are_kept() {
    let (mesh, _) = read_text(&TWO.replace("5 0 0 -1", "5 0.5 0.5 -1e-5")).expect("sliver");
    assert_eq!(mesh.tets.len(), 2);
    assert!(mesh.volume(1) > 0.0);
}

/// The two reference meshes of `tests/data`; the expected counts are from an independent reader.
#[test]
fn reference_meshes_are_read() {
    for (name, tets, nodes, contact) in [("9k", 8899, 3170, 379), ("33k", 32624, 10643, 1507)] {
        let path = format!(
            "{}/../../tests/data/paper_quarter_{name}/mesh.msh",
            env!("CARGO_MANIFEST_DIR")
        );
        let (mesh, notes) = read_with_notes(Path::new(&path)).expect("reference mesh");
        assert_eq!((mesh.tets.len(), mesh.nodes.len()), (tets, nodes));
        assert_eq!(
            mesh.bodies,
            ["COLUMN", "BEAM_R", "PLATE_R", "BOLT_RP1", "BOLT_RP2", "BOLT_RP3"]
        );
        for side in ["PLATE_COLUMN_A", "PLATE_COLUMN_B"] {
            assert_eq!(mesh.faces_named(side).expect("face").triangles.len(), contact);
        }
        assert!((0..tets).all(|e| mesh.volume(e) > 0.0));
        assert!(notes.is_empty(), "{notes:?}");
    }
}

proptest::proptest! {
    #![proptest_config(proptest::prelude::ProptestConfig::with_cases(600))]
    #[test]
    fn mutated_files_never_panic(
        v4: bool,
        at in 0usize..900,
        len in 0usize..12,
        put in "[0-9 .$\\n\"a-zE-]{0,8}",
    ) {
        let text = if v4 { TWO_41 } else { TWO };
        let at = at.min(text.len());
        let end = (at + len).min(text.len());
        let _ = read_text(&format!("{}{put}{}", &text[..at], &text[end..]));
        let _ = read_text(&text[..at]);
    }
}
