//! Bodies in plane strain: a slice one cell thick between frictionless faces that hold y.
//!
//! Slip-line solutions hold for the slice as well. Its stress does not vary along y, its stress
//! along y is the mean of the other two normal stresses, and its velocity lies in the plane.
//! k = s0/√3.

use super::grid::{Grid, name};
use super::limit::factors;
use super::yielding::model;
use bracket::mesh::TetMesh;
use bracket::model::AnalysisModel;

/// 1/√3: computed factors are divided by s0, those of the sources by k.
pub const K: f64 = 0.577_350_269_189_625_8;

/// Supports of the faces Y0 and Y1.
pub const PLANE_STRAIN: &str = "- {face: Y0, fix: [y]}\n- {face: Y1, fix: [y]}\n";

/// A slice in x and z of thickness `thick` along y, with the faces Y0 and Y1.
pub fn slice(x: Vec<f64>, z: Vec<f64>, thick: f64, flat: impl Fn(usize, f64) -> bool) -> TetMesh {
    // nothing bends: parallel diagonals give the narrower bracket of A23 (3.5 %, mirrored 4.8 %)
    let grid = Grid::new([x, vec![0.0, thick], z]).parallel().jittered(0.15, 3);
    let mut mesh = grid.mesh(&["B"], |_| Some(0), flat);
    name(&mut mesh, "Y0", "B", |p| p[1] == 0.0);
    name(&mut mesh, "Y1", "B", |p| p[1] == thick);
    mesh
}

/// A quarter of a block of width w = 2 `half` and height 2 between rough rigid platens, pressed.
///
/// ```text
///   ==================  rigid, rough
///   |                |
///   |                | w
///   ==================
/// ```
pub fn platens(half: f64, x: Vec<f64>, z: Vec<f64>) -> AnalysisModel {
    let thick = 0.15;
    let mut mesh = slice(x, z, thick, |_, _| false);
    name(&mut mesh, "X0", "B", |p| p[0] == 0.0);
    name(&mut mesh, "Z0", "B", |p| p[2] == 0.0);
    name(&mut mesh, "PLATEN", "B", |p| p[2] == 1.0);
    model(
        &format!(
            "bodies: {{B: s}}\nsupports:\n{PLANE_STRAIN}- {{face: X0, fix: [x]}}\n- {{face: Z0, \
             fix: [z]}}\nrigid:\n- {{face: PLATEN, components: [x, z], free: [uz], at: [0, 0, 1], \
             force: [0, 0, {:?}]}}\n",
            -half * thick
        ),
        mesh,
    )
}

/// Checks that the strict bracket contains the known factor and has a relative width of at most
/// `width`. Both factors are divided by k.
pub fn contains(name: &str, m: &AnalysisModel, exact: f64, width: f64) {
    let [low, up] = factors(&format!("{name}, {} tets", m.mesh.tets.len()), m).map(|f| f / K);
    println!(
        "{name}: [{low:.5}, {up:.5}] k around {exact:.5} k, width {:.2} %",
        100.0 * (up / low - 1.0)
    );
    assert!(low <= exact && exact <= up, "{name}: {exact} outside [{low}, {up}]");
    assert!(up / low - 1.0 <= width, "{name}: [{low}, {up}]");
}
