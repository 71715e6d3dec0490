//! Meshes and models for tests.
#![allow(dead_code, missing_docs, clippy::unwrap_used)]

pub mod bolt_in_sleeve;
pub mod grid;
pub mod limit;
pub mod mirrored;
pub mod oracle;
pub mod plane_strain;
pub mod plastic;
pub mod points;
pub mod prism;
pub mod solved;
pub mod t_stub;
pub mod yielding;

use bracket::mesh::{NamedFaces, TetMesh};

/// A structured block of tets (six per cell), interior nodes jittered by `jitter` × cell size.
pub struct Block {
    pub cells: [usize; 3],
    pub min: [f64; 3],
    pub max: [f64; 3],
    pub jitter: f64,
    pub seed: u64,
}

impl Block {
    pub fn new(cells: [usize; 3], max: [f64; 3]) -> Self {
        Self { cells, min: [0.0; 3], max, jitter: 0.0, seed: 1 }
    }

    pub fn jittered(mut self, seed: u64) -> Self {
        self.jitter = 0.2;
        self.seed = seed;
        self
    }

    /// Makes the mesh. `body(centre)` gives the body of each cell; `flat(axis, coordinate)` selects
    /// planes that must stay flat.
    pub fn mesh(
        &self,
        bodies: &[&str],
        body: impl Fn([f64; 3]) -> usize,
        flat: impl Fn(usize, f64) -> bool,
    ) -> TetMesh {
        let [nx, ny, nz] = self.cells;
        let h: [f64; 3] =
            std::array::from_fn(|d| (self.max[d] - self.min[d]) / self.cells[d] as f64);
        let id = |i: usize, j: usize, k: usize| (i + (nx + 1) * (j + (ny + 1) * k)) as u32;
        let mut state = self.seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) | 1;
        let mut random = || {
            state ^= state << 13;
            state ^= state >> 7;
            state ^= state << 17;
            (state >> 11) as f64 / (1u64 << 53) as f64 - 0.5
        };
        let mut nodes = Vec::new();
        for k in 0..=nz {
            for j in 0..=ny {
                for i in 0..=nx {
                    let at = [i, j, k];
                    nodes.push(std::array::from_fn(|d| {
                        let last = at[d] == self.cells[d];
                        let x = if last { self.max[d] } else { self.min[d] + h[d] * at[d] as f64 };
                        let fixed = at[d] == 0 || at[d] == self.cells[d] || flat(d, x);
                        let r = random();
                        if fixed { x } else { x + 2.0 * self.jitter * h[d] * r }
                    }));
                }
            }
        }
        let mut tets = Vec::new();
        let mut tet_body = Vec::new();
        for k in 0..nz {
            for j in 0..ny {
                for i in 0..nx {
                    let c = |a: usize, b: usize, c: usize| id(i + a, j + b, k + c);
                    let centre: [f64; 3] =
                        std::array::from_fn(|d| self.min[d] + h[d] * ([i, j, k][d] as f64 + 0.5));
                    for path in [[0, 1, 2], [1, 2, 0], [2, 0, 1], [0, 2, 1], [2, 1, 0], [1, 0, 2]] {
                        let mut at = [0; 3];
                        let mut t = [c(0, 0, 0); 4];
                        for (n, &d) in path.iter().enumerate() {
                            at[d] = 1;
                            t[n + 1] = c(at[0], at[1], at[2]);
                        }
                        if [[0, 2, 1], [2, 1, 0], [1, 0, 2]].contains(&path) {
                            t.swap(1, 2);
                        }
                        tets.push(t);
                        tet_body.push(body(centre) as u32);
                    }
                }
            }
        }
        let mut mesh = TetMesh {
            nodes,
            tets,
            tet_body,
            tet_region: vec![],
            bodies: bodies.iter().map(|b| b.to_string()).collect(),
            faces: vec![],
        };
        let names = [["X0", "X1"], ["Y0", "Y1"], ["Z0", "Z1"]];
        for d in 0..3 {
            for (side, value) in [self.min[d], self.max[d]].into_iter().enumerate() {
                let triangles = triangles_where(&mesh, |x| x[d] == value);
                mesh.faces.push(NamedFaces { name: names[d][side].into(), triangles });
            }
        }
        mesh
    }
}

/// All tet faces whose corners satisfy `inside`, each face once.
pub fn triangles_where(mesh: &TetMesh, inside: impl Fn([f64; 3]) -> bool) -> Vec<[u32; 3]> {
    let mut out = Vec::new();
    for t in &mesh.tets {
        for f in bracket::mesh::tet::FACES {
            let mut n = f.map(|i| t[i]);
            if n.iter().all(|&i| inside(mesh.nodes[i as usize])) {
                n.sort_unstable();
                out.push(n);
            }
        }
    }
    out.sort_unstable();
    out.dedup();
    out
}

/// Planes of a structured grid from 0: `n` steps of size `first`, then steps that grow by `ratio`
/// up to `end`.
pub fn graded(first: f64, n: usize, ratio: f64, end: f64) -> Vec<f64> {
    let mut planes: Vec<f64> = (0..=n).map(|i| first * i as f64).collect();
    let start = first * n as f64;
    // takes the nearest number of growing steps and scales them to end exactly at `end`
    let mut steps = vec![first * ratio];
    while steps.iter().sum::<f64>() < end - start {
        steps.push(steps[steps.len() - 1] * ratio);
    }
    let scale = (end - start) / steps.iter().sum::<f64>();
    let mut at = start;
    for s in &steps {
        at += s * scale;
        planes.push(at);
    }
    if let Some(last) = planes.last_mut() {
        *last = end;
    }
    planes
}

/// Moves every node. Reorders the tets to which a mirroring map would give negative volume.
pub fn mapped(mut mesh: TetMesh, map: impl Fn([f64; 3]) -> [f64; 3]) -> TetMesh {
    mesh.nodes.iter_mut().for_each(|x| *x = map(*x));
    for e in 0..mesh.tets.len() {
        if mesh.volume(e) < 0.0 {
            mesh.tets[e].swap(2, 3);
        }
    }
    mesh
}

/// Two meshes side by side without common nodes. Faces with the same name are merged.
pub fn beside(mut a: TetMesh, b: TetMesh) -> TetMesh {
    let (nodes, bodies) = (a.nodes.len() as u32, a.bodies.len() as u32);
    a.nodes.extend(b.nodes);
    a.tets.extend(b.tets.iter().map(|t| t.map(|n| n + nodes)));
    a.tet_body.extend(b.tet_body.iter().map(|t| t + bodies));
    a.bodies.extend(b.bodies);
    for f in b.faces {
        let moved = f.triangles.iter().map(|t| t.map(|n| n + nodes));
        match a.faces.iter_mut().find(|g| g.name == f.name) {
            Some(g) => g.triangles.extend(moved),
            None => a.faces.push(NamedFaces { name: f.name, triangles: moved.collect() }),
        }
    }
    a
}

/// The mesh with its face `from` renamed to `to`.
pub fn renamed(mut mesh: TetMesh, from: &str, to: &str) -> TetMesh {
    mesh.faces.iter_mut().filter(|f| f.name == from).for_each(|f| f.name = to.into());
    mesh
}

/// A sequence of pseudorandom numbers in [0, 1), reproducible by its seed (xorshift).
pub struct Random(u64);

impl Random {
    pub fn new(seed: u64) -> Self {
        Self(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) | 1)
    }
    pub fn unit(&mut self) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 11) as f64 / (1u64 << 53) as f64
    }
    pub fn below(&mut self, n: usize) -> usize {
        ((self.unit() * n as f64) as usize).min(n - 1)
    }
    /// Barycentric coordinates of a uniformly distributed point in a simplex with N corners.
    pub fn simplex<const N: usize>(&mut self) -> [f64; N] {
        let w: [f64; N] = std::array::from_fn(|_| -(1.0 - self.unit()).ln() + 1e-12);
        let sum: f64 = w.iter().sum();
        w.map(|x| x / sum)
    }
}
