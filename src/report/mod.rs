//! What a run leaves behind: the result folder, its numbers, its page, its pictures and its fields.

mod canvas;
pub mod case;
mod checks_text;
pub mod combine;
mod comparison;
pub mod contact_map;
pub mod data;
pub mod demand;
pub mod drawing;
pub mod field_files;
pub mod figures;
pub mod folder;
mod history;
pub mod joint_stiffness;
mod lettering;
pub mod limit_case;
mod limit_text;
pub mod log;
pub mod pace;
pub mod page;
pub mod plastic_file;
mod plastic_text;
pub mod plot;
pub mod polygon;
pub mod preload_text;
pub mod progress;
pub mod raster;
pub mod schedule;
pub mod static_forces;
pub mod study;
mod summary;
pub mod surface;
mod svg;
pub mod text;
pub mod vtu;

pub use canvas::Picture;
