//! Runs a pass of limit analysis and checks what must hold for every pass.

use super::yielding::FY;
use bracket::analysis::event::silent;
use bracket::analysis::limit;
use bracket::analysis::limit::LimitPass;
use bracket::analysis::pass::PassOptions;
use bracket::certify::limit_certificate::{certify_lower, certify_upper};
use bracket::model::AnalysisModel;
use bracket::solve::{SolveOptions, StopRules};

pub fn run(model: &AnalysisModel) -> LimitPass {
    limit::run(model, &PassOptions::default(), &silent()).unwrap()
}

/// Maximum number of iterations of a program of limit analysis, hard cases included.
pub const MOST_ITERATIONS: u32 = 60;

/// Both bounds over the yield strength. Checks that they are strict and in order, and that the
/// stored fields alone prove them.
pub fn factors(name: &str, model: &AnalysisModel) -> [f64; 2] {
    factors_of(name, model, &run(model))
}

/// The same bounds from a solver with a smaller gap than the default.
pub fn sharp_factors(name: &str, model: &AnalysisModel) -> [f64; 2] {
    let solve = SolveOptions::default().with(StopRules::to_limit_gap(1e-7));
    let options = PassOptions { solve, ..PassOptions::default() };
    factors_of(name, model, &limit::run(model, &options, &silent()).unwrap())
}

/// The same for a pass that has already run.
pub fn factors_of(name: &str, model: &AnalysisModel, pass: &LimitPass) -> [f64; 2] {
    for (program, r) in pass.runs() {
        assert!(
            r.iterations <= MOST_ITERATIONS,
            "{name} {}: {} iterations",
            program.name(),
            r.iterations
        );
    }
    strict(name, model, pass)
}

/// The same without a limit on the iterations.
pub fn strict(name: &str, model: &AnalysisModel, pass: &LimitPass) -> [f64; 2] {
    for (program, r) in pass.runs() {
        assert!(
            r.status.is_solution(),
            "{name} {}: {}, {:?}",
            program.name(),
            r.status.words(),
            r.trouble
        );
        assert_eq!(r.trouble, None, "{name}");
    }
    let bracket = pass.bracket.as_ref().unwrap();
    assert!(bracket.is_strict(), "{name}: {bracket:?}");
    let [low, up] = [bracket.lower().value(), bracket.upper().value()];
    let iterations: Vec<u32> = pass.runs().map(|(_, r)| r.iterations).collect();
    println!(
        "{name}: [{:.8}, {:.8}], gap {:.2e}, iterations {iterations:?}",
        low / FY,
        up / FY,
        bracket.gap()
    );
    assert!(low <= up, "{name}");
    // certifies again from the stored fields alone
    let again =
        certify_lower(model, pass.stress.as_ref().unwrap(), bracket.lower().certificate().factor);
    assert!(
        again.utilisation <= 1.0 && again.equilibrium < 1e-9 && again.traction_jump < 1e-9,
        "{name}: {again:?}"
    );
    let again = certify_upper(model, pass.velocity.as_ref().unwrap(), 1);
    assert!(
        (again.factor - bracket.upper().certificate().factor).abs() <= 1e-12 * up.abs(),
        "{name}: {again:?}"
    );
    [low / FY, up / FY]
}
