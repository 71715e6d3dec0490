//! A mesh cut by a plane, so that a picture shows what lies behind the part in front.
//!
//! Every tet that the plane crosses is replaced by tets of its remaining part. The faces on the
//! plane then are outer faces, and the surface of the rest includes the section.

use bracket_base::math::vec3::V3;
use bracket_engine::mesh::TetMesh;
use std::collections::BTreeMap;

/// A plane normal to an axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plane {
    /// Axis of its normal: 0 = x, 1 = y, 2 = z.
    pub axis: usize,
    /// Coordinate of the plane \[mm\].
    pub at: f64,
    /// True if the part with larger coordinates is removed.
    pub removes_above: bool,
}

/// The remaining part of a mesh.
#[derive(Clone, Debug, PartialEq)]
pub struct Section {
    /// Its tets; named faces and regions are left out.
    pub mesh: TetMesh,
    /// Each node as a point of an edge of the given mesh: both ends, and the part of the way from
    /// the first to the second; the same node twice for a node of the given mesh.
    ends: Vec<([u32; 2], f64)>,
}

impl Section {
    /// Cuts a mesh. The plane is moved a little where it would pass through nodes.
    pub fn of(mesh: &TetMesh, plane: Plane) -> Self {
        let at = between_nodes(mesh, plane);
        let height = |n: u32| {
            let h = mesh.nodes[n as usize][plane.axis] - at;
            if plane.removes_above { -h } else { h }
        };
        let mut out = Self {
            mesh: TetMesh { bodies: mesh.bodies.clone(), ..TetMesh::default() },
            ends: Vec::new(),
        };
        // points of the section by the ends of their edge; kept nodes by twice their number
        let mut points: BTreeMap<[u32; 2], u32> = BTreeMap::new();
        for (e, tet) in mesh.tets.iter().enumerate() {
            let mut point = |a: u32, b: u32| -> u32 {
                let key = [a.min(b), a.max(b)];
                *points.entry(key).or_insert_with(|| {
                    let [p, q] = key;
                    let (hp, hq) = (height(p), height(q));
                    let part = if p == q { 0.0 } else { hp / (hp - hq) };
                    let (x, y) = (mesh.nodes[p as usize], mesh.nodes[q as usize]);
                    out.mesh.nodes.push(mixed(x, y, part));
                    out.ends.push((key, part));
                    (out.ends.len() - 1) as u32
                })
            };
            let (kept, cut): (Vec<u32>, Vec<u32>) = tet.iter().partition(|n| height(**n) > 0.0);
            let pieces: Vec<[u32; 4]> = match (&kept[..], &cut[..]) {
                (_, []) => vec![tet.map(|n| point(n, n))],
                ([a], [p, q, r]) => {
                    vec![[point(*a, *a), point(*a, *p), point(*a, *q), point(*a, *r)]]
                }
                ([a, b], [p, q]) => wedge(
                    [point(*a, *a), point(*a, *p), point(*a, *q)],
                    [point(*b, *b), point(*b, *p), point(*b, *q)],
                ),
                ([a, b, c], [p]) => wedge(
                    [point(*a, *a), point(*b, *b), point(*c, *c)],
                    [point(*a, *p), point(*b, *p), point(*c, *p)],
                ),
                _ => Vec::new(),
            };
            for mut piece in pieces {
                out.mesh.tets.push(piece);
                let last = out.mesh.tets.len() - 1;
                if out.mesh.volume(last) < 0.0 {
                    piece.swap(2, 3);
                    out.mesh.tets[last] = piece;
                }
                out.mesh.tet_body.push(mesh.tet_body[e]);
            }
        }
        out
    }

    /// A nodal field of the given mesh at the nodes of the section.
    pub fn scalars(&self, field: &[f64]) -> Vec<f64> {
        let value = |([a, b], part): &([u32; 2], f64)| {
            let (a, b) = (field[*a as usize], field[*b as usize]);
            a + part * (b - a)
        };
        self.ends.iter().map(value).collect()
    }

    /// The same for a vector field.
    pub fn vectors(&self, field: &[V3]) -> Vec<V3> {
        let value =
            |([a, b], part): &([u32; 2], f64)| mixed(field[*a as usize], field[*b as usize], *part);
        self.ends.iter().map(value).collect()
    }
}

fn mixed(a: V3, b: V3, part: f64) -> V3 {
    [0, 1, 2].map(|k| a[k] + part * (b[k] - a[k]))
}

/// The three tets of a wedge with the triangles `a` and `b` and edges from `a[i]` to `b[i]`. The
/// diagonal of each side starts at its lowest number, so that neighbours agree.
fn wedge(mut a: [u32; 3], mut b: [u32; 3]) -> Vec<[u32; 4]> {
    let lowest = (0..3).min_by_key(|&i| a[i].min(b[i])).unwrap_or(0);
    a.rotate_left(lowest);
    b.rotate_left(lowest);
    if b[0] < a[0] {
        (a, b) = (b, a);
    }
    // both diagonals through a[0]; the third one starts at the lower end
    let third = if a[1].min(b[2]) < a[2].min(b[1]) {
        [[a[0], a[1], a[2], b[2]], [a[0], a[1], b[2], b[1]]]
    } else {
        [[a[0], a[1], a[2], b[1]], [a[0], a[2], b[2], b[1]]]
    };
    vec![third[0], third[1], [a[0], b[0], b[1], b[2]]]
}

/// A coordinate near that of the plane, in the middle of the widest space between the coordinates
/// of nodes.
fn between_nodes(mesh: &TetMesh, plane: Plane) -> f64 {
    let mut all: Vec<f64> = mesh.nodes.iter().map(|x| x[plane.axis]).collect();
    all.sort_by(f64::total_cmp);
    let (Some(first), Some(last)) = (all.first(), all.last()) else { return plane.at };
    let near = 0.01 * (last - first);
    let (low, high) = (plane.at - near, plane.at + near);
    let mut levels = vec![low];
    levels.extend(all.iter().filter(|x| **x > low && **x < high));
    levels.push(high);
    let widest = levels.windows(2).max_by(|a, b| (a[1] - a[0]).total_cmp(&(b[1] - b[0])));
    widest.map_or(plane.at, |w| 0.5 * (w[0] + w[1]))
}

#[cfg(test)]
mod tests {
    use super::*;
    use bracket_engine::mesh::topology::FaceTable;

    /// A cube in six tets with a second body below the diagonal plane.
    fn cube() -> TetMesh {
        let nodes = (0..8).map(|i| [i & 1, i >> 1 & 1, i >> 2].map(f64::from)).collect();
        let paths = [[1, 3], [3, 2], [2, 6], [6, 4], [4, 5], [5, 1]];
        let mut mesh = TetMesh {
            nodes,
            tets: paths.iter().map(|[a, b]| [0, *a, *b, 7]).collect(),
            tet_body: vec![0, 0, 0, 1, 1, 1],
            bodies: vec!["A".into(), "B".into()],
            ..TetMesh::default()
        };
        for e in 0..6 {
            if mesh.volume(e) < 0.0 {
                mesh.tets[e].swap(2, 3);
            }
        }
        mesh
    }

    #[test]
    fn the_rest_is_a_closed_mesh_of_the_right_volume() {
        let mesh = cube();
        for axis in 0..3 {
            for (removes_above, wanted) in [(true, 0.3), (false, 0.7)] {
                let section = Section::of(&mesh, Plane { axis, at: 0.3, removes_above });
                let cut = &section.mesh;
                let volume: f64 = (0..cut.tets.len()).map(|e| cut.volume(e)).sum();
                assert!((volume - wanted).abs() < 1e-12, "{volume}");
                assert!((0..cut.tets.len()).all(|e| cut.volume(e) > 0.0));
                // faces of one tet only lie on the box of the rest
                let table = FaceTable::new(&cut.tets);
                let bounds = if removes_above { [0.0, 0.3] } else { [0.3, 1.0] };
                for rows in table.faces().filter(|rows| rows.len() == 1) {
                    let on_side = (0..3).any(|k| {
                        let sides = if k == axis { bounds } else { [0.0, 1.0] };
                        sides.iter().any(|s| {
                            rows[0]
                                .key
                                .iter()
                                .all(|n| (cut.nodes[*n as usize][k] - s).abs() < 1e-12)
                        })
                    });
                    assert!(on_side);
                }
                // a linear field is reproduced
                let linear = |x: &V3| [x[0] + 2.0 * x[1], 3.0 * x[2], -x[0]];
                let field: Vec<V3> = mesh.nodes.iter().map(linear).collect();
                for (value, x) in section.vectors(&field).iter().zip(&cut.nodes) {
                    let wanted = linear(x);
                    assert!((0..3).all(|k| (value[k] - wanted[k]).abs() < 1e-12));
                }
            }
        }
    }

    /// A plane through nodes is moved: no tet without volume appears.
    #[test]
    fn a_plane_through_nodes_is_moved() {
        let mesh = cube();
        let section = Section::of(&mesh, Plane { axis: 0, at: 1.0, removes_above: true });
        assert!((0..section.mesh.tets.len()).all(|e| section.mesh.volume(e) > 1e-9));
    }
}
