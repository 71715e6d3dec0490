//! The YAML files that a user writes.

pub mod analysis;
pub mod code;
pub mod connection;
pub mod expr;
pub mod friction;
pub mod load_table;
pub mod loads;
pub mod polygon;
pub mod table_loads;
pub mod welds;
mod word;

pub use connection::ConnectionSpec;
