//! The remesher's mesh as a mesh of the same bodies and names, with every node exactly on its
//! plane or line; or the reason why it does not fill the same polyhedron.

use super::medit::MeditMesh;
use super::polyhedron::{Polyhedron, Segment};
use super::tet::signed_volume;
use super::topology::{FaceTable, sorted};
use super::{NamedFaces, TetMesh};
use bracket_base::math::vec3::{V3, along, area_vector, dot, norm, sub};
use std::collections::{BTreeMap, HashMap};

/// Relative difference of the volume of a region or the area of a facet before and after
/// remeshing, up to which both are equal: rounding of sums over thousands of tets.
const SAME: f64 = 1e-9;

/// Distance from a corner within which a node is that corner, over the diagonal of the mesh.
const NEAR: f64 = 1e-6;

/// Distance by which the remesher may let a node stray from its plane or line, over the diagonal of
/// the mesh. The node is moved back; volumes and areas show whether the mesh still fits.
const STRAYED: f64 = 1e-3;

/// The mesh of `made` with bodies and names of `old`, whose polyhedron is `p`.
pub fn restore(old: &TetMesh, p: &Polyhedron, made: MeditMesh) -> Result<TetMesh, String> {
    let diagonal = p.tolerance / super::polyhedron::ON;
    let MeditMesh { mut nodes, tets: given, triangles } = made;
    let mut tets: Vec<[u32; 4]> = Vec::with_capacity(given.len());
    let mut regions: Vec<u32> = Vec::with_capacity(given.len());
    for (mut t, reference) in given {
        let region = reference.wrapping_sub(1);
        if region as usize >= p.body.len() {
            return Err(format!("a tetrahedron has the unknown reference {reference}"));
        }
        if signed_volume(&t.map(|n| nodes[n as usize])) < 0.0 {
            t.swap(2, 3);
        }
        tets.push(t);
        regions.push(region);
    }
    let facet_of = facets_of_faces(p, &tets, &regions, &triangles)?;
    let mut facets_at: BTreeMap<u32, Vec<u32>> = BTreeMap::new();
    for (key, facet) in &facet_of {
        key.iter().for_each(|n| facets_at.entry(*n).or_default().push(*facet));
    }
    facets_at.values_mut().for_each(|f| {
        f.sort_unstable();
        f.dedup();
    });
    place_nodes(old, p, &mut nodes, &facets_at, diagonal)?;
    let mesh = assemble(old, p, nodes, tets, &regions, &facet_of);
    check(p, &mesh, &regions, &facet_of)?;
    Ok(dropped(mesh))
}

/// The facet of each face of the skeleton.
pub(super) fn facets_of_faces(
    p: &Polyhedron,
    tets: &[[u32; 4]],
    regions: &[u32],
    triangles: &[([u32; 3], u32)],
) -> Result<BTreeMap<[u32; 3], u32>, String> {
    let mut named: HashMap<[u32; 3], u32> = HashMap::with_capacity(triangles.len());
    for (t, reference) in triangles {
        named.insert(sorted(*t).0, reference.wrapping_sub(1));
    }
    let new = Polyhedron { region_of_tet: regions.to_vec(), ..Polyhedron::default() };
    let mut facet_of = BTreeMap::new();
    for rows in FaceTable::new(tets).faces() {
        if rows.len() > 2 || rows.len() == 2 && rows[0].even == rows[1].even {
            return Err("tetrahedra overlap".into());
        }
        let Some(sides) = new.sides_of(rows) else { continue };
        let facet = named.get(&rows[0].key).copied().filter(|f| (*f as usize) < p.facets.len());
        match facet {
            Some(f) if p.facets[f as usize].sides == sides => {
                facet_of.insert(rows[0].key, f);
            }
            _ => return Err("a face between two bodies or on the surface was lost".into()),
        }
    }
    Ok(facet_of)
}

/// Moves the nodes of the skeleton exactly onto their corners, lines and planes.
fn place_nodes(
    old: &TetMesh,
    p: &Polyhedron,
    nodes: &mut [V3],
    facets_at: &BTreeMap<u32, Vec<u32>>,
    diagonal: f64,
) -> Result<(), String> {
    let near = NEAR * diagonal;
    let cell = |x: &V3| x.map(|c| (c / (2.0 * near)).round() as i64);
    let mut corners: HashMap<[i64; 3], Vec<u32>> = HashMap::new();
    for n in &p.corners {
        corners.entry(cell(&old.nodes[*n as usize])).or_default().push(*n);
    }
    let mut segments: BTreeMap<&[u32], Vec<&Segment>> = BTreeMap::new();
    for s in &p.segments {
        segments.entry(&s.facets).or_default().push(s);
    }
    let corner_near = |x: &V3| {
        let c = cell(x);
        let around =
            (-1..2).flat_map(|i| (-1..2).flat_map(move |j| (-1..2).map(move |k| [i, j, k])));
        around
            .flat_map(|d| corners.get(&[c[0] + d[0], c[1] + d[1], c[2] + d[2]]))
            .flatten()
            .copied()
            .find(|n| norm(sub(old.nodes[*n as usize], *x)) < near)
    };
    let mut found = 0;
    for (n, facets) in facets_at {
        let x = nodes[*n as usize];
        let to = if let Some(corner) = corner_near(&x) {
            found += 1;
            old.nodes[corner as usize]
        } else if let [facet] = facets[..] {
            let f = &p.facets[facet as usize];
            match f.constant {
                Some((axis, value)) => {
                    let mut to = x;
                    to[axis] = value;
                    to
                }
                None => along(x, -dot(f.normal, sub(x, f.point)), f.normal),
            }
        } else {
            let on = segments.get(&facets[..]).into_iter().flatten().map(|s| foot(s, &x));
            let by_distance = |a: &V3, b: &V3| norm(sub(*a, x)).total_cmp(&norm(sub(*b, x)));
            on.min_by(by_distance).ok_or("an edge was lost")?
        };
        if norm(sub(to, x)) >= STRAYED * diagonal {
            return Err("a node left its plane or line".into());
        }
        nodes[*n as usize] = to;
    }
    if found != p.corners.len() {
        return Err(format!("{found} of {} corners were kept", p.corners.len()));
    }
    Ok(())
}

/// The nearest point of a segment.
fn foot(s: &Segment, x: &V3) -> V3 {
    let d = sub(s.ends[1], s.ends[0]);
    let t = (dot(sub(*x, s.ends[0]), d) / dot(d, d)).clamp(0.0, 1.0);
    // both ends have the same coordinate along an axis: so has the point, bit for bit
    along(s.ends[0], t, d)
}

pub(super) fn assemble(
    old: &TetMesh,
    p: &Polyhedron,
    nodes: Vec<V3>,
    tets: Vec<[u32; 4]>,
    regions: &[u32],
    facet_of: &BTreeMap<[u32; 3], u32>,
) -> TetMesh {
    let mut faces: Vec<NamedFaces> = old
        .faces
        .iter()
        .map(|f| NamedFaces { name: f.name.clone(), triangles: Vec::new() })
        .collect();
    for (key, facet) in facet_of {
        for name in &p.facets[*facet as usize].names {
            faces[*name as usize].triangles.push(*key);
        }
    }
    let tet_region = match old.tet_region.is_empty() {
        true => Vec::new(),
        false => regions.iter().map(|r| p.volume_of[*r as usize]).collect(),
    };
    TetMesh {
        nodes,
        tets,
        tet_body: regions.iter().map(|r| p.body[*r as usize]).collect(),
        tet_region,
        bodies: old.bodies.clone(),
        faces,
    }
}

/// Compares the volume of each region and the area of each facet with the old ones.
pub(super) fn check(
    p: &Polyhedron,
    mesh: &TetMesh,
    regions: &[u32],
    facet_of: &BTreeMap<[u32; 3], u32>,
) -> Result<(), String> {
    let mut volumes = vec![0.0; p.body.len()];
    for (e, region) in regions.iter().enumerate() {
        let v = mesh.volume(e);
        if v <= 0.0 {
            return Err("a tetrahedron is flat".into());
        }
        volumes[*region as usize] += v;
    }
    for ((new, old), body) in volumes.iter().zip(&p.volumes).zip(&p.body) {
        if (new - old).abs() > SAME * old {
            let body = &mesh.bodies[*body as usize];
            return Err(format!("{body}: a volume changed from {old:.6} to {new:.6} mm³"));
        }
    }
    let mut areas = vec![0.0; p.facets.len()];
    for (key, facet) in facet_of {
        areas[*facet as usize] += norm(area_vector(&key.map(|n| mesh.nodes[n as usize])));
    }
    for (new, facet) in areas.iter().zip(&p.facets) {
        if (new - facet.area).abs() > SAME * facet.area {
            return Err(format!("an area changed from {:.6} to {new:.6} mm²", facet.area));
        }
    }
    Ok(())
}

/// The mesh without nodes that belong to no tet.
pub(super) fn dropped(mut mesh: TetMesh) -> TetMesh {
    let mut number = vec![u32::MAX; mesh.nodes.len()];
    mesh.tets.iter().flatten().for_each(|n| number[*n as usize] = 0);
    let mut nodes = Vec::with_capacity(mesh.nodes.len());
    for (x, number) in mesh.nodes.iter().zip(&mut number) {
        if *number == 0 {
            *number = nodes.len() as u32;
            nodes.push(*x);
        }
    }
    let new = |n: u32| number[n as usize];
    mesh.tets.iter_mut().for_each(|t| *t = t.map(new));
    mesh.faces.iter_mut().flat_map(|f| &mut f.triangles).for_each(|t| *t = t.map(new));
    mesh.nodes = nodes;
    mesh
}

#[cfg(test)]
mod tests;
