//! Search for a lack of equilibrium: a small conic program over the rigid motions that only contact
//! resists.
//!
//! The stiffness is zero along such a motion m. The program is unbounded when the loads work on the
//! motion, `q·m < 0`, and no contact resists it, `G m ∈ K`. The nearest such motion to the loads is
//! the projection of −q on that cone; it is zero when the contacts can balance the loads. When the
//! loads exceed the limit only slightly, interior-point iterations on the full program lose this
//! answer in their rounding errors; the projection has only one unknown per mode.

use super::clarabel;
use super::status::SolveOptions;
use crate::programs::conic::{ConicProgram, Csr, SymmetricCsc, cone_margin};

/// Smallest projection, relative to the loads, that counts as a lack of equilibrium.
const EXCESS: f64 = 1e-6;
/// Largest violation of a cone by the motion, relative to its largest opening.
const VIOLATION: f64 = 1e-7;

/// A direction among the given motions (`P m = 0`) along which the program is unbounded; `None`
/// when none is found.
pub fn direction(
    program: &ConicProgram,
    modes: &[Vec<f64>],
    options: &SolveOptions,
) -> Option<Vec<f64>> {
    // interfaces of finite strength resist as well, but are not among the cones
    if !program.elements.batches.is_empty() {
        return None;
    }
    let n = modes.len();
    let q: Vec<f64> =
        modes.iter().map(|m| m.iter().zip(&program.q).map(|(a, b)| a * b).sum()).collect();
    let size = q.iter().map(|x| x * x).sum::<f64>().sqrt();
    if size == 0.0 {
        return None;
    }
    let columns: Vec<Vec<f64>> = modes.iter().map(|m| program.g.mul(m)).collect();
    let mut g = Csr { ncols: n, ..Csr::default() };
    // the cones of yield points do not resist rigid motions
    let rows = program.g.nrows();
    let contacts = program.cone_starts().iter().take_while(|s| **s < rows).count();
    for r in 0..rows {
        let row: Vec<(u32, f64)> = (0..n).map(|c| (c as u32, columns[c][r])).collect();
        g.push_row(&row);
    }
    let identity = SymmetricCsc {
        n,
        col_ptr: (0..=n).collect(),
        row_idx: (0..n as u32).collect(),
        values: vec![1.0; n],
    };
    let small = ConicProgram {
        p: identity,
        q: q.iter().map(|x| x / size).collect(),
        c: 0.0,
        h: vec![0.0; rows],
        g,
        cones: program.cones[..contacts].to_vec(),
        ..ConicProgram::default()
    };
    let solution = clarabel::solve(&small, &SolveOptions { progress: None, ..options.clone() });
    if !solution.status.is_solution() {
        return None;
    }
    // the work of the loads on the projection equals its squared length
    let work: f64 = -solution.x.iter().zip(&small.q).map(|(a, b)| a * b).sum::<f64>();
    let length = solution.x.iter().map(|x| x * x).sum::<f64>().sqrt();
    let slack = small.g.mul(&solution.x);
    let largest = slack.iter().fold(0.0f64, |m, x| m.max(x.abs()));
    let worst = small
        .cone_starts()
        .into_iter()
        .zip(&small.cones)
        .map(|(s, c)| cone_margin(&slack[s..s + c.dim()]))
        .fold(f64::INFINITY, f64::min);
    if length < EXCESS || work < EXCESS * length || worst < -VIOLATION * largest {
        return None;
    }
    let mut x = vec![0.0; program.unknowns()];
    for (mode, w) in modes.iter().zip(&solution.x) {
        x.iter_mut().zip(mode).for_each(|(x, m)| *x += w * m);
    }
    Some(x)
}
