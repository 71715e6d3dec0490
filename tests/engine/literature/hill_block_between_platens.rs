//! A22: a block pressed between rigid platens, plane strain, w/h ≤ 1.
//!
//! ```text
//!   ====  rigid, rough
//!   |  |
//!   |  | h      a quarter is analysed
//!   |  |
//!   ====
//!    w
//! ```
//! Source: R. Hill, The Mathematical Theory of Plasticity (1950), chapter IX.3: 2k, the same as
//! between smooth platens.
//!
//! Tolerance: the stress is uniform, so the static side is exact on any mesh; the solver is asked
//! for a gap of 1e-4, which is the tolerance of the lower bound. The mechanism, bands at 45°, is
//! only approached by continuous velocities: 1 % for the upper bound (0.75 % measured).

use crate::common::grid::even;
use crate::common::limit::factors;
use crate::common::plane_strain::{K, platens};

#[test]
fn square_between_platens() {
    for (half, n) in [(0.5, 5), (1.0, 8)] {
        let m = platens(half, even(0.0, half, n), even(0.0, 1.0, 8));
        let [low, up] =
            factors(&format!("A22, w/h = {half}, {} tets", m.mesh.tets.len()), &m).map(|f| f / K);
        assert!((low / 2.0 - 1.0).abs() < 1e-4 && low <= 2.0 * (1.0 + 1e-9), "[{low}, {up}]");
        assert!((2.0..2.0 * 1.01).contains(&up), "[{low}, {up}]");
    }
}
