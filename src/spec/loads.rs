//! Load cases of a connection spec: pressure on a named section, or actions at a member's end.

use crate::units::{Force, Moment, Stress};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// One load. Loads that share a `name` act together in one load case.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct LoadSpec {
    /// Name of the load case.
    pub name: String,
    /// Named section of the template the load acts on: `column_top`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub section: Option<String>,
    /// Uniform pressure on the section; positive pushes on the face.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub pressure: Option<Stress>,
    /// Uniform traction on the section along x, y, z.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub traction: Option<[Stress; 3]>,
    /// True: not multiplied by the load factor.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub dead: bool,
    /// Member end the actions act on: `beam_left`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub end: Option<String>,
    /// Where the actions act: the lever arm must be said.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub at: Option<ActionPoint>,
    /// Axial force, tension positive.
    #[serde(default, rename = "N", skip_serializing_if = "Option::is_none")]
    pub n: Option<Force>,
    /// Shear force along the member's y.
    #[serde(default, rename = "Vy", skip_serializing_if = "Option::is_none")]
    pub vy: Option<Force>,
    /// Shear force along the member's z.
    #[serde(default, rename = "Vz", skip_serializing_if = "Option::is_none")]
    pub vz: Option<Force>,
    /// Torsion.
    #[serde(default, rename = "T", skip_serializing_if = "Option::is_none")]
    pub t: Option<Moment>,
    /// Moment about the member's y (strong axis).
    #[serde(default, rename = "My", skip_serializing_if = "Option::is_none")]
    pub my: Option<Moment>,
    /// Moment about the member's z (weak axis).
    #[serde(default, rename = "Mz", skip_serializing_if = "Option::is_none")]
    pub mz: Option<Moment>,
    /// Which of the actions the load factor multiplies; the others are fixed.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub factor: Vec<Action>,
}

impl LoadSpec {
    /// The actions that are given, by name.
    pub fn actions(&self) -> Vec<Action> {
        let given = [
            (Action::N, self.n.is_some()),
            (Action::Vy, self.vy.is_some()),
            (Action::Vz, self.vz.is_some()),
            (Action::T, self.t.is_some()),
            (Action::My, self.my.is_some()),
            (Action::Mz, self.mz.is_some()),
        ];
        given.into_iter().filter(|(_, g)| *g).map(|(a, _)| a).collect()
    }
}

/// Where the actions at a member's end act.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum ActionPoint {
    /// Intersection of the member axes.
    Node,
    /// Face of the column.
    ColumnFace,
    /// Plane between end plate and support.
    BoltPlane,
}

/// An internal force or moment of a member.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub enum Action {
    /// Axial force.
    N,
    /// Shear along y.
    Vy,
    /// Shear along z.
    Vz,
    /// Torsion.
    T,
    /// Moment about y.
    My,
    /// Moment about z.
    Mz,
}
