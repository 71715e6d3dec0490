//! `bracket analyse` and `bracket verify` as the compiled program, on a mesh that the test makes:
//! the files they write, their limits, and interrupts.

#[path = "cli/adaptive.rs"]
mod adaptive;
#[path = "cli/bench.rs"]
mod bench;
#[path = "common/mod.rs"]
mod common;
#[path = "cli/coulomb.rs"]
mod coulomb;
#[path = "cli/forged_inputs.rs"]
mod forged_inputs;
#[path = "cli/forgeries.rs"]
mod forgeries;
#[cfg(unix)]
#[path = "cli/interrupts.rs"]
mod interrupts;
#[path = "cli/limit_analysis.rs"]
mod limit_analysis;
#[path = "cli/limit_verify.rs"]
mod limit_verify;
#[path = "cli/limits.rs"]
mod limits;
#[path = "cli/plastic_analysis.rs"]
mod plastic_analysis;
#[path = "cli/polygon.rs"]
mod polygon;
#[path = "cli/preload.rs"]
mod preload;
#[path = "cli/result_folder.rs"]
mod result_folder;
#[path = "cli/rigid_and_welds.rs"]
mod rigid_and_welds;
#[path = "cli/unloaded_contacts.rs"]
mod unloaded_contacts;
#[path = "cli/verdicts.rs"]
mod verdicts;
#[path = "cli/verify.rs"]
mod verify;

use bench::Bench;
use bracket::mesh::msh_write;
use common::Block;

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

/// Runs with an expected exit code; returns standard output and standard error.
pub fn expect(bench: &Bench, args: &[&str], code: i32) -> (String, String) {
    let run = bench.run(args);
    let [out, err] = [run.stdout, run.stderr].map(|b| String::from_utf8(b).expect("UTF-8"));
    assert_eq!(run.status.code(), Some(code), "{args:?}\n{out}\n{err}");
    (out, err)
}
