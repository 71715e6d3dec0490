//! Changes that remove or add a node: collapse and split of an edge.

use super::draft::{Change, Draft, Freedom, edge};
use crate::mesh::topology::sorted;
use bracket_base::math::vec3::{along, dot, sub};

/// Moves node `from` into node `to` at the other end of an edge; the tets at the edge vanish.
/// A node of a facet goes to one of the same facet, a node of a straight edge to one of this edge.
pub fn collapse(d: &Draft, from: u32, to: u32) -> Option<Change> {
    let triangles = d.facets_at(from);
    let allowed = match d.freedom[from as usize] {
        Freedom::Fixed => false,
        Freedom::Line => d.is_edge(from, to),
        Freedom::Plane(_) => triangles.iter().any(|(key, _)| key.contains(&to)),
        Freedom::Space => true,
    };
    if !allowed || !is_link(d, from, to) {
        return None;
    }
    let put = |n: u32| if n == from { to } else { n };
    let mut change = Change { gone: d.tets_at(from).collect(), ..Change::default() };
    for e in &change.gone {
        let tet = d.tets[*e as usize];
        if !tet.contains(&to) {
            change.come.push((tet.map(put), d.region[*e as usize]));
        }
    }
    for (key, facet) in triangles {
        change.lost.push(key);
        if !key.contains(&to) {
            change.gained.push((sorted(key.map(put)).0, facet));
        }
    }
    if d.freedom[from as usize] == Freedom::Line {
        for other in d.edges_at(from) {
            change.cut.push(edge(from, other));
            if other != to {
                change.drawn.push(edge(to, other));
            }
        }
    }
    Some(change)
}

/// Whether every common neighbour of two nodes lies in a tet with both of them. If not, their
/// collapse would make two tets of the same nodes.
fn is_link(d: &Draft, a: u32, b: u32) -> bool {
    let neighbours = |n: u32| {
        let mut all: Vec<u32> = d.tets_at(n).flat_map(|e| d.tets[e as usize]).collect();
        all.sort_unstable();
        all.dedup();
        all
    };
    let of_b = neighbours(b);
    let mut around: Vec<u32> = d.tets_around(a, b).flat_map(|e| d.tets[e as usize]).collect();
    around.sort_unstable();
    let mut common = neighbours(a).into_iter().filter(|n| of_b.binary_search(n).is_ok());
    common.all(|n| around.binary_search(&n).is_ok())
}

/// Puts a node on the edge `ab`, at the fraction `t` from `a`.
pub fn split(d: &Draft, a: u32, b: u32, t: f64) -> Change {
    let node = d.nodes.len() as u32;
    let mut x = along(d.at(a), t, sub(d.at(b), d.at(a)));
    let mut freedom = Freedom::Space;
    let mut change = Change { gone: d.tets_around(a, b).collect(), ..Change::default() };
    let mut beside: Vec<u32> = Vec::new();
    for e in &change.gone {
        let (tet, region) = (d.tets[*e as usize], d.region[*e as usize]);
        for end in [a, b] {
            change.come.push((tet.map(|n| if n == end { node } else { n }), region));
        }
        beside.extend(tet.iter().filter(|n| ![a, b].contains(n)));
    }
    beside.sort_unstable();
    beside.dedup();
    for s in beside {
        if let Some(facet) = d.facet([a, b, s]) {
            freedom = Freedom::Plane(facet);
            change.lost.push(sorted([a, b, s]).0);
            change.gained.extend([a, b].map(|end| (sorted([end, node, s]).0, facet)));
        }
    }
    if d.is_edge(a, b) {
        freedom = Freedom::Line;
        change.cut.push(edge(a, b));
        change.drawn.extend([a, b].map(|end| edge(end, node)));
    }
    if let Freedom::Plane(facet) = freedom
        && let Some((axis, value)) = d.polyhedron.facets[facet as usize].constant
    {
        x[axis] = value;
    }
    change.place = Some((node, x));
    change.freedom = Some(freedom);
    change
}

/// The fraction from `a` at which the edge `ab` is nearest to the line `pq`, within its middle.
pub fn nearest(d: &Draft, [a, b]: [u32; 2], [p, q]: [u32; 2]) -> f64 {
    let (u, v, w) = (sub(d.at(b), d.at(a)), sub(d.at(q), d.at(p)), sub(d.at(a), d.at(p)));
    let (uu, uv, vv) = (dot(u, u), dot(u, v), dot(v, v));
    let determinant = uu * vv - uv * uv;
    let t = (uv * dot(v, w) - vv * dot(u, w)) / determinant;
    // parallel edges have no nearest point
    if t.is_finite() { t.clamp(0.1, 0.9) } else { 0.5 }
}
