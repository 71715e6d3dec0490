//! The engine against closed forms, published cases and itself, on meshes that the tests make.
#![allow(clippy::unwrap_used)]

mod adapt;
mod buckling;
#[path = "../common/mod.rs"]
mod common;
mod limit;
mod limit_bounds;
mod literature;
mod pass;
mod plastic;
mod yielding;
