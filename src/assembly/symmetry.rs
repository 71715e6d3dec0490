//! Symmetry of a whole joint: geometry, materials, interfaces, supports and loads against their
//! mirror images.
//!
//! Solids are compared as sets of rounded points, so that it does not matter in which order or
//! sense a template draws them.

use super::assembly::{
    Action, Assembly, BoltPreload, OutlineEdge, Solid, Surface, SymmetryPlane, WeldRule,
};
use crate::spec::friction::FrictionLaw;
use std::collections::BTreeMap;

/// Coordinates that agree to this are the same \[mm\].
const SAME: f64 = 1e-6;

type Point = [i64; 3];

fn round(x: [f64; 3], mirror: Option<usize>) -> Point {
    let mut p = x.map(|c| (c / SAME).round() as i64);
    if let Some(axis) = mirror {
        // a number too large for the grid stands at its end, which has no opposite
        p[axis] = p[axis].saturating_neg();
    }
    p
}

fn scalar(x: f64) -> i64 {
    (x / SAME).round() as i64
}

/// A shape as data that compare equal exactly when the shapes are the same.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Signature {
    /// Vertices, centres of arcs, a length that points do not show.
    Points(Vec<Point>, Vec<Point>, i64),
    Union(Vec<Signature>),
    Difference(Box<Signature>, Vec<Signature>),
}

fn corners(min: [f64; 3], max: [f64; 3], mirror: Option<usize>) -> Vec<Point> {
    let mut out: Vec<Point> = (0..8)
        .map(|i: usize| {
            round([0, 1, 2].map(|k| if i >> k & 1 == 0 { min[k] } else { max[k] }), mirror)
        })
        .collect();
    out.sort_unstable();
    out
}

fn ends(base: [f64; 3], axis: [f64; 3], length: f64, mirror: Option<usize>) -> Vec<Point> {
    let far = [0, 1, 2].map(|k| base[k] + length * axis[k]);
    let mut out = vec![round(base, mirror), round(far, mirror)];
    out.sort_unstable();
    out
}

fn signature(solid: &Solid, mirror: Option<usize>) -> Signature {
    let each = |list: &[Solid]| {
        let mut s: Vec<Signature> = list.iter().map(|x| signature(x, mirror)).collect();
        s.sort();
        s
    };
    match solid {
        Solid::Box { min, max } => Signature::Points(corners(*min, *max, mirror), Vec::new(), 0),
        Solid::Cylinder { base, axis, radius, length, .. } => {
            Signature::Points(ends(*base, *axis, *length, mirror), Vec::new(), scalar(*radius))
        }
        Solid::Prism { origin, u, v, start, edges, length } => {
            let n = crate::math::vec3::cross(*u, *v);
            let at = |q: [f64; 2], h: f64| {
                round([0, 1, 2].map(|k| origin[k] + q[0] * u[k] + q[1] * v[k] + h * n[k]), mirror)
            };
            let (mut points, mut centres) =
                (vec![at(*start, 0.0), at(*start, *length)], Vec::new());
            for e in edges {
                let (OutlineEdge::Line { to } | OutlineEdge::Arc { to, .. }) = e;
                points.extend([at(*to, 0.0), at(*to, *length)]);
                if let OutlineEdge::Arc { centre, .. } = e {
                    centres.push(at(*centre, 0.0));
                    centres.push(at(*centre, *length));
                }
            }
            points.sort_unstable();
            points.dedup();
            centres.sort_unstable();
            Signature::Points(points, centres, 0)
        }
        Solid::Union(list) => Signature::Union(each(list)),
        Solid::Difference(list) => match list.split_first() {
            Some((first, rest)) => {
                Signature::Difference(Box::new(signature(first, mirror)), each(rest))
            }
            None => Signature::Union(Vec::new()),
        },
    }
}

fn surface(s: &Surface, mirror: Option<usize>) -> Signature {
    match s {
        Surface::Plane { axis, at, min, max } => {
            let (mut lo, mut hi) = (*min, *max);
            (lo[*axis], hi[*axis]) = (*at, *at);
            Signature::Points(corners(lo, hi, mirror), Vec::new(), -1)
        }
        Surface::Mantle { base, axis, radius, length } => {
            Signature::Points(ends(*base, *axis, *length, mirror), Vec::new(), scalar(*radius))
        }
    }
}

/// What acts on a face: traction, or point, force and moment. A mirror turns moments the other way
/// round, but for the one about its normal.
fn action(a: &Action, mirror: Option<usize>) -> Vec<Point> {
    match *a {
        Action::Traction(t) => vec![round(t, mirror)],
        Action::Resultant { at, force, moment } => {
            let turned = mirror.map_or(moment, |axis| {
                std::array::from_fn(|k| if k == axis { moment[k] } else { -moment[k] })
            });
            vec![round(at, mirror), round(force, mirror), round(turned, None)]
        }
    }
}

/// Everything about a joint that symmetry must keep, with part names replaced by numbers of equal
/// shapes.
fn portrait(a: &Assembly, mirror: Option<usize>) -> impl PartialEq + use<> {
    let shapes: BTreeMap<&str, (Signature, &str, i64)> = a
        .parts
        .iter()
        .map(|p| {
            (p.name.as_str(), (signature(&p.solid, mirror), p.material.as_str(), scalar(p.size)))
        })
        .collect();
    let shape = |name: &str| shapes.get(name).map(|(s, m, h)| (s.clone(), m.to_string(), *h));
    let mut parts: Vec<_> = a.parts.iter().map(|p| shape(&p.name)).collect();
    parts.sort();
    let mut interfaces: Vec<_> = a
        .interfaces
        .iter()
        .map(|i| {
            let at = i.surface.as_ref().map(|(_, s)| surface(s, mirror));
            (
                shape(&i.between[0]),
                shape(&i.between[1]),
                at,
                scalar(i.mu),
                i.friction == FrictionLaw::Associated,
                scalar(i.gap),
            )
        })
        .collect();
    interfaces.sort();
    let face = |name: &str| {
        a.faces
            .iter()
            .find(|f| f.name == name)
            .map(|f| (shape(&f.part), surface(&f.surface, mirror)))
    };
    let mut supports: Vec<_> = a.supports.iter().map(|s| (face(&s.face), s.fix)).collect();
    supports.sort();
    let mut loads: Vec<_> = a
        .loads
        .iter()
        .map(|l| (face(&l.face), l.case.clone(), action(&l.action, mirror), l.dead))
        .collect();
    loads.sort();
    let cut = |p: &BoltPreload| (shape(&p.part), surface(&p.surface, mirror), scalar(p.force));
    let mut preloads: Vec<_> = a.preloads.iter().map(cut).collect();
    preloads.sort();
    let weld = |w: &WeldRule| {
        let pair = [shape(&w.between[0]), shape(&w.between[1])];
        (pair, surface(&w.surface, mirror), [w.throat, w.thickness, w.strength].map(scalar))
    };
    let mut welds: Vec<_> = a.welds.iter().map(weld).collect();
    welds.sort();
    (parts, interfaces, supports, loads, preloads, welds)
}

/// The planes `x[axis] = 0` about which the joint, its supports and all its loads are symmetric.
pub fn planes(a: &Assembly) -> Vec<SymmetryPlane> {
    let whole = portrait(a, None);
    (0..3)
        .filter(|&axis| portrait(a, Some(axis)) == whole)
        .map(|axis| SymmetryPlane { axis })
        .collect()
}
