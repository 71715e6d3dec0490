//! A bolt (area 1) and a sleeve (area 4) of the same length side by side.

use super::{Block, beside, renamed, triangles_where};
use bracket::mesh::{NamedFaces, TetMesh};

/// Length of both \[mm\].
pub const L: f64 = 10.0;

/// The bodies `BOLT`, with its cut `CUT` at mid-length, and `SLEEVE`, or the half of both with x
/// from the middle of each; `share`: 1 or 0.5. Their feet are `BOLT_END` and `SLEEVE_END`, their
/// sides at least x `BX` and `SX`.
pub fn mesh(share: f64, seed: u64) -> TetMesh {
    let bolt = Block { cells: [1, 1, 4], min: [0.0; 3], max: [share, 1.0, L], jitter: 0.2, seed };
    let sleeve = Block {
        cells: [2, 2, 3],
        min: [3.0, 0.0, 0.0],
        max: [3.0 + 2.0 * share, 2.0, L],
        jitter: 0.2,
        seed: seed + 1,
    };
    let middle = |d: usize, x: f64| d == 2 && x == L / 2.0;
    let mut bolt = renamed(bolt.mesh(&["BOLT"], |_| 0, middle), "Z0", "BOLT_END");
    let triangles = triangles_where(&bolt, |x| x[2] == L / 2.0);
    bolt.faces.push(NamedFaces { name: "CUT".into(), triangles });
    let sleeve = renamed(sleeve.mesh(&["SLEEVE"], |_| 0, |_, _| false), "Z0", "SLEEVE_END");
    beside(renamed(bolt, "X0", "BX"), renamed(sleeve, "X0", "SX"))
}
