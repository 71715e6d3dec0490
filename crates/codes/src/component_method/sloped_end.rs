//! The slope and the haunch of a beam where it meets its end plate.

use bracket_joint::assembly::Way;
use serde::{Deserialize, Serialize};

/// A flange where it meets the plate. Lengths in mm.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct EndFlange {
    /// Thickness across the flange.
    pub thickness: f64,
    /// Width.
    pub width: f64,
    /// Angle with the normal of the plate \[rad\]; positive: the flange rises out of the joint.
    pub slope: f64,
}

impl EndFlange {
    /// Thickness along the plate, `t/cos` of the slope \[mm\].
    pub fn along(&self) -> f64 {
        self.thickness / self.slope.cos()
    }

    /// The flange in the joint mirrored at its axis.
    fn mirrored(self) -> Self {
        Self { slope: -self.slope, ..self }
    }
}

/// What a haunch leaves of the beam at the plate. Lengths in mm.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct HaunchedEnd {
    /// Lower and upper face of the beam's own flange between its web and the web of the haunch: z
    /// at the plate.
    pub inner_flange: [f64; 2],
    /// The larger clear depth of the two webs.
    pub panel: f64,
    /// The larger c/t of the outstands of the two outer flanges.
    pub outstand: f64,
    /// Area of the beam without its haunch \[mm²\].
    pub area: f64,
}

/// The end of a beam with a slope or a haunch. Lengths in mm; z from the middle of the depth.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct SlopedEnd {
    /// Depth along the plate between the outer faces of the flanges.
    pub depth: f64,
    /// The upper flange.
    pub upper: EndFlange,
    /// The lower flange: that of the haunch where there is one.
    pub lower: EndFlange,
    /// The haunch; the section of the beam is then the equivalent one at the plate: two flanges
    /// of the smaller width and of the smaller t cos of the slope, the thinner web, no root
    /// fillets, and the lever arm of the real flanges.
    pub haunch: Option<HaunchedEnd>,
}

impl SlopedEnd {
    /// The end in the joint mirrored at the middle of the depth.
    #[must_use]
    pub fn mirrored(self) -> Self {
        let turned = |h: HaunchedEnd| {
            let [lower, upper] = h.inner_flange;
            HaunchedEnd { inner_flange: [-upper, -lower], ..h }
        };
        Self {
            depth: self.depth,
            upper: self.lower.mirrored(),
            lower: self.upper.mirrored(),
            haunch: self.haunch.map(turned),
        }
    }

    /// A flange.
    pub fn flange(&self, flange: Way) -> &EndFlange {
        if flange == Way::Up { &self.upper } else { &self.lower }
    }
}
