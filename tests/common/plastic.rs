//! Runs a pass of elastic, perfectly plastic analysis and checks what must hold for every pass.

use super::yielding::model;
use super::{Random, points};
use bracket::analysis::energy_pass::EnergyPass;
use bracket::analysis::event::silent;
use bracket::analysis::hencky;
use bracket::analysis::pass::PassOptions;
use bracket::certify::PlasticField;
use bracket::certify::fields::StressField;
use bracket::certify::plastic_field::PlasticTet;
use bracket::mesh::TetMesh;
use bracket::model::AnalysisKind;
use bracket::model::AnalysisModel;

/// A model from YAML without `mesh`, `analysis` and `materials`.
pub fn plastic_model(yaml: &str, mesh: TetMesh) -> AnalysisModel {
    AnalysisModel { analysis: AnalysisKind::Elastoplastic, ..model(yaml, mesh) }
}

pub fn run(model: &AnalysisModel) -> EnergyPass {
    hencky::run(model, &PassOptions::default(), &silent()).unwrap()
}

/// Both bounds of the energy, after the checks that must hold for every pass.
pub fn strict(name: &str, model: &AnalysisModel) -> [f64; 2] {
    strict_pass(name, model, &run(model))
}

pub fn strict_pass(name: &str, model: &AnalysisModel, pass: &EnergyPass) -> [f64; 2] {
    for (program, r) in pass.runs() {
        assert!(r.status.is_solution(), "{name} {}: {:?}", program.name(), r.trouble);
        assert_eq!(r.trouble, None, "{name}");
        println!(
            "{name} {}: {} of {} tets, {} solves, {} iterations",
            program.name(),
            r.yielding.unwrap(),
            model.mesh.tets.len(),
            r.rounds,
            r.iterations
        );
    }
    let b = pass.bracket.as_ref().unwrap_or_else(|| panic!("{name}: no bracket"));
    assert!(b.is_strict(), "{name}: {:?} {:?}", b.lower().certificate(), b.upper().certificate());
    let [low, up] = [b.lower().value(), b.upper().value()];
    println!("{name}: [{low:.10e}, {up:.10e}], gap {:.3e}; {:?}", b.gap(), b.lower().certificate());
    let c = pass.contributions.as_ref().unwrap();
    let strain = b.lower().certificate().strain_energy.unwrap_or(0.0);
    let scale = low.abs().max(up.abs()).max(strain * f64::from(model.symmetry));
    let (sum, gap) = (c.total() * f64::from(model.symmetry), up - low);
    assert!((sum - gap).abs() <= 1e-8 * scale, "{name}: contributions {sum:e}, gap {gap:e}");
    let least = c.elements.iter().chain(&c.contacts).copied().fold(0.0, f64::min);
    assert!(least >= -1e-12 * scale, "{name}: contribution {least:e}");
    let (stress, field) = (pass.stress.as_ref().unwrap(), pass.plastic.as_ref().unwrap());
    points::check(name, model, stress, pass.displacement.as_ref().unwrap());
    inside_everywhere(name, model, stress);
    no_flow_where_nothing_yields(name, model, field);
    [low, up]
}

/// Checks von Mises' condition at random points of every subtet, computed from the six components.
fn inside_everywhere(name: &str, model: &AnalysisModel, stress: &StressField) {
    let mut random = Random::new(99);
    for (e, subtets) in stress.points.iter().enumerate() {
        let material =
            &model.materials[model.body_material[model.mesh.tet_body[e] as usize] as usize];
        let Some(fy) = material.fy else { continue };
        for at in subtets {
            let l: [f64; 4] = random.simplex();
            let s: [f64; 6] = std::array::from_fn(|c| (0..4).map(|p| l[p] * at[p][c]).sum());
            let shear: f64 = s[3..].iter().map(|x| x * x).sum();
            let normal = (s[0] - s[1]).powi(2) + (s[1] - s[2]).powi(2) + (s[2] - s[0]).powi(2);
            // each shear component contains a factor √2
            let mises = (0.5 * normal + 1.5 * shear).sqrt();
            assert!(mises <= fy * (1.0 + 1e-12), "{name}: tet {e}: {mises}");
        }
    }
}

fn no_flow_where_nothing_yields(name: &str, model: &AnalysisModel, field: &PlasticField) {
    for (tet, body) in field.tets.iter().zip(&model.mesh.tet_body) {
        let yields = model.materials[model.body_material[*body as usize] as usize].fy.is_some();
        assert!(yields || *tet == PlasticTet::Elastic, "{name}");
    }
}
