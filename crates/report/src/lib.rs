//! The result of a run: its data and files, and the text and pictures made from it.

pub mod console;
pub mod document;
pub mod draw;
pub mod escaped;
pub mod figures;
pub mod lettering;
pub mod markdown;
pub mod page;
pub mod pdf;
pub mod printed;
pub mod result;
pub mod sheet;
pub mod study;
pub mod summary;
pub mod words;
