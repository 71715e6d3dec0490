#![allow(missing_docs, clippy::unwrap_used)]
mod common;
use common::grid::{Grid, even, joined, name};
use common::limit::factors;
use common::yielding::model;
fn c1(label: &str, x: Vec<f64>, y: Vec<f64>, z: Vec<f64>, phase: [usize; 3]) {
    let half = *y.last().unwrap() == 1.0;
    let mut mesh = Grid::new([x, y, z]).phase(phase).mesh(&["B"], |_| Some(0), |_, _| true);
    name(&mut mesh, "X0", "B", |p| p[0] == 0.0);
    name(&mut mesh, "X1", "B", |p| p[0] == 5.0);
    let mut sup = String::new();
    if half {
        name(&mut mesh, "Y0", "B", |p| p[1] == 0.0);
        sup = "- {face: Y0, fix: [y]}\n".into();
    }
    let n = mesh.tets.len();
    let m = model(&format!("bodies: {{B: s}}\nsupports:\n- {{face: X0, fix: [x, y, z]}}\n{sup}loads:\n- {{face: X1, traction: [0, 0, 1]}}\n"), mesh);
    let [low, up] = factors(label, &m);
    println!("C1 {label}: {n} tets [{low:.5}, {up:.5}] {:.2} %", 100.0 * (up / low - 1.0));
}
#[test]
fn scratch() {
    for p in 0..8 {
        let phase = [p & 1, p >> 1 & 1, p >> 2];
        c1(&format!("even 10x4x4 {phase:?}"), even(0.0, 5.0, 10), even(0.0, 2.0, 4), even(0.0, 1.0, 4), phase);
    }
}
#[test]
fn graded() {
    let a = std::env::var("C1").unwrap();
    for spec in a.split('|') {
        // x;y;z;phase
        let v: Vec<Vec<f64>> = spec.split(';').map(|s| s.split(',').map(|t| t.parse().unwrap()).collect()).collect();
        let ph = [v[3][0] as usize, v[3][1] as usize, v[3][2] as usize];
        c1(spec, v[0].clone(), v[1].clone(), v[2].clone(), ph);
    }
}
#[test]
fn other() { let _ = joined(&[vec![0.0]]); }
