//! Limits on the resultants of cuts: interaction of tension and shear as in EN 1993-1-8 Table 3.4,
//! differences of two cuts, half models, and random sets of limits.

use crate::common::limit::{run, sharp_factors};
use crate::common::oracle;
use crate::common::yielding::{FY, MATERIALS};
use crate::common::{Block, Random, solved, triangles_where};
use bracket::certify::UpperFactor;
use bracket::certify::limit_certificate::{certify_lower, certify_upper};
use bracket::certify::unlimited::certify_unlimited;
use bracket::certify::{StressField, cut_limits};
use bracket::diag::Diagnostics;
use bracket::elements::hencky_kinematic::Flow;
use bracket::mesh::{NamedFaces, TetMesh};
use bracket::model::AnalysisModel;
use bracket::programs::Kinematic;
use bracket::recover::draw_inside::draw_inside;
use std::f64::consts::PI;

/// Tension and shear resistance of the bolt \[N\], and the factor of Table 3.4.
const TENSION: f64 = 5e3;
const SHEAR: f64 = 4e3;
const KAPPA: f64 = SHEAR / (1.4 * TENSION);

/// A bar of 10 x 10 mm along x, from x = 0 to 40 mm, in bodies of 10 mm: `A`, `S`, `B` and `C`,
/// with cuts at the given positions, named `CUT` and the number of millimetres.
fn bar(cuts: &[f64], seed: u64, depth: usize) -> TetMesh {
    let shape =
        Block { cells: [8, depth, 2], min: [0.0; 3], max: [40.0, 10.0, 10.0], jitter: 0.2, seed };
    let at = |x: f64, y: f64| (x - y).abs() < 1e-9;
    let flat = |d: usize, x: f64| d == 0 && cuts.iter().any(|c| at(x, *c));
    let mut mesh = shape.mesh(
        &["A", "S", "B", "C"],
        |c| (c[0] / 10.0) as usize,
        |d, x| {
            flat(d, x)
                || (d == 0 && (at(x, 10.0) || at(x, 20.0) || at(x, 30.0)))
                || (d == 1 && at(x, 5.0))
        },
    );
    for c in cuts {
        let triangles = triangles_where(&mesh, |x| at(x[0], *c));
        mesh.faces.push(NamedFaces { name: format!("CUT{c}"), triangles });
    }
    mesh
}

fn entries(cuts: &[f64]) -> String {
    let body = |c: f64| ["A", "S", "B", "C"][(c / 10.0) as usize];
    let entry = |c: &f64| format!("- {{body: {}, cut: CUT{c}, axis: [1, 0, 0]}}\n", body(*c));
    format!("cuts:\n{}", cuts.iter().map(entry).collect::<String>())
}

fn resolved(text: &str, mesh: TetMesh) -> Result<AnalysisModel, Diagnostics> {
    solved::resolve_as("limit", &format!("{MATERIALS}{text}"), mesh)
}

/// The model of limit analysis of a YAML text without its materials.
pub fn model(text: &str, mesh: TetMesh) -> AnalysisModel {
    resolved(text, mesh).unwrap_or_else(|e| panic!("{e:?}"))
}

/// The three limits of a bolt in the cut at x = 15 mm; `share` is the part of the bolt that is
/// meshed, `across` the components of the shear.
fn bolt(share: f64, across: &str) -> String {
    let [tension, shear] = [share * TENSION, share * SHEAR];
    format!(
        "resultant_limits:\n- {{name: tension, cuts: [CUT15], along: [1, 0, 0], at_most: \
         {tension:?}}}\n- {{name: shear, cuts: [CUT15], across: {across}, at_most: {shear:?}}}\n- \
         {{name: both, cuts: [CUT15], along: [{KAPPA:?}, 0, 0], across: {across}, at_most: \
         {shear:?}}}\n"
    )
}

/// The bolt: rigid plates `A` and `B`, a shank `S` between them, a force of 1 N in the direction
/// `angle` from the axis, turned by `turn` in the plane of the cut. No plate rotates.
fn pulled(angle: f64, turn: f64, seed: u64) -> AnalysisModel {
    let force = [angle.cos(), angle.sin() * turn.cos(), angle.sin() * turn.sin()];
    let text = format!(
        "bodies: {{A: r, S: s, B: r, C: r}}\nsupports:\n- {{face: X0, fix: [x, y, z]}}\nrigid:\n- \
         {{face: X1, components: [x, y, z], free: [ux, uy, uz], at: [40, 5, 5], force: \
         {force:?}}}\n{}{}",
        entries(&[15.0]),
        bolt(1.0, "[[0, 1, 0], [0, 0, 1]]")
    );
    model(&text, bar(&[15.0], seed, 2))
}

/// Table 3.4: `V ≤ F_v (1 − N/(1.4 F_t))` and `N ≤ F_t`; compression takes nothing from the shear.
fn table_3_4(angle: f64) -> f64 {
    let (n, v) = (angle.cos(), angle.sin());
    let tension = if n > 0.0 { TENSION / n } else { f64::INFINITY };
    let shear = if v > 0.0 { SHEAR / v } else { f64::INFINITY };
    let both = SHEAR / (v + KAPPA * n).max(1e-300);
    tension.min(shear).min(both)
}

#[test]
fn tension_and_shear_at_eleven_ratios() {
    for (i, turn) in
        [0.0, 0.4, 1.1, 2.0, -0.7, 3.0, 1.5, 0.9, -2.0, 0.2, 2.6].into_iter().enumerate()
    {
        let angle = (i as f64 / 8.0).min(1.2) * PI / 2.0;
        let want = table_3_4(angle);
        let name = format!("{:.0} degrees from the axis", angle.to_degrees());
        let [low, up] = sharp_factors(&name, &pulled(angle, turn, i as u64 + 1)).map(|x| x * FY);
        assert!(
            low <= want * (1.0 + 1e-9) && up >= want * (1.0 - 1e-9),
            "{name}: [{low}, {up}], {want}"
        );
        assert!(
            (low / want - 1.0).abs() < 1e-6 && (up / want - 1.0).abs() < 1e-6,
            "{name}: [{low}, {up}], {want}"
        );
    }
}

/// Pure compression is not limited by the cut: the shank yields.
#[test]
fn compression_is_carried_by_the_shank() {
    let [low, up] = sharp_factors("compression", &pulled(PI, 0.0, 3)).map(|x| x * FY);
    // the rigid plates hold the ends of a short cube: at least f_y times its area
    assert!(low > 100.0 * FY && up < 2.0 * 100.0 * FY, "[{low}, {up}]");
}

/// Bearing: a force on the middle of a bar that two cuts pass is the difference of their
/// resultants. It is limited by its own number, with another one for the opposite direction.
#[test]
fn a_force_between_two_cuts() {
    let with = |load: f64, extra: &str| {
        let text = format!(
            "bodies: {{A: r, S: s, B: s, C: r}}\nsupports:\n- {{face: X0, fix: [x, y, z]}}\n- \
             {{face: X1, fix: [x, y, z]}}\nloads:\n- {{face: MIDDLE, traction: [0, {load:?}, \
             0]}}\n{}resultant_limits:\n- {{name: up, cuts: [CUT15], minus: [CUT25], along: [0, 1, \
             0], at_most: 900}}\n- {{name: down, cuts: [CUT15], minus: [CUT25], along: [0, -1, 0], \
             at_most: 700}}\n{extra}",
            entries(&[15.0, 25.0])
        );
        let mut mesh = bar(&[15.0, 25.0], 7, 2);
        let on = |x: [f64; 3]| x[1] == 10.0 && x[0] > 14.9 && x[0] < 25.1;
        mesh.faces
            .push(NamedFaces { name: "MIDDLE".into(), triangles: triangles_where(&mesh, on) });
        model(&text, mesh)
    };
    // 100 mm² at 1 MPa
    for (load, extra, want) in [
        (1.0, "", 9.0),
        (-1.0, "", 7.0),
        // a weaker shear plane on one side: its force and what the other side still carries
        (1.0, "- {name: plane, cuts: [CUT15], across: [[0, 1, 0]], at_most: 100}\n", 9.0),
        (
            1.0,
            "- {name: plane, cuts: [CUT15], across: [[0, 1, 0]], at_most: 100}\n- {name: other, \
             cuts: [CUT25], across: [[0, 1, 0]], at_most: 250}\n",
            3.5,
        ),
    ] {
        let name = format!("{load} MPa{extra}");
        let [low, up] = sharp_factors(&name, &with(load, extra)).map(|x| x * FY);
        // the bodies between the cuts move without strain up to the tolerance of the solver, and
        // what is left dissipates
        assert!(
            (low / want - 1.0).abs() < 1e-6 && (up / want - 1.0).abs() < 2e-5,
            "{name}: [{low}, {up}], {want}"
        );
    }
}

/// Half of the bolt with half of its resistances has the same factor under half of the force.
#[test]
fn half_a_bolt_is_the_whole_one() {
    let half = |angle: f64| {
        // the plane y = 0 halves the bolt; the force has no component across it
        let force = [0.5 * angle.cos(), 0.0, 0.5 * angle.sin()];
        let text = format!(
            "bodies: {{A: r, S: s, B: r, C: r}}\nsymmetry: 2\nsupports:\n- {{face: X0, fix: [x, y, \
             z]}}\n- {{face: Y0, fix: [y]}}\nrigid:\n- {{face: X1, components: [x, z], free: [ux, \
             uz], at: [40, 0, 5], force: {force:?}}}\n{}{}",
            entries(&[15.0]),
            bolt(0.5, "[[0, 0, 1]]")
        );
        let mut mesh = bar(&[15.0], 2, 2);
        mesh.nodes.iter_mut().for_each(|x| x[1] *= 0.5);
        model(&text, mesh)
    };
    for angle in [0.3, 1.0, 1.5] {
        let [low, up] = sharp_factors("half", &half(angle)).map(|x| x * FY);
        let want = table_3_4(angle);
        assert!(
            (low / want - 1.0).abs() < 1e-6 && (up / want - 1.0).abs() < 1e-6,
            "[{low}, {up}], {want}"
        );
    }
}

/// A bent and sheared cantilever with random limits in two cuts, under a random force.
fn random(seed: u64) -> AnalysisModel {
    let mut r = Random::new(seed);
    let mut unit = || 2.0 * r.unit() - 1.0;
    let mut limits = String::new();
    for i in 0..5 {
        let row = |u: &mut dyn FnMut() -> f64| format!("[{:?}, {:?}, {:?}]", u(), u(), u());
        let along = row(&mut unit);
        let rows: Vec<String> = (0..i % 3).map(|_| row(&mut unit)).collect();
        let at_most = 2e3 + 1.5e3 * unit();
        let minus = if unit() > 0.3 { "minus: [CUT25], " } else { "" };
        limits += &format!(
            "- {{name: limit {i}, cuts: [CUT15], {minus}along: {along}, across: [{}], at_most: \
             {at_most:?}}}\n",
            rows.join(", ")
        );
    }
    let force: [f64; 3] = std::array::from_fn(|_| 1e3 * unit());
    let dead = if unit() > 0.0 { ", dead_force: [0, 0, -100]" } else { "" };
    let text = format!(
        "bodies: {{A: s, S: s, B: s, C: r}}\nsupports:\n- {{face: X0, fix: [x, y, z]}}\nrigid:\n- \
         {{face: X1, components: [x, y, z], free: [ux, uy, uz, rx, ry, rz], at: [40, 5, 5], force: \
         {force:?}{dead}}}\n{}resultant_limits:\n{limits}",
        entries(&[15.0, 25.0])
    );
    model(&text, bar(&[15.0, 25.0], seed, 2))
}

#[test]
fn bounds_of_fifty_random_sets_of_limits_are_in_order() {
    bounds_of_random_sets_are_in_order(0..50);
}

#[test]
#[ignore = "heavy: a minute"]
fn bounds_of_fifty_more_random_sets_are_in_order() {
    bounds_of_random_sets_are_in_order(50..100);
}

fn bounds_of_random_sets_are_in_order(seeds: std::ops::Range<u64>) {
    let (mut compared, mut limited, mut refuted) = (0, 0, 0);
    for seed in seeds.clone() {
        let m = random(seed);
        let pass = run(&m);
        let [low, up] =
            crate::common::limit::strict(&format!("seed {seed}"), &m, &pass).map(|x| x * FY);
        if seed % 4 == 0 {
            let without = AnalysisModel { resultant_limits: Vec::new(), ..m.clone() };
            let free = run(&without);
            let free = free.bracket.as_ref().expect("a bracket");
            assert!(
                low <= free.upper().value() * (1.0 + 1e-9),
                "seed {seed}: limits take strength away"
            );
            compared += 1;
            limited += usize::from(up < 0.99 * free.lower().value());
        }
        // the resultants of the static field, by the forces on the free end: equilibrium alone
        let stress = pass.stress.as_ref().expect("a field");
        let r = cut_limits::resultants(&m, stress)[0];
        let factor = pass.lower.as_ref().expect("a bound").certificate().factor;
        for d in 0..3 {
            let want = factor * m.rigid[0].action[d] + m.rigid[0].dead_action[d];
            assert!((r[d] - want).abs() < 1e-6 * (1.0 + want.abs()), "seed {seed}: {r:?}");
        }
        // a motion that costs less than the jumps of the velocities is refuted
        let mut velocity = pass.velocity.clone().expect("velocities");
        let largest = velocity.limit_motions.iter().fold(0.0f64, |a, m| a.max(m.abs()));
        let moves = velocity.nodes.u.iter().flatten().fold(0.0f64, |a, u| a.max(u.abs()));
        if largest > 1e-3 * moves {
            velocity.limit_motions.iter_mut().for_each(|m| *m *= 0.99);
            assert!(!UpperFactor::new(certify_upper(&m, &velocity, 1)).is_strict(), "seed {seed}");
            velocity.limit_motions.clear();
            assert!(!UpperFactor::new(certify_upper(&m, &velocity, 1)).is_strict(), "seed {seed}");
            refuted += 1;
        }
        // a limit below the resultant refutes the stress
        let mut weaker = m.clone();
        weaker.resultant_limits.iter_mut().for_each(|l| l.at_most *= 0.5);
        let used = certify_lower(&weaker, stress, factor).worst();
        let here = certify_lower(&m, stress, factor);
        let most = here.resultant.expect("limits");
        assert!((used - (2.0 * most).max(here.utilisation)).abs() < 1e-9 * used, "seed {seed}");
    }
    println!("{limited} of {compared} are governed by a limit; {refuted} move across a cut");
    assert!(3 * limited > compared && 3 * refuted > seeds.count(), "{limited} {refuted}");
}

/// Dead loads beyond a limit are refused by the limit, not by a weld.
#[test]
fn dead_loads_beyond_a_limit_are_refused_by_its_name() {
    let live = pulled(0.0, 0.0, 1);
    let pass = run(&live);
    let stress = pass.stress.as_ref().expect("a field");
    let mut dead = live.clone();
    let factor = pass.lower.as_ref().expect("a bound").certificate().factor;
    dead.rigid[0].dead_action = dead.rigid[0].action.map(|a| a * factor);
    dead.resultant_limits.iter_mut().for_each(|l| l.at_most *= 0.5);
    let refused = draw_inside(&dead, StressField::none(dead.mesh.tets.len()), 0.0, Some(stress));
    let said = refused.expect_err("too much").to_string();
    assert!(said.contains("times a resultant limit"), "{said}");
}

#[test]
fn agrees_with_clarabel() {
    for seed in 0..6 {
        let m = random(seed);
        let k = Kinematic::limit(&m, Flow::Split).expect("a program");
        oracle::agree(&format!("kinematic {seed}"), &k.program, &k.map.block);
    }
}

/// A field of pressures proves no load factor without limit where a resultant is limited.
#[test]
fn nothing_is_without_limit() {
    let m = pulled(0.0, 0.0, 1);
    let none = StressField::none(m.mesh.tets.len());
    assert!(certify_unlimited(&m, &none, None).unproved);
}

/// Entries that cannot be right are refused with the place.
#[test]
fn wrong_limits_are_refused() {
    let told = |limit: &str, cut: &str, fixed: &str| {
        let text = format!(
            "bodies: {{A: r, S: s, B: r, C: r}}\nsupports:\n- {{face: X0, fix: [x, y, z]}}\n- \
             {{face: Y0, fix: [{fixed}]}}\nrigid:\n- {{face: X1, components: [x], free: [ux], at: \
             [40, 5, 5], force: [1, 0, 0]}}\ncuts:\n- {cut}\nresultant_limits:\n- {limit}\n"
        );
        let faults = resolved(&text, bar(&[15.0, 5.0], 1, 2)).expect_err("refused");
        faults.iter().map(|d| d.to_string()).collect::<Vec<_>>().join("\n")
    };
    let good_cut = "{body: S, cut: CUT15, axis: [1, 0, 0]}";
    let good = "{name: a, cuts: [CUT15], along: [1, 0, 0], at_most: 10}";
    for (limit, cut, fixed, words) in [
        (good, "{body: S, cut: CUT5, axis: [1, 0, 0]}", "y", "inside the body"),
        (good, "{body: A, cut: CUT5, axis: [1, 0, 0]}", "y", "no yield strength"),
        (good, "{body: S, cut: CUT15, axis: [0, 1, 0]}", "y", "runs along the axis"),
        (good, "{body: S, cut: CUT15, axis: [0, 0, 0]}", "y", "no direction"),
        (good, "{body: S, cut: X0, axis: [1, 0, 0]}", "y", "outer faces"),
        ("{name: a, cuts: [CUT16], along: [1, 0, 0], at_most: 10}", good_cut, "y", "`CUT16`"),
        ("{name: a, cuts: [], along: [1, 0, 0], at_most: 10}", good_cut, "y", "names no cut"),
        ("{name: a, cuts: [CUT15], at_most: 10}", good_cut, "y", "limits no direction"),
        ("{name: a, cuts: [CUT15], along: [1, 0, 0], at_most: 0}", good_cut, "y", "must be > 0"),
        ("{name: '', cuts: [CUT15], along: [1, 0, 0], at_most: 1}", good_cut, "y", "is empty"),
        (
            "{name: a, cuts: [CUT15], minus: [CUT15], along: [1, 0, 0], at_most: 1}",
            good_cut,
            "y",
            "named twice",
        ),
        (
            "{name: a, cuts: [CUT15], across: [[0, 0, 0]], at_most: 1}",
            good_cut,
            "y",
            "without a direction",
        ),
        ("{name: a, cuts: [CUT15], across: [[0, 1, 0]], at_most: 1}", good_cut, "y", "holds y"),
    ] {
        let said = told(limit, cut, fixed);
        assert!(said.contains(words), "{words}: {said}");
    }
}
