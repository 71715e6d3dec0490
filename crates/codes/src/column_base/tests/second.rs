//! A second way to the same values: the effective area by a grid of points, the moment by trial of
//! the equilibrium.

use super::fixture::base;
use crate::column_base::compression::{IBase, under_flange, z_c};
use crate::column_base::effective_area::IArea;
use crate::column_base::moment_resistance;
use crate::column_base::tension_side::tension_side;

/// A sequence of numbers from 0 to 1.
pub(super) struct Numbers(pub u64);

impl Numbers {
    pub fn within(&mut self, low: f64, high: f64) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963);
        low + (high - low) * ((self.0 >> 11) as f64 / (1u64 << 53) as f64)
    }
}

/// Whether a point lies within c of a wall of the section, as a rectangle about each wall.
fn pressed(a: &IArea, x: f64, y: f64) -> bool {
    let [h, b, tw, tf] = a.section;
    let walls = [
        [-0.5 * h, -0.5 * h + tf, 0.5 * b],
        [0.5 * h - tf, 0.5 * h, 0.5 * b],
        [-0.5 * h, 0.5 * h, 0.5 * tw],
    ];
    walls.iter().any(|[low, high, half]| x > low - a.c && x < high + a.c && y.abs() < half + a.c)
}

#[test]
fn effective_areas_are_those_of_a_grid() {
    let mut r = Numbers(7);
    for _ in 0..200 {
        let (h, b) = (r.within(100.0, 600.0), r.within(100.0, 320.0));
        let section = [h, b, r.within(5.0, 20.0), r.within(7.0, 40.0)];
        let c = r.within(10.0, 150.0);
        let (edge, width) = (0.5 * h + r.within(0.0, 150.0), b + r.within(0.0, 300.0));
        let a = IArea { section, edge, width, c };
        let n = 400;
        let step = [2.0 * edge / n as f64, width / n as f64];
        let mut count = 0;
        for i in 0..n {
            for j in 0..n {
                let x = -edge + (i as f64 + 0.5) * step[0];
                let y = -0.5 * width + (j as f64 + 0.5) * step[1];
                count += usize::from(pressed(&a, x, y));
            }
        }
        let grid = count as f64 * step[0] * step[1];
        // half a cell on every side of the rectangles
        let error = 6.0 * (step[0] * width + step[1] * 2.0 * edge) * 0.5;
        assert!((grid - a.area()).abs() <= error, "{grid} is not {}: {a:?}", a.area());
    }
}

/// Whether N and M \[N, N mm\] are in equilibrium with forces of both sides within their strengths:
/// a side is either pulled at its row or pressed under its flange.
fn carries(strengths: [[f64; 2]; 2], places: [[f64; 2]; 2], axial: f64, moment: f64) -> bool {
    let mut found = false;
    for near in 0..2 {
        for far in 0..2 {
            // 0: tension, positive; 1: compression, negative
            let (x, y) = (places[0][near], -places[1][far]);
            let p = (moment - axial * y) / (x - y);
            let q = axial - p;
            let holds = |kind: usize, f: f64, s: [f64; 2]| match kind {
                0 => f >= 0.0 && f <= s[0],
                _ => f <= 0.0 && -f <= s[1],
            };
            found |= holds(near, p, strengths[0]) && holds(far, q, strengths[1]);
        }
    }
    found
}

#[test]
fn moments_are_those_of_equilibrium_by_trial() {
    let mut r = Numbers(11);
    let mut known = 0;
    for _ in 0..200 {
        let mut e = base();
        e.thickness = r.within(12.0, 40.0);
        e.rows = vec![-r.within(125.0, 150.0), r.within(125.0, 150.0)];
        e.offset = r.within(-10.0, 10.0);
        e.elastic_length = r.within(60.0, 500.0);
        let axial = r.within(-900e3, 200e3);
        let i = IBase::of(&e).expect("an I section");
        let [up, down] = [1.0, -1.0].map(|side| {
            let row = tension_side(&i, side).expect("a row");
            let pressed = under_flange(&i, side, 0.0).expect("class 1 to 3").value;
            ([row.resistance.value, pressed], [row.z, z_c(&i)])
        });
        let (strengths, places) = ([up.0, down.0], [up.1, down.1]);
        let Some(most) = moment_resistance(&e, axial, 1.0) else {
            let any = (0..2000).any(|i| carries(strengths, places, axial, 2e5 * f64::from(i)));
            assert!(!any, "N = {axial}");
            continue;
        };
        known += 1;
        assert!(carries(strengths, places, axial, most * (1.0 - 1e-9)), "{most} at {axial}");
        assert!(
            !carries(strengths, places, axial, most * (1.0 + 1e-9) + 1e-3),
            "{most} at {axial}"
        );
    }
    assert!(known > 100, "{known}");
}
