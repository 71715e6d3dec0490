//! Elastic, perfectly plastic analysis: strict brackets of energies known in closed form, the
//! elastic ones below first yield, no equilibrium beyond the limit load, and random assemblies.
#![allow(clippy::unwrap_used)]

#[path = "plastic/adaptive.rs"]
mod adaptive;
mod common;
#[path = "plastic/coulomb.rs"]
mod coulomb;
#[path = "plastic/exact.rs"]
mod exact;
#[path = "plastic/hard.rs"]
mod hard;
#[path = "plastic/random.rs"]
mod random;
#[path = "plastic/welds.rs"]
mod welds;
