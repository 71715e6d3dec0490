//! Fields as solvers leave them: the elastic, perfectly plastic programs near the limit load. Their stress at a load they
//! carry is a lower bound there; their displacements beyond it, made to keep the volume, an upper one.

use crate::common::Block;
use crate::common::yielding::{block, model};
use bracket::bounds::fields::DisplacementField;
use bracket::bounds::flow::VelocityField;
use bracket::bounds::limit_lower::{self, ApproximateStress};
use bracket::bounds::limit_upper;
use bracket::bounds::{FactorBracket, LowerFactor, UpperFactor};
use bracket::model::{AnalysisModel, Flow, Kinematic, Static};
use bracket::solve::{SolveOptions, SolveStatus, condensed};

/// Both factors of `at`, whose load it carries; the velocities are those of a load further on.
fn bracket(name: &str, at: &AnalysisModel, further: &AnalysisModel) -> FactorBracket {
    let statics = Static::with_plasticity(at).unwrap();
    let s = condensed::Prepared::new(&statics.program, &statics.map.block).unwrap().solve(&SolveOptions::default());
    assert_eq!(s.status, SolveStatus::Optimal, "{name}");
    let parameters = statics.parameters(&s.x).unwrap();
    let contact = &s.z[..Static::new(at).unwrap().program.g.nrows()];
    let approximate = ApproximateStress { parameters: &parameters, contact, factor: 1.0 };
    let lower = limit_lower::project(at, &approximate, None).unwrap();
    println!("{name}: {:?}", lower.certificate);
    let kinematic = Kinematic::with_plasticity(further, Flow::Split).unwrap();
    let k = condensed::Prepared::new(&kinematic.program, &kinematic.map.block).unwrap().solve(&SolveOptions::default());
    assert_eq!(k.status, SolveStatus::Optimal, "{name}");
    let u = kinematic.map.expand(&k.x).chunks_exact(3).map(|c| [c[0], c[1], c[2]]).collect();
    let field = VelocityField { nodes: DisplacementField { u }, flow: Flow::Split };
    let upper = limit_upper::project(at, &field, 1).unwrap();
    println!("{name}: {:?}", upper.certificate);
    let bracket = FactorBracket::new(LowerFactor::new(lower.certificate), UpperFactor::new(upper.certificate)).unwrap();
    println!("{name}: [{}, {}], gap {:.4}", bracket.lower().value(), bracket.upper().value(), bracket.gap());
    assert!(bracket.is_strict(), "{name}");
    bracket
}

/// The pressed and sheared block, clamped at its foot: the solver's stress needs hardly any drawing in.
#[test]
fn clamped_block() {
    let b = bracket("block", &block(3, 1.0), &block(3, 1.2));
    assert!(b.lower().value() > 1.0 - 1e-4 && b.upper().value() < 1.4);
}

/// Two blocks with friction between them, the upper one held by nothing else, pressed and pushed.
#[test]
fn block_on_block() {
    let stacked = |factor: f64| {
        let shape = Block { cells: [2, 2, 4], min: [0.0; 3], max: [50.0, 50.0, 100.0], jitter: 0.2, seed: 3 };
        let mesh = shape.mesh(&["A", "B"], |c| usize::from(c[2] > 50.0), |d, x| d == 2 && x == 50.0);
        let (t, p) = (10.0 * factor, 200.0 * factor);
        model(
            &format!(
                "bodies: {{A: s, B: s}}\ninterfaces:\n\
                 - {{between: [A, B], law: contact, mu: 0.3, friction: associated}}\n\
                 supports:\n- {{face: Z0, fix: [x, y, z]}}\nloads:\n- {{face: Z1, traction: [{t:?}, 0, {:?}]}}\n",
                -p
            ),
            mesh,
        )
    };
    let b = bracket("block on block", &stacked(0.8), &stacked(0.9));
    assert!(b.lower().value() > 1.0 - 1e-3 && b.upper().value() < 2.0);
}
