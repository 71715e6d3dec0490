//! Bodies whose limit load is known exactly and whose exact fields both elements represent on any
//! mesh (docs/benchmarks.md, A1–A5, A7).
//!
//! Tolerance 1e-6 relative, because the solver is asked for a gap of 1e-7; 1e-5 for pure bending.

use crate::common::Block;
use crate::common::limit::{run, sharp_factors};
use crate::common::yielding::{FY, model};
use bracket::certify::free_mechanism::{certify_free, is_free};
use bracket::certify::limit_certificate::certify_upper;
use bracket::certify::unlimited::certify_unlimited;
use bracket::elements::hencky_kinematic::Flow;
use bracket::mesh::TetMesh;
use bracket::model::AnalysisModel;
use bracket::programs::{Kinematic, Static};
use bracket::solve::{Patterns, SolveOptions, SolveStatus, condensed};

const SEEDS: [u64; 3] = [1, 5, 9];

fn cuboid(cells: [usize; 3], max: [f64; 3], seed: u64) -> TetMesh {
    Block::new(cells, max).jittered(seed).mesh(&["B"], |_| 0, |_, _| false)
}

fn exact(name: &str, want: f64, tolerance: f64, at: impl Fn(u64) -> AnalysisModel) {
    for seed in SEEDS {
        let [low, up] = sharp_factors(&format!("{name}, seed {seed}"), &at(seed));
        assert!(
            (low / want - 1.0).abs() < tolerance && (up / want - 1.0).abs() < tolerance,
            "{name}: [{low}, {up}]"
        );
        // strict: neither bound may pass the exact value by more than its own rounding error
        assert!(
            low <= want * (1.0 + 1e-9) && up >= want * (1.0 - 1e-9),
            "{name}: [{low}, {up}] against {want}"
        );
    }
}

/// A1: N = s0 A.
#[test]
fn bar_in_tension() {
    exact("A1", 1.0, 1e-6, |seed| {
        model(
            "bodies: {B: s}\nsupports:\n- {face: X0, fix: [x]}\n- {face: Y0, fix: [y]}\n- {face: \
             Z0, fix: [z]}\nloads:\n- {face: X1, traction: [1, 0, 0]}\n",
            cuboid([3, 2, 2], [30.0, 10.0, 12.0], seed),
        )
    });
}

/// A2: between plane-strain faces 2/√3 s0 A.
#[test]
fn bar_in_plane_strain() {
    exact("A2", 2.0 / 3.0f64.sqrt(), 1e-6, |seed| {
        model(
            "bodies: {B: s}\nsupports:\n- {face: X0, fix: [x]}\n- {face: Y0, fix: [y]}\n- {face: \
             Z0, fix: [z]}\n- {face: Y1, fix: [y]}\nloads:\n- {face: X1, traction: [1, 0, 0]}\n",
            cuboid([3, 2, 2], [30.0, 10.0, 12.0], seed),
        )
    });
}

/// A3: pure shear, k = s0/√3.
#[test]
fn cube_in_shear() {
    exact("A3", 1.0 / 3.0f64.sqrt(), 1e-6, |seed| {
        let faces = ["X0", "X1", "Y0", "Y1"];
        let tractions = ["[0, -1, 0]", "[0, 1, 0]", "[-1, 0, 0]", "[1, 0, 0]"];
        let loads: String = faces
            .iter()
            .zip(tractions)
            .map(|(f, t)| format!("- {{face: {f}, traction: {t}}}\n"))
            .collect();
        let support = "supports:\n- {face: Z0, fix: [z]}\n- {face: Z1, fix: [z]}\n";
        model(
            &format!("bodies: {{B: s}}\n{support}loads:\n{loads}"),
            cuboid([2, 2, 2], [10.0; 3], seed),
        )
    });
}

/// A4: pure bending with ends that are rigid in x only and a mesh plane at mid-height: M = s0 b
/// h²/4. A5: the same between plane-strain faces.
#[test]
fn beam_in_pure_bending() {
    let (b, h) = (8.0, 12.0);
    for (name, plane, want) in
        [("A4", "", 1.0), ("A5", "- {face: Y1, fix: [y]}\n", 2.0 / 3.0f64.sqrt())]
    {
        exact(name, want, 1e-5, |seed| {
            let mesh = Block {
                cells: [3, 1, 2],
                min: [0.0, 0.0, -6.0],
                max: [30.0, b, 6.0],
                jitter: 0.2,
                seed,
            }
            .mesh(&["B"], |_| 0, |axis, z| axis == 2 && z.abs() < 1e-9);
            // the load is the moment b h²/4, so the load factor over s0 is M over s0 b h²/4
            let m = b * h * h / 4.0;
            model(
                &format!(
                    "bodies: {{B: s}}\nsupports:\n- {{face: X0, fix: [x]}}\n- {{face: Y0, fix: \
                     [y]}}\n{plane}rigid:\n- {{face: X1, components: [x], free: [ux, ry], at: \
                     [30, 0, 0], moment: [0, {m:?}, 0]}}\n"
                ),
                mesh,
            )
        });
    }
}

fn pressed_all_round(seed: u64, more: &str) -> AnalysisModel {
    let loads: String = ["X0", "X1", "Y0", "Y1", "Z0", "Z1"]
        .map(|f| format!("- {{face: {f}, pressure: 1}}\n"))
        .concat();
    model(&format!("bodies: {{B: s}}\nloads:\n{loads}{more}"), cuboid([2, 1, 2], [10.0; 3], seed))
}

/// A7: all-round pressure never causes plastic flow, so the load factor has no limit. A pressure
/// field proves it, and both programs report it within 15 iterations.
#[test]
fn cube_under_all_round_pressure() {
    for seed in SEEDS {
        let m = pressed_all_round(seed, "");
        let pass = run(&m);
        let unlimited = pass.unlimited.as_ref().expect("proved");
        assert!(pass.upper.is_none() && pass.lower.is_none() && pass.runs().count() == 0);
        let again = certify_unlimited(&m, &unlimited.field, None);
        assert!(
            again.is_strict() && again.deviator == 0.0 && again.traction_jump < 1e-12,
            "{again:?}"
        );
        let pressure = unlimited.field.points.iter().flatten().flatten().map(|s| s[0] + 1.0);
        assert!(pressure.fold(0.0, |m: f64, p| m.max(p.abs())) < 1e-12);
        let statics = Static::limit(&m).unwrap();
        let kinematic = Kinematic::limit(&m, Flow::Split).unwrap();
        let programs =
            [(&statics.program, &statics.map.block), (&kinematic.program, &kinematic.map.block)];
        for (program, block) in programs {
            let options = SolveOptions::default();
            let s = condensed::Prepared::new(program, block, &Patterns::default())
                .unwrap()
                .solve(&options);
            assert_eq!(s.status, SolveStatus::Infeasible);
            assert!(s.iterations <= 15, "{}", s.iterations);
        }
    }
}

/// A dead pull that the cube can carry changes nothing. A dead pull beyond its strength leaves no
/// proof and no bound.
#[test]
fn all_round_pressure_beside_a_dead_pull() {
    let pull = |t: f64| {
        format!(
            "dead:\n- {{face: X1, traction: [{t:?}, 0, 0]}}\n- {{face: X0, traction: [{:?}, 0, \
             0]}}\n",
            -t
        )
    };
    let m = pressed_all_round(1, &pull(0.5 * FY));
    let unlimited = run(&m).unlimited.expect("proved");
    let dead = unlimited.certificate.dead.as_ref().expect("a field of the dead loads");
    assert!(dead.factor == 0.0 && dead.utilisation > 0.49 && dead.utilisation < 1.0, "{dead:?}");
    assert!(
        !certify_unlimited(&m, &unlimited.field, None).is_strict(),
        "the dead loads need their own field"
    );
    let pass = run(&pressed_all_round(1, &pull(1.5 * FY)));
    assert!(pass.unlimited.is_none() && pass.bracket.is_none() && pass.lower.is_none());
}

/// Fields that do not prove a load without limit: a deviator, another pressure, a pull across a
/// contact, NaN.
#[test]
fn what_proves_no_load_without_limit() {
    let m = pressed_all_round(1, "");
    let good = run(&m).unlimited.expect("proved").field;
    assert!(certify_unlimited(&m, &good, None).is_strict());
    let changed = |f: &dyn Fn(&mut [f64; 6])| {
        let mut field = good.clone();
        field.points.iter_mut().flatten().flatten().for_each(f);
        certify_unlimited(&m, &field, None)
    };
    assert!(!changed(&|s| s[0] *= 1.0 + 1e-8).is_strict());
    assert!(!changed(&|s| (0..3).for_each(|i| s[i] *= 1.0 + 1e-8)).is_strict());
    assert!(!changed(&|s| s[3] = f64::NAN).is_strict());
    assert!(!changed(&|s| *s = [0.0; 6]).is_strict());
    // a pressure on every face but one is not in equilibrium with any pressure field
    let loads: String =
        ["X1", "Y0", "Y1", "Z0"].map(|f| format!("- {{face: {f}, pressure: 1}}\n")).concat();
    let supports = "supports:\n- {face: X0, fix: [x, y, z]}\n";
    let open = model(
        &format!("bodies: {{B: s}}\n{supports}loads:\n{loads}"),
        cuboid([2, 1, 2], [10.0; 3], 1),
    );
    assert!(run(&open).unlimited.is_none());
}

fn lifted(traction: &str, mu: f64, dead: &str) -> AnalysisModel {
    let shape =
        Block { cells: [2, 2, 2], min: [0.0; 3], max: [20.0, 20.0, 40.0], jitter: 0.2, seed: 4 };
    let mesh = shape.mesh(
        &["A", "B"],
        |c| usize::from(c[2] > 20.0),
        |d, x| d == 2 && (x - 20.0).abs() < 1e-9,
    );
    model(
        &format!(
            "bodies: {{A: s, B: s}}\ninterfaces:\n- {{between: [A, B], law: contact, mu: {mu:?}, \
             friction: associated}}\nsupports:\n- {{face: Z0, fix: [x, y, z]}}\nloads:\n- {{face: \
             Z1, traction: {traction}}}\n{dead}"
        ),
        mesh,
    )
}

/// A block that only contact holds. If it is lifted, pushed out of its friction cone or turned
/// over, it moves without any load. If it is pressed, or pushed inside the cone, it does not move.
/// A dead weight holds it down.
#[test]
fn mechanisms_at_zero_load() {
    for traction in ["[0, 0, 1]", "[1, 0, -1]", "[0.3, 0.6, 0.1]", "[0, 1, -1.9]"] {
        let m = lifted(traction, 0.5, "");
        let pass = run(&m);
        let free = pass.free.as_ref().unwrap_or_else(|| panic!("{traction}"));
        assert!(pass.moves.as_ref().unwrap().to_string().contains("part B"), "{:?}", pass.moves);
        let lower = pass.lower.as_ref().unwrap();
        assert!(lower.value() == 0.0 && lower.is_strict() && pass.upper.is_none());
        let c = certify_free(&m, &free.field);
        assert!(
            is_free(&c) && c.live_power > 0.0 && c.rigid < 1e-12 && c.contact.unwrap() < 1e-12,
            "{c:?}"
        );
        // the general certificate agrees: the dissipation is zero
        let upper = certify_upper(&m, &free.field, 1);
        assert!(upper.factor.abs() < 1e-9, "{traction}: {upper:?}");
        // the reversed velocities, or the same velocities with sufficient friction, prove nothing
        let mut back = free.field.clone();
        back.nodes.u.iter_mut().flatten().for_each(|u| *u = -*u);
        assert!(!is_free(&certify_free(&m, &back)));
        assert!(
            run(&lifted(
                traction,
                0.5,
                &format!("dead:\n- {{face: Z1, traction: [0, 0, {:?}]}}\n", -0.1 * FY)
            ))
            .free
            .is_none()
        );
    }
    for traction in ["[0, 0, -1]", "[0.2, 0.1, -1]"] {
        let pass = run(&lifted(traction, 0.5, ""));
        assert!(pass.free.is_none() && pass.bracket.as_ref().unwrap().is_strict(), "{traction}");
        assert!(pass.lower.unwrap().value() > 1.0);
    }
}

/// A dead load beyond the limit load: no load factor exists, and both programs report it.
#[test]
fn dead_load_beyond_the_limit() {
    let m = model(
        &format!(
            "bodies: {{B: s}}\nsupports:\n- {{face: X0, fix: [x, y, z]}}\nloads:\n- {{face: X1, \
             traction: [0, 0, 1]}}\ndead:\n- {{face: X1, traction: [{:?}, 0, 0]}}\n",
            1.5 * FY
        ),
        cuboid([3, 2, 2], [30.0, 10.0, 12.0], 1),
    );
    for (program, r) in run(&m).runs() {
        println!(
            "dead {}: {} in {}, {:?}",
            program.name(),
            r.status.words(),
            r.iterations,
            r.mechanism
        );
        assert_eq!(r.status, SolveStatus::Unbounded, "{}", program.name());
    }
}
