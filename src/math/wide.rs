//! Eight numbers side by side, and code compiled for the widest registers of the machine it runs
//! on.
//!
//! The build's baseline is a plain processor; kernels written against [`Simd`] exist once for each
//! instruction set and are chosen when they are called. What is not inlined into a kernel stays
//! with the baseline: closures handed to pulp's dispatcher, which arrive through a shim of the
//! compiler, and closures handed to most iterators.

use pulp::{Arch, Simd, WithSimd};

/// Numbers side by side.
pub const LANES: usize = 8;
/// One entry of eight things.
pub type Lane = [f64; LANES];

/// Registers that hold one lane.
pub const fn parts<S: Simd>() -> usize {
    LANES / S::F64_LANES
}

/// Lanes as registers, [`parts`] for each.
#[inline(always)]
pub fn registers<S: Simd>(x: &[Lane]) -> &[S::f64s] {
    S::as_simd_f64s(x.as_flattened()).0
}

/// Lanes as registers, to be written.
#[inline(always)]
pub fn registers_mut<S: Simd>(x: &mut [Lane]) -> &mut [S::f64s] {
    S::as_mut_simd_f64s(x.as_flattened_mut()).0
}

/// Runs a kernel in the widest registers there are.
#[inline(always)]
pub fn dispatch<K: WithSimd>(kernel: K) -> K::Output {
    Arch::new().dispatch(kernel)
}
