//! A11: the hollow sphere under internal pressure, partly plastic.
//!
//! ```text
//!      b = 2a     octant, symmetry planes x = y = z = 0
//!    .-''-.
//!   (  ()  )  p in the bore; plastic from a to c
//!    '-..-'
//! ```
//! Source: R. Hill, The Mathematical Theory of Plasticity (1950), chapter V.2: first yield at p = ⅔
//! s0 (1 − a³/b³) = 0.583333 s0; plastic to c at p = 2 s0 ln(c/a) + ⅔ s0 (1 − c³/b³), for c = 1.5a
//! 1.196347 s0, where the bore moves by 1.88396 s0 a/E (ν = 0.3). The load is proportional and
//! nothing unloads, so Hencky's material is the one of flow; −Π is the integral of 4πa² u_a(p) dp.
//!
//! The body of the mesh is facetted. Its two surfaces enclose the volumes of the spheres. To first
//! order in the depth of the facets, its energy is that of the sphere. In the case of Lamé's
//! cylinder and sphere, facets with as many segments change the elastic energy by less than 1 %.
//!
//! Tolerance: none. The closed form lies in the strict bracket of the facetted body.

use crate::common::plastic::{plastic_model, strict};
use crate::common::prism::{Prism, facetted_direction, radius_of_equal_volume};
use crate::common::yielding::{E, FY, NU};
use std::f64::consts::PI;

const A: f64 = 10.0;

/// Radial displacement of the bore at a plastic radius c, over s0 a/E. The change of volume is
/// elastic everywhere.
fn bore(c: f64) -> f64 {
    let b = 2.0;
    // u(r) = s0 [ (1 − ν) c³/r² − ⅔ (1 − 2ν) r (3 ln(c/r) + 1 − c³/b³) ] / E for a ≤ r ≤ c, at r =
    // a = 1
    (1.0 - NU) * c.powi(3)
        - 2.0 / 3.0 * (1.0 - 2.0 * NU) * (3.0 * c.ln() + 1.0 - c.powi(3) / (b * b * b))
}

fn pressure(c: f64) -> f64 {
    2.0 * c.ln() + 2.0 / 3.0 * (1.0 - c.powi(3) / 8.0)
}

/// −Π over 4πa³ s0²/E at plastic radius c: ∫ u dp by Simpson's rule, starting at first yield.
fn energy(c: f64) -> f64 {
    let n = 2000;
    let elastic = 0.5 * bore(1.0) * pressure(1.0);
    let at = |i: usize| 1.0 + (c - 1.0) * i as f64 / n as f64;
    let term = |i: usize| {
        let weight = if i == 0 || i == n { 1.0 } else { [2.0, 4.0][i % 2] };
        // dp/dc = 2/c − c²/4
        weight * bore(at(i)) * (2.0 / at(i) - at(i) * at(i) / 4.0)
    };
    elastic + (c - 1.0) / (3.0 * n as f64) * (0..=n).map(term).sum::<f64>()
}

fn radius(t: f64) -> f64 {
    A * 2f64.powf(t)
}

fn bracket(p: f64) -> [f64; 2] {
    let (segments, layers) = (8, 5);
    let scale = radius_of_equal_volume(segments);
    let mesh = Prism { n: segments, layers }
        .mesh(|l, t| facetted_direction(l, segments).map(|c| scale * radius(t) * c));
    let m = plastic_model(
        &format!(
            "bodies: {{B: s}}\nsupports:\n- {{face: S0, fix: [x]}}\n- {{face: S1, fix: [y]}}\n- \
             {{face: S2, fix: [z]}}\nloads:\n- {{face: BOTTOM, pressure: {:?}}}\n",
            p * FY
        ),
        mesh,
    );
    strict(&format!("A11 p = {p:.4} s0"), &m)
}

#[test]
fn a11_hollow_sphere() {
    assert!((pressure(1.0) - 0.583_333).abs() < 1e-6 && (pressure(1.5) - 1.196_347).abs() < 1e-6);
    assert!(
        (bore(1.5) - 1.883_96).abs() < 1e-5 && (energy(1.5) - 0.723_19).abs() < 1e-5,
        "{}",
        energy(1.5)
    );
    let unit = 4.0 * PI * A.powi(3) * FY * FY / E / 8.0;
    for (c, width) in [(1.0, 0.012), (1.5, 0.07)] {
        let exact = -energy(c) * unit;
        let [low, up] = bracket(pressure(c));
        println!(
            "A11, c = {c} a: exact {exact:.6e}, bracket {:+.2e} {:+.2e} (relative)",
            low / exact - 1.0,
            up / exact - 1.0
        );
        assert!(low <= exact && exact <= up, "c = {c} a: {exact} outside [{low}, {up}]");
        assert!((up - low) / exact.abs() < width, "c = {c} a: [{low}, {up}]");
    }
}
