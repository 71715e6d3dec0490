//! A structured mesh of a triangle times layers: triangular prisms and octants of spheres.
//!
//! The diagonals on the sides of a prism run from the corner of lower colour to that of higher
//! colour, with three colours so that no edge joins two equal ones. Layers are mirror images of each
//! other.

use bracket::math::vec3::{cross, dot, sub};
use bracket::mesh::{NamedFaces, TetMesh};
use std::f64::consts::PI;

/// `n` segments along each side of the triangle, `layers` layers.
pub struct Prism {
    pub n: usize,
    pub layers: usize,
}

impl Prism {
    /// The mesh. `map(barycentric, t)` gives the node positions, with t from 0 to 1 through the
    /// layers.
    ///
    /// Faces S0, S1, S2 lie opposite the corners of the triangle. BOTTOM is at t = 0, TOP at t = 1.
    /// The one body is called `B`.
    pub fn mesh(&self, map: impl Fn([f64; 3], f64) -> [f64; 3]) -> TetMesh {
        let n = self.n;
        let flat: Vec<[usize; 2]> =
            (0..=n).flat_map(|i| (0..=n - i).map(move |j| [i, j])).collect();
        let index = |i: usize, j: usize| flat.iter().position(|p| *p == [i, j]).unwrap();
        let mut triangles = Vec::new();
        for i in 0..n {
            for j in 0..n - i {
                triangles.push([index(i, j), index(i + 1, j), index(i, j + 1)]);
                if i + j + 2 <= n {
                    triangles.push([index(i + 1, j), index(i + 1, j + 1), index(i, j + 1)]);
                }
            }
        }
        let per = flat.len();
        let mut mesh = TetMesh { bodies: vec!["B".into()], ..TetMesh::default() };
        for k in 0..=self.layers {
            for [i, j] in &flat {
                let (a, b) = (*i as f64 / n as f64, *j as f64 / n as f64);
                mesh.nodes.push(map(
                    [a, b, (n - i - j) as f64 / n as f64],
                    k as f64 / self.layers as f64,
                ));
            }
        }
        for k in 0..self.layers {
            for t in &triangles {
                // one order of the colours makes the diagonals of neighbouring prisms agree
                let mut s = *t;
                s.sort_unstable_by_key(|&c| (flat[c][0] + 2 * flat[c][1]) % 3);
                if k % 2 == 1 {
                    s.reverse();
                }
                let low = s.map(|c| (k * per + c) as u32);
                let high = s.map(|c| ((k + 1) * per + c) as u32);
                mesh.tets.push([low[0], low[1], low[2], high[2]]);
                mesh.tets.push([low[0], low[1], high[1], high[2]]);
                mesh.tets.push([low[0], high[0], high[1], high[2]]);
            }
        }
        mesh.tet_body = vec![0; mesh.tets.len()];
        for e in 0..mesh.tets.len() {
            if mesh.volume(e) < 0.0 {
                mesh.tets[e].swap(2, 3);
            }
        }
        let on = |name: &str, inside: &dyn Fn(usize, usize) -> bool| {
            let mut triangles = Vec::new();
            for t in &mesh.tets {
                for f in bracket::mesh::tet::FACES {
                    let v = f.map(|i| t[i]);
                    if v.iter().all(|&v| inside(v as usize % per, v as usize / per)) {
                        triangles.push(v);
                    }
                }
            }
            NamedFaces { name: name.into(), triangles }
        };
        mesh.faces = vec![
            on("S0", &|p, _| flat[p][0] == 0),
            on("S1", &|p, _| flat[p][1] == 0),
            on("S2", &|p, _| flat[p][0] + flat[p][1] == n),
            on("BOTTOM", &|_, k| k == 0),
            on("TOP", &|_, k| k == self.layers),
        ];
        mesh
    }
}

/// The point with barycentric coordinates `l` on a polyhedron inscribed in an octant of the unit
/// sphere. Each quarter circle has `n` segments of equal angle.
pub fn facetted_direction(l: [f64; 3], n: usize) -> [f64; 3] {
    let vertex = |v: [f64; 3]| {
        let v = v.map(|c| (0.5 * PI * c / n as f64).sin());
        let size = v.iter().map(|c| c * c).sum::<f64>().sqrt();
        v.map(|c| c / size)
    };
    let s = l.map(|c| c * n as f64);
    let k = s.map(|c| (c + 1e-9).floor());
    let f: [f64; 3] = std::array::from_fn(|d| (s[d] - k[d]).max(0.0));
    let sum: f64 = f.iter().sum();
    if sum < 0.5 {
        return vertex(k);
    }
    let up = sum < 1.5;
    let mut x = [0.0; 3];
    for d in 0..3 {
        // the corners are k + e_d for an upward triangle and k + 1 − e_d for a downward one
        let corner = vertex(std::array::from_fn(|i| k[i] + f64::from(u8::from((i == d) == up))));
        let w = if up { f[d] } else { 1.0 - f[d] };
        (0..3).for_each(|i| x[i] += w * corner[i]);
    }
    x
}

/// The radius for which the polyhedron of [`facetted_direction`] has the volume of the unit ball.
///
/// The strain energy density of a hollow sphere is uniform on each of its surfaces. To first order
/// in the depth of the facets, its energy therefore changes only with the volumes of the two
/// surfaces.
pub fn radius_of_equal_volume(n: usize) -> f64 {
    let shell = Prism { n, layers: 1 }.mesh(|l, t| facetted_direction(l, n).map(|c| (1.0 + t) * c));
    // between radii 1 and 2 lies seven times the volume of the octant of the polyhedron
    let volume: f64 = (0..shell.tets.len()).map(|e| shell.volume(e)).sum();
    (PI / 6.0 / (volume / 7.0)).cbrt()
}

/// Radius of the sphere inscribed in the polyhedron of [`facetted_direction`], rounded down
/// slightly.
pub fn inscribed_radius(n: usize) -> f64 {
    let shell = Prism { n, layers: 1 }.mesh(|l, t| facetted_direction(l, n).map(|c| (1.0 + t) * c));
    let bottom = shell.faces.iter().find(|f| f.name == "BOTTOM").unwrap();
    let distance = |t: &[u32; 3]| {
        let [a, b, c] = t.map(|i| shell.nodes[i as usize]);
        let (u, v) = (sub(b, a), sub(c, a));
        let normal = cross(u, v);
        dot(normal, a).abs() / dot(normal, normal).sqrt()
    };
    bottom.triangles.iter().map(distance).fold(1.0, f64::min)
}
