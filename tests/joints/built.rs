//! Builds spec text → joint → mesh → model, gives access to the model file and the mesh, and runs
//! both programs.

use bracket::analysis::event::silent;
use bracket::analysis::pass::PassOptions;
use bracket::analysis::{elastic, limit};
use bracket::assembly::Joint;
use bracket::catalog::Catalog;
use bracket::checks::design_code::build;
use bracket::checks::design_strengths;
use bracket::diag::Place;
use bracket::mesh::TetMesh;
use bracket::meshing::joint::{MeshOptions, mesh_joint};
use bracket::model::AnalysisKind;
use bracket::model::file::ModelFile;
use bracket::model::resolve::resolve;
use bracket::model_file::{Asked, cases, model_file};
use bracket::solve::{SolveOptions, StopRules};
use bracket::spec::ConnectionSpec;
use bracket::yaml;
use std::path::Path;

/// The joint that a spec describes.
pub fn joint(spec: &str) -> Joint {
    let parsed = yaml::parse::<ConnectionSpec>(spec, Path::new("joint.yaml")).unwrap();
    build(&parsed, Path::new("."), &Catalog::builtin().unwrap())
        .unwrap_or_else(|e| panic!("{e:#?}"))
}

/// Model file and mesh of the first load case. The elements are `factor` times as large as usual.
/// With a factor above 2 there are no planes at mid-thickness, for as few elements as possible.
pub fn model(joint: &Joint, factor: f64, full: bool, kind: AnalysisKind) -> (ModelFile, TetMesh) {
    model_of(joint, factor, full, (kind, false))
}

/// The same with bolts that stay elastic.
pub fn model_with_elastic_bolts(
    joint: &Joint,
    factor: f64,
    full: bool,
    kind: AnalysisKind,
) -> (ModelFile, TetMesh) {
    model_of(joint, factor, full, (kind, true))
}

fn model_of(
    joint: &Joint,
    factor: f64,
    full: bool,
    (kind, elastic_bolts): (AnalysisKind, bool),
) -> (ModelFile, TetMesh) {
    let folder = tempfile::tempdir().unwrap();
    let mut options = MeshOptions::new(folder.path());
    options.full = full;
    options.sizes.factor = factor;
    options.layers = factor <= 2.0;
    let m = mesh_joint(&joint.assembly, &options, &mut |_| {}).unwrap_or_else(|e| panic!("{e:#?}"));
    let case = &cases(&joint.assembly)[0];
    let (assembly, strengths) = (&joint.assembly, design_strengths(joint));
    let asked = Asked { elastic_bolts, ..Asked::new(case, kind) };
    let file = model_file(assembly, &strengths, &m.mesh, &m.symmetry_used, "mesh.msh", &asked);
    (file, m.mesh)
}

/// Both strict bounds of the whole structure: energies \[N mm\] or load factors.
pub fn bounds(name: &str, file: &ModelFile, mesh: &TetMesh) -> [f64; 2] {
    bounds_by(name, file, mesh, &PassOptions::default())
}

/// The same of limit analysis, solved to a gap of 1e-7.
pub fn sharp_bounds(name: &str, file: &ModelFile, mesh: &TetMesh) -> [f64; 2] {
    let solve = SolveOptions::default().with(StopRules::to_limit_gap(1e-7));
    bounds_by(name, file, mesh, &PassOptions { solve, ..PassOptions::default() })
}

fn bounds_by(name: &str, file: &ModelFile, mesh: &TetMesh, options: &PassOptions) -> [f64; 2] {
    let model = resolve(file, mesh.clone(), &|_| Place::default())
        .unwrap_or_else(|e| panic!("{name}: {e:#?}"));
    let [lower, upper] = if file.analysis == AnalysisKind::Limit {
        let pass = limit::run(&model, options, &silent()).unwrap();
        let b = pass.bracket.as_ref().unwrap_or_else(|| panic!("{name}: no bracket"));
        assert!(b.is_strict(), "{name}: {b:?}");
        [b.lower().value(), b.upper().value()]
    } else {
        let pass = elastic::run(&model, options, &silent()).unwrap();
        let b = pass.bracket.as_ref().unwrap_or_else(|| panic!("{name}: no bracket"));
        assert!(b.is_strict(), "{name}: {b:?}");
        [b.lower().value(), b.upper().value()]
    };
    println!("{name}: {} tets, [{lower:.10e}, {upper:.10e}]", mesh.tets.len());
    [lower, upper]
}
