//! The flat bands in which the forces along a weld are measured.

use bracket_base::math::vec3::{self, V3, scale};
use bracket_engine::estimate::weld_forces::WeldBand;
use bracket_engine::model::analysis::FacePair;
use bracket_joint::assembly::assembly::{Surface, SymmetryPlane, WeldRule};
use bracket_joint::assembly::axes::{self, unit};
use std::collections::BTreeMap;
use std::f64::consts::TAU;

/// Least length over which the forces of a weld are averaged, beside six throats \[mm\].
const LENGTH: f64 = 30.0;
/// Pieces of the weld round a circular section.
const SECTORS: f64 = 16.0;

/// The bands of a weld: one of a plate, the walls of a rectangular hollow section, sectors of a
/// circular one. None of a weld on a curved surface. `nodes`: coordinates of the mesh.
pub(super) fn weld_bands(
    rule: &WeldRule,
    faces: &[FacePair],
    nodes: &[V3],
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
        let corners = f.nodes_a.map(|n| nodes[n as usize]);
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
            WeldBand {
                faces,
                along: vec3::along(scale(-angle.sin(), unit(first)), angle.cos(), unit(second)),
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

#[cfg(test)]
mod tests {
    use super::*;
    use bracket_base::math::vec3::{dot, norm};
    use bracket_engine::model::analysis::BoundaryFace;
    use bracket_joint::strength::{Nominal, WeldSteel};

    /// Triangles of a ring between an outer and an inner line, given as points from the middle.
    fn ring(outer: &[[f64; 2]], inner: &[[f64; 2]]) -> (Vec<FacePair>, Vec<V3>) {
        let count = outer.len() as u32;
        let nodes = outer.iter().chain(inner).map(|[x, y]| [*x, *y, 30.0]).collect();
        let side = BoundaryFace { tet: 0, local: 0 };
        let face = |nodes: [u32; 3]| FacePair { a: side, b: side, nodes_a: nodes, nodes_b: nodes };
        let faces = (0..count).flat_map(|i| {
            let next = (i + 1) % count;
            [[i, next, count + i], [next, count + next, count + i]].map(face)
        });
        (faces.collect(), nodes)
    }

    fn rule([width, depth]: [f64; 2]) -> WeldRule {
        let half = [0.5 * width, 0.5 * depth];
        WeldRule {
            name: "WELD".into(),
            between: ["COLUMN".into(), "PLATE".into()],
            surface: Surface::Plane {
                axis: 2,
                at: 30.0,
                min: [-half[0], -half[1], 30.0],
                max: [half[0], half[1], 30.0],
            },
            imprint: true,
            throat: 5.0,
            thickness: 16.0,
            length: None,
            closed: true,
            steel: WeldSteel { fu: Nominal::new(360.0), beta_w: 0.8 },
        }
    }

    /// Every face is in one band, whose line runs along the wall there: across the way from the
    /// middle of the section to the nearest wall.
    #[test]
    fn a_closed_weld_has_a_band_for_each_wall_or_sector() {
        let circle = |r: f64| -> Vec<[f64; 2]> {
            let at = |i: usize| TAU * (i as f64 + 0.3) / 48.0;
            (0..48).map(|i| [r * at(i).cos(), r * at(i).sin()]).collect()
        };
        let (faces, nodes) = ring(&circle(100.0), &circle(92.0));
        let bands = weld_bands(&rule([200.0, 200.0]), &faces, &nodes, &[]);
        assert_eq!(bands.len(), 16);
        assert_eq!(bands.iter().map(|b| b.faces.len()).sum::<usize>(), 96);
        for band in &bands {
            assert!((norm(band.along) - 1.0).abs() < 1e-12);
            for node in band.faces.iter().flat_map(|f| f.nodes_a) {
                let [x, y, _] = nodes[node as usize];
                let lean = dot([x, y, 0.0], band.along).abs() / x.hypot(y);
                assert!(lean < (TAU / 32.0 + TAU / 48.0).sin(), "{lean}");
            }
        }

        // 200 × 100 × 8: a point every 10 mm along the outside
        let walls = |[w, h]: [f64; 2]| -> Vec<[f64; 2]> {
            let corners = [[-w, -h], [w, -h], [w, h], [-w, h]];
            let step = |i: usize, k: usize| {
                let ([a, b], [c, d]) = (corners[i], corners[(i + 1) % 4]);
                let t = k as f64 / 10.0;
                [a + t * (c - a), b + t * (d - b)]
            };
            (0..4).flat_map(|i| (0..10).map(move |k| step(i, k))).collect()
        };
        let (faces, nodes) = ring(&walls([100.0, 50.0]), &walls([92.0, 42.0]));
        let quarter = [SymmetryPlane { axis: 1 }];
        let bands = weld_bands(&rule([200.0, 100.0]), &faces, &nodes, &quarter);
        let along: Vec<V3> = bands.iter().map(|b| b.along).collect();
        let (x, y) = ([1.0, 0.0, 0.0], [0.0, 1.0, 0.0]);
        assert_eq!(along, [y, y, x, x]);
        let mirrored: Vec<bool> = bands.iter().map(|b| b.mirrored_along).collect();
        assert_eq!(mirrored, [true, true, false, false], "the walls across x are halved");
        assert!(bands.iter().all(|b| b.faces.len() == 20 && !b.mirrored_across));
    }
}
