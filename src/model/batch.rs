//! Elements that yield as dense data, eight of one shape side by side.
//!
//! Such an element joins displacements v, shared with other elements or of its own, to parameters σ of its stress:
//! minimise over v, maximise over σ of `vᵀ T σ − ½ σᵀ F σ`, the parameters kept in the yield set at some points,
//! `(1, b_j + B_j σ) ∈ K⁶`. Parameters are normalised so that the yield radius is 1. Rigid-plastic elements have F = 0.
//!
//! # Shapes
//! - [`Shape::Stress`]: the static super-element, 30 parameters, 16 points.
//! - [`Shape::Flow`]: the kinematic element, one or four (sub)tets with linear strain. The parameters are deviatoric
//!   stresses at the points of a quadrature rule, times their weights; `T` is the strain there. A rigid-plastic element
//!   has further parameters without a yield condition, the pressures that hold its volume.
//!
//! # Layout
//! Eight elements are interleaved, entry by entry, so that every operation runs on the eight at once.

use pulp::Arch;

/// Elements side by side.
pub const LANES: usize = 8;
/// One entry of eight elements.
pub type Lane = [f64; LANES];
/// No unknown, no element.
pub const NONE: u32 = u32::MAX;
/// Rows of a von Mises cone: its axis and the five components of a deviator.
pub const YIELD_ROWS: usize = 6;
/// Components of a deviator.
const DEVIATOR: usize = 5;
/// Values of a linear deviator in a (sub)tet: 5 at each of its 4 vertices.
pub const VERTEX_VALUES: usize = 4 * DEVIATOR;

/// Where a (sub)tet with linear strain may yield, and whether it is elastic before.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Rule {
    /// Elastic, perfectly plastic (Hencky): exact elastic energy, dissipation by the vertex rule.
    Hencky,
    /// Rigid-plastic, dissipation by the rule of the 8 sub-subtets: 4 vertices, 6 mid-sides.
    TenPoints,
}

/// The ten points as means of the vertices times their weights: `V/32` at vertices, `7 V/48` at mid-sides.
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
/// The vertices, `V/4` each.
const FOUR_POINTS: [[f64; 4]; 4] =
    [[0.25, 0.0, 0.0, 0.0], [0.0, 0.25, 0.0, 0.0], [0.0, 0.0, 0.25, 0.0], [0.0, 0.0, 0.0, 0.25]];

impl Rule {
    /// Weight of each vertex value at each point.
    pub fn points(self) -> &'static [[f64; 4]] {
        match self {
            Rule::Hencky => &FOUR_POINTS,
            Rule::TenPoints => &TEN_POINTS,
        }
    }
}

/// Kind and sizes of an element.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Shape {
    /// Linear stress in four subtets.
    Stress,
    /// Linear strain in `subtets` (1 or 4) tets.
    Flow {
        /// Number of tets.
        subtets: usize,
        /// Where they yield.
        rule: Rule,
        /// Displacements of the element's own.
        inner: usize,
        /// Pressures.
        pressures: usize,
    },
}

impl Shape {
    /// Yield points.
    pub fn points(self) -> usize {
        match self {
            Shape::Stress => 16,
            Shape::Flow { subtets, rule, .. } => subtets * rule.points().len(),
        }
    }

    /// Parameters.
    pub fn parameters(self) -> usize {
        match self {
            Shape::Stress => 30,
            Shape::Flow { pressures, .. } => DEVIATOR * self.points() + pressures,
        }
    }

    /// Displacements of the element's own; they come before the shared ones.
    pub fn inner(self) -> usize {
        match self {
            Shape::Stress => 0,
            Shape::Flow { inner, .. } => inner,
        }
    }

    /// Parts of the data of an element that meets `k` shared unknowns.
    fn parts(self, k: usize) -> Parts {
        let all = self.inner() + k;
        match self {
            Shape::Stress => Parts { strain: 30 * k, flexibility: 30 * 31 / 2, volume: 80 * 30, inner: 0 },
            Shape::Flow { subtets, inner, pressures, .. } => Parts {
                strain: subtets * VERTEX_VALUES * all,
                flexibility: subtets,
                volume: pressures * k,
                inner: inner * all,
            },
        }
    }

    /// Length of the data of an element that meets `k` shared unknowns.
    pub fn len(self, k: usize) -> usize {
        let p = self.parts(k);
        p.strain + p.flexibility + p.volume + p.inner
    }
}

/// Lengths of the parts of an element's data.
struct Parts {
    strain: usize,
    flexibility: usize,
    volume: usize,
    inner: usize,
}

/// One element before it is laid beside others.
///
/// # Shape
/// `data` is, one part after the other:
/// - `Stress`: `Tᵀ` (30 × k), F (lower triangle by columns), B (16 × 5 × 30);
/// - `Flow`: strain (per subtet 20 × (inner + k): component a at vertex v is row `5 v + a`) times volume and yield
///   radius; per subtet the scalar f of its flexibility `f (20 δ_vw − 4)`, 0 for rigid-plastic; rows of the pressures
///   (k each); stiffness of the inner displacements beside the flow (column by column, inner + k rows).
#[derive(Clone, Debug, PartialEq)]
pub struct YieldingElement {
    /// Kind and sizes.
    pub shape: Shape,
    /// The k shared unknowns it meets; `NONE`: held.
    pub columns: Vec<u32>,
    /// Its matrices.
    pub data: Vec<f64>,
    /// Linear terms of its own unknowns: parameters, then inner displacements.
    pub q: Vec<f64>,
    /// Offsets of its yield points, `(1, b_j)` each.
    pub h: Vec<f64>,
    /// Stiffness that measures its inner displacements \[N/mm\].
    pub inner_stiffness: Vec<f64>,
}

/// An element, its first own unknown and its first yield row.
pub type Placed = (YieldingElement, u32, u32);

/// Up to eight elements of one shape.
#[derive(Clone, Debug, PartialEq)]
pub struct Batch {
    /// Kind and sizes.
    pub shape: Shape,
    /// Shared unknowns met, `[position][lane]`.
    pub columns: Vec<[u32; LANES]>,
    /// First own unknown of each lane; `NONE`: empty lane.
    pub own: [u32; LANES],
    /// First yield row of each lane.
    pub rows: [u32; LANES],
    /// Matrices, see [`YieldingElement`].
    pub data: Vec<Lane>,
}

/// `y += A x`, A by rows.
#[inline(always)]
fn times(a: &[Lane], x: &[Lane], y: &mut [Lane]) {
    let n = x.len();
    for (row, y) in a.chunks_exact(n).zip(y) {
        let mut sum = *y;
        for (a, x) in row.iter().zip(x) {
            for l in 0..LANES {
                sum[l] += a[l] * x[l];
            }
        }
        *y = sum;
    }
}

/// `y += Aᵀ x`, A by rows.
#[inline(always)]
fn times_transposed(a: &[Lane], x: &[Lane], y: &mut [Lane]) {
    let n = y.len();
    for (row, x) in a.chunks_exact(n).zip(x) {
        for (a, y) in row.iter().zip(&mut *y) {
            for l in 0..LANES {
                y[l] += a[l] * x[l];
            }
        }
    }
}

/// `y += S x`, the lower triangle of S by columns.
#[inline(always)]
fn times_symmetric(s: &[Lane], x: &[Lane], y: &mut [Lane]) {
    let n = x.len();
    let mut at = 0;
    for c in 0..n {
        for r in c..n {
            for l in 0..LANES {
                y[r][l] += s[at][l] * x[c][l];
                if r != c {
                    y[c][l] += s[at][l] * x[r][l];
                }
            }
            at += 1;
        }
    }
}

impl Batch {
    /// Lays elements of one shape side by side; each has its first own unknown and its first row.
    pub fn new(elements: &[Placed]) -> Self {
        let first = &elements[0].0;
        // empty lanes repeat the first element: whatever is regular there is regular here
        let lanes = |of: &dyn Fn(&YieldingElement) -> f64| -> Lane {
            std::array::from_fn(|l| of(&elements.get(l).unwrap_or(&elements[0]).0))
        };
        let place =
            |of: &dyn Fn(&Placed) -> u32| -> [u32; LANES] { std::array::from_fn(|l| elements.get(l).map_or(NONE, of)) };
        Self {
            shape: first.shape,
            columns: (0..first.columns.len()).map(|i| place(&|e| e.0.columns[i])).collect(),
            own: place(&|e| e.1),
            rows: place(&|e| e.2),
            data: (0..first.data.len()).map(|i| lanes(&|e| e.data[i])).collect(),
        }
    }

    /// Shared unknowns an element meets.
    pub fn shared(&self) -> usize {
        self.columns.len()
    }

    /// First inner displacement of each lane among the unknowns; `NONE`: empty lane.
    pub fn inner_own(&self) -> [u32; LANES] {
        let parameters = self.shape.parameters() as u32;
        self.own.map(|own| if own == NONE { NONE } else { own + parameters })
    }

    /// Displacements of an element: its own, then the shared ones.
    pub fn displacements(&self) -> usize {
        self.shape.inner() + self.columns.len()
    }

    /// Strain (or `Tᵀ`), flexibility, pressures (or B), inner stiffness.
    pub fn parts(&self) -> [&[Lane]; 4] {
        let p = self.shape.parts(self.shared());
        let (strain, rest) = self.data.split_at(p.strain);
        let (flexibility, rest) = rest.split_at(p.flexibility);
        let (volume, inner) = rest.split_at(p.volume);
        [strain, flexibility, volume, inner]
    }

    /// `Tᵀ v`, v the element's displacements.
    pub fn strain(&self, v: &[Lane]) -> Vec<Lane> {
        let mut out = vec![[0.0; LANES]; self.shape.parameters()];
        let [strain, _, volume, _] = self.parts();
        Arch::new().dispatch(
            #[inline(always)]
            || match self.shape {
                Shape::Stress => times(strain, v, &mut out),
                Shape::Flow { rule, inner, .. } => {
                    let points = rule.points();
                    let mut at = 0;
                    for part in strain.chunks_exact(VERTEX_VALUES * v.len()) {
                        let mut e = [[0.0; LANES]; VERTEX_VALUES];
                        times(part, v, &mut e);
                        for weights in points {
                            for (vertex, &w) in weights.iter().enumerate().filter(|w| *w.1 != 0.0) {
                                for a in 0..DEVIATOR {
                                    for l in 0..LANES {
                                        out[at + a][l] += w * e[DEVIATOR * vertex + a][l];
                                    }
                                }
                            }
                            at += DEVIATOR;
                        }
                    }
                    times(volume, &v[inner..], &mut out[at..]);
                }
            },
        );
        out
    }

    /// `v += T σ`.
    pub fn add_force(&self, sigma: &[Lane], v: &mut [Lane]) {
        let [strain, _, volume, _] = self.parts();
        Arch::new().dispatch(
            #[inline(always)]
            || match self.shape {
                Shape::Stress => times_transposed(strain, sigma, v),
                Shape::Flow { rule, inner, .. } => {
                    let points = rule.points();
                    let mut at = 0;
                    for part in strain.chunks_exact(VERTEX_VALUES * v.len()) {
                        let mut s = [[0.0; LANES]; VERTEX_VALUES];
                        for weights in points {
                            for (vertex, &w) in weights.iter().enumerate().filter(|w| *w.1 != 0.0) {
                                for a in 0..DEVIATOR {
                                    for l in 0..LANES {
                                        s[DEVIATOR * vertex + a][l] += w * sigma[at + a][l];
                                    }
                                }
                            }
                            at += DEVIATOR;
                        }
                        times_transposed(part, &s, v);
                    }
                    times_transposed(volume, &sigma[at..], &mut v[inner..]);
                }
            },
        );
    }

    /// `out −= F σ`.
    pub fn subtract_flexibility(&self, sigma: &[Lane], out: &mut [Lane]) {
        let flexibility = self.parts()[1];
        match self.shape {
            Shape::Stress => {
                let mut y = vec![[0.0; LANES]; sigma.len()];
                Arch::new().dispatch(
                    #[inline(always)]
                    || times_symmetric(flexibility, sigma, &mut y),
                );
                out.iter_mut().zip(&y).for_each(|(o, y)| (0..LANES).for_each(|l| o[l] -= y[l]));
            }
            Shape::Flow { rule: Rule::Hencky, .. } => {
                for (g, f) in flexibility.iter().enumerate() {
                    let at = g * VERTEX_VALUES;
                    for a in 0..DEVIATOR {
                        for l in 0..LANES {
                            let sum: f64 = (0..4).map(|v| sigma[at + DEVIATOR * v + a][l]).sum();
                            for v in 0..4 {
                                let i = at + DEVIATOR * v + a;
                                out[i][l] -= f[l] * (20.0 * sigma[i][l] - 4.0 * sum);
                            }
                        }
                    }
                }
            }
            Shape::Flow { .. } => {}
        }
    }

    /// `v += K v` of the inner displacements' stiffness.
    pub fn add_inner(&self, x: &[Lane], v: &mut [Lane]) {
        let (inner, all) = (self.shape.inner(), self.displacements());
        for (c, column) in self.parts()[3].chunks_exact(all.max(1)).enumerate().take(inner) {
            for r in 0..all {
                for l in 0..LANES {
                    v[r][l] += column[r][l] * x[c][l];
                    // the inner block is stored whole, its couplings once
                    if r >= inner {
                        v[c][l] += column[r][l] * x[r][l];
                    }
                }
            }
        }
    }

    /// Deviators `B σ` at the points, five values each.
    pub fn deviators(&self, sigma: &[Lane]) -> Vec<Lane> {
        match self.shape {
            Shape::Stress => {
                let mut out = vec![[0.0; LANES]; DEVIATOR * self.shape.points()];
                let b = self.parts()[2];
                Arch::new().dispatch(
                    #[inline(always)]
                    || times(b, sigma, &mut out),
                );
                out
            }
            Shape::Flow { .. } => sigma[..DEVIATOR * self.shape.points()].to_vec(),
        }
    }

    /// `out += Bᵀ d`, five values at each point.
    pub fn add_deviators(&self, d: &[Lane], out: &mut [Lane]) {
        match self.shape {
            Shape::Stress => {
                let b = self.parts()[2];
                Arch::new().dispatch(
                    #[inline(always)]
                    || times_transposed(b, d, out),
                );
            }
            Shape::Flow { .. } => {
                out.iter_mut().zip(d).for_each(|(o, d)| (0..LANES).for_each(|l| o[l] += d[l]));
            }
        }
    }

    /// The element's displacements of the program's unknowns `x`; `scale` multiplies shared and inner ones (empty: 1).
    pub fn gather_displacements(&self, x: &[f64], scale: &[f64]) -> Vec<Lane> {
        let value = |i: u32| match i {
            NONE => 0.0,
            i if scale.is_empty() => x[i as usize],
            i => x[i as usize] * scale[i as usize],
        };
        let first = self.inner_own();
        let inner = (0..self.shape.inner() as u32).map(|i| first.map(|f| if f == NONE { NONE } else { f + i }));
        inner.chain(self.columns.iter().copied()).map(|c| c.map(value)).collect()
    }

    /// Adds forces on the element's displacements to `y`.
    pub fn scatter_displacements(&self, v: &[Lane], scale: &[f64], y: &mut [f64]) {
        let (inner, first) = (self.shape.inner(), self.shape.parameters());
        for (i, lanes) in v.iter().enumerate() {
            for l in 0..LANES {
                if self.own[l] == NONE {
                    continue;
                }
                let at = if i < inner { self.own[l] + (first + i) as u32 } else { self.columns[i - inner][l] };
                if at != NONE {
                    y[at as usize] += lanes[l] * if scale.is_empty() { 1.0 } else { scale[at as usize] };
                }
            }
        }
    }

    /// The `count` values of `x` from each lane's `first` on; zero in empty lanes.
    pub fn gather(first: &[u32; LANES], count: usize, x: &[f64]) -> Vec<Lane> {
        let mut out = vec![[0.0; LANES]; count];
        for l in (0..LANES).filter(|&l| first[l] != NONE) {
            let at = first[l] as usize;
            out.iter_mut().zip(&x[at..at + count]).for_each(|(o, x)| o[l] = *x);
        }
        out
    }

    /// Adds values to `y` from each lane's `first` on.
    pub fn scatter(first: &[u32; LANES], values: &[Lane], y: &mut [f64]) {
        for l in (0..LANES).filter(|&l| first[l] != NONE) {
            let at = first[l] as usize;
            values.iter().zip(&mut y[at..at + values.len()]).for_each(|(v, y)| *y += v[l]);
        }
    }

    /// Parameters of the elements.
    pub fn gather_parameters(&self, x: &[f64]) -> Vec<Lane> {
        Self::gather(&self.own, self.shape.parameters(), x)
    }

    /// The lower triangle of F by columns of one lane, normalised parameters.
    pub fn flexibility_of(&self, lane: usize, r: usize, c: usize) -> f64 {
        let flexibility = self.parts()[1];
        let (r, c) = (r.max(c), r.min(c));
        match self.shape {
            Shape::Stress => flexibility[c * 30 - c * c.saturating_sub(1) / 2 + r - c][lane],
            Shape::Flow { rule: Rule::Hencky, .. } => {
                let same = r / VERTEX_VALUES == c / VERTEX_VALUES && r % DEVIATOR == c % DEVIATOR;
                let diagonal = if r == c { 20.0 } else { 0.0 };
                if same { flexibility[r / VERTEX_VALUES][lane] * (diagonal - 4.0) } else { 0.0 }
            }
            Shape::Flow { .. } => 0.0,
        }
    }
}
