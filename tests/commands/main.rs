//! The compiled program as users and scripts call it: its commands, files, exit codes and messages,
//! and the documents about it.
#![allow(clippy::unwrap_used)]

mod analyse;
mod batch;
#[path = "../common/bench.rs"]
mod bench;
mod catalog;
mod check;
#[path = "../common/mod.rs"]
mod common;
mod doctor;
mod documents;
mod import;
mod library;
mod mesh;
mod paper_joint;
mod wrong_inputs;
