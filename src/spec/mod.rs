//! What a user writes: YAML files, strictly read.

pub mod yaml;
