//! Meshes full of slivers with dihedral angles down to a twentieth of a degree, and contact faces
//! with triangles that are just as thin.
//!
//! ```text
//!    v v v v v v p
//!   [  slivers  ] <- t     inner nodes moved along random lines until a tet at them is nearly
//!   ------------- μ        flat; nodes of the contact plane the same way, within the plane
//!   [  slivers  ]
//!   /////////////
//! ```
//! Source: none for the mesh. Both spaces contain constant stress, p²V/2E, and self-weight (case
//! A9), b²AL³/6E, with ν = 0 on any mesh. The brackets of one body on any two meshes overlap.
//! Tolerance of the closed forms 1e-6: the conic solver stops at a relative gap of 1e-8, and the
//! rounding error grows with the inverse square of the angle (1e-16 / (8e-4)² = 1e-10). Overlap and
//! strictness are checked without tolerance.

use crate::common::solved::{resolve, solve};
use crate::common::{Block, Random};
use bracket::analysis::elastic;
use bracket::analysis::event::silent;
use bracket::analysis::pass::{PassError, PassOptions};
use bracket::mesh::TetMesh;
use bracket::mesh::quality::smallest_dihedral;
use bracket::model::ModelError;

const E: f64 = 210_000.0;
const TOP: f64 = 12.0;
const MIDDLE: f64 = 6.0;
const SIDE: f64 = 10.0;

/// Two stacked blocks of well-shaped tets.
fn blocks() -> TetMesh {
    Block::new([4, 4, 6], [SIDE, SIDE, TOP]).mesh(
        &["LOWER", "UPPER"],
        |c| usize::from(c[2] > MIDDLE),
        |d, x| d == 2 && x == MIDDLE,
    )
}

/// Moves inner nodes along random lines. Nodes inside the contact plane stay within it. A node
/// stops when the first of its tets has only the volume `least` \[mm³\].
fn slivered(mut mesh: TetMesh, least: f64, seed: u64) -> TetMesh {
    let mut random = Random::new(seed);
    let mut tets_at = vec![Vec::new(); mesh.nodes.len()];
    for (e, t) in mesh.tets.iter().enumerate() {
        t.iter().for_each(|n| tets_at[*n as usize].push(e));
    }
    for (node, around) in tets_at.iter().enumerate() {
        let x = mesh.nodes[node];
        let inside = |d: usize, end: f64| x[d] > 0.0 && x[d] < end;
        if !(inside(0, SIDE) && inside(1, SIDE) && inside(2, TOP)) {
            continue;
        }
        let mut line: [f64; 3] = std::array::from_fn(|_| 2.0 * random.unit() - 1.0);
        if x[2] == MIDDLE {
            line[2] = 0.0;
        }
        // the volume of a tet is linear in the position of one corner
        let volumes = |mesh: &TetMesh| around.iter().map(|e| mesh.volume(*e)).collect::<Vec<_>>();
        let before = volumes(&mesh);
        mesh.nodes[node] = std::array::from_fn(|d| x[d] + line[d]);
        let after = volumes(&mesh);
        let shrinks = before.iter().zip(&after).filter(|(b, a)| a < b);
        let far =
            shrinks.map(|(b, a)| (b - least) / (b - a)).fold(f64::INFINITY, f64::min).max(0.0);
        mesh.nodes[node] = std::array::from_fn(|d| x[d] + far * line[d]);
    }
    mesh
}

/// A mesh whose tets have at least the volume `least`. Checks that many of them are slivers, that
/// the worst angle is below `worst` degrees, and that all tets are valid.
fn bad(least: f64, worst: f64) -> TetMesh {
    let mesh = slivered(blocks(), least, 7);
    let angles: Vec<f64> =
        (0..mesh.tets.len()).map(|e| smallest_dihedral(&mesh.corners(e))).collect();
    let below = angles.iter().filter(|a| **a < 1.0).count();
    let smallest = angles.iter().copied().fold(f64::INFINITY, f64::min);
    println!("{below} of {} tets below 1°, the worst {smallest:.4}°", angles.len());
    assert!(smallest < worst && 20 * below > angles.len());
    assert!((0..mesh.tets.len()).all(|e| mesh.volume(e) > 0.99 * least));
    mesh
}

/// Two stacked blocks, the lower one held at its base. Without friction the upper one may slide if
/// no load pushes it.
fn model(nu: f64, mu: &str, loads: &str) -> String {
    format!(
        "materials: {{s: {{E: 210000, nu: {nu:?}}}}}\nbodies: {{LOWER: s, UPPER: \
         s}}\ninterfaces:\n- {{between: [LOWER, UPPER], law: contact, mu: {mu}}}\nsupports:\n- \
         {{face: Z0, fix: [x, y, z]}}\nloads:\n{loads}"
    )
}

#[test]
fn constant_stress_through_a_contact_of_slivers() {
    let mesh = bad(0.01, 0.05);
    let p = 100.0;
    for mu in ["0", "0.3, friction: associated"] {
        let yaml = model(0.0, mu, &format!("- {{face: Z1, pressure: {p:?}}}\n"));
        let exact = -p * p * SIDE * SIDE * TOP / (2.0 * E);
        solve(&yaml, mesh.clone()).exact(&format!("slivers, constant stress, μ {mu}"), exact, 1e-6);
    }
}

#[test]
fn weight_on_a_contact_of_slivers() {
    let mesh = bad(0.01, 0.05);
    let b = 10.0;
    let yaml = model(
        0.0,
        "0",
        &["LOWER", "UPPER"].map(|n| format!("- {{body: {n}, force: [0, 0, {:?}]}}\n", -b)).concat(),
    );
    // the contact transfers the load above it, so the energy is that without contact, b²AL³/6E
    solve(&yaml, mesh).exact(
        "slivers, weight",
        -b * b * SIDE * SIDE * TOP.powi(3) / (6.0 * E),
        1e-6,
    );
}

#[test]
fn brackets_on_slivers_and_on_good_tets_overlap() {
    let mesh = bad(0.01, 0.05);
    for (mu, push) in [("0.3, friction: associated", -15.0), ("0", 0.0)] {
        // a pull at x = 0 that changes into pressure, and a push: the contact opens along the edge
        let growing = format!(
            "{{traction0: [{push:?}, 0, 40], gradient: [[0, 0, 0], [0, 0, 0], [-20, 0, 0]]}}"
        );
        let yaml = model(0.3, mu, &format!("- {{face: Z1, linear: {growing}}}\n"));
        let good = solve(&yaml, blocks()).strict(&format!("good tets, μ {mu}"));
        let on_slivers = solve(&yaml, mesh.clone());
        let bad = on_slivers.strict(&format!("slivers, μ {mu}"));
        let gap = on_slivers.pass.upper.as_ref().unwrap().certificate().largest_gap.unwrap();
        assert!(gap > 1e-4, "the contact stays closed: {gap}");
        assert!(bad[0] <= good[1] && good[0] <= bad[1], "{bad:?} against {good:?}");
    }
}

#[test]
fn tets_too_flat_for_a_number_are_named() {
    let mesh = bad(0.001, 0.005);
    let yaml = model(0.3, "0", "- {face: Z1, pressure: 100}\n");
    let model = resolve(&yaml, mesh.clone()).unwrap();
    let Err(e) = elastic::run(&model, &PassOptions::default(), &silent()) else {
        panic!("a result")
    };
    println!("{e}");
    let PassError::Model(ModelError::FlatTet { tet, .. }) = e else { panic!("{e:?}") };
    assert!(smallest_dihedral(&mesh.corners(tet)) < 0.05);
}
