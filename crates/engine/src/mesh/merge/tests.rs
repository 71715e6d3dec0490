use super::*;
use crate::mesh::fixtures::{cubes, explode, name};
use bracket_base::diag::Diagnostic;

fn row() -> TetMesh {
    let mut mesh = cubes(&[([0, 0, 0], "A"), ([1, 0, 0], "B"), ([2, 0, 0], "C")]);
    name(&mut mesh, "AB", |x| x[0] == 10.0);
    mesh
}

#[test]
fn coincident_nodes_of_two_bodies_become_one() {
    let mesh = row();
    let mut apart = explode(&mesh);
    assert_eq!(apart.nodes.len(), 24);
    // round-off of the mesher, on both sides of a cell boundary
    for (i, x) in apart.nodes.iter_mut().enumerate() {
        x[0] += 1e-7 * (i % 3) as f64 - 1e-7;
        x[1] -= 1e-7 * (i % 2) as f64;
    }
    assert_eq!(merge_coincident(&mut apart).expect("merge"), 8);
    assert_eq!(apart.nodes.len(), 16);
    let table = FaceTable::new(&apart.tets);
    assert_eq!(
        table.faces().filter(|o| o.len() == 2).count(),
        FaceTable::new(&mesh.tets).faces().filter(|o| o.len() == 2).count()
    );
    assert!(apart.faces[0].triangles.iter().all(|t| table.owners(*t).len() == 2));
    check_matching(&apart, &table).expect("matching");
}

#[test]
fn nodes_farther_apart_stay_apart() {
    let mut apart = explode(&row());
    for (t, b) in apart.tets.iter().zip(&apart.tet_body) {
        for n in t {
            // body B is a thousandth of a millimetre away
            if *b == 1 {
                apart.nodes[*n as usize][1] =
                    (apart.nodes[*n as usize][1] / 10.0).round() * 10.0 + 1e-3;
            }
        }
    }
    assert_eq!(merge_coincident(&mut apart).expect("nothing to merge"), 0);
}

#[test]
fn near_nodes_of_one_body_are_an_error() {
    let mut apart = explode(&row());
    let far = apart.tets[0][3];
    let near = apart.tets[0][0];
    apart.nodes[far as usize] = apart.nodes[near as usize];
    let d: Diagnostic = merge_coincident(&mut apart).expect_err("near").into();
    assert_eq!(d.code, "mesh/near-nodes");
    assert!(d.message.contains("body `A`"), "{d:?}");
}

#[test]
fn different_diagonals_are_an_error() {
    let mesh = cubes(&[([0, 0, 0], "A"), ([1, 0, 0], "B")]);
    let mut apart = explode(&mesh);
    // B mirrored in y: the same nodes, but the other diagonals
    let own: Vec<u32> = apart.tets[6..].iter().flatten().copied().collect();
    let own: std::collections::BTreeSet<u32> = own.into_iter().collect();
    for n in own {
        apart.nodes[n as usize][1] = 10.0 - apart.nodes[n as usize][1];
    }
    for t in &mut apart.tets[6..] {
        t.swap(2, 3);
    }
    merge_coincident(&mut apart).expect("nodes match");
    let d: Diagnostic =
        check_matching(&apart, &FaceTable::new(&apart.tets)).expect_err("diagonals").into();
    assert_eq!(d.code, "mesh/not-matching");
    assert!(
        d.message.contains("`A` and `B`") && d.help.expect("help").contains("BooleanFragments")
    );
}
