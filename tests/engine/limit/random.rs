//! Random small assemblies: no result is a wrong number.

use crate::common::limit::run;
use crate::common::yielding::{FY, MATERIALS};
use crate::common::{Block, solved};
use bracket::elements::hencky_kinematic::Flow;
use bracket::model::AnalysisModel;
use bracket::programs::{Kinematic, Static};
use bracket::solve::{Patterns, SolveOptions, StopRules, clarabel, condensed};
use std::collections::BTreeMap;

struct Random(u64);

impl Random {
    fn next(&mut self) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 11) as f64 / (1u64 << 53) as f64
    }

    fn among(&mut self, least: usize, most: usize) -> usize {
        least + (self.next() * (most - least + 1) as f64) as usize
    }

    fn between(&mut self, a: f64, b: f64) -> f64 {
        a + (b - a) * self.next()
    }
}

/// Two stacked blocks, tied or in contact, clamped or guided at the foot, under a traction at the
/// top and sometimes a dead pressure. `None` if a part is loose.
pub fn assembly(seed: u64) -> Option<AnalysisModel> {
    assembly_on(seed, [0; 3])
}

/// The same on another mesh, with so many `more` cells in each direction, an even number in the
/// third.
pub fn assembly_on(seed: u64, more: [usize; 3]) -> Option<AnalysisModel> {
    let mut r = Random(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) | 1);
    (0..8).for_each(|_| _ = r.next());
    let size = [r.between(5.0, 40.0), r.between(5.0, 40.0), r.between(10.0, 60.0)];
    let cells = [r.among(1, 2), r.among(1, 2), 2 * r.among(1, 2)];
    let cells = std::array::from_fn(|d| cells[d] + more[d]);
    let middle = 0.5 * size[2];
    let shape = Block { cells, min: [0.0; 3], max: size, jitter: 0.2, seed };
    let mesh = shape.mesh(
        &["A", "B"],
        |c| usize::from(c[2] > middle),
        |d, x| d == 2 && (x - middle).abs() < 1e-9,
    );
    let interface = match r.among(0, 3) {
        0 => String::new(),
        1 => "interfaces:\n- {between: [A, B], law: contact, mu: 0, gap: 0.1}\n".into(),
        _ => {
            let (mu, gap) = (r.between(0.01, 1.5), if r.next() < 0.3 { 0.05 } else { 0.0 });
            format!(
                "interfaces:\n- {{between: [A, B], law: contact, mu: {mu:?}, gap: {gap:?}, \
                 friction: associated}}\n"
            )
        }
    };
    let foot = if r.next() < 0.7 { "[x, y, z]" } else { "[z]" };
    let guide = if r.next() < 0.3 || foot == "[z]" {
        "- {face: X0, fix: [x]}\n- {face: Y0, fix: [y]}\n"
    } else {
        ""
    };
    let t: [f64; 3] = [r.between(-1.0, 1.0), r.between(-1.0, 1.0), r.between(-2.0, 0.3)];
    let dead = match r.next() < 0.4 {
        true => {
            format!("dead:\n- {{face: Z1, traction: [0, 0, {:?}]}}\n", -r.between(0.01, 0.4) * FY)
        }
        false => String::new(),
    };
    let yaml = format!(
        "{MATERIALS}bodies: {{A: s, B: s}}\n{interface}supports:\n- {{face: Z0, fix: \
         {foot}}}\n{guide}loads:\n- {{face: Z1, traction: {t:?}}}\n{dead}"
    );
    // an upper block without support is refused, and the message names it
    match solved::resolve_as("limit", &yaml, mesh) {
        Ok(model) => Some(model),
        Err(e) => {
            assert!(e.iter().all(|d| d.code == "model/loose-part"), "seed {seed}: {e:?}");
            None
        }
    }
}

/// Every bracket is in order and strict. If Clarabel converges, it finds the same load factor.
fn assemblies(seeds: std::ops::Range<u64>) {
    let mut ends: BTreeMap<String, usize> = BTreeMap::new();
    let (mut brackets, mut compared, mut differ, mut failed) = (0, 0, Vec::new(), Vec::new());
    for seed in seeds.clone() {
        let Some(m) = assembly(seed) else {
            *ends.entry("refused: a loose part".into()).or_default() += 1;
            continue;
        };
        let pass = run(&m);
        if pass.free.is_some() || pass.unlimited.is_some() {
            let end = if pass.free.is_some() { "a mechanism at zero load" } else { "no limit" };
            *ends.entry(format!("proved: {end}")).or_default() += 1;
            continue;
        }
        for (program, r) in pass.runs() {
            if !r.status.is_solution() || r.trouble.is_some() {
                failed.push(format!(
                    "seed {seed} {}: {} after {}, {:?}",
                    program.name(),
                    r.status.words(),
                    r.iterations,
                    r.trouble
                ));
            }
            let trouble = if r.trouble.is_some() { ", not certified" } else { "" };
            *ends
                .entry(format!("{}: {}{trouble}", program.name(), r.status.words()))
                .or_default() += 1;
        }
        if let Some(b) = &pass.bracket {
            assert!(b.lower().value() <= b.upper().value(), "seed {seed}");
            assert!(b.is_strict(), "seed {seed}: {b:?}");
            brackets += 1;
        }
        // only a sample, because Clarabel is slow
        if seed % 4 == 0 {
            let statics = Static::limit(&m).unwrap();
            let kinematic = Kinematic::limit(&m, Flow::Split).unwrap();
            let options = SolveOptions::default().with(StopRules::to_gap(1e-8));
            for (name, program, block) in [
                ("static", &statics.program, &statics.map.block),
                ("kinematic", &kinematic.program, &kinematic.map.block),
            ] {
                let ours = condensed::Prepared::new(program, block, &Patterns::default())
                    .unwrap()
                    .solve(&options);
                let theirs = clarabel::solve(program, &options);
                let both = [ours.status, theirs.status];
                if !both.iter().all(|s| s.is_solution()) {
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
    assert!(failed.is_empty(), "{failed:#?}");
    assert!(brackets * 2 > seeds.count(), "most assemblies have a limit load");
    assert!(compared > 0);
    assert!(differ.is_empty(), "{differ:#?}");
}

#[test]
fn random_assemblies() {
    assemblies(0..24);
}

#[test]
#[ignore = "heavy: minutes"]
fn two_hundred_random_assemblies() {
    assemblies(0..200);
}
