//! Upper bound of the plastic dissipation of a linear strain rate.
//!
//! `π(ε) = √2 k ‖ε‖` is convex and ε linear in a tet, so the value interpolated between any points
//! of a partition is at least `∫ π(ε)`. The rules here are the vertex rule, and the vertex rule on
//! the 8 tets that the edge midpoints make.

use crate::mesh::tet::EDGES;
use bracket_base::math::mandel::{self, Mandel};

/// Positions in [`EDGES`] of the three pairs of opposite edges: the ends of an octahedron's
/// diagonals.
const OPPOSITE: [[usize; 2]; 3] = [[0, 5], [1, 3], [2, 4]];

fn middle(a: &Mandel, b: &Mandel) -> Mandel {
    std::array::from_fn(|i| 0.5 * (a[i] + b[i]))
}

fn at_middles(strains: &[Mandel; 4]) -> [Mandel; 6] {
    EDGES.map(|[a, b]| middle(&strains[a], &strains[b]))
}

/// An upper bound of the mean of `‖ε‖` over a tet with the given strain rates at its vertices.
///
/// The rule has ten points: the vertex rule on the 8 tets that edge midpoints make, averaged over
/// the three diagonals of the octahedron between them. The weights are 1/32 at vertices and 7/48 at
/// edge midpoints. Each further subdivision applies the rule to those 8 tets.
pub fn mean_norm(strains: &[Mandel; 4], subdivisions: u32) -> f64 {
    let middles = at_middles(strains);
    let norms = middles.map(|m| mandel::norm(&m));
    if subdivisions == 0 {
        let vertices: f64 = strains.iter().map(mandel::norm).sum();
        return vertices / 32.0 + 7.0 / 48.0 * norms.iter().sum::<f64>();
    }
    let corners = (0..4).map(|v| {
        let mut tet = [strains[v]; 4];
        let touching = (0..6).filter(|&e| EDGES[e].contains(&v));
        touching.enumerate().for_each(|(i, e)| tet[i + 1] = middles[e]);
        tet
    });
    // any diagonal gives a bound; its ends count most, so the one with the smallest norms is used
    let least = |d: &[usize; 2]| norms[d[0]] + norms[d[1]];
    let [p, q] =
        OPPOSITE.into_iter().min_by(|a, b| least(a).total_cmp(&least(b))).unwrap_or(OPPOSITE[0]);
    let ([a, c], [b, d]) = (EDGES[p], EDGES[q]);
    let ring = [(a, b), (a, d), (c, d), (c, b)].map(|(x, y)| middle(&strains[x], &strains[y]));
    let octahedron = (0..4).map(|i| [middles[p], middles[q], ring[i], ring[(i + 1) % 4]]);
    corners.chain(octahedron).map(|t| mean_norm(&t, subdivisions - 1)).sum::<f64>() / 8.0
}

#[cfg(test)]
mod tests {
    use super::*;
    use bracket_base::math::mandel::DEVIATORIC;

    fn random(seed: &mut u64) -> f64 {
        *seed ^= *seed << 13;
        *seed ^= *seed >> 7;
        *seed ^= *seed << 17;
        (*seed >> 11) as f64 / (1u64 << 53) as f64 - 0.5
    }

    fn deviatoric(c: [f64; 5]) -> Mandel {
        std::array::from_fn(|i| (0..5).map(|a| c[a] * DEVIATORIC[a][i]).sum())
    }

    /// `|x|` with x = 1, −1, −1, −1 at the vertices: the mean is known, `E|2λ₀ − 1|` with λ₀ of
    /// density 3 (1 − λ)², 9/16; the vertex rule gives 1. The bounds fall towards the mean and
    /// never below it.
    #[test]
    fn a_strain_that_changes_sign() {
        let tet = [1.0, -1.0, -1.0, -1.0].map(|x| deviatoric([x, 0.0, 0.0, 0.0, 0.0]));
        let exact = 9.0 / 16.0;
        let bounds: Vec<f64> = (0..5).map(|n| mean_norm(&tet, n)).collect();
        // four vertices of norm 1, three middles of norm 0 and three of norm 1
        assert!((bounds[0] - (4.0 / 32.0 + 3.0 * 7.0 / 48.0)).abs() < 1e-15, "{bounds:?}");
        assert!(bounds.iter().all(|b| *b >= exact - 1e-15), "{bounds:?}");
        assert!(bounds[4] - exact < 1e-12, "{bounds:?}");
    }

    /// On random strains: above the mean of many random points, falling with each subdivision,
    /// exact where the strain is constant, below the vertex rule.
    #[test]
    fn bounds_from_above() {
        let mut seed = 5;
        for _ in 0..20 {
            let tet: [Mandel; 4] =
                std::array::from_fn(|_| deviatoric(std::array::from_fn(|_| random(&mut seed))));
            let bounds: Vec<f64> = (0..4).map(|n| mean_norm(&tet, n)).collect();
            let vertices: f64 = tet.iter().map(|e| 0.25 * mandel::norm(e)).sum();
            assert!(
                bounds[0] <= vertices + 1e-15 && bounds.windows(2).all(|b| b[1] <= b[0] + 1e-15),
                "{bounds:?}"
            );
            let points = 20_000;
            let sum: f64 = (0..points)
                .map(|_| {
                    let mut cuts: [f64; 3] = std::array::from_fn(|_| random(&mut seed) + 0.5);
                    cuts.sort_unstable_by(f64::total_cmp);
                    let l = [cuts[0], cuts[1] - cuts[0], cuts[2] - cuts[1], 1.0 - cuts[2]];
                    mandel::norm(&std::array::from_fn(|i| (0..4).map(|v| l[v] * tet[v][i]).sum()))
                })
                .sum();
            let mean = sum / f64::from(points);
            assert!(bounds[3] > 0.99 * mean && bounds[3] < 1.02 * mean, "{bounds:?} {mean}");
            let constant = mean_norm(&[tet[0]; 4], 1);
            assert!((constant - mandel::norm(&tet[0])).abs() < 1e-15);
        }
    }
}
