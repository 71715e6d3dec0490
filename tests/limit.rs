//! Limit analysis: strict brackets of load factors known exactly or bracketed in the literature, and of random assemblies.
#![allow(clippy::unwrap_used)]

#[path = "limit/bracketed.rs"]
mod bracketed;
#[path = "limit/certified.rs"]
mod certified;
mod common;
#[path = "limit/exact.rs"]
mod exact;
#[path = "limit/random.rs"]
mod random;
#[path = "limit/random_joints.rs"]
mod random_joints;
#[path = "limit/rigid_bodies.rs"]
mod rigid_bodies;
#[path = "limit/welds.rs"]
mod welds;
