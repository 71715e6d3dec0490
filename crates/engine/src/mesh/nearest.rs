//! The nearest of many points.

use bracket_base::math::vec3::{V3, dot, sub};

/// Points in a regular grid of cells.
#[derive(Clone, Debug)]
pub struct Nearest {
    points: Vec<V3>,
    /// Edge of a cell \[mm\].
    cell: f64,
    low: V3,
    counts: [usize; 3],
    /// Start of the points of each cell in `order`.
    start: Vec<u32>,
    order: Vec<u32>,
}

/// Points in a cell on average.
const PER_CELL: f64 = 2.0;

/// Cells along an axis at most.
const MOST: usize = 400;

impl Nearest {
    /// Sorts points into cells.
    pub fn new(points: Vec<V3>) -> Self {
        let (mut low, mut high) = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
        for x in &points {
            (0..3).for_each(|d| (low[d], high[d]) = (low[d].min(x[d]), high[d].max(x[d])));
        }
        let volume: f64 = (0..3).map(|d| (high[d] - low[d]).max(1e-3)).product();
        let longest = (0..3).map(|d| high[d] - low[d]).fold(0.0, f64::max);
        let cell = (PER_CELL * volume / points.len().max(1) as f64).cbrt();
        let cell = cell.max(longest / MOST as f64).max(1e-9);
        let counts = [0, 1, 2].map(|d| ((high[d] - low[d]) / cell).max(0.0) as usize + 1);
        let mut grid = Self { points, cell, low, counts, start: Vec::new(), order: Vec::new() };
        let cells: Vec<usize> = grid.points.iter().map(|x| grid.index(grid.cell_of(x))).collect();
        let mut start = vec![0u32; counts.iter().product::<usize>() + 1];
        cells.iter().for_each(|c| start[c + 1] += 1);
        (1..start.len()).for_each(|c| start[c] += start[c - 1]);
        let mut next = start.clone();
        grid.order = vec![0; cells.len()];
        for (i, c) in cells.into_iter().enumerate() {
            grid.order[next[c] as usize] = i as u32;
            next[c] += 1;
        }
        grid.start = start;
        grid
    }

    fn cell_of(&self, x: &V3) -> [usize; 3] {
        let at = |d: usize| ((x[d] - self.low[d]) / self.cell).max(0.0) as usize;
        [0, 1, 2].map(|d| at(d).min(self.counts[d] - 1))
    }

    fn index(&self, c: [usize; 3]) -> usize {
        (c[2] * self.counts[1] + c[1]) * self.counts[0] + c[0]
    }

    /// Number of the point nearest to `x`, of two equally near ones the first; `None` without
    /// points.
    pub fn to(&self, x: V3) -> Option<usize> {
        let middle = self.cell_of(&x);
        let mut best: Option<(f64, u32)> = None;
        let rings = self.counts.iter().copied().max().unwrap_or(1);
        for ring in 0..=rings {
            // a point in this ring or beyond is at least so far from the cell of `x`
            let clear = (ring as f64 - 1.0).max(0.0) * self.cell;
            if best.is_some_and(|(square, _)| square < clear * clear) {
                break;
            }
            self.visit(middle, ring, &mut |point| {
                let d = sub(self.points[point as usize], x);
                let square = dot(d, d);
                if best.is_none_or(|b| (square, point) < b) {
                    best = Some((square, point));
                }
            });
        }
        best.map(|(_, point)| point as usize)
    }

    /// Visits the points of the cells whose largest distance from the middle along an axis is
    /// `ring`.
    fn visit(&self, middle: [usize; 3], ring: usize, look: &mut dyn FnMut(u32)) {
        let range =
            |d: usize| middle[d].saturating_sub(ring)..=(middle[d] + ring).min(self.counts[d] - 1);
        for k in range(2) {
            for j in range(1) {
                for i in range(0) {
                    let away = |a: usize, d: usize| a.abs_diff(middle[d]);
                    if away(i, 0).max(away(j, 1)).max(away(k, 2)) != ring {
                        continue;
                    }
                    let c = self.index([i, j, k]);
                    let points = self.start[c] as usize..self.start[c + 1] as usize;
                    self.order[points].iter().for_each(|p| look(*p));
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// As a search through all points finds it, for points in a box, in a plane and in one place,
    /// from inside and far outside.
    #[test]
    fn as_by_search_through_all() {
        let mut seed = 11u64;
        let mut random = || {
            seed ^= seed << 13;
            seed ^= seed >> 7;
            seed ^= seed << 17;
            (seed >> 11) as f64 / (1u64 << 53) as f64
        };
        for (count, box_) in [(500, [30.0, 5.0, 80.0]), (300, [50.0, 0.0, 20.0]), (4, [0.0; 3])] {
            let points: Vec<V3> = (0..count).map(|_| box_.map(|b: f64| b * random())).collect();
            let nearest = Nearest::new(points.clone());
            for _ in 0..200 {
                let x = box_.map(|b| 3.0 * b * (random() - 0.3));
                let square = |p: &V3| dot(sub(*p, x), sub(*p, x));
                let want = points.iter().map(square).fold(f64::INFINITY, f64::min);
                let found = nearest.to(x).expect("there are points");
                assert_eq!(square(&points[found]), want);
            }
        }
        assert_eq!(Nearest::new(Vec::new()).to([0.0; 3]), None);
    }
}
