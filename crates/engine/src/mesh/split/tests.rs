use super::*;
use crate::mesh::fixtures::cubes;
use std::collections::BTreeSet;

/// Opens all faces between the bodies `a` and `b` whose corners satisfy `on`; side A is `a`.
fn open_between(mesh: &TetMesh, a: u32, b: u32, on: impl Fn([[f64; 3]; 3]) -> bool) -> SplitMesh {
    let table = FaceTable::new(&mesh.tets);
    let mut open = Vec::new();
    for o in table.faces().filter(|o| o.len() == 2 && on(o[0].key.map(|n| mesh.nodes[n as usize])))
    {
        let bodies = [mesh.tet_body[o[0].tet as usize], mesh.tet_body[o[1].tet as usize]];
        if bodies == [a, b] {
            open.push([TetFace::from(&o[0]), TetFace::from(&o[1])]);
        } else if bodies == [b, a] {
            open.push([TetFace::from(&o[1]), TetFace::from(&o[0])]);
        }
    }
    let cut = split(mesh, &table, &open);
    check(mesh, &cut, a);
    cut
}

/// Faces that belong to only one tet.
fn boundary(mesh: &TetMesh) -> BTreeSet<TetFace> {
    let table = FaceTable::new(&mesh.tets);
    table.faces().filter(|o| o.len() == 1).map(|o| TetFace::from(&o[0])).collect()
}

/// Checks properties that every split must have.
fn check(before: &TetMesh, cut: &SplitMesh, a: u32) {
    let m = &cut.mesh;
    assert!((0..m.tets.len()).all(|e| m.corners(e) == before.corners(e)));
    assert_eq!(m.tets.iter().flatten().collect::<BTreeSet<_>>().len(), m.nodes.len());
    let boundary = boundary(m);
    for p in &cut.pairs {
        assert_eq!(m.tet_body[p.a.tet as usize], a);
        assert_eq!(p.nodes_a, face_nodes(&m.tets[p.a.tet as usize], p.a.local));
        for i in 0..3 {
            assert_eq!(m.nodes[p.nodes_a[i] as usize], m.nodes[p.nodes_b[i] as usize]);
            assert!(m.tets[p.b.tet as usize].contains(&p.nodes_b[i]));
        }
        // outward: the tet of side A lies behind its face
        let x = p.nodes_a.map(|n| m.nodes[n as usize]);
        let apex = m.nodes[m.tets[p.a.tet as usize][p.a.local as usize] as usize];
        assert!(crate::mesh::tet::signed_volume(&[x[0], x[1], x[2], apex]) < 0.0);
        assert!(boundary.contains(&p.a) && boundary.contains(&p.b));
    }
}

#[test]
fn two_cubes() {
    let mesh = cubes(&[([0, 0, 0], "A"), ([1, 0, 0], "B")]);
    assert_eq!(mesh.nodes.len(), 12);
    for (a, b) in [(0, 1), (1, 0)] {
        let cut = open_between(&mesh, a, b, |_| true);
        assert_eq!((cut.mesh.nodes.len(), cut.pairs.len(), cut.parts), (16, 2, 2));
        assert!(cut.pairs.iter().all(|p| p.nodes_a.iter().all(|n| !p.nodes_b.contains(n))));
        assert_eq!(boundary(&cut.mesh).len(), 2 * 12);
    }
    let tied = open_between(&mesh, 0, 1, |_| false);
    assert_eq!(tied.mesh, mesh);
    assert_eq!((tied.parts, boundary(&tied.mesh).len()), (1, 20));
}

#[test]
fn three_cubes_tied_and_in_contact() {
    let mesh = cubes(&[([0, 0, 0], "A"), ([1, 0, 0], "B"), ([2, 0, 0], "C")]);
    let cut = open_between(&mesh, 1, 2, |_| true);
    assert_eq!((cut.mesh.nodes.len(), cut.pairs.len(), cut.parts), (20, 2, 2));
    assert!((0..18).all(|e| cut.tet_part[e] == u32::from(e >= 12)));
}

/// A 3 × 3 plate with a hole, filled by the shank of a bolt whose head lies on the plate: head
/// tied, shank in contact.
fn bolt() -> TetMesh {
    let mut cells = Vec::new();
    for i in 0..3 {
        for j in 0..3 {
            cells.push(([i, j, 0], if (i, j) == (1, 1) { "BOLT" } else { "PLATE" }));
            cells.push(([i, j, 1], "BOLT"));
        }
    }
    cubes(&cells)
}

#[test]
fn tied_head_and_shank_in_contact_with_one_plate() {
    let mesh = bolt();
    let (plate, shank) = (0, 1);
    // 4 sides of the shank, but not the underside of the head
    let cut = open_between(&mesh, plate, shank, |x| {
        let same = |d: usize| (1..3).all(|i| x[i][d] == x[0][d]);
        same(0) || same(1)
    });
    assert_eq!(cut.pairs.len(), 8);
    // the four nodes at the foot of the shank are doubled; the four on the circle under the head
    // are common
    assert_eq!(cut.mesh.nodes.len(), mesh.nodes.len() + 4);
    assert_eq!(cut.parts, 1);
    for p in &cut.pairs {
        for (a, b) in p.nodes_a.iter().zip(p.nodes_b) {
            assert_eq!(*a == b, cut.mesh.nodes[*a as usize][2] == 10.0);
        }
    }
}

#[test]
fn parts_that_touch_in_an_edge_come_apart() {
    let mesh = cubes(&[([0, 0, 0], "A"), ([1, 1, 0], "B")]);
    assert_eq!(mesh.nodes.len(), 14);
    let cut = open_between(&mesh, 0, 1, |_| true);
    assert_eq!((cut.mesh.nodes.len(), cut.pairs.len(), cut.parts), (16, 0, 2));
}

#[test]
fn a_face_of_one_body_may_end_inside_another() {
    // B is open over only half of its face: the nodes at the end of the opening stay common
    let mesh = cubes(&[([0, 0, 0], "A"), ([0, 1, 0], "A"), ([1, 0, 0], "B"), ([1, 1, 0], "B")]);
    let cut = open_between(&mesh, 0, 1, |x| x.iter().all(|p| p[1] <= 10.0));
    assert_eq!((cut.mesh.nodes.len(), cut.pairs.len(), cut.parts), (mesh.nodes.len() + 2, 2, 1));
}
