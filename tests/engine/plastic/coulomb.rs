//! Coulomb's law beside bodies that yield: B8 with a strut behind the plate.
//!
//! ```text
//!              N₀ = 100 (dead)
//!                 v
//!     ======================= rigid: moves along x and z only
//!  T→ [   plate    ]|[ strut ]|    [b] [ spring ]|     k_n = 500 (bolt), k_t (spring)
//!     ~~~~~~~~~~~~~~                [o]
//!       μ = 0.3      frictionless   [l]   strut: yields at F_y = 40, its sides free
//! ```
//! At slip w the ground takes T − k_t w − F_y: μN₀ = 30 under Coulomb's law, μ(N₀ + k_n μw) = 52.5
//! at w = 0.5 under the associated one. The strut is a bar of uniform stress, so that both programs
//! hold it exactly.
//!
//! Tolerances: 1e-3 of the friction force, which is the tolerance of the fixed point. Below first
//! yield the energies agree with the elastic ones to 1e-4.

use crate::common::plastic::{run, strict_pass};
use crate::common::solved::{resolve_as, solve_to};
use crate::common::{Block, beside, triangles_where};
use bracket::analysis::energy_pass::EnergyPass;
use bracket::certify::coulomb_shift::distance_from_coulomb;
use bracket::mesh::{NamedFaces, TetMesh};
use bracket::model::AnalysisModel;
use bracket::solve::SolveOptions;

const MU: f64 = 0.3;
const N0: f64 = 100.0;
const KN: f64 = 500.0;
/// Yield strength of the strut \[MPa\] and its cross-section \[mm²\].
const FY: f64 = 10.0;
const AREA: f64 = 4.0;

/// The name of a face and the points that belong to it.
type Face<'a> = (&'a str, &'a dyn Fn([f64; 3]) -> bool);

fn named(mut mesh: TetMesh, faces: &[Face<'_>]) -> TetMesh {
    mesh.faces.clear();
    for (name, inside) in faces {
        let triangles = triangles_where(&mesh, inside);
        mesh.faces.push(NamedFaces { name: (*name).into(), triangles });
    }
    mesh
}

fn mesh(seed: u64) -> TetMesh {
    let block = |cells, min, max, seed| Block { cells, min, max, jitter: 0.2, seed };
    let plate = block([3, 1, 2], [0.0; 3], [6.0, 2.0, 2.0], seed);
    let body = |c: [f64; 3]| usize::from(c[0] > 4.0);
    let plate = plate.mesh(&["PLATE", "STRUT"], body, |axis, x| axis == 0 && x == 4.0);
    let plate = named(
        plate,
        &[
            ("HEAD", &|x| x[2] == 2.0 && x[0] <= 4.0),
            ("GROUND", &|x| x[2] == 0.0 && x[0] <= 4.0),
            ("STRUT_END", &|x| x[0] == 6.0),
            ("STRUT_UNDER", &|x| x[2] == 0.0 && x[0] >= 4.0),
            ("BACK", &|x| x[1] == 0.0),
        ],
    );
    let bolt = block([1, 1, 2], [10.0, 0.0, 0.0], [11.0, 1.0, 2.0], seed + 1).mesh(
        &["BOLT"],
        |_| 0,
        |_, _| false,
    );
    let bolt = named(bolt, &[("HEAD", &|x| x[2] == 2.0), ("BOLT_END", &|x| x[2] == 0.0)]);
    let spring = block([2, 1, 1], [20.0, 0.0, 0.0], [22.0, 1.0, 1.0], seed + 2).mesh(
        &["SPRING"],
        |_| 0,
        |_, _| false,
    );
    let spring = named(spring, &[("HEAD", &|x| x[0] == 20.0), ("SPRING_END", &|x| x[0] == 22.0)]);
    beside(beside(plate, bolt), spring)
}

/// The joint under T without the line of its analysis.
fn yaml(t: f64, kt: f64, friction: &str) -> String {
    format!(
        "materials:\n  hard: {{E: 1.0e6, nu: 0}}\n  bolt: {{E: 1000, nu: 0}}\n  spring: {{E: \
         {:?}, nu: 0}}\n  strut: {{E: 1000, nu: 0.3, fy: {FY}}}\nbodies: {{PLATE: hard, BOLT: \
         bolt, SPRING: spring, STRUT: strut}}\ninterfaces:\n- {{between: [PLATE, STRUT], law: \
         contact, mu: 0}}\nsupports:\n- {{face: GROUND, law: contact, mu: {MU}, friction: \
         {friction}}}\n- {{face: BOLT_END, fix: [z]}}\n- {{face: SPRING_END, fix: [x]}}\n- \
         {{face: STRUT_END, fix: [x]}}\n- {{face: STRUT_UNDER, fix: [z]}}\n- {{face: BACK, fix: \
         [y]}}\nrigid:\n- {{face: HEAD, components: [x, y, z], free: [ux, uz], force: [{t:?}, 0, \
         0], dead_force: [0, 0, -{N0}]}}\n",
        2.0 * kt,
    )
}

/// The model with the shift that the bounds belong to, and its pass.
fn solved(t: f64, kt: f64, friction: &str, seed: u64) -> (AnalysisModel, EnergyPass) {
    let mut model = resolve_as("elastoplastic", &yaml(t, kt, friction), mesh(seed))
        .unwrap_or_else(|e| panic!("{e:?}"));
    let pass = run(&model);
    model.shift = pass.shift.clone();
    (model, pass)
}

/// Displacement of the head along x: that of its first node.
fn slip(model: &AnalysisModel, pass: &EnergyPass) -> f64 {
    let head = model.rigid[0].faces[0];
    let node =
        model.mesh.tets[head.tet as usize][bracket::mesh::tet::FACES[head.local as usize][0]];
    pass.displacement.as_ref().expect("optimal").u[node as usize][0]
}

#[test]
fn coulomb_s_law_holds_beside_a_strut_that_yields() {
    for (seed, kt) in [(1, 100.0), (4, 300.0)] {
        for (friction, force) in [("coulomb", 30.0), ("associated", 52.5)] {
            let t = force + FY * AREA + 0.5 * kt;
            let (model, pass) = solved(t, kt, friction, seed);
            let name = format!("strut, {friction}, k_t {kt}");
            strict_pass(&name, &model, &pass);
            let w = slip(&model, &pass);
            let carried = t - FY * AREA - kt * w;
            println!("{name}: slip {w:.7}, friction {carried:.6}, {:?}", pass.fixed_point);
            let expected = if friction == "coulomb" { MU * N0 } else { MU * (N0 + KN * MU * w) };
            assert!(
                (carried - expected).abs() < 1e-3 * force,
                "{name}: {carried} against {expected} at slip {w}"
            );
            assert!((w - 0.5).abs() < 1e-3 * force / kt, "{name}: slip {w}");
            // the strut has yielded, and the shift agrees with the slips
            assert!(pass.runs().all(|(_, r)| r.yielding.unwrap() > 0), "{name}");
            assert_eq!(pass.fixed_point.is_some(), friction == "coulomb", "{name}");
            let off =
                distance_from_coulomb(&model, &pass.shift, pass.displacement.as_ref().unwrap());
            assert!(friction != "coulomb" || off < 2e-3, "{name}: {off:e}");
        }
    }
}

/// Where nothing yields, the fixed point is that of elastic analysis.
#[test]
fn below_first_yield_the_problem_is_the_elastic_one() {
    // at nine tenths of the yield force of the strut, whose stiffness of 2000 acts beside k_t
    let (t, kt) = (30.0 + 0.018 * (2000.0 + 3000.0), 3000.0);
    let (model, pass) = solved(t, kt, "coulomb", 7);
    let [low, up] = strict_pass("elastic strut", &model, &pass);
    assert!(pass.fixed_point.as_ref().is_some_and(|f| f.solves > 1), "{:?}", pass.fixed_point);
    let elastic = solve_to(&yaml(t, kt, "coulomb"), mesh(7), &SolveOptions::default());
    let [a, b] = elastic.strict("elastic strut");
    // two fixed points, each accurate to a thousandth of the slips
    assert!(
        (low - a).abs() < 1e-4 * a.abs() && (up - b).abs() < 1e-4 * b.abs(),
        "[{low}, {up}] against [{a}, {b}]"
    );
}
