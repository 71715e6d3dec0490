//! A bar of rectangular section under axial force and bending moment. Its limit loads lie on
//! `|m| + n² = 1`, between the inner and the outer hull from the bounds of a few directions.
//!
//! ```text
//!   u_x = 0 |========================| → N, ↻ M     m = M / (f_y b h²/4), n = N / (f_y b h)
//! ```
//!
//! Both ends may contract. Every cross-section is in the same uniaxial stress, and the fibre model
//! of the textbooks is exact.

use crate::common::Block;
use crate::common::yielding::{FY, model};
use bracket::analysis::event::silent;
use bracket::analysis::limit;
use bracket::analysis::limit::LimitPass;
use bracket::analysis::pass::PassOptions;
use bracket::certify::half_space::{Axes, HalfSpace, live_actions};
use bracket::math::convex::HalfPlane;
use bracket::model::AnalysisModel;
use bracket::result::demand::ActionValue;
use bracket::result::polygon::{Axis, CapacityPolygon, Point};
use bracket::solve::{Patterns, SolveOptions};
use bracket::spec::polygon::PolygonSpec;

const SIDES: [f64; 3] = [40.0, 10.0, 20.0];
/// Axial force and moment at full yield of the section \[N, N mm\].
const N: f64 = FY * SIDES[1] * SIDES[2];
const M: f64 = FY * SIDES[1] * SIDES[2] * SIDES[2] / 4.0;

/// The bar under a direction of moment and force, in units of their plastic values.
fn bar([m, n]: [f64; 2]) -> AnalysisModel {
    let flat = |axis: usize, z: f64| axis == 2 && (z / 2.5).fract() == 0.0;
    let mesh = Block::new([4, 1, 8], SIDES).jittered(3).mesh(&["B"], |_| 0, flat);
    let yaml = format!(
        "bodies: {{B: s}}\nsupports:\n- {{face: X0, fix: [x]}}\n- {{face: Y0, fix: \
         [y]}}\nrigid:\n- {{face: X1, components: [x], free: [ux, ry, rz], at: [40, 5, 10], \
         force: [{:?}, 0, 0], moment: [0, {:?}, 0]}}\n",
        n * N,
        m * M
    );
    model(&yaml, mesh)
}

fn polygon(directions: u32) -> (CapacityPolygon, Patterns) {
    let text = format!(
        "end: bar, at: node, My: {} kN m, N: {} kN, directions: {directions}",
        1e-6 * M,
        1e-3 * N
    );
    let spec: PolygonSpec = serde_yaml::from_str(&format!("{{{text}}}")).unwrap();
    let action = |d: [f64; 2]| live_actions(&bar(d));
    let axes: Axes = [action([1.0, 0.0]), action([0.0, 1.0])];
    let patterns = Patterns::default();
    let solve = SolveOptions { patterns: patterns.clone(), ..SolveOptions::default() };
    let options = PassOptions { solve, ..PassOptions::default() };
    let points = spec.directions().into_iter().map(|d| {
        let model = bar(d.unit);
        let pass: LimitPass = limit::run(&model, &options, &silent()).unwrap();
        let bracket = pass.bracket.as_ref().unwrap();
        assert!(bracket.is_strict(), "{}: {bracket:?}", d.case);
        let (velocity, upper) = (pass.velocity.as_ref().unwrap(), bracket.upper());
        let space = HalfSpace::new(&model, velocity, upper).expect("a strict mechanism");
        let plane = space.half_plane(&axes, d.unit).expect("a mechanism bounds a half plane");
        // the point of this direction lies on the edge of the half plane
        let outside = plane.outside(d.unit.map(|x| upper.value() * x));
        assert!(outside.abs() < 1e-8 * upper.value(), "{}: {outside}", d.case);
        // loads other than these two
        let twice = [axes[0].clone(), axes[1].iter().map(|a| a.map(|x| 2.0 * x)).collect()];
        assert!(d.unit[1] == 0.0 || space.half_plane(&twice, d.unit).is_none(), "{}", d.case);
        Point {
            case: d.case,
            direction: d.unit,
            lower: Some(bracket.lower().value()),
            upper: Some(upper.value()),
            half_plane: Some(plane),
        }
    });
    let points = points.collect();
    let axes = [
        Axis { action: "My".into(), unit: ActionValue::Moment(M) },
        Axis { action: "N".into(), unit: ActionValue::Force(N) },
    ];
    (CapacityPolygon::new(["bar".into(), "node".into()], axes, points), patterns)
}

/// The largest `a m + b n` of the exact set.
fn support([a, b]: [f64; 2]) -> f64 {
    // at the vertex |m| + n² = 1 with n = b / (2|a|), or at the tip n = 1
    if b.abs() >= 2.0 * a.abs() { b.abs() } else { a.abs() + b * b / (4.0 * a.abs()) }
}

#[test]
fn rectangular_section() {
    let (polygon, patterns) = polygon(8);
    assert!(polygon.outer_bounded);
    let outer: Vec<[f64; 2]> = polygon.outer.iter().map(|c| [c[0] / M, c[1] / N]).collect();
    let inner: Vec<[f64; 2]> = polygon.inner.iter().map(|c| [c[0] / M, c[1] / N]).collect();
    let beyond = |[m, n]: [f64; 2]| m.abs() + n * n - 1.0;
    println!("inner {inner:.4?}\nouter {outer:.4?}");
    // the lower bounds are carried by the exact section
    inner.iter().for_each(|c| assert!(beyond(*c) <= 1e-6, "{c:?}"));
    // no half plane cuts the exact set, and each one nearly touches it
    for p in &polygon.points {
        let plane: HalfPlane = p.half_plane.unwrap();
        let exact = support(plane.normal);
        println!("{}: normal {:.4?}, {:.5} of {exact:.5}", p.case, plane.normal, plane.offset);
        assert!(plane.offset >= exact * (1.0 - 1e-6), "{}: {} below {exact}", p.case, plane.offset);
        assert!(plane.offset <= 1.05 * exact, "{}: {} far above {exact}", p.case, plane.offset);
        assert!(
            p.lower.unwrap() > 0.9 * p.upper.unwrap(),
            "{}: {:?} {:?}",
            p.case,
            p.lower,
            p.upper
        );
    }
    // tangents bound more than points: the outer hull is close to the curve everywhere
    outer.iter().for_each(|c| assert!(beyond(*c) >= -1e-6 && beyond(*c) < 0.35, "{c:?}"));
    // all eight directions reused the patterns of the first one
    let (kept, found) = patterns.count();
    assert!(kept <= 4 && found >= 7 * 4, "{kept} {found}");
}
