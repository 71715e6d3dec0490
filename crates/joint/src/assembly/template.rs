//! Connection templates: the keys of a template file.
//!
//! A template is data. A new connection type needs only a new file, because no Rust code refers to
//! a template by name.

mod boundary;
mod column_base;
mod common;
mod connections;
mod cover_splice;
mod hand_check_entry;
mod hand_checks;
mod parameter;
mod parts;
mod simple_joint;

pub use boundary::{
    ClearanceEntry, EndEntry, GroundEntry, SectionEntry, ShearReactionEntry, SupportEntry,
};
pub use column_base::ColumnBaseEntry;
pub use common::{Axis, Loop, RectangleEntry};
pub use connections::{BoltEntry, ContactEntry, GripEntry, WeldEntry};
pub use cover_splice::CoverSpliceEntry;
pub use hand_check_entry::HandCheckEntry;
pub use hand_checks::{EndPlateEntry, HaunchEntry, RafterEntry};
pub use parameter::{Default, Parameter, ParameterKind};
pub use parts::{
    BoxEntry, CutEntry, MidEntry, PartEntry, PrismEntry, ProfileEntry, RoleEntry, SolidEntry,
    TurnEntry,
};
pub use simple_joint::{PlateKind, SimpleJointEntry};

use crate::catalog::SectionKind;
use crate::spec::expr::Expr;
use crate::spec::loads::LoadSpec;
use schemars::JsonSchema;
use serde::Deserialize;

/// A connection template.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Template {
    /// A template that this one extends: its name, or its path relative to this file. Keys that
    /// this one leaves out are those of the other; templates/README.md has the rules of lists.
    pub extends: Option<String>,
    /// Name, as a spec says it.
    pub name: String,
    /// One line.
    pub title: String,
    /// What it models.
    #[serde(default)]
    pub about: String,
    /// Members the spec must give.
    pub members: Vec<MemberRole>,
    /// Parameters of the spec.
    pub parameters: Vec<Parameter>,
    /// Named intermediate values.
    #[serde(default)]
    pub define: Vec<Definition>,
    /// Conditions on the values.
    #[serde(default)]
    pub checks: Vec<Check>,
    /// Members and plates.
    pub parts: Vec<PartEntry>,
    /// Bolts.
    #[serde(default)]
    pub bolts: Vec<BoltEntry>,
    /// Open interfaces beside those of the bolts.
    #[serde(default)]
    pub contacts: Vec<ContactEntry>,
    /// Fillet welds; where the throat is zero the parts stay tied.
    #[serde(default)]
    pub welds: Vec<WeldEntry>,
    /// Faces that loads can name.
    #[serde(default)]
    pub sections: Vec<SectionEntry>,
    /// Member ends that actions can name.
    #[serde(default)]
    pub ends: Vec<EndEntry>,
    /// Supports.
    #[serde(default)]
    pub supports: Vec<SupportEntry>,
    /// What balances shear and torsion where the supports of a plate on ground do not.
    pub shear_reaction: Option<ShearReactionEntry>,
    /// Distances to keep.
    #[serde(default)]
    pub clearances: Vec<ClearanceEntry>,
    /// What the hand checks of the code see of it; absent: none are made.
    pub hand_checks: Option<HandCheckEntry>,
    /// Load of the starter spec.
    pub starter_load: Option<LoadSpec>,
}

impl Template {
    /// Role of the column, if the hand checks have one.
    pub fn column(&self) -> Option<&String> {
        self.hand_checks.as_ref()?.end_plate()?.column.as_ref()
    }
}

/// A member role.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct MemberRole {
    /// Role, the key under `members`.
    pub role: String,
    /// What it is.
    pub about: String,
    /// Kinds of section that it may have; absent: I and H sections alone.
    #[serde(default = "only_i")]
    pub sections: Vec<SectionKind>,
    /// Profile of the starter spec.
    pub profile: String,
    /// Steel of the starter spec.
    pub steel: String,
}

fn only_i() -> Vec<SectionKind> {
    vec![SectionKind::I]
}

/// A named intermediate value.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Definition {
    /// Name.
    pub name: String,
    /// Value.
    pub value: Expr,
}

/// A condition on the values.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Check {
    /// Name by which a template that extends this one refers to it.
    pub name: Option<String>,
    /// Loops.
    #[serde(default, rename = "for")]
    pub each: Vec<Loop>,
    /// Only where this holds.
    pub when: Option<Expr>,
    /// What must hold.
    pub that: Expr,
    /// Path in the spec to point at.
    pub at: String,
    /// Message if it does not.
    pub say: String,
    /// Cure.
    pub help: String,
}
