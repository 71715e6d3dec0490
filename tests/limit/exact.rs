//! Bodies whose limit load is known exactly, with fields that both elements hold on any mesh (BENCHMARKS A1–A5, A7).
//!
//! Tolerance 1e-6 relative: the solver is asked for a gap of 1e-7; pure bending 1e-5.

use crate::certified::{run, sharp_factors};
use crate::common::Block;
use crate::common::yielding::{FY, model};
use bracket::mesh::TetMesh;
use bracket::model::AnalysisModel;
use bracket::solve::SolveStatus;

const SEEDS: [u64; 3] = [1, 5, 9];

fn cuboid(cells: [usize; 3], max: [f64; 3], seed: u64) -> TetMesh {
    Block::new(cells, max).jittered(seed).mesh(&["B"], |_| 0, |_, _| false)
}

fn exact(name: &str, want: f64, tolerance: f64, at: impl Fn(u64) -> AnalysisModel) {
    for seed in SEEDS {
        let [low, up] = sharp_factors(&format!("{name}, seed {seed}"), &at(seed));
        assert!((low / want - 1.0).abs() < tolerance && (up / want - 1.0).abs() < tolerance, "{name}: [{low}, {up}]");
        // strict: neither side may pass the exact value by more than its own rounding
        assert!(low <= want * (1.0 + 1e-9) && up >= want * (1.0 - 1e-9), "{name}: [{low}, {up}] against {want}");
    }
}

/// A1: N = s0 A.
#[test]
fn bar_in_tension() {
    exact("A1", 1.0, 1e-6, |seed| {
        model(
            "bodies: {B: s}\nsupports:\n- {face: X0, fix: [x]}\n- {face: Y0, fix: [y]}\n- {face: Z0, fix: [z]}\n\
             loads:\n- {face: X1, traction: [1, 0, 0]}\n",
            cuboid([3, 2, 2], [30.0, 10.0, 12.0], seed),
        )
    });
}

/// A2: between plane-strain faces 2/√3 s0 A.
#[test]
fn bar_in_plane_strain() {
    exact("A2", 2.0 / 3.0f64.sqrt(), 1e-6, |seed| {
        model(
            "bodies: {B: s}\nsupports:\n- {face: X0, fix: [x]}\n- {face: Y0, fix: [y]}\n- {face: Z0, fix: [z]}\n\
             - {face: Y1, fix: [y]}\nloads:\n- {face: X1, traction: [1, 0, 0]}\n",
            cuboid([3, 2, 2], [30.0, 10.0, 12.0], seed),
        )
    });
}

/// A3: pure shear, k = s0/√3.
#[test]
fn cube_in_shear() {
    exact("A3", 1.0 / 3.0f64.sqrt(), 1e-6, |seed| {
        let faces = ["X0", "X1", "Y0", "Y1"];
        let tractions = ["[0, -1, 0]", "[0, 1, 0]", "[-1, 0, 0]", "[1, 0, 0]"];
        let loads: String =
            faces.iter().zip(tractions).map(|(f, t)| format!("- {{face: {f}, traction: {t}}}\n")).collect();
        let support = "supports:\n- {face: Z0, fix: [z]}\n- {face: Z1, fix: [z]}\n";
        model(&format!("bodies: {{B: s}}\n{support}loads:\n{loads}"), cuboid([2, 2, 2], [10.0; 3], seed))
    });
}

/// A4: pure bending, the ends rigid in x only, a mesh plane at mid-height: M = s0 b h²/4; A5 between plane-strain faces.
#[test]
fn beam_in_pure_bending() {
    let (b, h) = (8.0, 12.0);
    for (name, plane, want) in [("A4", "", 1.0), ("A5", "- {face: Y1, fix: [y]}\n", 2.0 / 3.0f64.sqrt())] {
        exact(name, want, 1e-5, |seed| {
            let mesh = Block { cells: [3, 1, 2], min: [0.0, 0.0, -6.0], max: [30.0, b, 6.0], jitter: 0.2, seed }.mesh(
                &["B"],
                |_| 0,
                |axis, z| axis == 2 && z.abs() < 1e-9,
            );
            // unit moment: the factor is then M/s0 over b h²/4
            let m = b * h * h / 4.0;
            model(
                &format!(
                    "bodies: {{B: s}}\nsupports:\n- {{face: X0, fix: [x]}}\n- {{face: Y0, fix: [y]}}\n{plane}\
                     rigid:\n- {{face: X1, components: [x], free: [ux, ry], at: [30, 0, 0], moment: [0, {m:?}, 0]}}\n"
                ),
                mesh,
            )
        });
    }
}

/// A7: all-round pressure never makes it flow: the load factor has no limit, and both programs say so within 15 iterations.
#[test]
fn cube_under_all_round_pressure() {
    for seed in SEEDS {
        let loads: String =
            ["X0", "X1", "Y0", "Y1", "Z0", "Z1"].map(|f| format!("- {{face: {f}, pressure: 1}}\n")).concat();
        let m = model(&format!("bodies: {{B: s}}\nloads:\n{loads}"), cuboid([2, 1, 2], [10.0; 3], seed));
        for (program, r) in run(&m).runs() {
            println!("A7 {}: {} in {}", program.name(), r.status.words(), r.iterations);
            assert_eq!(r.status, SolveStatus::Infeasible, "{}", program.name());
            assert!(r.conflict.as_ref().is_some_and(|c| c.contains("no limit")), "{:?}", r.conflict);
            assert!(r.iterations <= 15, "{}: {}", program.name(), r.iterations);
        }
    }
}

/// A dead load beyond what the structure carries: no load factor at all, and it says so.
#[test]
fn dead_load_beyond_the_limit() {
    let m = model(
        &format!(
            "bodies: {{B: s}}\nsupports:\n- {{face: X0, fix: [x, y, z]}}\nloads:\n- {{face: X1, traction: [0, 0, 1]}}\n\
             dead:\n- {{face: X1, traction: [{:?}, 0, 0]}}\n",
            1.5 * FY
        ),
        cuboid([3, 2, 2], [30.0, 10.0, 12.0], 1),
    );
    for (program, r) in run(&m).runs() {
        println!("dead {}: {} in {}, {:?}", program.name(), r.status.words(), r.iterations, r.mechanism);
        assert_eq!(r.status, SolveStatus::Unbounded, "{}", program.name());
    }
}
