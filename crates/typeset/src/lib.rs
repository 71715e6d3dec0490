//! Sets a layout with its data as PDF, by typst in this process.
//!
//! It knows nothing of joints, results or languages: it takes a layout, data and pictures, and
//! gives bytes. So it is compiled beside the rest of Bracket, which does not wait for typst. Fonts
//! are embedded. Equal sheets give equal bytes.

pub mod fonts;
pub mod sheet;

pub use sheet::{Sheet, pdf};
