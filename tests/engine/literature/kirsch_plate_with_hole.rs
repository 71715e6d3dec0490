//! A29: a plate with a circular hole under tension.
//!
//! ```text
//!   +-------------+       quarter analysed: symmetry planes x = 0 and y = 0, tension s along x,
//!   |      _      |       half-width W = 10 a, half-length W; ends held along z: the stresses in
//! <-|     (_)     |-> s   the plane depend neither on ν nor on plane stress or strain (tractions
//!   +-------------+       only, hole free of load)
//! ```
//! Source: G. Kirsch, VDI-Z. 42 (1898): K_t = 3 in a wide plate; finite width: R. B. Heywood,
//! Designing by Photoelasticity (1952), K_tn = 2 + (1 − d/D)³ on the net section (Peterson's Stress
//! Concentration Factors, chart 4.1): d/D = 0.1, K_tg = 2.729 / 0.9 = 3.032 of the gross stress.
//! Tolerance 3 %: the formula is accurate to about 1 %. The stress at the edge of the hole comes
//! from a linear field on a polygon: it is the mean over the tets at the node of the static field.

use crate::common::solved::solve;
use crate::common::{Block, mapped};
use std::f64::consts::PI;

#[test]
fn a29_plate_with_a_hole() {
    let (a, w, s) = (1.0, 10.0, 100.0);
    let (radial, around) = (14, 16); // cells
    let block = Block::new([radial, around, 1], [1.0, 1.0, 0.2]).mesh(&["B"], |_| 0, |_, _| false);
    let ratio = 1.35f64;
    let mut mesh = mapped(block, |x| {
        let angle = 0.5 * PI * x[1];
        let (c, n) = (if x[1] == 1.0 { 0.0 } else { angle.cos() }, angle.sin());
        // from the circle to the square, steps growing outward
        let t = (ratio.powf(x[0] * radial as f64) - 1.0) / (ratio.powi(14) - 1.0);
        let outer = if x[1] <= 0.5 {
            [w, w * angle.tan()]
        } else {
            [if c == 0.0 { 0.0 } else { w * c / n }, w]
        };
        let outer = if x[1] == 0.5 { [w, w] } else { outer };
        [a * c + t * (outer[0] - a * c), a * n + t * (outer[1] - a * n), x[2]]
    });
    let pulled: Vec<[u32; 3]> = crate::common::triangles_where(&mesh, |x| (x[0] - w).abs() < 1e-9);
    mesh.faces.push(bracket::mesh::NamedFaces { name: "PULLED".into(), triangles: pulled });
    let yaml = format!(
        "materials: {{s: {{E: 210000, nu: 0.3}}}}\nbodies: {{B: s}}\nsupports:\n- {{face: Y0, \
         fix: [y]}}\n- {{face: Y1, fix: [x]}}\n- {{face: Z0, fix: [z]}}\n- {{face: Z1, fix: \
         [z]}}\nloads:\n- {{face: PULLED, traction: [{s:?}, 0, 0]}}\n"
    );
    let solved = solve(&yaml, mesh);
    solved.strict("A29");
    let stress = solved.pass.stress.as_ref().unwrap();
    let mesh = &solved.model.mesh;
    let (mut sum, mut count) = (0.0, 0.0);
    for (e, t) in mesh.tets.iter().enumerate() {
        for (k, f) in bracket::mesh::tet::FACES.iter().enumerate() {
            for (p, &i) in f.iter().enumerate() {
                let x = mesh.nodes[t[i] as usize];
                if x[0].abs() < 1e-12 && (x[1] - a).abs() < 1e-12 {
                    sum += stress.points[e][k][p][0];
                    count += 1.0;
                }
            }
        }
    }
    let k = sum / count / s;
    println!("A29: K_t {k:.4} over {count} values");
    assert!((k / 3.032 - 1.0).abs() < 0.03, "K_t {k}");
}
