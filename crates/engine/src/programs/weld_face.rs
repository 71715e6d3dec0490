//! A face of a weld of finite strength: rigid until its traction reaches the strength, then
//! perfectly plastic.
//!
//! Saddle form: minimise over displacements v and maximise over tractions t, with
//! `‖t_p‖ ≤ strength` at some points p, the sum `Σ_p t_p · J_p v`. J_p is a weighted jump of the
//! displacement from side A to side B. The maximum, `strength Σ_p ‖J_p v‖`, is the work that the
//! weld dissipates.
//!
//! - Static program: J_a is the mass-weighted jump `Σ_b M_ab (v_B − v_A)_b` at face vertex a, so
//!   that t_a is the traction `σ n` of side A there. It is linear on the face: vertices suffice.
//! - Kinematic program: the jump is quadratic on the face, its norm at most the norms of its six
//!   Bernstein coefficients weighted with the Bernstein polynomials, and each of these has the mean
//!   1/6: J_p is a coefficient times a sixth of the area.
//!
//! Both have the data layout of a yielding element ([`Shape::Flow`]) with [`Rule::Vertices`]: four
//! points to a group, of which three of the five components are used.

use crate::elements::space::{FACE_EDGES, Tet10Space};
use crate::elements::yielding_element::{NONE, Rule, Shape, YieldingElement};
use crate::model::analysis::FacePair;
use crate::programs::conic::Csr;
use crate::programs::dofs::DofMap;
use crate::programs::super_elements::SuperElements;
use bracket_base::math::quadrature::triangle_mass;
use bracket_base::math::vec3;

/// A linear form of full unknowns: unknown and factor.
pub type Form = Vec<(usize, f64)>;
/// Components of a weighted jump.
pub type Jump = [Form; 3];

/// Points in a group of [`Shape::Flow`].
const GROUP: usize = 4;
/// Components at a point of [`Shape::Flow`].
const COMPONENTS: usize = 5;

/// The weighted jumps at the three vertices of a face, on the displacements of mesh faces.
pub fn static_jumps(elements: &SuperElements, face: &FacePair) -> Vec<Jump> {
    let mesh = &elements.model().mesh;
    let area = vec3::norm(vec3::area_vector(&face.nodes_a.map(|n| mesh.nodes[n as usize])));
    let a = elements.vertex_dofs(&face.a, face.nodes_a);
    let b = elements.vertex_dofs(&face.b, face.nodes_b);
    let form = |vertex: usize, d: usize| -> Form {
        let both = (0..3).flat_map(|k| {
            let w = triangle_mass(vertex, k) * area;
            [(b[k] + d, w), (a[k] + d, -w)]
        });
        both.collect()
    };
    (0..3).map(|vertex| [0, 1, 2].map(|d| form(vertex, d))).collect()
}

/// Bernstein coefficient `i` of a quadratic function on a face: nodes of the face and factors.
pub(super) fn bernstein(i: usize) -> Vec<(usize, f64)> {
    match i.checked_sub(3) {
        None => vec![(i, 1.0)],
        Some(edge) => {
            let [p, q] = FACE_EDGES[edge];
            vec![(i, 2.0), (p, -0.5), (q, -0.5)]
        }
    }
}

/// The Bernstein coefficients of the jump on a face, each times its weight in the integral if
/// `weighted`, on nodal displacements.
pub fn kinematic_jumps(space: &Tet10Space, face: &FacePair, weighted: bool) -> Vec<Jump> {
    let area = vec3::norm(vec3::area_vector(&face.nodes_a.map(|n| space.nodes[n as usize])));
    let weight = if weighted { area / 6.0 } else { 1.0 };
    let (a, b) = (space.triangle(face.nodes_a), space.triangle(face.nodes_b));
    let form = |i: usize, d: usize| -> Form {
        let both = bernstein(i).into_iter().flat_map(|(k, w)| {
            let w = w * weight;
            [(3 * b[k] + d, w), (3 * a[k] + d, -w)]
        });
        both.collect()
    };
    (0..6).map(|i| [0, 1, 2].map(|d| form(i, d))).collect()
}

/// Weld face (or slip face) with the given weighted jumps as a yielding element; `None` when
/// nothing of it can move.
pub fn element(map: &DofMap, strength: f64, jumps: &[Jump]) -> Option<YieldingElement> {
    let mut dofs: Vec<usize> = jumps.iter().flatten().flatten().map(|t| t.0).collect();
    dofs.sort_unstable();
    dofs.dedup();
    let columns = map.columns(&dofs);
    if columns.unknowns.iter().all(|u| *u == NONE) {
        return None;
    }
    let subtets = jumps.len().div_ceil(GROUP);
    let shape = Shape::Flow { subtets, rule: Rule::Vertices, inner: 0, pressures: 0 };
    let mut data = Vec::with_capacity(shape.len(columns.unknowns.len()));
    for point in 0..GROUP * subtets {
        for component in 0..COMPONENTS {
            let mut full = vec![0.0; dofs.len()];
            let form = jumps.get(point).and_then(|jump| jump.get(component));
            for &(dof, w) in form.into_iter().flatten() {
                // the rule weighs each point with 1/4
                full[dofs.partition_point(|d| *d < dof)] += GROUP as f64 * strength * w;
            }
            data.extend(columns.row(&full));
        }
    }
    data.extend(std::iter::repeat_n(0.0, subtets));
    let h = (0..shape.points()).flat_map(|_| [1.0, 0.0, 0.0, 0.0, 0.0, 0.0]).collect();
    let q = vec![0.0; shape.parameters()];
    Some(YieldingElement {
        shape,
        columns: columns.unknowns,
        data,
        maps: Vec::new(),
        q,
        h,
        inner_stiffness: Vec::new(),
    })
}

/// Tractions at the points of a face from the own unknowns of its element \[MPa\]; zero without own
/// unknowns.
pub fn tractions(strength: f64, points: usize, own: &[f64]) -> Vec<f64> {
    (0..3 * points)
        .map(|i| own.get(COMPONENTS * (i / 3) + i % 3).map_or(0.0, |y| strength * y))
        .collect()
}

/// Jumps as rows on the program's unknowns, three rows each.
pub fn rows(map: &DofMap, jumps: impl Iterator<Item = Jump>) -> Csr {
    let mut out = Csr { ncols: map.n, row_ptr: vec![0], ..Csr::default() };
    jumps.flatten().for_each(|form| out.push_row(&map.row(&form)));
    out
}
