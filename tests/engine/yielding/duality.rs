//! The kinematic programs bound the energy from above, the static one from below. Far below yield
//! all of them give the elastic result.

use crate::common::yielding::{Built, FORMS, FY, Form, block, model};
use crate::common::{Block, oracle};
use bracket::elements::hencky_kinematic::Flow;
use bracket::elements::hencky_static::parameter_unit;
use bracket::model::AnalysisModel;
use bracket::programs::conic::{ConicProgram, cone_margin};
use bracket::programs::{Kinematic, Static};
use bracket::solve::{Solution, SolveOptions, solve};

/// The program of a model and its solution by the condensed method, after the checks that must hold
/// for every optimal solution. Clarabel finds the same objective.
pub fn optimal(name: &str, form: Form, model: &AnalysisModel) -> (Built, Solution) {
    let built = form.build(model);
    let s = oracle::agree(&format!("{name} {form:?}"), &built.program, &built.block);
    stationary(&format!("{name} {form:?}"), &built.program, &s);
    (built, s)
}

/// Checks `P x + q = ± Gᵀz` in every row, minimised or maximised. Checks that slacks and
/// multipliers lie in their cones and are complementary.
fn stationary(name: &str, program: &ConicProgram, s: &Solution) {
    let ([px], gz, slack) =
        (program.quadratic([&s.x]), program.rows_transposed(&s.z), program.slack(&s.x));
    // compares each row with the largest of its terms, as work on the typical size of the unknown
    let energy = program.objective(&s.x, &s.z).abs();
    for i in 0..program.unknowns() {
        let residual = px[i] + program.q[i] - gz[i];
        assert!(
            (residual * s.x[i]).abs() <= 1e-6 * energy,
            "{name}: row {i} {residual:e} × {:e}",
            s.x[i]
        );
    }
    let largest = |v: &[f64]| v.iter().fold(0.0f64, |m, x| m.max(x.abs()));
    for (start, cone) in program.cone_starts().into_iter().zip(&program.cones) {
        let range = start..start + cone.dim();
        let (a, b) = (&slack[range.clone()], &s.z[range]);
        assert!(cone_margin(a) * b[0] >= -1e-6 * energy, "{name}: slack {a:?}");
        assert!(cone_margin(b) >= -1e-6 * largest(&s.z), "{name}: multiplier {b:?}");
        let product: f64 = a.iter().zip(b).map(|(a, b)| a * b).sum();
        assert!(product.abs() <= 1e-6 * energy, "{name}: slack · multiplier {product:e}");
    }
}

/// Objectives of the three programs, which are dual to each other.
fn bracket(name: &str, model: &AnalysisModel) -> [f64; 3] {
    let [plain, split, lower] = FORMS.map(|form| {
        let (built, s) = optimal(name, form, model);
        built.program.objective(&s.x, &s.z)
    });
    println!(
        "{name}: static {lower:.9e}, split {split:.9e}, plain {plain:.9e}, gap {:.4}",
        (split - lower) / lower.abs()
    );
    let slack = 1e-7 * lower.abs();
    assert!(
        lower <= split + slack && split <= plain + slack,
        "{name}: {lower:e} {split:e} {plain:e}"
    );
    [plain, split, lower]
}

/// Duality on refined meshes of a partly plastic block: the gap shrinks.
#[test]
fn the_gap_shrinks() {
    let gaps: Vec<f64> = (1..4)
        .map(|n| {
            let [_, split, lower] = bracket(&format!("block {n}"), &block(n, 0.6));
            (split - lower) / lower.abs()
        })
        .collect();
    assert!(gaps.windows(2).all(|w| w[1] < 0.8 * w[0]), "{gaps:?}");
}

/// Objective of an elastic program.
fn linear(program: &ConicProgram, block: &[u32]) -> f64 {
    program.objective(&solve(program, block, &SolveOptions::default()).x, &[])
}

/// Far below yield the results equal those of the elastic programs to 1e-8. The split element is
/// softer than the plain one, so it is compared with a split element of three times the strength.
#[test]
fn far_below_yield_everything_is_elastic() {
    let model = block(2, 0.1);
    let mut stronger = model.clone();
    stronger.materials.iter_mut().for_each(|m| m.fy = Some(3.0 * FY));
    let kinematic = Kinematic::new(&model).unwrap();
    let elastic = linear(&kinematic.program, &kinematic.map.block);
    let statics = Static::new(&model).unwrap();
    let lower = linear(&statics.program, &statics.map.block);
    for form in FORMS {
        let (built, s) = optimal("far below", form, &model);
        assert_eq!(built.flowing(&model, &s), 0.0);
        let got = built.program.objective(&s.x, &s.z);
        let want = match form {
            Form::Plain => elastic,
            Form::Split => {
                let (built, s) = optimal("stronger", form, &stronger);
                let split = built.program.objective(&s.x, &s.z);
                assert!(split < elastic && split > lower);
                split
            }
            Form::Static => lower,
        };
        println!("{form:?}: {got:.12e} against {want:.12e}, {:.1e}", got / want - 1.0);
        assert!((got - want).abs() < 1e-8 * want.abs(), "{form:?}");
    }
}

/// The elastic solution, its stress parameters and zero flow satisfy every row of the static saddle
/// problem, and its yield condition is that of the elastic stress. The test needs no solver, only
/// one linear solve.
#[test]
fn elastic_stress_is_stationary() {
    let mut model = block(2, 0.1);
    model.body_loads.push(bracket::model::analysis::BodyLoad {
        body: 0,
        dead: false,
        force: [0.02, -0.01, 0.03],
    });
    let elastic = Static::new(&model).unwrap();
    let v = solve(&elastic.program, &elastic.map.block, &SolveOptions::default()).x;
    let yielding = Static::with_plasticity(&model).unwrap();
    let program = &yielding.program;
    let mut x = vec![0.0; program.unknowns()];
    x[..v.len()].copy_from_slice(&v);
    let full = elastic.map.expand(&v);
    let radius = bracket::math::mandel::yield_radius(FY);
    let mut stresses = Vec::new();
    for e in 0..model.mesh.tets.len() {
        let element = elastic.elements.element(e).unwrap();
        let a = element.parameters(&elastic.elements.dofs(e).map(|d| full[d]), true);
        let unit = parameter_unit(&element, radius);
        x[yielding.own[e]..yielding.own[e + 1]].copy_from_slice(&a.map(|a| a / unit));
        stresses.push(element.stress(&a));
    }
    let [px] = program.quadratic([&x]);
    let rows: Vec<f64> = px.iter().zip(&program.q).map(|(a, b)| a + b).collect();
    let force = program.q[..v.len()].iter().fold(0.0f64, |m, q| m.max(q.abs()));
    assert!(rows[..v.len()].iter().all(|r| r.abs() < 1e-9 * force), "equilibrium");
    // a row of compatibility is the difference of two energies: that of the element's stress and
    // that of its displacements
    let mut flexed = x.clone();
    flexed[v.len()..].fill(0.0);
    let [strain] = program.quadratic([&flexed]);
    let slack = program.slack(&x);
    for e in 0..model.mesh.tets.len() {
        let own = yielding.own[e]..yielding.own[e + 1];
        let size = strain[own.clone()].iter().fold(0.0f64, |m, s| m.max(s.abs()));
        assert!(
            size > 0.0 && rows[own].iter().all(|r| r.abs() < 1e-9 * size),
            "compatibility of tet {e}"
        );
        for point in 0..16 {
            let s = bracket::math::mandel::deviator(&stresses[e][point / 4][point % 4]);
            let slack = &slack[6 * (16 * e + point)..][..6];
            assert!((slack[0] - 1.0).abs() < 1e-9);
            assert!(
                (0..5).all(|i| (slack[1 + i] * radius - s[i]).abs() < 1e-9 * radius),
                "yield condition"
            );
            assert!(cone_margin(slack) > 0.5);
        }
    }
    let (a, b) =
        (program.objective(&x, &vec![0.0; program.h.len()]), elastic.program.objective(&v, &[]));
    assert!((a - b).abs() < 1e-10 * b.abs(), "{a} {b}");
}

/// The same on the kinematic side, element by element. The parameters are each vertex's share of
/// the deviatoric stress, divided by its share of the yield radius. With them every row of the
/// saddle problem is zero.
#[test]
fn elastic_displacements_are_stationary() {
    let model = block(2, 0.1);
    let elastic = Kinematic::new(&model).unwrap();
    let u = solve(&elastic.program, &elastic.map.block, &SolveOptions::default()).x;
    let yielding = Kinematic::with_plasticity(&model, Flow::Plain).unwrap();
    let program = &yielding.program;
    let mut x = vec![0.0; program.unknowns()];
    x[..u.len()].copy_from_slice(&u);
    let full = elastic.map.expand(&u);
    let material = model.stiffnesses()[0];
    for e in 0..model.mesh.tets.len() {
        let nodes = elastic.space.tet(&model.mesh, e);
        let at = nodes.map(|n| [full[3 * n], full[3 * n + 1], full[3 * n + 2]]);
        let strains = bracket::elements::tet10::vertex_strains(&model.mesh.corners(e), &at);
        let stress = strains.map(|s| bracket::math::mandel::deviator(&material.stress(&s)));
        let radius = bracket::math::mandel::yield_radius(FY) * model.mesh.volume(e) / 4.0;
        for i in 0..4 {
            for a in 0..5 {
                // ∫ λ_i of a linear field: (its value at i + the sum of all four) V/20
                let share = (stress[i][a] + (0..4).map(|j| stress[j][a]).sum::<f64>())
                    * model.mesh.volume(e)
                    / 20.0;
                x[yielding.own[e] + 5 * i + a] = share / radius;
            }
        }
    }
    let [px] = program.quadratic([&x]);
    let rows: Vec<f64> = px.iter().zip(&program.q).map(|(a, b)| a + b).collect();
    let force = program.q[..u.len()].iter().fold(0.0f64, |m, q| m.max(q.abs()));
    assert!(rows[..u.len()].iter().all(|r| r.abs() < 1e-9 * force), "equilibrium");
    let mut flexed = x.clone();
    flexed[u.len()..].fill(0.0);
    let [strain] = program.quadratic([&flexed]);
    for e in 0..model.mesh.tets.len() {
        let own = yielding.own[e]..yielding.own[e + 1];
        let size = strain[own.clone()].iter().fold(0.0f64, |m, s| m.max(s.abs()));
        assert!(size > 0.0 && rows[own].iter().all(|r| r.abs() < 1e-9 * size), "strain of tet {e}");
    }
    assert!(program.slack(&x).chunks_exact(6).all(|s| s[0] == 1.0 && cone_margin(s) > 0.5));
    let (a, b) =
        (program.objective(&x, &vec![0.0; program.h.len()]), elastic.program.objective(&u, &[]));
    assert!((a - b).abs() < 1e-12 * b.abs(), "{a} {b}");
}

/// Two blocks, one of which never yields, are pressed and pushed across a contact with friction and
/// an initial gap. Beside them is a rigid wall, also with a gap. One program contains contact cones
/// and yield cones.
fn blocks_in_contact(pressure: f64) -> AnalysisModel {
    let mesh =
        Block { cells: [2, 2, 4], min: [0.0; 3], max: [20.0, 20.0, 40.0], jitter: 0.15, seed: 4 }
            .mesh(
                &["LOW", "HIGH"],
                |c| usize::from(c[2] > 20.0),
                |axis, z| axis == 2 && (z - 20.0).abs() < 1e-9,
            );
    let (p, t) = (pressure, 0.1 * pressure);
    model(
        &format!(
            "bodies: {{LOW: s, HIGH: r}}\ninterfaces:\n- {{between: [LOW, HIGH], law: contact, \
             mu: 0.3, gap: 0.01, friction: associated}}\nsupports:\n- {{face: Z0, fix: [x, y, \
             z]}}\n- {{face: X1, law: contact, mu: 0.0, gap: 0.02}}\nloads:\n- {{face: Z1, \
             traction: [{t:?}, 0, {:?}]}}\n",
            -p
        ),
        mesh,
    )
}

#[test]
fn contact_and_yield_in_one_program() {
    // far below yield the result is that of elastic bodies in contact
    let model = blocks_in_contact(20.0);
    let kinematic = Kinematic::new(&model).unwrap();
    let statics = Static::new(&model).unwrap();
    let elastic =
        [(&kinematic.program, &kinematic.map.block), (&statics.program, &statics.map.block)]
            .map(|(p, b)| linear(p, b));
    let [plain, split, lower] = bracket("contact, elastic", &model);
    println!("contact: elastic {elastic:?}");
    assert!(
        (plain - elastic[0]).abs() < 1e-7 * plain.abs()
            && (lower - elastic[1]).abs() < 1e-7 * lower.abs()
    );
    assert!(split < plain);
    // beyond first yield the bodies release more energy than elastic bodies
    let model = blocks_in_contact(225.0);
    let [plain, split, lower] = bracket("contact, yielding", &model);
    let elastic = Kinematic::new(&model).unwrap();
    let stiff = linear(&elastic.program, &elastic.map.block);
    assert!(
        plain < 1.001 * stiff && split < plain && lower < split,
        "{stiff} {plain} {split} {lower}"
    );
    let built = Form::Split.build(&model);
    assert_eq!(built.program.cones.iter().filter(|c| c.dim() == 3).count(), 25);
    assert_eq!(built.program.cones.iter().filter(|c| c.dim() == 6).count(), 16 * 48);
}
