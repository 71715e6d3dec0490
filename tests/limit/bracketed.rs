//! Bodies whose limit load is known only as a bracket. The computed bracket must overlap it.

use crate::common::Block;
use crate::common::grid::{Grid, even, finer_at_start, name};
use crate::common::limit::factors;
use crate::common::yielding::{block, model};
use bracket::mesh::TetMesh;

/// C1: a clamped plate 5 × 2 × 1 with end shear on x = 5. The known strict bracket is [0.0578,
/// 0.0628] s0 per unit traction.
#[test]
fn clamped_plate() {
    let gaps = [1, 2].map(|n| {
        let mesh = Block::new([5 * n, 2 * n, 2 * n], [5.0, 2.0, 1.0]).jittered(2).mesh(
            &["B"],
            |_| 0,
            |axis, z| axis == 2 && (z - 0.5).abs() < 1e-9,
        );
        let m = model(
            "bodies: {B: s}\nsupports:\n- {face: X0, fix: [x, y, z]}\nloads:\n- {face: X1, \
             traction: [0, 0, 1]}\n",
            mesh,
        );
        let [low, up] = factors("C1", &m);
        assert!(low <= 0.0628 && up >= 0.0578, "[{low}, {up}]");
        up / low - 1.0
    });
    assert!(gaps[1] < 0.6 * gaps[0], "{gaps:?}");
}

/// C1 on a mesh that is finer towards the clamp: the bracket is at most 8 % wide with at most 12
/// 000 macro tets.
#[test]
#[ignore = "heavy: minutes"]
fn clamped_plate_fine() {
    let x = finer_at_start(0.0, 5.0, 0.12, 1.1);
    let mesh = Grid::new([x, even(0.0, 2.0, 10), even(0.0, 1.0, 8)]).jittered(0.2, 2);
    let mut mesh = mesh.mesh(&["B"], |_| Some(0), |axis, z| axis == 2 && (z - 0.5).abs() < 1e-9);
    name(&mut mesh, "X0", "B", |p| p[0] == 0.0);
    name(&mut mesh, "X1", "B", |p| p[0] == 5.0);
    let m = model(
        "bodies: {B: s}\nsupports:\n- {face: X0, fix: [x, y, z]}\nloads:\n- {face: X1, traction: \
         [0, 0, 1]}\n",
        mesh,
    );
    let [low, up] = factors(&format!("C1, {} tets", m.mesh.tets.len()), &m);
    assert!(low <= 0.0628 && up >= 0.0578, "[{low}, {up}]");
    assert!(m.mesh.tets.len() <= 12_000 && up / low - 1.0 <= 0.08, "[{low}, {up}]");
}

/// An eighth of a cube of edge 2, pressed at its top between rough rigid platens.
fn cube_between_platens(n: usize) -> bracket::model::AnalysisModel {
    let mesh: TetMesh = Block::new([n; 3], [1.0; 3]).jittered(3).mesh(&["B"], |_| 0, |_, _| false);
    model(
        "bodies: {B: s}\nsupports:\n- {face: X0, fix: [x]}\n- {face: Y0, fix: [y]}\n- {face: Z0, \
         fix: [z]}\nrigid:\n- {face: Z1, components: [x, y, z], free: [uz], at: [0, 0, 1], force: \
         [0, 0, -1]}\n",
        mesh,
    )
}

/// A33: the known strict bracket is [1.0353, 1.0600] s0.
#[test]
fn cube_between_rough_platens() {
    let [low, up] = factors("A33", &cube_between_platens(4));
    assert!(low <= 1.0600 && up >= 1.0353, "[{low}, {up}]");
    assert!(up / low - 1.0 < 0.06, "[{low}, {up}]");
}

/// A33 with 6 000 macro tets: the bracket is at most 1.5 % wide.
#[test]
#[ignore = "heavy: minutes"]
fn cube_between_rough_platens_fine() {
    let m = cube_between_platens(10);
    let [low, up] = factors("A33, fine", &m);
    assert!(low <= 1.0600 && up >= 1.0353, "[{low}, {up}]");
    assert!(
        m.mesh.tets.len() <= 6000 && up / low - 1.0 <= 0.015,
        "[{low}, {up}] on {} tets",
        m.mesh.tets.len()
    );
}

/// A clamped cube, pressed and sheared at its top (`common::yielding`).
#[test]
fn clamped_block() {
    let [low, up] = factors("block", &block(3, 1.0));
    assert!(low > 1.04 / 235.0 && up < 1.27 / 235.0);
}
