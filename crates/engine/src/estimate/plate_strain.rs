//! Mean strains of plates from a displacement with plastic strain.
//!
//! The strain at a point of a corner or of a hinge grows without limit as the mesh becomes finer;
//! its mean over a prism as wide and as long as the plate is thick converges. The mean is exact for
//! the field but for the edges of excluded discs; how far the field is from the exact solution is
//! not known. So the numbers are estimates.
//!
//! # Source
//! EN 1993-1-5:2006 C.8: the principal membrane strain in tension is at most 5 %.

mod map;
mod prism;
mod sums;

use super::plate::Plate;
use crate::certify::PlasticField;
use crate::elements::space::Tet10Space;
use crate::model::AnalysisModel;
use bracket_base::math::eigen::eigen;
use bracket_base::math::mandel::symmetric_part;
use bracket_base::math::vec3::{M3, V3};
pub use map::membrane_at_nodes;
use prism::Prism;
use rayon::prelude::*;
use sums::Sums;

/// Pieces that the edge of a disc crosses are divided down to this part of the thickness.
const PIECE: f64 = 1.0 / 16.0;

/// A largest mean, and the middle of the prism where it is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Peak {
    /// The mean strain, a fraction; NaN if a strain is NaN.
    pub value: f64,
    /// Middle of the prism \[mm\].
    pub at: V3,
}

/// Largest mean strains of a plate; `None` where no prism is filled by half.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PlateStrain {
    /// Largest principal strain in the plane of the plate, tension positive: of the mean total
    /// strain over the whole depth of a prism t × t × t. The membrane strain of a plate.
    pub membrane: Option<Peak>,
    /// The same with the strains across the plane: the largest principal value of that mean tensor
    /// in all directions. Never less than `membrane`.
    pub tensile: Option<Peak>,
    /// Largest mean equivalent plastic strain `√(2/3) ‖ε_p‖` in a layer t × t × t/4 at either
    /// surface.
    pub surface: Option<Peak>,
}

/// The largest mean strains of each plate, in the order of the plates.
///
/// Prisms start at every half thickness along both directions of the plane. Those that the plate
/// fills by less than half do not count.
pub fn plate_strains(
    model: &AnalysisModel,
    field: &PlasticField,
    plates: &[Plate],
) -> Vec<PlateStrain> {
    let space = Tet10Space::new(&model.mesh);
    plates.par_iter().map(|plate| strain_of(model, field, &space, plate, PIECE)).collect()
}

/// The same of one plate; `piece`: see [`PIECE`].
fn strain_of(
    model: &AnalysisModel,
    field: &PlasticField,
    space: &Tet10Space,
    plate: &Plate,
    piece: f64,
) -> PlateStrain {
    match sums_of(model, field, space, plate, piece) {
        Some(sums) => peaks(&sums),
        None => PlateStrain::default(),
    }
}

/// The integrals over a plate; `None` without a volume.
fn sums_of<'a>(
    model: &AnalysisModel,
    field: &PlasticField,
    space: &Tet10Space,
    plate: &'a Plate,
    piece: f64,
) -> Option<Sums<'a>> {
    if !plate.is_solid() {
        return None;
    }
    let mut sums = Sums::new(plate, piece);
    for e in (0..model.mesh.tets.len()).filter(|&e| model.mesh.tet_body[e] == plate.body) {
        if sums.may_meet(&model.mesh.corners(e)) {
            field.pieces(model, space, e).iter().for_each(|tet| sums.add(tet));
        }
    }
    Some(sums)
}

/// The largest means of all prisms.
fn peaks(sums: &Sums<'_>) -> PlateStrain {
    let mut out = PlateStrain::default();
    let (extent, mirrored) = (sums.plate.extent[2], sums.plate.mirrored[2]);
    for prism in prisms(sums) {
        if let Some(mean) = prism.mean() {
            let middle = prism.middle(extent, mirrored);
            raise(&mut out.membrane, largest_in_plane(&mean), middle);
            raise(&mut out.tensile, largest(&mean), middle);
        }
        for layer in prism.surfaces() {
            if let Some(mean) = prism.equivalent(layer) {
                let ends = [sums.layers[layer], sums.layers[layer + 1]];
                raise(&mut out.surface, mean, prism.middle(ends, false));
            }
        }
    }
    out
}

/// Every prism of a plate.
fn prisms<'a>(sums: &'a Sums<'a>) -> impl Iterator<Item = Prism<'a>> {
    let [first, second] = &sums.plane;
    let of = move |a| second.windows.iter().map(move |b| Prism::new(sums, [a, b]));
    first.windows.iter().flat_map(of)
}

fn raise(peak: &mut Option<Peak>, value: f64, at: V3) {
    if peak.is_none_or(|p| value.is_nan() || value > p.value) {
        *peak = Some(Peak { value, at });
    }
}

/// Largest principal value.
fn largest(m: &M3) -> f64 {
    let (values, _) = eigen(&symmetric_part(m));
    values.into_iter().fold(f64::NEG_INFINITY, |a, b| if b.is_nan() { b } else { a.max(b) })
}

/// Largest principal value in the plane of the first two coordinates.
fn largest_in_plane(m: &M3) -> f64 {
    0.5 * (m[0][0] + m[1][1]) + (0.5 * (m[0][0] - m[1][1])).hypot(m[0][1])
}

#[cfg(test)]
mod tests;
