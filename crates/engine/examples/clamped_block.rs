//! Brackets the limit load of a block 5 × 2 × 1 mm: clamped at x = 0, pulled down at x = 5.
//!
//! `cargo run --release -p bracket-engine --example clamped_block`

use bracket_engine::analysis::{event::silent, limit, pass::PassOptions};
use bracket_engine::mesh::topology::{FaceTable, face_nodes};
use bracket_engine::mesh::{NamedFaces, TetMesh};
use bracket_engine::model::resolve::resolve;

/// Cells of 1/2 mm along x, y, z.
const CELLS: [u32; 3] = [10, 4, 2];

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let model = serde_json::from_value(serde_json::json!({
        "mesh": "", "analysis": "limit",
        "materials": { "steel": { "E": 210_000.0, "nu": 0.3, "fy": 235.0 } },
        "bodies": { "BLOCK": "steel" },
        "supports": [{ "face": "CLAMPED", "fix": ["x", "y", "z"] }],
        "loads": [{ "face": "PULLED", "traction": [0.0, 0.0, -1.0] }],
    }))?;
    let model = resolve(&model, block(), &|_| Default::default())?;
    let pass = limit::run(&model, &PassOptions::default(), &silent())?;
    // both bounds are computed from the fields alone, whatever the solver claims
    let bracket = pass.bracket.ok_or("no bracket")?;
    let [lower, upper] = [bracket.lower().value(), bracket.upper().value()];
    println!(
        "{} tets: the block carries at least {lower:.2} MPa, at most {upper:.2} MPa",
        model.mesh.tets.len()
    );
    Ok(())
}

/// The mesh: every cell becomes six tets, one for each way along its edges from corner to corner.
fn block() -> TetMesh {
    let [nx, ny, nz] = CELLS;
    let node = |p: [u32; 3]| (p[0] * (ny + 1) + p[1]) * (nz + 1) + p[2];
    let mut mesh = TetMesh { bodies: vec!["BLOCK".into()], ..TetMesh::default() };
    let grid = |n: [u32; 3]| {
        let rows = (0..n[0]).flat_map(move |i| (0..n[1]).map(move |j| [i, j]));
        rows.flat_map(move |[i, j]| (0..n[2]).map(move |k| [i, j, k]))
    };
    mesh.nodes = grid([nx + 1, ny + 1, nz + 1]).map(|p| p.map(|i| 0.5 * f64::from(i))).collect();
    for cell in grid(CELLS) {
        for (turn, order) in [[0, 1, 2], [1, 2, 0], [2, 0, 1], [0, 2, 1], [2, 1, 0], [1, 0, 2]]
            .into_iter()
            .enumerate()
        {
            let mut corner = cell;
            let mut tet = [node(cell); 4];
            for (vertex, axis) in order.into_iter().enumerate() {
                corner[axis] += 1;
                tet[vertex + 1] = node(corner);
            }
            // odd permutations of the axes turn the tet inside out
            if turn >= 3 {
                tet.swap(2, 3);
            }
            mesh.tets.push(tet);
            mesh.tet_body.push(0);
        }
    }
    for (name, x) in [("CLAMPED", 0.0), ("PULLED", 5.0)] {
        let table = FaceTable::new(&mesh.tets);
        let triangles =
            table.faces().map(|f| face_nodes(&mesh.tets[f[0].tet as usize], f[0].local));
        let there = triangles.filter(|t| t.iter().all(|n| mesh.nodes[*n as usize][0] == x));
        let faces = NamedFaces { name: name.into(), triangles: there.collect() };
        mesh.faces.push(faces);
    }
    mesh
}
