//! Live and dead loads separately: they are linear in the load factor, their sum equals the loads
//! of the elastic programs, and their power agrees with direct quadrature.

use super::cases;
use crate::common::Random;
use bracket::certify::fields::DisplacementField;
use bracket::certify::limit_certificate::certify_upper;
use bracket::certify::velocity_field::VelocityField;
use bracket::elements::hencky_kinematic::Flow;
use bracket::model::AnalysisModel;
use bracket::model::loads::Loads;
use bracket::programs::{Kinematic, Static};

/// A model with every kind of load, live and dead.
fn model(seed: u64) -> AnalysisModel {
    let mut m = cases::own_weight(seed).model;
    let rigid = cases::bar_with_rigid_end(seed).model.rigid.remove(0);
    let face = m.surface_loads[0].clone();
    m.surface_loads.push(bracket::model::analysis::SurfaceLoad {
        dead: true,
        traction: bracket::model::analysis::Traction::Pressure(0.7),
        ..face.clone()
    });
    // the side that carries shear can also move rigidly along y
    m.rigid.push(bracket::model::analysis::RigidFace {
        components: [false, true, false],
        free: [false, true, false, true, false, false],
        action: [0.0, 30.0, 0.0, 7.0, 0.0, 0.0],
        dead_action: [0.0, -20.0, 0.0, 5.0, 0.0, 0.0],
        faces: face.faces,
        ..rigid
    });
    m
}

fn close(name: &str, a: &[f64], b: &[f64]) {
    let scale = b.iter().fold(0.0f64, |m, x| m.max(x.abs()));
    let off = a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    assert!(
        a.len() == b.len() && scale > 0.0 && off <= 1e-13 * scale,
        "{name}: {off:e} of {scale:e}"
    );
}

/// Computes the forces of some of the loads.
type Forces<'a> = dyn Fn(Loads) -> Vec<f64> + 'a;

#[test]
fn live_and_dead_add_up() {
    let m = model(3);
    let minus = |v: &[f64]| -> Vec<f64> { v.iter().map(|x| -x).collect() };
    let sum = |a: f64, x: &[f64], y: &[f64]| -> Vec<f64> {
        x.iter().zip(y).map(|(x, y)| a * x + y).collect()
    };
    let statics = Static::new(&m).unwrap();
    let kinematic = Kinematic::new(&m).unwrap();
    assert_eq!(statics.forces(Loads::ALL), statics.loads);
    close(
        "kinematic",
        &minus(&kinematic.limit_forces(&m, Flow::Plain, Loads::ALL)),
        &kinematic.program.q,
    );
    let forms: [(&str, &Forces); 4] = [
        ("static", &|l| statics.forces(l)),
        ("particular", &|l| statics.particular_forces(l).unwrap()),
        ("plain", &|l| kinematic.limit_forces(&m, Flow::Plain, l)),
        ("split", &|l| kinematic.limit_forces(&m, Flow::Split, l)),
    ];
    for (name, forces) in forms {
        let (live, dead) = (forces(Loads::LIVE), forces(Loads::DEAD));
        close(name, &forces(Loads::at(-2.5)), &sum(-2.5, &live, &dead));
        assert!(live != dead && forces(Loads::ALL) == forces(Loads::at(1.0)));
    }
}

/// The power of the forces on random velocities equals that of the certificate, which integrates
/// over faces and subtets.
#[test]
fn power_by_quadrature() {
    for seed in cases::SEEDS {
        let m = model(seed);
        let kinematic = Kinematic::new(&m).unwrap();
        let mut random = Random::new(seed);
        let x: Vec<f64> = (0..kinematic.map.n).map(|_| random.unit() - 0.5).collect();
        let u: Vec<[f64; 3]> =
            kinematic.map.expand(&x).chunks_exact(3).map(|c| [c[0], c[1], c[2]]).collect();
        for flow in [Flow::Plain, Flow::Split] {
            let c = certify_upper(
                &m,
                &VelocityField {
                    nodes: DisplacementField { u: u.clone() },
                    flow,
                    limit_motions: vec![],
                },
                0,
            );
            let power = |loads| -> f64 {
                kinematic.limit_forces(&m, flow, loads).iter().zip(&x).map(|(f, u)| f * u).sum()
            };
            let (live, dead) = (power(Loads::LIVE), power(Loads::DEAD));
            println!("{flow:?}: {live:e} {dead:e}");
            assert!(
                (c.live_power - live).abs() < 1e-10 * live.abs(),
                "{flow:?}: {:e} {live:e}",
                c.live_power
            );
            assert!(
                (c.dead_power - dead).abs() < 1e-10 * dead.abs(),
                "{flow:?}: {:e} {dead:e}",
                c.dead_power
            );
        }
    }
}
