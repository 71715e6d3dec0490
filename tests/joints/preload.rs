//! Preloaded bolts of a spec: the preload is the same in the whole joint and in its symmetric half,
//! drops out of limit analysis, and appears in result and report.

use crate::bench::Bench;
use crate::built::{joint, model};
use bracket::analysis::elastic;
use bracket::analysis::energy_pass::EnergyPass;
use bracket::analysis::event::silent;
use bracket::analysis::pass::PassOptions;
use bracket::diag::Place;
use bracket::model::AnalysisKind;
use bracket::model::resolve::resolve;
use serde_json::Value;

/// 0.7 f_ub A_s of an M16 8.8 \[N\].
const FORCE: f64 = 0.7 * 800.0 * 157.0;

/// A T-stub in tension with `n` kN. Its two preloaded bolts fill their holes without friction
/// there.
fn spec(preload: &str, n: f64) -> String {
    format!(
        "template: t_stub\nmembers: {{tee: {{profile: IPE300, steel: S235}}}}\nbolts: {{size: \
         M16, grade: \"8.8\", gauge: 100, rows: [0], preload: {preload}}}\nparameters: {{length: \
         60, welded: true, flange_thickness: 16, flange_width: 160, web_height: 30}}\nfriction: \
         {{mu: 0}}\nloads: [{{name: A, end: top, at: bolt_plane, N: {n} kN}}]\nanalysis: {{kind: \
         [elastic, limit], max_passes: 1, mesh: {{layers: false}}}}\n"
    )
}

/// The elastic pass, and the number of copies of the mesh that make up the whole joint.
fn solved(preload: &str, n: f64, factor: f64, full: bool) -> (EnergyPass, f64) {
    let (file, mesh) = model(&joint(&spec(preload, n)), factor, full, AnalysisKind::Elastic);
    let m = resolve(&file, mesh, &|_| Place::default()).unwrap_or_else(|e| panic!("{e:#?}"));
    let pass = elastic::run(&m, &PassOptions::default(), &silent()).unwrap();
    assert!(pass.bracket.as_ref().is_some_and(|b| b.is_strict()), "{:?}", pass.bracket);
    (pass, f64::from(m.symmetry))
}

/// Under a small load every bolt keeps its preload. The static program computes this preload with
/// the frozen closure, which is the mean of the closures of both programs. The closure belongs to
/// the shank and the clamped parts: δ > F_p L/(E A), and less than three times that value in
/// flanges as stiff as these.
#[test]
fn every_bolt_has_its_preload_whole_or_halved() {
    let shank = FORCE * 32.0 / (210e3 * 201.06);
    for (said, factor, full, bolts, half, near) in
        [("0.7", 2.0, true, 2, 1.0, 0.2), ("87.92 kN", 0.8, false, 1, 0.5, 0.1)]
    {
        let (pass, copies) = solved(said, 0.01, factor, full);
        assert_eq!((pass.preload.len(), copies), (bolts, if full { 1.0 } else { 4.0 }));
        for b in &pass.preload {
            let tension = b.tension.unwrap();
            println!(
                "{}: closure {:.5} mm, {:.3} of the shank alone; tension {tension:.0} N",
                b.body,
                b.closure,
                b.closure / shank
            );
            assert!((b.force - half * FORCE).abs() < 1e-6, "{b:?}");
            assert!((1.0..3.0).contains(&(b.closure / shank)), "{b:?}");
            // the error is half the difference of the closures from the two programs, which is
            // larger on coarse meshes
            assert!((tension / b.force - 1.0).abs() < near, "{b:?}");
        }
        if let [a, b] = &pass.preload[..] {
            // the bolts differ only because the mesh is not symmetric
            assert!((a.tension.unwrap() / b.tension.unwrap() - 1.0).abs() < 0.03, "{a:?} {b:?}");
            assert!((a.closure / b.closure - 1.0).abs() < 0.03, "{a:?} {b:?}");
        }
    }
}

/// Under a load below the preload the flanges stay closed, and a bolt carries little of the load. A
/// bolt without preload carries all of the load and the prying force.
#[test]
fn a_preloaded_bolt_feels_a_part_of_the_load() {
    let pulled = |preload: &str| solved(preload, 60.0, 2.5, false).0;
    let [idle, loaded] =
        [0.01, 60.0].map(|n| solved("0.7", n, 2.5, false).0.preload[0].tension.unwrap());
    let rise = 2.0 * (loaded - idle);
    println!("the tension of a bolt rises by {rise:.0} N of 30 000 N");
    assert!(rise > 0.0 && rise < 0.5 * 30e3, "{rise}");
    assert!(pulled("none").preload.is_empty());
}

/// Preload of bolts that may yield is refused before meshing starts.
#[test]
fn preload_of_bolts_that_yield_is_refused_before_the_mesher_starts() {
    let bench = Bench::new().file(
        "joint.yaml",
        spec("0.7", 40.0).replace("[elastic, limit]", "[elastic, elastoplastic]"),
    );
    let run = bench.run(&["run", "joint.yaml"]);
    let stderr = String::from_utf8_lossy(&run.stderr).into_owned();
    assert_eq!(run.status.code(), Some(2), "{stderr}");
    for words in
        ["model/unavailable", "joint.yaml:3:", "tightens elastic bolts only", "`bolts: elastic`"]
    {
        assert!(stderr.contains(words), "{words}: {stderr}");
    }
    assert!(!stderr.contains("meshing"), "{stderr}");
}

/// The limit analysis gives the same number on the same mesh without preload. `verify` confirms the
/// files.
#[test]
fn a_run_reports_the_preload_and_limit_analysis_ignores_it() {
    let bench = Bench::new().file(
        "joint.yaml",
        spec("0.7", 40.0).replace("[elastic, limit]", "[elastic, limit], decide: false"),
    );
    let run = bench.run(&["run", "joint.yaml", "--size-factor", "2.5", "--threads", "1"]);
    let stderr = String::from_utf8_lossy(&run.stderr).into_owned();
    // the lower bound alone is no complete route
    assert_eq!(run.status.code(), Some(3), "{stderr}");
    let result: Value = serde_json::from_str(&bench.read("joint/result.json")).unwrap();
    let (elastic, limit) = (&result["cases"][0], &result["cases"][1]);
    for case in [elastic, limit] {
        assert_eq!(case["certificate"]["strict"], true, "{case}");
    }
    assert_eq!(
        (&elastic["preload"][0]["halved"], &elastic["preload"][0]["force"]),
        (&true.into(), &(FORCE / 2.0).into())
    );
    assert!(limit.get("preload").is_none() && elastic.get("load_displacement").is_none());
    let report = bench.read("joint/report.md");
    for words in [
        "Bolt BOLT_1P: the preload of 43.96 kN in the half that is meshed (a plane of symmetry \
         halves the bolt) closes the cut",
        "| bolts.preload | 87920 | N | given |",
        "limit analysis: the preload of BOLT\\_1P drops out",
        "with preload it does not bracket a displacement",
    ] {
        assert!(
            report.contains(words) || report.contains(&words.replace("\\_", "_")),
            "{words}: {report}"
        );
    }
    let verify = bench.run(&["verify", "joint"]);
    let out = String::from_utf8_lossy(&verify.stdout).into_owned();
    assert_eq!((verify.status.code(), out.matches("confirmed").count()), (Some(0), 4), "{out}");
    // the same mesh without preload: removes the preload from the model
    let text = bench.read("joint/model_A_limit.yaml");
    let (before, after) = text.split_once("preload:\n").expect("a preload");
    let rest: String = after
        .lines()
        .skip_while(|l| l.starts_with('-') || l.starts_with(' '))
        .map(|l| format!("{l}\n"))
        .collect();
    let bench = bench.file("joint/bare.yaml", format!("{before}{rest}"));
    let run = bench.run(&["analyse", "joint/bare.yaml", "--out", "bare", "--threads", "1"]);
    assert_eq!(run.status.code(), Some(0), "{}", String::from_utf8_lossy(&run.stderr));
    let bare: Value = serde_json::from_str(&bench.read("bare/result.json")).unwrap();
    for key in ["lower", "upper"] {
        assert_eq!(bare["cases"][0][key], limit[key], "{key}");
    }
}
