//! Field files, for ParaView and for `verify`.

pub mod field_files;
pub mod plastic_file;
pub mod route_files;
pub mod vtu;
mod vtu_read;
mod vtu_write;
