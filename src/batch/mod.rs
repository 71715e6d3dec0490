//! Catalogues of joints: a sweep file is expanded into cases, the cases are checked and analysed,
//! and their results are merged into tables.

pub mod analysing;
pub mod axis;
pub mod cache;
pub mod capacity;
pub mod case;
pub mod checking;
pub mod choice;
pub mod choice_table;
pub mod chosen_joints;
pub mod column;
pub mod commands;
pub mod counts;
pub mod derived;
pub mod dimension;
pub mod expansion;
pub mod forecast;
pub mod import;
pub mod load_lists;
pub mod merged;
#[cfg(feature = "parquet")]
pub mod parquet_table;
pub mod part;
pub mod plan;
pub mod results_table;
pub mod row;
pub mod screen;
pub mod shard;
pub mod slurm;
pub mod spec_path;
pub mod summary;
pub mod summary_sheet;
pub mod sweep;
pub mod sweep_file;
pub mod sweep_folder;
pub mod table;
mod work_folder;
pub mod worker;
