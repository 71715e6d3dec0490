//! The elastic, perfectly plastic programs: they are valid as data, exact where both elements
//! represent the exact fields, and dual to each other. Clarabel alone solves them.
mod closed_forms;
mod duality;
mod program_data;
