//! A plate that turns about a line of its middle plane, on structured meshes.

use crate::common::grid::{Grid, name};
use crate::common::limit::factors;
use crate::common::mirrored;
use crate::common::plane_strain::PLANE_STRAIN;
use crate::common::yielding::model;
use bracket::mesh::topology::FaceTable;

/// Six tets fill each cell, and neighbouring cells share whole faces: of a block of 3 × 4 × 2
/// cells, only the triangles on its surface have one owner.
#[test]
fn mirrored_cells_fit_together() {
    for phase in (0..8).map(|p| [p & 1, p >> 1 & 1, p >> 2]) {
        let n = [3, 4, 2];
        let mut tets = Vec::new();
        for cell in (0..n[0] * n[1] * n[2]).map(|c| [c % 3, c / 3 % 4, c / 12]) {
            for tet in mirrored::tets(cell, mirrored::start(cell, Some(phase))) {
                let x = tet.map(|p| p.map(|c| c as f64));
                let volume = bracket::mesh::tet::signed_volume(&x);
                assert!((volume - 1.0 / 6.0).abs() < 1e-15, "{phase:?} {tet:?}: {volume}");
                assert!(tet.iter().all(|p| (0..3).all(|d| p[d] == cell[d] || p[d] == cell[d] + 1)));
                tets.push(tet.map(|[i, j, k]| (i + 4 * (j + 5 * k)) as u32));
            }
        }
        let outer = FaceTable::new(&tets).faces().filter(|owners| owners.len() == 1).count();
        assert_eq!(outer, 2 * 2 * (n[0] * n[1] + n[1] * n[2] + n[2] * n[0]), "{phase:?}");
    }
}

/// A strip in plane strain, 20 long and 1 thick, clamped at x = 0 and sheared at its end.
///
/// ```text
///   /+---+---------------------+
///   /|\ /|                     | ↑     diagonals from the middle plane at x = 0.5
///   /| X |                     |
///   /|/ \|                     |
///   /+---+---------------------+
/// ```
/// Let the part beyond the wedges turn about that line, u = (θ/2) sgn(z) (−x, z) in the wedges. The
/// field is continuous and keeps the volume, and it dissipates M_p θ with M_p = (2/√3) s0 b t²/4.
/// So the upper bound is at most M_p over the lever, 19.5. Without these diagonals the cells lock.
#[test]
fn diagonals_through_the_middle_plane_make_a_hinge() {
    let turned_by_hand = 0.25 * 2.0 / 3f64.sqrt() / 19.5;
    let strip = |phase: [usize; 3]| {
        let grid = Grid::new([vec![0.0, 0.5, 1.0, 20.0], vec![0.0, 0.2], vec![0.0, 0.5, 1.0]]);
        let mut mesh = grid.phase(phase).mesh(&["B"], |_| Some(0), |_, _| true);
        for (face, d, at) in [("Y0", 1, 0.0), ("Y1", 1, 0.2), ("X0", 0, 0.0), ("X1", 0, 20.0)] {
            name(&mut mesh, face, "B", |p| p[d] == at);
        }
        let m = model(
            &format!(
                "bodies: {{B: s}}\nsupports:\n{PLANE_STRAIN}- {{face: X0, fix: [x, y, \
                 z]}}\nloads:\n- {{face: X1, traction: [0, 0, 1]}}\n"
            ),
            mesh,
        );
        factors(&format!("strip with hinge, phase {phase:?}"), &m)[1] / turned_by_hand
    };
    let (hinge, locked) = (strip([0; 3]), strip([1, 0, 0]));
    println!("upper bound over that of the hinge: {hinge:.4}, without its diagonals {locked:.4}");
    assert!(hinge <= 1.0 + 1e-4, "{hinge}");
    assert!(locked > 1.05, "{locked}");
}
