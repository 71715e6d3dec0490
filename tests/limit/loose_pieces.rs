//! Pieces that only contact holds, and contacts that carry no force: the lower bound is strict, or
//! the reason is true.

use crate::common::grid::name;
use crate::common::limit::run;
use crate::common::yielding::MATERIALS;
use crate::common::{Block, Random, beside, mapped, renamed, solved};
use bracket::analysis::elastic;
use bracket::analysis::event::silent;
use bracket::analysis::pass::PassOptions;
use bracket::certify::sampling::sample_lower;
use bracket::model::AnalysisModel;
use bracket::programs::Static;
use bracket::solve::{Patterns, SolveOptions, SolveStatus, condensed};

/// Six slices of a wall in plane strain, two rows of three, tied or in contact, between walls.
///
/// ```text
///      ↓
///   | D | E | F |
///   | A | B | C |
///   /////////////
/// ```
fn slices(kind: &str, seed: u64) -> Option<AnalysisModel> {
    let mut r = Random::new(seed + 7);
    (0..8).for_each(|_| _ = r.unit());
    let bodies = ["A", "B", "C", "D", "E", "F"];
    let mut mesh =
        Block { cells: [6, 1, 4], min: [0.0; 3], max: [12.0, 1.0, 8.0], jitter: 0.15, seed }.mesh(
            &bodies,
            |c| (c[0] / 4.0) as usize + 3 * ((c[2] / 4.0) as usize),
            |d, x| d != 1 && (x - 4.0 * (x / 4.0).round()).abs() < 1e-9,
        );
    let pairs = ["[A, B]", "[B, C]", "[D, E]", "[E, F]", "[A, D]", "[B, E]", "[C, F]"];
    let mut interfaces = String::new();
    for pair in pairs {
        match r.below(4) {
            0 => {}
            1 => interfaces.push_str(&format!(
                "- {{between: {pair}, law: contact, mu: 0.3, friction: associated}}\n"
            )),
            _ => interfaces.push_str(&format!("- {{between: {pair}, law: contact, mu: 0}}\n")),
        }
    }
    let mut wall = |face: &str, axis: &str, free: bool| match r.below(if free { 4 } else { 3 }) {
        0 => format!("- {{face: {face}, fix: [{axis}]}}\n"),
        1 => format!("- {{face: {face}, law: contact, mu: 0}}\n"),
        2 => format!("- {{face: {face}, law: contact, mu: 0.2, friction: associated}}\n"),
        _ => String::new(),
    };
    let walls =
        format!("{}{}{}", wall("X0", "x", true), wall("X1", "x", true), wall("Z0", "z", false));
    let loaded = bodies[3 + r.below(3)];
    let x0 = 4.0 * (bodies.iter().position(|b| *b == loaded).unwrap() - 3) as f64;
    let narrow = r.unit() < 0.5;
    let x1 = if narrow { x0 + 2.0 } else { x0 + 4.0 };
    name(&mut mesh, "LOADED", loaded, |p| p[2] == 8.0 && p[0] > x0 - 1e-9 && p[0] < x1 + 0.35);
    let shear = if r.unit() < 0.3 { 0.2 } else { 0.0 };
    let interfaces =
        if interfaces.is_empty() { interfaces } else { format!("interfaces:\n{interfaces}") };
    let dead = if r.unit() < 0.2 && kind == "limit" {
        "dead:\n- {face: LOADED, traction: [0, 0, -10]}\n"
    } else {
        ""
    };
    let all = bodies.map(|b| format!("{b}: s")).join(", ");
    let yaml = format!(
        "{MATERIALS}bodies: {{{all}}}\n{interfaces}supports:\n- {{face: Y0, fix: [y]}}\n- {{face: \
         Y1, fix: [y]}}\n{walls}loads:\n- {{face: LOADED, traction: [{shear:?}, 0, -1]}}\n{dead}"
    );
    match solved::resolve_as(kind, &yaml, mesh) {
        Ok(model) => Some(model),
        Err(e) => {
            assert!(e.iter().all(|d| d.code == "model/loose-part"), "seed {seed}: {e:?}");
            None
        }
    }
}

/// Loads that the static program itself finds, before its solution is made admissible.
fn found(m: &AnalysisModel) -> f64 {
    let statics = Static::limit(m).unwrap();
    let prepared =
        condensed::Prepared::new(&statics.program, &statics.map.block, &Patterns::default());
    let solution = prepared.unwrap().solve(&SolveOptions::default().for_resistance());
    assert_eq!(solution.status, SolveStatus::Optimal);
    *solution.x.last().unwrap()
}

/// Every optimal static program gives a strict lower bound, which random points confirm, and which
/// is as large as the load that the program found.
fn bounds_are_recovered(seeds: std::ops::Range<u64>) {
    let (mut brackets, mut smooth, mut compared) = (0, 0, 0);
    for seed in seeds {
        let Some(m) = slices("limit", seed) else { continue };
        let pass = run(&m);
        if pass.free.is_some() || pass.unlimited.is_some() {
            continue;
        }
        let runs = pass.runs().map(|(_, r)| r).chain(&pass.frictionless_run);
        for r in runs {
            assert_eq!(r.status, SolveStatus::Optimal, "seed {seed}");
            assert_eq!(r.trouble, None, "seed {seed}");
        }
        let b = pass.bracket.as_ref().unwrap();
        let low = b.lower().value();
        println!("seed {seed}: [{low:.6}, {:.6}]", b.upper().value());
        assert!(b.is_strict(), "seed {seed}: {b:?}");
        let factor = b.lower().certificate().factor;
        let s = sample_lower(&m, pass.stress.as_ref().unwrap(), factor, 300);
        assert!(
            s.utilisation <= 1.0 && s.traction_jump < 1e-9 && s.traction_cone < 1e-9,
            "seed {seed}: {s:?}"
        );
        brackets += 1;
        if let Some(l) = &pass.frictionless {
            assert!(l.is_strict() && l.value() <= b.upper().value(), "seed {seed}: {l:?}");
            // friction adds admissible forces
            assert!(l.value() <= low * (1.0 + 1e-3), "seed {seed}: {} above {low}", l.value());
            smooth += 1;
        }
        if seed % 3 == 0 {
            let found = found(&m);
            assert!(low > (1.0 - 1e-3) * found, "seed {seed}: {low} of {found}");
            compared += 1;
        }
    }
    println!("{brackets} strict brackets, {smooth} bounds without friction, {compared} compared");
    assert!(brackets > 10 && smooth > 5 && compared > 3);
}

#[test]
fn slices_held_by_contact() {
    bounds_are_recovered(0..24);
}

#[test]
#[ignore = "heavy: minutes"]
fn many_slices_held_by_contact() {
    bounds_are_recovered(0..240);
}

/// The same slices in elastic analysis.
#[test]
fn elastic_slices_held_by_contact() {
    let mut brackets = 0;
    for seed in 0..16 {
        let Some(m) = slices("elastic", seed) else { continue };
        let pass = elastic::run(&m, &PassOptions::default(), &silent()).unwrap();
        for (_, r) in pass.runs() {
            let ends = [SolveStatus::Optimal, SolveStatus::Unbounded];
            assert!(ends.contains(&r.status), "seed {seed}: {:?}", r.status);
            assert_eq!(r.trouble, None, "seed {seed}");
        }
        let Some(b) = &pass.bracket else { continue };
        println!("seed {seed}: [{:.6}, {:.6}]", b.lower().value(), b.upper().value());
        assert!(b.is_strict(), "seed {seed}: {b:?}");
        brackets += 1;
    }
    println!("{brackets} strict brackets");
    assert!(brackets >= 8);
}

/// A block on frictionless ground without load, beside one that is pressed on the ground: the
/// contact that carries nothing does not cost the bound.
#[test]
fn contact_that_carries_nothing() {
    let idle = Block::new([2, 2, 2], [10.0; 3]).jittered(4).mesh(&["IDLE"], |_| 0, |_, _| false);
    let busy = Block::new([2, 2, 2], [10.0; 3]).jittered(6).mesh(&["BUSY"], |_| 0, |_, _| false);
    let busy = mapped(renamed(busy, "Z1", "TOP"), |x| [x[0] + 20.0, x[1], x[2]]);
    for (pressure, mu) in [(100.0, "mu: 0"), (0.0, "mu: 0"), (0.0, "mu: 0.3, friction: associated")]
    {
        let yaml = format!(
            "materials: {{s: {{E: 210000, nu: 0.3}}}}\nbodies: {{IDLE: s, BUSY: s}}\nsupports:\n- \
             {{face: Z0, law: contact, {mu}}}\nloads:\n- {{face: TOP, pressure: {pressure:?}}}\n"
        );
        let mesh = beside(idle.clone(), busy.clone());
        let solved = solved::solve(&yaml, mesh);
        let [low, up] = solved.strict(&format!("pressure {pressure}, {mu}"));
        // −½ p² V/E
        let exact = -0.5 * pressure * pressure * 1000.0 / 210_000.0;
        assert!((low - exact).abs() < 1e-6 && (up - exact).abs() < 1e-6, "[{low}, {up}]");
    }
}
