//! The paper's quarter joint on two fixed meshes, against an independent numpy implementation of both programs.
//!
//! Source: the reference implementation's figures (9k: −79 722.936 / −83 550.428 N mm; 33k: −80 686.184 / −82 674.174).
//! Tolerance 1e-6 relative: both solve the same discrete programs to a gap of 1e-7.
//!
//! The reference keys a contact cone by the bolt's node and the normal alone. Where a shank passes from plate to column
//! one node of the shank meets a node of the plate and another of the column, with the same normal: two cones, of which
//! the reference keeps one. So its kinematic figure lies a little below ours (−79 722.936 against −79 721.808 at 9k) and
//! is not strict. The test checks both: with the same cones left out our program gives the reference's figure, with all
//! cones it gives a higher one, and that is the certified bound.

use bracket::adapt::pass;
use bracket::model::kinematic::{ControlPoint, Kinematic};
use bracket::model::{AnalysisModel, ConicProgram};
use bracket::solve::{self, SolveStatus};
use std::collections::BTreeSet;
use std::path::Path;
use std::sync::Arc;

fn close(a: f64, b: f64, tolerance: f64) {
    assert!((a - b).abs() <= tolerance * b.abs(), "{a} against {b}");
}

fn load(folder: &str) -> AnalysisModel {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data").join(folder).join("model.yaml");
    bracket::model::resolve::load_model(&path).unwrap()
}

/// Which control points the reference keeps: of those on a shank, the first with its bolt node and normal.
fn kept_by_reference(model: &AnalysisModel, kinematic: &Kinematic) -> Vec<bool> {
    let mut of_bolt = vec![false; kinematic.space.nodes.len()];
    for e in 0..model.mesh.tets.len() {
        if model.mesh.bodies[model.mesh.tet_body[e] as usize].starts_with("BOLT") {
            kinematic.space.tet(&model.mesh, e).into_iter().for_each(|n| of_bolt[n] = true);
        }
    }
    let mut seen = BTreeSet::new();
    kinematic
        .points
        .iter()
        .map(|p: &ControlPoint| {
            // shanks run along x: their normals have no x component, all other contacts have nothing else
            if p.normal[0].abs() > 0.5 {
                return true;
            }
            let (node, sign) = if of_bolt[p.a[0]] { (p.a[0], 1.0) } else { (p.b.unwrap()[0], -1.0) };
            seen.insert((node, p.normal.map(|x| (sign * x * 1e3).round() as i64)))
        })
        .collect()
}

/// The program without the cones that are not kept.
fn with_cones(program: &ConicProgram, keep: &[bool]) -> ConicProgram {
    let mut out = ConicProgram { p: program.p.clone(), q: program.q.clone(), c: program.c, ..Default::default() };
    out.g.ncols = program.g.ncols;
    for ((start, cone), keep) in program.cone_starts().into_iter().zip(&program.cones).zip(keep) {
        if *keep {
            for r in start..start + cone.dim() {
                out.g.push_row(&program.g.row(r).map(|(c, v)| (c as u32, v)).collect::<Vec<_>>());
                out.h.push(program.h[r]);
            }
            out.cones.push(*cone);
        }
    }
    out
}

fn check(folder: &str, upper: f64, reference_upper: f64, reference_lower: f64, dropped: usize) {
    let model = load(folder);
    let quiet: pass::Progress = Arc::new(|_, _, _, _| {});
    let result = pass::run(&model, &Default::default(), &quiet).unwrap();
    let bracket = result.bracket.as_ref().expect("both programs end optimal");
    println!("{folder}: [{}, {}], gap {}", bracket.lower().value(), bracket.upper().value(), bracket.gap());
    println!("{:?}\n{:?}", result.kinematic, result.statics);
    close(bracket.lower().value(), reference_lower, 1e-6);
    close(bracket.upper().value(), upper, 1e-6);
    assert!(bracket.is_strict(), "{bracket:?}");
    let total = result.contributions.as_ref().unwrap().total();
    close(total, bracket.upper().value() - bracket.lower().value(), 1e-7);

    let kinematic = Kinematic::new(&model).unwrap();
    let keep = kept_by_reference(&model, &kinematic);
    assert_eq!(keep.iter().filter(|k| !**k).count(), dropped);
    let program = with_cones(&kinematic.program, &keep);
    let solution = solve::solve(&program, &kinematic.map.block, &Default::default());
    assert_eq!(solution.status, SolveStatus::Optimal);
    let value = program.objective(&solution.x);
    println!("{folder}: with the reference's cones {value}");
    close(value, reference_upper, 1e-6);
    assert!(value < bracket.upper().value());
}

#[test]
fn nine_thousand() {
    check("paper_quarter_9k", -79_721.808, -79_722.936, -83_550.428, 2);
}

#[test]
#[ignore = "heavy: about ten minutes and several GiB"]
fn thirty_three_thousand() {
    check("paper_quarter_33k", -80_685.0, -80_686.184, -82_674.174, 2);
}
