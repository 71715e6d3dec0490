//! Text and pictures of a result.

pub mod console;
pub mod draw;
pub mod figures;
pub mod html;
pub mod markdown;
pub mod study;
