//! Pictures of the meshed joint: a z-buffer, no graphics card, the same bytes every time.
//!
//! Orthographic view, flat shading, 2 × 2 supersampling. Lines of the mesh and of the shape are
//! drawn where a pixel of a triangle lies near one of its edges: what is hidden stays hidden
//! without any depth offset.

use crate::math::vec3::{cross, dot, unit};
use crate::mesh::TetMesh;
use crate::report::draw::canvas::{Canvas, Picture, Rgb, SAMPLES};
use crate::report::draw::lettering::text_width;
use crate::report::draw::surface::{EdgeKind, Surface, unit_normal};

/// A crease sharper than this is drawn as an edge of the shape \[rad\]: above the 30° between the
/// facets of a bolt's twelve-sided shank and those of a fillet in three facets, below the 60° of
/// its head.
const FEATURE_ANGLE: f64 = 35.0 * std::f64::consts::PI / 180.0;

const BACKGROUND: Rgb = [255.0, 255.0, 255.0];
const INK: Rgb = [38.0, 42.0, 48.0];
const FRAME: Rgb = [150.0, 154.0, 160.0];
const UNDEFINED: Rgb = [205.0, 205.0, 205.0];

/// Body colours, in the order in which groups of bodies appear.
const BODY_COLOURS: [Rgb; 8] = [
    [176.0, 186.0, 198.0],
    [126.0, 170.0, 214.0],
    [240.0, 188.0, 96.0],
    [214.0, 92.0, 80.0],
    [132.0, 188.0, 122.0],
    [176.0, 142.0, 202.0],
    [98.0, 186.0, 186.0],
    [196.0, 160.0, 124.0],
];

/// Colours of a field from low to high.
const FIELD_COLOURS: [Rgb; 7] = [
    [54.0, 70.0, 158.0],
    [58.0, 142.0, 200.0],
    [92.0, 192.0, 180.0],
    [150.0, 206.0, 104.0],
    [244.0, 220.0, 90.0],
    [240.0, 144.0, 60.0],
    [190.0, 36.0, 44.0],
];

/// A field at the nodes of the mesh, shown in bands of colour.
#[derive(Clone, Copy, Debug)]
pub struct Field<'a> {
    /// What it is, for the legend: `von Mises stress`.
    pub name: &'a str,
    /// Its unit, for the legend; empty for a plain number.
    pub unit: &'a str,
    /// One value a node; NaN where the field is not defined (shown grey).
    pub values: &'a [f64],
    /// Lowest and highest value of the colours; absent: of the field. Values beyond keep the last
    /// colour.
    pub range: Option<[f64; 2]>,
}

/// Displacements drawn larger than they are.
#[derive(Clone, Copy, Debug)]
pub struct Deformed<'a> {
    /// Displacement of each node of the mesh \[mm\].
    pub displacement: &'a [[f64; 3]],
    /// Times this.
    pub factor: f64,
    /// Whether the factor means anything: velocities of a mechanism have no size.
    pub to_scale: bool,
}

/// How a picture is made.
#[derive(Clone, Debug)]
pub struct PictureOptions<'a> {
    /// Width \[pixels\], at least 320.
    pub width: usize,
    /// Height at most \[pixels\], at least 240; less is used where the shape is flat.
    pub max_height: usize,
    /// Axes (0 = x, 1 = y, 2 = z) whose plane through the origin is a symmetry plane to complete
    /// the shape by.
    pub mirror: &'a [usize],
    /// Direction from the shape to the eye; absent: chosen from the shape.
    pub eye: Option<[f64; 3]>,
    /// Bodies to come close to: the frame is theirs plus a quarter, the rest is cut at its border.
    /// Empty: everything.
    pub focus: &'a [&'a str],
    /// Whether the lines of the mesh are drawn.
    pub mesh_lines: bool,
    /// A field instead of body colours.
    pub field: Option<Field<'a>>,
    /// The deformed shape instead of the given one.
    pub deformed: Option<Deformed<'a>>,
}

impl Default for PictureOptions<'_> {
    fn default() -> Self {
        Self {
            width: 1600,
            max_height: 1200,
            mirror: &[],
            eye: None,
            focus: &[],
            mesh_lines: true,
            field: None,
            deformed: None,
        }
    }
}

/// Draws a mesh.
pub fn draw(mesh: &TetMesh, options: &PictureOptions) -> Picture {
    let surface = options.mirror.iter().fold(Surface::of(mesh), |s, &axis| s.mirrored(axis));
    draw_surface(surface, options)
}

/// Draws a surface; nodal arrays of the options are numbered as [`Surface::origin`] says.
pub fn draw_surface(mut surface: Surface, options: &PictureOptions) -> Picture {
    let kinds = surface.edge_kinds(FEATURE_ANGLE);
    let eye = unit(options.eye.unwrap_or_else(|| natural_eye(&surface)));
    if let Some(Deformed { displacement, factor, .. }) = options.deformed {
        for (i, point) in surface.points.iter_mut().enumerate() {
            let u = displacement[surface.origin[i] as usize];
            for k in 0..3 {
                point[k] += factor * surface.signs[i][k] * u[k];
            }
        }
    }
    let groups = Groups::of(&surface.bodies);
    let bands = options.field.map(Bands::of);
    let view = View::new(&surface, eye, options, bands.is_some());
    let mut canvas = Canvas::new(view.width, view.height, BACKGROUND);
    let drawing = Drawing {
        surface: &surface,
        kinds: &kinds,
        view: &view,
        groups: &groups,
        bands: &bands,
        options,
    };
    drawing.triangles(&mut canvas);
    canvas.outline(INK, 0.01 * view.diagonal);
    canvas.blank_below(view.strip_top, BACKGROUND);
    if bands.is_some() {
        canvas.blank_right(view.width as f64 - LEGEND, BACKGROUND);
    }
    if view.close {
        // what the frame cuts is cut on purpose: show the frame
        let right = view.width as f64 - if bands.is_some() { LEGEND } else { 0.0 };
        canvas.frame([1.0, 1.0], [right - 1.0, view.strip_top - 1.0], FRAME);
    }
    if let (Some(bands), Some(field)) = (&bands, options.field) {
        legend(&mut canvas, bands, field, view.width as f64 - LEGEND + 16.0, view.strip_top);
    }
    strip(&mut canvas, &view, &groups, options);
    canvas.finish()
}

/// Room for the legend of a field \[pixels\].
const LEGEND: f64 = 230.0;
/// Room below the shape for scale bar, names and axes \[pixels\].
const STRIP: f64 = 84.0;
/// White border \[pixels\].
const MARGIN: f64 = 24.0;
/// Height of capitals \[pixels\].
const LETTER: f64 = 14.0;

/// A view a little from above that shows the long side wide. A shape on one side of the planes x =
/// 0 or y = 0 (a half or quarter model) is seen from its outside.
fn natural_eye(surface: &Surface) -> [f64; 3] {
    let (low, high) = surface.extents();
    let size = [0, 1, 2].map(|k| high[k] - low[k]);
    let one_sided = |k: usize| low[k] >= -1e-6 * size[k];
    let (turn, tilt) = (36.0_f64.to_radians(), 26.0_f64.to_radians());
    let (x, y) =
        if size[0] >= size[1] { (turn.sin(), turn.cos()) } else { (turn.cos(), turn.sin()) };
    [x * tilt.cos(), if one_sided(1) { y } else { -y } * tilt.cos(), tilt.sin()]
}

/// Where points of the shape come to lie on the picture.
struct View {
    right: [f64; 3],
    up: [f64; 3],
    eye: [f64; 3],
    /// Pixels a millimetre.
    scale: f64,
    /// Pixel of the shape's zero.
    zero: [f64; 2],
    width: usize,
    height: usize,
    /// First row below the shape.
    strip_top: f64,
    /// Diagonal of the shape \[mm\].
    diagonal: f64,
    /// Whether the frame cuts the shape.
    close: bool,
}

impl View {
    fn new(surface: &Surface, eye: [f64; 3], options: &PictureOptions, has_legend: bool) -> Self {
        let world_up = if eye[2].abs() > 0.999 { [0.0, 1.0, 0.0] } else { [0.0, 0.0, 1.0] };
        let right = unit(cross(world_up, eye));
        let up = cross(eye, right);
        let mut frame = Frame::default();
        let focused: Vec<bool> =
            surface.bodies.iter().map(|b| options.focus.contains(&b.as_str())).collect();
        let close = focused.contains(&true);
        for triangle in surface.triangles.iter().filter(|t| !close || focused[t.body as usize]) {
            for n in triangle.nodes {
                let p = surface.points[n as usize];
                frame.add([dot(p, right), dot(p, up)]);
            }
        }
        if close {
            frame.grow(0.125);
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
    fn sample(&self, p: [f64; 3]) -> [f64; 3] {
        let s = SAMPLES as f64;
        [
            s * (self.zero[0] + self.scale * dot(p, self.right)),
            s * (self.zero[1] - self.scale * dot(p, self.up)),
            dot(p, self.eye),
        ]
    }
}

/// A rectangle that grows around points.
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
        // an empty or flat shape still needs a scale
        [0, 1].map(|k| (self.1[k] - self.0[k]).max(1e-9))
    }

    fn centre(&self) -> [f64; 2] {
        [0, 1].map(|k| if self.0[k] <= self.1[k] { 0.5 * (self.0[k] + self.1[k]) } else { 0.0 })
    }
}

/// Bodies that share a colour: those whose names agree up to the first `_` or digit.
struct Groups {
    names: Vec<String>,
    of_body: Vec<usize>,
}

impl Groups {
    fn of(bodies: &[String]) -> Self {
        let mut names: Vec<String> = Vec::new();
        let of_body = bodies
            .iter()
            .map(|body| {
                let stem =
                    body.split(|c: char| c == '_' || c.is_ascii_digit()).next().unwrap_or_default();
                let stem = if stem.is_empty() { body } else { stem };
                names.iter().position(|n| n == stem).unwrap_or_else(|| {
                    names.push(stem.into());
                    names.len() - 1
                })
            })
            .collect();
        Self { names, of_body }
    }

    fn colour(&self, body: u32) -> Rgb {
        BODY_COLOURS[self.of_body.get(body as usize).copied().unwrap_or(0) % BODY_COLOURS.len()]
    }
}

/// Bands of a field, with round limits.
struct Bands {
    low: f64,
    step: f64,
    count: usize,
    /// Lowest and highest value of the field itself.
    extremes: [f64; 2],
}

impl Bands {
    fn of(field: Field) -> Self {
        let defined = field.values.iter().copied().filter(|v| v.is_finite());
        let extremes = [
            defined.clone().fold(f64::INFINITY, f64::min),
            defined.fold(f64::NEG_INFINITY, f64::max),
        ];
        let [low, high] = field.range.unwrap_or(extremes);
        if !(low.is_finite() && high.is_finite() && high > low) {
            // nothing, or one value everywhere: a single band around it
            let value = if low.is_finite() { low } else { 0.0 };
            let step = nice(value.abs().max(1.0));
            return Self { low: (value / step).floor() * step, step, count: 1, extremes };
        }
        let step = nice((high - low) / 12.0);
        let first = (low / step + 1e-9).floor();
        let count = ((high / step - 1e-9).ceil() - first).max(1.0) as usize;
        Self { low: first * step, step, count, extremes }
    }

    fn band(&self, value: f64) -> usize {
        (((value - self.low) / self.step).max(0.0) as usize).min(self.count - 1)
    }

    fn colour(&self, band: usize) -> Rgb {
        let last = FIELD_COLOURS.len() - 1;
        let t =
            if self.count > 1 { band as f64 / (self.count - 1) as f64 * last as f64 } else { 0.0 };
        let i = (t as usize).min(last - 1);
        mix(FIELD_COLOURS[i], FIELD_COLOURS[i + 1], (t - i as f64) as f32)
    }

    /// A limit with the digits that tell it from the next.
    fn label(&self, limit: usize) -> String {
        let value = self.low + limit as f64 * self.step;
        let decimals = (-self.step.log10().floor()).max(0.0) as usize;
        if decimals > 5 || value.abs() >= 1e7 {
            return format!("{value:.2e}");
        }
        let text = format!("{value:.decimals$}");
        if text.trim_start_matches('-').chars().all(|c| c == '0' || c == '.') {
            "0".into()
        } else {
            text
        }
    }
}

/// The smallest of 1, 2, 2.5, 5, 10 times a power of ten that is not below `x`.
fn nice(x: f64) -> f64 {
    let power = 10.0_f64.powf(x.log10().floor());
    [1.0, 2.0, 2.5, 5.0, 10.0]
        .into_iter()
        .map(|m| m * power)
        .find(|s| *s >= x * (1.0 - 1e-9))
        .unwrap_or(10.0 * power)
}

fn mix(a: Rgb, b: Rgb, t: f32) -> Rgb {
    [0, 1, 2].map(|k| a[k] + (b[k] - a[k]) * t)
}

/// What the triangles are drawn from.
struct Drawing<'a> {
    surface: &'a Surface,
    kinds: &'a [[EdgeKind; 3]],
    view: &'a View,
    groups: &'a Groups,
    bands: &'a Option<Bands>,
    options: &'a PictureOptions<'a>,
}

impl Drawing<'_> {
    fn triangles(&self, canvas: &mut Canvas) {
        let points: Vec<[f64; 3]> =
            self.surface.points.iter().map(|&p| self.view.sample(p)).collect();
        let mesh_ink = if self.options.mesh_lines { self.mesh_ink(&points) } else { 0.0 };
        let lamp = unit(
            [0, 1, 2].map(|k| self.view.eye[k] + 0.45 * self.view.up[k] - 0.7 * self.view.right[k]),
        );
        for (t, triangle) in self.surface.triangles.iter().enumerate() {
            let normal = unit_normal(triangle.nodes.map(|n| self.surface.points[n as usize]));
            if dot(normal, self.view.eye) <= 0.0 {
                continue;
            }
            let light =
                (0.58 + 0.30 * dot(normal, lamp).max(0.0) + 0.20 * normal[2].max(0.0)).min(1.06);
            let corners = triangle.nodes.map(|n| points[n as usize]);
            let values = self.options.field.map(|f| {
                triangle.nodes.map(|n| f.values[self.surface.origin[n as usize] as usize])
            });
            let body = self.groups.colour(triangle.body);
            let kinds = self.kinds[t];
            let length = [0, 1, 2].map(|i| {
                let (a, b) = (corners[i], corners[(i + 1) % 3]);
                (a[0] - b[0]).hypot(a[1] - b[1])
            });
            canvas.triangle(corners, |w, double_area| {
                let mut colour = match (values, self.bands) {
                    (Some(v), Some(bands)) => {
                        let value = v[0] * w[0] + v[1] * w[1] + v[2] * w[2];
                        let flat = if value.is_nan() {
                            UNDEFINED
                        } else {
                            bands.colour(bands.band(value))
                        };
                        // pale shading, so that colours still match the legend
                        flat.map(|c| c * (0.45 + 0.55 * light.min(1.0)) as f32)
                    }
                    _ => body.map(|c| c * light as f32),
                };
                for i in 0..3 {
                    let distance = w[(i + 2) % 3] * double_area / length[i].max(1e-9);
                    let (half, ink) = match kinds[i] {
                        EdgeKind::Feature => (1.3, 0.95),
                        EdgeKind::Mesh => (0.55, mesh_ink),
                    };
                    let cover = (half + 0.5 - distance).clamp(0.0, 1.0) * ink;
                    colour = mix(colour, INK, cover as f32);
                }
                colour
            });
        }
    }

    /// Strength of mesh lines: full for coarse meshes, fading where lines would merge into a grey
    /// blur.
    fn mesh_ink(&self, points: &[[f64; 3]]) -> f64 {
        let mut lengths: Vec<f64> = self
            .surface
            .triangles
            .iter()
            .map(|t| {
                let [a, b] = [points[t.nodes[0] as usize], points[t.nodes[1] as usize]];
                (a[0] - b[0]).hypot(a[1] - b[1])
            })
            .collect();
        if lengths.is_empty() {
            return 0.0;
        }
        let middle = lengths.len() / 2;
        let (_, median, _) = lengths.select_nth_unstable_by(middle, f64::total_cmp);
        0.55 * (*median / (8.0 * SAMPLES as f64)).clamp(0.25, 1.0)
    }
}

/// The colour legend of a field, its top at the picture's top.
fn legend(canvas: &mut Canvas, bands: &Bands, field: Field, left: f64, bottom: f64) {
    let mut y = MARGIN + LETTER;
    let mut title = |canvas: &mut Canvas, text: &str| {
        let size = LETTER.min(LETTER * (LEGEND - 32.0) / text_width(text, LETTER).max(1.0));
        canvas.text(text, left, y, size, INK);
        y += 1.7 * LETTER;
    };
    title(canvas, field.name);
    if !field.unit.is_empty() {
        title(canvas, &format!("[{}]", field.unit));
    }
    let height = ((bottom - y - 4.0 * LETTER) / bands.count as f64).clamp(8.0, 44.0);
    let top = y;
    let label_every = (1.6 * LETTER / height).ceil().max(1.0) as usize;
    for i in 0..bands.count {
        // high values on top
        let box_top = top + (bands.count - 1 - i) as f64 * height;
        canvas.rectangle([left, box_top], [left + 34.0, box_top + height], bands.colour(i));
        canvas.frame([left, box_top], [left + 34.0, box_top + height], INK);
    }
    for i in (0..=bands.count).step_by(label_every) {
        let at = top + (bands.count - i) as f64 * height;
        canvas.line([left + 34.0, at], [left + 40.0, at], 0.6, INK);
        canvas.text(&bands.label(i), left + 46.0, at + LETTER / 2.0 - 1.0, LETTER * 0.9, INK);
    }
    if bands.extremes[0].is_finite() {
        let foot = top + bands.count as f64 * height + 2.0 * LETTER;
        canvas.text(
            &format!("min {}", four_digits(bands.extremes[0])),
            left,
            foot,
            LETTER * 0.8,
            INK,
        );
        canvas.text(
            &format!("max {}", four_digits(bands.extremes[1])),
            left,
            foot + 1.5 * LETTER,
            LETTER * 0.8,
            INK,
        );
    }
}

fn four_digits(x: f64) -> String {
    if x == 0.0 {
        return "0".into();
    }
    if !(1e-3..1e6).contains(&x.abs()) {
        return format!("{x:.3e}");
    }
    let decimals = (3 - x.abs().log10().floor() as i32).max(0) as usize;
    format!("{x:.decimals$}")
}

/// Scale bar, names of the bodies, magnification and axes below the shape.
fn strip(canvas: &mut Canvas, view: &View, groups: &Groups, options: &PictureOptions) {
    let base = view.strip_top + 46.0;
    let mut x = axes(canvas, view, [MARGIN + 36.0, view.strip_top + 30.0]) + 28.0;
    let length = nice(110.0 / view.scale);
    let end = x + length * view.scale;
    canvas.line([x, base], [end, base], 1.4, INK);
    for at in [x, end] {
        canvas.line([at, base - 6.0], [at, base + 6.0], 1.0, INK);
    }
    let text = format!("{} mm", four_digits_plain(length));
    canvas.text(&text, 0.5 * (x + end) - 0.5 * text_width(&text, LETTER), base - 10.0, LETTER, INK);
    x = end + 40.0;
    if let Some(deformed) = options.deformed {
        let text = if deformed.to_scale {
            format!("displacements × {}", four_digits_plain(deformed.factor))
        } else {
            "velocities, to no scale".into()
        };
        canvas.text(&text, x, base, LETTER, INK);
        x += text_width(&text, LETTER) + 36.0;
    }
    if options.field.is_none() {
        for (i, name) in groups.names.iter().enumerate() {
            let width = 24.0 + text_width(name, LETTER);
            if x + width > view.width as f64 - MARGIN {
                break;
            }
            canvas.rectangle(
                [x, base - LETTER],
                [x + 16.0, base + 2.0],
                BODY_COLOURS[i % BODY_COLOURS.len()],
            );
            canvas.frame([x, base - LETTER], [x + 16.0, base + 2.0], INK);
            canvas.text(name, x + 24.0, base, LETTER, INK);
            x += width + 28.0;
        }
    }
}

fn four_digits_plain(x: f64) -> String {
    let text = four_digits(x);
    if text.contains('.') && !text.contains('e') {
        text.trim_end_matches('0').trim_end_matches('.').into()
    } else {
        text
    }
}

/// The three axes as seen; returns where they end on the right.
fn axes(canvas: &mut Canvas, view: &View, at: [f64; 2]) -> f64 {
    let directions = [0, 1, 2].map(|k| [30.0 * view.right[k], -30.0 * view.up[k]]);
    for (direction, name) in directions.iter().zip(["x", "y", "z"]) {
        let length = direction[0].hypot(direction[1]);
        let tip = [at[0] + direction[0], at[1] + direction[1]];
        canvas.line(at, tip, 1.0, INK);
        if length < 6.0 {
            continue;
        }
        let along = direction.map(|c| c / length);
        for side in [-1.0, 1.0] {
            let back = [
                tip[0] - 7.0 * along[0] - side * 3.0 * along[1],
                tip[1] - 7.0 * along[1] + side * 3.0 * along[0],
            ];
            canvas.line(tip, back, 1.0, INK);
        }
        let letter = [tip[0] + 11.0 * along[0] - 3.5, tip[1] + 11.0 * along[1] + 4.0];
        canvas.text(name, letter[0], letter[1], 11.0, INK);
    }
    at[0] + 46.0
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn round_steps() {
        for (x, wanted) in [
            (0.9, 1.0),
            (1.0, 1.0),
            (1.1, 2.0),
            (2.2, 2.5),
            (26.0, 50.0),
            (70.0, 100.0),
            (0.003, 0.005),
        ] {
            assert!((nice(x) - wanted).abs() < 1e-12 * wanted, "{x} {}", nice(x));
        }
    }

    #[test]
    fn bands_cover_the_field_with_round_limits() {
        let values = [-3.0, f64::NAN, 97.0];
        let bands = Bands::of(Field { name: "s", unit: "MPa", values: &values, range: None });
        assert_eq!((bands.low, bands.step, bands.count), (-10.0, 10.0, 11));
        assert_eq!(
            (bands.band(-3.0), bands.band(0.0), bands.band(97.0), bands.band(1e9)),
            (0, 1, 10, 10)
        );
        assert_eq!((bands.label(0), bands.label(1)), ("-10".to_string(), "0".to_string()));
        for values in [vec![], vec![5.0; 3], vec![0.0; 2], vec![f64::NAN]] {
            let bands = Bands::of(Field { name: "s", unit: "", values: &values, range: None });
            assert!(bands.count == 1 && bands.step > 0.0, "{values:?}");
        }
    }

    #[test]
    fn bodies_are_grouped_by_the_stem_of_their_names() {
        let names = ["COLUMN", "BEAM_R", "BOLT_RP1", "BOLT_RP2", "BEAM2", "9A"].map(String::from);
        let groups = Groups::of(&names);
        assert_eq!(groups.names, ["COLUMN", "BEAM", "BOLT", "9A"]);
        assert_eq!(groups.of_body, [0, 1, 2, 2, 1, 3]);
    }
}
