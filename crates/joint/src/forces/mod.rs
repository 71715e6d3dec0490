//! Tables of internal forces, as frame programs write them.

mod asked;
mod force_row;
mod frame_model;
mod headers;
mod iom;
mod program;
mod read;
mod saf_model;
mod tables;

pub use asked::Asked;
pub use force_row::{ForceRow, names};
pub use frame_model::{FrameMember, FrameModel};
pub use iom::model as iom_model;
pub use program::{Program, Quantity};
pub use read::Source;
pub use saf_model::read as saf_model;
pub use tables::{ForceTable, ForceTables};

#[cfg(test)]
mod tests;
