//! A bolted joint for which the code has no method: what its bounds say of a demand below, above
//! and within them, and the verdict by the complete route of analysis.

use crate::bench::Bench;
use serde_json::Value;

/// Verdict by bounds alone, and the bounds, of a T-stub pulled by `n` kN; the run must end with
/// `code`.
fn answer(bench: &Bench, name: &str, n: f64, code: i32) -> (String, [f64; 2]) {
    let spec = format!(
        "template: t_stub\nmembers: {{tee: {{profile: IPE300, steel: S235}}}}\nbolts: {{size: \
         M16, grade: \"8.8\", gauge: 100, rows: [0]}}\nparameters: {{length: 100, welded: true, \
         flange_thickness: 40, flange_width: 160, web_height: 30}}\nfriction: {{mu: 0}}\nloads: \
         [{{name: ULS1, end: top, at: bolt_plane, N: {n} kN}}]\nanalysis: {{kind: limit, \
         decide: false, max_passes: 1, mesh: {{layers: false}}}}\n"
    );
    std::fs::write(bench.path().join(format!("{name}.yaml")), spec).expect("written");
    let run = bench.run(&["run", &format!("{name}.yaml"), "--size-factor", "1.25"]);
    assert_eq!(run.status.code(), Some(code), "{name}: {}", String::from_utf8_lossy(&run.stderr));
    let result: Value =
        serde_json::from_str(&bench.read(&format!("{name}/result.json"))).expect("JSON");
    let case = &result["cases"][0];
    assert_eq!(case["certificate"]["strict"], true);
    let bounds =
        ["lower", "upper"].map(|key| case[key].as_f64().unwrap_or_else(|| panic!("{key}: {case}")));
    // the utilisation is the interval [1/λ_up, 1/λ_low]
    for (k, bound) in [bounds[1], bounds[0]].into_iter().enumerate() {
        let u = case["utilisation"][k].as_f64().expect("utilisation");
        assert!((u * bound - 1.0).abs() < 1e-9, "{u} {bound}");
    }
    let by_bounds = &case["demand"]["by_analysis"];
    (by_bounds.as_str().unwrap_or_default().to_string(), bounds)
}

/// The bounds decide below the lower and above the upper one. A lower bound that carries the load
/// is one step of the route of analysis, and no verdict: the exit code is 3.
#[test]
fn a_bolted_joint_at_95_percent_of_the_lower_and_105_of_the_upper_bound() {
    let bench = Bench::new();
    let (verdict, [lower, upper]) = answer(&bench, "once", 100.0, 3);
    assert_eq!(verdict, "ok");
    // the flange is so thick that both bolts fail in pure tension, at F_t,Rd = 0.9 · 800 · 157/1.25
    // each: mode 3
    let bolts = 2.0 * 0.9 * 800.0 * 157.0 / 1.25 / 1e3;
    assert!((100.0 * upper / bolts - 1.0).abs() < 0.01, "{upper} {bolts}");
    let middle = 50.0 * (lower + upper);
    for (name, n, code, word) in [
        ("below", 95.0 * lower, 3, "ok"),
        ("above", 105.0 * upper, 1, "not_ok"),
        ("within", middle, 3, "undecided"),
    ] {
        let (verdict, bounds) = answer(&bench, name, n, code);
        assert_eq!(verdict, word, "{name}: {bounds:?}");
        // on the same mesh the bracket of the force does not depend on the demand, up to the
        // tolerance of the solver
        for (b, once) in bounds.into_iter().zip([lower, upper]) {
            assert!(
                (b * n / (100.0 * once) - 1.0).abs() < 2e-4,
                "{name}: {b} at {n} kN, {once} at 100 kN"
            );
        }
    }
}

/// With associated friction the bound without friction decides the verdict. On later meshes it is
/// left out where it reaches the load already. It then stays on the first mesh, and `verify`
/// confirms all three bounds on their meshes.
#[test]
fn the_bound_without_friction_may_stay_on_the_first_mesh() {
    let bench = Bench::new();
    let spec = "template: t_stub\nmembers: {tee: {profile: IPE300, steel: S235}}\nbolts: {size: \
                M16, grade: \"8.8\", gauge: 100, rows: [0]}\nparameters: {length: 100, welded: \
                true, flange_thickness: 12, flange_width: 160, web_height: 30}\nfriction: {mu: \
                0.3, law: associated}\nloads: [{name: ULS1, end: top, at: bolt_plane, N: 20 \
                kN}]\nanalysis: {kind: limit, decide: false, max_passes: 2, target_gap: \
                0.01, max_macro_tets: 1500, mesh: {layers: false}}\n";
    std::fs::write(bench.path().join("stub.yaml"), spec).expect("written");
    let run = bench.run(&["run", "stub.yaml", "--size-factor", "5"]);
    // the lower bound alone is no complete route
    assert_eq!(run.status.code(), Some(3), "{}", String::from_utf8_lossy(&run.stderr));
    let result: Value = serde_json::from_str(&bench.read("stub/result.json")).expect("JSON");
    let case = &result["cases"][0];
    let history = case["history"].as_array().expect("rows");
    assert!(history[0]["static_frictionless"].is_object() && history.len() == 3, "{history:?}");
    assert!(history[1..].iter().all(|h| h["static_frictionless"].is_null()), "{history:?}");
    assert!(case["frictionless"]["lower"].as_f64().is_some_and(|l| l >= 1.0), "{case}");
    let verified = bench.run(&["verify", "stub"]);
    let text = String::from_utf8_lossy(&verified.stdout).into_owned();
    assert_eq!(verified.status.code(), Some(0), "{text}");
    assert_eq!(text.matches("confirmed").count(), 3, "{text}");
}

/// Mmg makes the later meshes of a spec, gmsh where Mmg is missing, with a word. No lower bound of
/// either exceeds an upper bound of the other, both narrow the first bracket, and `verify` confirms
/// them: of the load in limit analysis, of the energy in elastic analysis.
#[test]
fn meshes_of_mmg_and_of_gmsh_bound_the_same_load() {
    remeshed("limit, decide: false");
}

#[test]
fn meshes_of_mmg_and_of_gmsh_bound_the_same_energy() {
    remeshed("elastic");
}

/// Runs a T-stub with both remeshers.
fn remeshed(kind: &str) {
    let bench = Bench::new();
    let spec = format!(
        "template: t_stub\nmembers: {{tee: {{profile: IPE300, steel: S235}}}}\nbolts: {{size: M16, \
         grade: \"8.8\", gauge: 100, rows: [0]}}\nparameters: {{length: 100, welded: true, \
         flange_thickness: 12, flange_width: 160, web_height: 30}}\nfriction: {{mu: 0}}\nloads: \
         [{{name: ULS1, end: top, at: bolt_plane, N: 80 kN}}]\nanalysis: {{kind: {kind}, \
         max_passes: 2, target_gap: 0.01, max_macro_tets: 2500}}\n"
    );
    std::fs::write(bench.path().join("stub.yaml"), spec).expect("written");
    let brackets = [("mmg", None), ("gmsh", Some("no_such_mmg"))].map(|(name, remesher)| {
        let args = ["run", "stub.yaml", "--size-factor", "2", "--out", name];
        let mut command = bench.command(&args);
        if let Some(remesher) = remesher {
            command.env("BRACKET_MMG", remesher);
        }
        let run = command.output().expect("bracket starts");
        let told = String::from_utf8_lossy(&run.stderr).into_owned();
        assert_eq!(run.status.code(), Some(3), "{told}");
        let without = told.contains("gmsh with a map of sizes in place of Mmg");
        assert_eq!(without, remesher.is_some(), "{told}");
        assert!(!told.contains("from here on"), "{told}");
        let verified = bench.run(&["verify", name]);
        let text = String::from_utf8_lossy(&verified.stdout).into_owned();
        assert_eq!(verified.status.code(), Some(0), "{text}");
        let result: Value =
            serde_json::from_str(&bench.read(&format!("{name}/result.json"))).expect("JSON");
        let case = &result["cases"][0];
        let of = |row: &Value| ["lower", "upper"].map(|key| row[key].as_f64().expect("a bound"));
        let (first, last) = (of(&case["history"][0]), of(case));
        assert!(first[0] < last[0] && last[1] < first[1], "{name}: {first:?} {last:?}");
        last
    });
    let [mmg, gmsh] = brackets;
    assert!(mmg[0] <= gmsh[1] && gmsh[0] <= mmg[1], "{mmg:?} {gmsh:?}");
}

/// A T-stub has no checks by code. The complete route of analysis decides it on either side of its
/// resistance: every step holds under less, and the upper bound refuses more without a second
/// analysis. `verify` confirms the numbers of the route and refutes others.
#[test]
fn a_t_stub_is_decided_by_the_route_of_analysis() {
    let bench = Bench::new();
    let spec = |n: f64| {
        format!(
            "template: t_stub\nmembers: {{tee: {{profile: IPE300, steel: S235}}}}\nbolts: {{size: \
             M16, grade: \"8.8\", rows: [0]}}\nparameters: {{length: 80}}\nfriction: {{mu: \
             0}}\nloads: [{{name: PULL, end: top, at: bolt_plane, N: {n} kN}}]\nanalysis: {{kind: \
             limit}}\n"
        )
    };
    for (name, n, code) in [("less", 40.0, 0), ("more", 200.0, 1)] {
        std::fs::write(bench.path().join(format!("{name}.yaml")), spec(n)).expect("written");
        let run = bench.run(&["run", &format!("{name}.yaml"), "--size-factor", "1.5"]);
        let told = String::from_utf8_lossy(&run.stderr).into_owned();
        assert_eq!(run.status.code(), Some(code), "{told}");
    }
    let read = |name: &str| -> Value {
        serde_json::from_str(&bench.read(&format!("{name}/result.json"))).expect("JSON")
    };
    let (less, more) = (read("less"), read("more"));
    assert_eq!(less["judgement"]["route"], "analysis");
    let steps = less["cases"][0]["demand"]["steps"].as_array().expect("the steps");
    let words = |key: &str| steps.iter().map(|s| s[key].as_str().unwrap_or("")).collect::<Vec<_>>();
    let ids = ["scope", "detailing", "strength", "bolts", "strain", "stability", "welds"];
    assert_eq!(words("step"), ids);
    let [proved, estimated] = ["proved", "estimated"];
    let states = [proved, proved, proved, estimated, estimated, estimated, proved];
    assert_eq!(words("state"), states);
    // half of the pull and some prying, by both fields: 0.9 · 800 · 157/1.25 = 90.4 kN are allowed
    let bolt = &less["cases"][1]["evidence"]["bolts"][0]["sections"][0];
    for field in ["by_stress", "by_displacement"] {
        let tension = -bolt[field][2].as_f64().expect("a force");
        assert!(tension.abs() > 20e3 && tension.abs() < 35e3, "{field}: {bolt}");
    }
    assert_eq!(more["cases"].as_array().map(Vec::len), Some(1), "no second analysis");
    for name in ["less", "more"] {
        let verified = bench.run(&["verify", name]);
        let told = String::from_utf8_lossy(&verified.stdout).into_owned();
        assert_eq!(verified.status.code(), Some(0), "{name}: {told}");
    }
    let mut forged = less.clone();
    forged["cases"][1]["evidence"]["plates"][0]["membrane"] = 1e-9.into();
    std::fs::write(bench.path().join("less/result.json"), forged.to_string()).expect("written");
    let refuted = bench.run(&["verify", "less"]);
    let told = String::from_utf8_lossy(&refuted.stdout).into_owned();
    assert!(told.contains("`evidence` is not that of the stored fields: plates"), "{told}");
}
