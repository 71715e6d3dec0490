//! Joints remeshed by Mmg: the same bodies, contacts and named faces.

use crate::assembly::Assembly;
use crate::geometry::fixtures::{lap_joint, paper_joint};
use crate::geometry::scene::Scene;
use crate::meshing::joint::{MeshOptions, mesh_joint};
use crate::meshing::naming::name_and_check;
use bracket_base::math::eigen::compose;
use bracket_base::math::mandel::Mandel;
use bracket_base::math::vec3::unit;
use bracket_engine::mesh::mmg::Remesher;
use bracket_engine::mesh::polyhedron::Polyhedron;
use bracket_engine::mesh::topology::sorted;
use bracket_engine::mesh::{TetMesh, quality};
use std::time::Duration;

const LIMIT: Duration = Duration::from_secs(300);

/// A metric whose directions and sizes change from place to place: short along a radius, four times
/// as long across it.
fn swirl(mesh: &TetMesh, size: f64) -> Vec<Mandel> {
    let one = |x: &[f64; 3]| {
        let a = unit([x[0] + 11.0, x[1] - 7.0, x[2] + 3.0]);
        let (b, c) = bracket_base::math::vec3::tangents(a);
        let h = size * (1.5 + (x[2] / 60.0).sin());
        compose([h, 2.0 * h, 4.0 * h].map(|h| h.powi(-2)), &[a, b, c])
    };
    mesh.nodes.iter().map(one).collect()
}

/// The joint meshed coarsely and remeshed.
fn remeshed(joint: &Assembly, factor: f64, size: f64) -> (TetMesh, TetMesh, Polyhedron) {
    let dir = tempfile::tempdir().expect("temporary folder");
    let mut options = MeshOptions::new(dir.path());
    options.sizes.factor = factor;
    let old = mesh_joint(joint, &options, &mut |_| ()).expect("meshes").mesh;
    let p = Polyhedron::new(&old);
    let remesher = Remesher::find().expect("scripts/setup.sh installs Mmg");
    let metric = swirl(&old, size);
    let new =
        remesher.remesh(&old, &p, &metric, &dir.path().join("mmg"), LIMIT, None).expect("remeshes");
    (old, new, p)
}

/// The same polyhedron, by three means: its own description is the same; volumes of bodies, areas
/// of contacts and named faces agree with the exact ones of the solids; the named faces are those
/// that are found by their coordinates.
fn check_kept(joint: &Assembly, old: &TetMesh, new: &TetMesh, p: &Polyhedron) {
    let q = Polyhedron::new(new);
    let counts = |p: &Polyhedron| {
        let mut body = p.body.clone();
        body.sort_unstable();
        (body, p.facets.len(), p.corners.len(), p.segments.len())
    };
    assert_eq!(counts(p), counts(&q));
    let mut corners: Vec<_> = p.corners.iter().map(|n| old.nodes[*n as usize]).collect();
    let mut again: Vec<_> = q.corners.iter().map(|n| new.nodes[*n as usize]).collect();
    let order = |a: &[f64; 3], b: &[f64; 3]| {
        (0..3)
            .map(|d| a[d].total_cmp(&b[d]))
            .find(|o| o.is_ne())
            .unwrap_or(std::cmp::Ordering::Equal)
    };
    corners.sort_by(order);
    again.sort_by(order);
    assert_eq!(corners, again);
    let mut named = new.clone();
    let checks = name_and_check(&mut named, &Scene::new(joint, false)).expect("agrees");
    for v in &checks.volumes {
        let mine: f64 = (0..new.tets.len())
            .filter(|e| new.bodies[new.tet_body[*e] as usize] == v.body)
            .map(|e| new.volume(e))
            .sum();
        let before: f64 = (0..old.tets.len())
            .filter(|e| old.bodies[old.tet_body[*e] as usize] == v.body)
            .map(|e| old.volume(e))
            .sum();
        assert!((mine / before - 1.0).abs() < 1e-9, "{}", v.body);
    }
    assert_eq!(named.faces.len(), new.faces.len());
    for (a, b) in named.faces.iter().zip(&new.faces) {
        let keys = |t: &[[u32; 3]]| {
            let mut k: Vec<_> = t.iter().map(|t| sorted(*t).0).collect();
            k.sort_unstable();
            k
        };
        assert_eq!((&a.name, keys(&a.triangles)), (&b.name, keys(&b.triangles)));
    }
    let worst = quality::table(new).iter().fold(f64::INFINITY, |w, b| w.min(b.worst_dihedral));
    println!("{} → {} tets, worst angle {worst:.1}", old.tets.len(), new.tets.len());
}

/// A lap joint with a bolt through both plates.
#[test]
fn a_bolted_joint_stays_the_same_body() {
    let joint = lap_joint();
    let (old, new, p) = remeshed(&joint, 1.5, 3.0);
    check_kept(&joint, &old, &new, &p);
}

/// The paper's joint: bolts with heads and nuts, fillets, stiffeners, footprint and load face,
/// plates in two half layers.
#[test]
fn the_paper_s_joint_stays_the_same_body() {
    let joint = paper_joint();
    let (old, new, p) = remeshed(&joint, 4.0, 40.0);
    assert!(p.body.len() > new.bodies.len(), "half layers are regions");
    check_kept(&joint, &old, &new, &p);
}
