//! Adaptive meshes: the rate at which the gap falls with the number of tets, and the gap predicted
//! for a mesh against the gap computed on it.

use crate::common::Block;
use crate::common::solved::{Solved, solve};
use bracket::mesh::{TetMesh, bisect};
use bracket::refine::rates;

/// Number of tets, gap over the lower bound, and the predicted gap.
struct Step {
    tets: f64,
    gap: f64,
    expected: Option<f64>,
}

fn gap(name: &str, s: &Solved) -> f64 {
    let [lower, upper] = s.strict(name);
    (upper - lower) / lower.abs()
}

/// Solves on the given mesh and on refined ones. Each mesh has `growth` times the tets of the
/// previous one and is refined where the gap comes from.
fn adaptive(name: &str, yaml: &str, mesh: TetMesh, growth: f64, most: usize) -> Vec<Step> {
    let mut mesh = mesh;
    let mut steps: Vec<Step> = Vec::new();
    let mut expected = None;
    loop {
        let s = solve(yaml, mesh.clone());
        let (tets, gap) = (mesh.tets.len() as f64, gap(name, &s));
        println!(
            "{name}: {tets} tets, gap {:.3} %, expected {:.3} %",
            100.0 * gap,
            100.0 * expected.unwrap_or(0.0)
        );
        steps.push(Step { tets, gap, expected });
        if growth * tets > most as f64 {
            return steps;
        }
        let estimate = rates::estimate(&s.model, s.pass.contributions.as_ref().unwrap(), None);
        let singular = estimate.rates.iter().filter(|q| **q < 1.0).count();
        let parts = |wanted: &[f64]| bisect::refine(&mesh, wanted).parts(mesh.tets.len());
        let curve = estimate.curve(2.0 * growth * tets, &parts);
        let design = estimate.with_tets(&curve, growth * tets, &parts);
        println!("{name}: {singular} tets beside singular edges, {} tets expected", design.tets);
        expected = Some(gap * design.gap);
        mesh = bisect::refine(&mesh, &design.wanted).mesh;
        assert!(
            (mesh.tets.len() as f64 / design.tets - 1.0).abs() < 1e-12,
            "bisection makes what it says"
        );
    }
}

/// Solves on the given mesh and on refined ones, with every tet split into `parts` each time.
fn uniform(name: &str, yaml: &str, mesh: TetMesh, parts: f64, most: usize) -> Vec<Step> {
    let mut mesh = mesh;
    let mut steps: Vec<Step> = Vec::new();
    while mesh.tets.len() <= most {
        let (tets, gap) = (mesh.tets.len() as f64, gap(name, &solve(yaml, mesh.clone())));
        println!("{name}: {tets} tets, gap {:.3} %", 100.0 * gap);
        steps.push(Step { tets, gap, expected: None });
        mesh = bisect::refine(&mesh, &vec![parts; mesh.tets.len()]).mesh;
    }
    steps
}

/// Slope of ln gap against ln N between the first of the last `count` steps and the last one.
fn slope(steps: &[Step], count: usize) -> f64 {
    let (a, b) = (&steps[steps.len() - count], steps.last().unwrap());
    (b.gap / a.gap).ln() / (b.tets / a.tets).ln()
}

/// An L-shaped block in plane strain with a 270° edge at (1, 1): `[0, 2]² × [0, t]` without
/// `[1, 2]²`. It has rollers at x = 0 and at the end of the upper arm. A normal traction acts on
/// the end of the lower arm. Only the re-entrant edge is singular.
fn l_shape(n: usize) -> (&'static str, TetMesh) {
    let mut mesh =
        Block::new([2 * n, 2 * n, n / 2], [2.0, 2.0, 0.5]).mesh(&["L"], |_| 0, |_, _| true);
    let inside = |t: &[u32; 4]| {
        let c: [f64; 2] =
            std::array::from_fn(|d| t.iter().map(|i| 0.25 * mesh.nodes[*i as usize][d]).sum());
        c[0] < 1.0 || c[1] < 1.0
    };
    let tets: Vec<[u32; 4]> = mesh.tets.iter().filter(|t| inside(t)).copied().collect();
    let mut number = vec![u32::MAX; mesh.nodes.len()];
    let mut nodes = Vec::new();
    for n in tets.iter().flatten() {
        if number[*n as usize] == u32::MAX {
            number[*n as usize] = nodes.len() as u32;
            nodes.push(mesh.nodes[*n as usize]);
        }
    }
    mesh.tet_body.truncate(tets.len());
    mesh.tets = tets.iter().map(|t| t.map(|n| number[n as usize])).collect();
    mesh.nodes = nodes;
    for face in &mut mesh.faces {
        face.triangles.retain(|t| t.iter().all(|n| number[*n as usize] != u32::MAX));
        face.triangles.iter_mut().for_each(|t| *t = t.map(|n| number[n as usize]));
    }
    let yaml = "materials: {s: {E: 1000, nu: 0.3}}\nbodies: {L: s}\nsupports:\n- {face: X0, fix: \
                [x]}\n- {face: Y1, fix: [y]}\n- {face: Z0, fix: [z]}\n- {face: Z1, fix: \
                [z]}\nloads:\n- {face: X1, traction: [1, 0, 0]}\n";
    (yaml, mesh)
}

/// At a 270° edge the gap falls as N^(−0.36) on uniform meshes, and as N^(−0.95) or faster on
/// adaptive ones.
#[test]
fn re_entrant_edge() {
    let (yaml, mesh) = l_shape(2);
    let even = uniform("L uniform", yaml, mesh.clone(), 2.0, 12_000);
    let steps = adaptive("L adaptive", yaml, mesh, 2.0, 9_000);
    let (u, a) = (slope(&even, 4), slope(&steps, 4));
    println!("slopes {u:.3} {a:.3}");
    assert!((u + 0.36).abs() <= 0.06, "uniform {u}");
    assert!(a <= -0.95, "adaptive {a}");
    // the median error of the predicted gap is at most 30 %
    let mut errors: Vec<f64> =
        steps.iter().filter_map(|s| Some((s.gap / s.expected? - 1.0).abs())).collect();
    errors.sort_by(f64::total_cmp);
    assert!(errors[errors.len() / 2] < 0.3, "{errors:?}");
}

/// A block on rollers on three sides, pulled by a traction that varies along y: no edge is
/// singular. The gap on adaptive meshes is at most a tenth larger than on uniform meshes with as
/// many tets.
#[test]
fn smooth_block() {
    let mesh = Block::new([3, 3, 3], [1.0; 3]).mesh(&["B"], |_| 0, |_, _| true);
    let yaml = "materials: {s: {E: 1000, nu: 0.3}}\nbodies: {B: s}\nsupports:\n- {face: X0, fix: \
                [x]}\n- {face: Y0, fix: [y]}\n- {face: Z0, fix: [z]}\nloads:\n- {face: X1, \
                linear: {traction0: [0, 0, 0], gradient: [[0, 1, 0], [0, 0, 0], [0, 0, 0]]}}\n";
    let even = uniform("block uniform", yaml, mesh.clone(), 2.0, 6_000);
    let steps = adaptive("block adaptive", yaml, mesh, 2.0, 3_000);
    for s in &steps[1..] {
        let after = even.iter().position(|e| e.tets >= s.tets).unwrap();
        let [a, b] = [&even[after - 1], &even[after]];
        let share = (s.tets / a.tets).ln() / (b.tets / a.tets).ln();
        let same = (a.gap.ln() + share * (b.gap / a.gap).ln()).exp();
        println!("{} tets: adaptive {:.4} %, uniform {:.4} %", s.tets, 100.0 * s.gap, 100.0 * same);
        assert!(s.gap <= 1.1 * same, "{} tets: {} against {same}", s.tets, s.gap);
    }
}
