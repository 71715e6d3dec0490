//! Forces of bolts and between flanges, computed from the static field: they are in equilibrium
//! with the loads, and they include prying.

use crate::built::{joint, model};
use bracket::analysis::elastic;
use bracket::analysis::event::silent;
use bracket::analysis::pass::PassOptions;
use bracket::diag::Place;
use bracket::model::AnalysisKind;
use bracket::model::resolve::resolve;
use bracket::result::forces::{StaticForces, static_forces};

/// Forces in an elastic T-stub with two bolts under the load. `mirror` lists the symmetry planes of
/// its mesh.
/// The forces of one solution, read with the planes of symmetry `mirror` and without.
fn forces(load: &str, factor: f64, full: bool, mirror: &[usize]) -> [StaticForces; 2] {
    let joint = joint(&format!(
        "template: t_stub\nmembers: {{tee: {{profile: IPE300, steel: S235}}}}\nbolts: {{size: \
         M16, grade: \"8.8\", gauge: 100, rows: [0]}}\nparameters: {{length: 60, welded: true, \
         flange_thickness: 16, flange_width: 160, web_height: 30}}\nfriction: {{mu: 0}}\nloads: \
         [{{name: A, end: top, at: bolt_plane, {load}}}]\n"
    ));
    let (file, mesh) = model(&joint, factor, full, AnalysisKind::Elastic);
    let m = resolve(&file, mesh, &|_| Place::default()).unwrap_or_else(|e| panic!("{e:#?}"));
    assert_eq!(m.symmetry, 1 << mirror.len());
    let pass = elastic::run(&m, &PassOptions::default(), &silent()).unwrap();
    [mirror, &[]]
        .map(|planes| static_forces(&m, pass.stress.as_ref().unwrap(), 1.0, &joint.bolts, planes))
}

/// In tension the bolts carry the load and the prying force between the flange tips, Σ F_t = N + Q.
/// A strict field satisfies this up to rounding.
///
/// The estimate treats the flange as a beam that cannot rotate at the web and does not lift at the
/// bolt and at its tip: F m²/2 = Q n (m + n/3), so Q/F = 0.637 with m = 50 - 3.55 and n = 30.
/// Measured: 0.614 here, and 0.604 with elements of half the size, because a bolt head is wider
/// than a point.
#[test]
fn bolts_carry_the_load_and_the_prying() {
    let [s, quarter] = forces("N: 60 kN", 2.0, false, &[0, 1]);
    assert_eq!((s.bolts.len(), s.contacts.len()), (1, 1), "{s:?}");
    // a quarter contains half of one of the two bolts; both planes cut the contact of the flanges
    let (tension, prying) = (2.0 * s.bolts[0].tension, s.contacts[0].compression);
    println!("tension {tension:.1} N, prying {prying:.1} N");
    assert!((tension - prying - 60e3).abs() < 1e-6 * 60e3, "{tension} {prying}");
    let (m, n) = (50.0 - 3.55, 30.0);
    let beam = m * m / (2.0 * n * (m + n / 3.0));
    assert!((prying / 60e3 / beam - 1.0).abs() < 0.15, "{prying} {beam}");
    // the centre of pressure of the whole contact is on both planes; without the mirror it is that
    // of the flange tip, which presses beyond the bolt
    assert_eq!(s.contacts[0].centre[..2], [0.0, 0.0], "{s:?}");
    assert!(quarter.contacts[0].centre[0].abs() > 60.0, "{quarter:?}");
    assert!((4.0 * quarter.contacts[0].compression / prying - 1.0).abs() < 1e-12, "{quarter:?}");
}

/// With shear and bending as well, the forces of all bolts of the whole joint balance the load. One
/// bolt has a larger tension.
#[test]
fn bolts_balance_shear_and_moment() {
    let [s, _] = forces("N: 60 kN, Vz: 6 kN, My: 0.5 kN m", 4.0, true, &[]);
    let [a, b] = &s.bolts[..] else { panic!("{s:?}") };
    let flanges = &s.contacts[0];
    let sum = a.tension + b.tension - flanges.compression;
    assert!((sum - 60e3).abs() < 1e-4 * 60e3, "{s:?}");
    assert!((a.shear + b.shear - 6e3).abs() < 0.02 * 6e3, "{s:?}");
    assert!((a.tension - b.tension).abs() > 1e3, "{s:?}");
    // z′ of the end is x: My = 0.5 kN m acts about y; the bolts at ±50 mm and the pressed flanges
    // balance it
    assert!(a.tension.min(b.tension) > 0.0 && flanges.centre[2].abs() < 1e-9, "{s:?}");
}
