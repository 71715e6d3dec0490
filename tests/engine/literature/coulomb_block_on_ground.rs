//! B5: a block pressed by a dead load N and pushed along its base by T.
//!
//! ```text
//!        N (dead)
//!     v v v v v v
//!    [           ] <- T    (on the base's level on average: no overturning to speak of)
//!  ~~~~~~~~~~~~~~~~~~~     μ = 0.3, rigid ground or a lower block
//! ```
//! Source: C. A. Coulomb, Théorie des machines simples (1785): T ≤ μN, all that equilibrium asks
//! (associated friction has the same equilibrium set, and the fixed point for Coulomb's law begins
//! with it). Expected: 0.999 μN ends in a strict bracket, 1.001 μN is reported as having no
//! equilibrium by both programs, each naming the part that slides. No tolerance: the two loads lie
//! 0.1 % on either side of the limit.

use crate::common::Block;
use crate::common::solved::solve;

const MU: f64 = 0.3;
const N: f64 = 100.0 * 40.0;

fn loads(ratio: f64) -> String {
    // N as 100 MPa on 10 × 4, T as traction on X1, 4 × 2
    let t = ratio * MU * N / 8.0;
    format!(
        "dead:\n- {{face: Z1, traction: [0, 0, -100]}}\nloads:\n- {{face: X1, traction: [{:?}, 0, \
         0]}}\n",
        -t
    )
}

fn on_ground(ratio: f64, friction: &str, seed: u64) -> crate::common::solved::Solved {
    let mesh = Block::new([5, 2, 1], [10.0, 4.0, 2.0]).jittered(seed).mesh(
        &["BLOCK"],
        |_| 0,
        |_, _| false,
    );
    let yaml = format!(
        "materials: {{s: {{E: 210000, nu: 0.3}}}}\nbodies: {{BLOCK: s}}\nsupports:\n- {{face: Z0, \
         law: contact, mu: {MU}, friction: {friction}}}\n{}",
        loads(ratio)
    );
    solve(&yaml, mesh)
}

fn on_block(ratio: f64, friction: &str, seed: u64) -> crate::common::solved::Solved {
    // the upper block is the middle of the upper layer over its whole width, with the same faces
    // and a flat plane between the blocks
    let block =
        Block { cells: [5, 2, 2], min: [0.0, 0.0, -2.0], max: [10.0, 4.0, 2.0], jitter: 0.2, seed };
    let mesh =
        block.mesh(&["LOWER", "UPPER"], |c| usize::from(c[2] > 0.0), |d, x| d == 2 && x == 0.0);
    // T on the upper half of X1 only
    let mut mesh = mesh;
    let upper: Vec<[u32; 3]> = mesh.faces_named("X1").unwrap().triangles.clone();
    let upper =
        upper.into_iter().filter(|t| t.iter().all(|&n| mesh.nodes[n as usize][2] >= 0.0)).collect();
    mesh.faces.push(bracket::mesh::NamedFaces { name: "PUSH".into(), triangles: upper });
    let yaml = format!(
        "materials: {{s: {{E: 210000, nu: 0.3}}}}\nbodies: {{LOWER: s, UPPER: s}}\ninterfaces:\n- \
         {{between: [LOWER, UPPER], law: contact, mu: {MU}, friction: {friction}}}\nsupports:\n- \
         {{face: Z0, fix: [x, y, z]}}\n{}",
        loads(ratio).replace("X1", "PUSH")
    );
    solve(&yaml, mesh)
}

#[test]
fn b5_just_below_the_limit_there_is_equilibrium() {
    for seed in [1, 7, 42] {
        for friction in ["associated", "coulomb"] {
            on_ground(0.999, friction, seed).strict(&format!("B5 ground 0.999 {friction}"));
            on_block(0.999, friction, seed).strict(&format!("B5 block 0.999 {friction}"));
        }
    }
}

#[test]
fn b5_just_above_the_limit_there_is_none() {
    for seed in [1, 7, 42] {
        for friction in ["associated", "coulomb"] {
            let name = |on: &str| format!("B5 {on} 1.001 {friction}");
            on_ground(1.001, friction, seed)
                .no_equilibrium(&name("ground"), "part BLOCK moves along −x");
            on_block(1.001, friction, seed)
                .no_equilibrium(&name("block"), "part UPPER moves along −x");
        }
    }
}
