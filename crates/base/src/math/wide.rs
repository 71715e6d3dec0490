//! Eight numbers side by side, and kernels compiled for the widest registers of the machine that
//! runs them.
//!
//! The build targets a baseline processor. Kernels written with [`Simd`] are compiled once for each
//! instruction set, and the call selects one at run time. Code that is not inlined into a kernel is
//! compiled for the baseline only. This applies to closures passed to pulp's dispatcher (they
//! arrive through a shim of the compiler) and to closures passed to most iterators.

use pulp::{Arch, Simd, WithSimd};

/// Number of values in a lane.
pub const LANES: usize = 8;
/// The same entry of eight objects.
pub type Lane = [f64; LANES];

/// Number of registers that hold one lane.
pub const fn parts<S: Simd>() -> usize {
    LANES / S::F64_LANES
}

/// Lanes as registers, [`parts`] per lane.
#[inline(always)]
pub fn registers<S: Simd>(x: &[Lane]) -> &[S::f64s] {
    S::as_simd_f64s(x.as_flattened()).0
}

/// Lanes as mutable registers.
#[inline(always)]
pub fn registers_mut<S: Simd>(x: &mut [Lane]) -> &mut [S::f64s] {
    S::as_mut_simd_f64s(x.as_flattened_mut()).0
}

/// Runs a kernel in the widest registers available.
#[inline(always)]
pub fn dispatch<K: WithSimd>(kernel: K) -> K::Output {
    Arch::new().dispatch(kernel)
}
