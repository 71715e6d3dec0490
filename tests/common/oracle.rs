//! Clarabel as the oracle for the condensed method: both solve the same program.

use bracket::programs::conic::ConicProgram;
use bracket::solve::status::Iterations;
use bracket::solve::{Iteration, Patterns, Solution, SolveOptions, clarabel, condensed};
use std::sync::{Arc, Mutex};

/// Maximum number of iterations of an elastic or elastoplastic program, hard cases included.
pub const MOST_ITERATIONS: u32 = 40;

/// Solves with both methods, without fallback from one to the other. Both solutions must be optimal
/// and their objectives must agree to 1e-6. Returns the solution of the condensed method.
pub fn agree(name: &str, program: &ConicProgram, block: &[u32]) -> Solution {
    let trace: Arc<Mutex<Vec<Iteration>>> = Arc::default();
    let kept = trace.clone();
    let progress: Iterations = Arc::new(move |i| kept.lock().unwrap().push(*i));
    let options = SolveOptions { progress: Some(progress), ..SolveOptions::default() };
    let prepared = condensed::Prepared::new(program, block, &Patterns::default())
        .unwrap_or_else(|e| panic!("{name}: {e}"));
    let ours = prepared.solve(&options);
    assert!(ours.status.is_solution(), "{name}: {:#?}", trace.lock().unwrap());
    let options = SolveOptions::default();
    assert!(ours.iterations <= MOST_ITERATIONS, "{name}: {} iterations", ours.iterations);
    let theirs = clarabel::solve(program, &options);
    assert!(theirs.status.is_solution(), "{name}: Clarabel");
    let [a, b] = [&ours, &theirs].map(|s| program.objective(&s.x, &s.z) - program.c);
    println!(
        "{name}: {a:.9e} in {} iterations, Clarabel {b:.9e} in {}",
        ours.iterations, theirs.iterations
    );
    // without loads or gaps to close, both objectives are zero up to rounding
    assert!((a - b).abs() <= 1e-6 * b.abs() + 1e-14, "{name}: {a:.9e} against {b:.9e}");
    ours
}
