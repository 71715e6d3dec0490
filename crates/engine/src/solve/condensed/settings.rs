//! Settings of the interior-point iteration, each with its meaning and the measurement behind it.

/// Settings of the iteration; elastic and limit analysis differ in three of them. When
/// it ends is in [`crate::solve::StopRules`].
pub struct Settings {
    /// Fraction of the way to the surface of the cones that a step may go.
    pub fraction_to_boundary: f64,
    /// Largest number of refinement passes on the full system.
    pub refinements: usize,
    /// A refinement pass that leaves this fraction of the error or more is the last.
    pub stalled: f64,
    /// Error of a direction's stationarity rows that needs no refinement, as a fraction of the
    /// residual that the direction removes.
    ///
    /// In limit analysis a refinement costs a tenth of the iteration. The larger value there takes
    /// as many iterations and an eighth fewer solves.
    pub direction_error: f64,
    /// Error of a direction's stationarity rows that rounding explains, relative to their terms.
    pub rounding: f64,
    /// Largest number of centrality correctors in an iteration. In limit analysis contacts end
    /// steps early, so that more of them pay.
    pub correctors: usize,
    /// Operations of a factorisation for each nonzero of the factor from which correctors pay: a
    /// solve with its products then costs less than a tenth of a factorisation. Limit analysis
    /// always uses correctors.
    pub dense_factor: f64,
    /// Fractions of the second-order term that limit analysis tries.
    pub second_order: [f64; 6],
    /// Steps of this length or more need no corrector.
    pub long_step: f64,
    /// Increase of the step that a corrector aims at.
    pub longer: f64,
    /// Fraction of that increase that a corrector must gain.
    pub worth: f64,
    /// Complementarity products within these multiples of the target are well centred.
    pub centre: (f64, f64),
    /// Fraction of the load factor at first yield below which a load factor counts as zero. Gap and
    /// residuals are measured there by their size at that fraction: where the stresses of a mesh
    /// carry no load at all, forces and objective vanish together.
    pub nothing: f64,
    /// Contact velocities at the start of limit analysis, relative to the mean of the yield points.
    ///
    /// Most contacts of a mechanism open, at hundreds of times that velocity. Started alike, each
    /// of them has to lose its pressure on the way, and a few at a time end the steps. Static
    /// program of the paper's joint with 13 000 tets: 47 iterations with (1, 1), 26 with
    /// (`opening`, `pressure`) = (100, 0.1), 31 with (30, 0.1). (100, 0.01) takes an eighth to a
    /// quarter more iterations than (100, 0.1) on other joints.
    pub opening: f64,
    /// Contact pressures at the start of limit analysis, relative to the mean of the yield points;
    /// measured with `opening`.
    pub pressure: f64,
    /// Elastic stress at unit load factor below which the loads count as stressing nothing, so that
    /// there is no load factor at first yield.
    pub unstressed: f64,
    /// Relative increase of the diagonal when a factorisation fails, for a second attempt.
    pub raised_diagonal: f64,
}

impl Settings {
    /// Elastic analysis and elastic, perfectly plastic analysis.
    pub const ELASTIC: Self = Self {
        fraction_to_boundary: 0.99,
        refinements: 6,
        stalled: 0.9,
        direction_error: 0.01,
        rounding: 1e-13,
        correctors: 2,
        dense_factor: 1500.0,
        second_order: [1.0, 0.75, 0.5, 0.25, 0.1, 0.0],
        long_step: 0.97,
        longer: 0.3,
        worth: 0.1,
        centre: (0.1, 10.0),
        nothing: 1e-3,
        opening: 100.0,
        pressure: 0.1,
        unstressed: 1e-9,
        raised_diagonal: 1e-10,
    };

    /// Limit analysis.
    pub const LIMIT: Self =
        Self { direction_error: 0.1, correctors: 8, dense_factor: 0.0, ..Self::ELASTIC };

    /// Settings of a program; `limit`: the program has a load factor.
    pub fn of(limit: bool) -> &'static Self {
        if limit { &Self::LIMIT } else { &Self::ELASTIC }
    }
}
