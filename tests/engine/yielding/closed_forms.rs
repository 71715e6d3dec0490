//! Bars, cubes and columns whose exact stress is linear and whose plastic strain is constant. Every
//! program represents the exact fields on any mesh.
//!
//! ```text
//!   two bars in parallel      two cubes in parallel       all-round pressure    column
//!  |[=== elastic =====]|           __F__→                      p                 /////
//!  |[=== yields ======]|→ N     [/ /] [/ /]                 -> [ ] <-            [   ] → b
//!                               /////////// γ                                    [   ] → b
//! ```
//! The elastic one of two parallel bodies limits the strain of the other, e > f_y/E: energies per
//! volume ½Ee² and f_y²/(2E) + f_y (e − f_y/E); in shear ½Gγ² and k²/(2G) + k (γ − k/G) with k =
//! f_y/√3.
//!
//! Tolerance 1e-7 relative: the solver stops at a gap of 1e-8.

use super::duality::optimal;
use crate::common::yielding::{E, FORMS, FY, Form, NU, model};
use crate::common::{Block, beside};
use bracket::mesh::TetMesh;
use bracket::model::AnalysisModel;
use bracket::programs::Static;
use bracket::solve::{Patterns, SolveOptions, SolveStatus, condensed};

const SEEDS: [u64; 2] = [1, 7];

fn cuboid(cells: [usize; 3], min: [f64; 3], max: [f64; 3], seed: u64, body: &str) -> TetMesh {
    Block { cells, min, max, jitter: 0.2, seed }.mesh(&[body], |_| 0, |_, _| false)
}

fn exact(name: &str, model: &AnalysisModel, want: f64) {
    for form in FORMS {
        let (built, s) = optimal(name, form, model);
        let got = built.program.objective(&s.x, &s.z);
        println!("{name} {form:?}: {got:.12e} against {want:.12e}, {:.1e}", got / want - 1.0);
        assert!((got - want).abs() < 1e-7 * want.abs(), "{name} {form:?}");
    }
}

/// Strain of the bars at the load, three times that at yield.
const STRAIN: f64 = 3.0 * FY / E;

fn bars(seed: u64) -> AnalysisModel {
    let mesh = beside(
        cuboid([3, 1, 2], [0.0; 3], [30.0, 10.0, 12.0], seed, "A"),
        cuboid([2, 2, 1], [0.0, 20.0, 0.0], [30.0, 28.0, 12.0], seed + 1, "B"),
    );
    let n = E * STRAIN * 120.0 + FY * 96.0;
    model(
        &format!(
            "bodies: {{A: r, B: s}}\nsupports:\n- {{face: X0, fix: [x]}}\n- {{face: Y0, fix: \
             [y]}}\n- {{face: Z0, fix: [z]}}\nrigid:\n- {{face: X1, components: [x], free: [ux], \
             at: [30, 0, 0], force: [{n:?}, 0, 0]}}\n"
        ),
        mesh,
    )
}

#[test]
fn bar_beyond_yield_in_parallel_with_an_elastic_bar() {
    for seed in SEEDS {
        let energy = 30.0
            * (0.5 * E * STRAIN * STRAIN * 120.0
                + (FY * FY / (2.0 * E) + FY * (STRAIN - FY / E)) * 96.0);
        let work = (E * STRAIN * 120.0 + FY * 96.0) * STRAIN * 30.0;
        exact("bars", &bars(seed), energy - work);
    }
}

/// The multipliers of every point have the direction opposite to the flow diag(1, −½, −½). They add
/// up to the volume times the plastic strain e − f_y/E. The share of each element is free, because
/// a perfectly plastic bar may flow at any place. The multipliers' own multipliers are the stress.
#[test]
fn multipliers_are_the_plastic_strain() {
    let model = bars(1);
    let (built, s) = optimal("bars", Form::Static, &model);
    let length = |v: &[f64]| v.iter().map(|x| x * x).sum::<f64>().sqrt();
    let flow = (STRAIN - FY / E) * 1.5f64.sqrt() * 96.0 * 30.0;
    let direction = bracket::math::mandel::deviator(&[1.0, -0.5, -0.5, 0.0, 0.0, 0.0])
        .map(|x| x / 1.5f64.sqrt());
    let radius = bracket::math::mandel::yield_radius(FY);
    let (mut sum, slack) = (0.0, built.program.slack(&s.x));
    for (start, _) in built.program.cone_starts().into_iter().zip(&built.program.cones) {
        // both are divided by the yield radius
        let lambda: Vec<f64> = s.z[start..start + 6].iter().map(|z| z / radius).collect();
        let z: Vec<f64> = slack[start..start + 6].iter().map(|s| s * radius).collect();
        sum += lambda[0];
        assert!((lambda[0] - length(&lambda[1..])).abs() < 1e-6 * flow, "{lambda:?}");
        for i in 0..5 {
            assert!((lambda[1 + i] + lambda[0] * direction[i]).abs() < 1e-5 * flow, "{lambda:?}");
            assert!((z[1 + i] - radius * direction[i]).abs() < 1e-4 * radius, "{z:?}");
        }
    }
    assert!((sum - flow).abs() < 1e-6 * flow, "{sum} {flow}");
}

#[test]
fn cube_in_shear_beyond_yield() {
    let (g, k) = (E / (2.0 * (1.0 + NU)), FY / 3.0f64.sqrt());
    let gamma = 3.0 * k / g;
    for seed in SEEDS {
        let mesh = beside(
            cuboid([2, 1, 1], [0.0; 3], [10.0; 3], seed, "A"),
            cuboid([1, 2, 2], [20.0, 0.0, 0.0], [30.0, 10.0, 8.0], seed, "B"),
        );
        let force = g * gamma * 100.0 + k * 80.0;
        // u = (γ y, 0, 0): the sides carry the shear as a reaction
        let m = model(
            &format!(
                "bodies: {{A: r, B: s}}\nsupports:\n- {{face: Y0, fix: [x, y, z]}}\n- {{face: X0, \
                 fix: [y]}}\n- {{face: X1, fix: [y]}}\n- {{face: Z0, fix: [z]}}\n- {{face: Z1, \
                 fix: [z]}}\nrigid:\n- {{face: Y1, components: [x, y, z], free: [ux], at: [0, 10, \
                 0], force: [{force:?}, 0, 0]}}\n"
            ),
            mesh,
        );
        let energy = 0.5 * g * gamma * gamma * 1000.0 + (k * gamma - k * k / (2.0 * g)) * 800.0;
        exact("shear", &m, energy - force * gamma * 10.0);
    }
}

/// Pressure causes no plastic flow, however high it is. Nothing supports the cube.
#[test]
fn cube_under_all_round_pressure() {
    let p = 3.0 * FY;
    let mesh = cuboid([2, 1, 2], [0.0; 3], [10.0; 3], 3, "B");
    let loads: String = ["X0", "X1", "Y0", "Y1", "Z0", "Z1"]
        .map(|f| format!("- {{face: {f}, pressure: {p:?}}}\n"))
        .concat();
    let m = model(&format!("bodies: {{B: s}}\nloads:\n{loads}"), mesh);
    assert_eq!(m.free_modes.len(), 6);
    let bulk = E / (3.0 * (1.0 - 2.0 * NU));
    exact("pressure", &m, -p * p * 1000.0 / (2.0 * bulk));
}

/// A bar at 0.999 of its yield force is still elastic.
#[test]
fn bar_just_below_yield() {
    let (area, length) = (120.0, 30.0);
    let n = 0.999 * FY * area;
    let m = model(
        "bodies: {B: s}\nsupports:\n- {face: X0, fix: [x]}\n- {face: Y0, fix: [y]}\n- {face: Z0, \
         fix: [z]}\nloads:\n- {face: X1, traction: [234.765, 0, 0]}\n",
        cuboid([3, 2, 1], [0.0; 3], [length, 10.0, 12.0], 5, "B"),
    );
    exact("bar", &m, -n * n * length / (2.0 * E * area));
}

/// A column clamped at its top and pushed sideways by a force per volume. Its sides are guided so
/// that u = (u(z), 0, 0). The shear is linear and equals `root_shear` at the top.
fn column(root_shear: f64) -> AnalysisModel {
    let length = 60.0;
    model(
        &format!(
            "bodies: {{B: s}}\nsupports:\n- {{face: Z1, fix: [x, y, z]}}\n- {{face: X0, fix: \
             [z]}}\n- {{face: X1, fix: [z]}}\n- {{face: Y0, fix: [y]}}\n- {{face: Y1, fix: \
             [y]}}\nloads:\n- {{body: B, force: [{:?}, 0, 0]}}\n",
            root_shear / length
        ),
        cuboid([2, 2, 4], [0.0; 3], [10.0, 12.0, length], 2, "B"),
    )
}

/// The column is elastic until the top reaches k = f_y/√3, with the energy τ²AL/(6G). There it
/// slides off: beyond this load no equilibrium exists. The yield condition contains the particular
/// stress of the body force, and the inner nodes of the split element carry their part of the
/// force.
#[test]
fn column_sheared_by_a_body_force() {
    let (g, k) = (E / (2.0 * (1.0 + NU)), FY / 3.0f64.sqrt());
    let t = 0.99 * k;
    exact("column", &column(t), -t * t * 120.0 * 60.0 / (6.0 * g));
    let above = column(1.01 * k);
    let statics = Static::with_plasticity(&above).unwrap();
    let prepared =
        condensed::Prepared::new(&statics.program, &statics.map.block, &Patterns::default())
            .unwrap();
    let s = prepared.solve(&SolveOptions::default());
    assert_eq!(s.status, SolveStatus::Unbounded);
    assert!(s.iterations <= 15, "{} iterations", s.iterations);
}
