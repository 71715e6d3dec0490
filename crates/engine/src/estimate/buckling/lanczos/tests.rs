use super::*;
use crate::solve::sparse::Patterns;

/// A full symmetric matrix.
fn packed(a: &Mat<f64>) -> SymmetricCsc {
    let n = a.nrows();
    let mut out = SymmetricCsc { n, col_ptr: vec![0], ..SymmetricCsc::default() };
    for c in 0..n {
        (0..=c).for_each(|r| {
            out.row_idx.push(r as u32);
            out.values.push(a[(r, c)]);
        });
        out.col_ptr.push(out.row_idx.len());
    }
    out
}

/// `L Lᵀ` and `−L Q diag(θ) Qᵀ Lᵀ` with L lower triangular and Q orthogonal without a pattern: the
/// factors of the pencil are 1/θ.
fn pencil(theta: &[f64], seed: u64) -> [SymmetricCsc; 2] {
    let n = theta.len();
    let x = noise(2 * n * n, seed);
    let q = bracket_base::math::dense::orthogonal_factor(&Mat::from_fn(n, n, |i, j| x[i * n + j]));
    let l = Mat::from_fn(n, n, |i, j| match i.cmp(&j) {
        std::cmp::Ordering::Less => 0.0,
        std::cmp::Ordering::Equal => 2.0 + i as f64 / n as f64,
        std::cmp::Ordering::Greater => 0.3 * x[n * n + i * n + j],
    });
    let lq = &l * &q;
    let scaled = Mat::from_fn(n, n, |i, j| -lq[(i, j)] * theta[j]);
    [packed(&(&l * l.transpose())), packed(&(scaled * lq.transpose()))]
}

fn found(theta: &[f64], count: usize, largest: f64) -> Ended {
    let [k, g] = pencil(theta, 5);
    let block: Vec<u32> = (0..theta.len() as u32).collect();
    let factor = SparseCholesky::new(&k, &block, &Patterns::default()).expect("definite");
    let pencil = Pencil { stiffness: &k, geometric: &g, factor: &factor };
    lowest_positive(&pencil, &Wanted { count, largest, tolerance: 1e-7 })
}

/// The factors agree with the given ones and have small residuals.
fn agrees(name: &str, theta: &[f64], count: usize) {
    let ended = found(theta, count, 1e4);
    let mut exact: Vec<f64> = theta.iter().filter(|t| **t > 1e-4).map(|t| 1.0 / t).collect();
    exact.sort_by(f64::total_cmp);
    exact.truncate(count);
    let factors: Vec<f64> = ended.pairs.iter().map(|p| p.factor).collect();
    println!("{name}: {} steps, {factors:?}", ended.steps);
    assert!(ended.complete && factors.len() == exact.len(), "{name}: {ended:?}");
    for (pair, exact) in ended.pairs.iter().zip(&exact) {
        assert!((pair.factor / exact - 1.0).abs() < 1e-10, "{name}: {} {exact}", pair.factor);
        assert!(pair.residual < 1e-6, "{name}: {}", pair.residual);
    }
}

/// θ as in a structure, most of them close to zero, with both signs.
fn decaying(n: usize, sign: impl Fn(usize) -> f64) -> Vec<f64> {
    (0..n).map(|i| sign(i) / (1.0 + i as f64).powi(2)).collect()
}

#[test]
fn both_signs() {
    agrees("alternating", &decaying(300, |i| if i % 2 == 0 { -1.0 } else { 0.7 }), 5);
    agrees("mostly negative", &decaying(300, |i| if i % 7 == 6 { 1.0 } else { -1.0 }), 3);
    agrees("all positive", &decaying(300, |_| 0.3), 4);
}

#[test]
fn clusters_and_multiple_factors() {
    let mut theta = decaying(300, |i| if i % 2 == 0 { -1.0 } else { 0.2 });
    theta[20..22].fill(0.6);
    theta[30..33].fill(0.5);
    theta[40..44].fill(0.4);
    agrees("two, three and four equal", &theta, 9);
    (0..6).for_each(|i| theta[50 + i] = 0.7 + 1e-6 * i as f64);
    agrees("six close ones", &theta, 8);
}

#[test]
fn slow_convergence_restarts() {
    let theta: Vec<f64> = (0..400).map(|i| 0.5 - 0.0025 * i as f64).collect();
    agrees("evenly spaced", &theta, 4);
}

#[test]
fn small_problems_are_exhausted() {
    agrees("one", &[0.5], 3);
    agrees("five", &[0.5, -0.2, 0.5, 0.1, -3.0], 4);
    agrees("low rank", &[vec![0.3, 0.2, -0.4], vec![0.0; 60]].concat(), 4);
}

#[test]
fn no_positive_factor() {
    for (name, theta) in [
        ("tension", decaying(300, |_| -0.5)),
        ("none", vec![0.0; 50]),
        ("beyond the largest that matters", decaying(300, |i| if i > 200 { 1.0 } else { -1.0 })),
    ] {
        let ended = found(&theta, 3, 1e4);
        println!("{name}: {} steps", ended.steps);
        assert!(ended.pairs.is_empty() && ended.complete, "{name}: {ended:?}");
    }
    assert_eq!(found(&[], 3, 1e4).pairs.len(), 0);
}

#[test]
fn factors_above_the_largest_are_left_out() {
    let ended = found(&decaying(300, |_| 0.5), 6, 20.0);
    let factors: Vec<f64> = ended.pairs.iter().map(|p| p.factor).collect();
    assert!(ended.complete && factors.len() == 3, "{factors:?}");
}
