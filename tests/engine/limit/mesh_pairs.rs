//! Bounds of one joint on several meshes: the body is the same, so each bound holds on all of them.

use super::random::assembly_on;
use crate::common::limit::run;

/// Cells that each mesh has more than the first, in each direction.
const MESHES: [[usize; 3]; 3] = [[0; 3], [1, 0, 0], [0, 1, 2]];

/// The excess of a lower bound over an upper bound that counts as rounding.
const ROUNDING: f64 = 1e-9;

/// On random joints no lower bound of any mesh exceeds an upper bound of any other mesh; neither
/// does the lower bound without friction.
#[test]
fn bounds_of_different_meshes_are_in_order() {
    in_order(20);
}

#[test]
#[ignore = "heavy: minutes"]
fn bounds_of_more_joints_on_different_meshes_are_in_order() {
    in_order(60);
}

/// Compares the first `wanted` joints that have bounds.
fn in_order(wanted: usize) {
    let (mut joints, mut pairs, mut narrowest) = (0, 0, f64::INFINITY);
    for seed in 0.. {
        let models = MESHES.map(|more| assembly_on(seed, more));
        let passes: Vec<_> = models.iter().flatten().map(run).collect();
        let lower: Vec<f64> = passes
            .iter()
            .flat_map(|p| [&p.lower, &p.frictionless])
            .flatten()
            .filter(|l| l.is_strict())
            .map(|l| l.value())
            .collect();
        let upper: Vec<f64> = passes
            .iter()
            .filter_map(|p| p.upper.as_ref().filter(|u| u.is_strict()).map(|u| u.value()))
            .collect();
        // joints without a load factor have no bounds to compare
        if lower.len() < 2 || upper.len() < 2 {
            continue;
        }
        for l in &lower {
            for u in &upper {
                assert!(*l <= u + ROUNDING * u.abs(), "seed {seed}: {lower:?} {upper:?}");
                narrowest = f64::min(narrowest, u - l);
                pairs += 1;
            }
        }
        joints += 1;
        if joints == wanted {
            println!("{joints} joints of {seed} seeds, {pairs} pairs, nearest {narrowest:.3e}");
            return;
        }
    }
}
