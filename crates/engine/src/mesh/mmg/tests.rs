use super::*;
use bracket_base::diag::Diagnostic;
use bracket_base::math::eigen::compose;
use bracket_base::math::vec3::norm;
use std::path::PathBuf;

const LIMIT: Duration = Duration::from_secs(300);

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
