//! A stiff plate on elastic ground: the pressure is linear under it.
//!
//! ```text
//!          |← e →|
//!          .     ↓ N
//!   [▓▓▓▓▓▓▓▓▓▓▓▓▓▓▓▓▓]  E, ν = 0, thickness t
//!    ⌇⌇⌇⌇⌇⌇⌇⌇⌇⌇⌇⌇⌇⌇⌇⌇⌇   k
//! ```
//! Source: E. Winkler, Die Lehre von der Elasticität und Festigkeit (1867), § 195. With e ≤ L/6 the
//! pressure is N/(BL) (1 ± 6e/L). With ν = 0 the plate itself is a row of columns: it adds t/E to
//! 1/k, and both spaces contain the exact fields. The energy is −½ ∫ p² (1/k + t/E). Beyond L/6 the
//! pressed length is 3 (L/2 − e), the pressure is a triangle, and a plate that is rigid beside the
//! ground has −½ ∫ p²/k.

use crate::common::plastic::{plastic_model, run, strict_pass};
use crate::common::solved::{Solved, resolve, solve};
use crate::common::{Block, Random};
use bracket::certify::faces::contact_faces;
use bracket::certify::tractions::contact_tractions;

/// Length, width and thickness of the plate \[mm\].
const PLATE: [f64; 3] = [200.0, 100.0, 20.0];
/// Force on the plate \[N\].
const N: f64 = 90e3;

/// A plate of `n` cells along its length on ground of stiffness `k`, pressed at `e` from its middle
/// through its rigid top.
fn pressed(n: usize, modulus: f64, k: f64, e: f64) -> Solved {
    let [length, width, thick] = PLATE;
    let mesh = Block::new([n, 2, 1], PLATE).mesh(&["P"], |_| 0, |_, _| true);
    solve(
        &format!(
            "materials: {{s: {{E: {modulus:?}, nu: 0}}}}\nbodies: {{P: s}}\nsupports:\n- {{face: \
             Z0, law: contact, mu: 0, stiffness: {k:?}}}\nrigid:\n- {{face: Z1, components: [x, y, \
             z], free: [uz, rx, ry], at: [{:?}, {:?}, {thick:?}], force: [0, 0, {:?}]}}\n",
            0.5 * length + e,
            0.5 * width,
            -N
        ),
        mesh,
    )
}

/// The pressure of the stress field at every vertex of the contact, with the x of the vertex.
fn pressures(s: &Solved) -> Vec<[f64; 2]> {
    let stress = s.pass.stress.as_ref().unwrap();
    let faces = contact_faces(&s.model);
    let of_face = |f: &bracket::certify::faces::ContactFace<'_>| {
        let n = f.normal(&s.model).0;
        let p = contact_tractions(&s.model, stress, f, None);
        let x = f.nodes_a.map(|i| s.model.mesh.nodes[i as usize][0]);
        [0, 1, 2].map(|i| [x[i], (0..3).map(|d| p[i][d] * n[d]).sum()])
    };
    faces.iter().flat_map(of_face).collect()
}

/// Within the kern the pressure is N/(BL) (1 ± 6e/L) and the energy exact.
#[test]
fn within_the_kern() {
    let [length, width, thick] = PLATE;
    for (e, k) in [(0.0, 20.0), (20.0, 3.0), (33.0, 500.0)] {
        let s = pressed(4, 210e3, k, e);
        let mean = N / (length * width);
        let give = 1.0 / k + thick / 210e3;
        let exact = -0.5 * N * mean * give * (1.0 + 12.0 * (e / length).powi(2));
        s.exact(&format!("e = {e}"), exact, 1e-6);
        for [x, p] in pressures(&s) {
            let linear = mean * (1.0 + 12.0 * e * (x - 0.5 * length) / (length * length));
            assert!((p - linear).abs() <= 1e-3 * mean, "e = {e}: {p} against {linear} MPa at {x}");
        }
    }
}

/// Beyond the kern one side lifts off, and the rest is pressed by a triangle.
#[test]
fn beyond_the_kern() {
    let [length, width, _] = PLATE;
    let (e, k) = (60.0, 1.0);
    let pressed_length = 3.0 * (0.5 * length - e);
    let peak = 2.0 * N / (width * pressed_length);
    // −½ ∫ p² / k of a triangle
    let exact = -0.5 * width * pressed_length * peak * peak / (3.0 * k);
    // the edge of the pressed length is a line of the first mesh and inside the elements of the
    // second; the plate's own energy is 1e-5 of the ground's
    for (cells, within) in [(5, 1e-4), (8, 2e-3)] {
        pressed(cells, 2.1e6, k, e).exact(&format!("{cells} cells"), exact, within);
    }
}

/// Random blocks on elastic ground, with and without friction, a gap and a side load: brackets are
/// strict and agree with Clarabel.
#[test]
fn random_blocks() {
    let mut r = Random::new(20);
    for seed in 0..8 {
        let mut between = |a: f64, b: f64| a + (b - a) * r.unit();
        let size = [between(20.0, 60.0), between(20.0, 60.0), between(5.0, 30.0)];
        let k = 10f64.powf(between(0.0, 4.0));
        let law = match seed % 4 {
            0 => "mu: 0".to_string(),
            1 => format!("mu: 0, gap: {:?}", between(0.0, 0.01)),
            2 => format!("mu: {:?}, friction: associated", between(0.1, 0.6)),
            _ => format!("mu: {:?}", between(0.3, 0.6)),
        };
        let side = if seed % 4 < 2 { 0.0 } else { between(-0.2, 0.2) };
        // frictionless blocks are held along the ground
        let held =
            if seed % 4 < 2 { "- {face: X0, fix: [x]}\n- {face: Y0, fix: [y]}\n" } else { "" };
        let shape = Block { cells: [2, 2, 2], min: [0.0; 3], max: size, jitter: 0.2, seed };
        let mesh = shape.mesh(&["P"], |_| 0, |_, _| false);
        let s = solve(
            &format!(
                "materials: {{s: {{E: 210000, nu: 0.3}}}}\nbodies: {{P: s}}\nsupports:\n- {{face: \
                 Z0, law: contact, {law}, stiffness: {k:?}}}\n{held}loads:\n- {{face: Z1, \
                 traction: [{side:?}, 0, {:?}]}}\n",
                between(-60.0, -20.0)
            ),
            mesh,
        );
        s.strict(&format!("seed {seed}, k = {k:.3}, {law}"));
    }
}

/// A steel column that yields on elastic ground: a bracket of the elastoplastic energy.
#[test]
fn a_column_that_yields() {
    let block = |max| Block { cells: [2, 2, 3], min: [0.0; 3], max, jitter: 0.1, seed: 3 };
    let mesh = block([40.0, 30.0, 60.0]).mesh(&["A"], |_| 0, |_, _| false);
    let m = plastic_model(
        "bodies: {A: s}\nsupports:\n- {face: Z0, law: contact, mu: 0, stiffness: 800}\n- {face: \
         X0, fix: [x]}\n- {face: Y0, fix: [y]}\nloads:\n- {face: Z1, traction: [20, 0, -190]}\n",
        mesh,
    );
    strict_pass("yielding column", &m, &run(&m));
}

/// The ground's stiffness is a positive number, and a fixed face has none.
#[test]
fn wrong_stiffness() {
    let mesh = || Block::new([1, 1, 1], PLATE).mesh(&["P"], |_| 0, |_, _| true);
    for (support, said) in [
        ("{face: Z0, law: contact, mu: 0, stiffness: -3}", "stiffness of the ground under `Z0`"),
        ("{face: Z0, law: contact, mu: 0, stiffness: 0}", "stiffness of the ground under `Z0`"),
        ("{face: Z0, fix: [z], stiffness: 3}", "have no effect on the fixed face `Z0`"),
    ] {
        let yaml = format!(
            "materials: {{s: {{E: 210000, nu: 0.3}}}}\nbodies: {{P: s}}\nsupports:\n- {support}\n\
             loads:\n- {{face: Z1, traction: [0, 0, -1]}}\n"
        );
        let found = resolve(&yaml, mesh()).map(|_| ()).unwrap_err();
        assert!(format!("{found:?}").contains(said), "{support}: {found:?}");
    }
}
