//! B12: a bolt (area 1) and a sleeve (area 4) between rigid ends, without and with preload.
//!
//! ```text
//!        F (±)                    both tops follow one rigid plate, free along z only
//!    =============  rigid
//!    [s] [b] [s]                  bolt held to the ground, sleeve only standing on it
//!    ///-///-///                  ν = 0: prisms of constant stress
//! ```
//! Source: VDI 2230-1:2015, load factor of concentric clamping, Φ = δ_P / (δ_S + δ_P): with equal
//! lengths and modulus, Φ = 1 / (1 + 4) = 0.2. In compression the sleeve takes 0.8 F and Π = −F²L /
//! (2 E 5); in tension the sleeve lifts, the bolt works alone and Π = −F²L / (2 E 1): five times
//! the slope.
//!
//! Tolerance of the energies 1e-8 relative: both spaces contain constant stress, and the contact is
//! clearly open or clearly closed. With a preload F_p a closure δ = F_p (L/E)(1 + 1/4) of a cut in
//! the shank stays, and `Π(u) = ½ k_b (u + δ)² + ½ k_s min(u, 0)² − F u`: the bolt carries F_p +
//! 0.2 F until the sleeve lifts at F = F_p / 0.8, and F alone afterwards.
//!
//! Tolerance of the forces 1e-6 F: near its minimum an energy is known to twice as many digits as
//! the force at which it is minimal.

use crate::common::bolt_in_sleeve::{L, mesh};
use crate::common::solved::{Solved, solve_to};
use bracket::solve::{SolveOptions, StopRules};

const E: f64 = 200_000.0;

fn run(force: f64, seed: u64) -> Solved {
    run_preloaded(force, None, seed)
}

/// Runs the model with a force on the top and an optional preload of the bolt.
fn run_preloaded(force: f64, preload: Option<f64>, seed: u64) -> Solved {
    let yaml = format!(
        "materials: {{s: {{E: 200000, nu: 0}}}}\nbodies: {{BOLT: s, SLEEVE: s}}\nsupports:\n- \
         {{face: BOLT_END, fix: [z]}}\n- {{face: SLEEVE_END, law: contact, mu: 0}}\n- {{face: BX, \
         fix: [x]}}\n- {{face: SX, fix: [x]}}\n- {{face: Y0, fix: [y]}}\nrigid:\n- {{face: Z1, \
         components: [z], free: [uz], force: [0, 0, {force:?}]}}\n"
    );
    // the axis may point either way
    let axis = if seed.is_multiple_of(2) { "[0, 0, 1]" } else { "[0, 0, -1]" };
    let bolts = preload.map_or(String::new(), |f| {
        format!("preload:\n- {{body: BOLT, cut: CUT, axis: {axis}, force: {f:?}}}\n")
    });
    // an energy accurate to 1e-8 needs a smaller gap
    solve_to(
        &(yaml + &bolts),
        mesh(1.0, seed),
        &SolveOptions::default().with(StopRules::to_gap(1e-11)),
    )
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

const KB: f64 = E / L;

/// Energy, displacement of the top and tension of the bolt under `force`, with the closure that
/// results from `preload`.
fn preloaded(force: f64, preload: f64) -> [f64; 3] {
    let closure = preload * (1.0 / KB + 1.0 / (4.0 * KB));
    let closed = (force - KB * closure) / (5.0 * KB);
    let u = if closed <= 0.0 { closed } else { force / KB - closure };
    let sleeve = 0.5 * 4.0 * KB * u.min(0.0).powi(2);
    [0.5 * KB * (u + closure).powi(2) + sleeve - force * u, u, KB * (u + closure)]
}

/// Displacement of the rigid top along z \[mm\].
fn top(s: &Solved) -> f64 {
    let face = s.model.rigid[0].faces[0];
    let node =
        s.model.mesh.tets[face.tet as usize][bracket::mesh::tet::FACES[face.local as usize][0]];
    s.pass.displacement.as_ref().unwrap().u[node as usize][2]
}

#[test]
fn b12_the_preloaded_bolt_takes_a_fifth_until_the_sleeve_lifts_at_five_quarters() {
    const FP: f64 = 800.0;
    for seed in [1, 8, 42] {
        let mut tops = Vec::new();
        for factor in [0.0, 0.5, 1.2, 1.3, 2.0] {
            let force = factor * FP;
            let s = run_preloaded(force, Some(FP), seed);
            let [energy, u, tension] = preloaded(force, FP);
            let name = format!("B12 preload, F = {factor} F_p");
            s.exact(&name, energy, 1e-8);
            let bolt = &s.pass.preload[0];
            println!("{name}: {bolt:?}, sleeve {}", axial_force(&s, 1, 4.0));
            assert!(
                (bolt.closure - FP * 1.25 / KB).abs() < 1e-8 * bolt.closure,
                "{name}: {bolt:?}"
            );
            assert!(
                (bolt.tension.unwrap() - tension).abs() < 1e-6 * FP,
                "{name}: {bolt:?} against {tension}"
            );
            assert!((axial_force(&s, 0, 1.0) - tension).abs() < 1e-6 * FP, "{name}");
            assert!((top(&s) - u).abs() < 1e-6 * FP / KB, "{name}: {} against {u}", top(&s));
            // the sleeve carries the difference between bolt force and load, and nothing after it
            // has lifted
            let sleeve = (force - tension).min(0.0);
            assert!((axial_force(&s, 1, 4.0) - sleeve).abs() < 1e-6 * FP, "{name}");
            tops.push(top(&s));
        }
        let slopes = [(tops[1] - tops[0]) / 0.5, (tops[4] - tops[3]) / 0.7];
        assert!((slopes[1] / slopes[0] - 5.0).abs() < 1e-4, "{slopes:?}");
    }
}
