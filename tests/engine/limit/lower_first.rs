//! Where the time may not suffice for both bounds, the lower one comes first and the upper one is
//! added later. Bounds and fields are those of both programs side by side, to the last bit.

use crate::common::{Block, solved};
use bracket::analysis::event::{Event, Progress, silent};
use bracket::analysis::limit::{self, LimitPass};
use bracket::analysis::pass::PassOptions;
use bracket::analysis::program::Program;
use bracket::model::AnalysisModel;
use bracket::model::file::Bounds;
use bracket::solve::SolveOptions;
use std::sync::{Arc, Mutex};
use std::time::{Duration, Instant};

/// Two stacked leaves, clamped at one end and pressed and bent at the other, with this contact.
fn leaves(contact: &str) -> AnalysisModel {
    let mesh = Block::new([4, 2, 2], [40.0, 20.0, 20.0]).jittered(5).mesh(
        &["LOWER", "UPPER"],
        |c| usize::from(c[2] > 10.0),
        |axis, z| axis == 2 && z == 10.0,
    );
    let yaml = format!(
        "materials: {{s: {{E: 210000, nu: 0.3, fy: 235}}}}\nbodies: {{LOWER: s, UPPER: \
         s}}\ninterfaces:\n- {{between: [LOWER, UPPER], law: contact, {contact}}}\nsupports:\n- \
         {{face: X0, fix: [x, y, z]}}\nloads:\n- {{face: Z1, traction: [0, 0, -10]}}\n"
    );
    solved::resolve_as("limit", &yaml, mesh).unwrap()
}

const CONTACTS: [&str; 3] =
    ["mu: 0", "mu: 0.3, friction: associated", "mu: 0.3, friction: coulomb"];

fn within(seconds: f64) -> PassOptions {
    PassOptions { both_within: seconds, ..PassOptions::default() }
}

/// The bounds of a pass, bit by bit, and its fields: lower, without friction, upper, gaps.
fn answer(p: &LimitPass, coulomb: bool) -> (Vec<Option<u64>>, String) {
    let (stress, lower) = p.carried(coulomb).unwrap();
    let bracket = if coulomb { &p.coulomb } else { &p.bracket };
    let numbers = [
        Some(lower.value()),
        p.frictionless.as_ref().map(|b| b.value()),
        p.upper.as_ref().map(|b| b.value()),
        bracket.as_ref().map(|b| b.gap()),
        p.contributions.as_ref().map(|c| c.total()),
    ];
    let bits = numbers.into_iter().map(|x| x.map(f64::to_bits)).collect();
    (bits, format!("{stress:?}{:?}", p.velocity))
}

#[test]
fn the_lower_bound_first_and_the_upper_one_later_are_those_of_both_together() {
    for contact in CONTACTS {
        let model = leaves(contact);
        let coulomb = contact.contains("coulomb");
        let together = limit::run(&model, &PassOptions::default(), &silent()).unwrap();
        assert!(!limit::wants_upper(&together, &model));
        // not at all, and not by the forecast
        for seconds in [0.0, 1e-9] {
            let mut pass = limit::run(&model, &within(seconds), &silent()).unwrap();
            assert!(pass.kinematic.is_none() && pass.upper.is_none(), "{contact}");
            assert!(limit::wants_upper(&pass, &model), "{contact}");
            // under Coulomb's law the bound without friction answers, and is computed alone
            assert_eq!(pass.lower.is_none(), coulomb, "{contact}");
            let lower = pass.carried(coulomb).unwrap().1.clone();
            assert!(lower.is_strict(), "{contact}: {lower:?}");
            limit::add_upper(&mut pass, &model, &PassOptions::default(), &silent()).unwrap();
            assert!(!limit::wants_upper(&pass, &model), "{contact}");
            assert!(answer(&pass, coulomb) == answer(&together, coulomb), "{contact}");
        }
        // enough time
        let pass = limit::run(&model, &within(1e9), &silent()).unwrap();
        assert!(answer(&pass, coulomb) == answer(&together, coulomb), "{contact}");
    }
}

/// A time limit that ends before the upper bound leaves the lower one.
#[test]
fn a_time_limit_leaves_the_lower_bound() {
    let model = leaves(CONTACTS[0]);
    let later = Arc::new(Mutex::new(Vec::new()));
    let seen = later.clone();
    let progress: Progress = Arc::new(move |program, event| {
        if let Event::Later { expected, within } = event {
            seen.lock().unwrap().push((program, expected, within));
        }
    });
    let mut pass = limit::run(&model, &within(1e-9), &progress).unwrap();
    let later = later.lock().unwrap().clone();
    assert!(
        matches!(later[..], [(Program::Kinematic, expected, within)] if expected > within),
        "{later:?}"
    );
    let lower = pass.lower.clone().unwrap();
    let solve = SolveOptions { time_limit: 0.0, ..SolveOptions::default() };
    let over = PassOptions { solve, ..PassOptions::default() };
    limit::add_upper(&mut pass, &model, &over, &silent()).unwrap();
    assert_eq!(pass.kinematic.as_ref().unwrap().status.words(), "time limit");
    assert!(pass.upper.is_none() && pass.lower.as_ref().unwrap().value() == lower.value());
}

/// A lower bound whose time ends before the solver's tolerances are reached is strict, certified
/// from its own field, and not above the one with all the time.
#[test]
fn time_that_ends_late_leaves_a_bound() {
    let model = AnalysisModel { bounds: Bounds::Static, ..leaves(CONTACTS[0]) };
    let whole = limit::run(&model, &PassOptions::default(), &silent()).unwrap();
    let seconds = 4.0;
    let solve = SolveOptions { time_limit: seconds, ..SolveOptions::default() };
    let start = Instant::now();
    let slow: Progress = Arc::new(move |_, event| {
        if let Event::Iteration(i) = event
            && i.gap < 5e-3
            && i.residual < 5e-4
        {
            let left = seconds - start.elapsed().as_secs_f64();
            std::thread::sleep(Duration::from_secs_f64(left.max(0.0) + 0.1));
        }
    });
    let options = PassOptions { solve, ..PassOptions::default() };
    let pass = limit::run(&model, &options, &slow).unwrap();
    let run = pass.statics.as_ref().unwrap();
    assert_eq!(run.status.words(), "almost optimal");
    assert!(run.iterations < whole.statics.as_ref().unwrap().iterations);
    let [cut, full] = [&pass, &whole].map(|p| p.lower.clone().unwrap());
    assert!(cut.is_strict() && cut.value() <= full.value() * (1.0 + 1e-3), "{cut:?} {full:?}");
    assert!(cut.value() > 0.98 * full.value(), "{cut:?} {full:?}");
}
