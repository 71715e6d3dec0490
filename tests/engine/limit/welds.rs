//! Welds of finite strength in limit analysis: joints whose limit load is the strength of the weld
//! or of the welded bodies.

use crate::common::limit::{run, sharp_factors};
use crate::common::yielding::{FY, model};
use crate::common::{Block, triangles_where};
use bracket::certify::StressField;
use bracket::certify::limit_certificate::certify_upper;
use bracket::certify::unlimited::certify_unlimited;
use bracket::mesh::{NamedFaces, TetMesh};
use bracket::model::AnalysisModel;

const SEEDS: [u64; 3] = [1, 5, 9];

/// Two cubes of 10 mm joined at x = 10.
fn cubes(seed: u64) -> TetMesh {
    let shape =
        Block { cells: [4, 2, 2], min: [0.0; 3], max: [20.0, 10.0, 10.0], jitter: 0.2, seed };
    shape.mesh(&["A", "B"], |c| usize::from(c[0] > 10.0), |d, x| d == 0 && (x - 10.0).abs() < 1e-9)
}

fn welded(mesh: TetMesh, weld: &str, rest: &str) -> AnalysisModel {
    let law = format!("interfaces:\n- {{between: [A, B], law: weld, {weld}}}\n");
    model(&format!("bodies: {{A: s, B: s}}\n{law}{rest}"), mesh)
}

fn exact(name: &str, want: f64, at: impl Fn(u64) -> AnalysisModel) {
    for seed in SEEDS {
        let [low, up] = sharp_factors(&format!("{name}, seed {seed}"), &at(seed)).map(|x| x * FY);
        assert!(
            (low / want - 1.0).abs() < 1e-6 && (up / want - 1.0).abs() < 1e-6,
            "{name}: [{low}, {up}] for {want}"
        );
        assert!(
            low <= want * (1.0 + 1e-9) && up >= want * (1.0 - 1e-9),
            "{name}: [{low}, {up}] for {want}"
        );
    }
}

/// In tension the weak weld yields at its strength, `2 · throat · strength / thickness`, below
/// yield of the cubes. With the stronger weld the cubes yield.
#[test]
fn cubes_in_tension() {
    let pull = "supports:\n- {face: X0, fix: [x]}\n- {face: Y0, fix: [y]}\n- {face: Z0, fix: \
                [z]}\nloads:\n- {face: X1, traction: [1, 0, 0]}\n";
    // 2 · 3 · 200/10 = 120 MPa
    exact("weak in tension", 120.0, |seed| {
        welded(cubes(seed), "throat: 3, thickness: 10, strength: 200", pull)
    });
    exact("strong in tension", FY, |seed| welded(cubes(seed), "strength_traction: 300", pull));
}

/// The same in pure shear: the limit is the strength of the weld below k = f_y/√3, or k.
#[test]
fn cubes_in_shear() {
    let faces =
        [("X0", "[0, -1, 0]"), ("X1", "[0, 1, 0]"), ("Y0", "[-1, 0, 0]"), ("Y1", "[1, 0, 0]")];
    let loads: String =
        faces.iter().map(|(f, t)| format!("- {{face: {f}, traction: {t}}}\n")).collect();
    let rest =
        format!("supports:\n- {{face: Z0, fix: [z]}}\n- {{face: Z1, fix: [z]}}\nloads:\n{loads}");
    exact("weak in shear", 100.0, |seed| welded(cubes(seed), "strength_traction: 100", &rest));
    exact("strong in shear", FY / 3.0f64.sqrt(), |seed| {
        welded(cubes(seed), "strength_traction: 250", &rest)
    });
}

/// Under a dead tension of 60 MPa a weld of 100 MPa carries a further 80 MPa of shear.
#[test]
fn tension_and_shear() {
    let faces =
        [("X0", "[0, -1, 0]"), ("X1", "[0, 1, 0]"), ("Y0", "[-1, 0, 0]"), ("Y1", "[1, 0, 0]")];
    let loads: String =
        faces.iter().map(|(f, t)| format!("- {{face: {f}, traction: {t}}}\n")).collect();
    let rest = format!(
        "supports:\n- {{face: Z0, fix: [z]}}\n- {{face: Z1, fix: [z]}}\nloads:\n{loads}dead:\n- \
         {{face: X0, traction: [-60, 0, 0]}}\n- {{face: X1, traction: [60, 0, 0]}}\n"
    );
    let seed = 1;
    let m = welded(cubes(seed), "strength_traction: 100", &rest);
    let [low, up] = sharp_factors("tension and shear", &m).map(|x| x * FY);
    assert!((low / 80.0 - 1.0).abs() < 1e-5 && (up / 80.0 - 1.0).abs() < 1e-5, "[{low}, {up}]");
    assert!(low <= 80.0 * (1.0 + 1e-9) && up >= 80.0 * (1.0 - 1e-9), "[{low}, {up}]");
}

/// A pair of fillets joins the web of a strip to a rigid plate. A throat a on either side of a web
/// of thickness t carries 2 a f per length. The web is pulled and pushed sideways at once, by less
/// than its strength: f² (2a/t)² = σ² + τ².
///
/// ```text
///     ↑→
///    |  |
///    |  |  web, thickness 8
///   ◣|  |◢
///  [▓▓▓▓▓▓] plate, rigid, clamped
/// ```
#[test]
fn pair_of_fillets() {
    let (t, a, f) = (8.0, 3.0, 100.0);
    let shape =
        Block { cells: [1, 3, 4], min: [0.0; 3], max: [t, 30.0, 40.0], jitter: 0.2, seed: 3 };
    let mesh = shape.mesh(
        &["A", "B"],
        |c| usize::from(c[2] < 10.0),
        |d, x| d == 2 && (x - 10.0).abs() < 1e-9,
    );
    // in the plane of the web σ and τ are uniform, so its edges carry shear too
    let mut mesh = mesh;
    for (name, y) in [("EDGE0", 0.0), ("EDGE1", 30.0)] {
        let triangles = triangles_where(&mesh, |x| x[1] == y && x[2] >= 10.0 - 1e-9);
        mesh.faces.push(NamedFaces { name: name.into(), triangles });
    }
    let m = model(
        &format!(
            "bodies: {{A: s, B: r}}\ninterfaces:\n- {{between: [A, B], law: weld, throat: {a:?}, \
             thickness: {t:?}, strength: {f:?}}}\nsupports:\n- {{face: Z0, fix: [x, y, \
             z]}}\nloads:\n- {{face: Z1, traction: [0, 3, 4]}}\n- {{face: EDGE0, traction: [0, 0, \
             -3]}}\n- {{face: EDGE1, traction: [0, 0, 3]}}\n"
        ),
        mesh,
    );
    let want = 2.0 * a * f / t / 5.0;
    let [low, up] = sharp_factors("fillets", &m).map(|x| x * FY);
    // the web is far below its strength: noise in its velocities dissipates more than the weld does
    assert!(
        (low / want - 1.0).abs() < 1e-6 && (up / want - 1.0).abs() < 1e-4,
        "[{low}, {up}] for {want}"
    );
    assert!(low <= want * (1.0 + 1e-9) && up >= want * (1.0 - 1e-9), "[{low}, {up}] for {want}");
}

/// All the work is done in the weld. Its traction equals its strength, and its velocity jump equals
/// that of the certificate.
#[test]
fn the_weld_dissipates() {
    let pull = "supports:\n- {face: X0, fix: [x]}\n- {face: Y0, fix: [y]}\n- {face: Z0, fix: \
                [z]}\nloads:\n- {face: X1, traction: [1, 0, 0]}\n";
    let m = welded(cubes(1), "strength_traction: 120", pull);
    let pass = run(&m);
    let upper = pass.upper.as_ref().unwrap().certificate();
    let share = upper.welds[0] / (upper.welds[0] + upper.dissipation.iter().sum::<f64>());
    assert!(share > 0.999, "{share} {upper:?}");
    let lower = pass.lower.as_ref().unwrap().certificate();
    let used = lower.weld.unwrap();
    assert!(used <= 1.0 && used > 0.999 && lower.utilisation < 0.6, "{lower:?}");
    // half of the strength gives half of the dissipation of the weld
    let mut weaker = m.clone();
    weaker.welds[0].strength *= 0.5;
    let half = certify_upper(&weaker, pass.velocity.as_ref().unwrap(), 1);
    assert!((half.welds[0] / upper.welds[0] - 0.5).abs() < 1e-14, "{half:?}");
}

/// A bracket welded at one edge is turned. The jump is linear over the weld, with tension on one
/// side and compression on the other. The plastic moment of the weld about its middle is S b h²/4
/// with width b and height h.
#[test]
fn turned_weld() {
    let (b, h, s) = (8.0, 12.0, 40.0);
    let bounds = [2, 4].map(|n| {
        let shape = Block {
            cells: [2, 2, n],
            min: [0.0, 0.0, -6.0],
            max: [20.0, b, 6.0],
            jitter: 0.2,
            seed: 4,
        };
        let mesh = shape.mesh(
            &["A", "B"],
            |c| usize::from(c[0] > 10.0),
            |d, x| (d == 0 && (x - 10.0).abs() < 1e-9) || (d == 2 && x.abs() < 1e-9),
        );
        let m = model(
            &format!(
                "bodies: {{A: r, B: r}}\ninterfaces:\n- {{between: [A, B], law: weld, \
                 strength_traction: {s:?}}}\nsupports:\n- {{face: X0, fix: [x, y, z]}}\nrigid:\n- \
                 {{face: X1, components: [x, y, z], free: [ux, ry], at: [10, 0, 0], moment: [0, \
                 {:?}, 0]}}\n",
                b * h * h / 4.0
            ),
            mesh,
        );
        let [low, up] = sharp_factors("turned", &m).map(|x| x * FY);
        assert!(low <= s * (1.0 + 1e-9) && up >= s * (1.0 - 1e-9), "[{low}, {up}] for {s}");
        up / low - 1.0
    });
    // the traction jumps at mid-height, which is a line of the mesh: both sides are exact up to the
    // tolerance of the solver
    assert!(bounds.iter().all(|gap| *gap < 1e-4), "{bounds:?}");
}

/// All-round pressure acts through the weld, so the load has a limit, and no pressure field proves
/// the contrary.
#[test]
fn pressure_through_a_weld_is_limited() {
    let faces = ["X0", "X1", "Y0", "Y1", "Z0", "Z1"];
    let loads: String = faces.iter().map(|f| format!("- {{face: {f}, pressure: 1}}\n")).collect();
    let m = welded(cubes(1), "strength_traction: 100", &format!("loads:\n{loads}"));
    let field = StressField {
        points: vec![[[[-1.0, -1.0, -1.0, 0.0, 0.0, 0.0]; 4]; 4]; m.mesh.tets.len()],
    };
    let certificate = certify_unlimited(&m, &field, None);
    assert!(certificate.traction_jump < 1e-12 && certificate.deviator == 0.0, "{certificate:?}");
    assert!(!certificate.is_strict() && certificate.weld.unwrap() > 0.5, "{certificate:?}");
    let pass = run(&m);
    assert!(pass.unlimited.is_none());
    let [low, up] = pass.bracket.map(|b| [b.lower().value(), b.upper().value()]).unwrap();
    assert!(
        low <= 100.0 * (1.0 + 1e-9) && (100.0 * (1.0 - 1e-9)..101.0).contains(&up),
        "[{low}, {up}]"
    );
}

/// Welded cubes on the ground are lifted together without any load. If one of them is held, the
/// weld holds both.
#[test]
fn what_a_weld_holds_is_no_mechanism() {
    let lifted = |support: &str| {
        let floor = "- {face: Z0, law: contact, mu: 0.3, friction: associated}\n";
        let rest =
            format!("supports:\n{floor}{support}loads:\n- {{face: Z1, traction: [0, 0, 1]}}\n");
        run(&welded(cubes(1), "strength_traction: 100", &rest))
    };
    let free = lifted("").free.expect("nothing holds them");
    assert!(
        free.certificate.rigid < 1e-12 && free.certificate.live_power > 0.0,
        "{:?}",
        free.certificate
    );
    let held = lifted("- {face: X1, fix: [x, y, z]}\n");
    assert!(held.free.is_none() && held.lower.unwrap().value() > 1.0);
}
