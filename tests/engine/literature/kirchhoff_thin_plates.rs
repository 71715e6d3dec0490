//! Plates of slenderness 1:200, clamped, pressed, and lying on the ground with friction.
//!
//! ```text
//!   bent                 pressed                peeled off the ground      pressed onto the ground
//!  |==============) m   | v v v v v v v p       v v v v v v v p  __-- F    |=__ v v v v v v v p
//!  |                    |===============       ========____----            |  ---=============
//!   ν = 0: exact        |                      ~~~~~~~~~~~~~~~ μ          ~~~~~~~~~ μ, gap g
//! ```
//! Source: G. Kirchhoff, J. reine angew. Math. 40 (1850); S. P. Timoshenko, S. Woinowsky-Krieger,
//! Theory of Plates and Shells, 2nd ed., article 2 (cylindrical bending, D = Et³/12(1 − ν²)). Per
//! unit width, D: end moment m, m²L/2D; pressure p on a cantilever, p²L⁵/40D, and the shear energy
//! p²L³/5Gt (Timoshenko & Goodier, shear factor 6/5); strip of weight p lifted at its end to the
//! length a by F = pa/2 (touchdown without moment), p²a⁵/240D.
//!
//! clamped at g above the ground, pressed by p, flat on it from x = a: g = pa⁴/72D (no moment at
//! a), Π = p²a⁵/540D − p²a⁵/120D − pg(L − a).
//!
//! Tolerance of the moment 1e-8: both spaces contain linear stress and quadratic displacement, and
//! one linear solve is refined. In the other cases the closed form must lie inside a bracket
//! narrower than 3 %. The closed form neglects effects at the clamped end, at touchdown and of
//! shear near them. They are of the order of (t/L)² = 3e-5 of the energy, a hundredth of the
//! brackets, so the test makes no allowance for them.

use crate::common::Block;
use crate::common::solved::solve;
use bracket::mesh::TetMesh;

const E: f64 = 210_000.0;
const L: f64 = 200.0;
const T: f64 = 1.0;
/// Sides that stay plane: cylindrical bending with ν.
const SIDES: &str = "- {face: Y0, fix: [y]}\n- {face: Y1, fix: [y]}\n";

fn plate(cells: [usize; 3], width: f64, seed: u64) -> TetMesh {
    let block =
        Block { cells, min: [0.0, 0.0, -T / 2.0], max: [L, width, T / 2.0], jitter: 0.2, seed };
    block.mesh(&["P"], |_| 0, |_, _| false)
}

fn steel(nu: f64) -> String {
    format!("materials: {{s: {{E: {E:?}, nu: {nu:?}}}}}\nbodies: {{P: s}}\n")
}

/// Bending stiffness per unit width \[N mm\].
fn stiffness(nu: f64) -> f64 {
    E * T.powi(3) / (12.0 * (1.0 - nu * nu))
}

#[test]
fn a_moment_bends_it_along_a_circle() {
    let (width, stress) = (20.0, 100.0);
    let m = stress * T * T / 6.0;
    let k = 2.0 * stress / T;
    let moment = |face: &str, sign: f64| {
        let k = sign * k;
        format!(
            "- {{face: {face}, linear: {{traction0: [0, 0, 0], gradient: [[0, 0, {k:?}], [0, 0, \
             0], [0, 0, 0]]}}}}\n"
        )
    };
    for seed in [1, 7, 42] {
        let loads = format!("loads:\n{}", moment("X1", 1.0));
        let clamped = format!("{}supports:\n- {{face: X0, fix: [x, y, z]}}\n{loads}", steel(0.0));
        let exact = -m * m * L * width / (2.0 * stiffness(0.0));
        solve(&clamped, plate([40, 4, 2], width, seed)).exact("clamped, ν 0", exact, 1e-8);
        // free anticlastic bending: the stress, and therefore the energy, does not depend on ν
        let free = format!("{}{loads}{}", steel(0.3), moment("X0", -1.0));
        solve(&free, plate([40, 4, 2], width, seed)).exact("free, ν 0.3", exact, 1e-8);
    }
}

/// Checks that `Π` \[N mm\] is `energy` × width, inside a bracket narrower than 3 %.
fn holds(name: &str, yaml: &str, mesh: TetMesh, exact: f64) {
    let [lower, upper] = solve(yaml, mesh).contains(name, exact);
    println!(
        "{name}: ends {:+.2e} {:+.2e} from the closed form",
        lower / exact - 1.0,
        upper / exact - 1.0
    );
    assert!(upper - lower < 0.03 * -lower, "{name}: [{lower}, {upper}]");
}

#[test]
fn clamped_on_one_side_and_pressed() {
    let p = 1e-3;
    for (name, nu, sides) in [("ν 0", 0.0, ""), ("ν 0.3 between plane-strain sides", 0.3, SIDES)]
    {
        let yaml = format!(
            "{}supports:\n- {{face: X0, fix: [x, y, z]}}\n{sides}loads:\n- {{face: Z1, pressure: \
             {p:?}}}\n",
            steel(nu)
        );
        let shear = E / (2.0 * (1.0 + nu));
        let energy =
            p * p * L.powi(5) / (40.0 * stiffness(nu)) + p * p * L.powi(3) / (5.0 * shear * T);
        holds(name, &yaml, plate([24, 8, 1], L, 3), -L * energy);
    }
}

#[test]
fn peeled_off_a_rough_ground() {
    let (p, width, a) = (1e-3, 20.0, 120.0_f64);
    let force = p * a / 2.0;
    let energy = p * p * a.powi(5) / (240.0 * stiffness(0.0));
    for mu in ["0", "0.3, friction: associated"] {
        let guide = if mu == "0" { "- {face: X0, fix: [x]}\n- {face: Y0, fix: [y]}\n" } else { "" };
        let yaml = format!(
            "{}supports:\n{guide}- {{face: Z0, law: contact, mu: {mu}}}\nloads:\n- {{face: Z1, \
             pressure: {p:?}}}\n- {{face: X1, traction: [0, 0, {:?}]}}\n",
            steel(0.0),
            force / T
        );
        holds(&format!("peeled, μ {mu}"), &yaml, plate([32, 2, 1], width, 3), -width * energy);
    }
}

#[test]
fn pressed_down_until_its_end_lies_on_the_ground() {
    let p = 0.01_f64;
    for (gap, nu, sides) in [(0.5, 0.0, ""), (5.0, 0.3, SIDES)] {
        let d = stiffness(nu);
        let a = (72.0 * d * gap / p).powf(0.25);
        assert!(a < 0.85 * L);
        let energy = p * p * a.powi(5) * (1.0 / 540.0 - 1.0 / 120.0) / d - p * gap * (L - a);
        holds(
            &format!("gap {gap}, ν {nu}"),
            &lowered(gap, nu, sides),
            plate([24, 8, 1], L, 3),
            L * energy,
        );
    }
    // free sides curl upwards: no closed form is known
    solve(&lowered(0.5, 0.3, ""), plate([20, 10, 1], L, 3)).strict("gap 0.5, free sides");
}

/// A plate clamped at `gap` above rough ground and pressed down.
fn lowered(gap: f64, nu: f64, sides: &str) -> String {
    format!(
        "{}supports:\n- {{face: X0, fix: [x, y, z]}}\n{sides}- {{face: Z0, law: contact, mu: 0.3, \
         friction: associated, gap: {gap:?}}}\nloads:\n- {{face: Z1, pressure: 0.01}}\n",
        steel(nu)
    )
}
