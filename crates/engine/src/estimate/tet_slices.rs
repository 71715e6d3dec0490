//! Tetrahedra cut into pieces: along parallel planes, and at the middle of their longest edge.

use bracket_base::math::vec3::{V3, det, sub};
use std::ops::Range;

/// A tetrahedron inside another one: the barycentric coordinates of its corners there.
pub type Piece = [[f64; 4]; 4];

/// The whole tetrahedron.
pub const WHOLE: Piece =
    [[1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0], [0.0, 0.0, 0.0, 1.0]];

/// The value at barycentric coordinates `l` of what is linear in the whole tetrahedron, from its
/// values at the corners.
pub fn at<const N: usize>(values: &[[f64; N]; 4], l: &[f64; 4]) -> [f64; N] {
    std::array::from_fn(|c| (0..4).map(|v| l[v] * values[v][c]).sum())
}

/// Centroid of a piece.
pub fn centre(piece: &Piece) -> [f64; 4] {
    std::array::from_fn(|v| 0.25 * piece.iter().map(|l| l[v]).sum::<f64>())
}

/// Volume of a piece over that of the whole tetrahedron.
pub fn share(piece: &Piece) -> f64 {
    // the fourth coordinate of each corner follows from the others
    let first: V3 = [piece[0][0], piece[0][1], piece[0][2]];
    let side = |i: usize| sub([piece[i][0], piece[i][1], piece[i][2]], first);
    det(&[side(1), side(2), side(3)]).abs()
}

fn between(a: &[f64; 4], b: &[f64; 4], t: f64) -> [f64; 4] {
    std::array::from_fn(|v| a[v] + t * (b[v] - a[v]))
}

/// The three tetrahedra of a prism with triangles `a` and `b`, corner `i` above corner `i`.
fn prism(a: [[f64; 4]; 3], b: [[f64; 4]; 3]) -> [Piece; 3] {
    [[a[0], a[1], a[2], b[2]], [a[0], a[1], b[1], b[2]], [a[0], b[0], b[1], b[2]]]
}

/// The pieces below and above a plane that passes between the corners: `h` are the distances of the
/// corners from it, some negative and some positive.
fn halves(piece: &Piece, h: [f64; 4]) -> [Vec<Piece>; 2] {
    let mut order = [0, 1, 2, 3];
    order.sort_by(|&i, &j| h[i].total_cmp(&h[j]));
    let [p, q, r, s] = order.map(|i| piece[i]);
    let cut = |i: usize, j: usize| {
        let (i, j) = (order[i], order[j]);
        between(&piece[i], &piece[j], h[i] / (h[i] - h[j]))
    };
    match h.iter().filter(|x| **x < 0.0).count() {
        1 => {
            let [a, b, c] = [1, 2, 3].map(|j| cut(0, j));
            [vec![[p, a, b, c]], prism([q, r, s], [a, b, c]).to_vec()]
        }
        2 => {
            let [a, b, c, d] = [cut(0, 2), cut(0, 3), cut(1, 2), cut(1, 3)];
            [prism([p, a, b], [q, c, d]).to_vec(), prism([r, a, c], [s, b, d]).to_vec()]
        }
        _ => {
            let [a, b, c] = [0, 1, 2].map(|i| cut(i, 3));
            [prism([p, q, r], [a, b, c]).to_vec(), vec![[s, a, b, c]]]
        }
    }
}

/// Cuts a piece along the planes on which a coordinate has the values `lines`, rising; `x` is the
/// coordinate of the corners of the whole tetrahedron. Hands on every part with the number of its
/// cell, between the lines of that number and the next; parts outside the lines are left out.
pub fn slice(piece: &Piece, x: [f64; 4], lines: &[f64], part: &mut dyn FnMut(usize, &Piece)) {
    within(piece, x, lines, 0..lines.len(), part);
}

/// The same of a piece that only the lines of a range can cut.
fn within(
    piece: &Piece,
    x: [f64; 4],
    lines: &[f64],
    range: Range<usize>,
    part: &mut dyn FnMut(usize, &Piece),
) {
    let own = piece.map(|l| (0..4).map(|v| l[v] * x[v]).sum::<f64>());
    let low = own.iter().copied().fold(f64::INFINITY, f64::min);
    let high = own.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let from = range.start + lines[range.clone()].partition_point(|l| *l <= low);
    let to = range.start + lines[range].partition_point(|l| *l < high);
    if from >= to {
        if from > 0 && from < lines.len() {
            part(from - 1, piece);
        }
        return;
    }
    // no piece meets the same line again, so that rounding cannot go on for ever
    let middle = from + (to - from) / 2;
    let [below, above] = halves(piece, own.map(|y| y - lines[middle]));
    below.iter().for_each(|p| within(p, x, lines, from..middle, part));
    above.iter().for_each(|p| within(p, x, lines, middle + 1..to, part));
}

/// Length of the longest edge of a piece, and the two halves that its middle makes; `x` are the
/// corners of the whole tetrahedron.
pub fn bisect(piece: &Piece, x: &[V3; 4]) -> (f64, [Piece; 2]) {
    let corners = piece.map(|l| at(x, &l));
    let length = |i: usize, j: usize| {
        let d = sub(corners[i], corners[j]);
        d[0] * d[0] + d[1] * d[1] + d[2] * d[2]
    };
    let (mut i, mut j) = (0, 1);
    for (a, b) in [(0, 2), (0, 3), (1, 2), (1, 3), (2, 3)] {
        if length(a, b) > length(i, j) {
            (i, j) = (a, b);
        }
    }
    let middle = between(&piece[i], &piece[j], 0.5);
    let (mut first, mut second) = (*piece, *piece);
    (first[j], second[i]) = (middle, middle);
    (length(i, j).sqrt(), [first, second])
}

#[cfg(test)]
mod tests {
    use super::*;

    const X: [f64; 4] = [0.3, 4.1, -1.2, 2.2];

    /// The slices fill the tetrahedron, each lies in its cell, and the volume below a line is that
    /// of the closed form.
    #[test]
    fn slices_fill_the_tetrahedron() {
        let lines = [-2.0, -0.5, 0.3, 1.0, 1.9, 2.2, 3.0, 5.0];
        let (mut all, mut first) = (0.0, 0.0);
        slice(&WHOLE, X, &lines, &mut |cell, piece| {
            let own = piece.map(|l| (0..4).map(|v| l[v] * X[v]).sum::<f64>());
            let near = |y: f64| y >= lines[cell] - 1e-12 && y <= lines[cell + 1] + 1e-12;
            assert!(own.into_iter().all(near), "{cell} {own:?}");
            all += share(piece);
            if cell == 0 {
                first += share(piece);
            }
        });
        assert!((all - 1.0).abs() < 1e-13, "{all}");
        // the corner at −1.2 cut off at −0.5: a tetrahedron
        let want = 0.7f64.powi(3) / (1.5 * 5.3 * 3.4);
        assert!((first - want).abs() < 1e-14, "{first} {want}");
    }

    #[test]
    fn what_lies_outside_the_lines_is_left_out() {
        let mut inside = 0.0;
        slice(&WHOLE, [0.0, 0.0, 0.0, 1.0], &[0.5, 2.0], &mut |cell, piece| {
            assert_eq!(cell, 0);
            inside += share(piece);
        });
        assert!((inside - 0.125).abs() < 1e-15, "{inside}");
        slice(&WHOLE, X, &[5.0, 6.0], &mut |_, _| panic!("nothing lies there"));
    }

    #[test]
    fn halves_of_the_longest_edge_have_half_the_volume() {
        let x = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 5.0, 0.0], [0.0, 0.0, 2.0]];
        let (longest, parts) = bisect(&WHOLE, &x);
        assert!((longest - 29f64.sqrt()).abs() < 1e-14);
        assert!(parts.iter().all(|p| (share(p) - 0.5).abs() < 1e-15));
    }
}
