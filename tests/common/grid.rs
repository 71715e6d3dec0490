//! Bodies cut from a structured grid of unequal planes: slices, punches, T-stubs.

use super::{Random, mirrored};
use bracket::mesh::{NamedFaces, TetMesh, tet};

/// Planes of the grid along x, y, z, ascending. Every cell of a body becomes six tets
/// ([`mirrored`]).
pub struct Grid {
    pub planes: [Vec<f64>; 3],
    /// Index of a node from which diagonals run in all directions, in each direction 0 or 1.
    pub phase: [usize; 3],
    /// Inner nodes move by up to this fraction of the smaller neighbouring cell.
    pub jitter: f64,
    pub seed: u64,
}

/// Ascending planes from `from` to `to`. The step at `to` is the finest and has the size `first`.
pub fn finer_at_end(from: f64, to: f64, first: f64, ratio: f64) -> Vec<f64> {
    let mut planes: Vec<f64> =
        super::graded(first, 1, ratio, to - from).iter().map(|d| to - d).collect();
    planes.reverse();
    planes[0] = from;
    planes
}

/// Ascending planes from `from` to `to`. The step at `from` is the finest and has the size `first`.
pub fn finer_at_start(from: f64, to: f64, first: f64, ratio: f64) -> Vec<f64> {
    let mut planes: Vec<f64> =
        super::graded(first, 1, ratio, to - from).iter().map(|d| from + d).collect();
    *planes.last_mut().unwrap() = to;
    planes
}

/// Joins lists of planes. Each list starts where the previous one ends.
pub fn joined(parts: &[Vec<f64>]) -> Vec<f64> {
    let mut all: Vec<f64> = Vec::new();
    for part in parts {
        let again = all.last().is_some_and(|last| (last - part[0]).abs() < 1e-9);
        all.extend(&part[usize::from(again)..]);
    }
    all
}

/// `n` equal steps.
pub fn even(from: f64, to: f64, n: usize) -> Vec<f64> {
    (0..=n).map(|i| if i == n { to } else { from + (to - from) * i as f64 / n as f64 }).collect()
}

impl Grid {
    pub fn new(planes: [Vec<f64>; 3]) -> Self {
        Self { planes, phase: [0; 3], jitter: 0.0, seed: 1 }
    }

    /// Diagonals run in all directions from this node and from every second one.
    pub fn phase(mut self, phase: [usize; 3]) -> Self {
        self.phase = phase;
        self
    }

    pub fn jittered(mut self, jitter: f64, seed: u64) -> Self {
        (self.jitter, self.seed) = (jitter, seed);
        self
    }

    /// Makes the mesh. `body(centre)` gives the body of each cell, or none for an empty cell.
    /// `flat(axis, coordinate)` selects planes that must stay flat. Faces between bodies and outer
    /// faces stay unchanged.
    pub fn mesh(
        &self,
        bodies: &[&str],
        body: impl Fn([f64; 3]) -> Option<usize>,
        flat: impl Fn(usize, f64) -> bool,
    ) -> TetMesh {
        let cells: [usize; 3] = std::array::from_fn(|d| self.planes[d].len() - 1);
        let of = |at: [isize; 3]| -> Option<usize> {
            let inside = (0..3).all(|d| at[d] >= 0 && at[d] < cells[d] as isize);
            let centre = |d: usize| {
                0.5 * (self.planes[d][at[d] as usize] + self.planes[d][at[d] as usize + 1])
            };
            if inside { body([centre(0), centre(1), centre(2)]) } else { None }
        };
        let id = |i: usize, j: usize, k: usize| i + (cells[0] + 1) * (j + (cells[1] + 1) * k);
        let mut random = Random::new(self.seed);
        let mut nodes = Vec::new();
        for k in 0..=cells[2] {
            for j in 0..=cells[1] {
                for i in 0..=cells[0] {
                    let at = [i, j, k];
                    nodes.push(std::array::from_fn(|d| {
                        let p = &self.planes[d];
                        let x = p[at[d]];
                        let r = 2.0 * random.unit() - 1.0;
                        let same = |n: usize| {
                            let (a, b) = ((d + 1) % 3, (d + 2) % 3);
                            let mut cell = at.map(|c| c as isize);
                            cell[a] -= (n % 2) as isize;
                            cell[b] -= (n / 2) as isize;
                            let above = of(cell);
                            cell[d] -= 1;
                            of(cell) == above
                        };
                        let edge = at[d] == 0 || at[d] == cells[d];
                        if edge || flat(d, x) || !(0..4).all(same) {
                            return x;
                        }
                        let h = (p[at[d]] - p[at[d] - 1]).min(p[at[d] + 1] - p[at[d]]);
                        x + self.jitter * h * r
                    }));
                }
            }
        }
        let mut mesh = TetMesh {
            nodes,
            bodies: bodies.iter().map(|b| b.to_string()).collect(),
            ..TetMesh::default()
        };
        for k in 0..cells[2] {
            for j in 0..cells[1] {
                for i in 0..cells[0] {
                    let Some(body) = of([i as isize, j as isize, k as isize]) else { continue };
                    for t in mirrored::tets([i, j, k], self.phase) {
                        mesh.tets.push(t.map(|[i, j, k]| id(i, j, k) as u32));
                        mesh.tet_body.push(body as u32);
                    }
                }
            }
        }
        drop_unused(&mut mesh);
        mesh
    }
}

/// Removes nodes that belong to no tet.
fn drop_unused(mesh: &mut TetMesh) {
    let mut number = vec![u32::MAX; mesh.nodes.len()];
    let mut kept = Vec::new();
    for t in &mut mesh.tets {
        for n in t {
            let new = &mut number[*n as usize];
            if *new == u32::MAX {
                *new = kept.len() as u32;
                kept.push(mesh.nodes[*n as usize]);
            }
            *n = *new;
        }
    }
    mesh.nodes = kept;
}

/// Names the faces of a body whose three corners satisfy `inside`. There must be at least one.
pub fn name(mesh: &mut TetMesh, name: &str, body: &str, inside: impl Fn([f64; 3]) -> bool) {
    let body = mesh.bodies.iter().position(|b| b == body).unwrap() as u32;
    let mut triangles = Vec::new();
    for (t, _) in mesh.tets.iter().zip(&mesh.tet_body).filter(|(_, b)| **b == body) {
        for f in tet::FACES {
            let corners = f.map(|i| t[i]);
            if corners.iter().all(|&n| inside(mesh.nodes[n as usize])) {
                triangles.push(corners);
            }
        }
    }
    assert!(!triangles.is_empty(), "no face of {name}");
    mesh.faces.push(NamedFaces { name: name.into(), triangles });
}
