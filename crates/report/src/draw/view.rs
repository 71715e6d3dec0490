//! Projection of a shape onto a picture, and the space around the shape.

use crate::draw::canvas::SAMPLES;
use crate::draw::options::PictureOptions;
use crate::draw::surface::{Surface, SurfaceTriangle};
use bracket_base::math::vec3::{V3, cross, dot, unit};

/// Space for the legend of a field \[pixels\].
pub(super) const LEGEND: f64 = 280.0;
/// Space below the shape for scale bar, names and axes \[pixels\].
const STRIP: f64 = 88.0;
/// White border \[pixels\].
pub(super) const MARGIN: f64 = 24.0;
/// Height of capitals \[pixels\].
pub(super) const LETTER: f64 = 19.0;

/// Space around the places that a field marks, on each side, over their extent.
const AROUND: f64 = 0.4;

/// A view from slightly above that shows the long side across the picture. A shape on one side of
/// the plane x = 0 or y = 0 (a half or quarter model) is seen from its outside.
pub(super) fn natural_eye(surface: &Surface) -> [f64; 3] {
    let (low, high) = surface.extents();
    let size = [0, 1, 2].map(|k| high[k] - low[k]);
    let one_sided = |k: usize| low[k] >= -1e-6 * size[k];
    let (turn, tilt) = (36.0_f64.to_radians(), 26.0_f64.to_radians());
    let (x, y) =
        if size[0] >= size[1] { (turn.sin(), turn.cos()) } else { (turn.cos(), turn.sin()) };
    [x * tilt.cos(), if one_sided(1) { y } else { -y } * tilt.cos(), tilt.sin()]
}

/// Maps points of the shape to the picture.
pub(super) struct View {
    pub right: [f64; 3],
    pub up: [f64; 3],
    pub eye: [f64; 3],
    /// Pixels per millimetre.
    pub scale: f64,
    /// Pixel of the shape's origin.
    pub zero: [f64; 2],
    pub width: usize,
    pub height: usize,
    /// First row below the shape.
    pub strip_top: f64,
    /// Diagonal of the shape \[mm\].
    pub diagonal: f64,
    /// True if the frame cuts the shape.
    pub close: bool,
}

impl View {
    /// The view of a surface; `rest`: further lines that it shows.
    pub(super) fn new(
        surface: &Surface,
        eye: [f64; 3],
        options: &PictureOptions,
        has_legend: bool,
        rest: &[[V3; 2]],
    ) -> Self {
        let world_up = if eye[2].abs() > 0.999 { [0.0, 1.0, 0.0] } else { [0.0, 0.0, 1.0] };
        let right = unit(cross(world_up, eye));
        let up = cross(eye, right);
        let mut frame = Frame::default();
        let focused: Vec<bool> =
            surface.bodies.iter().map(|b| options.focus.contains(&b.as_str())).collect();
        let reached = |n: u32| match (options.around, options.field) {
            (Some(least), Some(f)) => f.values[surface.origin[n as usize] as usize] >= least,
            _ => false,
        };
        let near =
            |t: &&SurfaceTriangle| focused[t.body as usize] || t.nodes.into_iter().any(reached);
        let close = surface.triangles.iter().any(|t| near(&t));
        for triangle in surface.triangles.iter().filter(|t| !close || near(t)) {
            for n in triangle.nodes {
                let p = surface.points[n as usize];
                frame.add([dot(p, right), dot(p, up)]);
            }
        }
        for p in rest.iter().flatten().filter(|_| !close) {
            frame.add([dot(*p, right), dot(*p, up)]);
        }
        if close {
            frame.grow(if options.around.is_some() { AROUND } else { 0.125 });
        }
        let (low, high) = surface.extents();
        let diagonal = (0..3).map(|k| (high[k] - low[k]).powi(2)).sum::<f64>().sqrt();
        let width = options.width.max(320);
        let max_height = options.max_height.max(240);
        let room_x = width as f64 - 2.0 * MARGIN - if has_legend { LEGEND } else { 0.0 };
        let room_y = max_height as f64 - 2.0 * MARGIN - STRIP;
        let [size_x, size_y] = frame.size();
        let scale = (room_x / size_x).min(room_y / size_y);
        // a legend needs some height even beside a flat shape
        let least = if has_legend { 300.0 } else { 120.0 };
        let shape_height = (size_y * scale).max(least).min(room_y);
        let centre = frame.centre();
        let middle = [MARGIN + room_x / 2.0, MARGIN + shape_height / 2.0];
        Self {
            right,
            up,
            eye,
            scale,
            zero: [middle[0] - centre[0] * scale, middle[1] + centre[1] * scale],
            width,
            height: (shape_height + 2.0 * MARGIN + STRIP).round() as usize,
            strip_top: shape_height + 2.0 * MARGIN,
            diagonal,
            close,
        }
    }

    /// Sample coordinates and depth (larger is nearer \[mm\]) of a point.
    pub(super) fn sample(&self, p: [f64; 3]) -> [f64; 3] {
        let s = SAMPLES as f64;
        [
            s * (self.zero[0] + self.scale * dot(p, self.right)),
            s * (self.zero[1] - self.scale * dot(p, self.up)),
            dot(p, self.eye),
        ]
    }
}

/// A rectangle that is enlarged to contain points.
struct Frame([f64; 2], [f64; 2]);

impl Default for Frame {
    fn default() -> Self {
        Frame([f64::INFINITY; 2], [f64::NEG_INFINITY; 2])
    }
}

impl Frame {
    fn add(&mut self, p: [f64; 2]) {
        for k in 0..2 {
            self.0[k] = self.0[k].min(p[k]);
            self.1[k] = self.1[k].max(p[k]);
        }
    }

    fn grow(&mut self, part: f64) {
        let [x, y] = self.size();
        self.0 = [self.0[0] - part * x, self.0[1] - part * y];
        self.1 = [self.1[0] + part * x, self.1[1] + part * y];
    }

    fn size(&self) -> [f64; 2] {
        // an empty or flat shape needs a scale too
        [0, 1].map(|k| (self.1[k] - self.0[k]).max(1e-9))
    }

    fn centre(&self) -> [f64; 2] {
        [0, 1].map(|k| if self.0[k] <= self.1[k] { 0.5 * (self.0[k] + self.1[k]) } else { 0.0 })
    }
}
