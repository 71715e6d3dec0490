//! The command line, with one file for each subcommand.

pub mod analyse;
pub mod analysis_options;
pub mod batch;
pub mod catalog;
pub mod catalog_options;
pub mod check;
pub mod commands;
pub mod common;
pub mod doctor;
pub mod import;
pub mod mesh;
pub mod new;
pub mod report;
pub mod run;
pub mod schema;
pub mod study;
pub mod templates;
pub mod verify;
pub mod watch;
