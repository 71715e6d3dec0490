//! The design code of a spec: its partial factors, and what it makes of nominal strengths.

mod built;
mod code;
mod factors;
mod values;

pub use built::{build, build_from};
pub use code::DesignCode;

#[cfg(test)]
mod tests;
