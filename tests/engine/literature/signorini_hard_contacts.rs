//! Unilateral contact with gaps, extreme loads and extreme materials: the result is a strict
//! certified bracket or a clear status.
//!
//! ```text
//!   /////              |  F                [ soft ]  p
//!   [   ] | b          v                   [......]  μ
//!   [   ] v          [   ]  loose          [ hard ]
//!   ~~~~~ gap g      ~~~~~ gap g           ////////
//! ```
//! Source: A. Signorini, Questioni di elasticità non linearizzata e semilinearizzata (1959).
//! Columns with ν = 0 are one-dimensional: hanging column, stress b τ − r at height τ with r = bL/2
//! − gE/L (0 if the gap stays open), energy −A (∫ (bτ − r)² / 2E dτ + r g); loose block, −F g − F²L
//! / (2EA).
//!
//! Tolerance of the closed forms 1e-6 relative: both spaces contain the exact fields, and the conic
//! solver stops at a relative gap of 1e-8. The other cases have no closed form: the bracket must be
//! strict, and Σ contributions = gap.

use crate::common::Block;
use crate::common::solved::{Solved, resolve, solve};
use bracket::mesh::TetMesh;

const E: f64 = 210_000.0;
const L: f64 = 60.0;
const A: f64 = 10.0 * 12.0;

fn column(seed: u64) -> TetMesh {
    Block { cells: [2, 2, 4], min: [0.0; 3], max: [10.0, 12.0, L], jitter: 0.2, seed }.mesh(
        &["B"],
        |_| 0,
        |_, _| false,
    )
}

fn hanging(b: f64, gap: f64, seed: u64) -> (Solved, f64) {
    let yaml = format!(
        "materials: {{s: {{E: 210000, nu: 0}}}}\nbodies: {{B: s}}\nsupports:\n- {{face: Z1, fix: \
         [x, y, z]}}\n- {{face: Z0, law: contact, mu: 0, gap: {gap:?}}}\nloads:\n- {{body: B, \
         force: [0, 0, {:?}]}}\n",
        -b
    );
    let r = (0.5 * b * L - gap * E / L).max(0.0);
    let squares = b * b * L.powi(3) / 3.0 - b * r * L * L + r * r * L;
    (solve(&yaml, column(seed)), -A * (squares / (2.0 * E) + r * gap))
}

#[test]
fn a_gap_is_closed_by_the_load() {
    for seed in [1, 7, 42] {
        let (s, exact) = hanging(4.0 * E * 0.01 / (L * L), 0.01, seed);
        s.exact("gap 0.01 closed", exact, 1e-6);
    }
}

#[test]
fn a_gap_of_a_millionth_and_one_of_five_millimetres() {
    let (s, exact) = hanging(2.0, 1e-6, 1);
    s.exact("gap 1e-6", exact, 1e-6);
    let (s, exact) = hanging(2.0, 5.0, 1);
    s.exact("gap 5 stays open", exact, 1e-6);
    assert!(s.pass.upper.as_ref().unwrap().certificate().smallest_margin.unwrap() > 4.9);
}

#[test]
fn a_load_that_just_closes_the_gap() {
    for seed in [1, 7, 42] {
        let (s, exact) = hanging(2.0 * E * 0.01 / (L * L), 0.01, seed);
        s.exact("gap 0.01 just closed", exact, 1e-6);
    }
}

#[test]
fn a_loose_block_falls_through_its_gap_and_is_pressed() {
    let p = 50.0;
    for seed in [1, 7, 42] {
        for (gap, mu) in [(0.01, 0.0), (0.01, 0.3), (5.0, 0.3), (1e-6, 0.3)] {
            let guide =
                if mu > 0.0 { "" } else { "- {face: X0, fix: [x]}\n- {face: Y0, fix: [y]}\n" };
            let law = if mu > 0.0 { ", friction: associated" } else { "" };
            let yaml = format!(
                "materials: {{s: {{E: 210000, nu: 0}}}}\nbodies: {{B: s}}\nsupports:\n{guide}- \
                 {{face: Z0, law: contact, mu: {mu:?}, gap: {gap:?}{law}}}\nloads:\n- {{face: Z1, \
                 pressure: {p:?}}}\n"
            );
            let exact = -p * A * gap - p * p * A * L / (2.0 * E);
            solve(&yaml, column(seed)).exact(&format!("loose, gap {gap}, μ {mu}"), exact, 1e-6);
        }
    }
}

#[test]
fn a_quadratic_gap_closes_from_its_middle() {
    for seed in [1, 7, 42] {
        let mesh = Block {
            cells: [4, 4, 3],
            min: [-5.0, -5.0, 0.0],
            max: [5.0, 5.0, 6.0],
            jitter: 0.2,
            seed,
        };
        let yaml = "materials: {s: {E: 210000, nu: 0.3}}\nbodies: {B: s}\nsupports:\n- {face: X0, \
                    fix: [x]}\n- {face: Y0, fix: [y]}\n- {face: Z0, law: contact, mu: 0.3, \
                    friction: associated, gap: {quadratic: [0.001, 0, 0, 0, 0.0002, 0.0001, 0, 0, \
                    0, 0]}}\nloads:\n- {face: Z1, pressure: 60}\n";
        let s = solve(yaml, mesh.mesh(&["B"], |_| 0, |_, _| false));
        s.strict("quadratic gap");
        let c = s.pass.upper.as_ref().unwrap().certificate();
        println!("largest gap left {:?}, peak pressure {:?}", c.largest_gap, c.peak_pressure);
        // the corner has an initial gap of 0.0085 mm; the load cannot close all of it
        assert!(c.largest_gap.unwrap() > 1e-4 && c.peak_pressure.unwrap() > 60.0);
    }
}

#[test]
fn a_part_without_support_is_named() {
    let loose = "materials: {s: {E: 210000, nu: 0.3}}\nbodies: {B: s}\nloads:\n- {face: X1, \
                 traction: [1, 0, 0]}\n";
    let message = format!("{:?}", resolve(loose, column(1)).unwrap_err());
    assert!(message.contains("model/loose-part") && message.contains("part B"), "{message}");
    let slides = "materials: {s: {E: 210000, nu: 0.3}}\nbodies: {B: s}\nsupports:\n- {face: Z0, \
                  law: contact, mu: 0}\ndead:\n- {face: Z1, pressure: 5}\nloads:\n- {face: X1, \
                  traction: [1, 0, 0]}\n";
    let message = format!("{:?}", resolve(slides, column(1)).unwrap_err());
    assert!(message.contains("model/loose-part") && message.contains("part B"), "{message}");
    // a lifted block: contact carries no tension
    let lifted = "materials: {s: {E: 210000, nu: 0.3}}\nbodies: {B: s}\nsupports:\n- {face: Z0, \
                  law: contact, mu: 0.3, friction: associated}\nloads:\n- {face: Z1, pressure: \
                  -5}\n";
    solve(lifted, column(1)).no_equilibrium("lifted", "part B moves along +z");
}

const PUSHED: [usize; 3] = [4, 2, 1];

/// A block on the ground under pressure and a push of `ratio` μN. All loads are multiplied by
/// `scale`.
fn pushed(material: &str, mu: f64, ratio: f64, scale: f64) -> Solved {
    let mesh = Block::new(PUSHED, [10.0, 4.0, 2.0]).jittered(3).mesh(&["B"], |_| 0, |_, _| false);
    let t = ratio * mu * 100.0 * 40.0 / 8.0;
    let yaml = format!(
        "materials: {{s: {material}}}\nbodies: {{B: s}}\nsupports:\n- {{face: Z0, law: contact, \
         mu: {mu:?}, friction: associated}}\nloads:\n- {{face: Z1, pressure: {:?}}}\n- {{face: \
         X1, traction: [{:?}, 0, 0]}}\n",
        100.0 * scale,
        -t * scale
    );
    solve(&yaml, mesh)
}

#[test]
fn no_load_no_energy() {
    let s = pushed("{E: 210000, nu: 0.3}", 0.3, 0.5, 0.0);
    let reference = pushed("{E: 210000, nu: 0.3}", 0.3, 0.5, 1.0).strict("reference")[0].abs();
    for e in s.strict("zero load, contact") {
        assert!(e.abs() <= 1e-12 * reference, "{e:e}");
    }
    let held = "materials: {s: {E: 210000, nu: 0.3}}\nbodies: {B: s}\nsupports:\n- {face: Z1, \
                fix: [x, y, z]}\n";
    assert_eq!(solve(held, column(1)).strict("zero load, held"), [0.0, 0.0]);
    let gap = "materials: {s: {E: 210000, nu: 0.3}}\nbodies: {B: s}\nsupports:\n- {face: Z1, fix: \
               [x, y, z]}\n- {face: Z0, law: contact, mu: 0.3, friction: associated, gap: 0.01}\n";
    for e in solve(gap, column(1)).strict("zero load, open gap") {
        assert!(e.abs() <= 1e-12 * reference, "{e:e}");
    }
}

#[test]
fn energy_is_proportional_to_the_square_of_the_load() {
    let one = pushed("{E: 210000, nu: 0.3}", 0.3, 0.5, 1.0).strict("load × 1");
    for scale in [1e-9, 1e9] {
        let other =
            pushed("{E: 210000, nu: 0.3}", 0.3, 0.5, scale).strict(&format!("load × {scale:e}"));
        for (a, b) in one.iter().zip(other) {
            let ratio = b / (a * scale * scale);
            println!("scale {scale:e}: ratio − 1 = {:.2e}", ratio - 1.0);
            assert!((ratio - 1.0).abs() < 1e-6, "{ratio}");
        }
    }
}

#[test]
fn nearly_incompressible() {
    pushed("{E: 210000, nu: 0.4999}", 0.3, 0.5, 1.0).strict("ν 0.4999 in contact");
    let mesh =
        Block::new([4, 3, 3], [10.0, 8.0, 6.0]).jittered(5).mesh(&["B"], |_| 0, |_, _| false);
    let yaml = "materials: {s: {E: 210000, nu: 0.4999}}\nbodies: {B: s}\nsupports:\n- {face: X0, \
                fix: [x, y, z]}\nloads:\n- {face: X1, traction: [0, 0, -10]}\n";
    solve(yaml, mesh).strict("ν 0.4999 cantilever");
}

#[test]
fn little_and_much_friction() {
    for mu in [1e-3, 2.0] {
        pushed("{E: 210000, nu: 0.3}", mu, 0.5, 1.0).strict(&format!("μ {mu}"));
    }
}

#[test]
fn a_stiffness_contrast_of_a_million() {
    for law in ["law: tied", "law: contact, mu: 0.3, friction: associated", "law: contact, mu: 0"] {
        for (lower, upper) in [(210_000.0, 0.21), (0.21, 210_000.0)] {
            let mesh = Block::new([3, 3, 4], [10.0, 10.0, 8.0]).jittered(11).mesh(
                &["LOWER", "UPPER"],
                |c| usize::from(c[2] > 4.0),
                |d, x| d == 2 && x == 4.0,
            );
            let yaml = format!(
                "materials: {{l: {{E: {lower:?}, nu: 0.3}}, u: {{E: {upper:?}, nu: \
                 0.3}}}}\nbodies: {{LOWER: l, UPPER: u}}\ninterfaces:\n- {{between: [LOWER, \
                 UPPER], {law}}}\nsupports:\n- {{face: Z0, fix: [x, y, z]}}\n- {{face: X0, fix: \
                 [x]}}\n- {{face: Y0, fix: [y]}}\nloads:\n- {{face: Z1, pressure: 0.01}}\n"
            );
            solve(&yaml, mesh).strict(&format!("{law}, E {lower} under {upper}"));
        }
    }
}

#[test]
fn a_loose_part_that_nothing_loads_carries_nothing() {
    // B is pressed on the ground beside C, which carries no load
    for mu in ["0", "0.3, friction: associated"] {
        let b = Block::new([2, 2, 2], [10.0; 3]).jittered(1).mesh(&["B"], |_| 0, |_, _| false);
        let c = Block {
            cells: [2, 2, 2],
            min: [20.0, 0.0, 0.0],
            max: [30.0, 10.0, 10.0],
            jitter: 0.2,
            seed: 2,
        };
        let c = crate::common::renamed(c.mesh(&["C"], |_| 0, |_, _| false), "Z1", "TOP_C");
        let guide = if mu == "0" { "- {face: X0, fix: [x]}\n- {face: Y0, fix: [y]}\n" } else { "" };
        let yaml = format!(
            "materials: {{s: {{E: 210000, nu: 0.3}}}}\nbodies: {{B: s, C: \
             s}}\nsupports:\n{guide}- {{face: Z0, law: contact, mu: {mu}}}\nloads:\n- {{face: Z1, \
             pressure: 60}}\n"
        );
        solve(&yaml, crate::common::beside(b, c)).strict(&format!("unloaded part beside, μ {mu}"));
    }
}

/// A plate with a square hole and a pin that fills the hole on the mesh. The face PULL is on the
/// side of the plate, the faces PIN0 and PIN1 are on the ends of the pin.
fn pin_in_plate(with_pin: bool) -> TetMesh {
    let block = Block {
        cells: [4, 4, 2],
        min: [-10.0, -10.0, 0.0],
        max: [10.0, 10.0, 6.0],
        jitter: 0.2,
        seed: 5,
    };
    let pin = |x: [f64; 3]| x[0].abs() < 5.0 && x[1].abs() < 5.0;
    let mut mesh =
        block.mesh(&["PLATE", "PIN"], |x| usize::from(pin(x)), |d, x| d < 2 && x.abs() == 5.0);
    let ends = |z: f64| {
        let on = |x: [f64; 3]| x[2] == z && x[0].abs() <= 5.0 && x[1].abs() <= 5.0;
        crate::common::triangles_where(&mesh, on)
    };
    let (low, high) = (ends(0.0), ends(6.0));
    mesh.faces.retain(|f| !f.name.starts_with('Z'));
    if with_pin {
        mesh.faces.push(bracket::mesh::NamedFaces { name: "PIN0".into(), triangles: low });
        mesh.faces.push(bracket::mesh::NamedFaces { name: "PIN1".into(), triangles: high });
        return mesh;
    }
    // removes the pin and the nodes inside it
    let kept: Vec<[u32; 4]> =
        mesh.tets.iter().zip(&mesh.tet_body).filter(|(_, b)| **b == 0).map(|(t, _)| *t).collect();
    let mut index = vec![None; mesh.nodes.len()];
    let mut nodes = Vec::new();
    for n in kept.iter().flatten().map(|n| *n as usize) {
        index[n].get_or_insert_with(|| {
            nodes.push(mesh.nodes[n]);
            nodes.len() as u32 - 1
        });
    }
    let new = |n: u32| index[n as usize].unwrap();
    mesh.tets = kept.into_iter().map(|t| t.map(new)).collect();
    mesh.tet_body = vec![0; mesh.tets.len()];
    mesh.bodies.truncate(1);
    mesh.nodes = nodes;
    mesh.faces.iter_mut().for_each(|f| f.triangles.iter_mut().for_each(|t| *t = t.map(new)));
    mesh
}

#[test]
fn a_bolt_loose_in_its_hole() {
    let pulled = "loads:\n- {face: X1, traction: [50, 10, 0]}\n";
    let plate = format!(
        "materials: {{s: {{E: 210000, nu: 0.3}}}}\nbodies: {{PLATE: s}}\nsupports:\n- {{face: X0, \
         fix: [x, y, z]}}\n{pulled}"
    );
    let alone = solve(&plate, pin_in_plate(false)).strict("plate without bolt");
    for mu in ["0", "0.3, friction: associated"] {
        let bolted = |gap: f64, supports: &str| {
            format!(
                "materials: {{s: {{E: 210000, nu: 0.3}}}}\nbodies: {{PLATE: s, PIN: \
                 s}}\ninterfaces:\n- {{between: [PLATE, PIN], law: contact, mu: {mu}, gap: \
                 {gap:?}}}\nsupports:\n{supports}{pulled}"
            )
        };
        // the hole changes its shape by less than the clearance: the bolt carries nothing and its
        // position is not determined
        let loose = bolted(0.5, "- {face: X0, fix: [x, y, z]}\n");
        let loose = solve(&loose, pin_in_plate(true)).strict(&format!("loose bolt, μ {mu}"));
        for (a, b) in alone.iter().zip(loose) {
            assert!((a - b).abs() <= 1e-6 * a.abs(), "{alone:?} against {loose:?}");
        }
        // the plate hangs on the bolt: the contact closes after the clearance, along which the pull
        // does work
        let work = 50.0 * 20.0 * 6.0 * 0.5;
        let bears = bolted(
            0.5,
            "- {face: PIN0, fix: [x, y, z]}\n- {face: PIN1, fix: [x, y, z]}\n- {face: Y0, fix: \
             [y]}\n",
        );
        let bears = bears.replace("50, 10, 0", "50, 0, 0");
        let [lower, upper] =
            solve(&bears, pin_in_plate(true)).strict(&format!("bearing bolt, μ {mu}"));
        assert!(upper < -work && lower > -1.1 * work, "[{lower}, {upper}] against {work}");
    }
}

#[test]
fn the_random_points_find_faulty_fields() {
    let s = pushed("{E: 210000, nu: 0.3}", 0.3, 0.5, 1.0);
    let (stress, u) = (s.pass.stress.clone().unwrap(), s.pass.displacement.clone().unwrap());
    let refused = |stress: &bracket::certify::fields::StressField,
                   u: &bracket::certify::fields::DisplacementField| {
        std::panic::catch_unwind(|| crate::common::points::check("faulty", &s.model, stress, u))
            .is_err()
    };
    assert!(!refused(&stress, &u));
    // one stress value changed by a millionth of the largest
    let mut off = stress.clone();
    off.points[10][2][1][0] += 1e-4;
    assert!(refused(&off, &u));
    // a uniform change in equilibrium that causes tension at the contact
    let mut pulled = stress.clone();
    pulled.points.iter_mut().flatten().flatten().for_each(|p| p[2] += 1e3);
    assert!(refused(&pulled, &u));
    // the whole block a nanometre below the ground
    let mut sunk = u.clone();
    sunk.u.iter_mut().for_each(|x| x[2] -= 1e-6);
    assert!(refused(&stress, &sunk));
}
