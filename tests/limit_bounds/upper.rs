//! Upper bounds.

use crate::cases::{self, Case, NOISE, SEEDS};
use crate::common::Random;
use bracket::bounds::UpperFactor;
use bracket::bounds::fields::DisplacementField;
use bracket::bounds::flow::VelocityField;
use bracket::bounds::limit_certificate::certify_upper;
use bracket::bounds::limit_upper::{self, Upper, UpperError};
use bracket::bounds::sampling::sample_upper;
use bracket::model::Flow;

fn project(case: &Case, flow: Flow, noise: f64, random: &mut Random) -> Result<Upper, UpperError> {
    let field = VelocityField { nodes: DisplacementField { u: case.velocities(noise, random) }, flow };
    limit_upper::project(&case.model, &field, 0)
}

#[test]
fn exact_fields_with_noise() {
    for seed in SEEDS {
        for case in cases::all(seed) {
            for flow in [Flow::Split, Flow::Plain] {
                for (noise, within) in [(0.0, 1e-9), (NOISE, 1e-3)] {
                    let name = format!("{} {seed} {flow:?} noise {noise:e}", case.name);
                    let mut random = Random::new(seed);
                    let upper = project(&case, flow, noise, &mut random).unwrap_or_else(|e| panic!("{name}: {e}"));
                    let c = &upper.certificate;
                    println!("{name}: off {:.2e}, {c:?}", c.factor / case.factor - 1.0);
                    let bound = UpperFactor::new(c.clone());
                    assert!(bound.is_strict(), "{name}: {c:?}");
                    assert!(
                        bound.value() >= case.factor * (1.0 - 1e-14),
                        "{name}: {:e}",
                        bound.value() / case.factor - 1.0
                    );
                    assert!(
                        bound.value() <= case.factor * (1.0 + within),
                        "{name}: {:e}",
                        bound.value() / case.factor - 1.0
                    );
                    assert!(c.volume.max(c.rigid) < 1e-12, "{name}: {c:?}");
                    assert_eq!(certify_upper(&case.model, &upper.field, 0), *c);
                    let s = sample_upper(&case.model, &upper.field, 2000);
                    assert!(s.strain < 1e-12 && s.gap_cone <= 0.0, "{name}: {s:?}");
                }
            }
        }
    }
}
