//! Random stacks of three blocks that yield or are rigid and are tied, welded or in contact: no
//! result is a wrong number.

use crate::common::limit::run;
use crate::common::yielding::MATERIALS;
use crate::common::{Block, Random, solved};
use bracket::certify::sampling::{sample_lower, sample_upper};
use bracket::elements::hencky_kinematic::Flow;
use bracket::model::AnalysisModel;
use bracket::programs::{Kinematic, Static};
use bracket::solve::{Patterns, SolveOptions, SolveStatus, StopRules, clarabel, condensed};
use std::collections::BTreeMap;

/// A random stack. `None` if the model is refused because a part is loose or nothing can yield.
fn stack(seed: u64) -> Option<AnalysisModel> {
    let mut r = Random::new(seed + 100);
    (0..8).for_each(|_| _ = r.unit());
    let mut between = |a: f64, b: f64| a + (b - a) * r.unit();
    // multiples of 0.25 mm, so that the faces are found at the exact planes of the grid
    let third = 0.25 * (4.0 * between(5.0, 20.0)).round();
    let size = [between(5.0, 40.0), between(5.0, 40.0), 3.0 * third];
    let shape = Block { cells: [2, 1, 3], min: [0.0; 3], max: size, jitter: 0.2, seed };
    let level = |x: f64| (x / third).round() * third;
    let mesh = shape.mesh(
        &["A", "B", "C"],
        |c| ((c[2] / third) as usize).min(2),
        |d, x| d == 2 && (x - level(x)).abs() < 1e-9,
    );
    let mut interface = |pair: &str| match between(0.0, 3.0) as usize {
        0 => String::new(),
        1 => format!(
            "- {{between: {pair}, law: weld, strength_traction: {:?}}}\n",
            between(20.0, 300.0)
        ),
        _ => format!(
            "- {{between: {pair}, law: contact, mu: {:?}, friction: associated}}\n",
            between(0.05, 1.0)
        ),
    };
    let joints = format!("{}{}", interface("[A, B]"), interface("[C, B]"));
    let joints = if joints.is_empty() { joints } else { format!("interfaces:\n{joints}") };
    let material = |x: f64| if x < 0.4 { "r" } else { "s" };
    let bodies = [0, 1, 2].map(|_| material(between(0.0, 1.0)));
    let t: [f64; 3] = [between(-1.0, 1.0), between(-1.0, 1.0), between(-2.0, 0.3)];
    let load = if between(0.0, 1.0) < 0.3 {
        let middle = [0.5 * size[0], 0.5 * size[1], size[2]];
        format!(
            "rigid:\n- {{face: Z1, components: [x, y, z], free: [ux, uy, uz, rx, ry, rz], at: \
             {middle:?}, force: {t:?}}}\n"
        )
    } else {
        format!("loads:\n- {{face: Z1, traction: {t:?}}}\n")
    };
    let dead = match between(0.0, 1.0) < 0.4 {
        true => format!("dead:\n- {{face: Z1, traction: [0, 0, {:?}]}}\n", -between(1.0, 15.0)),
        false => String::new(),
    };
    let [a, b, c] = bodies;
    let yaml = format!(
        "{MATERIALS}bodies: {{A: {a}, B: {b}, C: {c}}}\n{joints}supports:\n- {{face: Z0, fix: [x, \
         y, z]}}\n{load}{dead}"
    );
    match solved::resolve_as("limit", &yaml, mesh) {
        Ok(model) => Some(model),
        Err(e) => {
            let known = ["model/loose-part", "model/never-yields"];
            assert!(e.iter().all(|d| known.contains(&d.code)), "seed {seed}: {e:?}");
            None
        }
    }
}

fn stacks(seeds: std::ops::Range<u64>) {
    let mut ends: BTreeMap<String, usize> = BTreeMap::new();
    let (mut brackets, mut compared, mut differ) = (0, 0, Vec::new());
    for seed in seeds.clone() {
        let Some(m) = stack(seed) else {
            *ends.entry("refused".into()).or_default() += 1;
            continue;
        };
        if Static::limit(&m).is_err() {
            // tied rigid blocks down to the support: they hold the load
            *ends.entry("load held".into()).or_default() += 1;
            continue;
        }
        let pass = run(&m);
        if pass.free.is_some() || pass.unlimited.is_some() {
            // a general solver finds a load factor of zero only to its tolerance
            let end = if pass.free.is_some() { "a mechanism at zero load" } else { "no limit" };
            *ends.entry(format!("proved: {end}")).or_default() += 1;
            continue;
        }
        for (program, r) in pass.runs() {
            let trouble = if r.trouble.is_some() { ", not certified" } else { "" };
            *ends
                .entry(format!("{}: {}{trouble}", program.name(), r.status.words()))
                .or_default() += 1;
        }
        if let Some(b) = &pass.bracket {
            let [low, up] = [b.lower().value(), b.upper().value()];
            println!("seed {seed}: [{low:.6}, {up:.6}]");
            assert!(low <= up, "seed {seed}");
            assert!(b.is_strict(), "seed {seed}: {b:?}");
            let s = sample_lower(
                &m,
                pass.stress.as_ref().unwrap(),
                b.lower().certificate().factor,
                500,
            );
            assert!(
                s.utilisation <= 1.0 && s.traction_jump < 1e-9 && s.traction_cone < 1e-9,
                "seed {seed}: {s:?}"
            );
            let s = sample_upper(&m, pass.velocity.as_ref().unwrap(), 500);
            assert!(s.strain < 1e-9 && s.gap_cone < 1e-9, "seed {seed}: {s:?}");
            brackets += 1;
        }
        if seed % 4 == 0 {
            let statics = Static::limit(&m).unwrap();
            let kinematic = Kinematic::limit(&m, Flow::Split).unwrap();
            let options = SolveOptions::default().with(StopRules::to_gap(1e-7));
            for (name, program, block) in [
                ("static", &statics.program, &statics.map.block),
                ("kinematic", &kinematic.program, &kinematic.map.block),
            ] {
                let ours = condensed::Prepared::new(program, block, &Patterns::default())
                    .unwrap()
                    .solve(&options);
                let theirs = clarabel::solve(program, &options);
                let both = [ours.status, theirs.status];
                // an almost optimal factor of Clarabel measures nothing
                if !ours.status.is_solution() || theirs.status != SolveStatus::Optimal {
                    println!("seed {seed} {name}: {both:?}");
                    continue;
                }
                let [ours, theirs] = [ours, theirs].map(|s| s.x.last().copied().unwrap());
                if (ours - theirs).abs() > 1e-5 * theirs.abs().max(0.01) {
                    differ.push(format!("seed {seed} {name}: {ours} {theirs}"));
                }
                compared += 1;
            }
        }
    }
    println!("{ends:?}; {brackets} strict brackets, {compared} factors compared with Clarabel");
    assert!(brackets * 2 > seeds.count(), "most stacks have a limit load");
    assert!(compared > 0);
    assert!(differ.is_empty(), "{differ:#?}");
}

#[test]
fn random_stacks() {
    stacks(0..24);
}

#[test]
#[ignore = "heavy: minutes"]
fn two_hundred_random_stacks() {
    stacks(0..200);
}
