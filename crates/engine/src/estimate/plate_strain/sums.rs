//! Integrals of strains over the cells of a grid on a plate.

use crate::certify::plastic_field::{PlasticPiece, length};
use crate::elements::tet10::vertex_strains;
use crate::estimate::plate::{Plate, Zone};
use crate::estimate::tet_slices::{Piece, WHOLE, at, bisect, centre, share, slice};
use crate::estimate::windows::Windows;
use bracket_base::math::mandel::Mandel;
use bracket_base::math::vec3::V3;

/// Integrals over a cell of the grid.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Cell {
    pub volume: f64,
    pub strain: Mandel,
    pub equivalent: f64,
}

impl Cell {
    pub fn add(&mut self, other: &Self) {
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
pub(super) struct Sums<'a> {
    pub plate: &'a Plate,
    /// Windows along the two directions of the plane.
    pub plane: [Windows; 2],
    /// Surfaces of the layers.
    pub layers: Vec<f64>,
    /// Size of the pieces at the edge of a disc \[mm\].
    finest: f64,
    pub cells: Vec<Cell>,
}

impl<'a> Sums<'a> {
    /// Without a tet; `piece`: size of the pieces at the edge of a disc over the thickness.
    pub fn new(plate: &'a Plate, piece: f64) -> Self {
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
    pub fn may_meet(&self, corners: &[V3; 4]) -> bool {
        let c = corners.map(|x| self.plate.coordinates(x));
        (0..3).all(|i| {
            let [low, high] = self.plate.extent[i];
            c.iter().any(|x| x[i] > low) && c.iter().any(|x| x[i] < high)
        })
    }

    pub fn index(&self, [i, j, k]: [usize; 3]) -> usize {
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
    pub fn add(&mut self, tet: &PlasticPiece) {
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
}
