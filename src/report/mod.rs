//! What a run leaves behind: the result folder, its numbers, its page, its pictures and its fields.

pub mod data;
pub mod folder;
pub mod log;
pub mod vtu;
