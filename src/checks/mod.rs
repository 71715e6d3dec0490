//! What a code asks for beyond the model: the hand checks of EN 1993-1-8:2005 as pure functions
//! over plain data.
//!
//! Every function is one formula of the code: its clause stands in the doc comment, its result is a
//! [`Worked`] value that carries the formula with its numbers, and [`Worked::against`] makes it a
//! [`Check`]. Units: mm, N, MPa, N mm, rad.

pub mod check;
pub mod classification;
pub mod component_method;
pub mod ductility;
pub mod end_plate;
pub mod error;
pub mod eurocode;
pub mod judgement;
pub mod verdict;

pub use check::{Check, Status, Step, Topic, Unit, Worked};
pub use end_plate::{Comparison, HandChecks, JointStiffness, MomentAxial, PureMoment, hand_checks};
pub use error::CheckError;
pub use judgement::{Analysed, Judgement, judge};
