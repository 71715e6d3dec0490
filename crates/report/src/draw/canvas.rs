//! A canvas with depth buffer, drawn at twice the resolution and averaged down to the picture.

use crate::draw::lettering::text_segments;

/// A colour, red green blue, 0 … 255.
pub type Rgb = [f32; 3];

/// Number of samples of a pixel along each side.
pub const SAMPLES: usize = 2;

/// A finished picture, 8 bit red green blue.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Picture {
    /// Width \[pixels\].
    pub width: usize,
    /// Height \[pixels\].
    pub height: usize,
    /// Rows from the top, three bytes per pixel.
    pub rgb: Vec<u8>,
}

impl Picture {
    /// The bytes of a `.png` file.
    pub fn to_png(&self) -> Result<Vec<u8>, png::EncodingError> {
        let mut bytes = Vec::new();
        let mut encoder = png::Encoder::new(&mut bytes, self.width as u32, self.height as u32);
        encoder.set_color(png::ColorType::Rgb);
        encoder.set_depth(png::BitDepth::Eight);
        encoder.set_compression(png::Compression::Balanced);
        let mut writer = encoder.write_header()?;
        writer.write_image_data(&self.rgb)?;
        writer.finish()?;
        Ok(bytes)
    }

    /// Colour of a pixel.
    pub fn pixel(&self, x: usize, y: usize) -> [u8; 3] {
        let i = 3 * (y * self.width + x);
        [self.rgb[i], self.rgb[i + 1], self.rgb[i + 2]]
    }
}

/// Colour and depth of every sample. Coordinates are pixels from the top left unless stated
/// otherwise.
pub struct Canvas {
    width: usize,
    height: usize,
    colour: Vec<[u8; 3]>,
    /// Depth of each sample; larger is nearer, −∞ where nothing is drawn.
    depth: Vec<f32>,
}

#[inline]
fn bytes(colour: Rgb) -> [u8; 3] {
    colour.map(|c| c.round().clamp(0.0, 255.0) as u8)
}

impl Canvas {
    /// An empty canvas for a picture of the given size.
    pub fn new(width: usize, height: usize, background: Rgb) -> Self {
        let (width, height) = (SAMPLES * width, SAMPLES * height);
        let n = width * height;
        Self {
            width,
            height,
            colour: vec![bytes(background); n],
            depth: vec![f32::NEG_INFINITY; n],
        }
    }

    /// Draws a triangle given in sample coordinates and depth. `shade` receives the barycentric
    /// coordinates of a sample and twice the area of the triangle in samples.
    pub fn triangle(&mut self, corners: [[f64; 3]; 3], shade: impl Fn([f64; 3], f64) -> Rgb) {
        let [a, b, c] = corners;
        let area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
        if !area.is_finite() || area.abs() < 1e-12 {
            return;
        }
        let low = [0, 1].map(|k| a[k].min(b[k]).min(c[k]));
        let high = [0, 1].map(|k| a[k].max(b[k]).max(c[k]));
        let first = |x: f64| (x - 0.5).ceil().max(0.0) as usize;
        let past = |x: f64, n: usize| ((x + 0.5).floor().max(0.0) as usize).min(n);
        for row in first(low[1])..past(high[1], self.height) {
            let y = row as f64 + 0.5;
            for column in first(low[0])..past(high[0], self.width) {
                let x = column as f64 + 0.5;
                let u = ((x - a[0]) * (c[1] - a[1]) - (y - a[1]) * (c[0] - a[0])) / area;
                let v = ((b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0])) / area;
                let w = [1.0 - u - v, u, v];
                // samples on a shared edge are drawn by both triangles, because a gap would show as
                // a pinhole
                if w.iter().any(|&w| w < -1e-9) {
                    continue;
                }
                let depth = (a[2] * w[0] + b[2] * w[1] + c[2] * w[2]) as f32;
                let i = row * self.width + column;
                if depth > self.depth[i] {
                    self.depth[i] = depth;
                    self.colour[i] = bytes(shade(w, area.abs()));
                }
            }
        }
    }

    /// Darkens samples whose neighbour is empty or farther by more than `jump`. This draws the
    /// outline of the parts in front.
    pub fn outline(&mut self, ink: Rgb, jump: f64) {
        let ink = bytes(ink);
        let mut marked = Vec::new();
        for row in 0..self.height {
            for column in 0..self.width {
                let i = row * self.width + column;
                if self.depth[i] == f32::NEG_INFINITY {
                    continue;
                }
                let behind = |j: usize| self.depth[j] < self.depth[i] - jump as f32;
                if (column > 0 && behind(i - 1))
                    || (column + 1 < self.width && behind(i + 1))
                    || (row > 0 && behind(i - self.width))
                    || (row + 1 < self.height && behind(i + self.width))
                {
                    marked.push(i);
                }
            }
        }
        for i in marked {
            self.colour[i] = ink;
        }
    }

    /// Clears everything below a row.
    pub fn blank_below(&mut self, top: f64, background: Rgb) {
        let (width, height) = (self.width as f64, self.height as f64);
        self.rectangle([0.0, top], [width, height], background);
    }

    /// Clears everything right of a column.
    pub fn blank_right(&mut self, left: f64, background: Rgb) {
        let (width, height) = (self.width as f64, self.height as f64);
        self.rectangle([left, 0.0], [width, height], background);
    }

    /// Fills a rectangle given by its top left and bottom right corners.
    pub fn rectangle(&mut self, from: [f64; 2], to: [f64; 2], colour: Rgb) {
        let s = SAMPLES as f64;
        let limit = |x: f64, n: usize| ((x * s).round().max(0.0) as usize).min(n);
        let colour = bytes(colour);
        for row in limit(from[1], self.height)..limit(to[1], self.height) {
            let (a, b) = (limit(from[0], self.width), limit(to[0], self.width));
            if a < b {
                self.colour[row * self.width + a..row * self.width + b].fill(colour);
            }
        }
    }

    /// Draws the border of a rectangle.
    pub fn frame(&mut self, from: [f64; 2], to: [f64; 2], ink: Rgb) {
        let corners = [from, [to[0], from[1]], to, [from[0], to[1]]];
        for i in 0..4 {
            self.line(corners[i], corners[(i + 1) % 4], 0.5, ink);
        }
    }

    /// Draws a line with round ends. `half` is half its width.
    pub fn line(&mut self, from: [f64; 2], to: [f64; 2], half: f64, ink: Rgb) {
        let s = SAMPLES as f64;
        let (a, b, half) = (from.map(|x| x * s), to.map(|x| x * s), half * s);
        let along = [b[0] - a[0], b[1] - a[1]];
        let length2 = along[0] * along[0] + along[1] * along[1];
        let reach = half + 1.0;
        let first = |x: f64| (x - reach).floor().max(0.0) as usize;
        let past = |x: f64, n: usize| ((x + reach).ceil().max(0.0) as usize).min(n);
        // where the line crosses a height, as a part of its length
        let part = |y: f64| (y - a[1]) / along[1];
        for row in first(a[1].min(b[1]))..past(a[1].max(b[1]), self.height) {
            // only the part of the line that is within reach of the row matters
            let y = row as f64 + 0.5;
            let [t0, t1] = match along[1] == 0.0 {
                true => [0.0, 1.0],
                false => [part(y - reach), part(y + reach)].map(|t| t.clamp(0.0, 1.0)),
            };
            let [x0, x1] = [t0, t1].map(|t| a[0] + t * along[0]);
            for column in first(x0.min(x1))..past(x0.max(x1), self.width) {
                let p = [column as f64 + 0.5 - a[0], row as f64 + 0.5 - a[1]];
                let t = if length2 > 0.0 {
                    ((p[0] * along[0] + p[1] * along[1]) / length2).clamp(0.0, 1.0)
                } else {
                    0.0
                };
                let distance = (p[0] - t * along[0]).hypot(p[1] - t * along[1]);
                let cover = (half + 0.5 - distance).clamp(0.0, 1.0) as f32;
                if cover > 0.0 {
                    let under = &mut self.colour[row * self.width + column];
                    let mixed =
                        [0, 1, 2].map(|k| f32::from(under[k]) * (1.0 - cover) + ink[k] * cover);
                    *under = bytes(mixed);
                }
            }
        }
    }

    /// Writes a text with its baseline at `y`, capitals `height` tall.
    pub fn text(&mut self, text: &str, x: f64, y: f64, height: f64, ink: Rgb) {
        for [from, to] in text_segments(text, x, y, height) {
            self.line(from, to, 0.055 * height, ink);
        }
    }

    /// The picture: samples averaged over each pixel.
    pub fn finish(self) -> Picture {
        let (width, height) = (self.width / SAMPLES, self.height / SAMPLES);
        let mut rgb = Vec::with_capacity(3 * width * height);
        let n = (SAMPLES * SAMPLES) as u32;
        for y in 0..height {
            for x in 0..width {
                for k in 0..3 {
                    let mut sum = n / 2;
                    for row in SAMPLES * y..SAMPLES * (y + 1) {
                        for column in SAMPLES * x..SAMPLES * (x + 1) {
                            sum += u32::from(self.colour[row * self.width + column][k]);
                        }
                    }
                    rgb.push((sum / n) as u8);
                }
            }
        }
        Picture { width, height, rgb }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Every sample that a line covers is drawn, whatever the slope of the line.
    #[test]
    fn lines_of_every_slope_are_whole() {
        for turn in 0..24 {
            let angle = f64::from(turn) * std::f64::consts::PI / 12.0;
            let (a, b) = ([20.0, 20.0], [20.0 + 15.0 * angle.cos(), 20.0 + 15.0 * angle.sin()]);
            let mut canvas = Canvas::new(40, 40, [255.0; 3]);
            canvas.line(a, b, 1.5, [0.0; 3]);
            let s = SAMPLES as f64;
            for (i, colour) in canvas.colour.iter().enumerate() {
                let p = [(i % canvas.width) as f64, (i / canvas.width) as f64];
                let p = p.map(|x| (x + 0.5) / s);
                let along = [b[0] - a[0], b[1] - a[1]];
                let t = ((p[0] - a[0]) * along[0] + (p[1] - a[1]) * along[1]) / 225.0;
                let t = t.clamp(0.0, 1.0);
                let off = [p[0] - a[0] - t * along[0], p[1] - a[1] - t * along[1]];
                let distance = off[0].hypot(off[1]);
                // the edge is one sample wide
                let inside = distance < 1.5 - 0.5 / s - 1e-9;
                let outside = distance > 1.5 + 0.5 / s + 1e-9;
                assert!(!inside || *colour == [0; 3], "{turn}: {p:?} {colour:?}");
                assert!(!outside || *colour == [255; 3], "{turn}: {p:?} {colour:?}");
            }
        }
    }
}
