//! Bodies without a yield strength are rigid: platens, punches, blocks and plates, tied or in
//! contact.

use crate::common::limit::{factors, sharp_factors};
use crate::common::yielding::{FY, model};
use crate::common::{Block, solved, triangles_where};
use bracket::elements::hencky_kinematic::Flow;
use bracket::mesh::topology::FaceTable;
use bracket::mesh::{NamedFaces, TetMesh};
use bracket::model::{AnalysisModel, ModelError};
use bracket::programs::{Kinematic, Static};

/// Yield strength in shear over yield strength in tension.
const K: f64 = 0.577_350_269_189_625_8;

/// The mesh without the bodies called `VOID`.
fn hollow(mesh: TetMesh) -> TetMesh {
    let void = mesh.bodies.iter().position(|b| b == "VOID").unwrap() as u32;
    without(mesh, void)
}

fn without(mut mesh: TetMesh, gone: u32) -> TetMesh {
    let kept: Vec<usize> = (0..mesh.tets.len()).filter(|&e| mesh.tet_body[e] != gone).collect();
    let mut number = vec![u32::MAX; mesh.nodes.len()];
    let mut nodes = Vec::new();
    for &e in &kept {
        for n in mesh.tets[e] {
            if number[n as usize] == u32::MAX {
                number[n as usize] = nodes.len() as u32;
                nodes.push(mesh.nodes[n as usize]);
            }
        }
    }
    mesh.tet_body =
        kept.iter().map(|&e| mesh.tet_body[e] - u32::from(mesh.tet_body[e] > gone)).collect();
    mesh.tets = kept.iter().map(|&e| mesh.tets[e].map(|n| number[n as usize])).collect();
    mesh.nodes = nodes;
    mesh.bodies.remove(gone as usize);
    // names stay with the remaining faces
    let faces = FaceTable::new(&mesh.tets);
    for f in &mut mesh.faces {
        f.triangles = f.triangles.iter().map(|t| t.map(|n| number[n as usize])).collect();
        f.triangles.retain(|t| t.iter().all(|n| *n != u32::MAX) && !faces.owners(*t).is_empty());
    }
    mesh.faces.retain(|f| !f.triangles.is_empty());
    mesh
}

/// An eighth of a cube of edge 2, pressed at its top between rough rigid platens. The platen is a
/// body tied to the cube, or a rigid face.
///
/// ```text
///   ↓↓↓↓↓
///   [▓▓▓]   B, rigid
///   |   |   A
///   +---+
/// ```
fn platen(n: usize, body: bool) -> AnalysisModel {
    let sides = "- {face: X0, fix: [x]}\n- {face: Y0, fix: [y]}\n- {face: Z0, fix: [z]}\n";
    if body {
        let shape = Block {
            cells: [n, n, n + 1],
            min: [0.0; 3],
            max: [1.0, 1.0, 1.0 + 1.0 / n as f64],
            jitter: 0.2,
            seed: 3,
        };
        let mesh = shape.mesh(
            &["A", "B"],
            |c| usize::from(c[2] > 1.0),
            |d, x| d == 2 && (x - 1.0).abs() < 1e-9,
        );
        model(
            &format!(
                "bodies: {{A: s, B: r}}\nsupports:\n{sides}loads:\n- {{face: Z1, traction: [0, 0, \
                 -1]}}\n"
            ),
            mesh,
        )
    } else {
        let mesh = Block::new([n; 3], [1.0; 3]).jittered(3).mesh(&["A"], |_| 0, |_, _| false);
        let face =
            "- {face: Z1, components: [x, y, z], free: [uz], at: [0, 0, 1], force: [0, 0, -1]}\n";
        model(&format!("bodies: {{A: s}}\nsupports:\n{sides}rigid:\n{face}"), mesh)
    }
}

/// A33 with the platen as a rigid body: the known strict bracket is [1.0353, 1.0600] s0.
#[test]
fn cube_between_platens_that_are_bodies() {
    let [low, up] = factors("A33", &platen(4, true));
    assert!(low <= 1.0600 && up >= 1.0353, "[{low}, {up}]");
    assert!(up / low - 1.0 < 0.06, "[{low}, {up}]");
}

/// The programs contain nothing of the inside of a rigid body: they have as many cones and unknowns
/// as without it, and six rigid motions minus those held by supports.
#[test]
fn rigid_bodies_leave_the_programs() {
    let (with, without) = (platen(2, true), platen(2, false));
    let tets = without.mesh.tets.len();
    assert!(with.mesh.tets.len() > tets);
    let k = [&with, &without].map(|m| Kinematic::limit(m, Flow::Split).unwrap());
    let s = [&with, &without].map(|m| Static::limit(m).unwrap());
    let cones = [&k[0].program, &k[1].program, &s[0].program, &s[1].program].map(|p| p.cones.len());
    assert_eq!(cones, [40 * tets, 40 * tets, 16 * tets, 16 * tets]);
    assert_eq!(k[0].program.shared(), k[1].program.shared());
    assert_eq!(s[0].program.shared(), s[1].program.shared());
    for motions in [&k[0].rigid, &s[0].rigid] {
        assert_eq!(motions.iter().map(|m| m.count).collect::<Vec<_>>(), [1]);
    }
}

/// A22: a strip of width w between rough platens at a distance h, plane strain, w/h = 1: 2k. The
/// uniform pressure 2k is a stress field that proves it as a lower bound.
#[test]
fn strip_between_platens() {
    let n = 4;
    let top = 1.0 + 1.0 / n as f64;
    let shape = Block {
        cells: [n, 1, n + 1],
        min: [0.0; 3],
        max: [1.0, 1.0 / n as f64, top],
        jitter: 0.2,
        seed: 3,
    };
    let mesh = shape.mesh(
        &["A", "B"],
        |c| usize::from(c[2] > 1.0),
        |d, x| d == 2 && (x - 1.0).abs() < 1e-9,
    );
    let held = "- {face: X0, fix: [x]}\n- {face: Y0, fix: [y]}\n- {face: Y1, fix: [y]}\n- {face: \
                Z0, fix: [z]}\n";
    let m = model(
        &format!(
            "bodies: {{A: s, B: r}}\nsupports:\n{held}loads:\n- {{face: Z1, traction: [0, 0, \
             -1]}}\n"
        ),
        mesh,
    );
    let [low, up] = factors("A22", &m);
    let exact = 2.0 * K;
    assert!(
        (low / exact - 1.0).abs() < 2e-4 && (exact..1.06 * exact).contains(&up),
        "[{low}, {up}]"
    );
}

/// A21: a rough rigid punch of half-width 1 on half of a block of 4 × 2, plane strain: (2 + π) k.
///
/// ```text
///      ↓
///    [▓▓]         B, rigid
///   +----+------------+
///   |                 |  A, deep and wide enough for Prandtl's mechanism
///   +-----------------+
/// ```
#[test]
fn punch() {
    let shape = Block {
        cells: [16, 1, 9],
        min: [0.0, 0.0, -2.0],
        max: [4.0, 0.25, 0.25],
        jitter: 0.15,
        seed: 5,
    };
    let body = |c: [f64; 3]| {
        if c[2] < 0.0 {
            0
        } else if c[0] < 1.0 {
            1
        } else {
            2
        }
    };
    let flat = |d: usize, x: f64| (d == 2 && x.abs() < 1e-9) || (d == 0 && (x - 1.0).abs() < 1e-9);
    let mesh = hollow(shape.mesh(&["A", "B", "VOID"], body, flat));
    let held = "- {face: X0, fix: [x]}\n- {face: Y0, fix: [y]}\n- {face: Y1, fix: [y]}\n- {face: \
                Z0, fix: [x, z]}\n- {face: X1, fix: [x]}\n";
    let m = model(
        &format!(
            "bodies: {{A: s, B: r}}\nsupports:\n{held}loads:\n- {{face: Z1, traction: [0, 0, \
             -1]}}\n"
        ),
        mesh,
    );
    let exact = (2.0 + std::f64::consts::PI) * K;
    let [low, up] = factors("A21", &m);
    assert!(low <= exact && up >= exact && up / low < 1.35, "[{low}, {up}] against {exact}");
}

/// A dead load presses a block on another one, and a live load pushes it. Shear on the sides keeps
/// the stress uniform (B5): T = μ N.
fn pushed(lower: &str, upper: &str) -> AnalysisModel {
    let shape = Block {
        cells: [4, 2, 3],
        min: [0.0, 0.0, -5.0],
        max: [20.0, 8.0, 10.0],
        jitter: 0.2,
        seed: 7,
    };
    let mesh =
        shape.mesh(&["A", "B"], |c| usize::from(c[2] > 0.0), |d, x| d == 2 && x.abs() < 1e-9);
    model(
        &format!(
            "bodies: {{A: {lower}, B: {upper}}}\ninterfaces:\n- {{between: [A, B], law: contact, \
             mu: 0.3, gap: 0.1, friction: associated}}\nsupports:\n- {{face: Z0, fix: [x, y, \
             z]}}\ndead:\n- {{face: Z1, traction: [0, 0, -100]}}\nloads:\n- {{face: Z1, traction: \
             [10, 0, 0]}}\n- {{face: X1, traction: [0, 0, 10]}}\n- {{face: X0, traction: [0, 0, \
             -10]}}\n"
        ),
        mesh,
    )
}

/// B5 in limit analysis, T = μ N: a rigid block on a base that yields, a block that yields on a
/// rigid base, and two rigid blocks.
#[test]
fn pushed_block() {
    for (lower, upper) in [("s", "r"), ("r", "s"), ("r", "r")] {
        let name = format!("B5, {lower} {upper}");
        let [low, up] = sharp_factors(&name, &pushed(lower, upper)).map(|x| x * FY);
        assert!(
            (low / 3.0 - 1.0).abs() < 1e-5 && (up / 3.0 - 1.0).abs() < 1e-5,
            "{name}: [{low}, {up}]"
        );
        assert!(low <= 3.0 * (1.0 + 1e-9) && up >= 3.0 * (1.0 - 1e-9), "{name}: [{low}, {up}]");
    }
}

/// B9: a member that yields at N_b presses two rigid plates together. One of them is pulled along
/// the joint, in its plane. Associated slip opens the joint, so the member must yield: T = μ N_b.
/// The model has no preload, and a preload would not matter.
///
/// ```text
///  +-----------------+
///  |▓▓▓▓▓▓▓▓▓▓▓▓▓▓▓▓▓|   arm of the lower plate over the upper one
///  |▓|     +--+            the member: frictionless ends, N_b = f_y A
///  |▓|  +--------+         upper plate, pulled out of the picture
///  |▓▓▓▓▓▓▓▓▓▓▓▓▓▓▓▓▓|   lower plate
/// ```
#[test]
fn lapped_plates() {
    let shape =
        Block { cells: [5, 3, 4], min: [0.0; 3], max: [5.0, 3.0, 4.0], jitter: 0.0, seed: 1 };
    let body = |c: [f64; 3]| match (c[0] as usize, c[1] as usize, c[2] as usize) {
        (0, _, _) | (_, _, 0 | 3) => 0,
        (2.., _, 1) => 1,
        (3, 1, 2) => 2,
        _ => 3,
    };
    let mut mesh = hollow(shape.mesh(&["LOWER", "UPPER", "MEMBER", "VOID"], body, |_, _| true));
    let end = triangles_where(&mesh, |x| x[1] == 3.0 && (1.0..=2.0).contains(&x[2]) && x[0] >= 2.0);
    mesh.faces.push(NamedFaces { name: "END".into(), triangles: end });
    // ∫ (20 − 12 z) over z from 1 to 2 and a width of 3: 6 N; ∫ (20 − 12 z) z = 2 = 2 · 1, so the
    // resultant lies in the plane of the joint
    let m = model(
        "bodies: {LOWER: r, UPPER: r, MEMBER: s}\ninterfaces:\n- {between: [LOWER, UPPER], law: \
         contact, mu: 0.3, friction: associated}\n- {between: [LOWER, MEMBER], law: contact, mu: \
         0}\n- {between: [UPPER, MEMBER], law: contact, mu: 0}\nsupports:\n- {face: Z0, fix: [x, \
         y, z]}\nloads:\n- {face: END, linear: {traction0: [0, 20, 0], gradient: [[0, 0, 0], [0, \
         0, -12], [0, 0, 0]]}}\n",
        mesh,
    );
    let exact = 0.3 * FY / 6.0;
    let [low, up] = sharp_factors("B9", &m).map(|x| x * FY);
    assert!(
        (low / exact - 1.0).abs() < 1e-5 && (up / exact - 1.0).abs() < 1e-5,
        "[{low}, {up}] against {exact}"
    );
}

/// A bar is pressed by a rigid head that carries a rigid face. Force and free motions of the face
/// are those of the head.
#[test]
fn rigid_face_on_a_rigid_body() {
    let shape =
        Block { cells: [4, 2, 2], min: [0.0; 3], max: [40.0, 10.0, 12.0], jitter: 0.2, seed: 2 };
    let mesh = shape.mesh(
        &["A", "B"],
        |c| usize::from(c[0] > 30.0),
        |d, x| d == 0 && (x - 30.0).abs() < 1e-9,
    );
    let yaml = "bodies: {A: s, B: r}\ninterfaces:\n- {between: [A, B], law: contact, mu: \
                0}\nsupports:\n- {face: X0, fix: [x]}\n- {face: Y0, fix: [y]}\n- {face: Z0, fix: \
                [z]}\nrigid:\n- {face: X1, components: [x, y, z], free: [ux], at: [40, 5, 6], \
                force: [-12000, 0, 0]}\n";
    let [low, up] = sharp_factors("head", &model(yaml, mesh)).map(|x| x * FY);
    let exact = FY / 100.0;
    assert!(
        (low / exact - 1.0).abs() < 1e-6 && (up / exact - 1.0).abs() < 1e-6,
        "[{low}, {up}] against {exact}"
    );
}

/// A rigid body that its supports hold completely also holds what is tied to it. A rigid body that
/// alone carries the load has no limit load.
#[test]
fn held_rigid_bodies() {
    let shape =
        Block { cells: [3, 2, 2], min: [0.0; 3], max: [30.0, 10.0, 12.0], jitter: 0.2, seed: 2 };
    let mesh = || {
        shape.mesh(
            &["A", "B"],
            |c| usize::from(c[0] < 10.0),
            |d, x| d == 0 && (x - 10.0).abs() < 1e-9,
        )
    };
    let clamped =
        "supports:\n- {face: X0, fix: [x, y, z]}\nloads:\n- {face: X1, traction: [0, 0, 1]}\n";
    let at_rest = "rigid:\n- {face: CUT, components: [x, y, z], free: [], at: [10, 0, \
                   0]}\nloads:\n- {face: X1, traction: [0, 0, 1]}\n";
    let a = factors("clamp body", &model(&format!("bodies: {{A: s, B: r}}\n{clamped}"), mesh()));
    // the same bar at rest in the plane x = 10: a support would let it slip there
    let mut cut = mesh();
    let plane = triangles_where(&cut, |x| (x[0] - 10.0).abs() < 1e-9);
    cut.faces.push(NamedFaces { name: "CUT".into(), triangles: plane });
    let cut = without(cut, 1);
    let b = factors("clamped", &model(&format!("bodies: {{A: s}}\n{at_rest}"), cut));
    assert!((a[0] / b[0] - 1.0).abs() < 1e-3 && (a[1] / b[1] - 1.0).abs() < 1e-3, "{a:?} {b:?}");
    // pulled only at the held rigid end
    let pulled =
        "supports:\n- {face: X0, fix: [x, y, z]}\nloads:\n- {face: SIDE, traction: [0, 0, 1]}\n";
    let mut mesh = mesh();
    let side = triangles_where(&mesh, |x| x[2] == 12.0 && x[0] <= 10.0 + 1e-9);
    mesh.faces.push(NamedFaces { name: "SIDE".into(), triangles: side });
    let m = model(&format!("bodies: {{A: s, B: r}}\n{pulled}"), mesh);
    for refused in [Kinematic::limit(&m, Flow::Split).err(), Static::limit(&m).err()] {
        assert_eq!(refused, Some(ModelError::LiveLoadsHeld));
    }
}

/// Models that a rigid body cannot make valid are refused, and the message names the reason.
#[test]
fn wrong_rigid_bodies_are_refused() {
    let good = "materials: {s: {E: 210000, nu: 0.3, fy: 235}, r: {E: 210000, nu: 0.3}}\nbodies: \
                {A: s, B: r}\ninterfaces: []\nsupports:\n- {face: X0, fix: [x, y, z]}\nloads:\n- \
                {face: X1, traction: [0, 0, 1]}\n";
    let contact = "[{between: [A, B], law: contact, mu: 0}]";
    let rows: [(&str, &str, &str); 12] = [
        ("A: s", "A: r", "no body has a yield strength"),
        ("A: s", "A: t", "material `t`, which is not defined"),
        (", fy: 235", ", fy: 0", "`fy` of material `s` is 0"),
        ("r: {E: 210000, nu: 0.3}", "r: {nu: 0.3}", "`E`"),
        ("r: {E: 210000, nu: 0.3}", "r: {E: 210000, nu: 0.3, rigid: true}", "unknown key `rigid`"),
        ("B: r", "C: r", "no physical volume `C`"),
        ("loads:", "dead:", "no load carries the load factor"),
        (
            "face: X1, traction: [0, 0, 1]",
            "body: B, force: [0, 0, 1]",
            "force in the body `B` carries the load factor",
        ),
        ("face: X1, traction", "face: X1, force", "needs exactly one of `traction`"),
        ("interfaces: []", &format!("interfaces: {contact}"), "part B can move"),
        ("fix: [x, y, z]", "fix: [x, y]", "can move along z"),
        (
            "loads:",
            "rigid: [{face: X0, components: [x], free: [ux]}]\nloads:",
            "is rigid and also fixed",
        ),
    ];
    let shape =
        Block { cells: [2, 1, 1], min: [0.0; 3], max: [20.0, 10.0, 10.0], jitter: 0.0, seed: 1 };
    for (old, new, words) in rows {
        assert_eq!(good.matches(old).count(), 1, "{old}");
        let mesh = shape.mesh(&["A", "B"], |c| usize::from(c[0] > 10.0), |_, _| true);
        let d = solved::resolve_as("limit", &good.replace(old, new), mesh).expect_err(new);
        assert!(d.iter().any(|d| d.message.contains(words)), "{new}: {d:?}");
    }
    let mesh = shape.mesh(&["A", "B"], |c| usize::from(c[0] > 10.0), |_, _| true);
    let sound = solved::resolve_as("limit", good, mesh).unwrap();
    let notes: Vec<String> = sound.notes.iter().map(ToString::to_string).collect();
    assert_eq!(notes, ["limit analysis: the body without `fy` is rigid: B"]);
}
