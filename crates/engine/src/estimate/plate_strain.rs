//! Mean strains of plates from a displacement with plastic strain.
//!
//! The strain at a point of a corner or of a hinge grows without limit as the mesh becomes finer;
//! its mean over a prism as wide and as long as the plate is thick converges. The mean is exact for
//! the field but for the edges of excluded discs; how far the field is from the exact solution is
//! not known. So the numbers are estimates.
//!
//! # Source
//! EN 1993-1-5:2006 C.8: the principal membrane strain in tension is at most 5 %.

use super::plate::{Plate, Zone};
use super::tet_slices::{Piece, WHOLE, at, bisect, centre, share, slice};
use super::windows::{Window, Windows};
use crate::certify::PlasticField;
use crate::certify::plastic_field::{PlasticPiece, length};
use crate::elements::space::Tet10Space;
use crate::elements::tet10::vertex_strains;
use crate::model::AnalysisModel;
use bracket_base::math::eigen::eigen;
use bracket_base::math::mandel::{Mandel, symmetric_part, to_matrix};
use bracket_base::math::vec3::{M3, V3, dot, mul};
use rayon::prelude::*;

/// Pieces that the edge of a disc crosses are divided down to this part of the thickness.
const PIECE: f64 = 1.0 / 16.0;

/// Least share of a prism that the plate must fill, the excluded zones left out; prisms with less
/// do not count. Half of it, less rounding.
const FILLED: f64 = 0.5 - 1e-6;

/// A largest mean, and the middle of the prism where it is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Peak {
    /// The mean strain, a fraction; NaN if a strain is NaN.
    pub value: f64,
    /// Middle of the prism \[mm\].
    pub at: V3,
}

/// Largest mean strains of a plate; `None` where no prism is filled by half.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PlateStrain {
    /// Largest principal strain in the plane of the plate, tension positive: of the mean total
    /// strain over the whole depth of a prism t × t × t. The membrane strain of a plate.
    pub membrane: Option<Peak>,
    /// The same with the strains across the plane: the largest principal value of that mean tensor
    /// in all directions. Never less than `membrane`.
    pub tensile: Option<Peak>,
    /// Largest mean equivalent plastic strain `√(2/3) ‖ε_p‖` in a layer t × t × t/4 at either
    /// surface.
    pub surface: Option<Peak>,
}

/// The largest mean strains of each plate, in the order of the plates.
///
/// Prisms start at every half thickness along both directions of the plane. Those that the plate
/// fills by less than half do not count.
pub fn plate_strains(
    model: &AnalysisModel,
    field: &PlasticField,
    plates: &[Plate],
) -> Vec<PlateStrain> {
    let space = Tet10Space::new(&model.mesh);
    plates.par_iter().map(|plate| strain_of(model, field, &space, plate, PIECE)).collect()
}

/// The same of one plate; `piece`: see [`PIECE`].
fn strain_of(
    model: &AnalysisModel,
    field: &PlasticField,
    space: &Tet10Space,
    plate: &Plate,
    piece: f64,
) -> PlateStrain {
    if !plate.is_solid() {
        return PlateStrain::default();
    }
    let mut sums = Sums::new(plate, piece);
    for e in (0..model.mesh.tets.len()).filter(|&e| model.mesh.tet_body[e] == plate.body) {
        if sums.may_meet(&model.mesh.corners(e)) {
            field.pieces(model, space, e).iter().for_each(|tet| sums.add(tet));
        }
    }
    sums.peaks()
}

/// Integrals over a cell of the grid.
#[derive(Clone, Copy, Debug, Default)]
struct Cell {
    volume: f64,
    strain: Mandel,
    equivalent: f64,
}

impl Cell {
    fn add(&mut self, other: &Self) {
        self.volume += other.volume;
        self.equivalent += other.equivalent;
        (0..6).for_each(|c| self.strain[c] += other.strain[c]);
    }
}

/// A (sub)tet with what is linear in it.
struct Linear {
    /// Corners in the coordinates of the plate \[mm\].
    corners: [V3; 4],
    volume: f64,
    strain: [Mandel; 4],
    plastic: [[f64; 5]; 4],
}

impl Linear {
    fn new(tet: &PlasticPiece, plate: &Plate) -> Self {
        Self {
            corners: tet.corners.map(|x| plate.coordinates(x)),
            volume: tet.volume,
            strain: vertex_strains(&tet.corners, &tet.displacements),
            plastic: tet.plastic,
        }
    }

    fn coordinate(&self, i: usize) -> [f64; 4] {
        self.corners.map(|c| c[i])
    }

    /// Integrals over a piece: exact but for the equivalent strain, which is taken at the centroid.
    fn over(&self, piece: &Piece) -> Cell {
        let (volume, l) = (share(piece) * self.volume, centre(piece));
        Cell {
            volume,
            strain: at(&self.strain, &l).map(|x| volume * x),
            equivalent: volume * (2.0f64 / 3.0).sqrt() * length(&at(&self.plastic, &l)),
        }
    }
}

/// How a piece lies to the excluded discs.
enum Covered {
    No,
    Partly,
    Whole,
}

/// The integrals over the cells of a grid that the prisms are made of.
struct Sums<'a> {
    plate: &'a Plate,
    /// Windows along the two directions of the plane.
    plane: [Windows; 2],
    /// Surfaces of the layers.
    layers: Vec<f64>,
    /// Size of the pieces at the edge of a disc \[mm\].
    finest: f64,
    cells: Vec<Cell>,
}

impl<'a> Sums<'a> {
    fn new(plate: &'a Plate, piece: f64) -> Self {
        let t = plate.thickness();
        let plane = [0, 1].map(|i| {
            let edges: Vec<f64> = plate
                .excluded
                .iter()
                .filter_map(|z| match z {
                    Zone::Rectangle { min, max } => Some([min[i], max[i]]),
                    Zone::Disc { .. } => None,
                })
                .flatten()
                .collect();
            Windows::new(plate.extent[i], t, plate.mirrored[i], &edges)
        });
        let [bottom, top] = plate.extent[2];
        let layers = match plate.mirrored[2] {
            true => vec![bottom, top - 0.25 * t, top],
            false => vec![bottom, bottom + 0.25 * t, top - 0.25 * t, top],
        };
        let number = plane[0].cells() * plane[1].cells() * (layers.len() - 1);
        Self { plate, plane, layers, finest: piece * t, cells: vec![Cell::default(); number] }
    }

    /// False if a tet lies beside the plate.
    fn may_meet(&self, corners: &[V3; 4]) -> bool {
        let c = corners.map(|x| self.plate.coordinates(x));
        (0..3).all(|i| {
            let [low, high] = self.plate.extent[i];
            c.iter().any(|x| x[i] > low) && c.iter().any(|x| x[i] < high)
        })
    }

    fn index(&self, [i, j, k]: [usize; 3]) -> usize {
        (i * self.plane[1].cells() + j) * (self.layers.len() - 1) + k
    }

    /// Middle of a cell in the plane \[mm\].
    fn middle(&self, cell: [usize; 2]) -> [f64; 2] {
        [0, 1].map(|i| 0.5 * (self.plane[i].lines[cell[i]] + self.plane[i].lines[cell[i] + 1]))
    }

    /// Whether an excluded rectangle covers a cell; the edges of rectangles are lines of the grid.
    fn in_rectangle(&self, cell: [usize; 2]) -> bool {
        let x = self.middle(cell);
        self.plate.excluded.iter().any(|z| match z {
            Zone::Rectangle { min, max } => (0..2).all(|i| min[i] < x[i] && x[i] < max[i]),
            Zone::Disc { .. } => false,
        })
    }

    /// Adds a (sub)tet.
    fn add(&mut self, tet: &PlasticPiece) {
        let tet = Linear::new(tet, self.plate);
        let mut parts: Vec<([usize; 3], Piece)> = Vec::new();
        let (u, v, n) = (&self.plane[0].lines, &self.plane[1].lines, &self.layers);
        slice(&WHOLE, tet.coordinate(2), n, &mut |k, layer| {
            slice(layer, tet.coordinate(0), u, &mut |i, strip| {
                slice(strip, tet.coordinate(1), v, &mut |j, part| parts.push(([i, j, k], *part)));
            });
        });
        for (cell, part) in parts {
            if !self.in_rectangle([cell[0], cell[1]]) {
                let index = self.index(cell);
                self.add_outside_discs(&tet, &part, index);
            }
        }
    }

    fn add_outside_discs(&mut self, tet: &Linear, part: &Piece, index: usize) {
        match self.covered(tet, part) {
            Covered::Whole => {}
            Covered::No => self.cells[index].add(&tet.over(part)),
            Covered::Partly => {
                let (longest, halves) = bisect(part, &tet.corners);
                if longest > self.finest {
                    halves.iter().for_each(|half| self.add_outside_discs(tet, half, index));
                } else if !self.in_disc(at(&tet.corners, &centre(part))) {
                    self.cells[index].add(&tet.over(part));
                }
            }
        }
    }

    fn discs(&self) -> impl Iterator<Item = ([f64; 2], f64)> + '_ {
        self.plate.excluded.iter().filter_map(|z| match z {
            Zone::Disc { centre, radius } => Some((*centre, *radius)),
            Zone::Rectangle { .. } => None,
        })
    }

    fn in_disc(&self, x: V3) -> bool {
        self.discs().any(|(c, radius)| (x[0] - c[0]).hypot(x[1] - c[1]) < radius)
    }

    fn covered(&self, tet: &Linear, part: &Piece) -> Covered {
        let corners = part.map(|l| at(&tet.corners, &l));
        let mut partly = false;
        for (c, radius) in self.discs() {
            // distance of the centre from the box around the piece
            let beside = [0, 1].map(|i| {
                let low = corners.iter().fold(f64::INFINITY, |m, x| m.min(x[i]));
                let high = corners.iter().fold(f64::NEG_INFINITY, |m, x| m.max(x[i]));
                (low - c[i]).max(c[i] - high).max(0.0)
            });
            if beside[0].hypot(beside[1]) >= radius {
                continue;
            }
            if corners.iter().all(|x| (x[0] - c[0]).hypot(x[1] - c[1]) <= radius) {
                return Covered::Whole;
            }
            partly = true;
        }
        if partly { Covered::Partly } else { Covered::No }
    }

    /// The largest means of all prisms.
    fn peaks(&self) -> PlateStrain {
        let mut out = PlateStrain::default();
        for a in &self.plane[0].windows {
            for b in &self.plane[1].windows {
                let prism = Prism::new(self, [a, b]);
                if let Some(mean) = prism.mean() {
                    let middle = prism.middle(self.plate.extent[2], self.plate.mirrored[2]);
                    raise(&mut out.membrane, largest_in_plane(&mean), middle);
                    raise(&mut out.tensile, largest(&mean), middle);
                }
                for layer in prism.surfaces() {
                    if let Some(mean) = prism.equivalent(layer) {
                        let ends = [self.layers[layer], self.layers[layer + 1]];
                        raise(&mut out.surface, mean, prism.middle(ends, false));
                    }
                }
            }
        }
        out
    }
}

fn raise(peak: &mut Option<Peak>, value: f64, at: V3) {
    if peak.is_none_or(|p| value.is_nan() || value > p.value) {
        *peak = Some(Peak { value, at });
    }
}

/// Largest principal value.
fn largest(m: &M3) -> f64 {
    let (values, _) = eigen(&symmetric_part(m));
    values.into_iter().fold(f64::NEG_INFINITY, |a, b| if b.is_nan() { b } else { a.max(b) })
}

/// Largest principal value in the plane of the first two coordinates.
fn largest_in_plane(m: &M3) -> f64 {
    0.5 * (m[0][0] + m[1][1]) + (0.5 * (m[0][0] - m[1][1])).hypot(m[0][1])
}

/// A prism through the plate: the cells of two windows, layer by layer.
struct Prism<'a> {
    sums: &'a Sums<'a>,
    windows: [&'a Window; 2],
    /// Integrals over each layer.
    layers: Vec<Cell>,
}

impl<'a> Prism<'a> {
    fn new(sums: &'a Sums<'a>, windows: [&'a Window; 2]) -> Self {
        let number = sums.layers.len() - 1;
        let mut layers = vec![Cell::default(); number];
        for i in windows[0].cells.clone() {
            for j in windows[1].cells.clone() {
                let first = sums.index([i, j, 0]);
                layers.iter_mut().zip(&sums.cells[first..]).for_each(|(sum, cell)| sum.add(cell));
            }
        }
        Self { sums, windows, layers }
    }

    fn span(&self, i: usize) -> [f64; 2] {
        self.sums.plane[i].span(self.windows[i])
    }

    /// Area of its meshed part in the plane \[mm²\].
    fn area(&self) -> f64 {
        [0, 1].map(|i| self.span(i)).iter().map(|[low, high]| high - low).product()
    }

    /// Its middle \[mm\]; `ends` are those along the normal, `mirrored`: the lower one is a plane
    /// of symmetry.
    fn middle(&self, ends: [f64; 2], mirrored: bool) -> V3 {
        let of =
            |[low, high]: [f64; 2], halved: bool| if halved { low } else { 0.5 * (low + high) };
        let plane = [0, 1].map(|i| of(self.span(i), self.windows[i].halved));
        self.sums.plate.point([plane[0], plane[1], of(ends, mirrored)])
    }

    /// Mean strain through the depth, in the coordinates of the plate; `None` if less than half of
    /// the prism is filled.
    fn mean(&self) -> Option<M3> {
        let mut all = Cell::default();
        self.layers.iter().for_each(|layer| all.add(layer));
        let [low, high] = self.sums.plate.extent[2];
        if all.volume < FILLED * self.area() * (high - low) {
            return None;
        }
        let strain = to_matrix(&all.strain.map(|x| x / all.volume));
        let axes = &self.sums.plate.axes;
        let mut mean = axes.map(|a| axes.map(|b| dot(a, mul(&strain, b))));
        let halved = [self.windows[0].halved, self.windows[1].halved, self.sums.plate.mirrored[2]];
        for i in (0..3).filter(|&i| halved[i]) {
            // the mirror image has the opposite shear across the plane of symmetry
            for j in (0..3).filter(|&j| j != i) {
                (mean[i][j], mean[j][i]) = (0.0, 0.0);
            }
        }
        Some(mean)
    }

    /// Numbers of the layers at the surfaces.
    fn surfaces(&self) -> impl Iterator<Item = usize> + use<> {
        let last = self.layers.len() - 1;
        let lower = (!self.sums.plate.mirrored[2]).then_some(0);
        lower.into_iter().chain([last])
    }

    /// Mean equivalent plastic strain of a layer; `None` if less than half of it is filled.
    fn equivalent(&self, layer: usize) -> Option<f64> {
        let Cell { volume, equivalent, .. } = self.layers[layer];
        let depth = self.sums.layers[layer + 1] - self.sums.layers[layer];
        (volume >= FILLED * self.area() * depth).then(|| equivalent / volume)
    }
}

#[cfg(test)]
mod tests;
