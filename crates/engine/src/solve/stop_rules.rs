//! When a solve ends: the tolerances of every kind of analysis, and when the interior-point method
//! gives up. Each number has the measurement behind it.

/// When a solve ends.
///
/// Bounds are certified from the fields alone, so that these numbers decide the time of a solve and
/// the width of a bracket, never whether a bound is right.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StopRules {
    /// Relative duality gap at which a solve is optimal.
    pub gap: f64,
    /// The same for limit analysis.
    pub limit_gap: f64,
    /// Relative residual at which a solve is optimal.
    pub residual: f64,
    /// Residual of limit analysis, relative to its gap.
    ///
    /// Unbalanced stresses reduce the lower bound. Measured on three bolted joints at a gap of
    /// 1e-4: by 3e-5 to 5e-4 of the bound. 1e-2 reduces it by at most 4e-5 and takes 20 to 42 %
    /// longer; 1 reduces it by up to 4e-3. The upper bound is 0 to 4e-4 higher than with 1e-2.
    pub limit_residual: f64,
    /// Relative imbalance of forces, and error of strains, that is allowed where it exceeds
    /// `residual`.
    pub unbalanced: f64,
    /// The same in a solve for the velocities of limit analysis, relative to its gap.
    ///
    /// The upper bound is computed from the velocities alone, whose cones hold long before the
    /// stresses balance. Measured on the joint: 8e-5 of the upper bound, after a third of the
    /// iterations.
    pub mechanism_unbalanced: f64,
    /// Least gap and residual of a solve with yield conditions in elastic, perfectly plastic
    /// analysis; the recovery makes the fields admissible from there.
    pub yielding: f64,
    /// Least gap and least residual of a rough elastic solution, which only shows where yield
    /// conditions are needed.
    pub rough: (f64, f64),
    /// Least gap and residual that Clarabel is asked for: below, it usually stops at its rounding
    /// errors.
    pub clarabel: f64,
    /// Largest number of iterations.
    pub max_iterations: u32,
    /// An iterate that stalls within this many times the tolerances is almost optimal.
    pub nearly: f64,
    /// The same in limit analysis, whose tolerances are coarse already.
    pub limit_nearly: f64,
    /// The same where the time ends, or where an iteration of limit analysis crawls: a bound is
    /// strict at any iterate, and only as good as it. T-stub on 23 720 tets: at 66 tolerances after
    /// 15 of 66 iterations, the others with steps of 0.02.
    pub limit_cut_off: f64,
    /// An iteration of limit analysis crawls where this number of iterations leaves more than this
    /// fraction of the excess over the tolerances. 148 other solves left 0.22 or less.
    pub crawl: (usize, f64),
    /// Iterations without a better iterate that end the solve once one is almost optimal: the limit
    /// of the arithmetic.
    pub not_better: u32,
    /// Steps shorter than this make no progress.
    pub short_step: f64,
    /// Number of short steps in a row that ends the solve.
    pub short_steps: u32,
    /// Largest residual of a certificate of unboundedness or infeasibility, however coarse the
    /// tolerance of a solution is.
    pub certain: f64,
    /// A certificate is accepted with residuals `decided.0` times larger once κ > `decided.1` τ:
    /// the embedding has decided.
    pub decided: (f64, f64),
}

impl Default for StopRules {
    fn default() -> Self {
        Self {
            gap: 1e-8,
            limit_gap: 1e-4,
            residual: 1e-8,
            limit_residual: 1e-1,
            unbalanced: 0.0,
            mechanism_unbalanced: 10.0,
            yielding: 1e-7,
            rough: (2e-2, 5e-3),
            clarabel: 1e-8,
            max_iterations: 100,
            nearly: 100.0,
            limit_nearly: 10.0,
            limit_cut_off: 100.0,
            crawl: (5, 0.5),
            not_better: 2,
            short_step: 1e-3,
            short_steps: 3,
            certain: 1e-8,
            decided: (100.0, 1e3),
        }
    }
}

impl StopRules {
    /// The default rules with another relative gap.
    pub fn to_gap(gap: f64) -> Self {
        Self { gap, ..Self::default() }
    }

    /// The default rules with another relative gap of limit analysis.
    pub fn to_limit_gap(limit_gap: f64) -> Self {
        Self { limit_gap, ..Self::default() }
    }

    /// For a pass of limit analysis whose mesh is to be refined: stresses as unbalanced as the gap.
    ///
    /// First meshes of two bolted joints: 18 iterations for 24 and 17 for 19; the lower bound is
    /// lower by 5e-4 and 1e-4. 3 and 10 save one and two more, at 2e-3.
    pub fn to_be_refined() -> Self {
        Self { limit_residual: 1.0, ..Self::default() }
    }

    /// For a pass of limit analysis; `refined`: its mesh is to be refined.
    pub fn on_mesh(refined: bool) -> Self {
        if refined { Self::to_be_refined() } else { Self::default() }
    }

    /// For a direction of a polygon on a single mesh, whose bracket is tens of percent wide.
    pub fn of_direction() -> Self {
        Self { limit_gap: 1e-3, ..Self::to_be_refined() }
    }

    /// For the stresses of limit analysis.
    pub fn for_resistance(&self) -> Self {
        let residual = self.residual.max(self.limit_residual * self.limit_gap);
        Self { gap: self.limit_gap, residual, ..*self }
    }

    /// For the velocities of limit analysis.
    pub fn for_mechanism(&self) -> Self {
        let unbalanced = self.mechanism_unbalanced * self.limit_gap;
        Self { unbalanced, ..self.for_resistance() }
    }

    /// For the yield conditions of elastic, perfectly plastic analysis.
    pub fn for_yielding(&self) -> Self {
        let [gap, residual] = [self.gap, self.residual].map(|t| t.max(self.yielding));
        Self { gap, residual, ..*self }
    }

    /// For a rough elastic solution.
    pub fn for_rough(&self) -> Self {
        let (gap, residual) = (self.gap.max(self.rough.0), self.residual.max(self.rough.1));
        Self { gap, residual, ..*self }
    }

    /// Whether an iteration crawls: `best` are the smallest excesses over the tolerances after each
    /// iteration.
    pub fn crawls(&self, best: &[f64]) -> bool {
        let (window, part) = self.crawl;
        let Some(before) = best.len().checked_sub(window + 1) else { return false };
        best[best.len() - 1] > part * best[before]
    }

    /// Times the tolerances within which an iterate that stalls is almost optimal; `limit`: the
    /// program has a load factor.
    pub fn nearly(&self, limit: bool) -> f64 {
        if limit { self.limit_nearly } else { self.nearly }
    }

    /// The same where the time ends or the iteration crawls.
    pub fn cut_off(&self, limit: bool) -> f64 {
        if limit { self.limit_cut_off } else { 0.0 }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Five iterations that halve the excess go on; those that gain less crawl.
    #[test]
    fn crawling() {
        let rules = StopRules::default();
        let excess = |factor: f64| -> Vec<f64> { (0..6).map(|i| 50.0 * factor.powi(i)).collect() };
        assert!(rules.crawls(&excess(0.9)));
        assert!(!rules.crawls(&excess(0.85)));
        assert!(!rules.crawls(&excess(0.9)[..5]), "too few iterations to tell");
    }
}
