//! Bolts that the loads may pull.
//!
//! The bolts between the same parts form a group. Where all supports lie on one side of the group,
//! the loads on the other side pass through it. Their force and moment are distributed over the
//! bolts linearly. Where both sides are supported, every bolt may be pulled.
//!
//! A load on a face that crosses the grip comes along the plies: the bolt laps them and is sheared.

use super::shank::Shank;
use crate::assembly::Assembly;
use crate::assembly::assembly::{Action, FaceRule, PartRole, Surface};
use bracket_base::math::vec3::{V3, add, cross, dot, sub};
use std::collections::BTreeSet;

/// Distance within which two planes count as one \[mm\].
const SAME: f64 = 1.0;

/// Forces below this fraction of the largest in the group count as no pull.
const NO_PULL: f64 = 0.01;

/// True unless every load case presses the bolt or leaves it without force.
pub(super) fn may_be(assembly: &Assembly, bolt: &Shank) -> bool {
    if laps(assembly, bolt) {
        return false;
    }
    let group: Vec<V3> = assembly
        .parts
        .iter()
        .filter(|p| p.role == PartRole::Bolt)
        .filter_map(|p| Shank::of(&p.solid))
        .filter(|s| s.axis == bolt.axis && (s.start[s.axis] - bolt.start[bolt.axis]).abs() < SAME)
        .map(|s| s.start)
        .collect();
    let Some(out) = loaded_side(assembly, bolt) else { return true };
    let cases: BTreeSet<&str> = assembly.loads.iter().map(|l| l.case.as_str()).collect();
    cases.into_iter().any(|case| match through(assembly, bolt, out, case) {
        None => true,
        Some((force, moment, at)) => pulls(bolt, &group, out, force, moment, at),
    })
}

/// True if the face of a load crosses the grip of the bolt.
fn laps(assembly: &Assembly, bolt: &Shank) -> bool {
    let crossed = |f: &FaceRule| [1.0, -1.0].iter().all(|out| beyond(f, bolt, *out).is_none());
    let faces =
        assembly.loads.iter().filter_map(|l| assembly.faces.iter().find(|f| f.name == l.face));
    faces.into_iter().any(crossed)
}

/// The side of the bolt's grip, +1 or −1 along its axis, without any support.
fn loaded_side(assembly: &Assembly, bolt: &Shank) -> Option<f64> {
    let held = |out: f64| {
        assembly.supports.iter().any(|s| {
            let face = assembly.faces.iter().find(|f| f.name == s.face);
            face.is_none_or(|f| beyond(f, bolt, out) != Some(false))
        })
    };
    [1.0, -1.0].into_iter().find(|&out| !held(out))
}

/// True if a face lies wholly beyond the bolt's grip on the side `out`, false if none of it does;
/// `None` if it crosses the grip.
fn beyond(face: &FaceRule, bolt: &Shank, out: f64) -> Option<bool> {
    let k = bolt.axis;
    let (low, high) = match &face.surface {
        Surface::Plane { axis, at, .. } if *axis == k => (*at, *at),
        Surface::Plane { min, max, .. } => (min[k], max[k]),
        Surface::Mantle { .. } => return None,
    };
    let (near, far, end) = if out > 0.0 {
        (low, high, bolt.start[k] + bolt.length)
    } else {
        (-high, -low, -bolt.start[k])
    };
    match () {
        () if near > end - SAME => Some(true),
        () if far < end - SAME => Some(false),
        () => None,
    }
}

/// Force and moment of a load case on the side `out`, about the last of the three vectors; `None`
/// if they are not known.
fn through(assembly: &Assembly, bolt: &Shank, out: f64, case: &str) -> Option<(V3, V3, V3)> {
    let about = bolt.start;
    let (mut force, mut moment) = ([0.0; 3], [0.0; 3]);
    for load in assembly.loads.iter().filter(|l| l.case == case) {
        let face = assembly.faces.iter().find(|f| f.name == load.face)?;
        if !beyond(face, bolt, out)? {
            continue;
        }
        let (f, m, at) = match (load.action, &face.surface) {
            (Action::Resultant { at, force, moment }, _) => (force, moment, at),
            (Action::Traction(t), Surface::Plane { axis, at, min, max }) => {
                let mut centre: V3 = std::array::from_fn(|k| 0.5 * (min[k] + max[k]));
                centre[*axis] = *at;
                let sides = [(axis + 1) % 3, (axis + 2) % 3].map(|k| max[k] - min[k]);
                (t.map(|c| c * sides[0] * sides[1]), [0.0; 3], centre)
            }
            (Action::Linear { .. }, _) | (Action::Traction(_), Surface::Mantle { .. }) => {
                return None;
            }
        };
        force = add(force, f);
        moment = add(moment, add(m, cross(sub(at, about), f)));
    }
    Some((force, moment, about))
}

/// True if force and moment, distributed linearly over the group, pull the bolt.
fn pulls(bolt: &Shank, group: &[V3], out: f64, force: V3, moment: V3, at: V3) -> bool {
    let n = group.len() as f64;
    let centre: V3 = std::array::from_fn(|k| group.iter().map(|p| p[k]).sum::<f64>() / n);
    let moment = add(moment, cross(sub(at, centre), force));
    let mut outward = [0.0; 3];
    outward[bolt.axis] = out;
    let mut slopes = [0.0; 3];
    for k in (0..3).filter(|&k| k != bolt.axis) {
        let mut unit = [0.0; 3];
        unit[k] = 1.0;
        let squares: f64 = group.iter().map(|p| (p[k] - centre[k]).powi(2)).sum();
        if squares > SAME {
            slopes[k] = dot(moment, cross(unit, outward)) / squares;
        }
    }
    let tension = |p: V3| dot(force, outward) / n + dot(slopes, sub(p, centre));
    let largest = group.iter().map(|p| tension(*p).abs()).fold(0.0, f64::max);
    tension(bolt.start) > NO_PULL * largest
}
