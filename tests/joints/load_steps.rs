//! Load steps of an elastoplastic analysis with preloaded bolts: the step at the full load is the
//! analysis itself, the chords enclose the displacement, and `verify` finds what is forged.

use crate::bench::Bench;
use crate::built::{joint, model_with_elastic_bolts};
use bracket::analysis::event::silent;
use bracket::analysis::hencky;
use bracket::analysis::pass::PassOptions;
use bracket::diag::Place;
use bracket::model::AnalysisKind;
use bracket::model::resolve::resolve;
use serde_json::Value;

/// A T-stub in tension with `n` kN whose two bolts are preloaded.
fn spec(n: f64, steps: &str) -> String {
    format!(
        "template: t_stub\nmembers: {{tee: {{profile: IPE300, steel: S235}}}}\nbolts: {{size: \
         M16, grade: \"8.8\", gauge: 100, rows: [0], preload: 0.7}}\nparameters: {{length: 60, \
         welded: true, flange_thickness: 16, flange_width: 160, web_height: 30}}\nfriction: {{mu: \
         0}}\nloads: [{{name: A, end: top, at: bolt_plane, N: {n} kN}}]\nanalysis: {{kind: \
         elastoplastic, bolts: elastic, load_steps: {steps}, max_passes: 1, decide: false, mesh: \
         {{layers: false}}}}\n"
    )
}

/// A change of a case of result.json.
type Change<'a> = &'a dyn Fn(&mut Value);

fn ran(spec: String) -> Bench {
    let bench = Bench::new().file("joint.yaml", spec);
    let run = bench.run(&["run", "joint.yaml", "--size-factor", "1.5", "--threads", "1"]);
    assert_eq!(run.status.code(), Some(3), "{}", String::from_utf8_lossy(&run.stderr));
    bench
}

fn result(bench: &Bench) -> Value {
    serde_json::from_str(&bench.read("joint/result.json")).unwrap()
}

/// The bounds of the energy of the whole joint, and the tension of a whole bolt \[N\].
fn solved(full: bool) -> ([f64; 2], f64) {
    let (file, mesh) = model_with_elastic_bolts(
        &joint(&spec(40.0, "[1]")),
        1.2,
        full,
        AnalysisKind::Elastoplastic,
    );
    let m = resolve(&file, mesh, &|_| Place::default()).unwrap_or_else(|e| panic!("{e:#?}"));
    let pass = hencky::run(&m, &PassOptions::default(), &silent()).unwrap();
    let b = pass.bracket.as_ref().expect("a bracket");
    assert!(b.is_strict(), "{b:?}");
    let bolt = &pass.preload[0];
    let share = bolt.force / (0.7 * 800.0 * 157.0);
    ([b.lower().value(), b.upper().value()], bolt.tension.unwrap() / share)
}

/// Whole joint and quarter have meshes of their own and closures of their own, whose energies
/// differ by that of the preload: the brackets overlap and the tensions are near.
#[test]
fn a_preloaded_quarter_is_the_whole_joint() {
    let ([a, b], whole) = solved(true);
    let ([c, d], quarter) = solved(false);
    println!("whole [{a}, {b}], {whole} N; quarter [{c}, {d}], {quarter} N");
    assert!(a <= d && c <= b);
    assert!((whole / quarter - 1.0).abs() < 0.1, "{whole} {quarter}");
}

#[test]
fn the_step_at_the_full_load_is_the_analysis_and_forged_steps_are_refuted() {
    let bench = ran(spec(40.0, "[0.5, 1, 1.25]"));
    let plain = result(&ran(spec(40.0, "[]")))["cases"][0].clone();
    let with_steps = result(&bench);
    let case = &with_steps["cases"][0];
    let steps = case["load_steps"].as_array().expect("steps");
    assert_eq!(steps.len(), 3);
    for key in ["lower", "upper", "face_motions"] {
        assert_eq!(plain[key], case[key], "{key}");
        assert_eq!(steps[1][key], case[key], "{key}");
    }
    let number = |i: usize, key: &str| steps[i][key].as_f64().unwrap_or(f64::NAN);
    let moved = |i: usize| steps[i]["face_motions"][0]["displacement"][2].as_f64().unwrap();
    assert!(steps.iter().all(|s| s["strict"] == true), "{steps:?}");
    assert!(number(1, "load_displacement_at_least") <= moved(1), "{steps:?}");
    assert!(number(1, "load_displacement_at_most") >= moved(1), "{steps:?}");
    assert!(moved(0) < moved(1) && moved(1) < moved(2), "{steps:?}");
    let report = bench.read("joint/report.md");
    assert!(report.contains("Load steps of A") && report.contains("load_steps_A.svg"), "{report}");
    let confirmed = bench.run(&["verify", "joint"]);
    let out = String::from_utf8_lossy(&confirmed.stdout).into_owned();
    assert_eq!((confirmed.status.code(), out.matches("confirmed").count()), (Some(0), 6), "{out}");
    let forged: [(&str, Change<'_>); 7] = [
        ("closure", &|c| scale(&mut c["preload"][0]["closure"])),
        ("lower", &|c| scale(&mut c["load_steps"][0]["lower"])),
        ("upper", &|c| scale(&mut c["load_steps"][2]["upper"])),
        ("bracket", &|c| scale(&mut c["load_steps"][1]["load_displacement_at_most"])),
        ("motion", &|c| scale(&mut c["load_steps"][2]["face_motions"][0]["displacement"][2])),
        ("factor", &|c| scale(&mut c["load_steps"][2]["factor"])),
        ("missing", &|c| drop(c["load_steps"].as_array_mut().unwrap().remove(0))),
    ];
    for (what, forge) in forged {
        let mut text = with_steps.clone();
        forge(&mut text["cases"][0]);
        let bench = bench.copy().file("joint/result.json", text.to_string());
        let verify = bench.sealed("joint").run(&["verify", "joint"]);
        let out = String::from_utf8_lossy(&verify.stdout).into_owned();
        assert_eq!(verify.status.code(), Some(1), "{what}: {out}");
    }
}

/// One per mille more.
fn scale(x: &mut Value) {
    *x = (1.001 * x.as_f64().expect("a number")).into();
}
