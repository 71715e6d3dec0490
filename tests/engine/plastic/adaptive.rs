//! Yield conditions only where they are needed. Below first yield the result is that of the elastic
//! analysis. Beyond it the result is that of all conditions. Beyond the limit load there is no
//! equilibrium.

use crate::common::Block;
use crate::common::plastic::{plastic_model, run, strict, strict_pass};
use crate::common::yielding::{self, FY};
use bracket::analysis::energy_pass::EnergyPass;
use bracket::analysis::event::silent;
use bracket::analysis::pass::PassOptions;
use bracket::analysis::{elastic, limit};
use bracket::elements::hencky_kinematic::Flow;
use bracket::model::AnalysisKind;
use bracket::model::AnalysisModel;
use bracket::programs::{Kinematic, Static};
use bracket::solve::{Patterns, SolveOptions, SolveStatus, condensed};

fn elastic(model: &AnalysisModel) -> EnergyPass {
    let model = AnalysisModel { analysis: AnalysisKind::Elastic, ..model.clone() };
    elastic::run(&model, &PassOptions::default(), &silent()).unwrap()
}

fn block(n: usize, factor: f64) -> AnalysisModel {
    AnalysisModel { analysis: AnalysisKind::Elastoplastic, ..yielding::block(n, factor) }
}

/// Two blocks with friction and an initial gap between them and a gap to a rigid wall beside them,
/// pressed and pushed.
fn stacked(pressure: f64) -> AnalysisModel {
    let mesh =
        Block { cells: [2, 2, 4], min: [0.0; 3], max: [20.0, 20.0, 40.0], jitter: 0.15, seed: 4 }
            .mesh(
                &["LOW", "HIGH"],
                |c| usize::from(c[2] > 20.0),
                |axis, z| axis == 2 && (z - 20.0).abs() < 1e-9,
            );
    let (p, t) = (pressure, 0.1 * pressure);
    plastic_model(
        &format!(
            "bodies: {{LOW: s, HIGH: s}}\ninterfaces:\n- {{between: [LOW, HIGH], law: contact, \
             mu: 0.3, gap: 0.01, friction: associated}}\nsupports:\n- {{face: Z0, fix: [x, y, \
             z]}}\n- {{face: X1, law: contact, mu: 0.0, gap: 0.02}}\nloads:\n- {{face: Z1, \
             traction: [{t:?}, 0, {:?}]}}\n",
            -p
        ),
        mesh,
    )
}

/// Below first yield the bracket is the elastic one, and no tet has a yield condition; with contact
/// each has one from the start.
#[test]
fn below_first_yield_it_is_the_elastic_analysis() {
    for (name, model) in [("block", block(3, 0.3)), ("stacked", stacked(20.0))] {
        let pass = run(&model);
        let [low, up] = strict_pass(name, &model, &pass);
        let with = if name == "block" { 0 } else { model.mesh.tets.len() };
        assert!(pass.runs().all(|(_, r)| r.yielding == Some(with)));
        let elastic = elastic(&model).bracket.unwrap();
        let near = |a: f64, b: f64, most: f64| (a - b).abs() <= most * b.abs();
        // with contact a solve ends at a gap of 1e-7, and split elements find a lower energy
        let (l, u) = (elastic.lower().value(), elastic.upper().value());
        let same = if with == 0 {
            near(low, l, 1e-8) && near(up, u, 1e-8)
        } else {
            near(low, l, 1e-6) && low <= up && up <= u + 1e-7 * u.abs()
        };
        assert!(same, "{name}: {low} {up}");
    }
}

/// The result is that of the programs with every yield condition: the same lower bound, and an
/// upper bound between that of plain elements and that of split elements alone.
#[test]
fn nothing_is_lost() {
    for (name, model) in [("block", block(3, 0.85)), ("stacked", stacked(180.0))] {
        let pass = run(&model);
        let [low, up] = strict_pass(name, &model, &pass);
        assert!(pass.runs().any(|(_, r)| r.yielding.is_some_and(|n| n > 0)));
        let statics = Static::with_plasticity(&model).unwrap();
        let full = |program: &_, block: &[u32]| {
            let s = condensed::Prepared::new(program, block, &Patterns::default())
                .unwrap()
                .solve(&SolveOptions::default());
            assert!(s.status.is_solution());
            s
        };
        let s = full(&statics.program, &statics.map.block);
        let all = statics.program.objective(&s.x, &s.z);
        let [plain, split] = [Flow::Plain, Flow::Split].map(|flow| {
            let k = Kinematic::with_plasticity(&model, flow).unwrap();
            let s = full(&k.program, &k.map.block);
            k.program.objective(&s.x, &s.z)
        });
        println!(
            "{name}: all conditions {all:.9e} {split:.9e}, plain {plain:.9e}; here {low:.9e} \
             {up:.9e}"
        );
        let slack = 1e-6 * low.abs();
        assert!((low - all).abs() <= slack, "{name}: {low} {all}");
        assert!(up <= plain + slack && up >= split - slack, "{name}: {up} {plain} {split}");
    }
}

/// Towards the limit load of the mesh all elements yield. Beyond it there is no equilibrium: first
/// in the static program, then in both.
#[test]
fn beyond_the_limit_load_nothing_balances() {
    let at_one = AnalysisModel { analysis: AnalysisKind::Limit, ..block(2, 1.0) };
    let bracket = limit::run(&at_one, &PassOptions::default(), &silent()).unwrap().bracket.unwrap();
    let [low, up] = [bracket.lower().value(), bracket.upper().value()];
    println!("limit load between {low} and {up} times the block's");
    let [a, b] =
        [0.9 * low, 0.995 * low].map(|f| strict(&format!("block at {f:.4}"), &block(2, f)));
    assert!(b[0] < a[0] && b[1] < a[1]);
    let pass = run(&block(2, 1.005 * low));
    assert_eq!(pass.statics.as_ref().unwrap().status, SolveStatus::Unbounded);
    assert!(pass.lower.is_none() && pass.upper.is_some_and(|u| u.is_strict()));
    // plastic flow dissipates more by the vertex rule of the energy than by the rule of the limit
    // load
    let pass = run(&block(2, 1.3 * up));
    for (program, r) in pass.runs() {
        println!("{}: {:?} after {} solves: {:?}", program.name(), r.status, r.rounds, r.mechanism);
        assert_eq!(r.status, SolveStatus::Unbounded);
        assert!(
            r.mechanism.as_ref().is_some_and(|m| m
                .to_string()
                .contains("body `B` (100 % of the dissipation) yields"))
        );
    }
    assert!(pass.lower.is_none() && pass.upper.is_none());
}

/// A dead load counts as any other load, and a force per volume does work in split tets too.
#[test]
fn dead_loads_and_body_forces_count() {
    let mesh =
        || Block::new([2, 2, 4], [20.0, 20.0, 40.0]).jittered(2).mesh(&["B"], |_| 0, |_, _| false);
    let support = "bodies: {B: s}\nsupports:\n- {face: Z0, fix: [x, y, z]}\n";
    let (p, t) = (-0.6 * FY, 0.03 * FY);
    let live = plastic_model(
        &format!("{support}loads:\n- {{face: Z1, traction: [{t:?}, 0, {p:?}]}}\n"),
        mesh(),
    );
    let both = plastic_model(
        &format!(
            "{support}dead:\n- {{face: Z1, traction: [0, 0, {p:?}]}}\nloads:\n- {{face: Z1, \
             traction: [{t:?}, 0, 0]}}\n"
        ),
        mesh(),
    );
    let [a, b] = [strict("live", &live), strict("dead and live", &both)];
    assert!((0..2).all(|i| (a[i] - b[i]).abs() < 1e-9 * a[i].abs()), "{a:?} {b:?}");
    let pushed = plastic_model(
        &format!("{support}loads:\n- {{body: B, force: [{:?}, 0, 0]}}\n", 0.005 * FY),
        mesh(),
    );
    let pass = run(&pushed);
    let [low, up] = strict_pass("body force", &pushed, &pass);
    assert!(pass.runs().any(|(_, r)| r.yielding.is_some_and(|n| n > 0)) && low < up);
}
