//! Slip along tied interfaces: bodies whose limit load is that of slip on another body, and what
//! the certificate of such velocities requires. k = f_y/√3 is the largest traction along a face.

use super::random::assembly;
use crate::common::grid::{Grid, even, joined, name};
use crate::common::limit::{run, sharp_factors};
use crate::common::plane_strain::{K, PLANE_STRAIN};
use crate::common::yielding::{FY, MATERIALS};
use crate::common::{Block, oracle, solved};
use bracket::analysis::event::silent;
use bracket::analysis::limit::{self, velocity};
use bracket::analysis::pass::PassOptions;
use bracket::certify::UpperFactor;
use bracket::certify::fields::DisplacementField;
use bracket::certify::limit_certificate::certify_upper;
use bracket::certify::sampling::sample_upper;
use bracket::elements::hencky_kinematic::Flow;
use bracket::elements::space::Tet10Space;
use bracket::math::vec3::V3;
use bracket::mesh::TetMesh;
use bracket::model::AnalysisModel;
use bracket::programs::Kinematic;
use bracket::solve::{SolveOptions, StopRules};

/// A model of limit analysis from YAML without `mesh`, `analysis` and `materials`.
fn model(yaml: &str, mesh: TetMesh) -> AnalysisModel {
    solved::resolve_as("limit", &format!("{MATERIALS}{yaml}"), mesh).expect("valid")
}

/// The block of plane strain on its footprint, as among the tests of slip on supports; here the
/// footprint is the top of a pedestal of the given material, which is clamped.
///
/// ```text
///   ↓→  rigid plate
///  +---------------------+
///  |          B          |
///  +------+=======+------+
///         |   P   |
///         +///////+
/// ```
fn pedestal(material: &str) -> AnalysisModel {
    let x = joined(&[even(-22.5, -7.5, 2), even(-7.5, 7.5, 4), even(7.5, 22.5, 2)]);
    let z = joined(&[even(-5.0, 0.0, 1), even(0.0, 15.0, 3)]);
    let grid = Grid::new([x, vec![0.0, 5.0], z]).parallel().jittered(0.15, 3);
    let mut mesh = grid.mesh(
        &["B", "P"],
        |c| match (c[2] > 0.0, c[0].abs() < 7.5) {
            (true, _) => Some(0),
            (false, true) => Some(1),
            (false, false) => None,
        },
        |axis, c| axis == 0 && c.abs() == 7.5,
    );
    for body in ["B", "P"] {
        name(&mut mesh, &format!("Y0{body}"), body, |p| p[1] == 0.0);
        name(&mut mesh, &format!("Y1{body}"), body, |p| p[1] == 5.0);
    }
    name(&mut mesh, "FOOT", "P", |p| p[2] == -5.0);
    name(&mut mesh, "TOP", "B", |p| p[2] == 15.0);
    let strain = ["B", "P"]
        .map(|b| PLANE_STRAIN.replace("Y0", &format!("Y0{b}")).replace("Y1", &format!("Y1{b}")));
    model(
        &format!(
            "bodies: {{B: s, P: {material}}}\nsupports:\n{}- {{face: FOOT, fix: [x, y, \
             z]}}\nrigid:\n- {{face: TOP, components: [x, z], free: [ux, uz], at: [0, 0, 0], \
             force: [30, 0, -75]}}\n",
            strain.concat()
        ),
        mesh,
    )
}

/// A rigid pedestal: slip along its top bounds V by k/0.4, as slip on a support does. The pedestal
/// is at rest, so that the bound is exact. (Velocities without the slip give 1.15 times as much.)
#[test]
fn block_on_a_rigid_pedestal() {
    let exact = K / 0.4;
    let m = pedestal("r");
    assert_eq!((m.ties.len(), m.ties[0].name.as_str(), m.parts.len()), (1, "B-P", 1));
    let [low, up] = sharp_factors("rigid pedestal", &m);
    assert!(up >= exact * (1.0 - 1e-9) && up <= exact * (1.0 + 1e-6), "{}", up / exact);
    assert!(low <= exact, "{}", low / exact);
}

/// A pedestal of the same steel yields as well: the bound is below that of the rigid one.
#[test]
fn block_on_a_pedestal_of_its_own_steel() {
    let m = pedestal("s");
    let pass = run(&m);
    let (low, up) = (pass.lower.as_ref().unwrap(), pass.upper.as_ref().unwrap());
    assert!(low.is_strict() && up.is_strict() && low.value() <= up.value());
    assert!(up.value() <= 0.8 * K / 0.4 * FY, "{}", up.value());
    let c = up.certificate();
    assert!(c.ties[0] > 1e-3 * c.dissipation.iter().sum::<f64>(), "{c:?}");
    let sampled = sample_upper(&m, pass.velocity.as_ref().unwrap(), 2_000);
    assert!(sampled.held < 1e-12 && sampled.strain < 1e-9, "{sampled:?}");
}

/// The condensed method and Clarabel find the same load factor.
#[test]
fn agrees_with_clarabel() {
    for material in ["r", "s"] {
        let k = Kinematic::limit(&pedestal(material), Flow::Split).unwrap();
        oracle::agree(material, &k.program, &k.map.block);
    }
}

/// A block on a foot, tied to one half of it and welded to the other. At the edge between both
/// halves the points of the weld share the unknown of the normal velocity.
///
/// ```text
///    ↑ ↗
///  [   B   ]
///  ====-----   = tie, - weld
///  [   A   ]
///  /////////
/// ```
#[test]
fn a_weld_beside_a_tie() {
    let max = [40.0, 20.0, 24.0];
    let shape = Block { cells: [4, 1, 2], min: [0.0; 3], max, jitter: 0.1, seed: 1 };
    let flat = |d: usize, x: f64| d != 1 && (x - 0.5 * max[d]).abs() < 1e-9;
    let mut mesh = shape.mesh(&["A", "B"], |c| usize::from(c[2] > 12.0), flat);
    name(&mut mesh, "SEAM", "B", |p| p[2] == 12.0 && p[0] >= 20.0);
    let m = model(
        "bodies: {A: s, B: s}\ninterfaces:\n- {between: [A, B], face: SEAM, law: weld, \
         strength_traction: 90}\nsupports:\n- {face: Z0, fix: [x, y, z]}\nloads:\n- {face: Z1, \
         traction: [40, 10, 60]}\n",
        mesh,
    );
    assert_eq!((m.ties.len(), m.welds.len()), (1, 1));
    let pass = run(&m);
    let (low, up) = (pass.lower.as_ref().unwrap(), pass.upper.as_ref().unwrap());
    assert!(low.is_strict() && up.is_strict() && low.value() <= up.value());
    let k = Kinematic::limit(&m, Flow::Split).unwrap();
    oracle::agree("weld beside a tie", &k.program, &k.map.block);
}

/// Random stacks of two tied blocks. With the slip the upper bound is at most that without it, and
/// at least the lower bound.
#[test]
fn random_stacks_slip() {
    let (mut compared, mut lower) = (0, 0);
    for seed in 0..40 {
        let Some(m) = assembly(seed).filter(|m| !m.ties.is_empty()) else { continue };
        let solve = SolveOptions::default().with(StopRules::to_limit_gap(1e-7));
        let options = PassOptions { solve, ..PassOptions::default() };
        let [slip, glued] = [&m, &glued(&m)].map(|m| limit::run(m, &options, &silent()).unwrap());
        let (Some(s), Some(g)) = (&slip.upper, &glued.upper) else { continue };
        assert!(s.is_strict() && g.is_strict(), "seed {seed}");
        let (s, g) = (s.value(), g.value());
        println!("seed {seed}: {s:.8} with slip, {g:.8} without");
        // the program minimises the six coefficients of a face, the certificate has a finer rule
        assert!(s <= g + 1e-4 * g.abs(), "seed {seed}: {s} {g}");
        for low in slip.lower.iter().filter(|l| l.is_strict()) {
            assert!(low.value() <= s + 1e-9 * s.abs(), "seed {seed}: {} {s}", low.value());
        }
        compared += 1;
        lower += usize::from(s < 0.999 * g);
    }
    println!("{compared} compared, {lower} lower with slip");
    assert!(compared >= 5 && lower >= 2);
}

/// The same model with a slip that costs so much that the mechanism hardly has any.
fn glued(m: &AnalysisModel) -> AnalysisModel {
    let mut m = m.clone();
    m.ties.iter_mut().for_each(|t| t.strength *= 1e3);
    m
}

/// Velocities with which body B of two moves as a whole, the other at rest.
fn moved(m: &AnalysisModel, v: V3) -> UpperFactor {
    let space = Tet10Space::new(&m.mesh);
    let mut u = vec![[0.0; 3]; space.nodes.len()];
    for e in (0..m.mesh.tets.len()).filter(|&e| m.mesh.tet_body[e] == 1) {
        space.tet(&m.mesh, e).into_iter().for_each(|n| u[n] = v);
    }
    UpperFactor::new(certify_upper(m, &velocity(DisplacementField { u }), 1))
}

/// Two cubes of 10 mm, A clamped below B, and a load on B.
fn cubes(bodies: &str, tilt: f64) -> AnalysisModel {
    let shape = Block::new([1, 1, 2], [10.0, 10.0, 20.0]);
    let mut mesh = shape.mesh(&["A", "B"], |c| usize::from(c[2] > 10.0), |_, _| true);
    mesh.nodes.iter_mut().for_each(|x| x[2] += tilt * x[0]);
    let rest = "supports:\n- {face: Z0, fix: [x, y, z]}\nloads:\n- {face: Z1, traction: [1, 2, \
                0]}\n";
    model(&format!("bodies: {{{bodies}}}\n{rest}"), mesh)
}

/// What the certificate of slip along a tie requires and costs, by hand.
#[test]
fn what_slip_costs() {
    let k = FY / 3.0f64.sqrt();
    let m = cubes("A: s, B: s", 0.0);
    // 100 mm² at 5 mm per unit of time; the load does 3 + 8 per area
    let bound = moved(&m, [3.0, 4.0, 0.0]);
    let c = bound.certificate();
    assert!(bound.is_strict() && (c.ties[0] / (500.0 * k) - 1.0).abs() < 1e-14, "{c:?}");
    assert!((c.factor / (5.0 / 11.0 * k) - 1.0).abs() < 1e-12, "{c:?}");
    assert!(c.dissipation.iter().all(|d| *d < 1e-9), "{c:?}");
    // neither opening nor overlap is admissible, whatever it costs
    assert!(!moved(&m, [3.0, 4.0, 1e-7]).is_strict() && !moved(&m, [3.0, 4.0, -1e-7]).is_strict());
    assert!(!moved(&m, [3.0, f64::NAN, 0.0]).is_strict());
    // the weaker body counts, and the certificate does not take the model's word for it
    let mut weaker = m.clone();
    weaker.materials.iter_mut().for_each(|m| m.fy = m.fy.map(|f| 0.5 * f));
    let half = moved(&weaker, [3.0, 4.0, 0.0]).certificate().ties[0];
    assert!((half / (250.0 * k) - 1.0).abs() < 1e-14);
    let rigid = moved(&cubes("A: r, B: s", 0.0), [3.0, 4.0, 0.0]);
    assert!(rigid.is_strict() && (rigid.certificate().ties[0] / (500.0 * k) - 1.0).abs() < 1e-14);
    // no slip between bodies that never yield, nor on an oblique face
    assert!(cubes("A: s, B: s", 0.01).ties.is_empty());
    let both = cubes("A: s, B: s", 0.0);
    assert_eq!((both.parts.len(), both.ties.len()), (1, 1));
}
