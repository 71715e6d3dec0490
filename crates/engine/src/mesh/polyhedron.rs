//! The polyhedron that a mesh fills: regions, flat facets, straight edges and corners. A remesher
//! must keep all of them.
//!
//! A region is a connected part of one body; bodies, the mesher's volumes and named interior faces
//! bound it. The skeleton consists of all faces that bound a region. A facet is a connected flat
//! part of the skeleton with the same regions on its sides and the same names throughout. A curved
//! surface counts as the facets of its triangulation, so that the body stays exactly the same.

use super::TetMesh;
use super::split::UnionFind;
use super::topology::{FaceRow, FaceTable, sorted};
use bracket_base::math::vec3::{V3, area_vector, dot, norm, scale, sub};
use std::collections::{BTreeMap, HashMap};

/// Distance from a plane or line below which a point lies on it, over the diagonal of the mesh.
/// Coordinates in files have 16 digits; the rounding of a CAD kernel stays below 1e-10.
pub const ON: f64 = 1e-9;

/// A flat part of the skeleton.
#[derive(Clone, Debug, PartialEq)]
pub struct Facet {
    /// The regions at its sides; the second is absent on the outer surface.
    pub sides: [Option<u32>; 2],
    /// The named faces (indices) that it belongs to.
    pub names: Vec<u32>,
    /// A point of its plane \[mm\].
    pub point: V3,
    /// Unit normal of its plane.
    pub normal: V3,
    /// The coordinate (axis, value) that all its nodes share bit for bit, if there is one.
    pub constant: Option<(usize, f64)>,
    /// Area \[mm²\].
    pub area: f64,
}

/// A straight edge between two corners, or the straight part of one.
#[derive(Clone, Debug, PartialEq)]
pub struct Segment {
    /// Coordinates of its ends \[mm\].
    pub ends: [V3; 2],
    /// The facets that meet there, increasing.
    pub facets: Vec<u32>,
}

/// The polyhedron of a mesh whose bodies share nodes.
#[derive(Clone, Debug, Default)]
pub struct Polyhedron {
    /// Region of each tet.
    pub region_of_tet: Vec<u32>,
    /// Body of each region.
    pub body: Vec<u32>,
    /// The mesher's volume of each region.
    pub volume_of: Vec<u32>,
    /// Volume of each region \[mm³\].
    pub volumes: Vec<f64>,
    /// The facets.
    pub facets: Vec<Facet>,
    /// The triangles of the skeleton, each with its facet.
    pub triangles: Vec<([u32; 3], u32)>,
    /// Edges of the mesh where facets end.
    pub edges: Vec<[u32; 2]>,
    /// Those of `edges` where the skeleton is not flat.
    pub ridges: Vec<[u32; 2]>,
    /// Nodes at which straight edges end.
    pub corners: Vec<u32>,
    /// The straight edges.
    pub segments: Vec<Segment>,
    /// Names that lie inside a region: their faces do not bound anything, and a remesher would lose
    /// them.
    pub loose: Vec<u32>,
    /// Tolerance of positions \[mm\].
    pub tolerance: f64,
}

/// Diagonal of the box around points \[mm\].
pub fn diagonal(nodes: &[V3]) -> f64 {
    let (mut min, mut max) = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
    for x in nodes {
        for d in 0..3 {
            min[d] = min[d].min(x[d]);
            max[d] = max[d].max(x[d]);
        }
    }
    norm(sub(max, min))
}

fn edge(a: u32, b: u32) -> [u32; 2] {
    if a < b { [a, b] } else { [b, a] }
}

/// The three edges of a triangle.
pub fn sides([a, b, c]: [u32; 3]) -> [[u32; 2]; 3] {
    [edge(a, b), edge(b, c), edge(c, a)]
}

/// What a face of the skeleton separates, and its names.
type Signature = ([Option<u32>; 2], Vec<u32>);

impl Polyhedron {
    /// Finds the polyhedron of a mesh.
    pub fn new(mesh: &TetMesh) -> Self {
        let table = FaceTable::new(&mesh.tets);
        let mut names: HashMap<[u32; 3], Vec<u32>> = HashMap::new();
        for (i, face) in mesh.faces.iter().enumerate() {
            for t in &face.triangles {
                names.entry(sorted(*t).0).or_default().push(i as u32);
            }
        }
        let mut p = Self { tolerance: ON * diagonal(&mesh.nodes), ..Self::default() };
        p.find_regions(mesh, &table, &names);
        p.find_facets(mesh, &table, &names);
        p.find_edges(mesh);
        p
    }

    fn find_regions(
        &mut self,
        mesh: &TetMesh,
        table: &FaceTable,
        names: &HashMap<[u32; 3], Vec<u32>>,
    ) {
        let given = |e: u32| (mesh.tet_body[e as usize], mesh.tet_region.get(e as usize));
        let mut sets = UnionFind::new(mesh.tets.len());
        for rows in table.faces() {
            if let [p, q] = rows
                && given(p.tet) == given(q.tet)
                && !names.contains_key(&p.key)
            {
                sets.join(p.tet as usize, q.tet as usize);
            }
        }
        let mut number: HashMap<usize, u32> = HashMap::new();
        for e in 0..mesh.tets.len() {
            let region = *number.entry(sets.root(e)).or_insert_with(|| {
                let body = mesh.tet_body[e];
                self.body.push(body);
                self.volume_of.push(mesh.tet_region.get(e).copied().unwrap_or(body));
                self.volumes.push(0.0);
                self.body.len() as u32 - 1
            });
            self.region_of_tet.push(region);
            self.volumes[region as usize] += mesh.volume(e);
        }
    }

    /// The regions at the sides of a face; `None` for faces inside a region.
    pub fn sides_of(&self, rows: &[FaceRow]) -> Option<[Option<u32>; 2]> {
        let region = |r: &FaceRow| self.region_of_tet[r.tet as usize];
        match rows {
            [p] => Some([Some(region(p)), None]),
            [p, q] if region(p) != region(q) => {
                let (a, b) = (region(p), region(q));
                Some([Some(a.min(b)), Some(a.max(b))])
            }
            _ => None,
        }
    }

    fn find_facets(
        &mut self,
        mesh: &TetMesh,
        table: &FaceTable,
        names: &HashMap<[u32; 3], Vec<u32>>,
    ) {
        let mut signatures: BTreeMap<Signature, u32> = BTreeMap::new();
        let mut faces: Vec<([u32; 3], u32, f64)> = Vec::new();
        for rows in table.faces() {
            let key = rows[0].key;
            let own = names.get(&key);
            match self.sides_of(rows) {
                Some(sides) => {
                    let next = signatures.len() as u32;
                    let signature = (sides, own.cloned().unwrap_or_default());
                    let s = *signatures.entry(signature).or_insert(next);
                    let area = norm(area_vector(&key.map(|n| mesh.nodes[n as usize])));
                    faces.push((key, s, area));
                }
                None => self.loose.extend(own.into_iter().flatten()),
            }
        }
        self.loose.sort_unstable();
        self.loose.dedup();
        let mut of_number: Vec<&Signature> = vec![&EMPTY; signatures.len()];
        for (signature, number) in &signatures {
            of_number[*number as usize] = signature;
        }
        // the largest triangles first: they define their planes best
        let mut order: Vec<u32> = (0..faces.len() as u32).collect();
        order.sort_by(|a, b| faces[*b as usize].2.total_cmp(&faces[*a as usize].2).then(a.cmp(b)));
        let mut around: HashMap<[u32; 2], Vec<u32>> = HashMap::with_capacity(2 * faces.len());
        for (i, (key, _, _)) in faces.iter().enumerate() {
            sides(*key).into_iter().for_each(|s| around.entry(s).or_default().push(i as u32));
        }
        let mut facet = vec![u32::MAX; faces.len()];
        for seed in order {
            if facet[seed as usize] != u32::MAX {
                continue;
            }
            let (key, signature, _) = faces[seed as usize];
            let corners = key.map(|n| mesh.nodes[n as usize]);
            let (point, normal) = (corners[0], unit(area_vector(&corners)));
            let number = self.facets.len() as u32;
            let mut queue = vec![seed];
            facet[seed as usize] = number;
            let (mut area, mut constant) = (0.0, [true; 3]);
            while let Some(i) = queue.pop() {
                let (key, _, own) = faces[i as usize];
                area += own;
                for n in key {
                    let x = mesh.nodes[n as usize];
                    (0..3).for_each(|d| constant[d] &= x[d].to_bits() == point[d].to_bits());
                }
                let ahead = sides(key).into_iter().flat_map(|s| &around[&s]).copied();
                for j in ahead {
                    let (other, s, _) = faces[j as usize];
                    let flat = |n: u32| {
                        dot(normal, sub(mesh.nodes[n as usize], point)).abs() < self.tolerance
                    };
                    if facet[j as usize] == u32::MAX
                        && s == signature
                        && other.into_iter().all(flat)
                    {
                        facet[j as usize] = number;
                        queue.push(j);
                    }
                }
            }
            let (sides, names) = of_number[signature as usize].clone();
            let constant = (0..3).find(|d| constant[*d]).map(|d| (d, point[d]));
            self.facets.push(Facet { sides, names, point, normal, constant, area });
        }
        self.triangles = faces.iter().zip(&facet).map(|((key, _, _), f)| (*key, *f)).collect();
    }

    fn find_edges(&mut self, mesh: &TetMesh) {
        let mut around: BTreeMap<[u32; 2], Vec<u32>> = BTreeMap::new();
        let mut at_node: BTreeMap<u32, Vec<u32>> = BTreeMap::new();
        for (key, facet) in &self.triangles {
            sides(*key).into_iter().for_each(|s| around.entry(s).or_default().push(*facet));
            key.iter().for_each(|n| at_node.entry(*n).or_default().push(*facet));
        }
        at_node.values_mut().for_each(|f| {
            f.sort_unstable();
            f.dedup();
        });
        let mut ends: BTreeMap<u32, Vec<[u32; 2]>> = BTreeMap::new();
        around.retain(|edge, facets| {
            let inside = facets.len() == 2 && facets[0] == facets[1];
            facets.sort_unstable();
            facets.dedup();
            if !inside {
                edge.iter().for_each(|n| ends.entry(*n).or_default().push(*edge));
            }
            !inside
        });
        let x = |n: u32| mesh.nodes[n as usize];
        for (edge, facets) in &around {
            self.edges.push(*edge);
            let parallel = |a: u32, b: u32| {
                let (a, b) = (&self.facets[a as usize], &self.facets[b as usize]);
                let off = dot(a.normal, sub(b.point, a.point)).abs();
                off < self.tolerance && dot(a.normal, b.normal).abs() > 1.0 - 1e-12
            };
            if facets.windows(2).any(|w| !parallel(w[0], w[1])) {
                self.ridges.push(*edge);
            }
        }
        let straight = |n: u32, [a, b]: [[u32; 2]; 2]| {
            let other = |e: [u32; 2]| x(if e[0] == n { e[1] } else { e[0] });
            let (p, q) = (sub(other(a), x(n)), sub(other(b), x(n)));
            let d = sub(q, p);
            let t = -dot(p, d) / dot(d, d);
            let off = norm(std::array::from_fn(|k| p[k] + t * d[k]));
            dot(p, q) < 0.0 && off < self.tolerance && around[&a] == around[&b]
        };
        let mut is_corner: HashMap<u32, bool> = HashMap::new();
        for (n, facets) in &at_node {
            let corner = match ends.get(n).map(Vec::as_slice) {
                None => facets.len() > 1,
                Some(&[a, b]) => !straight(*n, [a, b]) || around[&a] != *facets,
                Some(_) => true,
            };
            is_corner.insert(*n, corner);
            if corner {
                self.corners.push(*n);
            }
        }
        // walks from corner to corner
        let mut seen: BTreeMap<[u32; 2], bool> = BTreeMap::new();
        for start in self.corners.clone() {
            for first in ends.get(&start).into_iter().flatten() {
                if seen.insert(*first, true).is_some() {
                    continue;
                }
                let (mut at, mut along) = (start, *first);
                loop {
                    at = if along[0] == at { along[1] } else { along[0] };
                    seen.insert(along, true);
                    if is_corner[&at] {
                        break;
                    }
                    match ends[&at].iter().find(|e| **e != along) {
                        Some(next) => along = *next,
                        None => break,
                    }
                }
                let ends = [x(start), x(at)];
                self.segments.push(Segment { ends, facets: around[first].clone() });
            }
        }
    }
}

static EMPTY: Signature = ([None, None], Vec::new());

fn unit(a: V3) -> V3 {
    scale(1.0 / norm(a), a)
}

#[cfg(test)]
mod tests;
