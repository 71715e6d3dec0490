//! Forces per length along welds, from a stress field.
//!
//! The faces of a weld are a flat band: the thickness of a plate across, the length of the weld
//! along. The tractions are linear on a face, and the faces are cut exactly, so that the means are
//! those of the field; how far the field is from the exact solution is not known.

use super::windows::{Window, Windows};
use crate::certify::StressField;
use crate::certify::faces::InterfaceFace;
use crate::certify::tractions::{at_barycentric, contact_tractions};
use crate::mesh::TetMesh;
use crate::mesh::topology::{FaceTable, face_nodes};
use crate::model::AnalysisModel;
use crate::model::analysis::{BoundaryFace, FacePair};
use bracket_base::math::Sum;
use bracket_base::math::quadrature::triangle_mass;
use bracket_base::math::vec3::{V3, cross, dot, unit};

/// A weld, and how its forces are averaged.
#[derive(Clone, Debug, PartialEq)]
pub struct WeldBand {
    /// Its faces: those of a [`Weld`](crate::model::analysis::Weld), or [`tied_faces`].
    pub faces: Vec<FacePair>,
    /// Unit vector along the weld, in the plane of its faces.
    pub along: V3,
    /// Length over which the forces are averaged \[mm\].
    pub length: f64,
    /// Whether the faces end at a plane of symmetry at the start of the weld, the lowest coordinate
    /// along it.
    pub mirrored_along: bool,
    /// Whether a plane of symmetry halves the weld along its whole length, so that the faces are
    /// half of the band.
    pub mirrored_across: bool,
}

/// Mean forces per length of a piece of a weld: the actions of side B on side A.
///
/// The axes are the normal out of side A, `along`, and `across` = normal × along.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Segment {
    /// Ends of the piece: coordinates `x·along` \[mm\].
    pub span: [f64; 2],
    /// Force normal to the faces, tension positive \[N/mm\].
    pub normal: f64,
    /// Force across the weld in the plane of the faces, positive along `across` \[N/mm\].
    pub across: f64,
    /// Force along the weld \[N/mm\].
    pub along: f64,
    /// Couple of the normal tractions about the middle line of the faces, positive with tension on
    /// the side that `across` points to \[N mm/mm\].
    pub couple: f64,
}

/// The pieces of each weld, in the order of the welds; none of a weld without faces.
///
/// Pieces start at every half length, and the last one ends with the weld; a weld that is no longer
/// than `length` is one piece. Loads on the faces count as carried by the weld.
pub fn line_forces(
    model: &AnalysisModel,
    field: &StressField,
    welds: &[WeldBand],
) -> Vec<Vec<Segment>> {
    let segments = |weld: &WeldBand| {
        Band::new(model, weld).map_or_else(Vec::new, |band| band.segments(model, field))
    };
    welds.iter().map(segments).collect()
}

/// The faces with a name between bodies that share their nodes; side A is the body `a`. Faces that
/// do not bound `a` and another body are left out.
pub fn tied_faces(mesh: &TetMesh, name: &str, a: u32) -> Vec<FacePair> {
    let Some(named) = mesh.faces_named(name) else { return Vec::new() };
    let table = FaceTable::new(&mesh.tets);
    let pair = |triangle: &[u32; 3]| {
        let owners = table.owners(*triangle);
        let of_a = |tet: u32| mesh.tet_body[tet as usize] == a;
        let own = owners.iter().find(|o| of_a(o.tet))?;
        let other = owners.iter().find(|o| !of_a(o.tet))?;
        let nodes = face_nodes(&mesh.tets[own.tet as usize], own.local);
        let side = |tet, local| BoundaryFace { tet, local };
        Some(FacePair {
            a: side(own.tet, own.local),
            b: side(other.tet, other.local),
            nodes_a: nodes,
            nodes_b: nodes,
        })
    };
    named.triangles.iter().filter_map(pair).collect()
}

fn side_a(face: &FacePair) -> InterfaceFace<'_, ()> {
    let b = Some((face.b, face.nodes_b));
    InterfaceFace { index: 0, law: &(), of: 0, a: face.a, nodes_a: face.nodes_a, b }
}

/// Barycentric coordinates of the corners of a triangle inside another one.
type Part = [[f64; 3]; 3];

/// A face with its tractions, in the axes of the weld: normal, across, along.
struct Loaded {
    area: f64,
    /// Coordinates along the weld at the corners \[mm\].
    along: [f64; 3],
    /// Distances from the middle line at the corners \[mm\].
    arm: [f64; 3],
    /// Tractions at the corners \[MPa\].
    traction: [V3; 3],
}

/// Integrals of the tractions over a cell: normal, across, along, and the couple.
type Cell = [Sum; 4];

/// A weld in its axes.
struct Band<'a> {
    by: &'a WeldBand,
    /// Normal out of side A, across, along.
    axes: [V3; 3],
    /// Coordinate of the middle line across \[mm\].
    middle: f64,
    windows: Windows,
}

impl<'a> Band<'a> {
    /// `None` without faces, or if they have no extent along the weld.
    fn new(model: &AnalysisModel, by: &'a WeldBand) -> Option<Self> {
        let (normal, _) = side_a(by.faces.first()?).normal(model);
        let along = unit(by.along);
        let across = cross(normal, along);
        let extent = |axis: V3| {
            let at = by.faces.iter().flat_map(|f| side_a(f).corners(model)).map(|x| dot(x, axis));
            at.fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], x| [a.min(x), b.max(x)])
        };
        let [low, high] = extent(across);
        let span = extent(along);
        let windows = Windows::new(span, by.length, by.mirrored_along, &[]);
        let axes = [normal, across, along];
        (span[1] > span[0]).then_some(Self { by, axes, middle: 0.5 * (low + high), windows })
    }

    fn loaded(&self, model: &AnalysisModel, field: &StressField, face: &FacePair) -> Loaded {
        let face = side_a(face);
        let (_, area) = face.normal(model);
        let corners = face.corners(model);
        let [_, across, along] = self.axes;
        Loaded {
            area,
            along: corners.map(|x| dot(x, along)),
            arm: corners.map(|x| dot(x, across) - self.middle),
            // tractions of contacts are pressures on side A, those of welds tensions
            traction: contact_tractions(model, field, &face, None)
                .map(|r| self.axes.map(|axis| -dot(r, axis))),
        }
    }

    fn segments(&self, model: &AnalysisModel, field: &StressField) -> Vec<Segment> {
        let mut cells = vec![Cell::default(); self.windows.cells()];
        for face in &self.by.faces {
            let face = self.loaded(model, field, face);
            for (cell, ends) in cells.iter_mut().zip(self.windows.lines.windows(2)) {
                for part in parts(&face.along, [ends[0], ends[1]]) {
                    face.add(&part, cell);
                }
            }
        }
        self.windows.windows.iter().map(|w| self.segment(w, &cells)).collect()
    }

    /// The mean of a window, completed by what planes of symmetry mirror.
    fn segment(&self, window: &Window, cells: &[Cell]) -> Segment {
        let [start, end] = self.windows.span(window);
        let of = |i: usize| {
            Sum::of(cells[window.cells.clone()].iter().map(|c| c[i].value())) / (end - start)
        };
        let [normal, across, along, couple] = [0, 1, 2, 3].map(of);
        let whole = Segment { span: [start, end], normal, across, along, couple };
        let completed = match window.halved {
            // the mirror image pulls along the weld the other way
            true => Segment { span: [2.0 * start - end, end], along: 0.0, ..whole },
            false => whole,
        };
        match self.by.mirrored_across {
            true => Segment {
                normal: 2.0 * normal,
                along: 2.0 * completed.along,
                across: 0.0,
                couple: 0.0,
                ..completed
            },
            false => completed,
        }
    }
}

impl Loaded {
    /// Adds the integrals over a part of the face, exact for linear tractions.
    fn add(&self, part: &Part, cell: &mut Cell) {
        let corners = part.map(|l| at_barycentric(&self.traction, l));
        let arms = part.map(|l| (0..3).map(|i| l[i] * self.arm[i]).sum::<f64>());
        let area = self.area * share(part);
        for i in 0..3 {
            for axis in 0..3 {
                cell[axis].add(area / 3.0 * corners[i][axis]);
            }
            for j in 0..3 {
                cell[3].add(area * triangle_mass(i, j) * corners[i][0] * arms[j]);
            }
        }
    }
}

/// Area of a part over that of the whole triangle.
fn share(part: &Part) -> f64 {
    let side = |i: usize| [part[i][0] - part[0][0], part[i][1] - part[0][1]];
    let (a, b) = (side(1), side(2));
    (a[0] * b[1] - a[1] * b[0]).abs()
}

/// Triangles that fill the part of a triangle between two lines; `x` is the coordinate of its
/// corners across the lines.
fn parts(x: &[f64; 3], [low, high]: [f64; 2]) -> Vec<Part> {
    let corners = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    let above = kept(&corners, &|l| value(x, l) - low);
    let polygon = kept(&above, &|l| high - value(x, l));
    let fan = polygon.windows(2).skip(1).map(|edge| [polygon[0], edge[0], edge[1]]);
    fan.collect()
}

fn value(x: &[f64; 3], l: &[f64; 3]) -> f64 {
    (0..3).map(|i| l[i] * x[i]).sum()
}

/// The part of a convex polygon in which a linear function is not negative.
fn kept(polygon: &[[f64; 3]], inside: &dyn Fn(&[f64; 3]) -> f64) -> Vec<[f64; 3]> {
    let mut out = Vec::with_capacity(polygon.len() + 1);
    for (i, p) in polygon.iter().enumerate() {
        let q = &polygon[(i + 1) % polygon.len()];
        let (a, b) = (inside(p), inside(q));
        if a >= 0.0 {
            out.push(*p);
        }
        if (a > 0.0 && b < 0.0) || (a < 0.0 && b > 0.0) {
            let t = a / (a - b);
            out.push(std::array::from_fn(|d| p[d] + t * (q[d] - p[d])));
        }
    }
    out
}

#[cfg(test)]
mod tests;
