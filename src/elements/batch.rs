//! Elements that yield as dense data, eight of one shape side by side.
//!
//! Such an element joins displacements v, shared with other elements or of its own, to parameters σ
//! of its stress: minimise over v, maximise over σ of `vᵀ T σ − ½ σᵀ F σ`, the parameters kept in
//! the yield set at some points, `(1, b_j + B_j σ) ∈ K⁶`. Parameters are normalised so that the
//! yield radius is 1. Rigid-plastic elements have F = 0.
//!
//! # Shapes
//! - [`Shape::Stress`]: the static super-element, 30 parameters, 16 points.
//! - [`Shape::Flow`]: the kinematic element, one or four (sub)tets with linear strain. The
//!   parameters are deviatoric stresses at the points of a quadrature rule, times their weights;
//!   `T` is the strain there. A rigid-plastic element has further parameters without a yield
//!   condition, the pressures that hold its volume.
//!
//! # Layout
//! Eight elements are interleaved, entry by entry, so that every operation runs on the eight at
//! once.

use crate::math::lanes::{
    Place, add_times, add_times_part, add_transposed, add_transposed_part, kernel,
    subtract_symmetric,
};
use crate::math::wide::{LANES, Lane, parts, registers, registers_mut};

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
    /// Rigid-plastic at the vertices: faces of welds, see [`crate::programs::weld_face`].
    Vertices,
}

/// The ten points as means of the vertices times their weights: `V/32` at vertices, `7 V/48` at
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
/// The vertices, `V/4` each.
const FOUR_POINTS: [[f64; 4]; 4] =
    [[0.25, 0.0, 0.0, 0.0], [0.0, 0.25, 0.0, 0.0], [0.0, 0.0, 0.25, 0.0], [0.0, 0.0, 0.0, 0.25]];

impl Rule {
    /// Weight of each vertex value at each point.
    pub fn points(self) -> &'static [[f64; 4]] {
        match self {
            Rule::Hencky | Rule::Vertices => &FOUR_POINTS,
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
/// - `Flow`: strain (per subtet 20 × (inner + k): component a at vertex v is row `5 v + a`) times
///   volume and yield radius; per subtet the scalar f of its flexibility `f (20 δ_vw − 4)`, 0 for
///   rigid-plastic; rows of the pressures (k each); stiffness of the inner displacements beside the
///   flow (column by column, inner + k rows).
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

kernel! {
    /// `out += Tᵀ v` of (sub)tets: strains at the vertices, then what the points take of them.
    fn strain_at_points(simd; rule: Rule, strain: &'a [Lane], v: &'a [Lane], out: &'a mut [Lane]) {
        let size = VERTEX_VALUES * v.len();
        let (strain, v, out) = (registers::<S>(strain), registers::<S>(v), registers_mut::<S>(out));
        for offset in 0..parts::<S>() {
            let at = Place { stride: parts::<S>(), offset };
            let mut point = 0;
            for e in strain.chunks_exact(size * parts::<S>()) {
                let mut vertices = [simd.splat_f64s(0.0); VERTEX_VALUES];
                add_times_part(simd, (e, v, at), (&mut vertices, Place { stride: 1, offset: 0 }, VERTEX_VALUES));
                for weights in rule.points() {
                    for vertex in 0..4 {
                        if weights[vertex] == 0.0 {
                            continue;
                        }
                        let w = simd.splat_f64s(weights[vertex]);
                        for a in 0..DEVIATOR {
                            let to = &mut out[at.of(point + a)];
                            *to = simd.mul_add_e_f64s(w, vertices[DEVIATOR * vertex + a], *to);
                        }
                    }
                    point += DEVIATOR;
                }
            }
        }
    }
}

kernel! {
    /// `v += T σ` of (sub)tets.
    fn force_of_points(simd; rule: Rule, strain: &'a [Lane], sigma: &'a [Lane], v: &'a mut [Lane]) {
        let size = VERTEX_VALUES * v.len();
        let (strain, sigma, v) = (registers::<S>(strain), registers::<S>(sigma), registers_mut::<S>(v));
        for offset in 0..parts::<S>() {
            let at = Place { stride: parts::<S>(), offset };
            let mut point = 0;
            for e in strain.chunks_exact(size * parts::<S>()) {
                let mut vertices = [simd.splat_f64s(0.0); VERTEX_VALUES];
                for weights in rule.points() {
                    for vertex in 0..4 {
                        if weights[vertex] == 0.0 {
                            continue;
                        }
                        let w = simd.splat_f64s(weights[vertex]);
                        for a in 0..DEVIATOR {
                            let to = &mut vertices[DEVIATOR * vertex + a];
                            *to = simd.mul_add_e_f64s(w, sigma[at.of(point + a)], *to);
                        }
                    }
                    point += DEVIATOR;
                }
                add_transposed_part(simd, (e, &mut *v, at), (&vertices, Place { stride: 1, offset: 0 }, VERTEX_VALUES));
            }
        }
    }
}

kernel! {
    /// `out −= F σ` of (sub)tets that are elastic before they yield.
    fn subtract_hencky(simd; flexibility: &'a [Lane], sigma: &'a [Lane], out: &'a mut [Lane]) {
        let subtets = flexibility.len();
        let (flexibility, sigma) = (registers::<S>(flexibility), registers::<S>(sigma));
        let out = registers_mut::<S>(out);
        let (own, others) = (simd.splat_f64s(20.0), simd.splat_f64s(4.0));
        for offset in 0..parts::<S>() {
            let at = Place { stride: parts::<S>(), offset };
            for subtet in 0..subtets {
                for a in 0..DEVIATOR {
                    let mut sum = simd.splat_f64s(0.0);
                    for v in 0..4 {
                        sum = simd.add_f64s(sum, sigma[at.of(VERTEX_VALUES * subtet + DEVIATOR * v + a)]);
                    }
                    let sum = simd.mul_f64s(sum, others);
                    for v in 0..4 {
                        let i = at.of(VERTEX_VALUES * subtet + DEVIATOR * v + a);
                        let strain = simd.sub_f64s(simd.mul_f64s(own, sigma[i]), sum);
                        out[i] = simd.negate_mul_add_e_f64s(flexibility[at.of(subtet)], strain, out[i]);
                    }
                }
            }
        }
    }
}

kernel! {
    /// `v += K x` of the inner displacements' stiffness, `inner` columns; the inner block is stored
    /// whole, its couplings once.
    fn add_inner_stiffness(simd; inner: usize, stiffness: &'a [Lane], x: &'a [Lane], v: &'a mut [Lane]) {
        let all = x.len();
        let (stiffness, x, v) = (registers::<S>(stiffness), registers::<S>(x), registers_mut::<S>(v));
        for offset in 0..parts::<S>() {
            let at = Place { stride: parts::<S>(), offset };
            for c in 0..inner {
                let own = x[at.of(c)];
                for r in 0..all {
                    v[at.of(r)] = simd.mul_add_e_f64s(stiffness[at.of(c * all + r)], own, v[at.of(r)]);
                }
                let mut sum = v[at.of(c)];
                for r in inner..all {
                    sum = simd.mul_add_e_f64s(stiffness[at.of(c * all + r)], x[at.of(r)], sum);
                }
                v[at.of(c)] = sum;
            }
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
        let place = |of: &dyn Fn(&Placed) -> u32| -> [u32; LANES] {
            std::array::from_fn(|l| elements.get(l).map_or(NONE, of))
        };
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

    /// `out += Tᵀ v`, v the element's displacements.
    pub fn strain(&self, v: &[Lane], out: &mut [Lane]) {
        let [strain, _, volume, _] = self.parts();
        match self.shape {
            Shape::Stress => add_times(strain, v, out),
            Shape::Flow { rule, inner, .. } => {
                let (points, pressures) = out.split_at_mut(DEVIATOR * self.shape.points());
                strain_at_points(rule, strain, v, points);
                add_times(volume, &v[inner..], pressures);
            }
        }
    }

    /// `v += T σ`.
    pub fn add_force(&self, sigma: &[Lane], v: &mut [Lane]) {
        let [strain, _, volume, _] = self.parts();
        match self.shape {
            Shape::Stress => add_transposed(strain, sigma, v),
            Shape::Flow { rule, inner, .. } => {
                let (points, pressures) = sigma.split_at(DEVIATOR * self.shape.points());
                force_of_points(rule, strain, points, v);
                add_transposed(volume, pressures, &mut v[inner..]);
            }
        }
    }

    /// `out −= F σ`.
    pub fn subtract_flexibility(&self, sigma: &[Lane], out: &mut [Lane]) {
        let flexibility = self.parts()[1];
        match self.shape {
            Shape::Stress => subtract_symmetric(flexibility, sigma, out),
            Shape::Flow { rule: Rule::Hencky, .. } => subtract_hencky(flexibility, sigma, out),
            Shape::Flow { .. } => {}
        }
    }

    /// `v += K v` of the inner displacements' stiffness.
    pub fn add_inner(&self, x: &[Lane], v: &mut [Lane]) {
        add_inner_stiffness(self.shape.inner(), self.parts()[3], x, v);
    }

    /// Deviators `B σ` at the points, five values each.
    pub fn deviators(&self, sigma: &[Lane]) -> Vec<Lane> {
        match self.shape {
            Shape::Stress => {
                let mut out = vec![[0.0; LANES]; DEVIATOR * self.shape.points()];
                add_times(self.parts()[2], sigma, &mut out);
                out
            }
            Shape::Flow { .. } => sigma[..DEVIATOR * self.shape.points()].to_vec(),
        }
    }

    /// `out += Bᵀ d`, five values at each point.
    pub fn add_deviators(&self, d: &[Lane], out: &mut [Lane]) {
        match self.shape {
            Shape::Stress => add_transposed(self.parts()[2], d, out),
            Shape::Flow { .. } => {
                out.as_flattened_mut().iter_mut().zip(d.as_flattened()).for_each(|(o, d)| *o += d);
            }
        }
    }

    /// The element's displacements of the program's unknowns `x`; `scale` multiplies shared and
    /// inner ones (empty: 1).
    pub fn gather_displacements(&self, x: &[f64], scale: &[f64]) -> Vec<Lane> {
        let value = |i: u32| match i {
            NONE => 0.0,
            i if scale.is_empty() => x[i as usize],
            i => x[i as usize] * scale[i as usize],
        };
        let first = self.inner_own();
        let inner = (0..self.shape.inner() as u32)
            .map(|i| first.map(|f| if f == NONE { NONE } else { f + i }));
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
                let at = if i < inner {
                    self.own[l] + (first + i) as u32
                } else {
                    self.columns[i - inner][l]
                };
                if at != NONE {
                    y[at as usize] +=
                        lanes[l] * if scale.is_empty() { 1.0 } else { scale[at as usize] };
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
