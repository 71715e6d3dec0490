//! The YAML files that a user writes, and their strict reader.

pub mod analysis;
pub mod code;
pub mod connection;
pub mod expr;
pub mod friction;
pub mod later;
pub mod loads;
pub mod polygon;
pub mod welds;
mod word;
pub mod yaml;

pub use connection::ConnectionSpec;
