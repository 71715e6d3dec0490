//! Models and meshes that `bracket analyse` must refuse.

use crate::bench::{Bench, Want, none_wrong, refusal};
use crate::common::{Block, triangles_where};
use bracket::mesh::{NamedFaces, TetMesh, msh_write};

const MODEL: &str = "\
mesh: m.msh
analysis: elastic
materials: {steel: {E: 210000, nu: 0.3}}
bodies: {A: steel, B: steel, C: steel}
interfaces:
  - {between: [A, B], law: contact, mu: 0.3, friction: associated}
supports:
  - {face: X0, fix: [x, y, z]}
loads:
  - {face: X1, traction: [-1, 0, 0]}
";

/// Three cubes in a row along x.
fn row() -> TetMesh {
    let mut mesh = Block::new([3, 1, 1], [30.0, 10.0, 10.0]).mesh(
        &["A", "B", "C"],
        |x| (x[0] / 10.0) as usize,
        |_, _| false,
    );
    let triangles = triangles_where(&mesh, |x| x[0] == 10.0);
    mesh.faces.push(NamedFaces { name: "JOINT".into(), triangles });
    mesh
}

fn push(
    results: &mut Vec<(String, Result<String, String>)>,
    name: &str,
    mesh: &[u8],
    model: &str,
    want: Want<'_>,
) {
    let bench = Bench::new().file("model.yaml", model).file("m.msh", mesh);
    results.push((
        name.into(),
        refusal(&bench, &mut bench.command(&["analyse", "model.yaml"]), &want),
    ));
}

/// Old text, new text, code, line, words of the message, words of the cure.
const ROWS: &[(&str, &str, &str, usize, &str, &str)] = &[
    (
        "B: steel, ",
        "",
        "model/no-material",
        4,
        "body `B` of the mesh has no material",
        "add `B: MATERIAL`",
    ),
    (
        "C: steel}",
        "C: steal}",
        "model/unknown-material",
        4,
        "did you mean `steel`",
        "the materials are: steel",
    ),
    (
        "C: steel}",
        "C: steel, D: steel}",
        "model/unknown-body",
        4,
        "no physical volume `D`",
        "A, B, C",
    ),
    (
        "[A, B]",
        "[A, C]",
        "model/no-contact",
        6,
        "`A` and `C` have no face in common",
        "nodes: split",
    ),
    (
        "face: X1",
        "face: X11",
        "model/unknown-face",
        10,
        "did you mean `X1`",
        "the physical surfaces are",
    ),
    (
        "face: X1",
        "face: JOINT",
        "model/not-outer",
        10,
        "contact between `A` and `B`",
        "free outer faces",
    ),
    ("E: 210000", "E: -210000", "model/value", 3, "`E` of material `steel`", "210000"),
    ("E: 210000", "E: -1e300", "model/value", 3, "is -1e300, it must", "210000"),
    ("nu: 0.3}", "nu: .nan}", "yaml/not-finite", 3, "materials.steel.nu", "finite"),
    ("nu: 0.3}", "nu: 0.3, E: 1}", "yaml/duplicate-key", 3, "`E`", "keep one"),
    ("nu: 0.3}", "nu: 0.3, density: 1}", "yaml/unknown-key", 3, "`density`", "E, nu, fy"),
    (
        "analysis: elastic\nmaterials: {steel: {E: 210000, nu: 0.3}}\nbodies: {A: steel, B: \
         steel, C: steel}\ninterfaces:\n  - {between: [A, B], law: contact, mu: 0.3, friction: \
         associated}\n",
        "analysis: limit\nmaterials: {steel: {E: 210000, nu: 0.3}}\nbodies: {A: steel, B: steel, \
         C: steel}\n",
        "model/never-yields",
        3,
        "no body has a yield strength and no interface can open or slip",
        "bodies without one are rigid",
    ),
    (
        "mesh: m.msh",
        "mesh: n.msh",
        "model/no-mesh",
        1,
        "no mesh file `n.msh`",
        "relative to the model file",
    ),
    (
        "  - {face: X0, fix: [x, y, z]}",
        "  - {face: X0, fix: [y, z]}",
        "model/loose-part",
        0,
        "can move along x",
        "support",
    ),
    (
        "traction: [-1, 0, 0]",
        "traction: [0, 0, 0]",
        "model/no-load",
        0,
        "every load is zero",
        "not zero",
    ),
    ("traction: [-1, 0, 0]", "traction: [-1 MPa, 0, 0]", "yaml/type", 10, "-1 MPa", ""),
    (
        "traction: [-1, 0, 0]",
        "traction: -1",
        "yaml/type",
        10,
        "expected an array of length 3",
        "schema",
    ),
    ("E: 210000", "E: 210 GPa", "yaml/type", 3, "expected a number without a unit", "schema"),
    (
        "nu: 0.3}",
        "nu: -1.5}",
        "model/value",
        3,
        "it must be > -1 and at most 0.49999",
        "steel: 0.3",
    ),
    ("analysis: elastic\n", "", "yaml/missing-key", 1, "lacks the key `analysis`", "add `analysis"),
    (
        "analysis: elastic",
        "analysis: elastic\nbounds: upper",
        "yaml/unknown-value",
        3,
        "`upper`",
        "both, kinematic, static",
    ),
    (
        "mesh: m.msh",
        "mesh: .",
        "model/no-mesh",
        1,
        "no mesh file `.`",
        "relative to the model file",
    ),
    ("face: X0", "face: 12", "model/unknown-face", 8, "no physical surface `12`", "X0"),
    (
        "supports:",
        "  - {between: [B, A], law: contact, mu: 0}\nsupports:",
        "model/face-twice",
        7,
        "already named by interfaces[0]",
        "once",
    ),
    (
        "fix: [x, y, z]",
        "fix: []",
        "model/support",
        8,
        "needs either `fix` or `law: contact`",
        "fix: [x, y, z]",
    ),
    ("supports:", "symmetry: 16\nsupports:", "model/value", 7, "`symmetry` is 16", "1, 2, 4 or 8"),
];

#[test]
fn wrong_models_are_refused_with_place_and_cure() {
    let mesh = msh_write::text(&row());
    let mut results = Vec::new();
    for (old, new, code, line, message, cure) in ROWS {
        assert_eq!(MODEL.matches(old).count(), 1, "{old}");
        // a part that can move has no line number: the message names the part
        let place = if *line > 0 { format!("model.yaml:{line}:") } else { String::new() };
        let t = Want { exit: 2, code, place: &place, message, cure };
        push(&mut results, new, mesh.as_bytes(), &MODEL.replace(old, new), t);
    }
    none_wrong(results);
}

#[test]
fn wrong_meshes_are_refused_with_place_and_cure() {
    let good = msh_write::text(&row());
    let line_of =
        |needle: &str| good[..good.find(needle).expect("found")].matches('\n').count() + 1;
    let first_tet = good.lines().position(|l| l.split(' ').nth(1) == Some("4")).expect("a tet") + 1;
    let tet: Vec<&str> = good.lines().nth(first_tet - 1).expect("a line").split(' ').collect();
    let tet_line = tet.join(" ");
    // moves the first corner into the plane of the other three, or to their other side
    let spoil = |move_to: &dyn Fn([[f64; 3]; 4]) -> [f64; 3]| {
        let mut mesh = row();
        let t = mesh.tets[0];
        let x = t.map(|n| mesh.nodes[n as usize]);
        mesh.nodes[t[0] as usize] = move_to(x);
        msh_write::text(&mesh)
    };
    let centre = |x: [[f64; 3]; 4]| std::array::from_fn(|d| (x[1][d] + x[2][d] + x[3][d]) / 3.0);
    let flat = spoil(&|x| centre(x));
    let folded = spoil(&|x| {
        let c: [f64; 3] = centre(x);
        std::array::from_fn(|d| 2.0 * c[d] - x[0][d])
    });
    let quadratic = format!("{} 11 2 1 1 1 2 3 4 5 6 7 8 9 10", tet[0]);
    let at = |line: usize| format!("m.msh:{line}");
    let cut = &good[..good[..good.len() - 400].rfind('\n').expect("a line") + 1];
    let torn = format!("{cut}30 4");
    let second = at(first_tet);
    let version = at(2);
    let cases: Vec<(&str, String, &str, &str, &str, &str)> = vec![
        (
            "second order",
            good.replace(&tet_line, &quadratic),
            "mesh/order",
            &second,
            "10-node",
            "ElementOrder = 1",
        ),
        ("flat", flat, "mesh/flat", "m.msh:", "is flat", "remesh"),
        ("folded", folded, "mesh/folded", "m.msh:", "same side", "remesh"),
        ("cut off", cut.into(), "mesh/truncated", "m.msh", "ends inside `$Elements`", "again"),
        ("torn in a line", torn, "mesh/malformed", "m.msh:", "found `30 4`", "cut off"),
        (
            "binary",
            good.replace("2.2 0 8", "2.2 1 8"),
            "mesh/binary",
            &version,
            "binary",
            "Mesh.Binary = 0",
        ),
        (
            "old version",
            good.replace("2.2 0 8", "1 0 8"),
            "mesh/version",
            &version,
            "format 1",
            "msh41",
        ),
        (
            "no mesh",
            "solid block\n".into(),
            "mesh/not-gmsh",
            "m.msh:1",
            "not a gmsh mesh",
            "gmsh -3",
        ),
        ("empty", String::new(), "mesh/not-gmsh", "m.msh", "not a gmsh mesh", "gmsh -3"),
        ("surface only", surface_only(&good), "mesh/no-tets", "m.msh", "no tetrahedron", "gmsh -3"),
    ];
    let mut results = Vec::new();
    for (name, text, code, place, message, cure) in &cases {
        assert_ne!(text, &good, "{name}");
        push(
            &mut results,
            name,
            text.as_bytes(),
            MODEL,
            Want { exit: 2, code, place, message, cure },
        );
    }
    let nan = line_of("$Nodes") + 2;
    let node = good.lines().nth(nan - 1).expect("a node").to_string();
    let spoilt = good.replacen(&format!("\n{node}\n"), "\n1 nan 0 0\n", 1);
    let place = at(nan);
    let t =
        Want { exit: 2, code: "mesh/not-finite", place: &place, message: "node 1", cure: "gmsh" };
    push(&mut results, "NaN", spoilt.as_bytes(), MODEL, t);
    none_wrong(results);
}

#[test]
fn analyse_names_the_command_that_reads_a_spec() {
    let bench = Bench::new().file("joint.yaml", crate::bench::JOINT);
    let t = Want {
        exit: 2,
        code: "yaml/unknown-key",
        place: "joint.yaml:",
        message: "",
        cure: "`bracket run` reads it",
    };
    if let Err(e) = refusal(&bench, &mut bench.command(&["analyse", "joint.yaml"]), &t) {
        panic!("{e}");
    }
}

/// The file without its tets.
fn surface_only(good: &str) -> String {
    let (head, elements) = good.split_once("$Elements\n").expect("elements");
    let triangles: Vec<&str> =
        elements.lines().filter(|l| l.split(' ').nth(1) == Some("2")).collect();
    format!("{head}$Elements\n{}\n{}\n$EndElements\n", triangles.len(), triangles.join("\n"))
}

#[test]
fn a_part_without_support_is_named_before_anything_is_solved() {
    let mesh = msh_write::text(&row());
    // pulled apart, only contact connects A and B+C: the check counts friction as a support, so the
    // model is pulled sideways without friction
    let model =
        MODEL.replace("mu: 0.3, friction: associated", "mu: 0").replace("[-1, 0, 0]", "[0, 0, -1]");
    let bench = Bench::new().file("model.yaml", model).file("m.msh", mesh);
    let t = Want {
        exit: 2,
        code: "model/loose-part",
        place: "",
        message: "part B+C can move along z",
        cure: "support",
    };
    if let Err(e) = refusal(&bench, &mut bench.command(&["analyse", "model.yaml"]), &t) {
        panic!("{e}");
    }
}

/// A device without end is refused at once.
#[test]
#[cfg(target_os = "linux")]
fn a_device_is_no_mesh() {
    let model = MODEL.replace("m.msh", "/dev/zero");
    let bench = Bench::new().file("model.yaml", model);
    let t = Want {
        exit: 2,
        code: "model/no-mesh",
        place: "model.yaml:1:7",
        message: "there is no mesh file `/dev/zero`",
        cure: "the path is relative",
    };
    if let Err(e) = refusal(&bench, &mut bench.command(&["analyse", "model.yaml"]), &t) {
        panic!("{e}");
    }
}
