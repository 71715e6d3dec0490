//! Elastic, perfectly plastic programs with von Mises cones in every element: a block and a plate.
//!
//! `cargo bench --bench yielding -- [block|plate] [plain|split|static]
//! [clarabel|condensed|factor|build] [CELLS] [FACTOR]`
//!
//! CELLS is the number of cells along a side of the block or plate. FACTOR multiplies the load.
//! `build` only builds the programs. `factor` only factors and solves once. Prints one row for
//! each: tets, shared and own unknowns, cones, seconds to build, status, iterations, seconds to
//! solve, objective \[N mm\], share of the elements that yield.
#![allow(missing_docs, clippy::unwrap_used)]

#[path = "../tests/common/mod.rs"]
mod common;

use bracket::solve::{SolveOptions, Solver, prepare};
use common::yielding::{FORMS, Form, block, plate};
use std::time::Instant;

fn main() {
    let words: Vec<String> = std::env::args().skip(1).filter(|a| !a.starts_with("--")).collect();
    let has = |w: &str| words.iter().any(|a| a == w);
    let any = |all: &[&str]| all.iter().any(|w| has(w));
    let numbers: Vec<f64> = words.iter().filter_map(|w| w.parse().ok()).collect();
    let factor = numbers.get(1).copied().unwrap_or(1.0);
    let solver = if any(&["condensed", "factor"]) { Solver::Condensed } else { Solver::Clarabel };
    println!(
        "case form tets shared own cones build_s | status iterations solve_s objective yielding"
    );
    for case in ["block", "plate"].into_iter().filter(|c| has(c) || !any(&["block", "plate"])) {
        let cells = numbers.first().map(|n| *n as usize);
        let model = match case {
            "block" => block(cells.unwrap_or(4), factor),
            _ => plate(cells.unwrap_or(8), factor),
        };
        for form in FORMS {
            let name = match form {
                Form::Plain => "plain",
                Form::Split => "split",
                Form::Static => "static",
            };
            if any(&["plain", "split", "static"]) && !has(name) {
                continue;
            }
            let start = Instant::now();
            let built = form.build(&model);
            let build = start.elapsed().as_secs_f64();
            let shared = built.block.len();
            print!(
                "{case} {name} {} {shared} {} ",
                model.mesh.tets.len(),
                built.program.unknowns() - shared
            );
            print!("{} {build:.2} | ", built.program.cones.len());
            if has("build") {
                println!("not solved");
                continue;
            }
            let options = SolveOptions { solver, ..SolveOptions::default() };
            let mut prepared = prepare(&built.program, &built.block, &options);
            let unit = prepared.yardstick();
            if let (Some(u), Some(f)) = (&unit, prepared.forecast()) {
                let (entries, flops) = (f.factor_entries as f64 / 1e6, f.factor_flops / 1e9);
                print!(
                    "{entries:.1} M entries, {flops:.1} GFLOP, factor {:.3} solve {:.3} | ",
                    u.factor, u.solve
                );
            }
            if has("factor") {
                println!("not solved");
                continue;
            }
            let start = Instant::now();
            let s = prepared.solve(&options);
            let seconds = start.elapsed().as_secs_f64();
            let objective = built.program.objective(&s.x, &s.z);
            let yielding = built.flowing(&model, &s);
            print!(
                "{} {} {seconds:.2} {objective:.9e} {yielding:.3}",
                s.status.words(),
                s.iterations
            );
            if let Some(u) = unit {
                let y = seconds / (f64::from(s.iterations) * (u.factor + 2.0 * u.solve));
                print!(" | Y {y:.2}");
            }
            println!(" | {} MiB", bracket::analysis::memory::peak_memory_mib().unwrap_or(0));
        }
    }
}
