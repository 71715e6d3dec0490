//! Output of a run on the terminal: progress, log, answer.

pub mod answer;
pub mod log;
pub mod out;
pub mod pace;
pub mod progress;
