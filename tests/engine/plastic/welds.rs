//! Welds in bodies that yield: the weaker of the two yields.
//!
//! ```text
//!  |[======= elastic =======]|
//!  |[== yields ==‖== yields =]|→ N      ‖ weld
//! ```
//! The welded bar of length L lies beside an elastic bar with the strain e. It carries the smaller
//! strength s. Its own elastic strain is s/E. The rest of e L opens the weld or is plastic strain.
//! The energy per mm² is the same for both: `s²/(2E) L + s (e − s/E) L`.

use crate::common::plastic::{plastic_model, run, strict_pass};
use crate::common::yielding::{E, FY};
use crate::common::{Block, beside};
use bracket::model::AnalysisModel;

const LENGTH: f64 = 30.0;

fn bars(strength: f64, strain: f64, seed: u64) -> AnalysisModel {
    let bar = |cells, min, max, seed| Block { cells, min, max, jitter: 0.2, seed };
    let mesh = beside(
        bar([3, 1, 2], [0.0; 3], [LENGTH, 10.0, 12.0], seed).mesh(&["A"], |_| 0, |_, _| false),
        bar([2, 2, 1], [0.0, 20.0, 0.0], [LENGTH, 28.0, 12.0], seed + 1).mesh(
            &["B", "C"],
            |c| usize::from(c[0] > 15.0),
            |axis, x| axis == 0 && (x - 15.0).abs() < 1e-9,
        ),
    );
    let n = E * strain * 120.0 + strength.min(FY) * 96.0;
    plastic_model(
        &format!(
            "bodies: {{A: r, B: s, C: s}}\ninterfaces:\n- {{between: [B, C], law: weld, \
             strength_traction: {strength:?}}}\nsupports:\n- {{face: X0, fix: [x]}}\n- {{face: \
             Y0, fix: [y]}}\n- {{face: Z0, fix: [z]}}\nrigid:\n- {{face: X1, components: [x], \
             free: [ux], at: [{LENGTH:?}, 0, 0], force: [{n:?}, 0, 0]}}\n"
        ),
        mesh,
    )
}

#[test]
fn a_weld_or_the_bodies_beside_it_give_way() {
    let strain = 3.0 * FY / E;
    for (strength, seed) in [(120.0, 1), (120.0, 5), (300.0, 1), (300.0, 9)] {
        let s = FY.min(strength);
        let energy =
            0.5 * E * strain * strain * 120.0 + (s * s / (2.0 * E) + s * (strain - s / E)) * 96.0;
        let force = E * strain * 120.0 + s * 96.0;
        let want = LENGTH * (energy - force * strain);
        let name = format!("weld of {strength} MPa, seed {seed}");
        let model = bars(strength, strain, seed);
        let pass = run(&model);
        let [low, up] = strict_pass(&name, &model, &pass);
        println!("{name}: {:.1e} {:.1e}", low / want - 1.0, up / want - 1.0);
        assert!(
            (low / want - 1.0).abs() < 1e-6 && (up / want - 1.0).abs() < 1e-6,
            "{name}: [{low}, {up}], {want}"
        );
        let rounding = 1e-11 * want.abs();
        assert!(
            low <= want + rounding && up >= want - rounding,
            "{name}: [{low:e}, {up:e}] against {want:e}"
        );
        // either the weld is fully used, or the bars are
        let used = pass.lower.as_ref().unwrap().certificate().weld.unwrap();
        assert!(used <= 1.0 && (used - s / strength).abs() < 1e-5, "{name}: {used}");
        let work = pass.upper.as_ref().unwrap().certificate().welds[0];
        let opened =
            if strength < FY { strength * 96.0 * LENGTH * (strain - strength / E) } else { 0.0 };
        assert!((work - opened).abs() < 1e-5 * want.abs(), "{name}: {work} {opened}");
    }
}
