//! Effective bearing areas of base plates: the area within the additional width c of the walls of a
//! section, without overlaps, cut at the edges of the plate.
//!
//! # Source
//! EN 1993-1-8:2005 6.2.5(3) to (6), Figure 6.4; 6.2.8.2.

/// An I section on a plate \[mm\].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct IArea {
    /// Depth, width, thickness of the web, thickness of the flanges.
    pub section: [f64; 4],
    /// Distance of the plate's edges from the axis of the column along the depth, the smaller one.
    pub edge: f64,
    /// Width of the plate.
    pub width: f64,
    /// Additional width c.
    pub c: f64,
}

impl IArea {
    /// Length along the depth and width of the area under one flange, cut at the edge of the plate
    /// and at the axis of the column \[mm\].
    pub fn flange(&self) -> [f64; 2] {
        let [h, b, _, tf] = self.section;
        let outer = (0.5 * h + self.c).min(self.edge);
        let inner = (0.5 * h - tf - self.c).max(0.0);
        [(outer - inner).max(0.0), (b + 2.0 * self.c).min(self.width)]
    }

    /// Length and width of the area under the web that is under no flange \[mm\].
    pub fn web(&self) -> [f64; 2] {
        let [h, _, tw, tf] = self.section;
        let inner = (0.5 * h - tf - self.c).max(0.0).min(self.edge);
        [2.0 * inner, (tw + 2.0 * self.c).min(self.width)]
    }

    /// The whole area \[mm²\].
    pub fn area(&self) -> f64 {
        let ([l, b], [l_w, b_w]) = (self.flange(), self.web());
        2.0 * l * b + l_w * b_w
    }
}

/// Sides of the outer and of the inner rectangle of the area under a rectangular hollow section of
/// the size `[h, b]` and the wall `t`, its corners sharp, in the middle of a plate of the size
/// `plate` \[mm\].
pub fn frame(size: [f64; 2], t: f64, plate: [f64; 2], c: f64) -> [[f64; 2]; 2] {
    let outer = [0, 1].map(|k| (size[k] + 2.0 * c).min(plate[k]));
    [outer, size.map(|s| (s - 2.0 * (t + c)).max(0.0))]
}

/// Outer and inner diameter of the area under a circular hollow section of the diameter `d` and the
/// wall `t` in the middle of a plate \[mm\]. A ring beyond the plate is cut by the circle that
/// touches the nearest edge.
pub fn ring(d: f64, t: f64, plate: [f64; 2], c: f64) -> [f64; 2] {
    [(d + 2.0 * c).min(plate[0]).min(plate[1]), (d - 2.0 * (t + c)).max(0.0)]
}
