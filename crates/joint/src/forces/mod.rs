//! Tables of internal forces, as frame programs write them.

mod headers;
mod program;
mod read;

pub use program::{Program, Quantity};
pub use read::{ForceRow, Source, names, read};

#[cfg(test)]
mod tests;
