//! Spec + template + catalogue → parts, interfaces, supports, loads, symmetry.

pub mod actions;
#[allow(clippy::module_inception)] // a file is named for its noun, and this one holds `Assembly`
pub mod assembly;
pub mod axes;
mod base_entry;
pub mod block;
mod builder;
pub mod code_values;
pub mod column_base;
pub mod column_ends;
pub mod column_span;
pub mod content;
pub mod cover_splice;
mod coverage;
pub mod end_plate;
pub mod error;
mod evaluate;
mod expected_parts;
pub mod extent;
pub mod facets;
mod facts;
mod family_values;
pub mod foundation;
mod given;
pub mod hole;
pub mod inputs;
pub mod joint;
mod ledges;
mod load_checks;
mod member_ends;
mod no_effect;
pub mod origin;
pub mod part;
pub mod rafter;
pub mod scope;
mod seen_bolts;
pub mod shaped;
mod shear_reaction;
pub mod sheets;
mod simple_entry;
pub mod simple_joint;
mod small_actions;
mod spec_checks;
mod splice_entry;
pub mod symmetry;
pub mod symmetry_plane;
pub mod template;
pub mod template_file;
pub mod turn;

pub use actions::PlaneActions;
pub use assembly::Assembly;
pub use builder::BoltLine;
pub use code_values::CodeValues;
pub use column_base::{BaseSection, BaseShear, ColumnBase};
pub use column_ends::{ColumnEnds, Way};
pub use content::{Content, NotChecked};
pub use cover_splice::{CoverPlate, CoverSplice, InnerCovers, SpliceUse, SplicedMember};
pub use end_plate::{ColumnSide, EndPlate, UnseenLoad};
pub use error::AssemblyError;
pub use facts::Facts;
pub use foundation::Foundation;
pub use joint::{Joint, LoadedTemplate, build, build_from, given_names, names};
pub use rafter::{Haunch, Rafter};
pub use simple_joint::{Notch, SimpleJoint, SimpleKind, Support, SupportElement};
pub use small_actions::{Idle, Neglected};

#[cfg(test)]
mod bad_load_steps;
#[cfg(test)]
mod bad_specs;
#[cfg(test)]
mod extends_tests;
#[cfg(test)]
mod good_messages;
#[cfg(test)]
pub(crate) mod tests;
