//! Cases with known answers, named after their source.
#![allow(clippy::unwrap_used)]

#[path = "literature/acary_lap_joint.rs"]
mod acary_lap_joint;
#[path = "literature/bursi_jaspart_t_stub.rs"]
mod bursi_jaspart_t_stub;
mod common;
#[path = "literature/coulomb_block_on_ground.rs"]
mod coulomb_block_on_ground;
#[path = "literature/eurocode_t_stubs.rs"]
mod eurocode_t_stubs;
#[path = "literature/gaydon_mccrum_strip_with_hole.rs"]
mod gaydon_mccrum_strip_with_hole;
#[path = "literature/hertz_sphere_on_flat.rs"]
mod hertz_sphere_on_flat;
#[path = "literature/hill_block_between_platens.rs"]
mod hill_block_between_platens;
#[path = "literature/hill_hollow_sphere.rs"]
mod hill_hollow_sphere;
#[path = "literature/hill_partly_plastic_sphere.rs"]
mod hill_partly_plastic_sphere;
#[path = "literature/kirchhoff_thin_plates.rs"]
mod kirchhoff_thin_plates;
#[path = "literature/kirsch_plate_with_hole.rs"]
mod kirsch_plate_with_hole;
#[path = "literature/lame_cylinder_and_sphere.rs"]
mod lame_cylinder_and_sphere;
#[path = "literature/paper_reference_meshes.rs"]
mod paper_reference_meshes;
#[path = "literature/prandtl_punch.rs"]
mod prandtl_punch;
#[path = "literature/saint_venant_triangle.rs"]
mod saint_venant_triangle;
#[path = "literature/salencon_rough_platens.rs"]
mod salencon_rough_platens;
#[path = "literature/signorini_hard_contacts.rs"]
mod signorini_hard_contacts;
#[path = "literature/slivers_in_contact.rs"]
mod slivers_in_contact;
#[path = "literature/timoshenko_exact_bars.rs"]
mod timoshenko_exact_bars;
#[path = "literature/vdi2230_bolt_in_sleeve.rs"]
mod vdi2230_bolt_in_sleeve;
#[path = "literature/welds_between_blocks.rs"]
mod welds_between_blocks;
