//! What a run prints: progress, log, last words.

pub mod answer;
pub mod log;
pub mod out;
pub mod pace;
pub mod progress;
