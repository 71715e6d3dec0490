//! Load cases on one mesh share orderings and symbolic factors. Every bound and field stays equal
//! to that of a single run, to the last bit.

use crate::common::{Block, solved};
use bracket::analysis::energy_pass::EnergyPass;
use bracket::analysis::event::silent;
use bracket::analysis::limit::LimitPass;
use bracket::analysis::pass::PassOptions;
use bracket::analysis::{elastic, limit};
use bracket::mesh::TetMesh;
use bracket::model::AnalysisModel;
use bracket::solve::{Patterns, SolveOptions};

/// Two stacked leaves, clamped at one end.
fn leaves() -> TetMesh {
    Block::new([5, 2, 2], [50.0, 20.0, 20.0]).jittered(7).mesh(
        &["LOWER", "UPPER"],
        |c| usize::from(c[2] > 10.0),
        |axis, z| axis == 2 && z == 10.0,
    )
}

/// The leaves with friction, under a load.
fn case(kind: &str, load: &str) -> AnalysisModel {
    let yaml = format!(
        "materials: {{s: {{E: 210000, nu: 0.3, fy: 235}}}}\nbodies: {{LOWER: s, UPPER: \
         s}}\ninterfaces:\n- {{between: [LOWER, UPPER], law: contact, mu: 0.3, friction: \
         associated}}\nsupports:\n- {{face: X0, fix: [x, y, z]}}\nloads:\n- {load}\n"
    );
    match solved::resolve_as(kind, &yaml, leaves()) {
        Ok(model) => model,
        Err(e) => panic!("{e:?}"),
    }
}

const LOADS: [&str; 2] = ["{face: Z1, traction: [0, 0, -10]}", "{face: X1, traction: [0, 3, -20]}"];

fn options(patterns: &Patterns) -> PassOptions {
    let solve = SolveOptions { patterns: patterns.clone(), ..SolveOptions::default() };
    PassOptions { solve, ..PassOptions::default() }
}

/// The result of a limit pass, bit by bit.
fn answer(p: &LimitPass) -> (Vec<u64>, String) {
    let stress =
        |s: &Option<bracket::certify::fields::StressField>| format!("{:?}", s.as_ref().unwrap());
    let bounds = [p.bracket.as_ref().unwrap().lower(), p.frictionless.as_ref().unwrap()]
        .map(|b| b.value().to_bits());
    let upper = p.bracket.as_ref().unwrap().upper().value().to_bits();
    let fields = format!("{}{}{:?}", stress(&p.stress), stress(&p.frictionless_stress), p.velocity);
    (vec![bounds[0], bounds[1], upper], fields)
}

#[test]
fn limit_cases_share_patterns_and_give_the_same_results_as_alone() {
    let shared = Patterns::default();
    let cases = LOADS.map(|load| case("limit", load));
    let together =
        cases.each_ref().map(|m| answer(&limit::run(m, &options(&shared), &silent()).unwrap()));
    let (kept, found) = shared.count();
    // patterns of both programs and of both matrices that make their fields admissible
    assert!(kept <= 4, "{kept} patterns for one mesh");
    // the first case reuses patterns in the static program without friction and its projection; the
    // second case reuses all of them
    assert!(found >= 8, "{found}");
    for (model, together) in cases.iter().zip(&together) {
        assert!(
            answer(&limit::run(model, &options(&Patterns::default()), &silent()).unwrap())
                == *together
        );
    }
    assert!(together[0] != together[1], "two cases, two answers");
}

#[test]
fn elastic_and_limit_analysis_share_patterns_and_give_the_same_results_as_alone() {
    let shared = Patterns::default();
    let energies = |p: &EnergyPass| {
        let b = p.bracket.as_ref().unwrap();
        (
            b.lower().value().to_bits(),
            b.upper().value().to_bits(),
            format!("{:?}{:?}", p.stress, p.displacement),
        )
    };
    let run = |load: &str, patterns: &Patterns| {
        energies(&elastic::run(&case("elastic", load), &options(patterns), &silent()).unwrap())
    };
    limit::run(&case("limit", LOADS[0]), &options(&shared), &silent()).unwrap();
    let before = shared.count();
    let together = LOADS.map(|load| run(load, &shared));
    let after = shared.count();
    // that of its kinematic program: bodies slip on held faces in limit analysis only
    assert_eq!(after.0, before.0 + 1, "an elastic case brings one new pattern");
    assert!(after.1 >= before.1 + 5, "{before:?} {after:?}");
    for (load, together) in LOADS.iter().zip(&together) {
        assert!(run(load, &Patterns::default()) == *together);
    }
}
