//! Pictures of the meshed joint, drawn with a z-buffer. They need no graphics card and have the
//! same bytes every time.
//!
//! The view is orthographic, with flat shading and 2 × 2 supersampling. Lines of the mesh and of
//! the shape are drawn where a pixel of a triangle lies near one of its edges, so that hidden lines
//! remain hidden without a depth offset.

use crate::draw::canvas::{Canvas, Picture, SAMPLES};
use crate::draw::legend::{legend, mark, strip};
pub use crate::draw::options::{Colours, Deformed, Field, Mark, PictureOptions};
use crate::draw::palette::{BACKGROUND, Bands, FRAME, Groups, INK, UNDEFINED, mix};
use crate::draw::surface::{EdgeKind, Surface, unit_normal};
use crate::draw::view::{LEGEND, View, natural_eye};
use bracket_base::math::vec3::{V3, dot, unit};
use bracket_engine::mesh::TetMesh;

/// Smallest angle of a crease that is drawn as an edge of the shape \[rad\]. It is above the 30°
/// between the facets of a bolt's twelve-sided shank and those of a fillet in three facets, and
/// below the 60° of the bolt's head.
const FEATURE_ANGLE: f64 = 35.0 * std::f64::consts::PI / 180.0;

/// Half width \[samples\] and strength of the lines of the shape.
const FEATURE_LINE: (f64, f64) = (1.3, 0.95);

/// Draws a mesh.
pub fn draw(mesh: &TetMesh, options: &PictureOptions) -> Picture {
    draw_surface(completed(mesh, options.mirror), options)
}

/// The surface of a mesh, completed by reflection in the planes of symmetry with the normals
/// `mirror`.
pub fn completed(mesh: &TetMesh, mirror: &[usize]) -> Surface {
    mirror.iter().fold(Surface::of(mesh), |s, &axis| s.mirrored(axis))
}

/// Draws a surface. Nodal arrays of the options are numbered as in [`Surface::origin`].
pub fn draw_surface(mut surface: Surface, options: &PictureOptions) -> Picture {
    let kinds = surface.edge_kinds(FEATURE_ANGLE);
    let eye = unit(options.eye.unwrap_or_else(|| natural_eye(&surface)));
    let rest = if options.ghost { ghost_lines(&surface, &kinds, eye) } else { Vec::new() };
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
    let view = View::new(&surface, eye, options, bands.is_some(), &rest);
    let mut canvas = Canvas::new(view.width, view.height, BACKGROUND);
    let drawing = Drawing {
        surface: &surface,
        kinds: &kinds,
        view: &view,
        groups: &groups,
        bands: &bands,
        options,
    };
    for [a, b] in &rest {
        let [a, b] = [a, b].map(|p| view.sample(*p).map(|x| x / SAMPLES as f64));
        canvas.line([a[0], a[1]], [b[0], b[1]], 0.8, FRAME);
    }
    drawing.triangles(&mut canvas);
    canvas.outline(INK, 0.01 * view.diagonal);
    canvas.blank_below(view.strip_top, BACKGROUND);
    if bands.is_some() {
        canvas.blank_right(view.width as f64 - LEGEND, BACKGROUND);
    }
    if view.close {
        // the frame cuts the shape on purpose, so the frame is drawn
        let right = view.width as f64 - if bands.is_some() { LEGEND } else { 0.0 };
        canvas.frame([1.0, 1.0], [right - 1.0, view.strip_top - 1.0], FRAME);
    }
    if let (Some(bands), Some(field)) = (&bands, options.field) {
        let corner = [view.width as f64 - LEGEND + 16.0, view.strip_top];
        legend(&mut canvas, bands, (field, options.note), corner);
    }
    if let Some(marked) = options.mark {
        let right = view.width as f64 - if bands.is_some() { LEGEND } else { 0.0 };
        mark(&mut canvas, &view, marked, right);
    }
    strip(&mut canvas, &view, &groups, options);
    canvas.finish()
}

/// The edges of the shape whose front can be seen.
fn ghost_lines(surface: &Surface, kinds: &[[EdgeKind; 3]], eye: V3) -> Vec<[V3; 2]> {
    let point = |n: u32| surface.points[n as usize];
    let mut out = Vec::new();
    for (triangle, kinds) in surface.triangles.iter().zip(kinds) {
        if dot(unit_normal(triangle.nodes.map(point)), eye) <= 0.0 {
            continue;
        }
        for i in (0..3).filter(|i| kinds[*i] == EdgeKind::Feature) {
            out.push([point(triangle.nodes[i]), point(triangle.nodes[(i + 1) % 3])]);
        }
    }
    out
}

/// Data from which the triangles are drawn.
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
        let lines = self.lines();
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
            let touched: Vec<[[f64; 3]; 2]> = triangle
                .nodes
                .iter()
                .flat_map(|n| lines[*n as usize].iter().map(|m| [*n, *m]))
                .filter(|[_, m]| !triangle.nodes.contains(m))
                .map(|line| line.map(|n| points[n as usize]))
                .collect();
            let length = [0, 1, 2].map(|i| {
                let (a, b) = (corners[i], corners[(i + 1) % 3]);
                (a[0] - b[0]).hypot(a[1] - b[1])
            });
            canvas.triangle(corners, |w, double_area| {
                let mut colour = match (values, self.bands) {
                    (Some(v), Some(bands)) => {
                        let value = between(v, w);
                        let flat = if value.is_nan() {
                            UNDEFINED
                        } else {
                            bands.colour(bands.band(value))
                        };
                        // pale shading, so that the colours still match the legend
                        flat.map(|c| c * (0.45 + 0.55 * light.min(1.0)) as f32)
                    }
                    _ => body.map(|c| c * light as f32),
                };
                let mut cover = 0.0f64;
                for i in 0..3 {
                    let distance = w[(i + 2) % 3] * double_area / length[i].max(1e-9);
                    let (half, ink) = match kinds[i] {
                        EdgeKind::Feature => FEATURE_LINE,
                        EdgeKind::Mesh => (0.55, mesh_ink),
                    };
                    cover = cover.max((half + 0.5 - distance).clamp(0.0, 1.0) * ink);
                }
                // lines that end at a corner of the triangle
                let at = |k: usize| (0..3).map(|j| w[j] * corners[j][k]).sum::<f64>();
                for [a, b] in &touched {
                    let (half, ink) = FEATURE_LINE;
                    let distance = to_segment([at(0), at(1)], [a[0], a[1]], [b[0], b[1]]);
                    cover = cover.max((half + 0.5 - distance).clamp(0.0, 1.0) * ink);
                }
                colour = mix(colour, INK, cover as f32);
                colour
            });
        }
    }

    /// The other ends of the lines of the shape at each point, without lines behind the shape. A
    /// triangle that touches a line with a corner only covers a part of its width.
    fn lines(&self) -> Vec<Vec<u32>> {
        let mut lines = vec![Vec::new(); self.surface.points.len()];
        for (triangle, kinds) in self.surface.triangles.iter().zip(self.kinds) {
            let normal = unit_normal(triangle.nodes.map(|n| self.surface.points[n as usize]));
            if dot(normal, self.view.eye) <= 0.0 {
                continue;
            }
            for i in (0..3).filter(|i| kinds[*i] == EdgeKind::Feature) {
                let [a, b] = [triangle.nodes[i], triangle.nodes[(i + 1) % 3]];
                lines[a as usize].push(b);
                lines[b as usize].push(a);
            }
        }
        lines
    }

    /// Strength of mesh lines: full for coarse meshes, fading where lines would merge into a grey
    /// area.
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

/// The value at a point of a triangle by its barycentric coordinates. Where the field is not
/// defined at a corner, NaN near that corner and the value of the others beyond.
#[inline]
fn between(values: [f64; 3], w: [f64; 3]) -> f64 {
    let value = values[0] * w[0] + values[1] * w[1] + values[2] * w[2];
    if !value.is_nan() {
        return value;
    }
    let defined = (0..3).filter(|k| !values[*k].is_nan());
    let (sum, weight) =
        defined.fold((0.0, 0.0), |(sum, weight), k| (sum + w[k] * values[k], weight + w[k]));
    if weight > 0.5 { sum / weight } else { f64::NAN }
}

/// Distance of the point `x` from the segment from `a` to `b`.
#[inline]
fn to_segment(x: [f64; 2], a: [f64; 2], b: [f64; 2]) -> f64 {
    let (d, e) = ([b[0] - a[0], b[1] - a[1]], [x[0] - a[0], x[1] - a[1]]);
    let square = (d[0] * d[0] + d[1] * d[1]).max(f64::MIN_POSITIVE);
    let along = ((d[0] * e[0] + d[1] * e[1]) / square).clamp(0.0, 1.0);
    (e[0] - along * d[0]).hypot(e[1] - along * d[1])
}
