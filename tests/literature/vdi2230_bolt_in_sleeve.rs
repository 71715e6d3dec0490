//! B12 without preload: a bolt (area 1) and a sleeve (area 4) between rigid ends.
//!
//! ```text
//!        F (±)                    both tops follow one rigid plate, free along z only
//!    =============  rigid
//!    [s] [b] [s]                  bolt held to the ground, sleeve only standing on it
//!    ///-///-///                  ν = 0: prisms of constant stress
//! ```
//! Source: VDI 2230-1:2015, load factor of concentric clamping, Φ = δ_P / (δ_S + δ_P): with equal lengths and modulus,
//! Φ = 1 / (1 + 4) = 0.2. In compression the sleeve takes 0.8 F and Π = −F²L / (2 E 5); in tension the sleeve lifts, the
//! bolt works alone and Π = −F²L / (2 E 1): five times the slope.
//!
//! Tolerance of the energies 1e-8 relative: constant stress is in both spaces, the contact state is strictly open or strictly
//! closed. Of the forces 1e-6 F: an energy that is minimal is known twice as well (in digits) as the force at which it is.

use crate::common::solved::{Solved, solve_to};
use crate::common::{Block, beside, renamed};
use bracket::solve::SolveOptions;

const E: f64 = 200_000.0;
const L: f64 = 10.0;

fn run(force: f64, seed: u64) -> Solved {
    let bolt = Block { cells: [1, 1, 4], min: [0.0; 3], max: [1.0, 1.0, L], jitter: 0.2, seed };
    let sleeve = Block { cells: [2, 2, 3], min: [3.0, 0.0, 0.0], max: [5.0, 2.0, L], jitter: 0.2, seed: seed + 1 };
    let bolt = renamed(bolt.mesh(&["BOLT"], |_| 0, |_, _| false), "Z0", "BOLT_END");
    let sleeve = renamed(sleeve.mesh(&["SLEEVE"], |_| 0, |_, _| false), "Z0", "SLEEVE_END");
    let mesh = beside(renamed(bolt, "X0", "BX"), renamed(sleeve, "X0", "SX"));
    let yaml = format!(
        "materials: {{s: {{E: 200000, nu: 0}}}}\nbodies: {{BOLT: s, SLEEVE: s}}\nsupports:\n\
         - {{face: BOLT_END, fix: [z]}}\n- {{face: SLEEVE_END, law: contact, mu: 0}}\n\
         - {{face: BX, fix: [x]}}\n- {{face: SX, fix: [x]}}\n- {{face: Y0, fix: [y]}}\n\
         rigid:\n- {{face: Z1, components: [z], free: [uz], force: [0, 0, {force:?}]}}\n"
    );
    // an energy known to 1e-8 takes a gap below that
    solve_to(&yaml, mesh, &SolveOptions { gap: 1e-9, ..SolveOptions::default() })
}

/// Mean σ_zz of a body times its area \[N\].
fn axial_force(s: &Solved, body: u32, area: f64) -> f64 {
    let mesh = &s.model.mesh;
    let (mut sum, mut volume) = (0.0, 0.0);
    for e in (0..mesh.tets.len()).filter(|&e| mesh.tet_body[e] == body) {
        let points = &s.pass.stress.as_ref().unwrap().points[e];
        let mean: f64 = points.iter().flatten().map(|p| p[2] / 16.0).sum();
        sum += mean * mesh.volume(e);
        volume += mesh.volume(e);
    }
    area * sum / volume
}

#[test]
fn b12_in_compression_the_sleeve_takes_four_fifths() {
    for seed in [1, 7, 42] {
        let s = run(-1000.0, seed);
        s.exact("B12 compression", -1e6 * L / (2.0 * E * 5.0), 1e-8);
        let [bolt, sleeve] = [axial_force(&s, 0, 1.0), axial_force(&s, 1, 4.0)];
        println!("bolt {bolt}, sleeve {sleeve}");
        assert!((bolt + 200.0).abs() < 1e-3 && (sleeve + 800.0).abs() < 1e-3, "{bolt} {sleeve}");
    }
}

#[test]
fn b12_in_tension_the_bolt_works_alone() {
    for seed in [1, 7, 42] {
        let s = run(1000.0, seed);
        s.exact("B12 tension", -1e6 * L / (2.0 * E), 1e-8);
        let [bolt, sleeve] = [axial_force(&s, 0, 1.0), axial_force(&s, 1, 4.0)];
        println!("bolt {bolt}, sleeve {sleeve}");
        assert!((bolt - 1000.0).abs() < 1e-3 && sleeve.abs() < 1e-3, "{bolt} {sleeve}");
    }
}
