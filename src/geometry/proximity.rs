//! Clashes, thin gaps, missing contacts and clearances, checked before meshing and reported with
//! part names.
//!
//! The mesher does not detect overlaps: it drops bodies and reports success. Gaps far below the
//! element size spoil its mesh. parry finds the close pairs. The overlap of material is then
//! computed from the solids themselves, so that a bolt in its hole is not a clash.

use super::error::GeometryError;
use super::flat::{Bounds, FlatSolid};
use super::line::{Line, intersect};
use crate::assembly::Assembly;
use crate::assembly::assembly::{Part, Solid};
use crate::diag::{Diagnostic, Diagnostics};
use crate::math::vec3::V3;
use parry3d_f64::math::{Pose, Vector};
use parry3d_f64::query;
use parry3d_f64::shape::ConvexPolyhedron;

/// Largest overlap that still counts as contact \[mm\].
pub const TOUCH: f64 = 1e-3;

/// Gaps between `TOUCH` and this value are rejected \[mm\].
pub const SMALLEST_GAP: f64 = 1.0;

/// Number of lines per direction that search for overlapping material. They are quasi-random, so
/// that no regular pattern of features falls between them.
const PROBES: usize = 900;

/// Largest extent of the region common to two parts that one search for slivers covers \[mm\].
const ONE_SEARCH: f64 = 80.0;

/// A convex piece of a part, relative to its centre for precision.
struct Piece {
    shape: ConvexPolyhedron,
    pose: Pose,
    bounds: Bounds,
}

struct Checked<'a> {
    part: &'a Part,
    solid: FlatSolid,
    bounds: Bounds,
    pieces: Vec<Piece>,
}

/// Checks names, clashes, gaps, contacts and clearances, and reports all faults at once. `None` if
/// `stop` became true before the end.
pub fn check(assembly: &Assembly, stop: &dyn Fn() -> bool) -> Option<Result<(), Diagnostics>> {
    let mut faults = super::validate::faults(assembly);
    if faults.is_empty() {
        faults = proximity_faults(assembly, stop)?;
    }
    Some(Diagnostics::refuse(faults.into_iter().map(Diagnostic::from).collect()))
}

fn proximity_faults(assembly: &Assembly, stop: &dyn Fn() -> bool) -> Option<Vec<GeometryError>> {
    let parts: Vec<Checked> = assembly.parts.iter().map(prepare).collect();
    let mut faults = Vec::new();
    for (i, a) in parts.iter().enumerate() {
        for b in &parts[i + 1..] {
            if !a.bounds.near(&b.bounds, SMALLEST_GAP) {
                continue;
            }
            if stop() {
                return None;
            }
            if let Some((depth, at)) = overlap(a, b) {
                faults.push(GeometryError::Clash {
                    pair: pair(a.part, b.part),
                    depth,
                    limit: TOUCH,
                    at,
                });
            } else if let Some(gap) = sliver(a, b) {
                faults.push(GeometryError::Sliver {
                    pair: pair(a.part, b.part),
                    gap,
                    limit: SMALLEST_GAP,
                });
            }
        }
    }
    let find = |name: &str| parts.iter().find(|p| p.part.name == name);
    let mut asked: Vec<[&str; 2]> = Vec::new();
    for rule in &assembly.interfaces {
        if stop() {
            return None;
        }
        let names = [rule.between[0].as_str(), rule.between[1].as_str()];
        let (Some(a), Some(b)) = (find(names[0]), find(names[1])) else { continue };
        let gap = distance(a, b);
        if gap >= SMALLEST_GAP && !asked.contains(&names) {
            asked.push(names);
            faults.push(GeometryError::Apart { pair: pair(a.part, b.part), gap });
        }
    }
    for rule in &assembly.clearances {
        let (Some(a), Some(b)) = (find(&rule.between[0]), find(&rule.between[1])) else { continue };
        let distance = distance(a, b);
        if distance < rule.min - TOUCH {
            faults.push(GeometryError::Clearance {
                pair: pair(a.part, b.part),
                distance,
                min: rule.min,
                reason: rule.reason.clone(),
            });
        }
    }
    Some(faults)
}

/// Descriptions of both parts, such as `the end plate of the right beam (PLATE_R)`.
fn pair(a: &Part, b: &Part) -> [String; 2] {
    [a, b].map(|p| format!("the {} ({})", p.label, p.name))
}

fn prepare(part: &Part) -> Checked<'_> {
    let solid = FlatSolid::from_solid(&part.solid);
    let bounds = solid.bounds();
    let mut pieces: Vec<Piece> = part.convex.iter().filter_map(piece).collect();
    if pieces.is_empty() {
        pieces.extend(piece(&Solid::Box { min: bounds.min, max: bounds.max }));
    }
    Checked { part, solid, bounds, pieces }
}

fn piece(solid: &Solid) -> Option<Piece> {
    let flat = FlatSolid::from_solid(solid);
    let bounds = flat.bounds();
    let centre: V3 = std::array::from_fn(|k| 0.5 * (bounds.min[k] + bounds.max[k]));
    let points: Vec<Vector> = flat
        .prisms()
        .iter()
        .flat_map(|p| p.corners())
        .map(|c| Vector::new(c[0] - centre[0], c[1] - centre[1], c[2] - centre[2]))
        .collect();
    let shape = ConvexPolyhedron::from_convex_hull(&points)?;
    Some(Piece { shape, pose: Pose::translation(centre[0], centre[1], centre[2]), bounds })
}

/// Overlap of two parts' material: its depth and a point in it. For each coordinate axis the
/// longest interval common to both parts on a parallel line is found; the depth is the shortest of
/// the three.
fn overlap(a: &Checked, b: &Checked) -> Option<(f64, V3)> {
    let mut worst: Option<(f64, V3)> = None;
    for p in &a.pieces {
        for q in &b.pieces {
            if !p.bounds.near(&q.bounds, 0.0) {
                continue;
            }
            let contact = query::contact(&p.pose, &p.shape, &q.pose, &q.shape, 0.0).ok().flatten();
            if contact.is_none_or(|c| c.dist >= -TOUCH) {
                continue;
            }
            let min: V3 = std::array::from_fn(|k| p.bounds.min[k].max(q.bounds.min[k]));
            let max: V3 = std::array::from_fn(|k| p.bounds.max[k].min(q.bounds.max[k]));
            let found = common_material(&a.solid, &b.solid, min, max);
            if let Some((depth, at)) = found
                && depth > TOUCH
                && worst.is_none_or(|(d, _)| depth > d)
            {
                worst = Some((depth, at));
            }
        }
    }
    worst
}

/// Quasi-random lines along one axis through a box. The additive recurrence of the plastic number
/// covers the rectangle evenly. The line parameter is zero at the box's lower face.
fn probes(axis: usize, min: V3, max: V3) -> impl Iterator<Item = Line> {
    let (i, j) = ((axis + 1) % 3, (axis + 2) % 3);
    let mut direction = [0.0; 3];
    direction[axis] = 1.0;
    (1..=PROBES).map(move |n| {
        let f = |alpha: f64| (0.5 + alpha * n as f64).fract();
        let mut start = min;
        start[i] += f(0.754_877_666_246_692_8) * (max[i] - min[i]);
        start[j] += f(0.569_840_290_998_053_2) * (max[j] - min[j]);
        Line { start, direction }
    })
}

/// For each axis the longest common interval inside a box; returns the smallest of the three and
/// its midpoint.
fn common_material(a: &FlatSolid, b: &FlatSolid, min: V3, max: V3) -> Option<(f64, V3)> {
    let (a, b) = (&a.within(&Bounds { min, max })?, &b.within(&Bounds { min, max })?);
    let mut thinnest: Option<(f64, V3)> = None;
    for axis in 0..3 {
        let mut longest: Option<(f64, V3)> = None;
        for line in probes(axis, min, max) {
            let inside = line.through(a);
            if inside.is_empty() {
                continue;
            }
            let common =
                intersect(&intersect(&inside, &line.through(b)), &[[0.0, max[axis] - min[axis]]]);
            for s in common {
                if longest.is_none_or(|(l, _)| s[1] - s[0] > l) {
                    let mut at = line.start;
                    at[axis] += 0.5 * (s[0] + s[1]);
                    longest = Some((s[1] - s[0], at));
                }
            }
        }
        let found = longest?;
        if thinnest.is_none_or(|(l, _)| found.0 < l) {
            thinnest = Some(found);
        }
    }
    thinnest
}

/// Smallest gap between the two parts that is neither contact nor sufficient clearance.
///
/// Where pieces come close, the gap is measured in the solids with lines: the pieces around a hole
/// keep clear of a shank that fills the hole, although the solids touch.
fn sliver(a: &Checked, b: &Checked) -> Option<f64> {
    let common = |p: &Bounds, q: &Bounds| Bounds {
        min: std::array::from_fn(|k| p.min[k].max(q.min[k]) - SMALLEST_GAP),
        max: std::array::from_fn(|k| p.max[k].min(q.max[k]) + SMALLEST_GAP),
    };
    let close = |p: &&Piece, q: &&Piece| {
        let meet = p.bounds.near(&q.bounds, SMALLEST_GAP);
        let distance = || query::distance(&p.pose, &p.shape, &q.pose, &q.shape);
        meet && distance().is_ok_and(|d| d.distance > TOUCH && d.distance < SMALLEST_GAP)
    };
    let mut pairs = a.pieces.iter().flat_map(|p| {
        b.pieces.iter().filter(move |q| close(&p, q)).map(move |q| common(&p.bounds, &q.bounds))
    });
    // around a bolt many pieces are close: one search covers all of them
    let whole = common(&a.bounds, &b.bounds);
    let boxes = if (0..3).all(|k| whole.max[k] - whole.min[k] <= ONE_SEARCH) {
        pairs.next().map(|_| whole).into_iter().collect()
    } else {
        pairs.collect::<Vec<_>>()
    };
    let gaps = boxes.into_iter().filter_map(|of| {
        let (near_a, near_b) = (a.solid.within(&of)?, b.solid.within(&of)?);
        let of_axis = |axis| thin_air(&near_a, &near_b, axis, of.min, of.max);
        (0..3).filter_map(of_axis).reduce(f64::min)
    });
    gaps.reduce(f64::min)
}

/// Shortest interval outside both solids, with a length in (`TOUCH`, `SMALLEST_GAP`), on lines
/// along an axis through a box.
fn thin_air(a: &FlatSolid, b: &FlatSolid, axis: usize, min: V3, max: V3) -> Option<f64> {
    let thin = |d: f64| d > TOUCH && d < SMALLEST_GAP;
    let mut shortest: Option<f64> = None;
    for line in probes(axis, min, max) {
        let within = [[0.0, max[axis] - min[axis]]];
        let [in_a, in_b] = [a, b].map(|solid| intersect(&line.through(solid), &within));
        for s in &in_a {
            for t in &in_b {
                for gap in [t[0] - s[1], s[0] - t[1]] {
                    if thin(gap) {
                        shortest = Some(shortest.map_or(gap, |x| x.min(gap)));
                    }
                }
            }
        }
    }
    shortest
}

fn distance(a: &Checked, b: &Checked) -> f64 {
    let mut smallest = f64::INFINITY;
    for p in &a.pieces {
        for q in &b.pieces {
            // the boxes are no farther apart than the pieces
            if p.bounds.distance(&q.bounds) >= smallest {
                continue;
            }
            if let Ok(d) = query::distance(&p.pose, &p.shape, &q.pose, &q.shape) {
                smallest = smallest.min(d.distance);
            }
        }
    }
    smallest
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::fixtures::{lap_joint, paper_joint};

    fn messages(assembly: &Assembly) -> Vec<(String, String)> {
        match check(assembly, &|| false).expect("not stopped") {
            Ok(()) => vec![],
            Err(d) => d.into_iter().map(|d| (d.code.to_string(), d.message)).collect(),
        }
    }

    #[test]
    fn a_stopped_check_gives_no_answer() {
        assert!(check(&paper_joint(), &|| true).is_none());
    }

    #[test]
    fn sound_joints_pass() {
        assert_eq!(messages(&lap_joint()), vec![]);
        assert_eq!(messages(&paper_joint()), vec![]);
    }

    #[test]
    fn bolt_head_in_the_other_plate_is_a_clash() {
        let mut joint = lap_joint();
        // The bolt moves 3 mm along its axis, and its head enters the upper plate.
        crate::geometry::fixtures::move_part(&mut joint, "BOLT", [0.0, 0.0, -3.0]);
        let m = messages(&joint);
        assert!(
            m.iter().any(|(c, t)| c == "geometry/clash"
                && t.contains("bolt (BOLT)")
                && t.contains("3.000 mm")),
            "{m:?}"
        );
    }

    #[test]
    fn overlapping_bolts_are_named() {
        let mut joint = paper_joint();
        // The bolt at −125 mm moves to 7 mm below the one at 110 mm: heads and shanks overlap.
        crate::geometry::fixtures::move_part(&mut joint, "BOLT_RP2", [0.0, 0.0, 228.0]);
        let m = messages(&joint);
        assert!(
            m.iter().any(|(c, t)| c == "geometry/clash"
                && t.contains("BOLT_RP2")
                && t.contains("BOLT_RP3")),
            "{m:?}"
        );
    }

    #[test]
    fn half_a_millimetre_of_air_is_refused() {
        let mut joint = lap_joint();
        crate::geometry::fixtures::move_part(&mut joint, "LOWER", [0.0, 0.0, -0.5]);
        let m = messages(&joint);
        assert!(
            m.iter()
                .any(|(c, t)| c == "geometry/gap" && t.contains("LOWER") && t.contains("0.500 mm")),
            "{m:?}"
        );
    }

    #[test]
    fn pieces_that_leave_room_around_a_shank_are_no_gap() {
        let mut joint = lap_joint();
        // Convex pieces of the upper plate with a square window half a millimetre wider than the
        // hole.
        let upper = joint.parts.iter_mut().find(|p| p.name == "UPPER").expect("the fixture has it");
        let cuboid = |x: [f64; 2], y: [f64; 2]| Solid::Box {
            min: [x[0], y[0], 0.0],
            max: [x[1], y[1], 10.0],
        };
        upper.convex = vec![
            cuboid([-40.0, -8.5], [-30.0, 30.0]),
            cuboid([8.5, 40.0], [-30.0, 30.0]),
            cuboid([-8.5, 8.5], [-30.0, -8.5]),
            cuboid([-8.5, 8.5], [8.5, 30.0]),
        ];
        assert_eq!(messages(&joint), vec![]);
    }

    #[test]
    fn contact_between_parts_apart_is_refused() {
        let mut joint = lap_joint();
        crate::geometry::fixtures::move_part(&mut joint, "LOWER", [0.0, 0.0, -8.0]);
        let m = messages(&joint);
        assert!(m.iter().any(|(c, t)| c == "geometry/apart" && t.contains("8.000 mm")), "{m:?}");
    }

    #[test]
    fn clearance_too_small_gives_reason_and_numbers() {
        let mut joint = paper_joint();
        joint.clearances.push(crate::assembly::assembly::Clearance {
            between: ["BOLT_RP1".into(), "BOLT_RP2".into()],
            min: 70.0,
            reason: "wrench".into(),
        });
        let m = messages(&joint);
        // pitch of 90 mm minus the width across flats of 27 mm
        assert!(
            m.len() == 1 && m[0].0 == "geometry/clearance" && m[0].1.contains("63.0 mm"),
            "{m:?}"
        );
    }
}
