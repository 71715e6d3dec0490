//! The elastic, perfectly plastic programs: they are valid as data, exact where both elements
//! represent the exact fields, and dual to each other. Clarabel alone solves them.
#![allow(clippy::unwrap_used)]

#[path = "yielding/closed_forms.rs"]
mod closed_forms;
mod common;
#[path = "yielding/duality.rs"]
mod duality;
#[path = "yielding/program_data.rs"]
mod program_data;
