//! A prism through a plate, over which strains are averaged.

use super::sums::{Cell, Sums};
use crate::estimate::windows::Window;
use bracket_base::math::mandel::to_matrix;
use bracket_base::math::vec3::{M3, V3, dot, mul};

/// Least share of a prism that the plate must fill, the excluded zones left out; prisms with less
/// do not count. Half of it, less rounding.
const FILLED: f64 = 0.5 - 1e-6;

/// A prism through the plate: the cells of two windows, layer by layer.
pub(super) struct Prism<'a> {
    sums: &'a Sums<'a>,
    windows: [&'a Window; 2],
    /// Integrals over each layer.
    layers: Vec<Cell>,
}

impl<'a> Prism<'a> {
    /// The prism of two windows.
    pub fn new(sums: &'a Sums<'a>, windows: [&'a Window; 2]) -> Self {
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

    /// Ends of its meshed part along a direction of the plane \[mm\].
    pub fn span(&self, i: usize) -> [f64; 2] {
        self.sums.plane[i].span(self.windows[i])
    }

    /// Area of its meshed part in the plane \[mm²\].
    fn area(&self) -> f64 {
        [0, 1].map(|i| self.span(i)).iter().map(|[low, high]| high - low).product()
    }

    /// Its middle \[mm\]; `ends` are those along the normal, `mirrored`: the lower one is a plane
    /// of symmetry.
    pub fn middle(&self, ends: [f64; 2], mirrored: bool) -> V3 {
        let of =
            |[low, high]: [f64; 2], halved: bool| if halved { low } else { 0.5 * (low + high) };
        let plane = [0, 1].map(|i| of(self.span(i), self.windows[i].halved));
        self.sums.plate.point([plane[0], plane[1], of(ends, mirrored)])
    }

    /// Mean strain through the depth, in the coordinates of the plate; `None` if less than half of
    /// the prism is filled.
    pub fn mean(&self) -> Option<M3> {
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
    pub fn surfaces(&self) -> impl Iterator<Item = usize> + use<> {
        let last = self.layers.len() - 1;
        let lower = (!self.sums.plate.mirrored[2]).then_some(0);
        lower.into_iter().chain([last])
    }

    /// Mean equivalent plastic strain of a layer; `None` if less than half of it is filled.
    pub fn equivalent(&self, layer: usize) -> Option<f64> {
        let Cell { volume, equivalent, .. } = self.layers[layer];
        let depth = self.sums.layers[layer + 1] - self.sums.layers[layer];
        (volume >= FILLED * self.area() * depth).then(|| equivalent / volume)
    }
}
