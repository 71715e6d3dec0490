//! Volumes, contact areas and face areas of flat-faced solids, exact up to rounding.
//!
//! A plane section is swept by lines. Between two neighbouring corners, the length of a line inside
//! the section changes linearly, so two Gauss points per strip integrate it exactly. Where faces of
//! an oblique prism cross those of another one, the crossings count as corners. Only strips in
//! which edges of other prisms cross are approximate; those strips are halved. The method depends
//! neither on the CAD kernel nor on the mesh, and both are checked against it.

use super::flat::{Bounds, FlatPrism, FlatSolid};
use super::line::{Line, intersect, length, subtract, unite};
use super::scene::Body;
use crate::assembly::assembly::Surface;
use bracket_base::math::vec3::{V3, along, cross, dot, sub};

/// Distance from a plane, to either side, at which a point is tested for being inside \[mm\]. It is
/// far below any feature and far above rounding.
const BESIDE: f64 = 1e-5;

/// Parts of a strip between two corners. A value > 1 limits the error where edges of different
/// prisms cross.
const SUBSTRIPS: usize = 2;

/// A plane with in-plane axes.
#[derive(Clone, Copy, Debug)]
pub struct Plane {
    /// A point of the plane \[mm\].
    pub origin: V3,
    /// Unit normal.
    pub normal: V3,
    /// Unit direction of the sweeping lines.
    pub d: V3,
    /// Unit direction of the sweep.
    pub e: V3,
}

impl Plane {
    /// The plane `x[axis] = at`.
    pub fn coordinate(axis: usize, at: f64) -> Self {
        let unit = |k: usize| std::array::from_fn(|i| if i == k { 1.0 } else { 0.0 });
        let mut origin = [0.0; 3];
        origin[axis] = at;
        Plane { origin, normal: unit(axis), d: unit((axis + 1) % 3), e: unit((axis + 2) % 3) }
    }

    /// Positions along `e` of every corner of the prisms' sections with this plane.
    fn breakpoints(&self, solids: &[&FlatSolid], planes: &[usize]) -> Vec<f64> {
        let mut out = Vec::new();
        let place = |p: V3| dot(sub(p, self.origin), self.e);
        let mut edge = |a: V3, b: V3| {
            let (ha, hb) =
                (dot(sub(a, self.origin), self.normal), dot(sub(b, self.origin), self.normal));
            let near = 3.0 * BESIDE;
            if ha.abs() < near {
                out.push(place(a));
            }
            if hb.abs() < near {
                out.push(place(b));
            }
            if (ha > near && hb < -near) || (ha < -near && hb > near) {
                out.push(place(along(a, ha / (ha - hb), sub(b, a))));
            }
        };
        for prism in solids.iter().flat_map(|s| s.prisms()) {
            let n = prism.polygon.len();
            let corners = prism.corners();
            for i in 0..n {
                edge(corners[i], corners[(i + 1) % n]);
                edge(corners[n + i], corners[n + (i + 1) % n]);
                edge(corners[i], corners[n + i]);
            }
        }
        for &axis in planes {
            if self.e[axis].abs() > 1e-9 {
                out.push(-self.origin[axis] / self.e[axis]);
            }
        }
        let prisms: Vec<&FlatPrism> = solids.iter().flat_map(|s| s.prisms()).collect();
        for (i, a) in prisms.iter().enumerate() {
            for b in prisms[..i].iter().filter(|b| is_oblique(a) || is_oblique(b)) {
                out.extend(self.crossings(a, b).map(place));
            }
        }
        out
    }

    /// Points of the plane in which a face of one prism crosses a face of another one.
    fn crossings<'a>(
        &'a self,
        a: &'a FlatPrism,
        b: &'a FlatPrism,
    ) -> impl Iterator<Item = V3> + 'a {
        let (of_a, of_b) =
            (FlatSolid::Prism(a.clone()).bounds(), FlatSolid::Prism(b.clone()).bounds());
        let meet = of_a.near(&of_b, BESIDE);
        let inside = move |p: &V3| {
            let point = Bounds { min: *p, max: *p };
            of_a.near(&point, BESIDE) && of_b.near(&point, BESIDE)
        };
        let pairs = faces_of(a).flat_map(move |f| faces_of(b).map(move |g| [f, g]));
        let at = |[f, g]: [Plane; 2]| {
            let (n, m, k) = (self.normal, f.normal, g.normal);
            let volume = dot(n, cross(m, k));
            let heights = [dot(n, self.origin), dot(m, f.origin), dot(k, g.origin)];
            let normals = [cross(m, k), cross(k, n), cross(n, m)];
            let sum = |c: usize| (0..3).map(|i| heights[i] * normals[i][c]).sum::<f64>() / volume;
            (volume.abs() > 1e-6).then(|| std::array::from_fn(sum))
        };
        pairs.filter(move |_| meet).filter_map(at).filter(inside)
    }

    /// Integral of `measure` over all lines of the sweep.
    fn sweep(&self, mut at: Vec<f64>, measure: impl Fn(&Line) -> f64) -> f64 {
        at.sort_by(f64::total_cmp);
        at.dedup_by(|b, a| *b - *a < 1e-9);
        let gauss = 0.5 / 3f64.sqrt();
        let mut sum = 0.0;
        for strip in at.windows(2) {
            let h = (strip[1] - strip[0]) / SUBSTRIPS as f64;
            for i in 0..SUBSTRIPS {
                let middle = strip[0] + (i as f64 + 0.5) * h;
                for x in [middle - gauss * h, middle + gauss * h] {
                    let line = Line { start: along(self.origin, x, self.e), direction: self.d };
                    sum += 0.5 * h * measure(&line);
                }
            }
        }
        sum
    }

    fn shifted(&self, line: &Line, distance: f64) -> Line {
        Line { start: along(line.start, distance, self.normal), direction: line.direction }
    }
}

/// Volume of the kept part of a body \[mm³\].
pub fn volume(body: &Body) -> f64 {
    // Sweep along the axis with the fewest distinct corners, because it needs the fewest sections.
    // Across an axis that is a direction of every prism the sections change linearly.
    let prisms = body.solid.prisms();
    let straight = |axis: &usize| {
        prisms.iter().all(|p| [p.u, p.v, p.w].iter().any(|d| d[*axis].abs() > 1.0 - 1e-9))
    };
    let axes: Vec<usize> = (0..3).filter(straight).collect();
    let axes = if axes.is_empty() { vec![0, 1, 2] } else { axes };
    let corners: Vec<V3> = body.solid.prisms().iter().flat_map(|p| p.corners()).collect();
    let levels = |axis: usize| {
        let mut at: Vec<f64> = corners.iter().map(|c| c[axis]).collect();
        if body.planes.contains(&axis) {
            at.push(0.0);
        }
        at.sort_by(f64::total_cmp);
        at.dedup_by(|b, a| *b - *a < 1e-9);
        at
    };
    let best = axes.into_iter().map(|k| (k, levels(k))).min_by_key(|(_, l)| l.len());
    let Some((axis, at)) = best else { return 0.0 };
    let section = |x: f64| section_area(body, axis, x);
    let gauss = 0.5 / 3f64.sqrt();
    let mut sum = 0.0;
    for strip in at.windows(2) {
        let (middle, h) = (0.5 * (strip[0] + strip[1]), strip[1] - strip[0]);
        if body.planes.contains(&axis) && middle < 0.0 {
            continue;
        }
        sum += 0.5 * h * (section(middle - gauss * h) + section(middle + gauss * h));
    }
    sum
}

/// Area of the section of the kept part of a body with the plane `x[axis] = at` \[mm²\].
pub fn section_area(body: &Body, axis: usize, at: f64) -> f64 {
    let plane = Plane::coordinate(axis, at);
    let breaks = plane.breakpoints(&[&body.solid], &body.planes);
    plane.sweep(breaks, |line| length(&body.stretches(line)))
}

/// Contact area of two bodies \[mm²\], restricted to the surface `on` if given.
pub fn contact_area(a: &Body, b: &Body, on: Option<&Surface>) -> f64 {
    if !a.bounds.near(&b.bounds, 2.0 * BESIDE) {
        return 0.0;
    }
    let mut sum = 0.0;
    for plane in planes_of(&a.solid) {
        let Some(plane) = on.map_or(Some(plane), |s| on_surface_plane(s, plane)) else { continue };
        let window = on.map_or(Window::ALL, |s| Window::of(s, &plane));
        let mut breaks = plane.breakpoints(&[&a.solid, &b.solid], &a.planes);
        window.clip(&mut breaks);
        sum += plane.sweep(breaks, |line| {
            let (low, high) = (plane.shifted(line, -BESIDE), plane.shifted(line, BESIDE));
            let both = |x: &Line, y: &Line| {
                let inside = intersect(&a.stretches(x), &[window.d]);
                if inside.is_empty() { 0.0 } else { length(&intersect(&inside, &b.stretches(y))) }
            };
            both(&low, &high) + both(&high, &low)
        });
    }
    sum
}

/// Area of a body's outer face in the rectangle of a coordinate plane \[mm²\]: the body has
/// material on one side, and no body has material on the other.
pub fn outer_area(bodies: &[Body], body: usize, axis: usize, at: f64, min: V3, max: V3) -> f64 {
    let plane = Plane::coordinate(axis, at);
    let me = &bodies[body];
    let near: Vec<&Body> =
        bodies.iter().filter(|b| b.bounds.near(&me.bounds, 2.0 * BESIDE)).collect();
    let solids: Vec<&FlatSolid> = near.iter().map(|b| &b.solid).collect();
    let window = Window::of(&Surface::Plane { axis, at, min, max }, &plane);
    let mut breaks = plane.breakpoints(&solids, &me.planes);
    window.clip(&mut breaks);
    plane.sweep(breaks, |line| {
        let (low, high) = (plane.shifted(line, -BESIDE), plane.shifted(line, BESIDE));
        let bare = |x: &Line, y: &Line| {
            let inside = intersect(&me.stretches(x), &[window.d]);
            if inside.is_empty() {
                return 0.0;
            }
            let filled = near.iter().fold(Vec::new(), |acc, b| unite(acc, b.stretches(y)));
            length(&subtract(&inside, &filled))
        };
        bare(&low, &high) + bare(&high, &low)
    })
}

/// The plane, if facets on it belong to the surface: the coordinate plane itself (with coordinate
/// axes), or the plane of a facet of the mantle (swept along the axis).
fn on_surface_plane(surface: &Surface, plane: Plane) -> Option<Plane> {
    match surface {
        Surface::Plane { axis, at, .. } => (plane.normal[*axis].abs() > 1.0 - 1e-9
            && (plane.origin[*axis] - at).abs() < 1e-6)
            .then(|| Plane::coordinate(*axis, *at)),
        Surface::Mantle { base, axis, radius, .. } => {
            let distance = dot(sub(*base, plane.origin), plane.normal).abs();
            (dot(plane.normal, *axis).abs() < 1e-6
                && (distance / radius - 1.0).abs() < MANTLE_TOLERANCE)
                .then(|| Plane { origin: *base, d: cross(plane.normal, *axis), e: *axis, ..plane })
                .map(|p| Plane {
                    origin: along(*base, dot(sub(plane.origin, *base), plane.normal), plane.normal),
                    ..p
                })
        }
    }
}

/// The part of a plane that belongs to a surface, in the coordinates of the plane \[mm\].
struct Window {
    d: [f64; 2],
    e: [f64; 2],
}

impl Window {
    const ALL: Window =
        Window { d: [f64::NEG_INFINITY, f64::INFINITY], e: [f64::NEG_INFINITY, f64::INFINITY] };

    fn of(surface: &Surface, plane: &Plane) -> Self {
        match surface {
            // Both planes have their origin where their in-plane coordinates are zero.
            Surface::Plane { axis, min, max, .. } => {
                let (d, e) = ((axis + 1) % 3, (axis + 2) % 3);
                Window { d: [min[d], max[d]], e: [min[e], max[e]] }
            }
            // A facet extends tan(π/n) < 0.28 radii to either side of its middle, for n ≥ 12.
            Surface::Mantle { base, radius, length, .. } => {
                let start = dot(sub(*base, plane.origin), plane.e);
                Window { d: [-0.5 * radius, 0.5 * radius], e: [start, start + length] }
            }
        }
    }

    fn clip(&self, breaks: &mut Vec<f64>) {
        breaks.extend(self.e.iter().filter(|x| x.is_finite()));
        breaks.retain(|x| *x >= self.e[0] && *x <= self.e[1]);
    }
}

/// Largest relative distance from the nominal radius at which a point counts as lying on a mantle.
/// A regular 12-gon with the area of its circle reaches from 0.988 to 1.023 radii.
pub const MANTLE_TOLERANCE: f64 = 0.03;

/// The distinct planes of all facets of a solid, including those of the subtracted prisms.
fn planes_of(solid: &FlatSolid) -> Vec<Plane> {
    let mut out: Vec<Plane> = Vec::new();
    let mut add = |plane: Plane| {
        let known = out.iter().any(|p| {
            dot(p.normal, plane.normal).abs() > 1.0 - 1e-10
                && dot(sub(plane.origin, p.origin), p.normal).abs() < 1e-6
        });
        if !known {
            out.push(plane);
        }
    };
    for prism in solid.prisms() {
        faces_of(prism).for_each(&mut add);
    }
    out
}

/// The planes of both ends of a prism, then of its sides.
fn faces_of(prism: &FlatPrism) -> impl Iterator<Item = Plane> + '_ {
    let cap = |h: f64| Plane {
        origin: along(prism.origin, h, prism.w),
        normal: prism.w,
        d: prism.u,
        e: prism.v,
    };
    [cap(0.0), cap(prism.length)].into_iter().chain(side_planes(prism))
}

/// True if a direction of a prism is none of the coordinate axes.
fn is_oblique(prism: &FlatPrism) -> bool {
    let off = |d: &V3| d.iter().all(|c| c.abs() < 1.0 - 1e-9);
    [prism.u, prism.v, prism.w].iter().any(off)
}

fn side_planes(prism: &FlatPrism) -> impl Iterator<Item = Plane> + '_ {
    let n = prism.polygon.len();
    (0..n).map(move |i| {
        let (a, b) =
            (prism.point(prism.polygon[i], 0.0), prism.point(prism.polygon[(i + 1) % n], 0.0));
        let d = sub(b, a);
        let l = dot(d, d).sqrt();
        let d = d.map(|c| c / l);
        Plane { origin: a, normal: cross(d, prism.w), d, e: prism.w }
    })
}

#[cfg(test)]
mod tests;
