//! Each change on a small mesh made by hand, and random meshes with slivers put in.

use super::draft::{Change, Freedom};
use super::edges::{collapse, split};
use super::flips::{edge_removal, face_removal};
use super::moves::best_move;
use super::*;
use crate::mesh::fixtures::{cubes, name};
use crate::mesh::orient;
use crate::mesh::topology::FaceTable;
use bracket_base::math::vec3::{V3, area_vector, dot, norm, sub};
use proptest::prelude::*;

/// A mesh of these tets, oriented alike; each with its body.
fn mesh(nodes: &[V3], tets: &[([u32; 4], u32)]) -> TetMesh {
    let mut mesh = TetMesh {
        nodes: nodes.to_vec(),
        tets: tets.iter().map(|t| t.0).collect(),
        tet_body: tets.iter().map(|t| t.1).collect(),
        bodies: ["A", "B"].map(String::from).to_vec(),
        ..TetMesh::default()
    };
    orient::alike(&mut mesh).expect("no tets overlap");
    mesh
}

fn worst(mesh: &TetMesh) -> f64 {
    (0..mesh.tets.len()).map(|e| shape(&mesh.corners(e))).fold(f64::INFINITY, f64::min)
}

/// What mending must keep: the volume of each body and the area of each pair of bodies (or of a
/// body and the outside) in each plane.
fn kept(mesh: &TetMesh) -> Vec<(String, f64)> {
    let mut sums = std::collections::BTreeMap::new();
    for e in 0..mesh.tets.len() {
        *sums.entry(format!("body {}", mesh.tet_body[e])).or_insert(0.0) += mesh.volume(e);
    }
    let table = FaceTable::new(&mesh.tets);
    for rows in table.faces() {
        let mut bodies: Vec<u32> = rows.iter().map(|r| mesh.tet_body[r.tet as usize]).collect();
        bodies.sort_unstable();
        if bodies.len() == 2 && bodies[0] == bodies[1] {
            continue;
        }
        let x = rows[0].key.map(|n| mesh.nodes[n as usize]);
        let flat = (0..3).find(|k| x.iter().all(|p| p[*k] == x[0][*k]));
        let plane = flat.map_or("oblique".into(), |k| format!("{k} at {}", x[0][k]));
        *sums.entry(format!("{bodies:?} {plane}")).or_insert(0.0) += norm(area_vector(&x));
    }
    for face in &mesh.faces {
        let areas =
            face.triangles.iter().map(|t| norm(area_vector(&t.map(|n| mesh.nodes[n as usize]))));
        *sums.entry(format!("name {}", face.name)).or_insert(0.0) += areas.sum::<f64>();
    }
    sums.into_iter().filter(|(_, sum)| *sum > 1e-9).collect()
}

/// Checks everything that mending promises; returns the mended mesh.
fn checked(before: &TetMesh) -> (TetMesh, Mended) {
    let (after, mended) = mend(before, FLAT, &|| false).expect("mended");
    let (old, new) = (kept(before), kept(&after));
    assert_eq!(old.len(), new.len(), "{old:?} {new:?}");
    for ((a, was), (b, is)) in old.iter().zip(&new) {
        assert!(a == b && (was - is).abs() < 1e-9 * was, "{a}: {was}, {b}: {is}");
    }
    let table = FaceTable::new(&after.tets);
    let conformal = table.faces().all(|r| r.len() == 1 || r.len() == 2 && r[0].even != r[1].even);
    assert!(conformal, "two tets lie on one side of a face");
    assert!((0..after.tets.len()).all(|e| after.volume(e) > 0.0));
    assert!(worst(&after) >= worst(before), "{} {}", worst(before), worst(&after));
    let mut used = vec![false; after.nodes.len()];
    after.tets.iter().flatten().for_each(|n| used[*n as usize] = true);
    assert!(used.iter().all(|u| *u), "a node without a tet");
    (after, mended)
}

const SQUARE: [V3; 4] = [[0.0, 0.0, 0.0], [10.0, 0.0, 0.0], [10.0, 10.0, 0.0], [0.0, 10.0, 0.0]];

/// A pyramid of two tets with a third one of no volume under its square base.
#[test]
fn a_sliver_on_a_flat_outer_facet_is_removed() {
    let mut nodes = SQUARE.to_vec();
    nodes.push([5.0, 5.0, 8.0]);
    let before = mesh(&nodes, &[([0, 1, 2, 4], 0), ([0, 2, 3, 4], 0), ([0, 1, 2, 3], 0)]);
    assert!(worst(&before) <= 0.0);
    let (after, mended) = checked(&before);
    assert_eq!((after.tets.len(), mended.of_body, mended.left), (2, vec![1, 0], 0));
    assert!(worst(&after) > 20.0);
}

/// The triangles of two bodies have different diagonals in their common square; a flat tet of one
/// of them lies between. The bodies need not lie on the same side of the square.
#[test]
fn a_sliver_on_an_interface_is_removed() {
    let mut nodes = SQUARE.to_vec();
    nodes.extend([[5.0, 5.0, 8.0], [5.0, 5.0, -8.0]]);
    for body in [0, 1] {
        let tets = [
            ([0, 1, 2, 4], 0),
            ([0, 2, 3, 4], 0),
            ([0, 1, 3, 5], 1),
            ([1, 2, 3, 5], 1),
            ([0, 1, 2, 3], body),
        ];
        let (after, mended) = checked(&mesh(&nodes, &tets));
        assert_eq!((after.tets.len(), mended.tets(), mended.left), (4, 1, 0));
        assert!(worst(&after) > 20.0);
    }
}

/// An octahedron with the axis along z. One node of its equator lies beside the axis, so that two
/// of the four tets are flat; around the diagonal through this node none is.
#[test]
fn four_tets_turn_about_another_diagonal() {
    let nodes = [
        [0.0, 0.0, 10.0],
        [0.0, 0.0, -10.0],
        [10.0, 0.0, 0.0],
        [0.0, 10.0, 0.0],
        [-10.0, 0.0, 0.0],
        [0.0, -0.01, 0.0],
    ];
    let tets = [[0, 1, 2, 3], [0, 1, 3, 4], [0, 1, 4, 5], [0, 1, 5, 2]];
    let before = mesh(&nodes, &tets.map(|t| (t, 0)));
    assert!((0.0..0.1).contains(&worst(&before)));
    let p = Polyhedron::new(&before);
    let mut d = Draft::new(&before, &p);
    let change = edge_removal(&d, 0, 1).expect("an inner edge");
    assert_eq!((change.gone.len(), change.come.len()), (4, 4));
    assert!(change.come.iter().all(|(t, _)| t.contains(&3) && t.contains(&5)));
    assert!(d.conforms(&change) && d.judge(&change, false).expect("same space") > 20.0);
    // the way back is the same change about the other diagonal
    d.make(change);
    let back = edge_removal(&d, 3, 5).expect("an inner edge");
    assert_eq!((back.gone.len(), back.come.len()), (4, 4));
    let (after, mended) = checked(&before);
    assert_eq!((after.tets.len(), mended.tets(), mended.left), (4, 2, 0));
}

/// Three tets around a line that passes just inside an edge of the triangle: one of them is a
/// sliver. Two tets at the triangle are none. The way back is the removal of a face.
#[test]
fn an_inner_sliver_goes_with_its_edge() {
    let nodes =
        [[0.0, 0.01, 8.0], [0.0, 0.01, -8.0], [-9.0, 0.0, 0.0], [9.0, 0.0, 0.0], [0.0, 9.0, 0.0]];
    let before = mesh(&nodes, &[[0, 1, 2, 3], [0, 1, 3, 4], [0, 1, 4, 2]].map(|t| (t, 0)));
    assert!((0.0..0.5).contains(&worst(&before)));
    let (after, mended) = checked(&before);
    assert_eq!((after.tets.len(), mended.tets(), mended.left), (2, 1, 0));
    let p = Polyhedron::new(&after);
    let d = Draft::new(&after, &p);
    let local = after.tets[0].iter().position(|n| *n < 2).expect("the end of the line");
    let back = face_removal(&d, 0, local as u8).expect("an inner face");
    assert_eq!((back.gone.len(), back.come.len()), (2, 3));
    assert!(d.conforms(&back) && d.judge(&back, false).expect("same space") < 0.5);
}

/// A block of 27 cubes; its inner node at (10, 10, 10) is moved beyond a face of one of its tets.
fn folded() -> TetMesh {
    let cells: Vec<_> = (0..27).map(|i| ([i % 3, i / 3 % 3, i / 9], "A")).collect();
    let mut mesh = cubes(&cells);
    let inner = mesh.nodes.iter_mut().find(|x| **x == [10.0; 3]).expect("a node");
    *inner = [19.0, 12.0, 24.0];
    mesh
}

#[test]
fn a_folded_mesh_is_unfolded() {
    let before = folded();
    assert!((0..before.tets.len()).any(|e| before.volume(e) < -1.0));
    let (after, mended) = checked(&before);
    assert!(worst(&after) > 10.0 && mended.left == 0 && mended.worst_before == 0.0);
    let volume: f64 = (0..after.tets.len()).map(|e| after.volume(e)).sum();
    assert!((volume / 27_000.0 - 1.0).abs() < 1e-12);
}

/// A flat tet that has no free node and no edge that can go stays, and the answer says so.
#[test]
fn a_body_that_is_flat_itself_is_not_mended() {
    let before = mesh(&SQUARE, &[([0, 1, 2, 3], 0)]);
    assert!(mend(&before, FLAT, &|| false).is_err());
    // one with a thin body is returned as it is
    let mut nodes = SQUARE;
    nodes[3][2] = 0.01;
    let before = mesh(&nodes, &[([0, 1, 2, 3], 0)]);
    let (after, mended) = mend(&before, FLAT, &|| false).unwrap_or_else(|e| panic!("{e}"));
    assert_eq!((after.tets, mended.left), (before.tets.clone(), 1));
    assert!(mended.words().contains("1 flat tets are left"), "{}", mended.words());
}

#[test]
fn an_interruption_ends_the_mending() {
    assert!(mend(&folded(), FLAT, &|| true).is_err());
}

/// Collapse and split keep facets and edges; a corner stays, a node of an edge stays on it.
#[test]
fn collapse_and_split_keep_the_polyhedron() {
    let cells: Vec<_> = (0..27).map(|i| ([i % 3, i / 3 % 3, i / 9], "A")).collect();
    let block = cubes(&cells);
    let p = Polyhedron::new(&block);
    let mut d = Draft::new(&block, &p);
    let node = |x: V3| block.nodes.iter().position(|y| *y == x).expect("a node") as u32;
    let (corner, line, next) = (node([0.0; 3]), node([10.0, 0.0, 0.0]), node([20.0, 0.0, 0.0]));
    let (plane, inner) = (node([10.0, 10.0, 0.0]), node([10.0; 3]));
    let freedoms = [corner, line, plane, inner].map(|n| d.freedom[n as usize]);
    assert!(matches!(freedoms, [Freedom::Fixed, Freedom::Line, Freedom::Plane(_), Freedom::Space]));
    for [from, to] in [[corner, line], [line, plane], [plane, inner]] {
        assert!(collapse(&d, from, to).is_none(), "{from} leaves its place");
    }
    assert!(best_move(&d, corner).is_none());
    for [from, to] in [[line, next], [plane, line], [inner, plane]] {
        let change = collapse(&d, from, to).expect("allowed");
        if d.judge(&change, true).is_some() && d.conforms(&change) {
            let undo = d.make(change);
            let made = rebuilt(&block, &p, d.clone());
            assert!(made.is_ok() || d.shape.iter().any(|s| *s <= 0.0), "{:?}", made.err());
            d.undo(undo);
        }
    }
    let state = |d: &Draft| format!("{:?} {:?} {:?} {:?}", d.nodes, d.tets, d.alive, d.triangles());
    let start = state(&d);
    for [a, b] in [[line, next], [plane, line], [inner, plane]] {
        let change = split(&d, a, b, 0.3);
        assert!(d.judge(&change, false).is_some() && d.conforms(&change));
        assert_eq!(change.freedom, Some(d.freedom[a as usize]));
        let undo = d.make(change);
        let made = rebuilt(&block, &p, d.clone()).expect("the same polyhedron");
        assert_eq!(made.nodes.len(), block.nodes.len() + 1);
        let new = d.nodes.len() as u32 - 1;
        let back = collapse(&d, new, a).expect("allowed");
        assert!(d.judge(&back, false).is_some() && d.conforms(&back));
        d.undo(undo);
        assert_eq!(state(&d), start);
    }
}

/// A change that leaves a gap is refused.
#[test]
fn a_change_that_does_not_fill_its_space_is_refused() {
    let block = folded();
    let p = Polyhedron::new(&block);
    let d = Draft::new(&block, &p);
    let change = Change { gone: vec![0], ..Change::default() };
    assert!(d.judge(&change, true).is_none());
    let tet = d.tets[0];
    let twice = Change { come: vec![(tet, 0)], ..Change::default() };
    assert!(!d.conforms(&twice) && d.judge(&twice, true).is_none());
}

/// Two blocks side by side, one of them in halves, with a named patch on top.
fn blocks() -> TetMesh {
    let cells: Vec<_> =
        (0..54).map(|i| ([i % 6, i / 6 % 3, i / 18], if i % 6 < 3 { "A" } else { "B" })).collect();
    let mut mesh = cubes(&cells);
    mesh.tet_region = (0..mesh.tets.len())
        .map(|e| {
            let low = mesh.corners(e).iter().all(|x| x[2] <= 10.0);
            2 * mesh.tet_body[e] + u32::from(low && mesh.tet_body[e] == 1)
        })
        .collect();
    let inside = |x: f64| (10.0..=20.0).contains(&x);
    name(&mut mesh, "FOOT", |x| x[2] == 30.0 && inside(x[0]) && inside(x[1]));
    mesh
}

/// Moves nodes at random as far as their freedoms allow, flattens or folds some tets, and puts flat
/// tets on outer facets.
fn spoiled(moves: &[[f64; 3]], flats: &[(usize, f64)], lids: &[usize]) -> TetMesh {
    let mut mesh = blocks();
    let p = Polyhedron::new(&mesh);
    let freedom = Draft::new(&mesh, &p).freedom;
    for (n, x) in mesh.nodes.iter_mut().enumerate() {
        let step = moves[n % moves.len()].map(|c| 2.0 * c);
        match freedom[n] {
            Freedom::Space => (0..3).for_each(|k| x[k] += step[k]),
            Freedom::Plane(f) => {
                let (axis, _) = p.facets[f as usize].constant.expect("a coordinate plane");
                (0..3).filter(|k| *k != axis).for_each(|k| x[k] += step[k]);
            }
            Freedom::Line | Freedom::Fixed => {}
        }
    }
    for (e, height) in flats {
        let tet = mesh.tets[e % mesh.tets.len()];
        // a free node of the tet goes to a height over the opposite face; negative ones fold it
        if let Some(i) = (0..4).find(|i| freedom[tet[*i] as usize] == Freedom::Space) {
            let base = crate::mesh::tet::FACES[i].map(|v| mesh.nodes[tet[v] as usize]);
            let x = mesh.nodes[tet[i] as usize];
            let normal = area_vector(&base);
            let own = dot(sub(x, base[0]), normal) / dot(normal, normal);
            mesh.nodes[tet[i] as usize] =
                std::array::from_fn(|k| x[k] + (height - 1.0) * own * normal[k]);
        }
    }
    for pick in lids {
        put_lid(&mut mesh, *pick);
    }
    orient::alike(&mut mesh).expect("no tets overlap");
    mesh
}

/// Puts a flat tet on two neighbouring outer triangles of one facet that make a convex square.
fn put_lid(mesh: &mut TetMesh, pick: usize) {
    let p = Polyhedron::new(mesh);
    let table = FaceTable::new(&mesh.tets);
    let outer: Vec<_> = p.triangles.iter().filter(|(t, _)| table.owners(*t).len() == 1).collect();
    let start = pick % outer.len();
    for (t, f) in outer[start..].iter().chain(&outer[..start]) {
        for (u, g) in &outer {
            let common: Vec<u32> = t.iter().filter(|n| u.contains(n)).copied().collect();
            let (true, [a, c]) = (f == g, &common[..]) else { continue };
            let own = |k: &[u32; 3]| k.iter().find(|n| !common.contains(n)).copied();
            let (Some(b), Some(d)) = (own(t), own(u)) else { continue };
            let area = |k: [u32; 3]| norm(area_vector(&k.map(|n| mesh.nodes[n as usize])));
            let (before, after) = (area(*t) + area(*u), area([*a, b, d]) + area([*c, b, d]));
            // the named patch must stay what it is
            let named = !p.facets[*f as usize].names.is_empty();
            // a lid on a lid of the same nodes would be the same tet
            if [*a, *c].iter().any(|n| !table.owners([*n, b, d]).is_empty()) {
                continue;
            }
            if (before - after).abs() < 1e-9
                && area([*a, b, d]).min(area([*c, b, d])) > 1.0
                && !named
            {
                let owner = table.owners(*t)[0].tet as usize;
                mesh.tets.push([*a, b, *c, d]);
                mesh.tet_body.push(mesh.tet_body[owner]);
                mesh.tet_region.push(mesh.tet_region[owner]);
                return;
            }
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(60))]
    #[test]
    fn spoiled_meshes_are_mended(
        moves in proptest::collection::vec(proptest::array::uniform3(-1.0f64..1.0), 5..40),
        flats in proptest::collection::vec((0usize..1000, -0.3f64..0.003), 1..4),
        lids in proptest::collection::vec(0usize..1000, 0..3),
    ) {
        let before = spoiled(&moves, &flats, &lids);
        let (after, mended) = checked(&before);
        prop_assert!(mended.left == 0, "{} of {} left", mended.left, mended.tets());
        let again = mend(&before, FLAT, &|| false).expect("mended");
        prop_assert_eq!(again, (after, mended));
    }
}
