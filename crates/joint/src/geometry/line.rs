//! The intervals of a straight line that lie inside a solid.

use super::flat::{FlatPrism, FlatSolid};
use bracket_base::math::vec3::{V3, dot, sub};

/// Sorted, disjoint intervals of a line's parameter.
pub type Stretches = Vec<[f64; 2]>;

/// A line `start + t direction`, with a direction of unit length.
#[derive(Clone, Copy, Debug)]
pub struct Line {
    /// Point at `t = 0` \[mm\].
    pub start: V3,
    /// Unit direction.
    pub direction: V3,
}

/// Total length of the intervals.
pub fn length(stretches: &[[f64; 2]]) -> f64 {
    stretches.iter().map(|s| s[1] - s[0]).sum()
}

/// Intervals inside both `a` and `b`.
pub fn intersect(a: &[[f64; 2]], b: &[[f64; 2]]) -> Stretches {
    let (mut i, mut j) = (0, 0);
    let mut out = Vec::new();
    while i < a.len() && j < b.len() {
        let (lo, hi) = (a[i][0].max(b[j][0]), a[i][1].min(b[j][1]));
        if hi > lo {
            out.push([lo, hi]);
        }
        if a[i][1] < b[j][1] {
            i += 1;
        } else {
            j += 1;
        }
    }
    out
}

/// Intervals inside `a` and outside `b`.
pub fn subtract(a: &[[f64; 2]], b: &[[f64; 2]]) -> Stretches {
    let mut out = Vec::new();
    for s in a {
        let mut lo = s[0];
        for cut in b {
            if cut[1] <= lo || cut[0] >= s[1] {
                continue;
            }
            if cut[0] > lo {
                out.push([lo, cut[0]]);
            }
            lo = lo.max(cut[1]);
        }
        if lo < s[1] {
            out.push([lo, s[1]]);
        }
    }
    out
}

/// Intervals inside `a` or `b`.
pub fn unite(a: Stretches, b: Stretches) -> Stretches {
    let mut all = a;
    all.extend(b);
    all.sort_by(|x, y| x[0].total_cmp(&y[0]));
    let mut out: Stretches = Vec::new();
    for s in all {
        match out.last_mut() {
            Some(last) if s[0] <= last[1] => last[1] = last[1].max(s[1]),
            _ => out.push(s),
        }
    }
    out
}

impl Line {
    /// The part of the line with `x[axis] ≥ 0`.
    pub fn positive(&self, axis: usize) -> Stretches {
        let (p, d) = (self.start[axis], self.direction[axis]);
        if d.abs() < 1e-14 {
            return if p >= 0.0 { vec![[f64::NEG_INFINITY, f64::INFINITY]] } else { Vec::new() };
        }
        let t = -p / d;
        if d > 0.0 { vec![[t, f64::INFINITY]] } else { vec![[f64::NEG_INFINITY, t]] }
    }

    /// The intervals inside a solid.
    pub fn through(&self, solid: &FlatSolid) -> Stretches {
        match solid {
            FlatSolid::Prism(prism) => self.through_prism(prism),
            FlatSolid::Union(list) => {
                list.iter().fold(Vec::new(), |acc, s| unite(acc, self.through(s)))
            }
            FlatSolid::Difference(list) => {
                let Some((first, rest)) = list.split_first() else { return Vec::new() };
                let mut inside = self.through(first);
                for s in rest {
                    if inside.is_empty() {
                        break;
                    }
                    inside = subtract(&inside, &self.through(s));
                }
                inside
            }
        }
    }

    fn through_prism(&self, prism: &FlatPrism) -> Stretches {
        let from = sub(self.start, prism.origin);
        let (h, dh) = (dot(from, prism.w), dot(self.direction, prism.w));
        let slab = if dh.abs() < 1e-12 {
            if h <= 0.0 || h >= prism.length {
                return Vec::new();
            }
            [f64::NEG_INFINITY, f64::INFINITY]
        } else {
            let (a, b) = (-h / dh, (prism.length - h) / dh);
            [a.min(b), a.max(b)]
        };
        let p = [dot(from, prism.u), dot(from, prism.v)];
        let d = [dot(self.direction, prism.u), dot(self.direction, prism.v)];
        let speed = d[0].hypot(d[1]);
        if speed < 1e-12 {
            return if contains(&prism.polygon, p) { vec![slab] } else { Vec::new() };
        }
        // Crossings follow the half-open rule: a corner on the line belongs to only one of its two
        // edges.
        let n = prism.polygon.len();
        let side = |q: [f64; 2]| d[0] * (q[1] - p[1]) - d[1] * (q[0] - p[0]);
        let mut cuts = Vec::new();
        for i in 0..n {
            let (a, b) = (prism.polygon[i], prism.polygon[(i + 1) % n]);
            let (sa, sb) = (side(a), side(b));
            if (sa > 0.0) != (sb > 0.0) {
                let f = sa / (sa - sb);
                let q = [a[0] + f * (b[0] - a[0]), a[1] + f * (b[1] - a[1])];
                cuts.push(((q[0] - p[0]) * d[0] + (q[1] - p[1]) * d[1]) / (speed * speed));
            }
        }
        cuts.sort_by(f64::total_cmp);
        let inside: Stretches = cuts.chunks_exact(2).map(|c| [c[0], c[1]]).collect();
        intersect(&inside, &[slab])
    }
}

/// True if the point lies inside the polygon (even-odd rule).
fn contains(polygon: &[[f64; 2]], p: [f64; 2]) -> bool {
    let n = polygon.len();
    let mut inside = false;
    for i in 0..n {
        let (a, b) = (polygon[i], polygon[(i + 1) % n]);
        if (a[1] > p[1]) != (b[1] > p[1])
            && p[0] < a[0] + (p[1] - a[1]) / (b[1] - a[1]) * (b[0] - a[0])
        {
            inside = !inside;
        }
    }
    inside
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::assembly::assembly::Solid;

    #[test]
    fn a_line_through_a_drilled_box_has_two_stretches() {
        let solid = Solid::Difference(vec![
            Solid::Box { min: [0.0; 3], max: [10.0, 10.0, 10.0] },
            Solid::Box { min: [4.0, 4.0, -1.0], max: [6.0, 6.0, 11.0] },
        ]);
        let flat = FlatSolid::from_solid(&solid);
        let line = Line { start: [-3.0, 5.0, 5.0], direction: [1.0, 0.0, 0.0] };
        assert_eq!(line.through(&flat), vec![[3.0, 7.0], [9.0, 13.0]]);
        let along_hole = Line { start: [5.0, 5.0, -3.0], direction: [0.0, 0.0, 1.0] };
        assert!(along_hole.through(&flat).is_empty());
    }

    #[test]
    fn stretches_obey_set_algebra() {
        let a = vec![[0.0, 4.0], [6.0, 9.0]];
        let b = vec![[1.0, 2.0], [3.0, 7.0]];
        assert_eq!(intersect(&a, &b), vec![[1.0, 2.0], [3.0, 4.0], [6.0, 7.0]]);
        assert_eq!(subtract(&a, &b), vec![[0.0, 1.0], [2.0, 3.0], [7.0, 9.0]]);
        assert_eq!(unite(a, b), vec![[0.0, 9.0]]);
    }
}
