//! Tractions and deviators of super-elements, and the transposed products, through the reference
//! tetrahedron, eight elements side by side.
//!
//! The matrices of an element have 30 × 36 and 80 × 30 entries. The Piola map gives both from
//! constant matrices ([`super::stress_basis`]) and 39 numbers. The matrices do not fit into the
//! cache, these numbers and the constants do.
//!
//! # Shape
//! Numbers of an element: the matrix that turns reference tractions, by rows (9), and the matrix
//! that makes deviators of reference stresses, by rows (5 × 6).

use crate::elements::stress_basis::{PARAMETERS, TRACTIONS, reference};
use crate::elements::yielding_element::DEVIATOR;
use bracket_base::math::lanes::{Place, kernel};
use bracket_base::math::mandel::DEVIATORIC;
use bracket_base::math::mandel::Mandel;
use bracket_base::math::vec3::M3;
use bracket_base::math::wide::{Lane, parts, registers, registers_mut};
use pulp::Simd;

/// Stress values at the 16 points.
pub const STRESSES: usize = 96;
/// Rows of a constant matrix, and columns of its transpose, processed together.
const TILE: usize = 6;
const FIRST_DEVIATOR: usize = 9;

/// Constant matrix by rows.
type Rows = [[f64; PARAMETERS]];

/// The numbers of an element: its Jacobian, its Piola map, the unit of its parameters and its yield
/// radius.
pub fn numbers(jacobian: &M3, piola: &[Mandel; 6], unit: f64, radius: f64) -> Vec<f64> {
    let turn = jacobian.iter().flatten().map(|x| unit * x);
    let deviator = |i: usize, c: usize| -> f64 {
        (0..6).map(|r| DEVIATORIC[i][r] * piola[r][c]).sum::<f64>() * unit / radius
    };
    turn.chain((0..DEVIATOR).flat_map(|i| (0..6).map(move |c| deviator(i, c)))).collect()
}

/// `out = A x` for one register of each lane.
#[inline(always)]
fn times<S: Simd, const ROWS: usize>(
    simd: S,
    matrix: &Rows,
    x: &[S::f64s],
    at: Place,
) -> [S::f64s; ROWS] {
    let mut out = [simd.splat_f64s(0.0); ROWS];
    for first in (0..ROWS).step_by(TILE) {
        let mut sums = [simd.splat_f64s(0.0); TILE];
        for c in 0..PARAMETERS {
            let x = x[at.of(c)];
            for q in 0..TILE {
                let m = simd.splat_f64s(matrix[first + q][c]);
                sums[q] = simd.mul_add_e_f64s(m, x, sums[q]);
            }
        }
        out[first..first + TILE].copy_from_slice(&sums);
    }
    out
}

/// `y += Aᵀ x` for one register of each lane.
#[inline(always)]
fn add_transposed<S: Simd, const ROWS: usize>(
    simd: S,
    matrix: &Rows,
    x: &[S::f64s; ROWS],
    (y, at): (&mut [S::f64s], Place),
) {
    for first in (0..PARAMETERS).step_by(TILE) {
        let mut sums = [simd.splat_f64s(0.0); TILE];
        for r in 0..ROWS {
            for q in 0..TILE {
                let m = simd.splat_f64s(matrix[r][first + q]);
                sums[q] = simd.mul_add_e_f64s(m, x[r], sums[q]);
            }
        }
        for q in 0..TILE {
            let y = &mut y[at.of(first + q)];
            *y = simd.add_f64s(*y, sums[q]);
        }
    }
}

/// `v += T σ`.
pub fn add_tractions(maps: &[Lane], sigma: &[Lane], v: &mut [Lane]) {
    tractions(maps, sigma, v, &reference().traction[..]);
}

/// `out += Tᵀ v`.
pub fn add_strains(maps: &[Lane], v: &[Lane], out: &mut [Lane]) {
    strains(maps, v, out, &reference().traction[..]);
}

/// `out += B σ`: deviators at the points.
pub fn add_deviators(maps: &[Lane], sigma: &[Lane], out: &mut [Lane]) {
    deviators(maps, sigma, out, &reference().stress[..]);
}

/// `out += Bᵀ d`.
pub fn add_deviators_transposed(maps: &[Lane], d: &[Lane], out: &mut [Lane]) {
    deviators_transposed(maps, d, out, &reference().stress[..]);
}

kernel! {
    fn tractions(simd; maps: &'a [Lane], sigma: &'a [Lane], v: &'a mut [Lane], matrix: &'a Rows) {
        let (maps, sigma) = (registers::<S>(maps), registers::<S>(sigma));
        let v = registers_mut::<S>(v);
        for offset in 0..parts::<S>() {
            let at = Place { stride: parts::<S>(), offset };
            let t = times::<S, TRACTIONS>(simd, matrix, sigma, at);
            for q in (0..TRACTIONS).step_by(3) {
                for d in 0..3 {
                    let mut sum = v[at.of(q + d)];
                    for c in 0..3 {
                        sum = simd.mul_add_e_f64s(maps[at.of(3 * d + c)], t[q + c], sum);
                    }
                    v[at.of(q + d)] = sum;
                }
            }
        }
    }
}

kernel! {
    fn strains(simd; maps: &'a [Lane], v: &'a [Lane], out: &'a mut [Lane], matrix: &'a Rows) {
        let (maps, v) = (registers::<S>(maps), registers::<S>(v));
        let out = registers_mut::<S>(out);
        for offset in 0..parts::<S>() {
            let at = Place { stride: parts::<S>(), offset };
            let mut w = [simd.splat_f64s(0.0); TRACTIONS];
            for q in (0..TRACTIONS).step_by(3) {
                for d in 0..3 {
                    for c in 0..3 {
                        let j = maps[at.of(3 * c + d)];
                        w[q + d] = simd.mul_add_e_f64s(j, v[at.of(q + c)], w[q + d]);
                    }
                }
            }
            add_transposed(simd, matrix, &w, (&mut *out, at));
        }
    }
}

kernel! {
    fn deviators(simd; maps: &'a [Lane], sigma: &'a [Lane], out: &'a mut [Lane], matrix: &'a Rows) {
        let (maps, sigma) = (registers::<S>(maps), registers::<S>(sigma));
        let out = registers_mut::<S>(out);
        for offset in 0..parts::<S>() {
            let at = Place { stride: parts::<S>(), offset };
            let s = times::<S, STRESSES>(simd, matrix, sigma, at);
            for point in 0..STRESSES / 6 {
                for i in 0..DEVIATOR {
                    let to = at.of(DEVIATOR * point + i);
                    let mut sum = out[to];
                    for c in 0..6 {
                        let d = maps[at.of(FIRST_DEVIATOR + 6 * i + c)];
                        sum = simd.mul_add_e_f64s(d, s[6 * point + c], sum);
                    }
                    out[to] = sum;
                }
            }
        }
    }
}

kernel! {
    fn deviators_transposed(
        simd;
        maps: &'a [Lane],
        d: &'a [Lane],
        out: &'a mut [Lane],
        matrix: &'a Rows,
    ) {
        let (maps, d) = (registers::<S>(maps), registers::<S>(d));
        let out = registers_mut::<S>(out);
        for offset in 0..parts::<S>() {
            let at = Place { stride: parts::<S>(), offset };
            let mut s = [simd.splat_f64s(0.0); STRESSES];
            for point in 0..STRESSES / 6 {
                for c in 0..6 {
                    for i in 0..DEVIATOR {
                        let m = maps[at.of(FIRST_DEVIATOR + 6 * i + c)];
                        let to = &mut s[6 * point + c];
                        *to = simd.mul_add_e_f64s(m, d[at.of(DEVIATOR * point + i)], *to);
                    }
                }
            }
            add_transposed(simd, matrix, &s, (&mut *out, at));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::elements::columns::Columns;
    use crate::elements::fixtures::{corners, equals_by_matrix, lanes};
    use crate::elements::hencky_static::element;
    use crate::elements::packed_elements::Batch;
    use crate::elements::super_element::SuperElement;
    use bracket_base::math::mandel::Isotropic;
    use bracket_base::math::wide::LANES;

    /// Eight different tets: products from the numbers equal those with the matrices.
    #[test]
    fn products_equal_those_of_the_matrices() {
        let elements: Vec<_> = (0..LANES)
            .map(|l| {
                let corners = corners(l);
                let tet = SuperElement::new(corners, Isotropic::new(210_000.0, 0.3), None)
                    .expect("a good shape");
                let unknowns = (0..TRACTIONS as u32).collect();
                let columns = Columns { unknowns, terms: None };
                (element(&tet, &columns, 190.0 + l as f64, false), 1000 * l as u32, 1000 * l as u32)
            })
            .collect();
        let by_numbers = Batch::new(&elements);
        assert!(by_numbers.maps.len() == FIRST_DEVIATOR + 30 && !by_numbers.flexible);
        let both = |product: &dyn Fn(&Batch) -> Vec<Lane>| {
            equals_by_matrix(&by_numbers, 0.1, product);
        };
        let (v, sigma, d) = (lanes(TRACTIONS, 3), lanes(PARAMETERS, 17), lanes(80, 29));
        both(&|batch| {
            let mut out = lanes(PARAMETERS, 5);
            batch.strain(&v, &mut out);
            out
        });
        both(&|batch| {
            let mut out = lanes(TRACTIONS, 7);
            batch.add_force(&sigma, &mut out);
            out
        });
        both(&|batch| batch.deviators(&sigma));
        both(&|batch| {
            let mut out = lanes(PARAMETERS, 11);
            batch.add_deviators(&d, &mut out);
            out
        });
    }
}
