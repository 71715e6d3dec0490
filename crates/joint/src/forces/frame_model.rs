//! What the model of a frame program says of its members, beside their forces.

use bracket_base::diag::Place;
use std::collections::BTreeMap;

/// What a model says of a member.
#[derive(Clone, Debug, PartialEq)]
pub struct FrameMember {
    /// Where it says so.
    pub place: Place,
    /// Its section.
    pub section: String,
    /// Name of the rolled profile, as the model writes it; empty if it has none.
    pub profile: String,
    /// Steel grade, as the model writes it; empty if it has none.
    pub steel: String,
    /// True if the principal axes of the section are not along its depth and width.
    pub turned: bool,
}

/// The members of a model by name.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct FrameModel {
    members: BTreeMap<String, FrameMember>,
}

impl FrameModel {
    /// A member by its name.
    pub fn member(&self, name: &str) -> Option<&FrameMember> {
        self.members.get(name)
    }
}

impl FromIterator<(String, FrameMember)> for FrameModel {
    fn from_iter<I: IntoIterator<Item = (String, FrameMember)>>(members: I) -> Self {
        Self { members: members.into_iter().collect() }
    }
}
