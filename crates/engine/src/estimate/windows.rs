//! Overlapping windows on an interval.
//!
//! Windows of one width start at every half width, and the last one ends with the interval. So the
//! largest mean over a window depends little on where the first one starts.

use std::ops::Range;

/// Lines closer than this part of the width are one.
const SAME: f64 = 1e-6;

/// A window: a range of the cells between the lines.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Window {
    /// Its cells.
    pub cells: Range<usize>,
    /// True if the cells are the upper half of it, and the mirror image of them the lower half.
    pub halved: bool,
}

/// The windows on an interval and the lines that bound them.
#[derive(Clone, Debug, PartialEq)]
pub struct Windows {
    /// Rising, from the lower to the upper end of the interval \[mm\]. Cell `i` is between the
    /// lines `i` and `i + 1`.
    pub lines: Vec<f64>,
    /// The windows, by their start.
    pub windows: Vec<Window>,
}

impl Windows {
    /// The windows of a width on an interval \[mm\]; one window if the interval is no longer than
    /// that. `mirrored`: the lower end is a plane of symmetry, so that a window has its middle
    /// there. `extra`: further lines; those outside the interval are left out.
    pub fn new(interval: [f64; 2], width: f64, mirrored: bool, extra: &[f64]) -> Self {
        let [start, end] = interval;
        let same = |a: f64, b: f64| (a - b).abs() <= SAME * width;
        let mut spans = Vec::new();
        let middle = start + 0.5 * width;
        if mirrored {
            spans.push(([start, middle.min(end)], true));
        }
        for i in 0u32.. {
            let from = start + 0.5 * width * f64::from(i);
            // also false for a width of 0 or NaN
            let goes_on = from + width < end && !same(from + width, end);
            if !goes_on || width <= 0.0 {
                break;
            }
            spans.push(([from, from + width], false));
        }
        if !(mirrored && end <= middle) {
            spans.push(([(end - width).max(start), end], false));
        }
        let inside = extra.iter().copied().filter(|x| start < *x && *x < end);
        let mut lines: Vec<f64> = spans.iter().flat_map(|(span, _)| *span).chain(inside).collect();
        lines.sort_by(f64::total_cmp);
        lines.dedup_by(|b, a| same(*a, *b));
        let line = |x: f64| lines.partition_point(|l| *l < x && !same(*l, x));
        let window =
            |([a, b], halved): ([f64; 2], bool)| Window { cells: line(a)..line(b), halved };
        let windows = spans.into_iter().map(window).collect();
        Self { lines, windows }
    }

    /// Ends of the cells of a window \[mm\].
    pub fn span(&self, window: &Window) -> [f64; 2] {
        [self.lines[window.cells.start], self.lines[window.cells.end]]
    }

    /// Number of cells.
    pub fn cells(&self) -> usize {
        self.lines.len().saturating_sub(1)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn spans(w: &Windows) -> Vec<([f64; 2], bool)> {
        w.windows.iter().map(|x| (w.span(x), x.halved)).collect()
    }

    #[test]
    fn windows_start_at_every_half_width_and_end_with_the_interval() {
        let w = Windows::new([0.0, 27.0], 10.0, false, &[]);
        let want = [[0.0, 10.0], [5.0, 15.0], [10.0, 20.0], [15.0, 25.0], [17.0, 27.0]];
        assert_eq!(spans(&w), want.map(|s| (s, false)));
        let even = Windows::new([1.0, 21.0], 10.0, false, &[4.0, 30.0]);
        assert_eq!(spans(&even), [[1.0, 11.0], [6.0, 16.0], [11.0, 21.0]].map(|s| (s, false)));
        assert_eq!(even.lines, [1.0, 4.0, 6.0, 11.0, 16.0, 21.0]);
        assert_eq!(even.cells(), 5);
    }

    #[test]
    fn a_short_interval_is_one_window() {
        for length in [4.0, 10.0] {
            let w = Windows::new([2.0, 2.0 + length], 10.0, false, &[]);
            assert_eq!(spans(&w), [([2.0, 2.0 + length], false)]);
        }
    }

    #[test]
    fn a_plane_of_symmetry_is_the_middle_of_a_window() {
        let w = Windows::new([0.0, 17.0], 10.0, true, &[]);
        let want = [([0.0, 5.0], true), ([0.0, 10.0], false), ([5.0, 15.0], false)];
        assert_eq!(spans(&w)[..3], want);
        assert_eq!(spans(&w)[3..], [([7.0, 17.0], false)]);
        let short = Windows::new([0.0, 7.0], 10.0, true, &[]);
        assert_eq!(spans(&short), [([0.0, 5.0], true), ([0.0, 7.0], false)]);
        let half = Windows::new([0.0, 5.0], 10.0, true, &[]);
        assert_eq!(spans(&half), [([0.0, 5.0], true)]);
    }
}
