//! Elastic, perfectly plastic analysis: strict brackets of energies known in closed form, the
//! elastic ones below first yield, no equilibrium beyond the limit load, and random assemblies.
mod adaptive;
mod coulomb;
mod exact;
mod hard;
mod preload;
mod random;
mod welds;
