//! Tables of internal forces, as frame programs write them.

mod headers;
mod program;
mod read;
mod tables;

pub use program::{Program, Quantity};
pub use read::{ForceRow, Source, names, read};
pub use tables::ForceTables;

#[cfg(test)]
mod tests;
