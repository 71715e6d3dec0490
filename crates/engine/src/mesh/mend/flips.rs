//! Changes that keep all nodes: removal of an edge (3-2, 4-4 and longer rings, 2-2 and slivers on
//! flat facets) and of a face (2-3).

use super::draft::{Change, Draft};
use crate::mesh::tet::FACES;
use crate::mesh::topology::{face_nodes, sorted};

/// Tets at an edge up to which it is removed; longer rings have no good triangulation.
const LONGEST_RING: usize = 12;

/// A row of tets around an edge: the nodes of its ring from end to end, and its region.
struct Chain {
    ring: Vec<u32>,
    region: u32,
}

/// Removes the edge `ab`: the ring around it is triangulated in the best way, and each triangle
/// makes a tet with `a` and one with `b`.
///
/// An edge inside a facet is removed with the two triangles beside it, which become the two of the
/// other diagonal. A single tet on one side of it is flat on the facet and vanishes. An edge where
/// facets end is kept.
pub fn edge_removal(d: &Draft, a: u32, b: u32) -> Option<Change> {
    if d.is_edge(a, b) {
        return None;
    }
    let gone: Vec<u32> = d.tets_around(a, b).collect();
    if gone.len() > LONGEST_RING {
        return None;
    }
    let links: Vec<[u32; 3]> = gone.iter().filter_map(|e| link(d, *e, a, b)).collect();
    let mut ends: Vec<u32> = links
        .iter()
        .flat_map(|[p, q, _]| [*p, *q])
        .filter(|s| d.facet([a, b, *s]).is_some())
        .collect();
    ends.sort_unstable();
    ends.dedup();
    let mut change = Change { gone, ..Change::default() };
    let chains: Vec<Chain> = match ends[..] {
        [] => vec![walk(&links, links.iter().map(|l| l[0]).min()?, &[])?],
        [s, t] => {
            let facet = d.facet([a, b, s])?;
            if d.facet([a, b, t]) != Some(facet) {
                return None;
            }
            change.lost = [s, t].map(|n| sorted([a, b, n]).0).to_vec();
            change.gained = [a, b].map(|n| (sorted([s, t, n]).0, facet)).to_vec();
            let starts = [s, t].into_iter().filter(|n| links.iter().any(|l| l[0] == *n));
            starts.map(|n| walk(&links, n, &[s, t])).collect::<Option<_>>()?
        }
        _ => return None,
    };
    // a closed ring has as many nodes as links, a chain one more
    let closed = ends.is_empty();
    let walked: usize = chains.iter().map(|c| c.ring.len() - usize::from(!closed)).sum();
    if walked != links.len() || closed && walked < 3 {
        return None;
    }
    for chain in chains {
        for [p, q, r] in triangulation(d, &chain.ring, a, b) {
            change.come.push(([p, q, r, b], chain.region));
            change.come.push(([p, r, q, a], chain.region));
        }
    }
    Some(change)
}

/// The other two nodes of a tet at the edge `ab`, counterclockwise about it, and the region.
fn link(d: &Draft, e: u32, a: u32, b: u32) -> Option<[u32; 3]> {
    let tet = &d.tets[e as usize];
    let at = |n: u32| tet.iter().position(|t| *t == n);
    let (i, j) = (at(a)?, at(b)?);
    // outward order of the face opposite `a` starting behind `b` turns about `ab`
    let face = FACES[i];
    let k = face.iter().position(|v| *v == j)?;
    Some([tet[face[(k + 1) % 3]], tet[face[(k + 2) % 3]], d.region[e as usize]])
}

/// Walks from `start` to one of `ends`, or around. `None` if the region changes on the way.
fn walk(links: &[[u32; 3]], start: u32, ends: &[u32]) -> Option<Chain> {
    let next = |n: u32| links.iter().find(|l| l[0] == n);
    let region = next(start)?[2];
    let mut ring = vec![start];
    let mut at = start;
    for _ in 0..links.len() {
        let [_, to, own] = *next(at)?;
        if own != region {
            return None;
        }
        at = to;
        if at == start {
            return ends.is_empty().then_some(Chain { ring, region });
        }
        ring.push(at);
        if ends.contains(&at) {
            return Some(Chain { ring, region });
        }
    }
    None
}

/// The triangulation of a ring that makes the best tets with `a` and `b` (dynamic programming over
/// the sides of sub-polygons); the side between the first and the last node is a side of it.
fn triangulation(d: &Draft, ring: &[u32], a: u32, b: u32) -> Vec<[u32; 3]> {
    let n = ring.len();
    // worst shape and middle node of the best triangulation from i to j
    let mut best = vec![(f64::INFINITY, 0); n * n];
    for span in 2..n {
        for i in 0..n - span {
            let j = i + span;
            let mut own = (f64::NEG_INFINITY, i + 1);
            for k in i + 1..j {
                let [p, q, r] = [ring[i], ring[k], ring[j]];
                let pair = d.shape_of([p, q, r, b]).min(d.shape_of([p, r, q, a]));
                let worst = pair.min(best[i * n + k].0).min(best[k * n + j].0);
                if worst > own.0 {
                    own = (worst, k);
                }
            }
            best[i * n + j] = own;
        }
    }
    let mut triangles = Vec::new();
    let mut open = vec![(0, n - 1)];
    while let Some((i, j)) = open.pop() {
        if j - i > 1 {
            let k = best[i * n + j].1;
            triangles.push([ring[i], ring[k], ring[j]]);
            open.extend([(i, k), (k, j)]);
        }
    }
    triangles
}

/// Replaces two tets at a common face inside a region by three around the line between their
/// opposite nodes.
pub fn face_removal(d: &Draft, e: u32, local: u8) -> Option<Change> {
    let tet = &d.tets[e as usize];
    let face = face_nodes(tet, local);
    if d.facet(face).is_some() {
        return None;
    }
    let other = d
        .tets_around(face[0], face[1])
        .find(|o| *o != e && d.tets[*o as usize].contains(&face[2]))?;
    let a = tet[local as usize];
    let b = d.tets[other as usize].into_iter().find(|n| !face.contains(n))?;
    let region = d.region[e as usize];
    let [p, q, r] = face;
    let come = [[p, q], [q, r], [r, p]].map(|[p, q]| ([a, b, p, q], region)).to_vec();
    Some(Change { gone: vec![e, other], come, ..Change::default() })
}
