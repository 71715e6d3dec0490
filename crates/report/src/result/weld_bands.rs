//! The flat bands in which the forces along a weld are measured.

use bracket_base::math::vec3::{V3, scale};
use bracket_engine::estimate::weld_forces::WeldBand;
use bracket_engine::model::AnalysisModel;
use bracket_engine::model::analysis::FacePair;
use bracket_joint::assembly::assembly::{Surface, SymmetryPlane, WeldRule};
use bracket_joint::assembly::axes;
use std::collections::BTreeMap;
use std::f64::consts::TAU;

/// Least length over which the forces of a weld are averaged, beside six throats \[mm\].
const LENGTH: f64 = 30.0;
/// Pieces of the weld round a circular section.
const SECTORS: f64 = 16.0;

/// The bands of a weld: one of a plate, the walls of a rectangular hollow section, sectors of a
/// circular one. None of a weld on a curved surface.
pub(super) fn weld_bands(
    rule: &WeldRule,
    faces: &[FacePair],
    model: &AnalysisModel,
    symmetry: &[SymmetryPlane],
) -> Vec<WeldBand> {
    let Surface::Plane { axis, min, max, .. } = rule.surface else { return Vec::new() };
    let size = |k: usize| max[k] - min[k];
    let [first, second] = axes::across(axis);
    let (halved, _) = rule.surface.halved_by(symmetry);
    let straight = |faces: Vec<FacePair>, along: usize, mirrored_across: bool| WeldBand {
        faces,
        along: unit(along),
        length: (size(along) / 4.0).min((6.0 * rule.throat).max(LENGTH)),
        mirrored_along: halved.contains(&along),
        mirrored_across,
    };
    if !rule.closed {
        let off = |k: usize| (size(k) - rule.thickness).abs();
        // the plate is as thick as the weld's interface is wide
        let (along, across) =
            if off(first) > off(second) { (first, second) } else { (second, first) };
        return vec![straight(faces.to_vec(), along, halved.contains(&across))];
    }
    // places of the faces from the middle of the section, over half of its sizes
    let place = |f: &FacePair| {
        let corners = f.nodes_a.map(|n| model.mesh.nodes[n as usize]);
        [first, second].map(|k| {
            let middle = corners.iter().map(|x| x[k]).sum::<f64>() / 3.0;
            (2.0 * middle - min[k] - max[k]) / size(k)
        })
    };
    // only a rectangle has faces beyond the ellipse
    let round = faces.iter().map(place).all(|[a, b]| a.hypot(b) <= 1.0 + 1e-6);
    let side = |f: &FacePair| {
        let [a, b] = place(f);
        match round {
            true => (b.atan2(a) / TAU * SECTORS).round().rem_euclid(SECTORS) as usize,
            false if a.abs() >= b.abs() => usize::from(a > 0.0),
            false => 2 + usize::from(b > 0.0),
        }
    };
    let mut sides: BTreeMap<usize, Vec<FacePair>> = BTreeMap::new();
    for face in faces {
        sides.entry(side(face)).or_default().push(*face);
    }
    let band = |(side, faces): (usize, Vec<FacePair>)| match round {
        true => {
            let angle = TAU * side as f64 / SECTORS;
            let tangent = [scale(-angle.sin(), unit(first)), scale(angle.cos(), unit(second))];
            WeldBand {
                faces,
                along: std::array::from_fn(|k| tangent[0][k] + tangent[1][k]),
                // one piece
                length: size(first) + size(second),
                mirrored_along: false,
                mirrored_across: false,
            }
        }
        false => straight(faces, if side < 2 { second } else { first }, false),
    };
    sides.into_iter().map(band).collect()
}

/// The unit vector of an axis.
fn unit(axis: usize) -> V3 {
    std::array::from_fn(|k| f64::from(u8::from(k == axis)))
}
