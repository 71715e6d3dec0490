//! A13, A17: the elastic hollow sphere and thick cylinder under internal pressure.
//!
//! ```text
//!      b = 2a     sphere: octant, symmetry planes x = y = z = 0
//!    .-''-.       cylinder: quarter, symmetry planes x = y = 0, ends held along z (plane strain)
//!   (  ()  )  p in the bore
//!    '-..-'
//! ```
//! Source: G. Lamé, Leçons sur la théorie mathématique de l'élasticité des corps solides (1852); S.
//! P. Timoshenko, J. N. Goodier, Theory of Elasticity, 3rd ed., articles 28 (cylinder) and 136
//! (sphere). With ν = 0.3, b/a = 2: sphere u_a = 0.8 p a/E, cylinder u_a = 1.906667 p a/E; energy
//! −½ p u_a × (bore area).
//!
//! The body of the mesh is facetted. Its facets are moved outward until its two surfaces enclose
//! the volumes of the smooth ones: the energy density is uniform on each surface, so the energy
//! changes with these volumes only, to first order in the depth of the facets. The remaining error
//! is of second order, 1/N⁴ with N segments per quarter.
//!
//! Tolerance: none. The closed form lies in the strict bracket of the facetted body. The brackets
//! of bodies with N/2 and N segments on the same mesh differ by less than 1 %.

use crate::common::prism::{Prism, facetted_direction, radius_of_equal_volume};
use crate::common::solved::solve;
use crate::common::{Block, mapped};
use std::f64::consts::PI;

const P: f64 = 100.0;
const E: f64 = 210_000.0;
const A: f64 = 10.0;

/// Compares the brackets of the bodies with N/2 and N segments. `width` limits the width of the
/// second one: the measured value with a small margin.
fn check(name: &str, coarse: [f64; 2], fine: [f64; 2], exact: f64, width: f64) {
    let middle = |b: [f64; 2]| 0.5 * (b[0] + b[1]);
    let facets = (middle(coarse) / middle(fine) - 1.0).abs();
    println!(
        "{name}: exact {exact:.8e}, bracket {:+.2e} {:+.2e} (relative), facets {facets:.2e}",
        fine[0] / exact - 1.0,
        fine[1] / exact - 1.0
    );
    assert!(fine[0] <= exact && exact <= fine[1], "{name}: {exact} outside {fine:?}");
    assert!(facets < 0.01, "{name}: the facets change the energy by {facets}");
    assert!((fine[1] - fine[0]) / exact.abs() < width, "{name}: {fine:?}");
}

/// Radii from a to 2a with equal ratios.
fn radius(t: f64) -> f64 {
    A * 2f64.powf(t)
}

/// Point at fraction `s` on the polygon of the unit circle with `n` segments per quarter.
fn on_polygon(s: f64, n: usize) -> [f64; 2] {
    let k = ((s * n as f64 + 1e-9).floor() as usize).min(n - 1);
    let f = s * n as f64 - k as f64;
    let at = |i: usize| {
        let angle = 0.5 * PI * i as f64 / n as f64;
        // the ends lie exactly on the axes, so that symmetry planes are planes
        [if i == n { 0.0 } else { angle.cos() }, if i == 0 { 0.0 } else { angle.sin() }]
    };
    std::array::from_fn(|d| (1.0 - f) * at(k)[d] + f * at(k + 1)[d])
}

#[test]
fn a17_thick_cylinder() {
    let (segments, length) = (12, 2.0);
    let run = |facets: usize| {
        let block =
            Block::new([6, segments, 1], [1.0, 1.0, length]).mesh(&["B"], |_| 0, |_, _| false);
        // the polygon has the area of the circle
        let step = 0.5 * PI / facets as f64;
        let scale = (step / step.sin()).sqrt();
        let mesh = mapped(block, |x| {
            let c = on_polygon(x[1], facets).map(|c| scale * c);
            [radius(x[0]) * c[0], radius(x[0]) * c[1], x[2]]
        });
        let yaml = format!(
            "materials: {{s: {{E: {E:?}, nu: 0.3}}}}\nbodies: {{B: s}}\nsupports:\n- {{face: Y0, \
             fix: [y]}}\n- {{face: Y1, fix: [x]}}\n- {{face: Z0, fix: [z]}}\n- {{face: Z1, fix: \
             [z]}}\nloads:\n- {{face: X0, pressure: {P:?}}}\n"
        );
        solve(&yaml, mesh).strict(&format!("A17 {facets} facets"))
    };
    let u = 1.906_666_666_666_667 * P * A / E;
    check("A17", run(segments / 2), run(segments), -0.5 * P * u * 0.5 * PI * A * length, 0.002);
}

#[test]
fn a13_hollow_sphere() {
    let segments = 10;
    let run = |facets: usize| {
        let scale = radius_of_equal_volume(facets);
        let mesh = Prism { n: segments, layers: 5 }
            .mesh(|l, t| facetted_direction(l, facets).map(|c| scale * radius(t) * c));
        let yaml = format!(
            "materials: {{s: {{E: {E:?}, nu: 0.3}}}}\nbodies: {{B: s}}\nsupports:\n- {{face: S0, \
             fix: [x]}}\n- {{face: S1, fix: [y]}}\n- {{face: S2, fix: [z]}}\nloads:\n- {{face: \
             BOTTOM, pressure: {P:?}}}\n"
        );
        solve(&yaml, mesh).strict(&format!("A13 {facets} facets"))
    };
    let u = 0.8 * P * A / E;
    check("A13", run(segments / 2), run(segments), -0.5 * P * u * 4.0 * PI * A * A / 8.0, 0.005);
}
