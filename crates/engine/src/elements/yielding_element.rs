//! Elements that yield as dense data.
//!
//! A yielding element couples displacements v, shared with other elements or its own, with stress
//! parameters σ: minimise over v and maximise over σ the form `vᵀ T σ − ½ σᵀ F σ`, the parameters
//! restricted to the yield set at some points, `(1, b_j + B_j σ) ∈ K⁶`. Parameters are normalised
//! so that the yield radius is 1. Rigid-plastic elements have F = 0.
//!
//! # Shapes
//! - [`Shape::Stress`]: the static super-element, 30 parameters, 16 points.
//! - [`Shape::Flow`]: the kinematic element, one or four (sub)tets with linear strain. The
//!   parameters are deviatoric stresses at the points of a quadrature rule, times their weights;
//!   `T` is the strain there. A rigid-plastic element has further parameters without a yield
//!   condition: the pressures that enforce constant volume.

/// Marks a held unknown or an empty lane.
pub const NONE: u32 = u32::MAX;
/// Rows of a von Mises cone: its axis and the five components of a deviator.
pub const YIELD_ROWS: usize = 6;
/// Components of a deviator.
pub const DEVIATOR: usize = 5;
/// Values of a linear deviator in a (sub)tet: 5 at each of its 4 vertices.
pub const VERTEX_VALUES: usize = 4 * DEVIATOR;

/// Points at which a (sub)tet with linear strain may yield, and whether it is elastic below yield.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Rule {
    /// Elastic, perfectly plastic (Hencky): exact elastic energy, dissipation by the vertex rule.
    Hencky,
    /// Rigid-plastic, dissipation by the rule of the 8 sub-subtets: 4 vertices, 6 mid-sides. An
    /// upper bound of the dissipation.
    TenPoints,
    /// Rigid-plastic, dissipation by Gauss's rule of degree two, four points inside. Four points
    /// determine a linear strain, so no flow escapes them. The rule is no bound of the dissipation:
    /// the certificate computes one from the velocities.
    Gauss,
    /// Rigid-plastic at the vertices: faces of welds, see [`crate::programs::weld_face`].
    Vertices,
}

/// The ten points as means of the vertices, times their weights: `V/32` at vertices, `7 V/48` at
/// mid-sides.
const TEN_POINTS: [[f64; 4]; 10] = {
    const V: f64 = 1.0 / 32.0;
    const M: f64 = 7.0 / 96.0;
    [
        [V, 0.0, 0.0, 0.0],
        [0.0, V, 0.0, 0.0],
        [0.0, 0.0, V, 0.0],
        [0.0, 0.0, 0.0, V],
        [M, M, 0.0, 0.0],
        [M, 0.0, M, 0.0],
        [M, 0.0, 0.0, M],
        [0.0, M, M, 0.0],
        [0.0, M, 0.0, M],
        [0.0, 0.0, M, M],
    ]
};
/// Four points inside as means of the vertices, times their weights `V/4`: exact for quadratic
/// functions.
const GAUSS_POINTS: [[f64; 4]; 4] = {
    // (5 + 3 √5)/20 and (5 − √5)/20, a quarter each
    const A: f64 = 0.585_410_196_624_968_5 / 4.0;
    const B: f64 = 0.138_196_601_125_010_5 / 4.0;
    [[A, B, B, B], [B, A, B, B], [B, B, A, B], [B, B, B, A]]
};
/// The vertices, `V/4` each.
const FOUR_POINTS: [[f64; 4]; 4] =
    [[0.25, 0.0, 0.0, 0.0], [0.0, 0.25, 0.0, 0.0], [0.0, 0.0, 0.25, 0.0], [0.0, 0.0, 0.0, 0.25]];

impl Rule {
    /// Weight of each vertex value at each point.
    pub fn points(self) -> &'static [[f64; 4]] {
        match self {
            Rule::Hencky | Rule::Vertices => &FOUR_POINTS,
            Rule::TenPoints => &TEN_POINTS,
            Rule::Gauss => &GAUSS_POINTS,
        }
    }
}

/// Kind and sizes of an element.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Shape {
    /// Linear stress in four subtets.
    Stress,
    /// Linear strain in one tet or in four subtets.
    Flow {
        /// Number of (sub)tets, 1 or 4.
        subtets: usize,
        /// Points at which they yield.
        rule: Rule,
        /// Number of the element's own displacements.
        inner: usize,
        /// Number of pressures.
        pressures: usize,
    },
}

impl Shape {
    /// Number of yield points.
    pub fn points(self) -> usize {
        match self {
            Shape::Stress => 16,
            Shape::Flow { subtets, rule, .. } => subtets * rule.points().len(),
        }
    }

    /// Number of parameters.
    pub fn parameters(self) -> usize {
        match self {
            Shape::Stress => 30,
            Shape::Flow { pressures, .. } => DEVIATOR * self.points() + pressures,
        }
    }

    /// Number of the element's own displacements; they come before the shared ones.
    pub fn inner(self) -> usize {
        match self {
            Shape::Stress => 0,
            Shape::Flow { inner, .. } => inner,
        }
    }

    /// Lengths of the parts of the data of an element with `k` shared unknowns.
    pub fn parts(self, k: usize) -> Parts {
        let all = self.inner() + k;
        match self {
            Shape::Stress => {
                Parts { strain: 30 * k, flexibility: 30 * 31 / 2, volume: 80 * 30, inner: 0 }
            }
            Shape::Flow { subtets, inner, pressures, .. } => Parts {
                strain: subtets * VERTEX_VALUES * all,
                flexibility: subtets,
                volume: pressures * k,
                inner: inner * all,
            },
        }
    }

    /// Length of the data of an element with `k` shared unknowns.
    pub fn len(self, k: usize) -> usize {
        let p = self.parts(k);
        p.strain + p.flexibility + p.volume + p.inner
    }
}

/// Lengths of the parts of an element's data, in their order.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Parts {
    /// Strain, or `Tᵀ` of the super-element.
    pub strain: usize,
    /// Flexibility F.
    pub flexibility: usize,
    /// Rows of the pressures, or B of the super-element.
    pub volume: usize,
    /// Stiffness of the inner displacements.
    pub inner: usize,
}

/// One element, before it is interleaved with others.
///
/// # Shape
/// `data` holds, one part after the other:
/// - `Stress`: `Tᵀ` (30 × k), F (lower triangle by columns), B (16 × 5 × 30);
/// - `Flow`: strain (per subtet 20 × (inner + k): component a at vertex v is row `5 v + a`) times
///   volume and yield radius; per subtet the scalar f of its flexibility `f (20 δ_vw − 4)`, 0 for
///   rigid-plastic; rows of the pressures (k each); stiffness of the inner displacements against a
///   change of volume (column by column, inner + k rows).
#[derive(Clone, Debug, PartialEq)]
pub struct YieldingElement {
    /// Kind and sizes.
    pub shape: Shape,
    /// Its k shared unknowns; `NONE`: held.
    pub columns: Vec<u32>,
    /// Its matrices.
    pub data: Vec<f64>,
    /// The numbers from which products with its matrices follow ([`super::flow_maps`],
    /// [`super::stress_maps`]); empty: its columns are no plain nodes or faces, or its kind has no
    /// such numbers.
    pub maps: Vec<f64>,
    /// Linear terms of its own unknowns: parameters, then inner displacements.
    pub q: Vec<f64>,
    /// Offsets of its yield points, `(1, b_j)` each.
    pub h: Vec<f64>,
    /// Elastic stiffness that scales its inner displacements \[N/mm\].
    pub inner_stiffness: Vec<f64>,
}
