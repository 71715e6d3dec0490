//! Load cases of a connection spec: pressure on a named section, or forces and moments at a member
//! end.

use super::word::{word, word_schema};
use bracket_base::units::{Force, Moment, Stress};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// One load. Loads that share a `name` act together in one load case.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct LoadSpec {
    /// Name of the load case.
    #[serde(deserialize_with = "word")]
    #[schemars(schema_with = "word_schema")]
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
    /// Limit state of the load case; loads that share a name agree in it.
    #[serde(default, skip_serializing_if = "LimitState::is_ultimate")]
    pub state: LimitState,
    /// True: not multiplied by the load factor.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub dead: bool,
    /// Member end the actions act on: `beam_left`. The member's own axes: x′ out of the joint, z′
    /// along the section's depth (up for a beam), y′ = z′ × x′.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub end: Option<String>,
    /// Where the actions act: the lever arm must be said.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub at: Option<ActionPoint>,
    /// Axial force along x′, tension positive.
    #[serde(default, rename = "N", skip_serializing_if = "Option::is_none")]
    pub n: Option<Force>,
    /// Shear force on the end section along y′.
    #[serde(default, rename = "Vy", skip_serializing_if = "Option::is_none")]
    pub vy: Option<Force>,
    /// Shear force on the end section along z′: positive lifts a beam, negative presses it down.
    #[serde(default, rename = "Vz", skip_serializing_if = "Option::is_none")]
    pub vz: Option<Force>,
    /// Torsion, right-handed about x′.
    #[serde(default, rename = "T", skip_serializing_if = "Option::is_none")]
    pub t: Option<Moment>,
    /// Moment about y′ (strong axis): positive pulls the top of the section, as under hogging
    /// moments.
    #[serde(default, rename = "My", skip_serializing_if = "Option::is_none")]
    pub my: Option<Moment>,
    /// Moment about z′ (weak axis), right-handed.
    #[serde(default, rename = "Mz", skip_serializing_if = "Option::is_none")]
    pub mz: Option<Moment>,
    /// Which of the actions the load factor multiplies, the others are fixed; left out: all of
    /// them.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub factor: Vec<Action>,
    /// A direction of the capacity polygon, not a load of the user's.
    #[serde(skip)]
    #[schemars(skip)]
    pub of_polygon: bool,
}

/// Limit state that a load case belongs to.
#[derive(
    Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize, JsonSchema,
)]
pub enum LimitState {
    /// Ultimate limit state.
    #[default]
    #[serde(rename = "ULS")]
    Ultimate,
    /// Serviceability limit state: of the hand checks only slip at serviceability (bolts of
    /// category B).
    #[serde(rename = "SLS")]
    Serviceability,
}

impl LimitState {
    /// True for the ultimate limit state.
    pub fn is_ultimate(&self) -> bool {
        *self == Self::Ultimate
    }

    /// Its word in a spec and in a table.
    pub fn word(self) -> &'static str {
        match self {
            Self::Ultimate => "ULS",
            Self::Serviceability => "SLS",
        }
    }

    /// The limit state of a word in a table.
    pub fn of(word: &str) -> Option<Self> {
        [Self::Ultimate, Self::Serviceability].into_iter().find(|s| s.word() == word)
    }
}

impl LoadSpec {
    /// The value of an action \[N, N mm\]; `None` where it is not given.
    pub fn value(&self, action: Action) -> Option<f64> {
        self.actions().into_iter().find(|(given, _)| *given == action).map(|(_, value)| value)
    }

    /// The actions that are given, with their values \[N, N mm\].
    pub fn actions(&self) -> Vec<(Action, f64)> {
        let forces = [(Action::N, self.n), (Action::Vy, self.vy), (Action::Vz, self.vz)];
        let moments = [(Action::T, self.t), (Action::My, self.my), (Action::Mz, self.mz)];
        let forces = forces.into_iter().filter_map(|(a, v)| Some((a, v?.0)));
        forces.chain(moments.into_iter().filter_map(|(a, v)| Some((a, v?.0)))).collect()
    }

    /// Sets the value of an action \[N, N mm\].
    pub fn set(&mut self, action: Action, size: f64) {
        match action {
            Action::N => self.n = Some(Force(size)),
            Action::Vy => self.vy = Some(Force(size)),
            Action::Vz => self.vz = Some(Force(size)),
            Action::T => self.t = Some(Moment(size)),
            Action::My => self.my = Some(Moment(size)),
            Action::Mz => self.mz = Some(Moment(size)),
        }
    }

    /// Path of the load in the spec. For a direction of the polygon it is the path of the polygon.
    pub fn path(&self, i: usize) -> String {
        if self.of_polygon { "polygon".into() } else { format!("loads[{i}]") }
    }

    /// True if the load factor multiplies the action.
    pub fn multiplies(&self, action: Action) -> bool {
        !self.dead && (self.factor.is_empty() || self.factor.contains(&action))
    }
}

impl ActionPoint {
    /// The point of a word in a table.
    pub fn of(word: &str) -> Option<Self> {
        [Self::Node, Self::ColumnFace, Self::BoltPlane].into_iter().find(|p| p.word() == word)
    }

    /// Name in a spec.
    pub fn word(self) -> &'static str {
        match self {
            ActionPoint::Node => "node",
            ActionPoint::ColumnFace => "column_face",
            ActionPoint::BoltPlane => "bolt_plane",
        }
    }
}

impl Action {
    /// All actions, forces first.
    pub const ALL: [Self; 6] = [Self::N, Self::Vy, Self::Vz, Self::T, Self::My, Self::Mz];

    /// Name in a spec.
    pub fn word(self) -> &'static str {
        match self {
            Action::N => "N",
            Action::Vy => "Vy",
            Action::Vz => "Vz",
            Action::T => "T",
            Action::My => "My",
            Action::Mz => "Mz",
        }
    }

    /// Axis of the member that the action is parallel to or turns about (0: x′, 1: y′, 2: z′), and
    /// whether it is a moment.
    pub fn direction(self) -> (usize, bool) {
        match self {
            Action::N => (0, false),
            Action::Vy => (1, false),
            Action::Vz => (2, false),
            Action::T => (0, true),
            Action::My => (1, true),
            Action::Mz => (2, true),
        }
    }
}

/// Where the actions at a member's end act.
#[derive(
    Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize, JsonSchema,
)]
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
