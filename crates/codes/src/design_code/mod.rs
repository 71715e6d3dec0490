//! The design code of a spec: its partial factors, and what it makes of nominal strengths.

mod built;
mod code;
mod factors;
mod values;

pub use built::{build, build_from};
pub use code::{DesignCode, design_strengths};

#[cfg(test)]
mod tests;
