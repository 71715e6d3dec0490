//! The mesh with the fewest elements for a given gap, or the smallest gap for a number of elements.
//!
//! A tet with the contribution η that is split into n parts contributes `η n^(−2q/3)`. For a given
//! `Σ n` the sum of these is smallest where one more part gains the same everywhere:
//! `n = (μ q η)^(3 / (2q + 3))`, with the Lagrange multiplier μ, the price of a tet. With one q
//! everywhere this is the formula of the paper. The mesher grades and rounds sizes, so μ is set
//! from the numbers of parts that the mesher will realise.
//!
//! # Source
//! Ladevèze and Pelle, optimal meshes; paper, section 4.1.

use bracket_base::math::mandel::Mandel;

/// Bounds of the number of parts of a tet in one pass: the element size changes by ¼ to 2.
pub const PARTS: [f64; 2] = [0.125, 64.0];

/// Step of `ln μ` along a curve: a third more tets where the solution is smooth.
const STEP: f64 = 0.7;

/// Largest number of points of a curve.
const POINTS: usize = 80;

/// Relative tolerance of the number of tets of a design.
const NEAR: f64 = 0.01;

/// Estimates on the last mesh: contribution of each tet to the gap, and the rate at which
/// refinement reduces it.
#[derive(Clone, Debug, PartialEq)]
pub struct Estimate {
    /// Contributions, all in one arbitrary unit.
    pub contributions: Vec<f64>,
    /// Rates q, `η ~ h^(2q)`.
    pub rates: Vec<f64>,
    /// Directions of the next mesh's elements: a tensor for each tet, see
    /// [`crate::refine::directions`]; empty: none are preferred.
    pub directions: Vec<Mandel>,
    /// Fewest parts of a tet; below 1 tets are coarsened where they contribute little.
    pub least_parts: f64,
}

/// The density of a mesh to be made.
#[derive(Clone, Debug, PartialEq)]
pub struct Design {
    /// Number of parts of each tet, before grading.
    pub wanted: Vec<f64>,
    /// Directions of the elements, those of the estimate.
    pub directions: Vec<Mandel>,
    /// Number of tets that it will have.
    pub tets: f64,
    /// Expected gap over the present one.
    pub gap: f64,
}

/// A point of the curve of gap against tets.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Point {
    /// `ln μ`.
    pub price: f64,
    /// Number of tets.
    pub tets: f64,
    /// Gap over the present one.
    pub gap: f64,
}

/// Gap against number of tets of possible next meshes, from coarse to fine.
#[derive(Clone, Debug, PartialEq)]
pub struct Curve {
    points: Vec<Point>,
}

impl Estimate {
    /// Sum of the contributions; those that are negative by rounding count as zero.
    fn total(&self) -> f64 {
        self.contributions.iter().map(|c| c.max(0.0)).sum()
    }

    /// Number of parts of each tet at the multiplier μ.
    fn wanted(&self, mu: f64) -> Vec<f64> {
        let one = |c: &f64, q: &f64| {
            (mu * q * c.max(0.0)).powf(3.0 / (2.0 * q + 3.0)).clamp(self.least_parts, PARTS[1])
        };
        self.contributions.iter().zip(&self.rates).map(|(c, q)| one(c, q)).collect()
    }

    /// Gap over the present one with each tet split into `parts` parts.
    pub fn gap_after(&self, parts: &[f64]) -> f64 {
        let left = |((c, q), n): ((&f64, &f64), &f64)| c.max(0.0) * n.powf(-2.0 * q / 3.0);
        let sum: f64 = self.contributions.iter().zip(&self.rates).zip(parts).map(left).sum();
        let total = self.total();
        if total > 0.0 { sum / total } else { 0.0 }
    }

    fn design(&self, mu: f64, realised: &dyn Fn(&[f64]) -> Vec<f64>) -> Design {
        let wanted = self.wanted(mu);
        let parts = realised(&wanted);
        let directions = self.directions.clone();
        Design { tets: parts.iter().sum(), gap: self.gap_after(&parts), wanted, directions }
    }

    /// The curve from a third of the present tets to `most` tets, within the bounds of one pass;
    /// `realised`: the numbers of parts that the mesher makes of those wanted.
    pub fn curve(&self, most: f64, realised: &dyn Fn(&[f64]) -> Vec<f64>) -> Curve {
        let total = self.total();
        let mut points = Vec::new();
        if total <= 0.0 {
            return Curve { points };
        }
        let raw = |price: f64| self.wanted(price.exp());
        // bisection for the price of a third of the tets, before grading, or of a few more than
        // the fewest
        let few = f64::max(0.35, 1.02 * self.least_parts) * self.contributions.len() as f64;
        let (mut low, mut high) = (-40.0 - total.ln(), 60.0 - total.ln());
        while high - low > 0.1 {
            let middle = 0.5 * (low + high);
            if raw(middle).iter().sum::<f64>() < few { low = middle } else { high = middle }
        }
        let mut price = low;
        while points.len() < POINTS {
            let design = self.design(price.exp(), realised);
            points.push(Point { price, tets: design.tets, gap: design.gap });
            let clipped = design
                .wanted
                .iter()
                .zip(&self.contributions)
                .all(|(n, c)| *c <= 0.0 || *n >= PARTS[1]);
            if design.tets > most || clipped {
                break;
            }
            price += STEP;
        }
        Curve { points }
    }

    /// The design whose number of tets is closest to `tets`, within the bounds of one pass.
    pub fn with_tets(
        &self,
        curve: &Curve,
        tets: f64,
        realised: &dyn Fn(&[f64]) -> Vec<f64>,
    ) -> Design {
        let mut curve = curve.clone();
        let mut best: Option<Design> = None;
        let miss = |d: &Design| (d.tets / tets).ln().abs();
        for _ in 0..4 {
            let Some(price) = curve.price_of(tets) else { break };
            let design = self.design(price.exp(), realised);
            curve.insert(Point { price, tets: design.tets, gap: design.gap });
            if best.as_ref().is_none_or(|b| miss(&design) < miss(b)) {
                best = Some(design);
            }
            if best.as_ref().is_some_and(|b| miss(b) < NEAR) {
                break;
            }
        }
        best.unwrap_or_else(|| self.design(0.0, realised))
    }
}

impl Curve {
    fn insert(&mut self, point: Point) {
        let at = self.points.partition_point(|p| p.price < point.price);
        self.points.insert(at, point);
    }

    /// A quantity of the points at a number of tets: interpolated linearly in `ln tets`, constant
    /// beyond the ends.
    fn at(&self, tets: f64, quantity: impl Fn(&Point) -> f64) -> Option<f64> {
        let after = self.points.partition_point(|p| p.tets < tets);
        let (a, b) =
            match (after.checked_sub(1).and_then(|i| self.points.get(i)), self.points.get(after)) {
                (Some(a), Some(b)) => (a, b),
                (a, b) => return a.or(b).map(quantity),
            };
        let share =
            if b.tets > a.tets { (tets / a.tets).ln() / (b.tets / a.tets).ln() } else { 0.0 };
        Some(quantity(a) + share * (quantity(b) - quantity(a)))
    }

    /// The gap over the present one at a number of tets.
    pub fn gap_at(&self, tets: f64) -> f64 {
        self.at(tets, |p| p.gap.max(1e-30).ln()).map_or(0.0, f64::exp)
    }

    fn price_of(&self, tets: f64) -> Option<f64> {
        self.at(tets, |p| p.price)
    }

    /// Numbers of tets of the coarsest and finest design; `None` where no tet contributes.
    pub fn range(&self) -> Option<[f64; 2]> {
        Some([self.points.first()?.tets, self.points.last()?.tets])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn same(parts: &[f64]) -> Vec<f64> {
        parts.to_vec()
    }

    fn design(estimate: &Estimate, tets: f64) -> Design {
        estimate.with_tets(&estimate.curve(10.0 * tets, &same), tets, &same)
    }

    /// With one rate everywhere and no clipping, the paper's closed formula:
    /// `h' = h e₀^(1/q) / (e^(2/(2q+3)) [Σ e^(6/(2q+3))]^(1/2q))` with e² the contributions and e₀²
    /// the target.
    #[test]
    fn the_formula_of_the_paper() {
        let q = 2.0;
        let contributions: Vec<f64> = (0..200).map(|i| 1.0 + 0.5 * f64::from(i % 7)).collect();
        let total: f64 = contributions.iter().sum();
        let estimate = Estimate {
            contributions: contributions.clone(),
            rates: vec![q; 200],
            directions: vec![],
            least_parts: PARTS[0],
        };
        let design = design(&estimate, 700.0);
        assert!((design.tets / 700.0 - 1.0).abs() < 0.01, "{}", design.tets);
        let e0 = (design.gap * total).sqrt();
        let sum: f64 = contributions.iter().map(|c| c.sqrt().powf(6.0 / (2.0 * q + 3.0))).sum();
        for (c, n) in contributions.iter().zip(&design.wanted) {
            let ratio = e0.powf(1.0 / q)
                / (c.sqrt().powf(2.0 / (2.0 * q + 3.0)) * sum.powf(1.0 / (2.0 * q)));
            assert!((ratio.powi(-3) / n - 1.0).abs() < 1e-9, "{} {n}", ratio.powi(-3));
        }
    }

    /// With different rates: no other distribution of the same number of parts leaves a smaller gap
    /// (compared with random ones).
    #[test]
    fn the_design_is_optimal() {
        let mut seed = 7u64;
        let mut random = || {
            seed ^= seed << 13;
            seed ^= seed >> 7;
            seed ^= seed << 17;
            (seed >> 11) as f64 / (1u64 << 53) as f64
        };
        let contributions: Vec<f64> = (0..60).map(|_| 1.0 + 3.0 * random()).collect();
        let rates: Vec<f64> = (0..60).map(|i| if i % 5 == 0 { 0.55 } else { 2.0 }).collect();
        let estimate = Estimate { contributions, rates, directions: vec![], least_parts: PARTS[0] };
        let design = design(&estimate, 180.0);
        assert!(design.wanted.iter().all(|n| *n > PARTS[0] && *n < PARTS[1]), "not clipped");
        for _ in 0..200 {
            let mut other: Vec<f64> =
                design.wanted.iter().map(|n| n * (1.0 + 0.2 * (random() - 0.5))).collect();
            let scale = design.tets / other.iter().sum::<f64>();
            other.iter_mut().for_each(|n| *n *= scale);
            assert!(estimate.gap_after(&other) >= design.gap * (1.0 - 1e-12));
        }
    }

    /// Finer meshes leave smaller gaps; a goal beyond one pass gives the finest mesh of one pass;
    /// without contributions the curve is empty.
    #[test]
    fn goals_out_of_reach() {
        let estimate = Estimate {
            contributions: vec![1.0; 10],
            rates: vec![0.5; 10],
            directions: vec![],
            least_parts: PARTS[0],
        };
        let curve = estimate.curve(1e9, &same);
        let [few, many] = curve.range().expect("a curve");
        assert!(few < 4.0 && many == 640.0, "{few} {many}");
        assert!(
            [4.0, 10.0, 40.0, 640.0, 1e9].map(|n| curve.gap_at(n)).windows(2).all(|g| g[1] <= g[0])
        );
        // h^(2q) with twice the tets along each side
        assert!((curve.gap_at(80.0) - 0.5).abs() < 0.01, "{}", curve.gap_at(80.0));
        assert!(estimate.with_tets(&curve, 1e9, &same).wanted.iter().all(|n| *n == PARTS[1]));
        let nothing = Estimate {
            contributions: vec![0.0; 10],
            rates: vec![2.0; 10],
            directions: vec![],
            least_parts: PARTS[0],
        };
        assert_eq!(nothing.curve(1e9, &same).range(), None);
        // a contribution that is negative by rounding needs no parts
        let estimate = Estimate {
            contributions: vec![1.0, -1e-17],
            rates: vec![2.0; 2],
            directions: vec![],
            least_parts: PARTS[0],
        };
        assert_eq!(design(&estimate, 8.0).wanted[1], PARTS[0]);
    }
}
