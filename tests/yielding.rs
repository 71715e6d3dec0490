//! The elastic, perfectly plastic programs: valid as data, exact where both elements hold the exact
//! fields, and dual to each other. Solved by Clarabel alone.
#![allow(clippy::unwrap_used)]

#[path = "yielding/closed_forms.rs"]
mod closed_forms;
mod common;
#[path = "yielding/duality.rs"]
mod duality;
#[path = "yielding/program_data.rs"]
mod program_data;
