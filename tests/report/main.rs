//! What a run leaves behind, tested through files: pictures, fields, the page, the folder.

mod folder;
mod golden;
mod picture;
mod vtu;
