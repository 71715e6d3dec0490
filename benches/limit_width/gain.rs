//! What finer elements in one zone alone give: the gain of a bound per 1 000 tets.
//!
//! Mmg makes each mesh from the metric of the present one, with lengths divided by a number in the
//! zone. Zones: everything, the rest of each body, the inside of each contact and its edge.

use bracket::analysis::event::Progress;
use bracket::analysis::limit;
use bracket::analysis::pass::PassOptions;
use bracket::math::mandel::Mandel;
use bracket::mesh::mmg::{MENDED, Remesher};
use bracket::mesh::polyhedron::Polyhedron;
use bracket::mesh::{TetMesh, mend, msh};
use bracket::model::AnalysisModel;
use bracket::model::file::{Bounds, ModelFile};
use bracket::model::resolve::resolve;
use bracket::refine::metric;
use std::collections::BTreeMap;
use std::path::Path;
use std::sync::Arc;
use std::time::Duration;

/// Prints the table for the model of a file, whose bodies share nodes.
pub fn table(path: &Path, bounds: Bounds, finer: f64) {
    let text = std::fs::read_to_string(path).expect("the model file is read");
    let parsed = bracket::yaml::parse::<ModelFile>(&text, path).expect("the model file is sound");
    let file = parsed.value;
    let mesh = msh::read(&path.with_file_name(&file.mesh)).expect("the mesh is read");
    let mesh = TetMesh { tet_region: Vec::new(), ..mesh };
    let model = |mesh: TetMesh| {
        let model = resolve(&file, mesh, &|path| parsed.index.place(path)).expect("a sound model");
        AnalysisModel { bounds, ..model }
    };
    let zones = zones(&model(mesh.clone()), &mesh);
    let (polyhedron, own) = (Polyhedron::new(&mesh), metric::own(&mesh));
    let (remesher, folder) = (Remesher::find().expect("Mmg"), tempfile::tempdir().unwrap());
    let remesh = |scale: f64, zone: Option<&[bool]>| -> TetMesh {
        let at = |(n, t): (usize, &Mandel)| {
            let here = zone.is_some_and(|z| z[n]);
            let factor = scale * if here { finer * finer } else { 1.0 };
            t.map(|x| factor * x)
        };
        let tensors: Vec<Mandel> = own.iter().enumerate().map(at).collect();
        let limit = Duration::from_secs(300);
        let made = remesher.remesh(&mesh, &polyhedron, &tensors, folder.path(), limit, None);
        let made = made.expect("Mmg makes a mesh");
        mend::mend(&made, MENDED, &|| false).map_or(made, |(mended, _)| mended)
    };
    let bound = |mesh: TetMesh| {
        let progress: Progress = Arc::new(|_, _| {});
        let pass = limit::run(&model(mesh), &PassOptions::default(), &progress).expect("a pass");
        match bounds {
            Bounds::Kinematic => pass.upper.map(|b| b.value()),
            _ => pass.lower.map(|b| b.value()),
        }
        .unwrap_or(f64::NAN)
    };
    // a metric makes more tets than its own mesh has
    let count = mesh.tets.len() as f64;
    let mut scale = 0.7;
    for _ in 0..3 {
        scale *= (count / remesh(scale, None).tets.len() as f64).powf(2.0 / 3.0);
    }
    let base = remesh(scale, None);
    let (tets, value) = (base.tets.len(), bound(base));
    println!(
        "{count} tets: {:.5}; remade by their own metric, {tets} tets: {value:.5}",
        bound(mesh.clone())
    );
    println!("  zone                            nodes   more tets      bound    gain   per 1 000");
    for (name, zone) in &zones {
        let nodes = zone.iter().filter(|z| **z).count();
        let made = remesh(scale, Some(zone));
        let (more, found) = (made.tets.len() as f64 - tets as f64, bound(made));
        let gain = if bounds == Bounds::Kinematic { value - found } else { found - value };
        println!(
            "  {name:30} {nodes:6} {more:11.0} {found:10.5} {gain:7.4} {:11.4}",
            1e3 * gain / more
        );
    }
}

/// The nodes of each zone by its name.
fn zones(model: &AnalysisModel, shared: &TetMesh) -> Vec<(String, Vec<bool>)> {
    let mut zones: BTreeMap<String, Vec<bool>> = BTreeMap::new();
    let none = vec![false; shared.nodes.len()];
    let key = |x: &[f64; 3]| x.map(f64::to_bits);
    let place: BTreeMap<[u64; 3], usize> =
        shared.nodes.iter().enumerate().map(|(n, x)| (key(x), n)).collect();
    let at = |n: u32| place[&key(&model.mesh.nodes[n as usize])];
    let mut taken = none.clone();
    let contacts = model.interfaces.iter().map(|i| (&i.name, &i.faces));
    for (name, faces) in contacts {
        let mut edges: BTreeMap<[usize; 2], usize> = BTreeMap::new();
        for f in faces {
            let n = f.nodes_a.map(at);
            for (a, b) in [(0, 1), (1, 2), (2, 0)] {
                *edges.entry([n[a].min(n[b]), n[a].max(n[b])]).or_default() += 1;
            }
        }
        let mut edge = none.clone();
        let outer = edges.iter().filter(|(_, count)| **count == 1);
        outer.for_each(|(nodes, _)| nodes.iter().for_each(|n| edge[*n] = true));
        let mut inner = none.clone();
        edges.keys().flatten().filter(|n| !edge[**n]).for_each(|n| inner[*n] = true);
        edges.keys().flatten().for_each(|n| taken[*n] = true);
        zones.insert(format!("contact {name}, edge"), edge);
        zones.insert(format!("contact {name}, inside"), inner);
    }
    for (tet, body) in shared.tets.iter().zip(&shared.tet_body) {
        let name = shared.bodies[*body as usize].clone();
        let zone = zones.entry(name).or_insert_with(|| none.clone());
        tet.iter().map(|n| *n as usize).filter(|n| !taken[*n]).for_each(|n| zone[n] = true);
    }
    let all = ("all".into(), vec![true; shared.nodes.len()]);
    [all].into_iter().chain(zones).collect()
}
