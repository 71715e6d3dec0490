//! Fields as solvers return them: from the elastic, perfectly plastic programs near the limit load.
//! Their stress at a load that they carry gives a lower bound. Their displacements at a larger
//! load, projected to keep the volume, give an upper bound.

use super::cases;
use crate::common::Block;
use crate::common::yielding::{FY, block, model};
use bracket::certify::fields::{DisplacementField, StressField};
use bracket::certify::velocity_field::VelocityField;
use bracket::certify::{FactorBracket, LowerFactor, UpperFactor};
use bracket::elements::hencky_kinematic::Flow;
use bracket::elements::hencky_static::parameter_unit;
use bracket::elements::super_element::PARAMETERS;
use bracket::model::AnalysisModel;
use bracket::programs::{Kinematic, Static};
use bracket::recover::limit_lower::ApproximateStress;
use bracket::recover::{elastic, limit_lower, limit_upper};
use bracket::solve::{Patterns, SolveOptions, StopRules, condensed};

/// The stress parameters of every element in MPa, computed from the unknowns of the program.
fn stress_parameters(model: &AnalysisModel, statics: &Static, x: &[f64]) -> Vec<[f64; PARAMETERS]> {
    let radii = model.yield_radii();
    (0..model.mesh.tets.len())
        .map(|e| {
            let radius = radii[model.mesh.tet_body[e] as usize].unwrap();
            let unit = parameter_unit(&statics.elements.element(e).unwrap(), radius);
            std::array::from_fn(|a| unit * x[statics.own[e] + a])
        })
        .collect()
}

/// Both load factors of `at`, a load that the model carries. The velocities come from a larger
/// load, `further`.
fn bracket(name: &str, at: &AnalysisModel, further: &AnalysisModel) -> FactorBracket {
    let statics = Static::with_plasticity(at).unwrap();
    let s = condensed::Prepared::new(&statics.program, &statics.map.block, &Patterns::default())
        .unwrap()
        .solve(&SolveOptions::default());
    assert!(s.status.is_solution(), "{name}");
    let parameters = stress_parameters(at, &statics, &s.x);
    let contact = &s.z[..Static::new(at).unwrap().program.g.nrows()];
    let approximate =
        ApproximateStress { parameters: &parameters, contact, welds: &[], factor: 1.0 };
    let lower = limit_lower::project(at, &approximate, None, &Patterns::default()).unwrap();
    println!("{name}: {:?}", lower.certificate);
    let kinematic = Kinematic::with_plasticity(further, Flow::Split).unwrap();
    let k =
        condensed::Prepared::new(&kinematic.program, &kinematic.map.block, &Patterns::default())
            .unwrap()
            .solve(&SolveOptions::default());
    assert!(k.status.is_solution(), "{name}");
    let u = kinematic.map.expand(&k.x).chunks_exact(3).map(|c| [c[0], c[1], c[2]]).collect();
    let field =
        VelocityField { nodes: DisplacementField { u }, flow: Flow::Split, limit_motions: vec![] };
    let upper = limit_upper::project(at, &field, 1, &Patterns::default()).unwrap();
    println!("{name}: {:?}", upper.certificate);
    let bracket = FactorBracket::new(
        LowerFactor::new(lower.certificate),
        UpperFactor::new(upper.certificate),
    )
    .unwrap();
    println!(
        "{name}: [{}, {}], gap {:.4}",
        bracket.lower().value(),
        bracket.upper().value(),
        bracket.gap()
    );
    assert!(bracket.is_strict(), "{name}");
    bracket
}

/// The pressed and sheared block, clamped at its foot: the stress from the solver hardly needs to
/// be scaled back.
#[test]
fn clamped_block() {
    let b = bracket("block", &block(3, 1.0), &block(3, 1.2));
    assert!(b.lower().value() > 1.0 - 1e-4 && b.upper().value() < 1.4);
}

/// Two blocks with friction between them, pressed and pushed. Friction alone holds the upper one.
fn stacked(factor: f64) -> AnalysisModel {
    let shape =
        Block { cells: [2, 2, 4], min: [0.0; 3], max: [50.0, 50.0, 100.0], jitter: 0.2, seed: 3 };
    let mesh = shape.mesh(&["A", "B"], |c| usize::from(c[2] > 50.0), |d, x| d == 2 && x == 50.0);
    let (t, p) = (10.0 * factor, 200.0 * factor);
    model(
        &format!(
            "bodies: {{A: s, B: s}}\ninterfaces:\n- {{between: [A, B], law: contact, mu: 0.3, \
             friction: associated}}\nsupports:\n- {{face: Z0, fix: [x, y, z]}}\nloads:\n- {{face: \
             Z1, traction: [{t:?}, 0, {:?}]}}\n",
            -p
        ),
        mesh,
    )
}

#[test]
fn block_on_block() {
    let b = bracket("block on block", &stacked(0.8), &stacked(0.9));
    assert!(b.lower().value() > 1.0 - 1e-3 && b.upper().value() < 2.0);
}

/// The limit programs themselves, projected as in a pass of limit analysis.
fn limit(name: &str, m: &AnalysisModel, dead: Option<&StressField>) -> FactorBracket {
    let options = SolveOptions::default().with(StopRules::to_gap(1e-6));
    let statics = Static::limit(m).unwrap();
    let s = condensed::Prepared::new(&statics.program, &statics.map.block, &Patterns::default())
        .unwrap()
        .solve(&options);
    let (parameters, factor) = (stress_parameters(m, &statics, &s.x), s.x[s.x.len() - 1]);
    let contact = &s.z[..statics.program.g.nrows()];
    let approximate = ApproximateStress { parameters: &parameters, contact, welds: &[], factor };
    let lower = limit_lower::project(m, &approximate, dead, &Patterns::default()).unwrap();
    let kinematic = Kinematic::limit(m, Flow::Split).unwrap();
    let k =
        condensed::Prepared::new(&kinematic.program, &kinematic.map.block, &Patterns::default())
            .unwrap()
            .solve(&options);
    let u = kinematic.map.expand(&k.x).chunks_exact(3).map(|c| [c[0], c[1], c[2]]).collect();
    let field =
        VelocityField { nodes: DisplacementField { u }, flow: Flow::Split, limit_motions: vec![] };
    let upper = limit_upper::project(m, &field, 0, &Patterns::default()).unwrap();
    println!(
        "{name}: solver {} {factor:.9} and {} {:.9}",
        s.status.words(),
        k.status.words(),
        k.x[k.x.len() - 1]
    );
    println!("{name}: {:?}\n{name}: {:?}", lower.certificate, upper.certificate);
    let bracket = FactorBracket::new(
        LowerFactor::new(lower.certificate),
        UpperFactor::new(upper.certificate),
    )
    .unwrap();
    println!(
        "{name}: [{}, {}], gap {:.4}",
        bracket.lower().value(),
        bracket.upper().value(),
        bracket.gap()
    );
    assert!(bracket.is_strict(), "{name}");
    bracket
}

#[test]
fn limit_programs() {
    for seed in [1, 7] {
        for case in [cases::bar(seed), cases::bar_with_rigid_end(seed), cases::cube(seed)] {
            let b = limit(case.name, &case.model, None);
            assert!(
                b.gap() < 1e-3
                    && b.lower().value() <= case.factor
                    && b.upper().value() >= case.factor
            );
        }
    }
    limit("block", &block(3, 1.0), None);
    limit("block on block", &stacked(0.8), None);
}

/// B5 with a dead load: the sliding block yields as well.
#[test]
fn limit_programs_under_dead_load() {
    for seed in [1, 7] {
        let mut case = cases::sliding(seed);
        case.model.materials.iter_mut().for_each(|m| m.fy = Some(FY));
        let alone = case.model.without_live_loads();
        let statics = Static::new(&alone).unwrap();
        let elastic =
            bracket::solve::solve(&statics.program, &statics.map.block, &SolveOptions::default());
        let dead = elastic::stress(&statics, &elastic, &Patterns::default()).unwrap();
        let b = limit("sliding", &case.model, Some(&dead));
        assert!(
            b.gap() < 1e-2 && b.lower().value() <= case.factor && b.upper().value() >= case.factor
        );
    }
}
