//! Meshes whose bounds contradict each other.

use super::*;
use crate::driver::limits::Limits;
use crate::driver::passes::Share;
use bracket_base::yaml;
use bracket_engine::mesh::{NamedFaces, TetMesh};
use bracket_engine::model::file::ModelFile;
use bracket_engine::model::resolve::resolve;
use bracket_engine::solve::{Patterns, StopRules};
use bracket_report::console::log::Log;
use std::path::Path;
use std::sync::Arc;

/// A cube of 10 mm with the yield strength `fy` \[MPa\], clamped below and pulled above.
fn pulled(fy: f64) -> Mesh {
    let nodes = (0..8).map(|i| [0, 1, 2].map(|d| 10.0 * f64::from(i >> d & 1))).collect();
    let steps = [[1, 2], [2, 1], [1, 4], [4, 1], [2, 4], [4, 2]];
    let tets = steps.map(|[a, b]| {
        let mut tet = [0, a, a + b, 7];
        if [[2, 1], [1, 4], [4, 2]].contains(&[a, b]) {
            tet.swap(0, 1);
        }
        tet
    });
    let face = |name: &str, triangles: [[u32; 3]; 2]| NamedFaces {
        name: name.into(),
        triangles: triangles.to_vec(),
    };
    let mesh = TetMesh {
        nodes,
        tets: tets.to_vec(),
        tet_body: vec![0; 6],
        bodies: vec!["A".into()],
        faces: vec![face("BASE", [[0, 1, 3], [0, 2, 3]]), face("TOP", [[4, 5, 7], [4, 6, 7]])],
        ..TetMesh::default()
    };
    let text = format!(
        "mesh: m.msh\nanalysis: limit\nmaterials: {{s: {{E: 210000, nu: 0.3, fy: {fy}}}}}\n\
         bodies: {{A: s}}\nsupports: [{{face: BASE, fix: [x, y, z]}}]\nloads: [{{face: TOP, \
         traction: [0, 0, 1]}}]\n"
    );
    let parsed = yaml::parse::<ModelFile>(&text, Path::new("model.yaml")).expect("YAML");
    let model = resolve(&parsed.value, mesh, &|path| parsed.index.place(path)).expect("sound");
    Mesh { model, made: None, seconds: None, predicted: None }
}

/// A later mesh whose upper bound is below the first lower bound, because its steel is weaker,
/// is left out with a warning. The bounds of the first mesh remain.
#[test]
fn a_contradiction_keeps_what_was_certified() {
    let (limits, patterns) = (Limits::default(), Patterns::default());
    let log = Arc::new(Log::new(true));
    let share = Share {
        until: f64::INFINITY,
        both_within: f64::INFINITY,
        first_stop: StopRules::default(),
        patterns: &patterns,
        evidence: None,
        decide: false,
    };
    let mut passes = Passes::new("PULL".into(), share, &limits, &log);
    passes.run(pulled(235.0)).expect("the first mesh");
    let before = passes.joined().expect("bounds").factor_bounds();
    assert!(before.0.is_some_and(|l| l > 200.0) && before.1.is_some(), "{before:?}");
    assert!(!passes.run_beside(pulled(100.0)).expect("a warning, no error"));
    assert_eq!((passes.entries.len(), passes.kept.len()), (1, 1));
    let joined = passes.joined().expect("bounds");
    assert_eq!(joined.factor_bounds(), before);
    let says = |w: &bracket_base::words::Text| {
        w.to_string().starts_with("mesh 2 is left out: its bounds contradict")
    };
    assert!(joined.warnings.iter().any(says), "{:?}", joined.warnings);
    // one that agrees counts
    assert!(passes.run_beside(pulled(235.0)).expect("a mesh"));
    assert_eq!(passes.entries.len(), 2);
}
