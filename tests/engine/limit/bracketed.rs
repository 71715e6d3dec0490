//! Bodies whose limit load is known only as a bracket. The computed bracket must overlap it.

use crate::common::Block;
use crate::common::grid::{Grid, even, joined, name};
use crate::common::limit::{factors, sharp_factors};
use crate::common::yielding::{block, model};
use bracket::mesh::TetMesh;
use bracket::model::AnalysisModel;

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

/// The plate of C1 on mirrored cells between these planes, each with its mid-plane at z = 0. From
/// y = 0 it is half of the plate, from z = 0 its upper half.
///
/// The yield condition does not change with the sign of the stress. So the mirror image at the
/// mid-plane with opposite sign is also a solution, and so is the mean of both: it has no velocity
/// along the mid-plane and no pressure on it.
fn plate_of(planes: [Vec<f64>; 3]) -> AnalysisModel {
    let from = [1, 2].map(|d| planes[d][0]);
    let mut mesh = Grid::new(planes).mesh(&["B"], |_| Some(0), |_, _| true);
    name(&mut mesh, "X0", "B", |p| p[0] == 0.0);
    name(&mut mesh, "X1", "B", |p| p[0] == 5.0);
    let mut supports = "- {face: X0, fix: [x, y, z]}\n".to_string();
    for (face, d, fix) in [("Y0", 1, "[y]"), ("Z0", 2, "[x, y]")] {
        if from[d - 1] == 0.0 {
            name(&mut mesh, face, "B", |p| p[d] == 0.0);
            supports += &format!("- {{face: {face}, fix: {fix}}}\n");
        }
    }
    model(
        &format!(
            "bodies: {{B: s}}\nsupports:\n{supports}loads:\n- {{face: X1, traction: [0, 0, 1]}}\n"
        ),
        mesh,
    )
}

/// A quarter of C1 has the bounds of the whole plate on a symmetric mesh.
#[test]
fn quarter_of_the_clamped_plate() {
    let x = || vec![0.0, 0.25, 0.5, 1.0, 2.0, 5.0];
    let quarter = plate_of([x(), even(0.0, 1.0, 2), even(0.0, 0.5, 2)]);
    let whole = plate_of([x(), even(-1.0, 1.0, 4), even(-0.5, 0.5, 4)]);
    let found = sharp_factors("C1, quarter", &quarter);
    for (a, b) in found.into_iter().zip(sharp_factors("C1, whole", &whole)) {
        assert!((a / b - 1.0).abs() < 1e-5, "{a} {b}");
    }
}

/// C1 on a mesh that is finer towards the clamp and the free edge: the bracket is at most 2 % wide
/// with at most 4 000 macro tets. Where the plate turns, cells are a twelfth of its thickness.
#[test]
fn clamped_plate_fine() {
    let near = (0..=14).map(|i| f64::from(i) / 12.0).collect();
    let x = joined(&[near, vec![14.0 / 12.0, 1.3, 1.5, 1.75, 2.2, 3.0, 5.0]]);
    let m = plate_of([x, vec![0.0, 0.4, 0.7, 0.88, 1.0], even(0.0, 0.5, 6)]);
    let [low, up] = factors(&format!("C1, {} tets", m.mesh.tets.len()), &m);
    assert!(low <= 0.0628 && up >= 0.0578, "[{low}, {up}]");
    assert!(m.mesh.tets.len() <= 4_000 && up / low - 1.0 <= 0.02, "[{low}, {up}]");
}

/// An eighth of a cube of edge 2, pressed at its top between rough rigid platens.
fn cube_between_platens(n: usize) -> AnalysisModel {
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
