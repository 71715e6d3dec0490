use super::*;
use crate::mesh::fixtures::{cubes, name};
use crate::mesh::medit::{MeditMesh, mesh_text, parse};

/// Two blocks with named faces, and the file of their mesh.
fn blocks() -> (TetMesh, Polyhedron, MeditMesh) {
    let cells: Vec<_> =
        (0..54).map(|i| ([i % 6, i / 6 % 3, i / 18], if i % 6 < 3 { "A" } else { "B" })).collect();
    let mut mesh = cubes(&cells);
    name(&mut mesh, "BASE", |x| x[2] == 0.0);
    name(&mut mesh, "BETWEEN", |x| x[0] == 30.0);
    let p = Polyhedron::new(&mesh);
    let made = parse(&mesh_text(&mesh.nodes, &mesh.tets, &p)).expect("own file");
    (mesh, p, made)
}

fn node_at(mesh: &MeditMesh, x: V3) -> usize {
    mesh.nodes.iter().position(|y| *y == x).expect("a node of the grid")
}

/// The written mesh reads back to the same mesh with the same names.
#[test]
fn nothing_is_lost() {
    let (mesh, p, made) = blocks();
    let back = restore(&mesh, &p, made).expect("unchanged");
    assert_eq!(
        (&back.nodes, &back.tets, &back.tet_body),
        (&mesh.nodes, &mesh.tets, &mesh.tet_body)
    );
    for (old, new) in mesh.faces.iter().zip(&back.faces) {
        let keys = |f: &NamedFaces| {
            let mut k: Vec<_> = f.triangles.iter().map(|t| sorted(*t).0).collect();
            k.sort_unstable();
            k
        };
        assert_eq!((&old.name, keys(old)), (&new.name, keys(new)));
    }
}

/// Nodes that are off by rounding come back exactly onto their plane, line or corner; a node
/// inside may move.
#[test]
fn nodes_are_placed_exactly() {
    let (mesh, p, mut made) = blocks();
    for (x, off) in [
        ([10.0, 10.0, 30.0], [0.5, -0.3, 1e-6]),
        ([10.0, 0.0, 30.0], [2.0, 1e-6, -1e-6]),
        ([30.0, 30.0, 30.0], [1e-6, 1e-6, -1e-6]),
        ([30.0, 10.0, 10.0], [-1e-6, 1.0, 1.0]),
        ([10.0, 10.0, 10.0], [1.0, 1.0, 1.0]),
    ] {
        let n = node_at(&made, x);
        made.nodes[n] = std::array::from_fn(|d| x[d] + off[d]);
    }
    let back = restore(&mesh, &p, made).expect("the same polyhedron");
    for x in [[10.5, 9.7, 30.0], [12.0, 0.0, 30.0], [30.0; 3], [30.0, 11.0, 11.0], [11.0; 3]] {
        assert!(back.nodes.contains(&x), "{x:?}");
    }
}

/// Each way to change the bodies is refused.
#[test]
fn changes_are_refused() {
    let (mesh, p, good) = blocks();
    let refused = |change: &dyn Fn(&mut MeditMesh)| {
        let mut made = good.clone();
        change(&mut made);
        restore(&mesh, &p, made).expect_err("a change")
    };
    let moved = |x: V3, to: V3| {
        refused(&move |m: &mut MeditMesh| {
            let n = node_at(m, x);
            m.nodes[n] = to;
        })
    };
    assert_eq!(moved([10.0, 10.0, 30.0], [10.0, 10.0, 30.1]), "a node left its plane or line");
    assert_eq!(moved([10.0, 0.0, 30.0], [10.0, 0.1, 30.0]), "a node left its plane or line");
    assert_eq!(moved([0.0; 3], [0.0, 0.0, 0.1]), "an edge was lost");
    // a node of an inner edge pulled beyond the side of the block
    let beyond = moved([30.0, 10.0, 10.0], [30.0, -10.0, 10.0]);
    assert!(["changed", "flat", "overlap"].iter().any(|w| beyond.contains(w)), "{beyond}");
    let lost = refused(&|m| {
        m.triangles.pop();
    });
    assert!(lost.contains("was lost"), "{lost}");
    let other = refused(&|m| m.triangles[0].1 = 11);
    assert!(other.contains("was lost") || other.contains("changed"), "{other}");
    let body = refused(&|m| m.tets[0].1 = 3 - m.tets[0].1);
    assert!(body.contains("was lost"), "{body}");
    assert!(refused(&|m| m.tets[0].1 = 7).contains("unknown reference"));
    let hole = refused(&|m| {
        m.tets.remove(20);
    });
    assert!(hole.contains("was lost"), "{hole}");
    let twice = refused(&|m| {
        let t = m.tets[5];
        m.tets.push(t);
    });
    assert!(twice.contains("overlap"), "{twice}");
}

/// Nodes off a slanted plane are projected along its normal.
#[test]
fn slanted_planes() {
    let (mut mesh, ..) = blocks();
    let slant = |x: V3| [x[0] + 0.3 * x[2], x[1], x[2] + 0.2 * x[1]];
    mesh.nodes.iter_mut().for_each(|x| *x = slant(*x));
    let p = Polyhedron::new(&mesh);
    assert_eq!((p.facets.len(), p.corners.len()), (11, 12));
    let mut made = parse(&mesh_text(&mesh.nodes, &mesh.tets, &p)).expect("own file");
    let n = node_at(&made, slant([10.0, 10.0, 30.0]));
    made.nodes[n][2] += 1e-6;
    let back = restore(&mesh, &p, made).expect("the same polyhedron");
    let top = p
        .facets
        .iter()
        .find(|f| f.sides[1].is_none() && f.normal[2].abs() > 0.9 && f.point[2] > 20.0)
        .expect("the top");
    let worst = back
        .nodes
        .iter()
        .map(|x| dot(top.normal, sub(*x, top.point)).abs())
        .filter(|d| *d < 1e-3)
        .fold(0.0, f64::max);
    assert!(worst < 1e-13, "{worst:e}");
}
