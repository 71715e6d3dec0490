//! Text and pictures of a result.

pub mod console;
pub mod draw;
pub mod escaped;
pub mod figures;
pub mod markdown;
pub mod page;
#[cfg(feature = "pdf")]
pub mod pdf;
pub mod printed;
pub mod sheet;
pub mod study;
pub mod summary;
pub mod words;
