//! Errors of a model: the reasons why no program can be built from it.

use bracket_base::display_text;
use bracket_base::say;
use bracket_base::words::Text;

/// Reason why no program can be built from a model.
#[derive(Clone, Debug, PartialEq)]
pub enum ModelError {
    /// Two rigid faces share nodes in a component both of them move.
    RigidFacesTouch(String, String, &'static str),
    /// A tet too flat for its stress parameters.
    FlatTet {
        /// Index of the tet, from 0.
        tet: usize,
        /// Its number, body, place and shape, see [`crate::mesh::quality::tet_words`].
        words: Text,
    },
    /// Nothing can give way.
    NothingYields,
    /// Something fixes the closure of a cut, along which the preload should draw the halves of the
    /// bolt together.
    CutHeld {
        /// Support, rigid face, weld or cut that fixes it.
        holder: &'static str,
        /// Name of the cut.
        cut: String,
    },
    /// A force per volume that the load factor multiplies.
    LiveBodyForce(String),
    /// The loads that carry the load factor can do no work.
    LiveLoadsHeld,
    /// No load carries the load factor.
    NoLiveLoad,
}

impl ModelError {
    /// The reason in words.
    pub fn text(&self) -> Text {
        match self {
            ModelError::RigidFacesTouch(a, b, axis) => {
                say!("rigid faces `{}` and `{}` share an edge and both move it in {}", a, b, *axis)
            }
            ModelError::FlatTet { words, .. } => {
                say!("the static program needs rounder tets than {}", words)
            }
            ModelError::NothingYields => {
                "no body has a yield strength and no contact can slip or open: there is nothing \
                 that could collapse"
                    .into()
            }
            ModelError::CutHeld { holder, cut } => say!(
                "{} at the rim of the cut `{}` prevents its halves from moving relative to each \
                 other",
                *holder,
                cut
            ),
            ModelError::LiveBodyForce(body) => say!(
                "a body force on `{}` carries the load factor: limit analysis takes body forces \
                 as dead loads only",
                body
            ),
            ModelError::LiveLoadsHeld => {
                "every load that carries the load factor acts on fixed displacements: the load \
                 factor has no limit"
                    .into()
            }
            ModelError::NoLiveLoad => {
                "no load carries the load factor: there is nothing for limit analysis to increase"
                    .into()
            }
        }
    }
}

display_text!(ModelError);

impl std::error::Error for ModelError {}

impl From<ModelError> for bracket_base::diag::Diagnostic {
    fn from(e: ModelError) -> Self {
        let help = match &e {
            ModelError::RigidFacesTouch(..) => {
                "join the two faces into one physical surface, or move only one of them"
            }
            ModelError::NothingYields => "give the material of the bodies that can yield an `fy`",
            ModelError::CutHeld { .. } => {
                "cut the shank away from supports, rigid faces, welds and other cuts"
            }
            ModelError::LiveBodyForce(_) => "write it under `dead`, or load a face instead",
            ModelError::LiveLoadsHeld => {
                "load a face that can move, or free the displacement on which the load acts"
            }
            ModelError::NoLiveLoad => "write the load to be increased under `loads`",
            ModelError::FlatTet { .. } => {
                "improve the mesh there (a coarser size, an optimised mesh), then try again"
            }
        };
        bracket_base::diag::Diagnostic::input("model/program", e.to_string()).help(help)
    }
}
