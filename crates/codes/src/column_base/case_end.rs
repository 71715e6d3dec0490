//! The end of the column that a load case acts on.

use crate::subject::Subject;
use bracket_joint::assembly::PlaneActions;

/// The end of a load case.
pub(super) fn at(a: &PlaneActions) -> Subject {
    Subject::end(&a.end)
}
