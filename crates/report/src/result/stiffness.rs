//! The initial stiffness of a joint from its elastic analysis.

use crate::result::case_result::CaseResult;
use crate::result::quantity::LoadSize;
use bracket_codes::{JointStiffness, PureMoment};

/// The stiffness of a joint, if the only load of the case is a moment whose rotation is bracketed.
pub fn joint_stiffness<'a>(
    case: &CaseResult,
    moments: impl Iterator<Item = &'a PureMoment>,
) -> Option<JointStiffness> {
    let mine: Vec<&PureMoment> = moments.filter(|m| m.case == case.name).collect();
    let LoadSize::Moment(total) = case.load? else { return None };
    JointStiffness::new(&mine, total, case.load_displacement?)
}
