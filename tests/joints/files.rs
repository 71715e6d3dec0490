//! The files that a run writes: pictures, fields, the page, the folder.

mod folder;
mod golden;
mod picture;
mod vtu;
