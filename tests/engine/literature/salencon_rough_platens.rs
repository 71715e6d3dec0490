//! A23: a block between rough rigid platens, plane strain, w/h = 2.
//!
//! ```text
//!   ==========  rigid, rough
//!   |        |
//!   |        | h      a quarter is analysed
//!   ==========
//!       w
//! ```
//! Source: J. Salençon, Théorie des charges limites: poinçonnement d'une plaque par deux poinçons
//! symétriques, C. R. Acad. Sci. Paris 265 (1967); E. Christiansen, Limit analysis of collapse
//! states (1996), the benchmark of numerical limit analysis: 2.42768 k.
//!
//! Tolerance: none. The bracket contains the value. Its width is at most 4 % (3.5 % on 324 tets,
//! 1.9 % on 840). The corner of the platen is singular, and the meshes are finest there.

use crate::common::grid::finer_at_end;
use crate::common::plane_strain::{contains, platens};
use bracket::model::AnalysisModel;

fn wide_platens(first: f64, ratio: f64) -> AnalysisModel {
    platens(2.0, finer_at_end(0.0, 2.0, first, ratio), finer_at_end(0.0, 1.0, first, ratio))
}

const SALENCON: f64 = 2.42768;

#[test]
fn wide_block_between_platens() {
    contains("A23", &wide_platens(0.08, 1.3), SALENCON, 0.04);
}

#[test]
#[ignore = "heavy: minutes"]
fn wide_block_between_platens_fine() {
    contains("A23, fine", &wide_platens(0.04, 1.2), SALENCON, 0.03);
}
