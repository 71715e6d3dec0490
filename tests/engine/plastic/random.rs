//! Random small assemblies beyond first yield: no result is a wrong number.

use crate::common::plastic::{plastic_model, run, strict_pass};
use crate::common::yielding::FY;
use crate::common::{Block, Random};
use bracket::model::AnalysisModel;
use bracket::programs::Static;
use bracket::solve::{SolveOptions, clarabel};
use std::collections::BTreeMap;

/// Two stacked blocks, tied or in contact, clamped at the foot and held on two sides. The load on
/// the top is a fraction of the load that they may carry.
fn assembly(seed: u64) -> AnalysisModel {
    let mut r = Random::new(seed);
    (0..8).for_each(|_| _ = r.unit());
    let mut between = |a: f64, b: f64| a + (b - a) * r.unit();
    let size = [between(5.0, 40.0), between(5.0, 40.0), between(10.0, 60.0)];
    let share = between(0.2, 0.9);
    let t =
        [between(-0.15, 0.15), between(-0.15, 0.15), between(-1.0, -0.3)].map(|t| t * share * FY);
    let (mu, gap) = (between(0.05, 1.0), if between(0.0, 1.0) < 0.3 { 0.01 } else { 0.0 });
    let interface = match (between(0.0, 3.0)) as usize {
        0 => String::new(),
        1 => format!("interfaces:\n- {{between: [A, B], law: contact, mu: 0, gap: {gap:?}}}\n"),
        _ => format!(
            "interfaces:\n- {{between: [A, B], law: contact, mu: {mu:?}, gap: {gap:?}, friction: \
             associated}}\n"
        ),
    };
    let (other, middle) = (if between(0.0, 1.0) < 0.3 { "r" } else { "s" }, 0.5 * size[2]);
    let cells = [1 + r.below(2), 1 + r.below(2), 2 + 2 * r.below(2)];
    let shape = Block { cells, min: [0.0; 3], max: size, jitter: 0.2, seed };
    let mesh = shape.mesh(
        &["A", "B"],
        |c| usize::from(c[2] > middle),
        |d, x| d == 2 && (x - middle).abs() < 1e-9,
    );
    plastic_model(
        &format!(
            "bodies: {{A: s, B: {other}}}\n{interface}supports:\n- {{face: Z0, fix: [x, y, \
             z]}}\n- {{face: X0, fix: [x]}}\n- {{face: Y0, fix: [y]}}\nloads:\n- {{face: Z1, \
             traction: {t:?}}}\n"
        ),
        mesh,
    )
}

/// Every bracket is strict and in order. With all yield conditions, Clarabel finds the same lower
/// bound.
#[test]
fn random_assemblies() {
    let mut ends: BTreeMap<String, usize> = BTreeMap::new();
    let (mut brackets, mut yielded, mut compared) = (0, 0, 0);
    for seed in 0..16 {
        let m = assembly(seed);
        let pass = run(&m);
        for (program, r) in pass.runs() {
            *ends.entry(format!("{}: {}", program.name(), r.status.words())).or_default() += 1;
            assert_eq!(r.trouble, None, "seed {seed}");
        }
        if pass.bracket.is_none() {
            // no equilibrium is a valid result if it is reported as such
            assert!(
                pass.runs().any(|(_, r)| r.mechanism.is_some()),
                "seed {seed}: {:?}",
                pass.statics
            );
            continue;
        }
        let [low, _] = strict_pass(&format!("seed {seed}"), &m, &pass);
        brackets += 1;
        yielded += usize::from(pass.runs().any(|(_, r)| r.yielding.is_some_and(|n| n > 0)));
        if seed % 4 == 0 {
            let statics = Static::with_plasticity(&m).unwrap();
            let s = clarabel::solve(&statics.program, &SolveOptions::default());
            if s.status.is_solution() {
                let all = statics.program.objective(&s.x, &s.z);
                assert!((low - all).abs() <= 2e-6 * all.abs(), "seed {seed}: {low} {all}");
                compared += 1;
            }
        }
    }
    println!(
        "{ends:?}; {brackets} strict brackets, {yielded} with yield, {compared} compared with \
         Clarabel"
    );
    assert!(brackets >= 10 && yielded >= 5 && compared >= 2);
}
