//! Clashes, thin gaps, missing contacts and clearances, checked before meshing and reported with
//! part names.
//!
//! The mesher does not detect overlaps: it drops bodies and reports success. Gaps far below the
//! element size spoil its mesh. parry finds the close pairs. The overlap of material is then
//! computed from the solids themselves, so that a bolt in its hole is not a clash.

use super::boxes::Boxes;
use super::error::GeometryError;
use super::flat::{Bounds, FlatSolid};
use super::line::{Line, intersect};
use crate::assembly::Assembly;
use crate::assembly::assembly::{Part, Solid};
use bracket_base::diag::{Diagnostic, Diagnostics};
use bracket_base::math::vec3::V3;
use parry3d_f64::math::{Pose, Vector};
use parry3d_f64::query;
use parry3d_f64::shape::ConvexPolyhedron;
use std::cell::Cell;
use std::collections::{BTreeMap, BTreeSet};

/// Largest overlap that still counts as contact \[mm\].
pub const TOUCH: f64 = 1e-3;

/// Gaps between `TOUCH` and this value are rejected \[mm\].
pub const SMALLEST_GAP: f64 = 1.0;

/// Rounding error of a distance \[mm\]: a gap of 1 mm is not below 1 mm.
const ROUNDING: f64 = 1e-9;

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
    /// The boxes of the pieces.
    boxes: Boxes,
}

/// Checks names, clashes, gaps, contacts and clearances, and reports all faults at once. `None` if
/// `stop` became true before the end.
pub fn check(assembly: &Assembly, stop: &dyn Fn() -> bool) -> Option<Result<(), Diagnostics>> {
    let mut faults = super::validate::faults(assembly);
    if faults.is_empty() {
        faults = proximity_faults(assembly, stop)?;
    }
    Some(Diagnostics::refuse(grouped(faults)))
}

/// One message for faults of one kind and size: the same dimension moves the bolts of all rows.
fn grouped(faults: Vec<GeometryError>) -> Vec<Diagnostic> {
    let mut out: Vec<(Option<String>, Diagnostic, usize)> = Vec::new();
    for fault in faults {
        let cause = fault.cause();
        match out.iter_mut().find(|o| cause.is_some() && o.0 == cause) {
            Some((_, _, more)) => *more += 1,
            None => out.push((cause, fault.into(), 0)),
        }
    }
    let word = |(_, mut d, more): (Option<String>, Diagnostic, usize)| {
        if more > 0 {
            d.message +=
                &format!(" (and {more} more {} alike)", if more > 1 { "pairs" } else { "pair" });
        }
        d
    };
    out.into_iter().map(word).collect()
}

fn proximity_faults(assembly: &Assembly, stop: &dyn Fn() -> bool) -> Option<Vec<GeometryError>> {
    let search = Search { stop, pairs: Cell::new(0) };
    search.faults(assembly)
}

/// A search for faults, which ends without an answer when it is stopped.
struct Search<'a> {
    /// True once the search must end.
    stop: &'a dyn Fn() -> bool,
    /// Pairs of convex pieces whose distance or contact was computed: the expensive part.
    pairs: Cell<usize>,
}

impl Search<'_> {
    fn go_on(&self) -> Option<()> {
        if (self.stop)() { None } else { Some(()) }
    }

    fn faults(&self, assembly: &Assembly) -> Option<Vec<GeometryError>> {
        let mut parts = Vec::with_capacity(assembly.parts.len());
        for part in &assembly.parts {
            self.go_on()?;
            parts.push(prepare(part));
        }
        let mut faults = Vec::new();
        let boxes = parts.iter().map(|p| p.bounds).collect();
        let boxes = Boxes::new(boxes);
        for (i, a) in parts.iter().enumerate() {
            for j in boxes.near(&a.bounds, SMALLEST_GAP).into_iter().filter(|j| *j > i) {
                self.go_on()?;
                let (b, close) = (&parts[j], near_pieces(a, &parts[j]));
                if let Some((depth, at)) = self.overlap(a, b, &close)? {
                    faults.push(GeometryError::Clash {
                        pair: pair(a.part, b.part),
                        depth,
                        limit: TOUCH,
                        at,
                    });
                } else if let Some(gap) = self.sliver(a, b, &close)? {
                    faults.push(GeometryError::Sliver {
                        pair: pair(a.part, b.part),
                        gap,
                        limit: SMALLEST_GAP,
                    });
                }
            }
        }
        let by_name: BTreeMap<&str, &Checked> =
            parts.iter().map(|p| (p.part.name.as_str(), p)).collect();
        let find = |name: &str| by_name.get(name).copied();
        let mut asked: BTreeSet<[&str; 2]> = BTreeSet::new();
        for rule in &assembly.interfaces {
            let names = [rule.between[0].as_str(), rule.between[1].as_str()];
            let (Some(a), Some(b)) = (find(names[0]), find(names[1])) else { continue };
            // a pair may have a rule for each surface
            if !asked.insert(names) {
                continue;
            }
            let gap = self.distance(a, b)?;
            if gap >= SMALLEST_GAP {
                faults.push(GeometryError::Apart { pair: pair(a.part, b.part), gap });
            }
        }
        for rule in &assembly.clearances {
            let (Some(a), Some(b)) = (find(&rule.between[0]), find(&rule.between[1])) else {
                continue;
            };
            // the boxes are no farther apart than the parts
            if a.bounds.distance(&b.bounds) >= rule.min {
                continue;
            }
            let distance = self.distance(a, b)?;
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
    let boxes = Boxes::new(pieces.iter().map(|p| p.bounds).collect());
    Checked { part, solid, bounds, pieces, boxes }
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

/// The pairs of pieces whose boxes are closer than the smallest gap, in order.
fn near_pieces(a: &Checked, b: &Checked) -> Vec<[usize; 2]> {
    // the tree with more pieces is searched
    let swapped = a.pieces.len() > b.pieces.len();
    let (few, many) = if swapped { (b, a) } else { (a, b) };
    let of = |(i, p): (usize, &Piece)| {
        let near = many.boxes.near(&p.bounds, SMALLEST_GAP);
        near.into_iter().map(move |j| if swapped { [j, i] } else { [i, j] })
    };
    let mut pairs: Vec<[usize; 2]> = few.pieces.iter().enumerate().flat_map(of).collect();
    pairs.sort_unstable();
    pairs
}

impl Search<'_> {
    /// Distance of two pieces; `None` if it cannot be computed.
    fn distance_of(&self, p: &Piece, q: &Piece) -> Option<f64> {
        self.pairs.set(self.pairs.get() + 1);
        query::distance(&p.pose, &p.shape, &q.pose, &q.shape).ok().map(|d| d.distance)
    }

    /// Overlap of two parts' material: its depth and a point in it. For each coordinate axis the
    /// longest interval common to both parts on a parallel line is found; the depth is the shortest
    /// of the three.
    fn overlap(&self, a: &Checked, b: &Checked, close: &[[usize; 2]]) -> Option<Option<(f64, V3)>> {
        let mut worst: Option<(f64, V3)> = None;
        for [i, j] in close {
            let (p, q) = (&a.pieces[*i], &b.pieces[*j]);
            if !p.bounds.near(&q.bounds, 0.0) {
                continue;
            }
            self.go_on()?;
            self.pairs.set(self.pairs.get() + 1);
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
        Some(worst)
    }

    /// Smallest gap between the two parts that is neither contact nor sufficient clearance.
    ///
    /// Where pieces come close, the gap is measured in the solids with lines: the pieces around a
    /// hole keep clear of a shank that fills the hole, although the solids touch.
    fn sliver(&self, a: &Checked, b: &Checked, close: &[[usize; 2]]) -> Option<Option<f64>> {
        let common = |p: &Bounds, q: &Bounds| Bounds {
            min: std::array::from_fn(|k| p.min[k].max(q.min[k]) - SMALLEST_GAP),
            max: std::array::from_fn(|k| p.max[k].min(q.max[k]) + SMALLEST_GAP),
        };
        // around a bolt many pieces are close: one search covers all of them
        let whole = common(&a.bounds, &b.bounds);
        let one_search = (0..3).all(|k| whole.max[k] - whole.min[k] <= ONE_SEARCH);
        let mut boxes = Vec::new();
        for [i, j] in close {
            self.go_on()?;
            let (p, q) = (&a.pieces[*i], &b.pieces[*j]);
            if self.distance_of(p, q).is_some_and(is_thin) {
                boxes.push(if one_search { whole } else { common(&p.bounds, &q.bounds) });
                if one_search {
                    break;
                }
            }
        }
        let mut least: Option<f64> = None;
        for of in boxes {
            self.go_on()?;
            let Some((near_a, near_b)) = a.solid.within(&of).zip(b.solid.within(&of)) else {
                continue;
            };
            let of_axis = |axis| thin_air(&near_a, &near_b, axis, of.min, of.max);
            let gap = (0..3).filter_map(of_axis).reduce(f64::min);
            least = least.into_iter().chain(gap).reduce(f64::min);
        }
        Some(least)
    }

    /// Distance of two parts. Pairs of pieces are compared in the order of the distance of their
    /// boxes, until no pair can be closer.
    fn distance(&self, a: &Checked, b: &Checked) -> Option<f64> {
        let mut smallest = f64::INFINITY;
        let near = near_pieces(a, b);
        for [i, j] in near {
            self.go_on()?;
            let (p, q) = (&a.pieces[i], &b.pieces[j]);
            if p.bounds.distance(&q.bounds) < smallest {
                smallest = self.distance_of(p, q).map_or(smallest, |d| d.min(smallest));
            }
            // nothing is closer than parts that touch
            if smallest == 0.0 {
                break;
            }
        }
        // pieces whose boxes are not near are at least this far apart
        if smallest <= SMALLEST_GAP {
            return Some(smallest);
        }
        let mut pairs = Vec::with_capacity(a.pieces.len() * b.pieces.len());
        for p in &a.pieces {
            self.go_on()?;
            pairs.extend(b.pieces.iter().map(|q| (p.bounds.distance(&q.bounds), p, q)));
        }
        pairs.sort_by(|x, y| x.0.total_cmp(&y.0));
        for (least, p, q) in pairs {
            if least >= smallest {
                break;
            }
            self.go_on()?;
            smallest = self.distance_of(p, q).map_or(smallest, |d| d.min(smallest));
        }
        Some(smallest)
    }
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

/// True for a gap that is neither contact nor wide enough.
fn is_thin(gap: f64) -> bool {
    gap > TOUCH && gap < SMALLEST_GAP - ROUNDING
}

/// Shortest interval outside both solids, with a length in (`TOUCH`, `SMALLEST_GAP`), on lines
/// along an axis through a box.
///
/// Where the solids touch beside the line, no farther than the gap is wide, the air is the open
/// corner between two faces, which a line along one of them crosses at its very end: a sloping
/// flange on an end plate. A narrow gap that ends in a contact is found farther from it.
fn thin_air(a: &FlatSolid, b: &FlatSolid, axis: usize, min: V3, max: V3) -> Option<f64> {
    let mut shortest: Option<f64> = None;
    for line in probes(axis, min, max) {
        let within = [[0.0, max[axis] - min[axis]]];
        let [in_a, in_b] = [a, b].map(|solid| intersect(&line.through(solid), &within));
        for s in &in_a {
            for t in &in_b {
                for (gap, from) in [(t[0] - s[1], s[1]), (s[0] - t[1], t[1])] {
                    let less = shortest.is_none_or(|x| gap < x);
                    if is_thin(gap) && less && !touches_beside(a, b, axis, &line, [from, gap]) {
                        shortest = Some(gap);
                    }
                }
            }
        }
    }
    shortest
}

/// True if the solids touch on a line beside this one, as far from it as the gap is wide: within
/// that length of the gap, which begins at `from`.
fn touches_beside(
    a: &FlatSolid,
    b: &FlatSolid,
    axis: usize,
    line: &Line,
    [from, gap]: [f64; 2],
) -> bool {
    let near = [[from - gap, from + 2.0 * gap]];
    let beside = [(1, 1.0), (1, -1.0), (2, 1.0), (2, -1.0)];
    beside.into_iter().any(|(next, sign)| {
        let mut moved = *line;
        moved.start[(axis + next) % 3] += sign * gap;
        let [in_a, in_b] = [a, b].map(|solid| intersect(&moved.through(solid), &near));
        let ends = |s: &[f64; 2], t: &[f64; 2]| (t[0] - s[1]).max(s[0] - t[1]);
        in_a.iter().any(|s| in_b.iter().any(|t| ends(s, t) <= TOUCH))
    })
}

#[cfg(test)]
mod tests;
