//! Lower bounds.

use super::cases::{self, Case, NOISE, SEEDS};
use crate::common::yielding::FY;
use crate::common::{Random, points};
use bracket::certify::LowerFactor;
use bracket::certify::fields::{DisplacementField, StressField};
use bracket::certify::limit_certificate::certify_lower;
use bracket::certify::sampling::sample_lower;
use bracket::elements::space::Tet10Space;
use bracket::model::analysis::Traction;
use bracket::programs::Static;
use bracket::recover::limit_lower::{ApproximateStress, Lower, LowerError};
use bracket::recover::{elastic, limit_lower};
use bracket::solve::{Patterns, SolveOptions};

fn dead_field(case: &Case, noise: f64, random: &mut Random) -> Option<StressField> {
    let stress = case.dead?;
    let a = case.static_field_of(stress, 0.0, noise, true, random);
    let approximate = ApproximateStress {
        parameters: &a.parameters,
        contact: &a.contact,
        welds: &[],
        factor: 0.0,
    };
    Some(limit_lower::dead_field(&case.model, &approximate, &Patterns::default()).unwrap())
}

fn project(
    case: &Case,
    factor: f64,
    noise: f64,
    bare: bool,
    random: &mut Random,
) -> Result<Lower, LowerError> {
    let dead = dead_field(case, noise, random);
    let a = case.static_field(factor, noise, bare, random);
    let approximate = ApproximateStress {
        parameters: &a.parameters,
        contact: &a.contact,
        welds: &[],
        factor: a.factor,
    };
    limit_lower::project(&case.model, &approximate, dead.as_ref(), &Patterns::default())
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
                let lower = project(&case, case.factor, noise, bare, &mut random)
                    .unwrap_or_else(|e| panic!("{name}: {e}"));
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
                // the stored field alone gives the same bound
                let again = certify_lower(&case.model, &lower.field, c.factor);
                assert_eq!(
                    bracket::certify::limit_certificate::LowerCertificate {
                        scaled_by: c.scaled_by,
                        ..again
                    },
                    *c
                );
                let s = sample_lower(&case.model, &lower.field, c.factor, 2000);
                assert!(
                    s.utilisation <= 1.0 && s.traction_jump < 1e-12 && s.traction_cone < 1e-12,
                    "{name}: {s:?}"
                );
            }
        }
    }
}

/// Checks the same lower bounds with code that shares nothing with the library: equilibrium at
/// points inside elements and on faces under the loads at the load factor, and von Mises' condition
/// from the full tensor.
#[test]
fn admissible_by_other_code() {
    for seed in SEEDS {
        for case in cases::all(seed) {
            let mut random = Random::new(seed);
            let lower = project(&case, case.factor, NOISE, true, &mut random).unwrap();
            let zero = DisplacementField {
                u: vec![[0.0; 3]; Tet10Space::new(&case.model.mesh).nodes.len()],
            };
            points::check(case.name, &case.loaded(lower.certificate.factor), &lower.field, &zero);
            let fy: Vec<Option<f64>> = case
                .model
                .body_material
                .iter()
                .map(|m| case.model.materials[*m as usize].fy)
                .collect();
            let mut worst = 0.0f64;
            for (e, s) in lower.field.points.iter().enumerate() {
                let Some(fy) = fy[case.model.mesh.tet_body[e] as usize] else { continue };
                for _ in 0..20 {
                    let (at, l) = (&s[random.below(4)], random.simplex::<4>());
                    let x: [f64; 6] =
                        std::array::from_fn(|i| (0..4).map(|p| l[p] * at[p][i]).sum());
                    let normal =
                        (x[0] - x[1]).powi(2) + (x[1] - x[2]).powi(2) + (x[2] - x[0]).powi(2);
                    // √2 in each shear component: 3 τ² is 1.5 times its square
                    let mises =
                        (0.5 * normal + 1.5 * (x[3] * x[3] + x[4] * x[4] + x[5] * x[5])).sqrt();
                    worst = worst.max(mises / fy);
                }
            }
            assert!(worst <= 1.0, "{}: {worst}", case.name);
            // where yield is the limit, the points come close to it
            assert!(worst > 0.98 || case.dead.is_some(), "{}: {worst}", case.name);
        }
    }
}

fn given<'a>(a: &'a cases::Approximate) -> ApproximateStress<'a> {
    ApproximateStress {
        parameters: &a.parameters,
        contact: &a.contact,
        welds: &[],
        factor: a.factor,
    }
}

/// A field at twice the limit proves no bound as it stands. It is scaled back to the limit.
#[test]
fn beyond_yield() {
    for (make, stress) in [
        (
            cases::bar as fn(u64) -> Case,
            (|_, _| [2.0 * FY, 0.0, 0.0, 0.0, 0.0, 0.0]) as fn(usize, [f64; 3]) -> [f64; 6],
        ),
        (cases::bar_under_dead_load, |_, _| [2.0 * FY, 0.0, 0.0, 0.0, 0.0, 0.0]),
    ] {
        let case = make(1);
        let mut random = Random::new(1);
        let dead = dead_field(&case, 0.0, &mut random);
        let factor = 2.0 * FY / 100.0 - f64::from(u8::from(dead.is_some()));
        let a = case.static_field_of(stress, factor, 0.0, false, &mut random);
        let raw =
            StressField { points: vec![[[stress(0, [0.0; 3]); 4]; 4]; case.model.mesh.tets.len()] };
        let c = certify_lower(&case.model, &raw, factor);
        assert!((c.utilisation - 2.0).abs() < 1e-12 && c.equilibrium < 1e-12, "{c:?}");
        assert!(!LowerFactor::new(c).is_strict());
        let lower =
            limit_lower::project(&case.model, &given(&a), dead.as_ref(), &Patterns::default())
                .unwrap();
        let bound = LowerFactor::new(lower.certificate);
        println!("{}: {:e}", case.name, bound.value() / case.factor - 1.0);
        assert!(
            bound.is_strict()
                && bound.value() <= case.factor
                && bound.value() > case.factor * (1.0 - 1e-9)
        );
    }
}

/// Dead loads need a field of their own that is in equilibrium and below yield.
#[test]
fn dead_loads_without_a_sound_field() {
    let case = cases::bar_under_dead_load(1);
    let mut random = Random::new(1);
    let a = case.static_field(case.factor, 0.0, false, &mut random);
    assert!(matches!(
        limit_lower::project(&case.model, &given(&a), None, &Patterns::default()),
        Err(LowerError::NoDeadField)
    ));
    // the field of twice the dead loads is not in equilibrium with them
    let wrong = StressField {
        points: vec![[[[200.0, 0.0, 0.0, 0.0, 0.0, 0.0]; 4]; 4]; case.model.mesh.tets.len()],
    };
    let refused = limit_lower::project(&case.model, &given(&a), Some(&wrong), &Patterns::default());
    assert!(
        matches!(
            &refused,
            Err(LowerError::DeadField { what }) if what.to_string().contains("equilibrium")
        ),
        "{refused:?}"
    );
    // dead loads beyond yield
    let mut heavy = cases::bar_under_dead_load(1);
    heavy.model.surface_loads[1].traction =
        Traction::Linear { traction0: [236.0, 0.0, 0.0], gradient: [[0.0; 3]; 3] };
    let b = heavy.static_field_of(
        |_, _| [236.0, 0.0, 0.0, 0.0, 0.0, 0.0],
        0.0,
        0.0,
        false,
        &mut random,
    );
    let refused = limit_lower::dead_field(&heavy.model, &given(&b), &Patterns::default());
    assert!(
        matches!(
            &refused,
            Err(LowerError::DeadField { what }) if what.to_string().contains("yield")
        ),
        "{refused:?}"
    );
}

/// Contact forces in tension, and fields of pure noise, prove at most the limit.
#[test]
fn wrong_fields() {
    for case in cases::all(7) {
        let mut random = Random::new(7);
        let dead = dead_field(&case, 0.0, &mut random);
        let mut pulls = case.static_field(case.factor, 0.0, false, &mut random);
        pulls.contact.iter_mut().for_each(|z| *z = -*z);
        let mut noise = case.static_field(case.factor, 1.0, false, &mut random);
        noise.parameters.iter_mut().flatten().for_each(|a| *a *= random.unit() - 0.5);
        let mut high = case.static_field(case.factor, 0.0, false, &mut random);
        high.factor *= 3.0;
        for (what, a) in [("pulls", pulls), ("noise", noise), ("high", high)] {
            match limit_lower::project(&case.model, &given(&a), dead.as_ref(), &Patterns::default())
            {
                Err(e) => println!("{} {what}: {e}", case.name),
                Ok(lower) => {
                    let bound = LowerFactor::new(lower.certificate);
                    println!(
                        "{} {what}: {} of {}, strict {}",
                        case.name,
                        bound.value(),
                        case.factor,
                        bound.is_strict()
                    );
                    assert!(
                        !bound.is_strict() || bound.value() <= case.factor,
                        "{} {what}",
                        case.name
                    );
                }
            }
        }
        let mut nan = case.static_field(case.factor, 0.0, false, &mut random);
        nan.parameters[0][3] = f64::NAN;
        let lower =
            limit_lower::project(&case.model, &given(&nan), dead.as_ref(), &Patterns::default());
        assert!(
            lower.is_err() || lower.is_ok_and(|l| !LowerFactor::new(l.certificate).is_strict()),
            "{}",
            case.name
        );
    }
}

/// The elastic stress under the dead loads alone, from the elastic programs, serves as the field of
/// the dead loads.
#[test]
fn elastic_field_of_the_dead_loads() {
    let mut stronger = cases::own_weight(7);
    // friction restrains the lateral expansion of the elastic block: its stress exceeds that of the
    // limit state
    stronger.model.materials[0].fy = Some(12.0);
    for case in [cases::bar_under_dead_load(7), cases::sliding(7), stronger] {
        let alone = case.model.without_live_loads();
        let statics = Static::new(&alone).unwrap();
        let solution =
            bracket::solve::solve(&statics.program, &statics.map.block, &SolveOptions::default());
        let dead = elastic::stress(&statics, &solution, &Patterns::default()).unwrap();
        let a = case.static_field(case.factor, NOISE, true, &mut Random::new(7));
        let lower =
            limit_lower::project(&case.model, &given(&a), Some(&dead), &Patterns::default())
                .unwrap();
        let bound = LowerFactor::new(lower.certificate);
        println!("{}: {:e}", case.name, bound.value() / case.factor - 1.0);
        assert!(
            bound.is_strict()
                && bound.value() <= case.factor
                && bound.value() > 0.999 * case.factor,
            "{}",
            case.name
        );
    }
}
