//! Limit analysis: strict brackets of load factors that are known exactly or bracketed in the
//! literature, and of random assemblies.
mod bracketed;
mod coulomb;
mod crushing;
mod exact;
mod hard;
mod hinges;
mod interaction;
mod lapped_plates;
mod lower_first;
mod mesh_pairs;
mod random;
mod random_joints;
mod resultant_limits;
mod rigid_bodies;
mod shared_patterns;
mod slip;
mod ties;
mod unloaded_contacts;
mod welds;
