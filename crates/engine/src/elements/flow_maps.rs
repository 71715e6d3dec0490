//! Strains of split rigid-plastic elements, and the forces of their stresses, through the reference
//! tetrahedron, eight elements side by side.
//!
//! The matrix of such an element has 80 × 30 entries. A product with it is computed from 19 numbers
//! instead: the outer velocities are mapped to the reference tetrahedron, where one constant map
//! gives the inner velocities of every element ([`super::split_flow`]); the gradients of a subtet
//! give the strains. The matrix does not fit into the cache, these numbers do.
//!
//! # Shape
//! Numbers of an element: J by rows, J⁻¹ by rows, and a factor on the strains.

use crate::elements::geometry::jacobian;
use crate::elements::split_flow::{OUTER_UNKNOWNS, inner_map};
use crate::elements::split_tet10::{INNER_UNKNOWNS, NODES, subtet_nodes};
use crate::elements::yielding_element::{DEVIATOR, Rule, VERTEX_VALUES};
use crate::mesh::tet::{EDGES, FACES};
use bracket_base::math::lanes::{Place, kernel};
use bracket_base::math::vec3::V3;
use bracket_base::math::wide::{Lane, parts, registers, registers_mut};
use pulp::Simd;
use std::f64::consts::FRAC_1_SQRT_2;
use std::sync::OnceLock;

/// Number of values of an element.
const NUMBERS: usize = 19;
const FULL: usize = 3 * NODES;
/// Rows of the inner map, and columns of its transpose, processed together.
const TILE: usize = 5;
/// 1/√3.
const THIRD_ROOT: f64 = 0.577_350_269_189_625_8;

/// Node of a pair of corners of each subtet: the corner itself, or the middle between both.
type Pairs = [[[usize; 4]; 4]; 4];

fn pairs() -> &'static Pairs {
    static PAIRS: OnceLock<Pairs> = OnceLock::new();
    PAIRS.get_or_init(|| {
        std::array::from_fn(|k| {
            let nodes = subtet_nodes(k);
            std::array::from_fn(|a| {
                std::array::from_fn(|b| {
                    let edge = EDGES.iter().position(|e| *e == [a, b] || *e == [b, a]);
                    edge.map_or(nodes[a], |e| nodes[4 + e])
                })
            })
        })
    })
}

/// The numbers of an element whose strains are multiplied by `factor`.
pub fn numbers(corners: &[V3; 4], factor: f64) -> Vec<f64> {
    let (j, inverse, _) = jacobian(corners);
    let mut out: Vec<f64> = j.iter().chain(&inverse).flatten().copied().collect();
    out.push(FRAC_1_SQRT_2 * factor);
    out
}

/// Values of some points are means of those at the vertices of a subtet: `out += weight · values`.
#[inline(always)]
pub fn add_at_points<S: Simd>(
    simd: S,
    rule: Rule,
    vertices: &[S::f64s; VERTEX_VALUES],
    (out, at, first): (&mut [S::f64s], Place, usize),
) {
    for (point, weights) in rule.points().iter().enumerate() {
        for vertex in 0..4 {
            if weights[vertex] == 0.0 {
                continue;
            }
            let w = simd.splat_f64s(weights[vertex]);
            for a in 0..DEVIATOR {
                let to = &mut out[at.of(first + DEVIATOR * point + a)];
                *to = simd.mul_add_e_f64s(w, vertices[DEVIATOR * vertex + a], *to);
            }
        }
    }
}

/// The transpose of [`add_at_points`]: values at the vertices of a subtet.
#[inline(always)]
pub fn from_points<S: Simd>(
    simd: S,
    rule: Rule,
    (values, at, first): (&[S::f64s], Place, usize),
) -> [S::f64s; VERTEX_VALUES] {
    let mut vertices = [simd.splat_f64s(0.0); VERTEX_VALUES];
    for (point, weights) in rule.points().iter().enumerate() {
        for vertex in 0..4 {
            if weights[vertex] == 0.0 {
                continue;
            }
            let w = simd.splat_f64s(weights[vertex]);
            for a in 0..DEVIATOR {
                let to = &mut vertices[DEVIATOR * vertex + a];
                *to = simd.mul_add_e_f64s(w, values[at.of(first + DEVIATOR * point + a)], *to);
            }
        }
    }
    vertices
}

/// The numbers of the elements in one register of each lane.
struct Numbers<S: Simd> {
    j: [[S::f64s; 3]; 3],
    inverse: [[S::f64s; 3]; 3],
    factor: S::f64s,
}

impl<S: Simd> Numbers<S> {
    #[inline(always)]
    fn new(maps: &[S::f64s], at: Place) -> Self {
        let mut out = Self {
            j: [[maps[at.of(0)]; 3]; 3],
            inverse: [[maps[at.of(0)]; 3]; 3],
            factor: maps[at.of(NUMBERS - 1)],
        };
        for r in 0..3 {
            for c in 0..3 {
                out.j[r][c] = maps[at.of(3 * r + c)];
                out.inverse[r][c] = maps[at.of(9 + 3 * r + c)];
            }
        }
        out
    }

    /// Gradients of the barycentric coordinates of the element, times the factor.
    #[inline(always)]
    fn gradients(&self, simd: S) -> [[S::f64s; 3]; 4] {
        let mut g = [[simd.splat_f64s(0.0); 3]; 4];
        for r in 0..3 {
            for d in 0..3 {
                g[r + 1][d] = simd.mul_f64s(self.inverse[r][d], self.factor);
                g[0][d] = simd.sub_f64s(g[0][d], g[r + 1][d]);
            }
        }
        g
    }

    /// The velocities of all nodes.
    #[inline(always)]
    fn velocities(&self, simd: S, v: &[S::f64s], at: Place, map: &InnerMap) -> [S::f64s; FULL] {
        let zero = simd.splat_f64s(0.0);
        let mut u = [zero; FULL];
        let mut hat = [zero; OUTER_UNKNOWNS];
        for i in 0..OUTER_UNKNOWNS {
            u[i] = v[at.of(i)];
        }
        for node in 0..OUTER_UNKNOWNS / 3 {
            for d in 0..3 {
                let mut sum = zero;
                for c in 0..3 {
                    sum = simd.mul_add_e_f64s(self.inverse[d][c], u[3 * node + c], sum);
                }
                hat[3 * node + d] = sum;
            }
        }
        let mut inner = [zero; INNER_UNKNOWNS];
        for first in (0..INNER_UNKNOWNS).step_by(TILE) {
            let mut sums = [zero; TILE];
            for c in 0..OUTER_UNKNOWNS {
                for q in 0..TILE {
                    let m = simd.splat_f64s(map[first + q][c]);
                    sums[q] = simd.mul_add_e_f64s(m, hat[c], sums[q]);
                }
            }
            inner[first..first + TILE].copy_from_slice(&sums);
        }
        for node in 0..INNER_UNKNOWNS / 3 {
            for d in 0..3 {
                let mut sum = zero;
                for c in 0..3 {
                    sum = simd.mul_add_e_f64s(self.j[d][c], inner[3 * node + c], sum);
                }
                u[OUTER_UNKNOWNS + 3 * node + d] = sum;
            }
        }
        u
    }

    /// Adds forces on all nodes to those on the outer velocities.
    #[inline(always)]
    fn add_forces(
        &self,
        simd: S,
        f: &[S::f64s; FULL],
        map: &InnerMap,
        (v, at): (&mut [S::f64s], Place),
    ) {
        let zero = simd.splat_f64s(0.0);
        let mut inner = [zero; INNER_UNKNOWNS];
        for node in 0..INNER_UNKNOWNS / 3 {
            for d in 0..3 {
                let mut sum = zero;
                for c in 0..3 {
                    let force = f[OUTER_UNKNOWNS + 3 * node + c];
                    sum = simd.mul_add_e_f64s(self.j[c][d], force, sum);
                }
                inner[3 * node + d] = sum;
            }
        }
        let mut hat = [zero; OUTER_UNKNOWNS];
        for first in (0..OUTER_UNKNOWNS).step_by(TILE) {
            let mut sums = [zero; TILE];
            for r in 0..INNER_UNKNOWNS {
                for q in 0..TILE {
                    let m = simd.splat_f64s(map[r][first + q]);
                    sums[q] = simd.mul_add_e_f64s(m, inner[r], sums[q]);
                }
            }
            hat[first..first + TILE].copy_from_slice(&sums);
        }
        for node in 0..OUTER_UNKNOWNS / 3 {
            for d in 0..3 {
                let mut sum = f[3 * node + d];
                for c in 0..3 {
                    sum = simd.mul_add_e_f64s(self.inverse[c][d], hat[3 * node + c], sum);
                }
                let to = &mut v[at.of(3 * node + d)];
                *to = simd.add_f64s(*to, sum);
            }
        }
    }
}

type InnerMap = [[f64; OUTER_UNKNOWNS]; INNER_UNKNOWNS];

/// Gradients of the three outer corners of subtet `k` relative to its own.
#[inline(always)]
fn slopes<S: Simd>(simd: S, g: &[[S::f64s; 3]; 4], k: usize) -> [[S::f64s; 3]; 3] {
    let mut e = [[g[0][0]; 3]; 3];
    for a in 0..3 {
        for d in 0..3 {
            e[a][d] = simd.sub_f64s(g[FACES[k][a]][d], g[k][d]);
        }
    }
    e
}

/// `out += Tᵀ v` at the yield points, v the outer velocities.
pub fn add_strains(rule: Rule, maps: &[Lane], v: &[Lane], out: &mut [Lane]) {
    strains(rule, maps, v, out, inner_map(), pairs());
}

/// `v += T σ`.
pub fn add_forces(rule: Rule, maps: &[Lane], sigma: &[Lane], v: &mut [Lane]) {
    forces(rule, maps, sigma, v, inner_map(), pairs());
}

kernel! {
    fn strains(
        simd;
        rule: Rule,
        maps: &'a [Lane],
        v: &'a [Lane],
        out: &'a mut [Lane],
        map: &'a InnerMap,
        pairs: &'a Pairs,
    ) {
        let (maps, v, out) = (registers::<S>(maps), registers::<S>(v), registers_mut::<S>(out));
        let (four, third) = (simd.splat_f64s(4.0), simd.splat_f64s(THIRD_ROOT));
        for offset in 0..parts::<S>() {
            let at = Place { stride: parts::<S>(), offset };
            let numbers = Numbers::<S>::new(maps, at);
            let u = numbers.velocities(simd, v, at, map);
            let g = numbers.gradients(simd);
            for k in 0..4 {
                let slopes = slopes::<S>(simd, &g, k);
                let mut vertices = [simd.splat_f64s(0.0); VERTEX_VALUES];
                for corner in 0..4 {
                    // gradient Σ_b w_b ⊗ ∇λ_b with w_b = 4 u(middle) − u(corner b)
                    let mut minus = [[four; 3]; 4];
                    for b in 0..4 {
                        let (node, own) = (pairs[k][corner][b], pairs[k][b][b]);
                        for d in 0..3 {
                            let corner = u[3 * own + d];
                            minus[b][d] = simd.negate_mul_add_e_f64s(four, u[3 * node + d], corner);
                        }
                    }
                    let mut grad = [[simd.splat_f64s(0.0); 3]; 3];
                    for a in 0..3 {
                        for r in 0..3 {
                            let w = simd.sub_f64s(minus[3][r], minus[a][r]);
                            for c in 0..3 {
                                grad[r][c] = simd.mul_add_e_f64s(w, slopes[a][c], grad[r][c]);
                            }
                        }
                    }
                    let e = &mut vertices[DEVIATOR * corner..][..DEVIATOR];
                    let plane = simd.add_f64s(grad[0][0], grad[1][1]);
                    let twice = simd.add_f64s(grad[2][2], grad[2][2]);
                    e[0] = simd.sub_f64s(grad[0][0], grad[1][1]);
                    e[1] = simd.mul_f64s(third, simd.sub_f64s(twice, plane));
                    e[2] = simd.add_f64s(grad[1][2], grad[2][1]);
                    e[3] = simd.add_f64s(grad[0][2], grad[2][0]);
                    e[4] = simd.add_f64s(grad[0][1], grad[1][0]);
                }
                let first = DEVIATOR * rule.points().len() * k;
                add_at_points(simd, rule, &vertices, (&mut *out, at, first));
            }
        }
    }
}

kernel! {
    fn forces(
        simd;
        rule: Rule,
        maps: &'a [Lane],
        sigma: &'a [Lane],
        v: &'a mut [Lane],
        map: &'a InnerMap,
        pairs: &'a Pairs,
    ) {
        let (maps, sigma) = (registers::<S>(maps), registers::<S>(sigma));
        let v = registers_mut::<S>(v);
        let (four, third) = (simd.splat_f64s(4.0), simd.splat_f64s(THIRD_ROOT));
        for offset in 0..parts::<S>() {
            let at = Place { stride: parts::<S>(), offset };
            let numbers = Numbers::<S>::new(maps, at);
            let g = numbers.gradients(simd);
            let mut f = [simd.splat_f64s(0.0); FULL];
            for k in 0..4 {
                let slopes = slopes::<S>(simd, &g, k);
                let first = DEVIATOR * rule.points().len() * k;
                let vertices = from_points(simd, rule, (sigma, at, first));
                for corner in 0..4 {
                    let s = &vertices[DEVIATOR * corner..][..DEVIATOR];
                    let part = simd.mul_f64s(third, s[1]);
                    let stress = [
                        [simd.sub_f64s(s[0], part), s[4], s[3]],
                        [s[4], simd.neg_f64s(simd.add_f64s(s[0], part)), s[2]],
                        [s[3], s[2], simd.add_f64s(part, part)],
                    ];
                    for r in 0..3 {
                        let mut last = simd.splat_f64s(0.0);
                        for a in 0..4 {
                            let mut t = simd.splat_f64s(0.0);
                            if a < 3 {
                                for c in 0..3 {
                                    t = simd.mul_add_e_f64s(stress[r][c], slopes[a][c], t);
                                }
                                last = simd.sub_f64s(last, t);
                            } else {
                                t = last;
                            }
                            let (node, own) = (pairs[k][corner][a], pairs[k][a][a]);
                            f[3 * node + r] = simd.mul_add_e_f64s(four, t, f[3 * node + r]);
                            f[3 * own + r] = simd.sub_f64s(f[3 * own + r], t);
                        }
                    }
                }
            }
            numbers.add_forces(simd, &f, map, (&mut *v, at));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::elements::columns::Columns;
    use crate::elements::fixtures::{corners, equals_by_matrix, lanes};
    use crate::elements::hencky_kinematic::YieldingTet10;
    use crate::elements::packed_elements::Batch;
    use crate::elements::yielding_element::Shape;
    use bracket_base::math::mandel::Isotropic;
    use bracket_base::math::wide::LANES;

    /// Eight different tets: products from the numbers equal those with the matrices.
    #[test]
    fn products_equal_those_of_the_matrix() {
        let elements: Vec<_> = (0..LANES)
            .map(|l| {
                let corners = corners(l);
                let tet = YieldingTet10 {
                    corners,
                    volume: crate::mesh::tet::signed_volume(&corners),
                    material: Isotropic::new(210_000.0, 0.3),
                    radius: 190.0 + l as f64,
                    body_force: [0.0; 3],
                    split: true,
                    rule: Rule::TenPoints,
                };
                let columns = Columns { unknowns: (0..30).collect(), terms: None };
                (tet.element(&columns), 1000 * l as u32, 1000 * l as u32)
            })
            .collect();
        let by_numbers = Batch::new(&elements);
        assert!(by_numbers.maps.len() == NUMBERS && !by_numbers.flexible);
        let Shape::Flow { pressures: 1, .. } = by_numbers.shape else { panic!("a split element") };
        let both = |product: &dyn Fn(&Batch) -> Vec<Lane>| {
            equals_by_matrix(&by_numbers, 1.0, product);
        };
        let rows = DEVIATOR * by_numbers.shape.points() + 1;
        let (v, sigma) = (lanes(30, 3), lanes(rows, 17));
        both(&|batch| {
            let mut out = lanes(rows, 5);
            batch.strain(&v, &mut out);
            out
        });
        both(&|batch| {
            let mut out = lanes(30, 7);
            batch.add_force(&sigma, &mut out);
            out
        });
    }
}
