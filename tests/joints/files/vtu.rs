//! Compares our `.vtu` files with an independent reader, meshio.

use bracket::mesh::tet::EDGES;
use bracket::result::fields::vtu::{QUADRATIC_TETRA, TETRA, VtuGrid};
use std::path::{Path, PathBuf};
use std::process::Command;

/// The Python of the project, or the one named by `BRACKET_TEST_PYTHON`.
fn python() -> PathBuf {
    match std::env::var_os("BRACKET_TEST_PYTHON") {
        Some(python) => python.into(),
        None => Path::new(env!("CARGO_MANIFEST_DIR")).join(".venv/bin/python"),
    }
}

fn grid(cell_type: u8) -> VtuGrid {
    let mut points = vec![[0.0; 3], [1.0, 0.1, 0.0], [0.2, 1.0, 0.0], [0.1, 0.3, 1.0]];
    let mut cells = vec![0, 1, 2, 3];
    if cell_type == QUADRATIC_TETRA {
        for [a, b] in EDGES {
            cells.push(points.len() as u32);
            let (p, q) = (points[a], points[b]);
            points.push([0, 1, 2].map(|k| 0.5 * (p[k] + q[k])));
        }
    }
    let n = points.len();
    VtuGrid {
        points,
        cells,
        cell_type,
        point_data: vec![
            ("displacement".into(), 3, (0..3 * n).map(|i| (i as f64 + 0.5).ln()).collect()),
            ("p & <q>".into(), 1, (0..n).map(|i| 1.0 / (i as f64 + 3.0)).collect()),
        ],
        cell_data: vec![(
            "stress".into(),
            6,
            (0..6).map(|i| -1e5 / (f64::from(i) + 7.0)).collect(),
        )],
        field_data: vec![("bound".into(), 1, vec![-330_696.123_456_789])],
    }
}

/// All doubles as hexadecimal bits, one array per line, so that rounding cannot hide a difference.
fn listing(grid: &VtuGrid) -> String {
    let bits = |values: &[f64]| {
        values.iter().map(|v| format!("{:016x}", v.to_bits())).collect::<Vec<_>>().join(" ")
    };
    let mut out = format!("points 3 {}\n", bits(grid.points.as_flattened()));
    let kind = if grid.cell_type == QUADRATIC_TETRA { "tetra10" } else { "tetra" };
    let nodes: Vec<String> = grid.cells.iter().map(u32::to_string).collect();
    out += &format!("cells {kind} {}\n", nodes.join(" "));
    for (word, arrays) in
        [("point", &grid.point_data), ("cell", &grid.cell_data), ("field", &grid.field_data)]
    {
        for (name, components, values) in arrays {
            out += &format!("{word} {name:?} {components} {}\n", bits(values));
        }
    }
    out
}

#[test]
fn meshio_reads_the_same_bits() {
    let python = python();
    let script = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/support/read_vtu.py");
    let folder = tempfile::tempdir().expect("temporary folder");
    for cell_type in [TETRA, QUADRATIC_TETRA] {
        let grid = grid(cell_type);
        let file = folder.path().join("fields.vtu");
        std::fs::write(&file, grid.to_bytes().expect("writes")).expect("writes");
        let run = Command::new(&python).arg(&script).arg(&file).output().unwrap_or_else(|e| {
            panic!(
                "cannot run `{}` ({e}): this test needs a Python with meshio 5.3.5; make `.venv` \
                 with `python3 -m venv .venv && .venv/bin/pip install meshio==5.3.5`, or name one \
                 in BRACKET_TEST_PYTHON",
                python.display()
            )
        });
        assert!(run.status.success(), "{}", String::from_utf8_lossy(&run.stderr));
        assert_eq!(String::from_utf8_lossy(&run.stdout), listing(&grid));
    }
}
