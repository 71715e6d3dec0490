//! A mesh that is being mended: its tets, what keeps the polyhedron in place (freedoms of nodes,
//! triangles of facets, edges where facets end), and changes that can be judged, made and undone.

use crate::mesh::TetMesh;
use crate::mesh::polyhedron::{Polyhedron, sides};
use crate::mesh::quality::{FLAT_VOLUME, longest_edge, smallest_dihedral};
use crate::mesh::tet::signed_volume;
use crate::mesh::topology::{face_nodes, sorted};
use bracket_base::math::vec3::{V3, area_vector, norm};
use std::collections::{HashMap, HashSet};

/// Relative difference of volumes and areas before and after a change up to which both are equal.
const SAME: f64 = 1e-9;

/// Distance by which nodes of one facet may lie off its plane, over the tolerance of the
/// polyhedron: the rounding of a CAD kernel.
const OFF_PLANE: f64 = 1e-2;

/// Where a node may go without a change of the polyhedron.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Freedom {
    /// Nowhere: the node is a corner.
    Fixed,
    /// Along the straight edge on which it lies.
    Line,
    /// In the plane of this facet.
    Plane(u32),
    /// Anywhere inside its region.
    Space,
}

/// A replacement of some tets by others that fill the same space.
#[derive(Clone, Debug, Default)]
pub struct Change {
    /// The tets that go.
    pub gone: Vec<u32>,
    /// The tets that come: nodes and region.
    pub come: Vec<([u32; 4], u32)>,
    /// Triangles of the skeleton that go (sorted nodes).
    pub lost: Vec<[u32; 3]>,
    /// Triangles of the skeleton that come (sorted nodes), each with its facet.
    pub gained: Vec<([u32; 3], u32)>,
    /// Edges where facets end that go.
    pub cut: Vec<[u32; 2]>,
    /// Edges where facets end that come.
    pub drawn: Vec<[u32; 2]>,
    /// A node and its new place \[mm\].
    pub place: Option<(u32, V3)>,
    /// Set if that node is new.
    pub freedom: Option<Freedom>,
}

/// What is needed to undo a change.
pub struct Undo {
    change: Change,
    /// Facets of `change.lost`.
    facets: Vec<u32>,
    /// Where the moved node was.
    from: Option<V3>,
}

impl Undo {
    /// The tets that went.
    pub fn gone(&self) -> &[u32] {
        &self.change.gone
    }
}

/// A mesh that is being mended.
#[derive(Clone)]
pub struct Draft<'a> {
    /// What must be kept.
    pub polyhedron: &'a Polyhedron,
    /// Coordinates \[mm\].
    pub nodes: Vec<V3>,
    /// Where each node may go.
    pub freedom: Vec<Freedom>,
    /// Nodes of all tets that ever were; see [`Draft::alive`].
    pub tets: Vec<[u32; 4]>,
    /// Region of each tet.
    pub region: Vec<u32>,
    /// Shape of each tet; see [`shape`].
    pub shape: Vec<f64>,
    /// Whether each tet is part of the mesh.
    pub alive: Vec<bool>,
    at_node: Vec<Vec<u32>>,
    skeleton: HashMap<[u32; 3], u32>,
    edges: HashSet<[u32; 2]>,
}

/// Smallest dihedral angle \[degrees\]; for a tet that is flat or inverted its volume over the cube
/// of its longest edge, less the limit, which is not positive.
pub fn shape(x: &[V3; 4]) -> f64 {
    let relative = signed_volume(x) / longest_edge(x).powi(3);
    // also for four equal points, whose ratio is NaN
    if relative > FLAT_VOLUME { smallest_dihedral(x) } else { (relative - FLAT_VOLUME).min(0.0) }
}

/// An edge with its nodes in increasing order.
pub fn edge(a: u32, b: u32) -> [u32; 2] {
    if a < b { [a, b] } else { [b, a] }
}

impl<'a> Draft<'a> {
    /// The mesh as the mesher left it, with its polyhedron.
    pub fn new(mesh: &TetMesh, polyhedron: &'a Polyhedron) -> Self {
        let mut freedom = vec![Freedom::Space; mesh.nodes.len()];
        for (key, facet) in &polyhedron.triangles {
            key.iter().for_each(|n| freedom[*n as usize] = Freedom::Plane(*facet));
        }
        let on_edges = polyhedron.edges.iter().flatten();
        on_edges.for_each(|n| freedom[*n as usize] = Freedom::Line);
        polyhedron.corners.iter().for_each(|n| freedom[*n as usize] = Freedom::Fixed);
        let mut at_node = vec![Vec::new(); mesh.nodes.len()];
        for (e, tet) in (0u32..).zip(&mesh.tets) {
            tet.iter().for_each(|n| at_node[*n as usize].push(e));
        }
        Self {
            polyhedron,
            nodes: mesh.nodes.clone(),
            freedom,
            tets: mesh.tets.clone(),
            region: polyhedron.region_of_tet.clone(),
            shape: (0..mesh.tets.len()).map(|e| shape(&mesh.corners(e))).collect(),
            alive: vec![true; mesh.tets.len()],
            at_node,
            skeleton: polyhedron.triangles.iter().copied().collect(),
            edges: polyhedron.edges.iter().copied().collect(),
        }
    }

    /// Coordinates of a node \[mm\].
    pub fn at(&self, n: u32) -> V3 {
        self.nodes[n as usize]
    }

    /// Shape of the tet with these nodes.
    pub fn shape_of(&self, tet: [u32; 4]) -> f64 {
        shape(&tet.map(|n| self.at(n)))
    }

    /// The tets at a node.
    pub fn tets_at(&self, n: u32) -> impl Iterator<Item = u32> + '_ {
        self.at_node[n as usize].iter().copied().filter(|e| self.alive[*e as usize])
    }

    /// The tets at an edge.
    pub fn tets_around(&self, a: u32, b: u32) -> impl Iterator<Item = u32> + '_ {
        self.tets_at(a).filter(move |e| self.tets[*e as usize].contains(&b))
    }

    /// The facet of a triangle; `None` inside a region.
    pub fn facet(&self, triangle: [u32; 3]) -> Option<u32> {
        self.skeleton.get(&sorted(triangle).0).copied()
    }

    /// Whether facets end at an edge.
    pub fn is_edge(&self, a: u32, b: u32) -> bool {
        self.edges.contains(&edge(a, b))
    }

    /// The triangles of the skeleton, each with its facet, in increasing order.
    pub fn triangles(&self) -> Vec<([u32; 3], u32)> {
        let mut all: Vec<_> = self.skeleton.iter().map(|(key, facet)| (*key, *facet)).collect();
        all.sort_unstable();
        all
    }

    /// The worst shape among the tets that a change brings. `None` if it does not fill the same
    /// space, or, unless `rough`, if one of them is flat or inverted.
    pub fn judge(&self, change: &Change, rough: bool) -> Option<f64> {
        let mut worst = f64::INFINITY;
        // the size of what is changed bounds the rounding
        let mut size: f64 = 0.0;
        let mut volumes = Sums::default();
        for e in &change.gone {
            let x = self.tets[*e as usize].map(|n| self.at(n));
            size = size.max(longest_edge(&x));
            volumes.add(self.region[*e as usize], -signed_volume(&x));
        }
        for (tet, region) in &change.come {
            let x = tet.map(|n| self.place(change, n));
            let own = shape(&x);
            if own <= 0.0 && !rough {
                return None;
            }
            worst = worst.min(own);
            volumes.add(*region, signed_volume(&x));
        }
        let mut areas = Sums::default();
        for key in &change.lost {
            let area = norm(area_vector(&key.map(|n| self.at(n))));
            areas.add(self.facet(*key)?, -area);
        }
        for (key, facet) in &change.gained {
            areas.add(*facet, norm(area_vector(&key.map(|n| self.place(change, n)))));
        }
        let off = OFF_PLANE * self.polyhedron.tolerance;
        (volumes.vanish(off * size * size) && areas.vanish(off * size)).then_some(worst)
    }

    /// Where a node is after a change.
    fn place(&self, change: &Change, n: u32) -> V3 {
        change.place.filter(|(moved, _)| *moved == n).map_or_else(|| self.at(n), |(_, x)| x)
    }

    /// Whether the mesh is conformal after a change: at each face inside a region two tets, on
    /// opposite sides, and at each triangle of a facet one of each region that ends there.
    pub fn conforms(&self, change: &Change) -> bool {
        let faces = change
            .come
            .iter()
            .flat_map(|(tet, _)| (0..4u8).map(|local| sorted(face_nodes(tet, local)).0));
        let fresh = change
            .gained
            .iter()
            .all(|(key, _)| !self.skeleton.contains_key(key) || change.lost.contains(key));
        fresh
            && faces.chain(change.gained.iter().map(|(key, _)| *key)).all(|key| {
                let facet = match change.gained.iter().find(|(k, _)| *k == key) {
                    Some((_, facet)) => Some(*facet),
                    None => self.facet(key).filter(|_| !change.lost.contains(&key)),
                };
                let sides = facet.map(|f| self.polyhedron.facets[f as usize].sides);
                let owners: Vec<(bool, u32)> = self.owners_after(change, key).take(3).collect();
                match (&owners[..], sides) {
                    ([(p, a), (q, b)], None) => p != q && a == b,
                    ([(_, a)], Some([own, None])) => Some(*a) == own,
                    ([(p, a), (q, b)], Some([low, Some(high)])) => {
                        p != q && (Some(*a.min(b)), *a.max(b)) == (low, high)
                    }
                    _ => false,
                }
            })
    }

    /// Side and region of each tet at a face after a change.
    fn owners_after<'b>(
        &'b self,
        change: &'b Change,
        key: [u32; 3],
    ) -> impl Iterator<Item = (bool, u32)> + 'b {
        let side = move |tet: &[u32; 4]| {
            let mut faces = (0..4u8).map(|local| sorted(face_nodes(tet, local)));
            faces.find(|(k, _)| *k == key).map(|(_, even)| even)
        };
        let kept = self.at_node.get(key[0] as usize).into_iter().flatten().copied();
        let kept = kept.filter(|e| self.alive[*e as usize] && !change.gone.contains(e));
        let kept = kept.map(|e| (&self.tets[e as usize], self.region[e as usize]));
        let come = change.come.iter().map(|(tet, region)| (tet, *region));
        kept.chain(come).filter_map(move |(tet, region)| Some((side(tet)?, region)))
    }

    /// Makes a change.
    pub fn make(&mut self, change: Change) -> Undo {
        let from = match (change.place, change.freedom) {
            (Some((_, x)), Some(freedom)) => {
                self.nodes.push(x);
                self.freedom.push(freedom);
                self.at_node.push(Vec::new());
                None
            }
            (Some((n, x)), None) => Some(std::mem::replace(&mut self.nodes[n as usize], x)),
            _ => None,
        };
        change.gone.iter().for_each(|e| self.alive[*e as usize] = false);
        for (tet, region) in &change.come {
            let number = self.tets.len() as u32;
            tet.iter().for_each(|n| self.at_node[*n as usize].push(number));
            self.shape.push(self.shape_of(*tet));
            self.tets.push(*tet);
            self.region.push(*region);
            self.alive.push(true);
        }
        let lost = change.lost.iter().filter_map(|key| self.skeleton.remove(key));
        let facets = lost.collect();
        self.skeleton.extend(change.gained.iter().copied());
        change.cut.iter().for_each(|e| {
            self.edges.remove(e);
        });
        self.edges.extend(&change.drawn);
        Undo { change, facets, from }
    }

    /// Undoes the last change that was made and not yet undone.
    pub fn undo(&mut self, Undo { change, facets, from }: Undo) {
        change.drawn.iter().for_each(|e| {
            self.edges.remove(e);
        });
        self.edges.extend(&change.cut);
        for (key, _) in &change.gained {
            self.skeleton.remove(key);
        }
        self.skeleton.extend(change.lost.into_iter().zip(facets));
        for (tet, _) in change.come.iter().rev() {
            // the newest tets are the last of their nodes
            tet.iter().for_each(|n| {
                self.at_node[*n as usize].pop();
            });
        }
        let kept = self.tets.len() - change.come.len();
        self.tets.truncate(kept);
        self.region.truncate(kept);
        self.shape.truncate(kept);
        self.alive.truncate(kept);
        change.gone.iter().for_each(|e| self.alive[*e as usize] = true);
        match (change.place, from) {
            (Some((n, _)), Some(x)) => self.nodes[n as usize] = x,
            (Some(_), None) => {
                self.nodes.pop();
                self.freedom.pop();
                self.at_node.pop();
            }
            _ => {}
        }
    }

    /// The triangles of the skeleton at a node, each with its facet, in increasing order.
    pub fn facets_at(&self, n: u32) -> Vec<([u32; 3], u32)> {
        let mut found = Vec::new();
        if self.freedom[n as usize] == Freedom::Space {
            return found;
        }
        for e in self.tets_at(n) {
            let tet = &self.tets[e as usize];
            for local in (0..4u8).filter(|local| tet[*local as usize] != n) {
                let key = sorted(face_nodes(tet, local)).0;
                found.extend(self.facet(key).map(|facet| (key, facet)));
            }
        }
        found.sort_unstable();
        found.dedup();
        found
    }

    /// The other ends of the edges where facets end at a node, in increasing order.
    pub fn edges_at(&self, n: u32) -> Vec<u32> {
        let triangles = self.facets_at(n);
        let ends = triangles.iter().flat_map(|(key, _)| sides(*key)).filter(|e| e.contains(&n));
        let mut ends: Vec<u32> = ends
            .filter(|e| self.edges.contains(e))
            .map(|e| if e[0] == n { e[1] } else { e[0] })
            .collect();
        ends.sort_unstable();
        ends.dedup();
        ends
    }
}

/// Sums by number, with the sum of absolute values for the rounding.
#[derive(Default)]
struct Sums(Vec<(u32, f64, f64)>);

impl Sums {
    fn add(&mut self, number: u32, value: f64) {
        match self.0.iter_mut().find(|(n, ..)| *n == number) {
            Some((_, sum, size)) => {
                *sum += value;
                *size += value.abs();
            }
            None => self.0.push((number, value, value.abs())),
        }
    }

    /// Whether all sums vanish up to rounding and `off`.
    fn vanish(&self, off: f64) -> bool {
        self.0.iter().all(|(_, sum, size)| sum.abs() <= SAME * size + off)
    }
}
