//! What every room of Bracket may use: diagnostics, text files, quantities with units, the only
//! readers of YAML and XML, and small mathematics.
//!
//! Units everywhere: mm, N, MPa, N mm, rad. Symmetric tensors in Mandel form
//! `[xx, yy, zz, √2 yz, √2 xz, √2 xy]`.

pub mod diag;
pub mod diag_render;
pub mod grid;
pub mod later;
pub mod math;
pub mod text_file;
pub mod units;
pub mod words;
pub mod xml;
pub mod yaml;
