//! Changes that move a node in its facet, along its edge or inside its region.

use super::draft::{Change, Draft, Freedom, shape};
use bracket_base::math::vec3::{V3, add, along, dot, scale, sub, tangents, unit};

/// Smallest step of the search over the first one.
const FINEST: f64 = 1e-2;

/// Steps of the search at most.
const LONGEST: usize = 40;

/// Where a node may go: up to three directions at right angles.
struct Space {
    directions: Vec<V3>,
    /// A coordinate that is kept bit for bit.
    constant: Option<(usize, f64)>,
}

impl Space {
    /// A place near `x`, displaced by `step`.
    fn place(&self, x: V3, step: V3) -> V3 {
        let mut to = add(x, step);
        if let Some((axis, value)) = self.constant {
            to[axis] = value;
        }
        to
    }

    /// The part of a displacement that is allowed.
    fn part(&self, step: V3) -> V3 {
        let parts = self.directions.iter().map(|t| scale(dot(*t, step), *t));
        parts.fold([0.0; 3], add)
    }

    /// The directions and the diagonals between all of them, both ways.
    fn compass(&self) -> Vec<V3> {
        let mut all: Vec<V3> = Vec::new();
        let mut diagonals: Vec<V3> = vec![[0.0; 3]];
        for t in &self.directions {
            all.extend([*t, scale(-1.0, *t)]);
            diagonals =
                diagonals.iter().flat_map(|s| [-1.0, 1.0].map(|k| along(*s, k, *t))).collect();
        }
        if self.directions.len() > 1 {
            all.extend(diagonals);
        }
        all
    }
}

/// Moves a node to where the worst shape of its tets is best; `None` if it may not move or no
/// other place is better.
pub fn best_move(d: &Draft, n: u32) -> Option<Change> {
    let space = space(d, n)?;
    let start = d.at(n);
    let gone: Vec<u32> = d.tets_at(n).collect();
    let mut corners: Vec<([V3; 4], usize)> = gone
        .iter()
        .map(|e| {
            let tet = d.tets[*e as usize];
            (tet.map(|m| d.at(m)), tet.iter().position(|m| *m == n).unwrap_or(0))
        })
        .collect();
    // the worst one first: it rules out most places
    corners.sort_by(|a, b| shape(&a.0).total_cmp(&shape(&b.0)));
    // the worst shape at a place; anything below `least` is as good as `least`
    let worst = |x: V3, least: f64| {
        let mut worst = f64::INFINITY;
        for (tet, own) in &corners {
            let mut tet = *tet;
            tet[*own] = x;
            worst = worst.min(shape(&tet));
            if worst <= least {
                break;
            }
        }
        worst
    };
    let mut best = (worst(start, f64::NEG_INFINITY), start);
    let others = corners.iter().flat_map(|(tet, own)| {
        tet.iter().enumerate().filter(move |(v, _)| v != own).map(|(_, x)| *x)
    });
    let (sum, count) = others.fold(([0.0; 3], 0.0), |(s, c), x| (add(s, x), c + 1.0));
    let to_middle = sub(scale(1.0 / count, sum), start);
    let middle = space.place(start, space.part(to_middle));
    best = better(best, (worst(middle, best.0), middle));
    let far = corners.iter().flat_map(|(tet, _)| tet.iter().map(|x| sub(*x, start)));
    let size = far.map(|r| dot(r, r)).fold(0.0, f64::max).sqrt();
    let compass = space.compass();
    let mut step = 0.25 * size;
    let least = FINEST * step;
    // an inverted tet becomes better without end the farther the node goes
    for _ in 0..LONGEST {
        let from = best;
        for t in &compass {
            let x = space.place(from.1, scale(step, *t));
            best = better(best, (worst(x, best.0), x));
        }
        if best.0 <= from.0 {
            step *= 0.5;
            if step < least {
                break;
            }
        }
    }
    if best.1 == d.at(n) {
        return None;
    }
    let come = gone.iter().map(|e| (d.tets[*e as usize], d.region[*e as usize])).collect();
    Some(Change { gone, come, place: Some((n, best.1)), ..Change::default() })
}

fn better(a: (f64, V3), b: (f64, V3)) -> (f64, V3) {
    if b.0 > a.0 { b } else { a }
}

/// Where a node may go from its place.
fn space(d: &Draft, n: u32) -> Option<Space> {
    Some(match d.freedom[n as usize] {
        Freedom::Fixed => return None,
        Freedom::Line => {
            let [a, b] = d.edges_at(n)[..] else { return None };
            // a coordinate that both ends share stays as it is, bit for bit
            let t = unit(sub(d.at(b), d.at(a)));
            Space { directions: vec![t], constant: None }
        }
        Freedom::Plane(facet) => {
            let facet = &d.polyhedron.facets[facet as usize];
            let (s, t) = tangents(facet.normal);
            Space { directions: vec![s, t], constant: facet.constant }
        }
        Freedom::Space => {
            let axes = vec![[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
            Space { directions: axes, constant: None }
        }
    })
}
