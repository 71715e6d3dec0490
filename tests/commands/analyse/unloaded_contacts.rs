//! A block that lies on a loaded one and carries nothing, by the compiled program: the folder has
//! strict bounds, and `bracket verify` confirms them.

use crate::bench::Bench;
use crate::bench::expect;
use crate::common::Block;
use crate::common::grid::name;
use bracket::mesh::msh_write;
use serde_json::Value;

const MODEL: &str = "\
mesh: m.msh
analysis: KIND
materials: {steel: {E: 210000, nu: 0.3, fy: 235}}
bodies: {BASE: steel, BLOCK: steel}
interfaces:
  - {between: [BLOCK, BASE], law: contact, LAW}
supports:
  - {face: Z0, fix: [x, y, z]}
loads:
  - {face: LOADED, traction: [-60, 5, 20]}
";

fn mesh() -> String {
    let block = Block::new([2, 2, 4], [10.0, 8.0, 12.0]).jittered(3);
    let mut mesh = block.mesh(
        &["BASE", "BLOCK"],
        |x| usize::from(x[2] > 6.0),
        |axis, x| axis == 2 && (x - 6.0).abs() < 1e-9,
    );
    name(&mut mesh, "LOADED", "BASE", |x| x[0] == 10.0);
    msh_write::text(&mesh)
}

#[test]
fn a_block_that_carries_nothing_costs_no_bound() {
    for kind in ["elastic", "elastoplastic", "limit"] {
        for law in ["mu: 0", "mu: 0.3, friction: associated", "mu: 0.3, friction: coulomb"] {
            let model = MODEL.replace("KIND", kind).replace("LAW", law);
            let bench = Bench::new().file("block.yaml", &model).file("m.msh", mesh());
            expect(&bench, &["analyse", "block.yaml", "-q"], 0);
            let result: Value =
                serde_json::from_str(&bench.read("block/result.json")).expect("JSON");
            let case = &result["cases"][0];
            assert_eq!(case["certificate"]["strict"], true, "{kind}, {law}: {case}");
            let [low, up] = ["lower", "upper"].map(|b| case[b].as_f64().expect("a bound"));
            assert!(low <= up, "{kind}, {law}: [{low}, {up}]");
            expect(&bench, &["verify", "block"], 0);
        }
    }
}
