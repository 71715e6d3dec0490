//! Many load cases bounded by few limit analyses: the arm of [`super::verdicts`] under moment,
//! shear and axial force.

use super::verdicts::TEMPLATE;
use crate::bench::{Bench, Edit, expect};
use serde_json::Value;

const HEAD: &str = "template: ./arm.yaml\nmembers: {arm: {profile: IPE80, steel: S235}}\n";

/// Moment, shear and axial force of 16 load cases in kN m and kN. The section carries f_y b h²/4 =
/// 0.47 kN m or f_y b h = 94 kN; the last two are beyond it.
fn actions() -> Vec<[f64; 3]> {
    let wave = |i: usize, k: usize| ((5 + 7 * i + 3 * k * i * i) % 13) as f64 / 6.0 - 1.0;
    let within = (0..14).map(|i| {
        let m = 0.1 + 0.2 * (i as f64 / 13.0);
        [m, -0.4 + 0.2 * wave(i, 1), 12.0 * wave(i, 2)]
    });
    within.chain([[0.9, -0.4, 3.0], [0.95, -0.3, -4.0]]).collect()
}

fn spec(combinations: &str, cases: &[usize]) -> String {
    let load = |i: &usize| {
        let [m, v, n] = actions()[*i];
        format!("{{name: LC{i}, end: tip, at: node, My: {m} kN m, Vz: {v} kN, N: {n} kN}}")
    };
    let loads: Vec<String> = cases.iter().map(load).collect();
    format!(
        "{HEAD}loads: [{}]\nanalysis: {{kind: limit, decide: false, max_passes: \
         1{combinations}}}\n",
        loads.join(", ")
    )
}

fn number(v: &Value) -> f64 {
    v.as_f64().unwrap_or_else(|| panic!("a number: {v}"))
}

/// Every load case is decided, few are analysed, each bracket overlaps that of a run of its own,
/// and `verify` proves the weights.
#[test]
fn few_analyses_decide_all_load_cases() {
    let all: Vec<usize> = (0..16).collect();
    let bench = Bench::new().file("arm.yaml", TEMPLATE).file("joint.yaml", spec("", &all));
    let (_, err) = expect(&bench, &["run", "joint.yaml"], 1);
    let result: Value = serde_json::from_str(&bench.read("joint/result.json")).expect("JSON");
    let cases = result["cases"].as_array().expect("cases");
    let derived = |c: &&Value| c.get("proved_by").is_some();
    let runs = cases.iter().filter(|c| !derived(c)).count();
    assert!(runs <= 7, "{runs} analyses: {err}");
    assert_eq!(cases.len(), 16 + result["directions"].as_array().map_or(0, Vec::len));
    let words: Vec<&Value> = cases[..16].iter().map(|c| &c["demand"]["by_analysis"]).collect();
    assert!(words[..14].iter().all(|w| **w == "ok") && words[14..].iter().all(|w| **w == "not_ok"));
    let told = format!("{runs} limit analyses decide 16 of 16 load cases");
    assert!(err.contains(&told), "{err}");
    // some with a run of their own
    let own: Vec<usize> = (0..16).filter(|i| derived(&&cases[*i])).step_by(4).collect();
    let bench = bench.file("own.yaml", spec(", combinations: each", &own));
    let code = if own.iter().any(|i| *i > 13) { 1 } else { 3 };
    expect(&bench, &["run", "own.yaml"], code);
    let direct: Value = serde_json::from_str(&bench.read("own/result.json")).expect("JSON");
    for (k, i) in own.iter().enumerate() {
        let (found, direct) = (&cases[*i], &direct["cases"][k]);
        assert_eq!(found["name"], direct["name"]);
        let [low, up] = ["lower", "upper"].map(|b| [found, direct].map(|c| number(&c[b])));
        assert!(low[0] <= up[1] && low[1] <= up[0], "{low:?} {up:?}");
        // the hull is inside of what is carried, the half spaces outside
        assert!(low[0] <= low[1] * 1.02 && up[0] >= up[1] * 0.98, "{low:?} {up:?}");
    }
    let (text, _) = expect(&bench, &["verify", "joint"], 0);
    assert!(text.contains("confirmed"), "{text}");
    let report = bench.read("joint/report.md");
    assert!(report.contains(&format!("{runs} limit analyses bound 16 load cases;")), "{report}");
}

/// A claim that the stored analyses do not prove is refuted.
#[test]
fn forged_proofs_are_refuted() {
    let all: Vec<usize> = (0..14).collect();
    let bench = Bench::new().file("arm.yaml", TEMPLATE).file("joint.yaml", spec("", &all));
    expect(&bench, &["run", "joint.yaml"], 3);
    let result: Value = serde_json::from_str(&bench.read("joint/result.json")).expect("JSON");
    let cases = result["cases"].as_array().expect("cases");
    let found = cases.iter().position(|c| c.get("proved_by").is_some()).expect("a derived case");
    let edits: [Edit<'_>; 6] = [
        ("prove no such bounds", &|c| scale(&mut c["proved_by"]["lower"][0]["weight"], 0.9)),
        ("prove no such bounds", &|c| c["proved_by"]["upper"] = "LC99".into()),
        ("not those that `proved_by` proves", &|c| scale(&mut c["lower"], 1.1)),
        ("not those that `proved_by` proves", &|c| scale(&mut c["upper"], 0.95)),
        ("gap", &|c| scale(&mut c["gap"], 0.5)),
        ("not those that `proved_by` proves", &|c| c["proved_by"] = serde_json::json!({})),
    ];
    for (words, edit) in edits {
        let mut changed = result.clone();
        edit(&mut changed["cases"][found]);
        std::fs::write(bench.path().join("joint/result.json"), format!("{changed:#}"))
            .expect("written");
        let (out, _) = expect(bench.sealed("joint"), &["verify", "joint"], 1);
        assert!(out.contains("REFUTED: ") && out.contains(words), "{words}: {out}");
    }
}

fn scale(v: &mut Value, by: f64) {
    *v = (by * number(v)).into();
}
