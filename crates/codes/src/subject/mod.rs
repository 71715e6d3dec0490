//! What a check is about.

mod part;

pub use part::Part;
