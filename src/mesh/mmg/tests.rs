use super::*;
use crate::assembly::Assembly;
use crate::diag::Diagnostic;
use crate::geometry::fixtures::{lap_joint, paper_joint};
use crate::geometry::scene::Scene;
use crate::math::eigen::compose;
use crate::math::vec3::{norm, unit};
use crate::mesh::joint::{MeshOptions, mesh_joint};
use crate::mesh::naming::name_and_check;
use crate::mesh::quality;
use crate::mesh::topology::sorted;
use std::path::PathBuf;

const LIMIT: Duration = Duration::from_secs(300);

/// A metric whose directions and sizes change from place to place: short along a radius, four times
/// as long across it.
fn swirl(mesh: &TetMesh, size: f64) -> Vec<Mandel> {
    let one = |x: &[f64; 3]| {
        let a = unit([x[0] + 11.0, x[1] - 7.0, x[2] + 3.0]);
        let (b, c) = crate::math::vec3::tangents(a);
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
    let (old, new, p) = remeshed(&joint, 2.5, 25.0);
    assert!(p.body.len() > new.bodies.len(), "half layers are regions");
    check_kept(&joint, &old, &new, &p);
}

/// Edges follow the metric: on a block the mean length of edges in the metric is about 1 in every
/// direction, and the number of tets follows its determinant.
#[test]
fn edges_follow_the_metric() {
    let cells: Vec<_> = (0..216).map(|i| ([i % 6, i / 6 % 6, i / 36], "B")).collect();
    let mesh = crate::mesh::fixtures::cubes(&cells);
    let p = Polyhedron::new(&mesh);
    let dir = tempfile::tempdir().expect("temporary folder");
    let remesher = Remesher::find().expect("scripts/setup.sh installs Mmg");
    let h = [3.0, 6.0, 12.0];
    let metric =
        vec![
            compose(h.map(|h: f64| h.powi(-2)), &[[1., 0., 0.], [0., 1., 0.], [0., 0., 1.]]);
            mesh.nodes.len()
        ];
    let new = remesher.remesh(&mesh, &p, &metric, dir.path(), LIMIT, None).expect("remeshes");
    // edges that lie mainly along one axis, measured in units of the metric
    for axis in 0..3 {
        let mut along = Vec::new();
        for t in &new.tets {
            for [i, j] in crate::mesh::tet::EDGES {
                let d: [f64; 3] = std::array::from_fn(|k| {
                    (new.nodes[t[j] as usize][k] - new.nodes[t[i] as usize][k]) / h[k]
                });
                if d[axis].abs() > 0.9 * norm(d) {
                    along.push(norm(d));
                }
            }
        }
        let mean = along.iter().sum::<f64>() / along.len() as f64;
        println!("axis {axis}: {} edges, mean {mean:.3}", along.len());
        assert!((0.75..1.35).contains(&mean), "{mean}");
    }
    let units = 216e3 / h.iter().product::<f64>() * 6.0 * std::f64::consts::SQRT_2;
    let ratio = new.tets.len() as f64 / units;
    println!("{} tets, {units:.0} regular ones, ratio {ratio:.2}", new.tets.len());
    assert!((0.6..2.2).contains(&ratio), "{ratio}");
}

/// An executable made of shell commands.
#[cfg(unix)]
fn script(dir: &std::path::Path, body: &str) -> PathBuf {
    use std::os::unix::fs::PermissionsExt;
    let file = dir.join("mmg3d");
    std::fs::write(&file, format!("#!/bin/sh\n{body}\n")).expect("write");
    std::fs::set_permissions(&file, std::fs::Permissions::from_mode(0o755)).expect("executable");
    file
}

/// A program that is not Mmg, and runs that end badly, are told apart.
#[cfg(unix)]
#[test]
fn wrong_programs_are_told_apart() {
    let dir = tempfile::tempdir().expect("temporary folder");
    let fault = |body: &str| -> Diagnostic {
        let command = vec![script(dir.path(), body).into()];
        let remesher = match Remesher::with_command(command) {
            Ok(remesher) => remesher,
            Err(error) => return error.into(),
        };
        let mesh = crate::mesh::fixtures::cubes(&[([0, 0, 0], "B")]);
        let p = Polyhedron::new(&mesh);
        let metric = vec![[0.01, 0.01, 0.01, 0.0, 0.0, 0.0]; mesh.nodes.len()];
        let work = dir.path().join("work");
        remesher
            .remesh(&mesh, &p, &metric, &work, Duration::from_secs(2), None)
            .expect_err("a bad run")
            .into()
    };
    let answers = "[ \"$1\" = -h ] && echo '-- MMG3D, Release 5.8.0 (today)' && exit 0\n";
    for (body, code, words) in [
        ("echo 4.15.2".to_string(), "mesher/version", "does not answer `-h`: `4.15.2`"),
        (format!("{answers}exit 0"), "mesher/no-output", "it is absent"),
        (format!("{answers}echo '  ## Error: bad'; exit 1"), "mesher/failed", "Error: bad"),
        (format!("{answers}echo End > out.mesh"), "mesher/no-output", "no tetrahedra"),
        (format!("{answers}sleep 9"), "mesher/time", "after 2 s"),
        (
            format!("{answers}sed 's/^0 0 10 0/0 0 11 0/' in.mesh > out.mesh"),
            "mesher/other-body",
            "changed the bodies",
        ),
    ] {
        let d = fault(&body);
        assert_eq!(d.code, code, "{}", d.message);
        assert!(d.message.contains(words), "{}", d.message);
    }
    let missing = Remesher::with_command(vec!["no-such-program-anywhere".into()]);
    assert!(matches!(missing, Err(MesherError::Start { .. })), "{missing:?}");
}

/// The mesh is passed through by a program that copies it: nothing but the run itself changes.
#[cfg(unix)]
#[test]
fn a_copy_is_accepted() {
    let dir = tempfile::tempdir().expect("temporary folder");
    let body = "[ \"$1\" = -h ] && echo 'MMG3D, Release 5.8.0 x' && exit 0\ncp in.mesh out.mesh";
    let remesher = Remesher::with_command(vec![script(dir.path(), body).into()]).expect("answers");
    assert_eq!(remesher.version, "5.8.0");
    let mesh = crate::mesh::fixtures::cubes(&[([0, 0, 0], "B")]);
    let p = Polyhedron::new(&mesh);
    let metric = vec![[0.01, 0.01, 0.01, 0.0, 0.0, 0.0]; mesh.nodes.len()];
    let work = dir.path().join("work");
    let new = remesher.remesh(&mesh, &p, &metric, &work, LIMIT, None).expect("a copy");
    assert_eq!(new, mesh);
}
