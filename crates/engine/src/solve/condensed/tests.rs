use super::prepared::Prepared;
use crate::programs::conic::{Cone, ConicProgram, Csr, SymmetricCsc};
use crate::solve::sparse::Patterns;
use crate::solve::status::{Solution, SolveOptions, SolveStatus};

/// `min ½ p x² + q x` in each unknown, with the given rows.
fn program(p: &[f64], q: &[f64], rows: &[(&[(u32, f64)], f64)], cones: &[Cone]) -> ConicProgram {
    let n = p.len();
    let mut g = Csr { ncols: n, ..Csr::default() };
    rows.iter().for_each(|(row, _)| g.push_row(row));
    ConicProgram {
        p: SymmetricCsc {
            n,
            col_ptr: (0..=n).collect(),
            row_idx: (0..n as u32).collect(),
            values: p.to_vec(),
        },
        q: q.to_vec(),
        g,
        h: rows.iter().map(|r| r.1).collect(),
        cones: cones.to_vec(),
        ..ConicProgram::default()
    }
}

fn solved(program: &ConicProgram) -> Solution {
    let block: Vec<u32> = (0..program.p.n as u32).collect();
    Prepared::new(program, &block, &Patterns::default())
        .expect("laid out")
        .solve(&SolveOptions::default())
}

#[test]
fn the_nearest_point_of_a_cone() {
    // the point (0, 3, 4) goes to (2.5, 1.5, 2) of the cone x₀ ≥ ‖(x₁, x₂)‖
    let rows: [(&[(u32, f64)], f64); 3] =
        [(&[(0, 1.0)], 0.0), (&[(1, 1.0)], 0.0), (&[(2, 1.0)], 0.0)];
    let s = solved(&program(&[1.0; 3], &[0.0, -3.0, -4.0], &rows, &[Cone::SecondOrder(3)]));
    assert_eq!(s.status, SolveStatus::Optimal);
    s.x.iter().zip([2.5, 1.5, 2.0]).for_each(|(x, e)| assert!((x - e).abs() < 1e-6, "{:?}", s.x));
}

#[test]
fn contradicting_rows_end_with_a_certificate() {
    // x ≥ 1 and −x ≥ 1
    let rows: [(&[(u32, f64)], f64); 2] = [(&[(0, 1.0)], -1.0), (&[(0, -1.0)], -1.0)];
    let program = program(&[1.0], &[0.5], &rows, &[Cone::NonNegative; 2]);
    let s = solved(&program);
    assert_eq!(s.status, SolveStatus::Infeasible);
    assert!(s.iterations <= 15, "{} iterations", s.iterations);
    // Gᵀz = 0 and hᵀz < 0
    let hz: f64 = program.h.iter().zip(&s.z).map(|(h, z)| h * z).sum();
    assert!(hz < 0.0 && program.g.mul_transpose(&s.z)[0].abs() < 1e-6 * -hz, "{:?}", s.z);
}

#[test]
fn an_unbounded_program_ends_with_a_direction() {
    // −x + y with x ≥ |y|: falls along x
    let rows: [(&[(u32, f64)], f64); 2] = [(&[(0, 1.0)], 0.0), (&[(1, 1.0)], 0.0)];
    let program = program(&[0.0, 1.0], &[-1.0, 1.0], &rows, &[Cone::SecondOrder(2)]);
    let s = solved(&program);
    assert_eq!(s.status, SolveStatus::Unbounded);
    assert!(s.iterations <= 15, "{} iterations", s.iterations);
    assert!(s.x[0] > 0.0 && s.x[1].abs() < 1e-3 * s.x[0], "{:?}", s.x);
}
