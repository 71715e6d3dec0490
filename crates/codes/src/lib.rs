//! Checks of the code that the model does not cover: the hand checks of EN 1993-1-8:2005 as pure
//! functions over plain data, and the verdict that joins them with the analysis.
//!
//! Every function is one formula of the code. Its doc comment names the clause. Its result is a
//! [`Worked`] value, which carries the formula with its numbers, and [`Worked::against`] makes it a
//! [`Check`]. Units: mm, N, MPa, N mm, rad.

pub mod check;
pub mod classification;
pub mod column_base;
pub mod component_method;
pub mod cover_splice;
pub mod design_code;
pub mod ductility;
pub mod end_plate;
pub mod error;
pub mod eurocode;
pub mod formula;
pub mod judgement;
pub mod route;
pub mod simple_joint;
pub mod subject;
pub mod unit;
pub mod verdict;
pub mod whole_joint;
pub mod worked;

pub use check::{Binding, Check, CheckId, Status, Step, Topic, Unit};
pub use column_base::base_checks;
pub use cover_splice::splice_checks;
pub use end_plate::{Comparison, HandChecks, JointStiffness, MomentAxial, PureMoment, hand_checks};
pub use error::CheckError;
pub use judgement::{Analysed, Governing, Judgement, judge};
pub use simple_joint::simple_checks;
pub use whole_joint::{design_strengths, joint_checks};
pub use worked::Worked;
