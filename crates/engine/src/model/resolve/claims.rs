//! Mesh faces claimed by interfaces.

use crate::mesh::split::TetFace;
use crate::model::analysis::ContactLaw;
use std::collections::BTreeMap;

/// Law of an open interface, whose two sides have separate nodes.
pub(super) enum OpenLaw {
    /// Unilateral contact.
    Contact(ContactLaw),
    /// A weld: strength per area of the interface and, if given, on the throat \[MPa\].
    Weld(f64, Option<f64>),
}

/// An open interface before the nodes are split.
pub(super) struct OpenInterface {
    /// Name in messages.
    pub name: String,
    /// Its law.
    pub law: OpenLaw,
    /// Side A and side B of each face.
    pub faces: Vec<[TetFace; 2]>,
}

/// The faces claimed by the entries of `interfaces`.
#[derive(Default)]
pub(super) struct Claims {
    /// The open interfaces.
    pub open: Vec<OpenInterface>,
    /// The entry that claims a face, and whether it opens the face; the key is the lower tet face.
    by_face: BTreeMap<TetFace, (usize, bool)>,
}

impl Claims {
    /// True when the face (its first side in the table) is in contact or welded.
    pub fn is_open(&self, first: TetFace) -> bool {
        self.by_face.get(&first).is_some_and(|(_, open)| *open)
    }

    /// Claims a face (its first side in the table) for an entry; returns the entry that had claimed
    /// it before.
    pub fn claim(&mut self, first: TetFace, entry: usize, open: bool) -> Option<usize> {
        self.by_face.insert(first, (entry, open)).map(|(other, _)| other)
    }
}
