//! Limit analysis: strict brackets of load factors that are known exactly or bracketed in the
//! literature, and of random assemblies.
#![allow(clippy::unwrap_used)]

#[path = "limit/bracketed.rs"]
mod bracketed;
mod common;
#[path = "limit/coulomb.rs"]
mod coulomb;
#[path = "limit/exact.rs"]
mod exact;
#[path = "limit/hard.rs"]
mod hard;
#[path = "limit/hinges.rs"]
mod hinges;
#[path = "limit/interaction.rs"]
mod interaction;
#[path = "limit/lower_first.rs"]
mod lower_first;
#[path = "limit/mesh_pairs.rs"]
mod mesh_pairs;
#[path = "limit/random.rs"]
mod random;
#[path = "limit/random_joints.rs"]
mod random_joints;
#[path = "limit/rigid_bodies.rs"]
mod rigid_bodies;
#[path = "limit/shared_patterns.rs"]
mod shared_patterns;
#[path = "limit/slip.rs"]
mod slip;
#[path = "limit/ties.rs"]
mod ties;
#[path = "limit/unloaded_contacts.rs"]
mod unloaded_contacts;
#[path = "limit/welds.rs"]
mod welds;
