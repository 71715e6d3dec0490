//! The solids, interfaces and faces of a joint, built from the entries of its template.

mod bolts;
mod boundary;
mod context;
mod grips;
mod interfaces;
mod parts;
mod shapes;

pub use bolts::BoltLine;
pub(super) use context::Context;
