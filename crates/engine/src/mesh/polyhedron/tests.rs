use super::*;
use crate::mesh::fixtures::{cubes, name};

/// Two blocks of 30 mm side by side, 27 cubes each.
pub fn blocks(second: &str) -> TetMesh {
    let cells: Vec<_> = (0..54)
        .map(|i| ([i % 6, i / 6 % 3, i / 18], if i % 6 < 3 { "A" } else { second }))
        .collect();
    cubes(&cells)
}

/// Two boxes with a common face have 11 facets, 12 corners and 20 straight edges.
#[test]
fn two_boxes() {
    let p = Polyhedron::new(&blocks("B"));
    assert_eq!((p.body.len(), p.facets.len(), p.corners.len(), p.segments.len()), (2, 11, 12, 20));
    assert!(p.volumes.iter().all(|v| (v - 27_000.0).abs() < 1e-9));
    assert!(p.facets.iter().all(|f| (f.area - 900.0).abs() < 1e-9 && f.constant.is_some()));
    assert_eq!(p.facets.iter().filter(|f| f.sides[1].is_some()).count(), 1);
    for s in &p.segments {
        let l = norm(sub(s.ends[1], s.ends[0]));
        assert!((l - 30.0).abs() < 1e-12, "{l}");
    }
    // the four edges of the common face and those along x have no ridge between coplanar sides,
    // but all meet another facet at a right angle
    assert_eq!(p.ridges, p.edges);
    // one body: no common face
    let p = Polyhedron::new(&blocks("A"));
    assert_eq!((p.body.len(), p.facets.len(), p.corners.len(), p.segments.len()), (1, 6, 8, 12));
}

/// The volumes of the mesher inside a body are regions: their common face is kept.
#[test]
fn half_layers_are_regions() {
    let mut mesh = blocks("A");
    mesh.tet_region = (0..mesh.tets.len())
        .map(|e| u32::from(mesh.corners(e).iter().all(|x| x[0] >= 30.0)))
        .collect();
    let p = Polyhedron::new(&mesh);
    assert_eq!((p.body.clone(), p.facets.len(), p.corners.len()), (vec![0, 0], 11, 12));
    assert_eq!(p.volume_of, [0, 1]);
}

/// A named patch in a flat side is a facet of its own. Its boundary is no ridge, and its corners
/// are kept.
#[test]
fn a_footprint_is_a_facet() {
    let mut mesh = blocks("A");
    let inside = |x: f64| (10.0..=20.0).contains(&x);
    name(&mut mesh, "FOOT", |x| x[2] == 0.0 && inside(x[0]) && inside(x[1]));
    let p = Polyhedron::new(&mesh);
    assert_eq!((p.facets.len(), p.corners.len(), p.segments.len()), (7, 12, 16));
    assert_eq!(p.edges.len() - p.ridges.len(), 4);
    let foot: Vec<&Facet> = p.facets.iter().filter(|f| !f.names.is_empty()).collect();
    assert_eq!((foot.len(), foot[0].area), (1, 100.0));
    assert!(p.loose.is_empty());
}

/// A named section that severs a body bounds regions; one that does not is loose.
#[test]
fn named_interior_faces() {
    let mut mesh = blocks("A");
    name(&mut mesh, "CUT", |x| x[0] == 30.0);
    let p = Polyhedron::new(&mesh);
    assert_eq!((p.body.clone(), p.loose.len()), (vec![0, 0], 0));
    let mut mesh = blocks("A");
    name(&mut mesh, "SLIT", |x| x[0] == 30.0 && x[2] <= 10.0);
    let p = Polyhedron::new(&mesh);
    assert_eq!((p.body.len(), p.loose.clone()), (1, vec![0]));
}

/// Every facet of a curved surface is kept: a box with one side bent has as many facets there as
/// triangles.
#[test]
fn curved_sides_keep_their_triangles() {
    let mut mesh = blocks("A");
    for x in &mut mesh.nodes {
        if x[2] == 30.0 {
            x[2] += 1e-5 * (x[0] + 2.0 * x[1]).powi(3) + 1e-3 * x[0] * x[0];
        }
    }
    let p = Polyhedron::new(&mesh);
    assert_eq!(p.facets.len(), 5 + 36);
}
