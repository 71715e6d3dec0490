//! What a check is about.

mod frame;
mod part;
mod place;
mod places;
mod sense;

pub use frame::Frame;
pub use part::Part;
pub use place::Place;
pub use places::Subject;
pub use sense::Sense;
