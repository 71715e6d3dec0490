//! What a design code says about a spec.

use super::error::AssemblyError;
use super::scope::Resolved;
use crate::spec::code::{Edition, PartialFactors};
use bracket_base::math::vec3::V3;
use bracket_base::words::Text;
use std::collections::BTreeMap;

/// What a design code says about a spec, as plain data. The assembly hands it on and compares loads
/// with it; it knows no clause and no factor itself.
#[derive(Debug)]
pub struct CodeValues {
    /// Edition of the code.
    pub edition: Edition,
    /// Partial factors, for the hand checks.
    pub factors: PartialFactors,
    /// The national annex, as the catalogue names it; `None`: the recommended values.
    pub annex: Option<String>,
    /// Each factor with its origin, for the list of resolved values.
    pub resolved: Vec<Resolved>,
    /// Notes for the report on factors and grades, one sentence each.
    pub notes: Vec<Text>,
    /// Design resistances of the members' sections by role, each action alone: to N, Vy, Vz \[N\]
    /// and T, My, Mz \[N mm\]. A role without an entry has none that is known.
    pub members: BTreeMap<String, [V3; 2]>,
    /// Faults in what the spec says about the code.
    pub faults: Vec<AssemblyError>,
}

/// Whether a resolved value is a factor of concrete, by its name.
pub(super) fn of_concrete(name: &str) -> bool {
    matches!(name, "code.gamma_c" | "code.alpha_cc")
}
