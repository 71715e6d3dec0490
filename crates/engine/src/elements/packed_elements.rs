//! Elements that yield, eight of one shape side by side.
//!
//! The data of eight elements are interleaved entry by entry, so that every operation runs on the
//! eight at once.

use crate::elements::flow_maps::{self, add_at_points, from_points};
use crate::elements::stress_maps;
use crate::elements::yielding_element::{
    DEVIATOR, NONE, Rule, Shape, VERTEX_VALUES, YieldingElement,
};
use bracket_base::math::lanes::{
    Place, add_times, add_times_part, add_transposed, add_transposed_part, kernel,
    subtract_symmetric,
};
use bracket_base::math::wide::{LANES, Lane, parts, registers, registers_mut};

/// An element, its first own unknown and its first yield row.
pub type Placed = (YieldingElement, u32, u32);

/// Up to eight elements of one shape.
#[derive(Clone, Debug, PartialEq)]
pub struct Batch {
    /// Kind and sizes.
    pub shape: Shape,
    /// Shared unknowns, `[position][lane]`.
    pub columns: Vec<[u32; LANES]>,
    /// First own unknown of each lane; `NONE`: empty lane.
    pub own: [u32; LANES],
    /// First yield row of each lane.
    pub rows: [u32; LANES],
    /// Matrices, see [`YieldingElement`].
    pub data: Vec<Lane>,
    /// Numbers of their products; empty: the matrices are used.
    pub maps: Vec<Lane>,
    /// True: the elements have a flexibility.
    pub flexible: bool,
}

kernel! {
    /// `out += Tᵀ v` of (sub)tets: strains at the vertices, then their weighted means at the
    /// points.
    fn strain_at_points(simd; rule: Rule, strain: &'a [Lane], v: &'a [Lane], out: &'a mut [Lane]) {
        let size = VERTEX_VALUES * v.len();
        let (strain, v, out) = (registers::<S>(strain), registers::<S>(v), registers_mut::<S>(out));
        for offset in 0..parts::<S>() {
            let at = Place { stride: parts::<S>(), offset };
            let mut point = 0;
            for e in strain.chunks_exact(size * parts::<S>()) {
                let mut vertices = [simd.splat_f64s(0.0); VERTEX_VALUES];
                let all = (&mut vertices[..], Place { stride: 1, offset: 0 }, VERTEX_VALUES);
                add_times_part(simd, (e, v, at), all);
                add_at_points(simd, rule, &vertices, (&mut *out, at, point));
                point += DEVIATOR * rule.points().len();
            }
        }
    }
}

kernel! {
    /// `v += T σ` of (sub)tets.
    fn force_of_points(simd; rule: Rule, strain: &'a [Lane], sigma: &'a [Lane], v: &'a mut [Lane]) {
        let size = VERTEX_VALUES * v.len();
        let (strain, sigma) = (registers::<S>(strain), registers::<S>(sigma));
        let v = registers_mut::<S>(v);
        for offset in 0..parts::<S>() {
            let at = Place { stride: parts::<S>(), offset };
            let mut point = 0;
            for e in strain.chunks_exact(size * parts::<S>()) {
                let vertices = from_points(simd, rule, (sigma, at, point));
                point += DEVIATOR * rule.points().len();
                let all = (&vertices[..], Place { stride: 1, offset: 0 }, VERTEX_VALUES);
                add_transposed_part(simd, (e, &mut *v, at), all);
            }
        }
    }
}

kernel! {
    /// `out −= F σ` of (sub)tets that are elastic below yield.
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
                        let i = at.of(VERTEX_VALUES * subtet + DEVIATOR * v + a);
                        sum = simd.add_f64s(sum, sigma[i]);
                    }
                    let sum = simd.mul_f64s(sum, others);
                    for v in 0..4 {
                        let i = at.of(VERTEX_VALUES * subtet + DEVIATOR * v + a);
                        let strain = simd.sub_f64s(simd.mul_f64s(own, sigma[i]), sum);
                        let f = flexibility[at.of(subtet)];
                        out[i] = simd.negate_mul_add_e_f64s(f, strain, out[i]);
                    }
                }
            }
        }
    }
}

kernel! {
    /// `v += K x` of the inner displacements' stiffness, `inner` columns; the inner block is stored
    /// whole, its couplings once.
    fn add_inner_stiffness(
        simd; inner: usize, stiffness: &'a [Lane], x: &'a [Lane], v: &'a mut [Lane],
    ) {
        let all = x.len();
        let (stiffness, x) = (registers::<S>(stiffness), registers::<S>(x));
        let v = registers_mut::<S>(v);
        for offset in 0..parts::<S>() {
            let at = Place { stride: parts::<S>(), offset };
            for c in 0..inner {
                let own = x[at.of(c)];
                for r in 0..all {
                    let entry = stiffness[at.of(c * all + r)];
                    v[at.of(r)] = simd.mul_add_e_f64s(entry, own, v[at.of(r)]);
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
    /// Interleaves elements of one shape, each given with its first own unknown and first row.
    pub fn new(elements: &[Placed]) -> Self {
        let first = &elements[0].0;
        // empty lanes repeat the first element, so that their matrices are regular too
        let lanes = |of: &dyn Fn(&YieldingElement) -> f64| -> Lane {
            std::array::from_fn(|l| of(&elements.get(l).unwrap_or(&elements[0]).0))
        };
        let place = |of: &dyn Fn(&Placed) -> u32| -> [u32; LANES] {
            std::array::from_fn(|l| elements.get(l).map_or(NONE, of))
        };
        let parts = first.shape.parts(first.columns.len());
        let flexibility = parts.strain..parts.strain + parts.flexibility;
        Self {
            shape: first.shape,
            columns: (0..first.columns.len()).map(|i| place(&|e| e.0.columns[i])).collect(),
            own: place(&|e| e.1),
            rows: place(&|e| e.2),
            data: (0..first.data.len()).map(|i| lanes(&|e| e.data[i])).collect(),
            maps: (0..first.maps.len()).map(|i| lanes(&|e| e.maps[i])).collect(),
            flexible: elements
                .iter()
                .any(|e| e.0.data[flexibility.clone()].iter().any(|f| *f != 0.0)),
        }
    }

    /// Number of shared unknowns of an element.
    pub fn shared(&self) -> usize {
        self.columns.len()
    }

    /// First inner displacement of each lane among the unknowns; `NONE`: empty lane.
    pub fn inner_own(&self) -> [u32; LANES] {
        let parameters = self.shape.parameters() as u32;
        self.own.map(|own| if own == NONE { NONE } else { own + parameters })
    }

    /// Number of displacements of an element: its own, then the shared ones.
    pub fn displacements(&self) -> usize {
        self.shape.inner() + self.columns.len()
    }

    /// The parts of the data: strain (or `Tᵀ`), flexibility, pressures (or B), inner stiffness.
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
            Shape::Stress if !self.maps.is_empty() => stress_maps::add_strains(&self.maps, v, out),
            Shape::Stress => add_times(strain, v, out),
            Shape::Flow { rule, inner, .. } => {
                let (points, pressures) = out.split_at_mut(DEVIATOR * self.shape.points());
                match self.maps.is_empty() {
                    true => strain_at_points(rule, strain, v, points),
                    false => flow_maps::add_strains(rule, &self.maps, v, points),
                }
                add_times(volume, &v[inner..], pressures);
            }
        }
    }

    /// `v += T σ`.
    pub fn add_force(&self, sigma: &[Lane], v: &mut [Lane]) {
        let [strain, _, volume, _] = self.parts();
        match self.shape {
            Shape::Stress if !self.maps.is_empty() => {
                stress_maps::add_tractions(&self.maps, sigma, v);
            }
            Shape::Stress => add_transposed(strain, sigma, v),
            Shape::Flow { rule, inner, .. } => {
                let (points, pressures) = sigma.split_at(DEVIATOR * self.shape.points());
                match self.maps.is_empty() {
                    true => force_of_points(rule, strain, points, v),
                    false => flow_maps::add_forces(rule, &self.maps, points, v),
                }
                add_transposed(volume, pressures, &mut v[inner..]);
            }
        }
    }

    /// `out −= F σ`.
    pub fn subtract_flexibility(&self, sigma: &[Lane], out: &mut [Lane]) {
        if !self.flexible {
            return;
        }
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
                match self.maps.is_empty() {
                    true => add_times(self.parts()[2], sigma, &mut out),
                    false => stress_maps::add_deviators(&self.maps, sigma, &mut out),
                }
                out
            }
            Shape::Flow { .. } => sigma[..DEVIATOR * self.shape.points()].to_vec(),
        }
    }

    /// `out += Bᵀ d`, five values at each point.
    pub fn add_deviators(&self, d: &[Lane], out: &mut [Lane]) {
        match self.shape {
            Shape::Stress if !self.maps.is_empty() => {
                stress_maps::add_deviators_transposed(&self.maps, d, out);
            }
            Shape::Stress => add_transposed(self.parts()[2], d, out),
            Shape::Flow { .. } => {
                out.as_flattened_mut().iter_mut().zip(d.as_flattened()).for_each(|(o, d)| *o += d);
            }
        }
    }

    /// Displacements of the elements from the program's unknowns `x`; `scale` multiplies shared and
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

    /// Entry (r, c) of the flexibility F of one lane, for normalised parameters.
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
