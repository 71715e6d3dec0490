//! Result of the hand checks of a connection.

use super::capacity::Capacity;
use super::comparison::Comparison;
use super::joint_stiffness::PureMoment;
use super::method_record::MethodRecord;
use crate::check::{Check, Status};
use bracket_base::words::Text;
use bracket_joint::assembly::Neglected;

/// The checks of a connection, and the reasons why some of them are missing.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct HandChecks {
    /// The checks, by topic.
    pub checks: Vec<Check>,
    /// Parts that could not be checked, with the reason.
    pub notes: Vec<Text>,
    /// What the methods of the code know of the joint beside the checks.
    pub capacities: Vec<Capacity>,
    /// Reason why the lower bound of a limit analysis decides nothing: no rule of rotation capacity
    /// holds.
    pub brittle: Option<Text>,
    /// Load cases in which a component may buckle. In these the component method binds, whatever
    /// the limit analysis gives.
    pub unstable: Vec<String>,
    /// Load cases at serviceability, in which only slip is checked.
    pub serviceability: Vec<String>,
    /// Actions at member ends that are neglected.
    pub neglected: Vec<Neglected>,
}

impl HandChecks {
    /// The component method of each sense of bending, with all numbers of M_j,Rd.
    pub fn methods(&self) -> impl Iterator<Item = &MethodRecord> {
        self.capacities.iter().filter_map(|c| match c {
            Capacity::Moment(method) => Some(method),
            _ => None,
        })
    }

    /// The component method for each load case with actions at a member end.
    pub fn comparisons(&self) -> impl Iterator<Item = &Comparison> {
        self.capacities.iter().filter_map(|c| match c {
            Capacity::UnderLoad(comparison) => Some(comparison),
            _ => None,
        })
    }

    /// Load cases that consist of one moment; its rotation gives the stiffness of the joint.
    pub fn moments(&self) -> impl Iterator<Item = &PureMoment> {
        self.capacities.iter().filter_map(|c| match c {
            Capacity::Stiffness(moment) => Some(moment),
            _ => None,
        })
    }

    /// Whether a check failed.
    pub fn failed(&self) -> bool {
        self.checks.iter().any(|c| c.status == Status::Failed)
    }
}
