//! Closes ledges: offsets between a plate and a profile that are too small for elements.
//!
//! A plate as wide as the flange of its beam "to the millimetre" leaves a ledge of some hundredths
//! of a millimetre. Its elements would be thousands of times as long as thick. The faces of boxes
//! are therefore moved onto those of the profiles.

use super::assembly::{Assembly, MidPlane, OutlineEdge, Solid, Surface};
use bracket_base::math::vec3::{V3, cross};

/// Largest offset that is closed \[mm\], well below the tolerances of rolling and cutting
/// (EN 10034, EN 1090-2).
pub const LEDGE: f64 = 0.05;

/// Offsets below this are rounding \[mm\].
const ROUNDING: f64 = 1e-9;

/// Moves a coordinate along an axis.
type Onto<'a> = dyn FnMut(usize, &mut f64) + 'a;

/// Moves the faces of boxes, with all surfaces that are defined there, onto the faces of profiles
/// that are less than [`LEDGE`] away. Returns the largest move \[mm\], if there was one.
pub fn close(assembly: &mut Assembly) -> Option<f64> {
    let mut profiles = Places::default();
    assembly.parts.iter().for_each(|p| profiles.add(&p.solid));
    let mut largest = 0.0f64;
    let mut onto = |axis: usize, x: &mut f64| {
        if let Some(near) = profiles.nearest(axis, *x) {
            largest = largest.max((near - *x).abs());
            *x = near;
        }
    };
    for part in &mut assembly.parts {
        boxes(&mut part.solid, &mut onto);
        part.convex.iter_mut().for_each(|s| boxes(s, &mut onto));
        for MidPlane { axis, at, min, max } in &mut part.mid_planes {
            plane((*axis, at), [min, max], &mut onto);
        }
    }
    let interfaces =
        assembly.interfaces.iter_mut().filter_map(|i| Some(&mut i.surface.as_mut()?.1));
    let welds = assembly.welds.iter_mut().map(|w| &mut w.surface);
    let faces = assembly.faces.iter_mut().map(|f| &mut f.surface);
    let sections = assembly.sections.iter_mut().map(|s| &mut s.surface);
    for surface in interfaces.chain(welds).chain(faces).chain(sections) {
        if let Surface::Plane { axis, at, min, max } = surface {
            plane((*axis, at), [min, max], &mut onto);
        }
    }
    (largest > 0.0).then_some(largest)
}

fn plane((axis, at): (usize, &mut f64), [min, max]: [&mut V3; 2], onto: &mut Onto<'_>) {
    onto(axis, at);
    corners(min, max, onto);
}

fn corners(min: &mut V3, max: &mut V3, onto: &mut Onto<'_>) {
    (0..3).for_each(|k| {
        onto(k, &mut min[k]);
        onto(k, &mut max[k]);
    });
}

fn boxes(solid: &mut Solid, onto: &mut Onto<'_>) {
    match solid {
        Solid::Box { min, max } => corners(min, max, onto),
        Solid::Union(all) | Solid::Difference(all) => all.iter_mut().for_each(|s| boxes(s, onto)),
        Solid::Prism { .. } | Solid::Cylinder { .. } => {}
    }
}

/// Coordinates of the corners of profiles along x, y and z \[mm\].
#[derive(Default)]
struct Places([Vec<f64>; 3]);

impl Places {
    fn add(&mut self, solid: &Solid) {
        match solid {
            Solid::Prism { origin, u, v, start, edges, length } => {
                let along = cross(*u, *v).map(|n| n * length);
                let ends = edges.iter().map(|e| match e {
                    OutlineEdge::Line { to } | OutlineEdge::Arc { to, .. } => to,
                });
                // an oblique profile has a face across an axis only where its own directions lie
                // on it
                let across = |k: usize| {
                    [u[k], v[k], along[k] / length]
                        .iter()
                        .all(|c| c.abs() < 1e-9 || c.abs() > 1.0 - 1e-9)
                };
                for p in ends.chain([start]) {
                    for k in (0..3).filter(|k| across(*k)) {
                        let at = origin[k] + p[0] * u[k] + p[1] * v[k];
                        self.0[k].extend([at, at + along[k]]);
                    }
                }
            }
            Solid::Union(all) | Solid::Difference(all) => all.iter().for_each(|s| self.add(s)),
            Solid::Box { .. } | Solid::Cylinder { .. } => {}
        }
    }

    /// The nearest coordinate within [`LEDGE`]; `None`: there is none, or it is `x` itself.
    fn nearest(&self, axis: usize, x: f64) -> Option<f64> {
        let near =
            self.0[axis].iter().copied().min_by(|a, b| (a - x).abs().total_cmp(&(b - x).abs()))?;
        (ROUNDING..LEDGE).contains(&(near - x).abs()).then_some(near)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::assembly::tests::ok;

    fn splice(width: &str, z: &str) -> String {
        format!(
            "{{template: beam_splice, members: {{beam: {{profile: W10X77, steel: S355}}}}, plate: \
             {{thickness: 20, width: {width}, z: {z}}}, bolts: {{size: M20, grade: '8.8', rows: \
             [-80, 80]}}, loads: [{{name: A, end: beam_right, at: bolt_plane, My: 10 kN m}}]}}"
        )
    }

    fn plate(assembly: &Assembly) -> [V3; 2] {
        let part = assembly.parts.iter().find(|p| p.name == "PLATE_R").expect("a plate");
        let Solid::Difference(list) = &part.solid else { panic!("holes") };
        let Solid::Box { min, max } = list[0] else { panic!("a box") };
        [min, max]
    }

    /// W10X77 is 269.24 mm × 259.08 mm.
    #[test]
    fn plates_as_large_as_the_profile_to_a_tenth_meet_its_edges() {
        let joint = ok(&splice("259.1", "[-134.65, 200]"));
        let [min, max] = plate(&joint.assembly);
        assert!(
            (max[1] - 129.54).abs() < 1e-9 && (min[1] + 129.54).abs() < 1e-9,
            "{min:?} {max:?}"
        );
        assert!((min[2] + 134.62).abs() < 1e-9 && max[2] == 200.0, "{min:?} {max:?}");
        let faces = joint.assembly.interfaces.iter().filter_map(|i| Some(&i.surface.as_ref()?.1));
        let contact = faces.filter_map(|s| match s {
            Surface::Plane { axis: 0, max, .. } => Some(max[1]),
            _ => None,
        });
        assert!(contact.into_iter().any(|y| (y - 129.54).abs() < 1e-9));
        assert!(
            joint.notes.iter().any(|n| n.to_string().contains("0.030 mm")),
            "{:?}",
            joint.notes
        );
    }

    #[test]
    fn plates_that_differ_or_agree_stay() {
        for width in ["259.3", "259.08", "280"] {
            let joint = ok(&splice(width, "[-150, 200]"));
            let half = 0.5 * width.parse::<f64>().expect("a number");
            assert!((plate(&joint.assembly)[1][1] - half).abs() < 1e-12, "{width}");
            assert!(joint.notes.is_empty(), "{:?}", joint.notes);
        }
    }
}
