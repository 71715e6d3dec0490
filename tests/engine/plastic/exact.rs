//! A1 and A3 beyond yield: bodies whose exact stress and plastic strain are constant, so that both
//! programs represent them on any mesh. A parallel elastic body limits the strain.
//!
//! ```text
//!   two bars in parallel      two cubes in parallel       all-round pressure
//!  |[=== elastic =====]|           __F__→                      p
//!  |[=== yields ======]|→ N     [/ /] [/ /]                 -> [ ] <-
//!                               /////////// γ
//! ```
//! Energies per volume: ½Ee² and f_y²/(2E) + f_y (e − f_y/E); in shear ½Gγ² and k²/(2G) + k (γ −
//! k/G) with k = f_y/√3.
//!
//! Tolerance 1e-6 relative (docs/benchmarks.md): the solver stops at 1e-7, and the lower bound
//! leaves 2e-7 of the yield strength unused.

use crate::common::plastic::{plastic_model, run, strict};
use crate::common::yielding::{E, FY, NU};
use crate::common::{Block, beside};
use bracket::mesh::TetMesh;
use bracket::model::AnalysisModel;
use bracket::solve::SolveStatus;

const SEEDS: [u64; 3] = [1, 5, 9];

fn cuboid(cells: [usize; 3], min: [f64; 3], max: [f64; 3], seed: u64, body: &str) -> TetMesh {
    Block { cells, min, max, jitter: 0.2, seed }.mesh(&[body], |_| 0, |_, _| false)
}

fn exact(name: &str, want: f64, at: impl Fn(u64) -> AnalysisModel) {
    for seed in SEEDS {
        let [low, up] = strict(&format!("{name}, seed {seed}"), &at(seed));
        println!("{name}: {:.1e} {:.1e}", low / want - 1.0, up / want - 1.0);
        assert!(
            (low / want - 1.0).abs() < 1e-6 && (up / want - 1.0).abs() < 1e-6,
            "{name}: [{low}, {up}], {want}"
        );
        // strict: neither bound may pass the exact value
        let rounding = 1e-11 * want.abs();
        assert!(
            low <= want + rounding && up >= want - rounding,
            "{name}: [{low:e}, {up:e}] against {want:e}"
        );
    }
}

/// Bars with a strain of `times` that at yield. A never yields. Their areas are 120 mm² and 96 mm²,
/// their length is 30 mm.
fn bars(times: f64, seed: u64) -> AnalysisModel {
    let mesh = beside(
        cuboid([3, 1, 2], [0.0; 3], [30.0, 10.0, 12.0], seed, "A"),
        cuboid([2, 2, 1], [0.0, 20.0, 0.0], [30.0, 28.0, 12.0], seed + 1, "B"),
    );
    let n = FY * (times * 120.0 + times.min(1.0) * 96.0);
    plastic_model(
        &format!(
            "bodies: {{A: r, B: s}}\nsupports:\n- {{face: X0, fix: [x]}}\n- {{face: Y0, fix: \
             [y]}}\n- {{face: Z0, fix: [z]}}\nrigid:\n- {{face: X1, components: [x], free: [ux], \
             at: [30, 0, 0], force: [{n:?}, 0, 0]}}\n"
        ),
        mesh,
    )
}

#[test]
fn a1_bar_beside_an_elastic_bar() {
    for times in [0.9, 1.1, 3.0, 20.0] {
        let strain = times * FY / E;
        let yielded = match times > 1.0 {
            true => FY * FY / (2.0 * E) + FY * (strain - FY / E),
            false => 0.5 * E * strain * strain,
        };
        let energy = 30.0 * (0.5 * E * strain * strain * 120.0 + yielded * 96.0);
        let work = FY * (times * 120.0 + times.min(1.0) * 96.0) * strain * 30.0;
        exact(&format!("A1 at {times}"), energy - work, |seed| bars(times, seed));
    }
}

#[test]
fn a3_cube_in_shear_beside_an_elastic_cube() {
    let (g, k) = (E / (2.0 * (1.0 + NU)), FY / 3.0f64.sqrt());
    let gamma = 3.0 * k / g;
    let force = g * gamma * 100.0 + k * 80.0;
    let energy = 0.5 * g * gamma * gamma * 1000.0 + (k * gamma - k * k / (2.0 * g)) * 800.0;
    exact("A3", energy - force * gamma * 10.0, |seed| {
        let mesh = beside(
            cuboid([2, 1, 1], [0.0; 3], [10.0; 3], seed, "A"),
            cuboid([1, 2, 2], [20.0, 0.0, 0.0], [30.0, 10.0, 8.0], seed, "B"),
        );
        // u = (γ y, 0, 0): the sides carry the shear as a reaction
        plastic_model(
            &format!(
                "bodies: {{A: r, B: s}}\nsupports:\n- {{face: Y0, fix: [x, y, z]}}\n- {{face: X0, \
                 fix: [y]}}\n- {{face: X1, fix: [y]}}\n- {{face: Z0, fix: [z]}}\n- {{face: Z1, \
                 fix: [z]}}\nrigid:\n- {{face: Y1, components: [x, y, z], free: [ux], at: [0, 10, \
                 0], force: [{force:?}, 0, 0]}}\n"
            ),
            mesh,
        )
    });
}

/// A7: pressure causes no plastic flow, however high it is. Nothing supports the cube, and no
/// element gets a yield condition.
#[test]
fn a7_cube_under_all_round_pressure() {
    let p = 3.0 * FY;
    let bulk = E / (3.0 * (1.0 - 2.0 * NU));
    let at = |seed| {
        let loads: String = ["X0", "X1", "Y0", "Y1", "Z0", "Z1"]
            .map(|f| format!("- {{face: {f}, pressure: {p:?}}}\n"))
            .concat();
        plastic_model(
            &format!("bodies: {{B: s}}\nloads:\n{loads}"),
            cuboid([2, 1, 2], [0.0; 3], [10.0; 3], seed, "B"),
        )
    };
    exact("A7", -p * p * 1000.0 / (2.0 * bulk), at);
    assert!(run(&at(1)).runs().all(|(_, r)| r.yielding == Some(0) && r.rounds == 1));
}

/// A single bar is elastic at 0.999 of its yield force. It has no equilibrium at 1.001, and both
/// programs name the body that flows.
#[test]
fn bar_below_and_beyond_its_strength() {
    let bar = |part: f64, seed| {
        let t = part * FY;
        plastic_model(
            &format!(
                "bodies: {{B: s}}\nsupports:\n- {{face: X0, fix: [x]}}\n- {{face: Y0, fix: \
                 [y]}}\n- {{face: Z0, fix: [z]}}\nloads:\n- {{face: X1, traction: [{t:?}, 0, \
                 0]}}\n"
            ),
            cuboid([3, 2, 1], [0.0; 3], [30.0, 10.0, 12.0], seed, "B"),
        )
    };
    let n = 0.999 * FY * 120.0;
    exact("bar", -n * n * 30.0 / (2.0 * E * 120.0), |seed| bar(0.999, seed));
    for seed in SEEDS {
        let pass = run(&bar(1.001, seed));
        assert!(pass.lower.is_none() && pass.upper.is_none());
        for (program, r) in pass.runs() {
            println!(
                "bar {}: {:?} after {}: {:?}",
                program.name(),
                r.status,
                r.iterations,
                r.mechanism
            );
            assert_eq!(r.status, SolveStatus::Unbounded, "{}", program.name());
            let words = r.mechanism.clone().unwrap_or_default().to_string();
            assert!(
                words.contains("body `B` (100 % of the dissipation) yields without end"),
                "{words}"
            );
            assert!(words.contains("part B moves along +x"), "{words}");
        }
    }
}
