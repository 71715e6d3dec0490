//! Symmetry of a whole joint. Geometry, materials, interfaces, supports and loads are compared with
//! their mirror images.
//!
//! Solids are compared as sets of rounded points, so the result does not depend on the order or
//! sense in which a template draws them.

use super::assembly::{
    Action, Assembly, BoltPreload, FaceLoad, OutlineEdge, Part, Solid, Surface, SymmetryPlane,
    WeldRule,
};
use bracket_base::math::vec3::{V3, norm};
use bracket_engine::model::FrictionLaw;
use std::collections::BTreeMap;

/// Lengths that differ by less than this are equal \[mm\].
const SAME: f64 = 1e-6;

/// Loads that differ by no more than this fraction of their size are equal. The value is a million
/// times the rounding error and far below any significant load.
const SAME_LOAD: f64 = 1e-10;

type Point = [i64; 3];

fn round(x: [f64; 3], mirror: Option<usize>) -> Point {
    let mut p = x.map(|c| (c / SAME).round() as i64);
    if let Some(axis) = mirror {
        // a number too large for the grid saturates; the smallest one has no opposite
        p[axis] = p[axis].saturating_neg();
    }
    p
}

fn on_grid(x: f64) -> i64 {
    (x / SAME).round() as i64
}

/// A force, a stress or a pure number, rounded to ten significant digits at any magnitude.
fn digits(x: f64) -> String {
    format!("{:.9e}", x + 0.0)
}

/// A shape as data that are equal exactly if the shapes are equal.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Signature {
    /// Vertices, centres of arcs, and a length that the points do not determine.
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
            Signature::Points(ends(*base, *axis, *length, mirror), Vec::new(), on_grid(*radius))
        }
        Solid::Prism { origin, u, v, start, edges, length } => {
            let n = bracket_base::math::vec3::cross(*u, *v);
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
            Signature::Points(ends(*base, *axis, *length, mirror), Vec::new(), on_grid(*radius))
        }
    }
}

/// The mirror image of a vector: the component along the normal changes sign.
fn mirrored(v: V3, mirror: Option<usize>) -> V3 {
    std::array::from_fn(|k| if mirror == Some(k) { -v[k] } else { v[k] })
}

/// The mirror image of a moment: all components except the one along the normal change sign.
fn mirrored_moment(m: V3, mirror: Option<usize>) -> V3 {
    mirror.map_or(m, |_| mirrored(m, mirror).map(|c| -c))
}

/// True if the vectors agree up to rounding relative to their size.
fn same_load(a: V3, b: V3) -> bool {
    let size = norm(a).max(norm(b));
    (0..3).all(|k| (a[k] - b[k]).abs() <= SAME_LOAD * size)
}

/// A load: its place and other data that must be exactly equal, and its vectors.
struct Acting<'a> {
    place: (Option<Face>, &'a str, bool, Option<Point>),
    /// Traction \[MPa\] and its derivatives \[MPa/mm\], or force \[N\] and moment \[N mm\].
    vectors: Vec<V3>,
}

impl Acting<'_> {
    fn same(&self, other: &Self) -> bool {
        self.place == other.place
            && self.vectors.iter().zip(&other.vectors).all(|(a, b)| same_load(*a, *b))
    }
}

/// The loads of a joint; their mirror images if `mirror` is given.
fn loads<'a>(a: &'a Assembly, shapes: &Shapes<'a>, mirror: Option<usize>) -> Vec<Acting<'a>> {
    let acting = |l: &'a FaceLoad| {
        let (at, vectors) = match l.action {
            Action::Traction(t) => (None, vec![mirrored(t, mirror)]),
            Action::Linear { traction0, gradient } => {
                let derivative = |j: usize| {
                    let along = mirrored(gradient.map(|row| row[j]), mirror);
                    if mirror == Some(j) { along.map(|c| -c) } else { along }
                };
                (
                    None,
                    [mirrored(traction0, mirror)]
                        .into_iter()
                        .chain((0..3).map(derivative))
                        .collect(),
                )
            }
            Action::Resultant { at, force, moment } => (
                Some(round(at, mirror)),
                vec![mirrored(force, mirror), mirrored_moment(moment, mirror)],
            ),
        };
        Acting { place: (face(a, shapes, &l.face, mirror), &l.case, l.dead, at), vectors }
    };
    a.loads.iter().map(acting).collect()
}

/// True if each load can be paired with a different one of the others.
fn paired(loads: &[Acting<'_>], others: Vec<Acting<'_>>) -> bool {
    let mut left = others;
    loads.iter().all(|l| {
        let partner = left.iter().position(|o| l.same(o));
        partner.map(|i| left.swap_remove(i)).is_some()
    }) && left.is_empty()
}

/// Data of a part that symmetry must keep: shape, material, element size.
type Shape = (Signature, String, i64);
type Shapes<'a> = BTreeMap<&'a str, Shape>;
/// A named face: its part and its position.
type Face = (Option<Shape>, Signature);

fn shapes(a: &Assembly, mirror: Option<usize>) -> Shapes<'_> {
    let shape = |p: &Part| (signature(&p.solid, mirror), p.material.clone(), on_grid(p.size));
    a.parts.iter().map(|p| (p.name.as_str(), shape(p))).collect()
}

fn face(a: &Assembly, shapes: &Shapes<'_>, name: &str, mirror: Option<usize>) -> Option<Face> {
    let f = a.faces.iter().find(|f| f.name == name)?;
    Some((shapes.get(f.part.as_str()).cloned(), surface(&f.surface, mirror)))
}

/// All data of a joint except the loads that symmetry must keep, with part names replaced by
/// shapes.
fn portrait(a: &Assembly, shapes: &Shapes<'_>, mirror: Option<usize>) -> impl PartialEq + use<> {
    let shape = |name: &str| shapes.get(name).cloned();
    let mut parts: Vec<_> = a.parts.iter().map(|p| shape(&p.name)).collect();
    parts.sort();
    // the two parts of an interface stay in their order: a plane that lies in an open contact
    // between mirror twins is then no plane of symmetry, as it must be, since symmetry would close
    // the contact
    let mut interfaces: Vec<_> = a
        .interfaces
        .iter()
        .map(|i| {
            let at = i.surface.as_ref().map(|(_, s)| surface(s, mirror));
            (
                shape(&i.between[0]),
                shape(&i.between[1]),
                at,
                digits(i.mu),
                i.friction == FrictionLaw::Associated,
                on_grid(i.gap),
            )
        })
        .collect();
    interfaces.sort();
    let mut supports: Vec<_> =
        a.supports.iter().map(|s| (face(a, shapes, &s.face, mirror), s.fix)).collect();
    supports.sort();
    let cut = |p: &BoltPreload| (shape(&p.part), surface(&p.surface, mirror), digits(p.force));
    let mut preloads: Vec<_> = a.preloads.iter().map(cut).collect();
    preloads.sort();
    let weld = |w: &WeldRule| {
        let pair = [shape(&w.between[0]), shape(&w.between[1])];
        let lengths = [w.throat, w.thickness].map(on_grid);
        let steel = [w.steel.fu.mpa(), w.steel.beta_w].map(digits);
        (pair, surface(&w.surface, mirror), lengths, steel)
    };
    let mut welds: Vec<_> = a.welds.iter().map(weld).collect();
    welds.sort();
    (parts, interfaces, supports, preloads, welds)
}

/// The planes `x[axis] = 0` about which the joint, its supports and all its loads are symmetric.
pub fn planes(a: &Assembly) -> Vec<SymmetryPlane> {
    let own = shapes(a, None);
    let (whole, acting) = (portrait(a, &own, None), loads(a, &own, None));
    let symmetric = |axis: &usize| {
        let mirror = Some(*axis);
        let image = shapes(a, mirror);
        portrait(a, &image, mirror) == whole && paired(&acting, loads(a, &image, mirror))
    };
    (0..3).filter(symmetric).map(|axis| SymmetryPlane { axis }).collect()
}
