//! Lower bounds.

use crate::cases::{self, Case, NOISE, SEEDS};
use crate::common::Random;
use bracket::bounds::LowerFactor;
use bracket::bounds::fields::StressField;
use bracket::bounds::limit_certificate::certify_lower;
use bracket::bounds::limit_lower::{self, ApproximateStress, Lower, LowerError};
use bracket::bounds::sampling::sample_lower;

fn dead_field(case: &Case, noise: f64, random: &mut Random) -> Option<StressField> {
    let stress = case.dead?;
    let a = case.static_field_of(stress, 0.0, noise, true, random);
    let approximate = ApproximateStress { parameters: &a.parameters, contact: &a.contact, factor: 0.0 };
    Some(limit_lower::dead_field(&case.model, &approximate).unwrap())
}

fn project(case: &Case, factor: f64, noise: f64, bare: bool, random: &mut Random) -> Result<Lower, LowerError> {
    let dead = dead_field(case, noise, random);
    let a = case.static_field(factor, noise, bare, random);
    let approximate = ApproximateStress { parameters: &a.parameters, contact: &a.contact, factor: a.factor };
    limit_lower::project(&case.model, &approximate, dead.as_ref())
}

#[test]
fn exact_fields_with_noise() {
    for seed in SEEDS {
        for case in cases::all(seed) {
            for (noise, within, bare) in
                [(0.0, 1e-9, false), (0.0, 1e-7, true), (NOISE, 1e-3, false), (NOISE, 1e-3, true)]
            {
                let name = format!("{} {seed} noise {noise:e} bare {bare}", case.name);
                let mut random = Random::new(seed);
                let lower =
                    project(&case, case.factor, noise, bare, &mut random).unwrap_or_else(|e| panic!("{name}: {e}"));
                let c = &lower.certificate;
                println!("{name}: off {:.2e}, {c:?}", c.factor / case.factor - 1.0);
                let bound = LowerFactor::new(c.clone());
                assert!(bound.is_strict(), "{name}: {c:?}");
                assert!(
                    bound.value() <= case.factor * (1.0 + 1e-14),
                    "{name}: {:e}",
                    bound.value() / case.factor - 1.0
                );
                assert!(
                    bound.value() >= case.factor * (1.0 - within),
                    "{name}: {:e}",
                    bound.value() / case.factor - 1.0
                );
                assert!(c.equilibrium.max(c.traction_jump) < 1e-12, "{name}: {c:?}");
                // the stored field alone says the same
                let again = certify_lower(&case.model, &lower.field, c.factor);
                assert_eq!(
                    bracket::bounds::limit_certificate::LowerCertificate { scaled_by: c.scaled_by, ..again },
                    *c
                );
                let s = sample_lower(&case.model, &lower.field, c.factor, 2000);
                assert!(s.utilisation <= 1.0 && s.traction_jump < 1e-12 && s.traction_cone < 1e-12, "{name}: {s:?}");
            }
        }
    }
}
