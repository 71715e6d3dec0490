//! Bars, cubes and columns whose exact stress is linear. Both programs represent the exact solution
//! on any mesh.
//!
//! ```text
//!   A1 tension          A6 pure bending        A7 all-round pressure   A9 self-weight
//!  |[=======]--> p      )[=======](  t = Mz/I        p                  /////
//!  |                    no support                -> [ ] <-             [   ]  | ρg
//!                                                 no support            [   ]  v
//! ```
//! Source: S. P. Timoshenko, J. N. Goodier, Theory of Elasticity, 3rd ed., articles 99
//! (self-weight), 102 (bending); strain energies N²L/(2EA), M²L/(2EI), p²V/(2K), ρ²g²AL³/(6E) by
//! integrating σ:C⁻¹:σ / 2.
//!
//! Tolerance 1e-8 relative: there is no discretisation error, there are no cones, and one linear
//! solve is refined. The remaining error is rounding times the condition number. Each case runs on
//! three meshes with different random inner nodes.

use crate::common::Block;
use crate::common::solved::solve;

const E: f64 = 210_000.0;
const STEEL: &str = "materials: {s: {E: 210000, nu: 0.3}}\nbodies: {B: s}\n";
const SEEDS: [u64; 3] = [1, 7, 42];

fn block(cells: [usize; 3], min: [f64; 3], max: [f64; 3], seed: u64) -> bracket::mesh::TetMesh {
    Block { cells, min, max, jitter: 0.2, seed }.mesh(&["B"], |_| 0, |_, _| false)
}

#[test]
fn a1_bar_in_tension() {
    for seed in SEEDS {
        let mesh = block([5, 2, 3], [0.0; 3], [50.0, 10.0, 12.0], seed);
        let yaml = format!(
            "{STEEL}supports:\n- {{face: X0, fix: [x]}}\n- {{face: Y0, fix: [y]}}\n- {{face: Z0, \
             fix: [z]}}\nloads:\n- {{face: X1, traction: [80, 0, 0]}}\n"
        );
        let (n, a, l) = (80.0 * 120.0, 120.0, 50.0);
        solve(&yaml, mesh).exact("A1", -n * n * l / (2.0 * E * a), 1e-8);
    }
}

#[test]
fn a6_pure_bending_without_support() {
    let (b, h, l) = (6.0, 10.0, 40.0);
    let m = 50_000.0;
    let i = b * h * h * h / 12.0;
    for seed in SEEDS {
        let mesh = block([4, 2, 3], [0.0, -b / 2.0, -h / 2.0], [l, b / 2.0, h / 2.0], seed);
        let load = |face: &str, sign: f64| {
            let k = sign * m / i;
            format!(
                "- {{face: {face}, linear: {{traction0: [0, 0, 0], gradient: [[0, 0, {k:?}], [0, \
                 0, 0], [0, 0, 0]]}}}}\n"
            )
        };
        let yaml = format!("{STEEL}loads:\n{}{}", load("X1", 1.0), load("X0", -1.0));
        let s = solve(&yaml, mesh);
        assert_eq!(s.model.free_modes.len(), 6);
        s.exact("A6", -m * m * l / (2.0 * E * i), 1e-8);
        assert!(s.pass.bracket.as_ref().unwrap().gap().abs() < 1e-8);
    }
}

#[test]
fn a7_cube_under_all_round_pressure() {
    let (p, a) = (120.0, 10.0f64);
    for seed in SEEDS {
        let mesh = block([3, 3, 3], [0.0; 3], [a; 3], seed);
        let loads: String = ["X0", "X1", "Y0", "Y1", "Z0", "Z1"]
            .map(|f| format!("- {{face: {f}, pressure: {p:?}}}\n"))
            .concat();
        let k = E / (3.0 * (1.0 - 0.6));
        let s = solve(&format!("{STEEL}loads:\n{loads}"), mesh);
        assert_eq!(s.model.free_modes.len(), 6);
        s.exact("A7", -p * p * a.powi(3) / (2.0 * k), 1e-8);
    }
}

#[test]
fn a9_column_under_its_own_weight() {
    let (rho_g, a, l) = (7.7e-5, 10.0 * 12.0, 60.0f64);
    for seed in SEEDS {
        let mesh = block([2, 2, 5], [0.0; 3], [10.0, 12.0, l], seed);
        let yaml = format!(
            "materials: {{s: {{E: 210000, nu: 0}}}}\nbodies: {{B: s}}\nsupports:\n- {{face: Z1, \
             fix: [x, y, z]}}\nloads:\n- {{body: B, force: [0, 0, {:?}]}}\n",
            -rho_g
        );
        let s = solve(&yaml, mesh);
        s.exact("A9", -rho_g * rho_g * a * l.powi(3) / (6.0 * E), 1e-8);
        assert!(s.pass.bracket.as_ref().unwrap().gap().abs() < 1e-8);
    }
}
