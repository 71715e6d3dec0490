//! Limit analysis: both programs against load factors known exactly, and against each other.
#![allow(clippy::unwrap_used)]

mod common;
#[path = "limit/exact.rs"]
mod exact;
