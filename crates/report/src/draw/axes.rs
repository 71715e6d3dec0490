//! A frame with two axes through zero, ticks and names, for plots of forces and moments.

use crate::draw::svg::{Anchor, Drawing, LINE, Pen};
use crate::figures::{Rounding, significant};
use bracket_base::say;
use bracket_base::words::Text;

/// Side of the frame and margin for the numbers to its left \[pixels\].
const SIDE: f64 = 420.0;
const MARGIN: f64 = 72.0;

/// A square frame that shows −reach to +reach on either axis, or 0 to reach.
pub(crate) struct Axes {
    low: [f64; 2],
    reach: [f64; 2],
}

impl Axes {
    /// Axes with a margin beyond the largest values.
    pub fn new(largest: [f64; 2]) -> Self {
        let quadrant = Self::quadrant(largest);
        Self { low: quadrant.reach.map(|r| -r), ..quadrant }
    }

    /// Axes of values that are not negative.
    pub fn quadrant(largest: [f64; 2]) -> Self {
        let reach = largest.map(|r| if r > 0.0 { 1.08 * r } else { 1.0 });
        Self { low: [0.0; 2], reach }
    }

    /// Upper end of each axis.
    pub fn reach(&self) -> [f64; 2] {
        self.reach
    }

    /// Position of a point in the plot \[pixels\].
    pub fn at(&self, c: [f64; 2]) -> [f64; 2] {
        let part = |k: usize| (c[k] - self.low[k]) / (self.reach[k] - self.low[k]);
        [MARGIN + SIDE * part(0), LINE + SIDE * (1.0 - part(1))]
    }

    /// Draws the frame with its ticks. `names` are the quantities to the right and upwards. Returns
    /// the point where a legend begins.
    pub fn draw(&self, d: &mut Drawing, names: [Text; 2]) -> [f64; 2] {
        let [across, upwards] = names;
        let (low, reach) = (self.low, self.reach);
        let [left, top] = self.at([low[0], reach[1]]);
        let [right, bottom] = self.at([reach[0], low[1]]);
        d.rectangle(Pen::Thin, "none", [left, top], [right, bottom]);
        d.line(Pen::Thin, self.at([low[0], 0.0]), self.at([reach[0], 0.0]));
        d.line(Pen::Thin, self.at([0.0, low[1]]), self.at([0.0, reach[1]]));
        for axis in 0..2 {
            let by = step(reach[axis] - low[axis]);
            let ends = [low, reach].map(|e| (e[axis] / by).abs().floor() as i32);
            for k in -ends[0]..=ends[1] {
                let value = f64::from(k) * by;
                let text = significant(value, 3, Rounding::Nearest).replace('-', "−");
                let text = Text::given(text);
                if axis == 0 {
                    let [x, _] = self.at([value, 0.0]);
                    d.line(Pen::Thin, [x, bottom], [x, bottom + 4.0]);
                    d.text([x, bottom + LINE], Anchor::Middle, text);
                } else {
                    let [_, y] = self.at([0.0, value]);
                    d.line(Pen::Thin, [left - 4.0, y], [left, y]);
                    d.text([left - 8.0, y], Anchor::End, text);
                }
            }
        }
        d.text([0.5 * (left + right), bottom + 2.0 * LINE + 4.0], Anchor::Middle, across);
        let legend = right + 20.0;
        d.text([legend, top + 8.0], Anchor::Start, say!("upwards: {}", upwards));
        [legend, top]
    }
}

/// A round step that divides a range into four to ten parts.
fn step(range: f64) -> f64 {
    let power = 10f64.powf((range / 4.0).log10().floor());
    [5.0, 2.0, 1.0].into_iter().map(|m| m * power).find(|s| range / s >= 4.0).unwrap_or(power)
}
