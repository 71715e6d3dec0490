//! Measures how many specs the hand checks judge per second on one core, with and without reading
//! the spec.
//!
//! `cargo bench --bench checks`

use bracket::assembly::{EndPlate, Facts};
use bracket::catalog::Catalog;
use bracket::checks::design_code;
use bracket::checks::end_plate::moment_axial;
use bracket::checks::{Analysed, hand_checks, judge};
use bracket::spec::connection::ConnectionSpec;
use bracket::yaml;
use std::hint::black_box;
use std::path::Path;
use std::time::{Duration, Instant};

const EXAMPLES: [&str; 5] = [
    "one_sided_unstiffened",
    "one_sided_stiffened",
    "double_sided",
    "splice_flush",
    "splice_extended",
];

/// Seconds per call: the smallest mean of five batches of 0.2 s each.
fn seconds(mut call: impl FnMut()) -> f64 {
    let mut least = f64::INFINITY;
    for _ in 0..5 {
        let (start, mut count) = (Instant::now(), 0);
        while start.elapsed() < Duration::from_millis(200) {
            call();
            count += 1;
        }
        least = least.min(start.elapsed().as_secs_f64() / f64::from(count));
    }
    least
}

fn main() {
    let catalog = Catalog::builtin().expect("the shipped catalogue is sound");
    println!(
        "| example | checks and verdict, 1/s | beside N > 5 % N_pl, 1/s | spec read and built, \
         1/s | M-N diagram, ms |"
    );
    println!("| --- | ---: | ---: | ---: | ---: |");
    for name in EXAMPLES {
        let path = format!("{}/examples/{name}/joint.yaml", env!("CARGO_MANIFEST_DIR"));
        let text = std::fs::read_to_string(&path).expect("the example is there");
        let build = |text: &str| {
            let spec =
                yaml::parse::<ConnectionSpec>(text, Path::new("joint.yaml")).expect("a spec");
            let joint = design_code::build(&spec, Path::new(""), &catalog).expect("a joint");
            let Some(Facts::EndPlate(e)) = joint.facts else { panic!("with hand checks") };
            e
        };
        let judged = |e: &EndPlate| {
            let mut checks = hand_checks(black_box(e));
            let case = e.actions.first().map_or_else(String::new, |a| a.case.clone());
            black_box(judge(&mut checks, &[Analysed::not(case)]));
        };
        let plain = build(&text);
        let mut pulled = plain.clone();
        for a in &mut pulled.actions {
            a.live[0][0] = 0.1 * 1e2 * pulled.beam.area * pulled.beam_steel.fy.mpa();
        }
        println!(
            "| {name} | {:.0} | {:.0} | {:.0} | {:.1} |",
            1.0 / seconds(|| judged(&plain)),
            1.0 / seconds(|| judged(&pulled)),
            1.0 / seconds(|| drop(black_box(build(&text)))),
            1e3 * seconds(|| drop(black_box(moment_axial(&plain)))),
        );
    }
}
