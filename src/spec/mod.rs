//! What a user writes: YAML files, strictly read.

pub mod yaml;
pub mod connection;
pub mod expr;
pub mod loads;

pub use connection::ConnectionSpec;
