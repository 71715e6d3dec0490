//! Forces of many members and a table of joints become a sweep whose joints carry all their load
//! cases.

pub mod column_forces;
pub mod doubts;
pub mod end_loads;
pub mod equilibrium;
pub mod forces_file;
pub mod import_folder;
pub mod imported;
pub mod joint_columns;
pub mod joint_row;
pub mod joint_specs;
pub mod joints_table;
pub mod model_members;
pub mod residuals_table;
pub mod template_ends;
