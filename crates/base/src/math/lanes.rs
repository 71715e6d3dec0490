//! Dense products and solves of eight small interleaved matrices at once.
//!
//! The kernels use registers explicitly. Otherwise the compiler turns loops over the eight matrices
//! into gathered loads.

use super::wide::{Lane, parts, registers, registers_mut};
use pulp::Simd;

/// Rows processed together.
const ROWS: usize = 4;

/// Defines a kernel as a function. The macro also defines a struct, which passes the arguments to
/// the code of the selected instruction set.
#[macro_export]
macro_rules! kernel {
    (
        $(#[$meta:meta])*
        $vis:vis fn $name:ident($simd:ident; $($argument:ident: $type:ty),* $(,)?) $body:block
    ) => {
        $(#[$meta])*
        $vis fn $name<'a>($($argument: $type),*) {
            struct Kernel<'a> {
                $($argument: $type),*
            }
            impl<'a> pulp::WithSimd for Kernel<'a> {
                type Output = ();

                #[inline(always)]
                fn with_simd<S: pulp::Simd>(self, $simd: S) {
                    let Self { $($argument),* } = self;
                    $body
                }
            }
            $crate::math::wide::dispatch(Kernel { $($argument),* });
        }
    };
}
pub use kernel;

/// Positions of the entries of a vector of registers: entry i is at `stride i + offset`.
#[derive(Clone, Copy)]
pub struct Place {
    /// Distance between entries.
    pub stride: usize,
    /// Position of the first entry.
    pub offset: usize,
}

impl Place {
    /// Position of entry i.
    #[inline(always)]
    pub fn of(self, i: usize) -> usize {
        self.stride * i + self.offset
    }
}

/// `y += A x` for one register of each lane, A stored by rows. `at` gives the positions in A and x,
/// `to` those in y; `rows` is the number of rows of A and y.
#[inline(always)]
pub fn add_times_part<S: Simd>(
    simd: S,
    (a, x, at): (&[S::f64s], &[S::f64s], Place),
    (y, to, rows): (&mut [S::f64s], Place, usize),
) {
    let columns = x.len() / at.stride;
    let mut r = 0;
    while r + ROWS <= rows {
        let mut sums = [simd.splat_f64s(0.0); ROWS];
        for c in 0..columns {
            let x = x[at.of(c)];
            for q in 0..ROWS {
                sums[q] = simd.mul_add_e_f64s(a[at.of((r + q) * columns + c)], x, sums[q]);
            }
        }
        for q in 0..ROWS {
            let y = &mut y[to.of(r + q)];
            *y = simd.add_f64s(*y, sums[q]);
        }
        r += ROWS;
    }
    while r < rows {
        let mut sum = simd.splat_f64s(0.0);
        for c in 0..columns {
            sum = simd.mul_add_e_f64s(a[at.of(r * columns + c)], x[at.of(c)], sum);
        }
        let y = &mut y[to.of(r)];
        *y = simd.add_f64s(*y, sum);
        r += 1;
    }
}

/// `y += Aᵀ x` for one register of each lane, A stored by rows. `at` gives the positions in A and
/// y, `from` those in x; `rows` is the number of rows of A and x.
#[inline(always)]
pub fn add_transposed_part<S: Simd>(
    simd: S,
    (a, y, at): (&[S::f64s], &mut [S::f64s], Place),
    (x, from, rows): (&[S::f64s], Place, usize),
) {
    let columns = y.len() / at.stride;
    let mut r = 0;
    while r + ROWS <= rows {
        let mut factors = [simd.splat_f64s(0.0); ROWS];
        for q in 0..ROWS {
            factors[q] = x[from.of(r + q)];
        }
        for c in 0..columns {
            let mut sum = y[at.of(c)];
            for q in 0..ROWS {
                sum = simd.mul_add_e_f64s(a[at.of((r + q) * columns + c)], factors[q], sum);
            }
            y[at.of(c)] = sum;
        }
        r += ROWS;
    }
    while r < rows {
        let factor = x[from.of(r)];
        for c in 0..columns {
            y[at.of(c)] = simd.mul_add_e_f64s(a[at.of(r * columns + c)], factor, y[at.of(c)]);
        }
        r += 1;
    }
}

kernel! {
    /// `y += A x`, A stored by rows.
    pub fn add_times(simd; a: &'a [Lane], x: &'a [Lane], y: &'a mut [Lane]) {
        let rows = y.len();
        let (a, x, y) = (registers::<S>(a), registers::<S>(x), registers_mut::<S>(y));
        for offset in 0..parts::<S>() {
            let at = Place { stride: parts::<S>(), offset };
            add_times_part(simd, (a, x, at), (&mut *y, at, rows));
        }
    }
}

kernel! {
    /// `y += Aᵀ x`, A stored by rows.
    pub fn add_transposed(simd; a: &'a [Lane], x: &'a [Lane], y: &'a mut [Lane]) {
        let rows = x.len();
        let (a, x, y) = (registers::<S>(a), registers::<S>(x), registers_mut::<S>(y));
        for offset in 0..parts::<S>() {
            let at = Place { stride: parts::<S>(), offset };
            add_transposed_part(simd, (a, &mut *y, at), (x, at, rows));
        }
    }
}

kernel! {
    /// `y −= A x` with symmetric A, its lower triangle stored by columns.
    pub fn subtract_symmetric(simd; a: &'a [Lane], x: &'a [Lane], y: &'a mut [Lane]) {
        let order = x.len();
        let (a, x, y) = (registers::<S>(a), registers::<S>(x), registers_mut::<S>(y));
        for offset in 0..parts::<S>() {
            let at = Place { stride: parts::<S>(), offset };
            let mut first = 0;
            for c in 0..order {
                let own = x[at.of(c)];
                let mut sum = simd.negate_mul_add_e_f64s(a[at.of(first)], own, y[at.of(c)]);
                for r in c + 1..order {
                    let entry = a[at.of(first + r - c)];
                    y[at.of(r)] = simd.negate_mul_add_e_f64s(entry, own, y[at.of(r)]);
                    sum = simd.negate_mul_add_e_f64s(entry, x[at.of(r)], sum);
                }
                y[at.of(c)] = sum;
                first += order - c;
            }
        }
    }
}

kernel! {
    /// Solves in place with a Cholesky factor, its lower triangle stored by columns.
    pub fn solve_packed(simd; factor: &'a [Lane], y: &'a mut [Lane]) {
        let order = y.len();
        let (factor, y) = (registers::<S>(factor), registers_mut::<S>(y));
        for offset in 0..parts::<S>() {
            let at = Place { stride: parts::<S>(), offset };
            let mut first = 0;
            for c in 0..order {
                let x = simd.div_f64s(y[at.of(c)], factor[at.of(first)]);
                y[at.of(c)] = x;
                for r in c + 1..order {
                    let entry = factor[at.of(first + r - c)];
                    y[at.of(r)] = simd.negate_mul_add_e_f64s(entry, x, y[at.of(r)]);
                }
                first += order - c;
            }
            for c in (0..order).rev() {
                first -= order - c;
                let mut x = y[at.of(c)];
                for r in c + 1..order {
                    x = simd.negate_mul_add_e_f64s(factor[at.of(first + r - c)], y[at.of(r)], x);
                }
                y[at.of(c)] = simd.div_f64s(x, factor[at.of(first)]);
            }
        }
    }
}
