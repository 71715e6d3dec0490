//! Errors of a model: the reasons why no program can be built from it.

/// Reason why no program can be built from a model.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum ModelError {
    /// Two rigid faces share nodes in a component both of them move.
    #[error("rigid faces `{0}` and `{1}` share an edge and both move it in {2}")]
    RigidFacesTouch(String, String, &'static str),
    /// A tet too flat for its stress parameters.
    #[error("the static program needs rounder tets than {words}")]
    FlatTet {
        /// Index of the tet, from 0.
        tet: usize,
        /// Its number, body, place and shape, see [`crate::mesh::quality::tet_words`].
        words: String,
    },
    /// Nothing can give way.
    #[error(
        "no body has a yield strength and no contact can slip or open: there is nothing that \
         could collapse"
    )]
    NothingYields,
    /// Something fixes the closure of a cut, along which the preload should draw the halves of the
    /// bolt together.
    #[error(
        "{holder} at the rim of the cut `{cut}` prevents its halves from moving relative to each \
         other"
    )]
    CutHeld {
        /// Support, rigid face, weld or cut that fixes it.
        holder: &'static str,
        /// Name of the cut.
        cut: String,
    },
    /// A force per volume that the load factor multiplies.
    #[error(
        "a body force on `{0}` carries the load factor: limit analysis takes body forces as dead \
         loads only"
    )]
    LiveBodyForce(String),
    /// The loads that carry the load factor can do no work.
    #[error(
        "every load that carries the load factor acts on fixed displacements: the load factor has \
         no limit"
    )]
    LiveLoadsHeld,
    /// No load carries the load factor.
    #[error("no load carries the load factor: there is nothing for limit analysis to increase")]
    NoLiveLoad,
}

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
