//! What a method of the code knows of a joint beside its checks.

use super::comparison::Comparison;
use super::joint_stiffness::PureMoment;
use super::method_record::MethodRecord;

/// A resistance or a stiffness with what gives it. Each family gives those that its methods know.
#[derive(Clone, Debug, PartialEq)]
pub enum Capacity {
    /// M_j,Rd of a sense of bending, or of a load case whose forces change it, with all numbers of
    /// the component method.
    Moment(MethodRecord),
    /// The component method under the actions of a load case at a member end.
    UnderLoad(Comparison),
    /// The stiffness under a load case that consists of one moment; its rotation brackets it.
    Stiffness(PureMoment),
}
