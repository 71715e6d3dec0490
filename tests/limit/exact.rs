//! Bodies whose limit load is known exactly, and fields that both elements hold.

use crate::common::Block;
use crate::common::yielding::{FY, model};
use bracket::mesh::TetMesh;
use bracket::model::program::ConicProgram;
use bracket::model::{AnalysisModel, Flow, Kinematic, Static};
use bracket::solve::{Solution, SolveOptions, SolveStatus, condensed};
use std::sync::Arc;

fn options() -> SolveOptions {
    let trace = std::env::var_os("TRACE").is_some();
    SolveOptions {
        gap: 1e-7,
        progress: trace.then(|| {
            Arc::new(|i: &bracket::solve::Iteration| {
                println!("{:3} gap {:.2e} residual {:.2e} step {:.3}", i.number, i.gap, i.residual, i.step)
            }) as bracket::solve::status::Iterations
        }),
        ..SolveOptions::default()
    }
}

pub fn solve(name: &str, program: &ConicProgram, block: &[u32]) -> Solution {
    let s = condensed::Prepared::new(program, block).unwrap().solve(&options());
    println!(
        "{name}: {} iterations {} objective {:.8} factor {:.8}",
        s.status.words(),
        s.iterations,
        program.objective(&s.x, &s.z),
        s.x.last().unwrap()
    );
    s
}

/// Load factors of the static program, of the kinematic one on split elements and on plain ones.
pub fn factors(name: &str, model: &AnalysisModel) -> [f64; 2] {
    let statics = Static::limit(model).unwrap();
    let s = solve(&format!("{name} static"), &statics.program, &statics.map.block);
    let kinematic = Kinematic::limit(model, Flow::Split).unwrap();
    let k = solve(&format!("{name} split"), &kinematic.program, &kinematic.map.block);
    assert_eq!(s.status, SolveStatus::Optimal);
    assert_eq!(k.status, SolveStatus::Optimal);
    [*s.x.last().unwrap(), *k.x.last().unwrap()]
}

fn cuboid(cells: [usize; 3], max: [f64; 3], seed: u64) -> TetMesh {
    Block::new(cells, max).jittered(seed).mesh(&["B"], |_| 0, |_, _| false)
}

/// A1: a bar in tension.
#[test]
fn bar_in_tension() {
    for seed in [1, 5, 9] {
        let m = model(
            "bodies: {B: s}\nsupports:\n- {face: X0, fix: [x]}\n- {face: Y0, fix: [y]}\n- {face: Z0, fix: [z]}\n\
             loads:\n- {face: X1, traction: [1, 0, 0]}\n",
            cuboid([3, 2, 2], [30.0, 10.0, 12.0], seed),
        );
        for f in factors("A1", &m) {
            assert!((f / FY - 1.0).abs() < 1e-6, "{f}");
        }
    }
}

/// A cube, clamped, pressed and sheared: the bounds enclose the load factor.
#[test]
fn clamped_block() {
    let m = crate::common::yielding::block(3, 1.0);
    let [low, up] = factors("block", &m);
    assert!(low < up);
}

/// C1: a clamped plate 5 × 2 × 1 with end shear on x = 5.
#[test]
fn clamped_plate() {
    for (n, text) in [(1, "coarse"), (2, "fine")] {
        let mesh = Block::new([5 * n, 2 * n, 2 * n], [5.0, 2.0, 1.0]).jittered(2).mesh(
            &["B"],
            |_| 0,
            |axis, z| axis == 2 && (z - 0.5).abs() < 1e-9,
        );
        let m = model(
            "bodies: {B: s}\nsupports:\n- {face: X0, fix: [x, y, z]}\nloads:\n- {face: X1, traction: [0, 0, 235]}\n",
            mesh,
        );
        let [low, up] = factors(text, &m);
        assert!(low < 0.0628 && up > 0.0578 && low < up);
    }
}
