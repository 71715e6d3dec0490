//! Upper bounds.

use super::cases::{self, Case, NOISE, SEEDS};
use crate::common::{Random, points};
use bracket::certify::UpperFactor;
use bracket::certify::fields::{DisplacementField, StressField};
use bracket::certify::limit_certificate::certify_upper;
use bracket::certify::sampling::sample_upper;
use bracket::certify::velocity_field::VelocityField;
use bracket::elements::hencky_kinematic::Flow;
use bracket::elements::space::Tet10Space;
use bracket::elements::{split_flow, split_tet10};
use bracket::mesh::tet::EDGES;
use bracket::recover::limit_upper;
use bracket::recover::limit_upper::{Upper, UpperError};
use bracket::solve::Patterns;

fn project(case: &Case, flow: Flow, noise: f64, random: &mut Random) -> Result<Upper, UpperError> {
    let field = VelocityField {
        nodes: DisplacementField { u: case.velocities(noise, random) },
        flow,
        limit_motions: vec![],
    };
    limit_upper::project(&case.model, &field, 0, &Patterns::default())
}

#[test]
fn exact_fields_with_noise() {
    for seed in SEEDS {
        for case in cases::all(seed) {
            for flow in [Flow::Split, Flow::Plain] {
                for (noise, within) in [(0.0, 1e-9), (NOISE, 1e-3)] {
                    let name = format!("{} {seed} {flow:?} noise {noise:e}", case.name);
                    let mut random = Random::new(seed);
                    let upper = project(&case, flow, noise, &mut random)
                        .unwrap_or_else(|e| panic!("{name}: {e}"));
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

fn raw(case: &Case, u: Vec<[f64; 3]>, flow: Flow) -> VelocityField {
    assert_eq!(u.len(), Tet10Space::new(&case.model.mesh).nodes.len());
    VelocityField { nodes: DisplacementField { u }, flow, limit_motions: vec![] }
}

fn everywhere(case: &Case, u: impl Fn(usize, [f64; 3]) -> [f64; 3]) -> Vec<[f64; 3]> {
    let space = Tet10Space::new(&case.model.mesh);
    let mut body = vec![0; space.nodes.len()];
    for e in 0..case.model.mesh.tets.len() {
        space
            .tet(&case.model.mesh, e)
            .iter()
            .for_each(|&n| body[n] = case.model.mesh.tet_body[e] as usize);
    }
    space.nodes.iter().zip(body).map(|(x, b)| u(b, *x)).collect()
}

/// Checks admissibility with code that shares only the numbering of nodes and the inner velocities
/// with the library. It checks supports and contacts at random points. It checks the divergence
/// (and the strain in rigid bodies) by central differences, which are exact for quadratics.
#[test]
fn admissible_by_other_code() {
    for seed in SEEDS {
        for case in cases::all(seed) {
            for flow in [Flow::Split, Flow::Plain] {
                let mut random = Random::new(seed);
                let upper = project(&case, flow, NOISE, &mut random).unwrap();
                let mesh = &case.model.mesh;
                let zero = StressField { points: vec![[[[0.0; 6]; 4]; 4]; mesh.tets.len()] };
                let mut unloaded = case.loaded(0.0);
                unloaded.surface_loads.clear();
                unloaded.body_loads.clear();
                unloaded.supports.clear();
                points::check(case.name, &unloaded, &zero, &upper.field.nodes);
                points::velocities_on_supports(case.name, &case.model, &upper.field.nodes);
                let space = Tet10Space::new(mesh);
                let scale =
                    upper.field.nodes.u.iter().flatten().fold(0.0f64, |m, u| m.max(u.abs()));
                for _ in 0..2000 {
                    let e = random.below(mesh.tets.len());
                    let yields = case.model.materials
                        [case.model.body_material[mesh.tet_body[e] as usize] as usize]
                        .fy
                        .is_some();
                    let outer = space.tet(mesh, e).map(|n| upper.field.nodes.u[n]);
                    let (corners, nodes) = match (yields, flow) {
                        (true, Flow::Split) => {
                            let all = split_flow::velocities(
                                &mesh.corners(e),
                                &std::array::from_fn(|i| outer[i / 3][i % 3]),
                            );
                            let k = random.below(4);
                            let at = split_tet10::subtet_nodes(k)
                                .map(|n| [all[3 * n], all[3 * n + 1], all[3 * n + 2]]);
                            (split_tet10::subtet_corners(&mesh.corners(e), k), at)
                        }
                        _ => (mesh.corners(e), outer),
                    };
                    let grad = gradient(&corners, &nodes, random.simplex::<4>());
                    let h = mesh.volume(e).cbrt();
                    let worst = if yields {
                        (grad[0][0] + grad[1][1] + grad[2][2]).abs()
                    } else {
                        (0..9)
                            .map(|i| (grad[i / 3][i % 3] + grad[i % 3][i / 3]).abs())
                            .fold(0.0, f64::max)
                    };
                    assert!(
                        worst * h < 1e-11 * scale,
                        "{} {flow:?}: {:e}",
                        case.name,
                        worst * h / scale
                    );
                }
            }
        }
    }
}

/// Velocity gradient at barycentric `l` by central differences over the size of the whole tet.
fn gradient(x: &[[f64; 3]; 4], u: &[[f64; 3]; 10], l: [f64; 4]) -> [[f64; 3]; 3] {
    let sub = |a: [f64; 3], b: [f64; 3]| [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
    let det = |a: [f64; 3], b: [f64; 3], c: [f64; 3]| {
        a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0])
            + a[2] * (b[0] * c[1] - b[1] * c[0])
    };
    let six = det(sub(x[1], x[0]), sub(x[2], x[0]), sub(x[3], x[0]));
    let velocity = |p: [f64; 3]| -> [f64; 3] {
        let l: [f64; 4] = std::array::from_fn(|i| {
            let mut y = *x;
            y[i] = p;
            det(sub(y[1], y[0]), sub(y[2], y[0]), sub(y[3], y[0])) / six
        });
        let mut v = [0.0; 3];
        for i in 0..10 {
            let n = if i < 4 {
                l[i] * (2.0 * l[i] - 1.0)
            } else {
                4.0 * l[EDGES[i - 4][0]] * l[EDGES[i - 4][1]]
            };
            (0..3).for_each(|d| v[d] += n * u[i][d]);
        }
        v
    };
    let at: [f64; 3] = std::array::from_fn(|d| (0..4).map(|i| l[i] * x[i][d]).sum());
    let step = six.abs().cbrt();
    let mut g = [[0.0; 3]; 3];
    for j in 0..3 {
        let (mut plus, mut minus) = (at, at);
        plus[j] += step;
        minus[j] -= step;
        let (a, b) = (velocity(plus), velocity(minus));
        (0..3).for_each(|i| g[i][j] = (a[i] - b[i]) / (2.0 * step));
    }
    g
}

/// Velocities with a change of volume, penetration, strain in rigid bodies or moving supports prove
/// no bound as they stand. After projection they give an upper bound, or they are refused.
#[test]
fn wrong_fields() {
    for flow in [Flow::Split, Flow::Plain] {
        let mut random = Random::new(5);
        let mut wrong: Vec<(&str, Case, Vec<[f64; 3]>)> = Vec::new();
        let mut add = |what, case: Case, u: &dyn Fn(usize, [f64; 3]) -> [f64; 3]| {
            let u = everywhere(&case, u);
            wrong.push((what, case, u));
        };
        add("swelling", cases::bar(1), &|_, x| x);
        add("stretching alone", cases::bar(1), &|_, x| [x[0], 0.0, 0.0]);
        add("support moved", cases::bar(1), &|_, x| [x[0] + 1.0, -0.5 * x[1], -0.5 * x[2]]);
        add("rigid end bent", cases::bar_with_rigid_end(1), &|_, x| [x[0] * x[0], 0.0, 0.0]);
        add("rigid body strained", cases::lid(1), &|_, x| [x[1], 0.0, 0.0]);
        add("penetrating", cases::sliding(1), &|b, _| {
            if b == 1 { [1.0, 0.0, -0.5] } else { [0.0; 3] }
        });
        add("slip without dilation", cases::sliding(1), &|b, _| {
            if b == 1 { [1.0, 0.0, 0.0] } else { [0.0; 3] }
        });
        add("into the ground", cases::own_weight(1), &|_, x| [1.0, 0.0, 0.3 - 0.1 * x[0]]);
        for case in cases::all(1) {
            let u = everywhere(&case, |b, x| (case.velocity)(b, x)).into_iter();
            let u = u.map(|v| v.map(|v| v + 3.0 * (random.unit() - 0.5))).collect();
            wrong.push(("noise", case, u));
        }
        for (what, case, u) in wrong {
            let name = format!("{} {flow:?} {what}", case.name);
            let field = raw(&case, u, flow);
            let bound = UpperFactor::new(certify_upper(&case.model, &field, 0));
            assert!(!bound.is_strict(), "{name}: {:?}", bound.certificate());
            match limit_upper::project(&case.model, &field, 0, &Patterns::default()) {
                Err(e) => println!("{name}: {e}"),
                Ok(upper) => {
                    let bound = UpperFactor::new(upper.certificate);
                    println!(
                        "{name}: {} of {}, strict {}",
                        bound.value(),
                        case.factor,
                        bound.is_strict()
                    );
                    assert!(
                        bound.is_strict() && bound.value() >= case.factor,
                        "{name}: {:?}",
                        bound.certificate()
                    );
                }
            }
        }
        // reversed velocities: the loads do negative work
        let case = cases::bar(1);
        let back = everywhere(&case, |_, x| [-x[0], 0.5 * x[1], 0.5 * x[2]]);
        let refused =
            limit_upper::project(&case.model, &raw(&case, back, flow), 0, &Patterns::default());
        assert!(matches!(refused, Err(UpperError::NoPower { .. })), "{refused:?}");
        let mut nan = everywhere(&case, |b, x| (case.velocity)(b, x));
        nan[3][1] = f64::NAN;
        assert!(
            !UpperFactor::new(certify_upper(&case.model, &raw(&case, nan, flow), 0)).is_strict()
        );
    }
}

/// Each subdivision of the quadrature rule lowers the bound, but never below the limit.
#[test]
fn finer_rules() {
    let case = cases::bar(7);
    let upper = project(&case, Flow::Split, 1e-2, &mut Random::new(7)).unwrap();
    let bounds: Vec<f64> =
        (0..4).map(|n| certify_upper(&case.model, &upper.field, n).factor).collect();
    println!("{bounds:?}");
    assert!(bounds.windows(2).all(|b| b[1] < b[0]) && bounds[3] > case.factor, "{bounds:?}");
}
