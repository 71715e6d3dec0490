//! `bracket analyse` and `bracket verify` as the compiled program, on a mesh that the test makes:
//! the files they write, their limits, and interrupts.

mod adaptive;
mod combinations;
mod coulomb;
mod forged_inputs;
mod forgeries;
#[cfg(unix)]
mod interrupts;
mod limit_analysis;
mod limit_verify;
mod limits;
mod plastic_analysis;
mod polygon;
mod preload;
mod result_folder;
mod rigid_and_welds;
mod unloaded_contacts;
mod verdicts;
mod verify;

use crate::bench::Bench;
use crate::common::Block;
use bracket::mesh::msh_write;

/// A block on another one with friction, under an oblique load: contact, friction, two bodies, 144
/// tets.
pub const MODEL: &str = "\
mesh: m.msh
analysis: elastic
materials: {steel: {E: 210000, nu: 0.3}}
bodies: {BASE: steel, BLOCK: steel}
interfaces:
  - {between: [BLOCK, BASE], law: contact, mu: 0.3, friction: associated}
supports:
  - {face: Z0, fix: [x, y, z]}
loads:
  - {face: Z1, traction: [2, 0, -40]}
";

/// The mesh of [`MODEL`], `height` mm high.
pub fn mesh(height: f64) -> String {
    mesh_of([2, 2, 6], height)
}

/// [`MODEL`] with a gap that closes. A large sideways push keeps the joint open at one edge.
pub fn opening() -> String {
    MODEL.replace("[2, 0, -40]", "[4, 0, -40]").replace("associated}", "associated, gap: 0.001}")
}

/// The same mesh with `cells` along each side; the number in height must be even.
pub fn mesh_of(cells: [usize; 3], height: f64) -> String {
    let block = Block::new(cells, [20.0, 20.0, height]).jittered(3);
    let joint = height / 2.0;
    let mesh = block.mesh(
        &["BASE", "BLOCK"],
        |x| usize::from(x[2] > joint),
        |axis, x| axis == 2 && (x - joint).abs() < 1e-9,
    );
    msh_write::text(&mesh)
}

/// A folder with model and mesh.
pub fn bench(model: &str) -> Bench {
    Bench::new().file("block.yaml", model).file("m.msh", mesh(60.0))
}
