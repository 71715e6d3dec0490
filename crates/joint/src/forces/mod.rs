//! Tables of internal forces, as frame programs write them.

mod headers;
mod program;
mod read;
mod saf_model;
mod tables;

pub use program::{Program, Quantity};
pub use read::{ForceRow, Source, names, read};
pub use saf_model::{SafMember, SafModel};
pub use tables::{ForceTable, ForceTables};

#[cfg(test)]
mod tests;
