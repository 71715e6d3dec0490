//! Energy of elastic ground (Winkler), `½ k ∫ c²`, as entries of the quadratic term.
//!
//! The kinematic program has one closing for each control point, with `g_N + c ≥ 0` at each: the
//! quadratic polynomial c closes at least as much as the steel presses, so its energy bounds that
//! of the ground from above. The static program has one closing for each contact vertex. Its c is
//! linear on a face and equals the pressure over k, so its energy is the complementary energy
//! `∫ p² / 2k` of that pressure.

use crate::elements::space::Tet10Space;
use crate::model::AnalysisModel;
use crate::programs::contact::cone::Closing;
use crate::programs::contact::kinematic_contact::{ControlPoint, points_of_faces};
use crate::programs::contact::static_contact::ContactVertex;
use bracket_base::math::quadrature::{bernstein_mass, triangle_mass};
use bracket_base::math::vec3;
use std::collections::BTreeMap;
use std::ops::Range;

/// An entry of the quadratic term: column, row, value.
type Entry = (usize, u32, f64);

/// Entries of the upper triangle of `k A M` on the unknowns of one face.
fn face_entries<const N: usize>(
    unknowns: [usize; N],
    factor: f64,
    mass: fn(usize, usize) -> f64,
) -> impl Iterator<Item = Entry> {
    let pairs = (0..N).flat_map(|i| (0..N).map(move |j| (i, j)));
    let upper = pairs.filter(move |&(i, j)| unknowns[i] <= unknowns[j]);
    upper.map(move |(i, j)| (unknowns[j], unknowns[i] as u32, factor * mass(i, j)))
}

/// Entries of the kinematic program; `points` have the unknowns `closings` in their order, those
/// with a closing alone.
pub fn kinematic_entries(
    model: &AnalysisModel,
    space: &Tet10Space,
    points: &[ControlPoint],
    closings: Range<usize>,
) -> Vec<Entry> {
    if !points.iter().any(|p| p.closing == Some(Closing::Elastic)) {
        return Vec::new();
    }
    let closed = points.iter().filter(|p| p.closing.is_some());
    let unknown: BTreeMap<_, usize> = closed.map(ControlPoint::key).zip(closings).collect();
    let mut out = Vec::new();
    for face in points_of_faces(model, space) {
        if face[0].closing != Some(Closing::Elastic) {
            continue;
        }
        let stiffness = model.ground_stiffness(face[0].contact).unwrap_or_default();
        let corners = [0, 1, 2].map(|i| space.nodes[face[i].a[0]]);
        let area = vec3::norm(vec3::area_vector(&corners));
        let unknowns = face.map(|p| unknown[&p.key()]);
        out.extend(face_entries(unknowns, stiffness * area, bernstein_mass));
    }
    out
}

/// Entries of the static program; `vertices` have the unknowns `closings` in their order, those
/// with a closing alone.
pub fn static_entries(
    model: &AnalysisModel,
    vertices: &[ContactVertex],
    closings: Range<usize>,
) -> Vec<Entry> {
    let closed = vertices.iter().filter(|v| v.closing.is_some()).zip(closings);
    let first = closed.filter(|(v, _)| v.closing == Some(Closing::Elastic) && v.index == 0);
    let of_face = |(v, k): (&ContactVertex, usize)| {
        let stiffness = model.ground_stiffness(v.contact).unwrap_or_default();
        face_entries([k, k + 1, k + 2], stiffness * v.area, triangle_mass)
    };
    first.flat_map(of_face).collect()
}
