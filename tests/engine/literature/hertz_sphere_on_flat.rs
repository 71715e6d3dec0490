//! B1: Hertz, a sphere R = 100 pressed by 10 kN on a rigid flat.
//!
//! ```text
//!    F/4 on a rigid top, free along z        quarter block B × B × B, symmetry planes x = y = 0
//!   =====
//!   [   ]       the sphere's roundness is the initial gap (x² + y²) / 2R of a flat block
//!   ~~~~~  rigid ground, frictionless
//! ```
//! Source: H. Hertz, J. reine angew. Math. 92 (1882) 156–171; K. L. Johnson, Contact Mechanics
//! (1985), equations 4.22–4.24: E* = E/(1 − ν²), a = (3FR/4E*)^⅓ = 1.48125, p₀ = 3F/2πa² = 2176.13,
//! δ = a²/R = 0.0219410; potential energy of the half-space −⅗ F δ.
//!
//! The block is finite, so its far field adds a compliance D to δ. D is the same for every load
//! near the corner. It is measured without contact and against another known answer: under uniform
//! pressure on a square of side c, the mean settlement of a half-space is 2.973210/π · p c (1 −
//! ν²)/E (the mean of 1/r over the square; Love, Phil. Trans. R. Soc. A 228 (1929)). Then −Π = ⅗ F
//! δ + ½ F² D.
//! Tolerance: δ 1 %, a and p₀ 5 %: energies converge with the square of stresses.

use crate::common::solved::{Solved, solve_to};
use crate::common::{Block, graded, mapped};
use bracket::mesh::{NamedFaces, TetMesh};
use bracket::solve::SolveOptions;

const F: f64 = 1e4;
const R: f64 = 100.0;
const E: f64 = 210_000.0;
const NU: f64 = 0.3;

/// A block with planes at the given coordinates: `xy` in x and y, `z` in z.
fn block(xy: &[f64], z: &[f64]) -> TetMesh {
    let cells = [xy.len() - 1, xy.len() - 1, z.len() - 1];
    let mesh = Block::new(cells, cells.map(|n| n as f64)).mesh(&["B"], |_| 0, |_, _| false);
    mapped(mesh, |x| {
        [xy[x[0].round() as usize], xy[x[1].round() as usize], z[x[2].round() as usize]]
    })
}

fn quarter(law: &str, load: &str, top: f64) -> String {
    format!(
        "materials: {{s: {{E: {E:?}, nu: {NU}}}}}\nbodies: {{B: s}}\nsupports:\n- {{face: X0, \
         fix: [x]}}\n- {{face: Y0, fix: [y]}}\n{law}rigid:\n- {{face: Z1, components: [z], free: \
         [{}], force: [0, 0, {top:?}]}}\n{load}",
        if top == 0.0 { "" } else { "uz" }
    )
}

/// Additional compliance \[mm/N\] of the finite block compared with the half-space, for a force on
/// the whole block (four quarters).
fn extra_compliance(xy: &[f64], z: &[f64], square: f64) -> [f64; 2] {
    let mut mesh = block(xy, z);
    let patch =
        crate::common::triangles_where(&mesh, |x| x[2] == 0.0 && x[0] <= square && x[1] <= square);
    mesh.faces.push(NamedFaces { name: "PATCH".into(), triangles: patch });
    let p = 1000.0;
    let yaml = quarter("", &format!("loads:\n- {{face: PATCH, pressure: {p:?}}}\n"), 0.0);
    let s = solve_to(&yaml, mesh, &SolveOptions::default());
    let [lower, upper] = s.strict("settlement of a square");
    let (side, force) = (2.0 * square, p * 4.0 * square * square);
    let half_space = 2.973_210 / std::f64::consts::PI * p * side * (1.0 - NU * NU) / E;
    // four quarters: −Π = ½ F w
    [upper, lower].map(|e| (-8.0 * e / force - half_space) / force)
}

fn hertz(xy: &[f64], z: &[f64]) -> Solved {
    let k = 0.5 / R;
    let law = format!(
        "- {{face: Z0, law: contact, mu: 0, gap: {{quadratic: [0, 0, 0, 0, {k:?}, {k:?}, 0, 0, 0, \
         0]}}}}\n"
    );
    solve_to(&quarter(&law, "", -F / 4.0), block(xy, z), &SolveOptions::default())
}

/// Resultant, radius and peak of the contact pressure of the static field. The radius follows from
/// the mean distance, which is 3π/16 a under Hertz's pressure.
fn pressure(s: &Solved) -> (f64, f64, f64) {
    let mesh = &s.model.mesh;
    let (mut force, mut moment, mut peak) = (0.0, 0.0, 0.0f64);
    for f in &s.model.ground[0].faces {
        let nodes = bracket::mesh::tet::FACES[f.local as usize]
            .map(|i| mesh.tets[f.tet as usize][i] as usize);
        let x = nodes.map(|n| mesh.nodes[n]);
        let p: [f64; 3] = std::array::from_fn(|i| {
            -s.pass.stress.as_ref().unwrap().points[f.tet as usize][f.local as usize][i][2]
        });
        let area = 0.5
            * ((x[1][0] - x[0][0]) * (x[2][1] - x[0][1])
                - (x[2][0] - x[0][0]) * (x[1][1] - x[0][1]))
                .abs();
        for (l, w) in bracket::math::quadrature::TRIANGLE_4 {
            let at = |d: usize| (0..3).map(|i| l[i] * x[i][d]).sum::<f64>();
            let here: f64 = (0..3).map(|i| l[i] * p[i]).sum();
            force += w * area * here;
            moment += w * area * here * at(0).hypot(at(1));
        }
        peak = p.into_iter().fold(peak, f64::max);
    }
    (4.0 * force, moment / force * 16.0 / (3.0 * std::f64::consts::PI), peak)
}

fn check(xy: &[f64], z: &[f64], square: f64) {
    let extra = extra_compliance(xy, z, square);
    let s = hertz(xy, z);
    let [lower, upper] = s.strict("B1");
    let mean_extra = 0.5 * (extra[0] + extra[1]);
    let delta = [upper, lower].map(|e| (-4.0 * e - 0.5 * F * F * mean_extra) / (0.6 * F));
    let (force, a, p0) = pressure(&s);
    println!(
        "B1: D {extra:?} ({:.3e} of δ/F), δ in {delta:?}, F {force}, a {a}, p0 {p0}",
        mean_extra * F / 0.021_941
    );
    let mean = 0.5 * (delta[0] + delta[1]);
    println!(
        "B1: δ {mean} error {:+.3e}, a {:+.3e}, p0 {:+.3e}",
        mean / 0.021_941_0 - 1.0,
        a / 1.481_25 - 1.0,
        p0 / 2176.13 - 1.0
    );
    assert!((force / F - 1.0).abs() < 1e-8);
    assert!((mean / 0.021_941_0 - 1.0).abs() < 0.01, "δ {mean}");
    assert!((a / 1.481_25 - 1.0).abs() < 0.05, "a {a}");
    assert!((p0 / 2176.13 - 1.0).abs() < 0.05, "p0 {p0}");
}

#[test]
fn b1_hertz() {
    check(&graded(0.4, 4, 1.9, 15.0), &graded(0.5, 2, 1.8, 15.0), 1.6);
}
