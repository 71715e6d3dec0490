//! The models of the meshed part of a symmetric structure for displacements of every parity: to
//! each plane of symmetry they are symmetric or antisymmetric.
//!
//! Loads, stresses and contacts of the structure are symmetric, but it may buckle
//! antisymmetrically. On a plane normal to k a symmetric displacement has no component along k, an
//! antisymmetric one has that component alone.

use super::motions::{self, LooseParts};
use crate::model::AnalysisModel;
use crate::model::analysis::RigidFace;
use crate::model::loads::face_corners;

/// Distance within which a node lies on a plane \[mm\].
const ON_PLANE: f64 = 1e-6;

/// A plane of symmetry `x[axis] = 0`, and the name of the support on it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct MirrorPlane<'a> {
    /// Name of its support.
    pub support: &'a str,
    /// Normal axis, 0 = x.
    pub axis: usize,
}

/// The models of all parities without loads, the symmetric one first.
pub fn parities(
    model: &AnalysisModel,
    planes: &[MirrorPlane<'_>],
) -> Result<Vec<AnalysisModel>, LooseParts> {
    let each = 0..1usize << planes.len();
    each.map(|bits| of_parity(model, planes, |i| bits >> i & 1 == 1)).collect()
}

/// The model of one parity; `odd`: whether it is antisymmetric to a plane.
fn of_parity(
    model: &AnalysisModel,
    planes: &[MirrorPlane<'_>],
    odd: impl Fn(usize) -> bool,
) -> Result<AnalysisModel, LooseParts> {
    let mut out = model.clone();
    // a mode is no answer to loads: none of them keeps a free motion from being held
    out.surface_loads.clear();
    out.body_loads.clear();
    for (_, plane) in planes.iter().enumerate().filter(|(i, _)| odd(*i)) {
        let here = out.supports.iter_mut().filter(|s| s.name == plane.support);
        here.for_each(|s| s.fix = s.fix.map(|held| !held));
    }
    for face in &mut out.rigid {
        (face.action, face.dead_action) = ([0.0; 6], [0.0; 6]);
        let cut: Vec<(usize, bool)> = planes
            .iter()
            .enumerate()
            .filter(|(_, p)| is_cut(face, model, p.axis))
            .map(|(i, p)| (p.axis, odd(i)))
            .collect();
        let free = |k: usize, odd: bool| cut.iter().all(|(axis, o)| moves(k, *axis, odd && *o));
        // a motion that symmetry permits and that is held all the same stays held
        face.free = std::array::from_fn(|k| free(k, true) && (face.free[k] || !free(k, false)));
    }
    out.free_modes = motions::free_modes(&out)?;
    Ok(out)
}

/// Whether a plane of symmetry cuts a rigid face.
fn is_cut(face: &RigidFace, model: &AnalysisModel, axis: usize) -> bool {
    let corners = face.faces.iter().flat_map(|f| face_corners(&model.mesh, f));
    corners.into_iter().any(|x| x[axis].abs() <= ON_PLANE)
}

/// Whether a rigid face that a plane normal to `axis` cuts can have motion k (ux … rz). Symmetric:
/// it moves along the plane and turns about its normal; antisymmetric: the other motions.
fn moves(k: usize, axis: usize, odd: bool) -> bool {
    let even = if k < 3 { k != axis } else { k - 3 == axis };
    even != odd
}
