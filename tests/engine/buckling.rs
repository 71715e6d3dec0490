//! Linear buckling against closed forms: plates and a column under exact stress fields.
//!
//! The stress is written down, not computed, and the displacements are zero: only the eigenvalue
//! problem is on trial. `σ_cr = k σ_E`, `σ_E = π² E / 12(1 − ν²) (t/b)²`. Simply supported faces
//! hold what Kirchhoff's plate holds there, the deflection and the displacement along the edge, and
//! leave the displacement across the edge to the rotation of the section. Shear, which Kirchhoff's
//! plate does not have, lowers k by up to 0.5 % at these thicknesses, 1/50 to 1/80 of the width.
//!
//! Source: S. P. Timoshenko, J. M. Gere, Theory of Elastic Stability, 2nd ed., chapters 2 and 9;
//! EN 1993-1-5, Annex A.1.

mod joined;

use crate::common::Block;
use crate::common::solved::resolve;
use bracket::certify::fields::{DisplacementField, StressField};
use bracket::elements::space::Tet10Space;
use bracket::elements::super_element::SuperElement;
use bracket::estimate::buckling::{Buckling, BucklingOptions, buckling, conservative};
use bracket::model::AnalysisModel;
use std::f64::consts::PI;
use std::time::Instant;

const E: f64 = 210_000.0;
const NU: f64 = 0.3;

/// Mandel form of a stress in the plane of a plate.
fn plane(xx: f64, yy: f64, xy: f64) -> [f64; 6] {
    [xx, yy, 0.0, 0.0, 0.0, std::f64::consts::SQRT_2 * xy]
}

/// The stress field with the given values.
fn field(model: &AnalysisModel, stress: impl Fn([f64; 3]) -> [f64; 6]) -> StressField {
    let points = |e: usize| SuperElement::points(&model.mesh.corners(e)).map(|t| t.map(&stress));
    StressField { points: (0..model.mesh.tets.len()).map(points).collect() }
}

fn zero(model: &AnalysisModel) -> DisplacementField {
    DisplacementField { u: vec![[0.0; 3]; Tet10Space::new(&model.mesh).nodes.len()] }
}

/// A rectangular plate 0 ≤ x ≤ a, 0 ≤ y ≤ b.
struct Plate {
    a: f64,
    b: f64,
    t: f64,
    nu: f64,
    /// Lines `- {face: …, fix: …}`.
    supports: &'static str,
}

impl Plate {
    fn model(&self, cells: [usize; 3]) -> AnalysisModel {
        let mut block = Block::new(cells, [self.a, self.b, 0.5 * self.t]);
        block.min = [0.0, 0.0, -0.5 * self.t];
        let mesh = block.mesh(&["P"], |_| 0, |_, _| false);
        let yaml = format!(
            "materials: {{s: {{E: {E:?}, nu: {:?}}}}}\nbodies: {{P: s}}\nsupports:\n{}loads: []\n",
            self.nu, self.supports
        );
        resolve(&yaml, mesh).expect("a sound model")
    }

    fn buckled(&self, cells: [usize; 3], stress: impl Fn([f64; 3]) -> [f64; 6]) -> Buckling {
        let model = self.model(cells);
        let start = Instant::now();
        let found =
            buckling(&model, &zero(&model), &field(&model, stress), &OPTIONS).expect("an answer");
        println!(
            "  {cells:?}: factors {:?}, residual {:.1e}, {} steps, {:.2} s",
            found.modes.iter().map(|m| m.factor).collect::<Vec<_>>(),
            found.modes[0].residual,
            found.steps,
            start.elapsed().as_secs_f64()
        );
        found
    }

    /// `π² E / 12(1 − ν²) (t/b)²` \[MPa\].
    fn euler(&self) -> f64 {
        PI * PI * E / (12.0 * (1.0 - self.nu * self.nu)) * (self.t / self.b).powi(2)
    }
}

const OPTIONS: BucklingOptions = BucklingOptions { modes: 2, largest: 1e4, tolerance: 1e-6 };

/// Richardson's value of two meshes, errors of order 2.
fn extrapolated(coarse: f64, fine: f64, ratio: f64) -> f64 {
    conservative(coarse, fine, ratio) / 0.95
}

/// Compares k, extrapolated from two meshes, the second twice as fine, with the closed form to 1 %.
fn holds(
    name: &str,
    plate: &Plate,
    cells: [usize; 3],
    stress: impl Fn([f64; 3]) -> [f64; 6],
    exact: f64,
) {
    let twice = [2 * cells[0], 2 * cells[1], cells[2]];
    let k = [cells, twice].map(|c| plate.buckled(c, &stress).modes[0].factor / plate.euler());
    let limit = extrapolated(k[0], k[1], 2.0);
    let percent = |x: f64| 100.0 * (x / exact - 1.0);
    println!(
        "{name}: k = {:.5}, {:.5}, extrapolated {limit:.5}, exact {exact:.5}: {:+.2} %, {:+.2} %, \
         {:+.2} %",
        k[0],
        k[1],
        percent(k[0]),
        percent(k[1]),
        percent(limit)
    );
    assert!(percent(limit).abs() < 1.0, "{name}: {k:?} {limit} {exact}");
}

/// The root of a function in an interval on which it changes its sign once.
fn root(f: impl Fn(f64) -> f64, mut low: f64, mut high: f64) -> f64 {
    let sign = f(low).signum();
    for _ in 0..100 {
        let middle = 0.5 * (low + high);
        if f(middle).signum() == sign { low = middle } else { high = middle }
    }
    0.5 * (low + high)
}

/// Unit compression along x.
fn pressed(_: [f64; 3]) -> [f64; 6] {
    plane(-1.0, 0.0, 0.0)
}

#[test]
fn simply_supported_on_four_edges() {
    // a quarter of a square plate
    let supports = "- {face: X0, fix: [x]}\n- {face: Y0, fix: [y]}\n- {face: X1, fix: [y, \
                    z]}\n- {face: Y1, fix: [x, z]}\n";
    let plate = Plate { a: 50.0, b: 50.0, t: 2.0, nu: NU, supports };
    let of_whole = Plate { b: 100.0, ..plate };
    let scale = plate.euler() / of_whole.euler();
    let quarter = |x: [f64; 3]| pressed(x).map(|s| s / scale);
    holds("four edges", &plate, [8, 8, 1], quarter, 4.0);
}

/// k of a plate simply supported on the loaded edges, the edge y = 0 and y = b held as `condition`
/// says, with one half-wave along x: `condition(p, q, s)` vanishes there, with `s = π/a` and
/// `w = f(y) sin(π x/a)`, f of `cosh py, sinh py, cos qy, sin qy` (Timoshenko, article 9.4).
fn strip(a: f64, b: f64, condition: impl Fn(f64, f64, f64) -> f64, low: f64, high: f64) -> f64 {
    let s = PI / a;
    // N = k π² D / b²
    let at = |k: f64| {
        let r = (k * PI * PI / (b * b)).sqrt() * s;
        condition((r + s * s).sqrt(), (r - s * s).sqrt(), s)
    };
    root(at, low, high)
}

#[test]
fn clamped_along_the_edges() {
    // half of one half-wave; the other half of the width by symmetry
    let supports = "- {face: X0, fix: [x]}\n- {face: X1, fix: [y, z]}\n- {face: Y0, fix: \
                    [y]}\n- {face: Y1, fix: [x, y, z]}\n";
    let half = Plate { a: 33.0, b: 50.0, t: 2.0, nu: NU, supports };
    let condition =
        |p: f64, q: f64, _: f64| p * (p * 50.0).tanh() * (q * 50.0).cos() + q * (q * 50.0).sin();
    let exact = strip(66.0, 100.0, condition, 5.0, 9.0);
    assert!((exact - 6.97).abs() < 0.01, "{exact}");
    // σ_E of the whole width
    holds("clamped edges", &half, [6, 9, 1], |x| pressed(x).map(|s| s / 4.0), exact);
}

#[test]
fn one_edge_free() {
    let supports = "- {face: X0, fix: [x]}\n- {face: X1, fix: [y, z]}\n- {face: Y0, fix: [x, z]}\n";
    let (a, b) = (200.0, 100.0);
    let half = Plate { a: 0.5 * a, b, t: 2.0, nu: NU, supports };
    let condition = |p: f64, q: f64, s: f64| {
        let (of_p, of_q) = (p * p - NU * s * s, q * q + NU * s * s);
        q * of_p * of_p * (p * b).tanh() * (q * b).cos() - p * of_q * of_q * (q * b).sin()
    };
    let exact = strip(a, b, condition, 0.5, 1.0);
    // the usual approximation
    assert!((exact / (0.425 + (b / a).powi(2)) - 1.0).abs() < 0.02, "{exact}");
    holds("one edge free", &half, [10, 10, 1], pressed, exact);
}

#[test]
fn bent_in_its_plane() {
    // 23.9 in EN 1993-1-5, table 4.1, for half-waves of 2/3 of the width; 23.88 by a series of 16
    // terms
    let supports = "- {face: X0, fix: [x]}\n- {face: X1, fix: [y, z]}\n- {face: Y0, fix: [x, \
                    z]}\n- {face: Y1, fix: [x, z]}\n";
    let half = Plate { a: 100.0 / 3.0, b: 100.0, t: 1.5, nu: NU, supports };
    let bent = |x: [f64; 3]| plane(-1.0 + 2.0 * x[1] / 100.0, 0.0, 0.0);
    holds("bent", &half, [6, 18, 1], bent, 23.88);
}

#[test]
fn sheared() {
    let supports = "- {face: X0, fix: [y, z]}\n- {face: X1, fix: [y, z]}\n- {face: Y0, fix: [x, \
                    z]}\n- {face: Y1, fix: [x, z]}\n";
    let plate = Plate { a: 100.0, b: 100.0, t: 1.25, nu: NU, supports };
    // 5.34 + 4 = 9.34 in EN 1993-1-5, A.3; 9.325 by the series of Timoshenko, article 9.7, with 196
    // terms
    holds("sheared", &plate, [16, 16, 1], |_| plane(0.0, 0.0, 1.0), 9.325);
    // sheared the other way, along the diagonals of the mesh, it is stiffer, but not on a fine one
    let [one, other] =
        [1.0, -1.0].map(|s| plate.buckled([24, 24, 1], |_| plane(0.0, 0.0, s)).modes[0].factor);
    assert!((one / other - 1.0).abs() < 0.02, "{one} {other}");
}

#[test]
fn column() {
    // half of a column with pinned ends, without Poisson's effect
    let supports = "- {face: X0, fix: [x]}\n- {face: X1, fix: [z]}\n- {face: Y0, fix: \
                    [y]}\n- {face: Y1, fix: [y]}\n";
    let half = Plate { a: 100.0, b: 10.0, t: 5.0, nu: 0.0, supports };
    // Engesser: 1/N = 1/N_E + 1/κGA
    let euler = PI * PI * E * 25.0 / (12.0 * 200.0f64.powi(2));
    let shear = 5.0 / 6.0 * E / 2.0;
    let exact = 1.0 / (1.0 / euler + 1.0 / shear);
    holds("column", &half, [10, 1, 1], pressed, exact / half.euler());
}

#[test]
fn modes_are_normalised_and_repeat() {
    let supports = "- {face: X0, fix: [y, z]}\n- {face: X1, fix: [y, z]}\n- {face: Y0, fix: [x, \
                    z]}\n- {face: Y1, fix: [x, z]}\n";
    let plate = Plate { a: 100.0, b: 100.0, t: 3.0, nu: NU, supports };
    let found = plate.buckled([4, 4, 1], pressed);
    assert!(found.complete && found.modes.len() == 2);
    assert_eq!((found.contact_faces, found.held_motions), (0, 0));
    for mode in &found.modes {
        let longest = mode.shape.iter().map(|u| u[0].hypot(u[1]).hypot(u[2])).fold(0.0, f64::max);
        assert!((longest - 1.0).abs() < 1e-12 && mode.residual < 1e-5);
        assert!((mode.share_by_body[0] - 1.0).abs() < 1e-12);
    }
    assert_eq!(found, plate.buckled([4, 4, 1], pressed));
    // equal pressure on all sides: two modes with equal factors, twice as many stresses
    let biaxial = plate.buckled([4, 4, 1], |_| plane(-1.0, -1.0, 0.0));
    assert!((found.modes[0].factor / biaxial.modes[0].factor - 2.0).abs() < 0.05);
}

#[test]
fn nothing_pressed_does_not_buckle() {
    let supports = "- {face: X0, fix: [x, y, z]}\n";
    let plate = Plate { a: 100.0, b: 30.0, t: 3.0, nu: NU, supports };
    let model = plate.model([4, 2, 1]);
    for stress in [plane(0.0, 0.0, 0.0), plane(10.0, 0.0, 0.0), plane(-1e-9, 0.0, 0.0)] {
        let stress = field(&model, |_| stress);
        let found = buckling(&model, &zero(&model), &stress, &OPTIONS).expect("an answer");
        assert!(found.complete && found.modes.is_empty(), "{found:?}");
    }
    let wrong = buckling(&model, &DisplacementField::default(), &field(&model, pressed), &OPTIONS);
    assert!(wrong.is_err());
}
