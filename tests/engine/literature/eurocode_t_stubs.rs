//! B15: strip T-stubs as solids against the beam model of EN 1993-1-8, three modes.
//!
//! ```text
//!             ↑ F
//!           | |
//!   [head]  | |  [head]        a quarter: symmetry planes x = 0 (web) and y = 0; the flange rests
//!  +-[  ]---+ +---[  ]-+       on rigid ground without friction (the plane between two such
//!  |_[  ]_________[  ]_|  t    T-stubs), bolts pass through holes as wide as they are and are held
//!  ~~~~~~~~~~~~~~~~~~~~~       at their feet
//!   n  |  m |   |
//! ```
//! Source: EN 1993-1-8:2005, 6.2.4, table 6.2. Gauge 100, web 10, no fillet, width 160, length 100,
//! m = 45, n = 30, f_y = 235, 100 kN per bolt: 75.2 (mode 1, t = 12), 177.9 (mode 2, t = 25) and
//! 200 kN (mode 3, t = 40).
//!
//! Tolerance: solids carry 1.00 to 1.35 times the beam model in modes 1 and 2, for two reasons: a
//! wide flange cannot contract sideways (up to 2/√3), and a head supports the flange nearer to the
//! web than the axis of the bolt (table 6.2, method 2). In mode 3 they carry the same as the beam
//! model, because the shanks yield in pure tension. The bracket must overlap that range. It must
//! also be as narrow as measured on this mesh, with a small margin.

use crate::common::grid::{Grid, even, joined, name};
use crate::common::solved;
use crate::common::t_stub::forces;
use crate::common::yielding::FY;
use bracket::model::AnalysisModel;

/// B15: gauge 100, web 10, no fillet, width 160, length 100, m = 45, n = 30, f_y = 235; square
/// bolts of 12 mm with a strength of 100 kN and heads of 24 mm.
///
/// `n` cells across the flange from web to head and from head to tip, `layers` through its
/// thickness.
fn strip_t_stub(t: f64, n: usize, layers: usize) -> AnalysisModel {
    let x = joined(&[
        even(0.0, 5.0, 1),
        even(5.0, 38.0, n),
        even(38.0, 44.0, 1),
        even(44.0, 56.0, 2),
        even(56.0, 62.0, 1),
        even(62.0, 80.0, n.div_ceil(2)),
    ]);
    let y = joined(&[even(0.0, 6.0, 1), even(6.0, 12.0, 1), even(12.0, 50.0, n)]);
    let z = joined(&[even(0.0, t, layers), even(t, t + 12.0, 1), even(t + 12.0, t + 24.0, 1)]);
    let grid = Grid::new([x, y, z]).jittered(0.1, 5);
    let body = |c: [f64; 3]| {
        let off = (c[0] - 50.0).abs().max(c[1]);
        match () {
            () if off < 6.0 && c[2] < t + 12.0 => Some(1),
            () if c[2] < t => Some(0),
            () if off < 12.0 && c[2] < t + 12.0 => Some(1),
            () if c[0] < 5.0 => Some(0),
            () => None,
        }
    };
    let mut mesh =
        grid.mesh(&["T", "BOLT"], body, |axis, c| axis == 2 && (c - 0.5 * t).abs() < 1e-9);
    name(&mut mesh, "X0", "T", |p| p[0] == 0.0);
    name(&mut mesh, "Y0", "T", |p| p[1] == 0.0);
    name(&mut mesh, "YB", "BOLT", |p| p[1] == 0.0);
    name(&mut mesh, "GROUND", "T", |p| p[2] == 0.0);
    name(&mut mesh, "FOOT", "BOLT", |p| p[2] == 0.0);
    name(&mut mesh, "TOP", "T", |p| (p[2] - t - 24.0).abs() < 1e-9);
    let yaml = format!(
        "materials: {{s: {{E: 210000, nu: 0.3, fy: 235}}, b: {{E: 210000, nu: 0.3, fy: \
         {:?}}}}}\nbodies: {{T: s, BOLT: b}}\ninterfaces:\n- {{between: [T, BOLT], law: contact, \
         mu: 0}}\nsupports:\n- {{face: X0, fix: [x]}}\n- {{face: Y0, fix: [y]}}\n- {{face: YB, \
         fix: [y]}}\n- {{face: GROUND, law: contact, mu: 0}}\n- {{face: FOOT, fix: \
         [z]}}\nloads:\n- {{face: TOP, traction: [0, 0, 1]}}\n",
        100e3 / 144.0
    );
    solved::resolve(&yaml, mesh).unwrap_or_else(|e| panic!("{e:?}"))
}

/// The force \[kN\] of the beam model in each mode for B15.
fn modes(t: f64) -> [f64; 3] {
    let (length, m, n, bolts) = (100.0, 45.0, 30.0, 200.0);
    let plastic = 0.25 * length * t * t * FY * 1e-3;
    [4.0 * plastic / m, (2.0 * plastic + n * bolts) / (m + n), bolts]
}

/// The force in the mode that governs at flange thickness `t`. The bracket is at most `width` wide.
///
/// The loads have the order of the modes. The test does not distinguish the mechanisms: at t = 25
/// the bolts dissipate all the work, as in mode 3. At t = 12 the effects named above bring mode 1
/// (up to 99 kN) near mode 2 (102.6), so the mechanism may be either.
fn mode(number: usize, t: f64, model: &AnalysisModel, width: f64) -> [f64; 2] {
    let beam = modes(t)[number - 1];
    assert!(modes(t).iter().all(|f| *f >= beam), "mode {number} governs at t = {t}");
    // unit traction on 10 × 100
    let ([low, up], bolts) = forces(&format!("B15, t = {t}"), model, 1000.0);
    println!(
        "B15, t = {t}: {:.3} … {:.3} times the beam model's {beam:.1} kN",
        low / beam,
        up / beam
    );
    assert!(up / low - 1.0 < width, "t = {t}: [{low}, {up}]");
    if number < 3 {
        assert!(low <= 1.35 * beam && up >= beam, "[{low}, {up}] against {beam}");
    } else {
        assert!(
            (low / beam - 1.0).abs() < 0.02 && (up / beam - 1.0).abs() < 0.02,
            "[{low}, {up}] against {beam}"
        );
        assert!(bolts > 0.9, "bolts alone yield in mode 3: {bolts}");
    }
    [low, up]
}

fn three_modes(n: usize, layers: usize, widths: [f64; 3]) {
    let [one, two, three] = [12.0, 25.0, 40.0].map(|t| (t, strip_t_stub(t, n, layers)));
    let one = mode(1, one.0, &one.1, widths[0]);
    let two = mode(2, two.0, &two.1, widths[1]);
    let three = mode(3, three.0, &three.1, widths[2]);
    assert!(
        one[1] < two[0] && two[0] < three[0] && two[1] < 1.01 * three[1],
        "{one:?} {two:?} {three:?}"
    );
}

/// Measured widths: 49.7, 11.9 and 0.64 %.
#[test]
fn strip_t_stubs_fail_in_three_modes() {
    three_modes(2, 2, [0.55, 0.13, 0.01]);
}

/// Measured widths: 31.0, 6.7 and 0.57 %.
#[test]
#[ignore = "heavy: minutes"]
fn strip_t_stubs_fail_in_three_modes_fine() {
    three_modes(4, 4, [0.34, 0.075, 0.008]);
}
