//! The printout: checks that need no load stand once, and a checker can compute M_j,Rd again from
//! the numbers of the component method.

use super::answer::Answer;
use crate::bench::Bench;
use serde_json::Value;
use std::path::Path;

fn number(v: &Value) -> f64 {
    v.as_f64().expect("a number")
}

/// The value of a symbol among steps.
fn step(steps: &Value, symbol: &str) -> Option<f64> {
    let all = steps.as_array().expect("values");
    all.iter().find(|s| s["symbol"] == symbol).map(|s| number(&s["value"]))
}

fn near(what: &str, found: f64, printed: f64) {
    let scale = found.abs().max(printed.abs()).max(1e-9);
    assert!((found - printed).abs() <= 1e-3 * scale, "{what}: {found} beside printed {printed}");
}

/// F_T,Rd of Table 6.2 from the printed numbers of a T-stub and F_t,Rd of a bolt.
fn t_stub(stub: &Value, bolt: f64, gamma_m0: f64) -> f64 {
    let of = |key: &str| number(&stub[key]);
    let (m, n, t, fy) = (of("m"), of("n"), of("thickness"), of("fy"));
    let rows = of_rows(stub);
    let bolts = 2.0 * (rows.1 - rows.0 + 1) as f64 * bolt;
    let plastic = |length: f64| 0.25 * length * t * t * fy / gamma_m0;
    let one = plastic(of("circular").min(of("straight")));
    let two = plastic(of("straight"));
    if stub["prying"] == false {
        return (2.0 * one / m).min(bolts);
    }
    (4.0 * one / m).min((2.0 * two + n * bolts) / (m + n)).min(bolts)
}

fn of_rows(stub: &Value) -> (usize, usize) {
    let row = |i: usize| stub["rows"][i].as_u64().expect("a row") as usize;
    (row(0), row(1))
}

/// Resistance of a limit of the sum of the rows, as far as its formula is here.
fn limit(record: &Value, limit: &Value, gamma_m0: f64) -> f64 {
    let printed = number(&limit["resistance"]);
    let values = &limit["values"];
    let web_fy = || {
        let stubs = record["stubs"].as_array().expect("stubs");
        let web = stubs.iter().find(|s| s["web"]["part"] == "column web").expect("a column web");
        number(&web["web"]["fy"])
    };
    match limit["part"].as_str().expect("a part") {
        // 6.2.6.1, formulas 6.7 and 6.8, over β
        "column web panel in shear" if limit["clause"] == "EN 1993-1-8:2005 6.2.6.1" => {
            let area = step(values, "A_vc").expect("A_vc");
            let added = match ["M_pl,fc,Rd", "M_pl,st,Rd", "d_s"].map(|s| step(values, s)) {
                [Some(flange), Some(stiffener), Some(distance)] => {
                    (4.0 * flange).min(2.0 * flange + 2.0 * stiffener) / distance
                }
                _ => 0.0,
            };
            let panel = 0.9 * web_fy() * area / (3f64.sqrt() * gamma_m0) + added;
            let found = panel / number(&record["beta"]);
            near("panel", found, printed);
            found
        }
        // 6.2.6.7, formula 6.21
        "beam flange and web in compression" => {
            let [moment, lever] = ["M_c,Rd", "h − t_fb"].map(|s| step(values, s).expect(s));
            assert!(printed <= 1.001 * moment / lever, "{limit}");
            printed
        }
        _ => printed,
    }
}

/// M_j,Rd by 6.2.7.2 from the printed numbers of a record, all on the way compared.
fn moment(record: &Value) -> f64 {
    let (bolt, gamma_m0) = (number(&record["bolt"]), number(&record["gamma_m0"]));
    let mut parts: Vec<((usize, usize), f64)> = Vec::new();
    for stub in record["stubs"].as_array().expect("stubs") {
        let flange = t_stub(stub, bolt, gamma_m0);
        near("T-stub", flange, number(&stub["resistance"]));
        parts.push((of_rows(stub), flange));
        let web = &stub["web"];
        if !web.is_null() {
            let of = |key: &str| number(&web[key]);
            let found = of("omega") * of("width") * of("thickness") * of("fy") / gamma_m0;
            near("web", found, of("resistance"));
            let length = number(&stub["circular"]).min(number(&stub["straight"]));
            near("b_eff", length, of("width"));
            parts.push((of_rows(stub), found));
        }
    }
    let rows = record["rows"].as_array().expect("rows");
    let limits = record["limits"].as_array().expect("limits");
    let mut left = limits.iter().map(|l| limit(record, l, gamma_m0)).fold(f64::INFINITY, f64::min);
    let (mut before, mut total): (Vec<(f64, f64)>, f64) = (Vec::new(), 0.0);
    for (r, row) in rows.iter().enumerate() {
        let lever = number(&row["lever"]);
        let mut force = f64::INFINITY;
        for ((first, last), value) in parts.iter().filter(|p| p.0.1 == r + 1) {
            let above: f64 = before[first - 1..last - 1].iter().map(|b| b.1).sum();
            force = force.min(value - above);
        }
        // 6.2.7.2(9)
        for (h, above) in before.iter().filter(|b| b.1 > 1.9 * bolt) {
            force = force.min(above * lever / h);
        }
        force = force.max(0.0);
        before.push((lever, force));
        let carried = force.min(left).max(0.0);
        near("row", carried + 1.0, number(&row["force"]) + 1.0);
        left -= carried;
        total += lever * carried;
        stiffness(row, record["beta"] == 0.0 && limits.len() == 1);
    }
    total
}

/// k_eff,r of 6.3.3.1 from the coefficients of the row; a splice has two end plates.
fn stiffness(row: &Value, splice: bool) {
    let k = |symbol: &str| step(&row["stiffness"], symbol);
    let mut flexible: f64 =
        ["k3", "k4", "k5", "k10"].iter().filter_map(|s| k(s)).map(|k| 1.0 / k).sum();
    if splice && k("k3").is_none() {
        flexible += 1.0 / k("k5").expect("k5");
    }
    near("k_eff", 1.0 / flexible, k("k_eff").expect("k_eff"));
}

/// Every sense of bending of an answer; also that the report prints the same numbers.
fn recomputed(answer: &Answer) -> usize {
    let records = answer.result["component_method"].as_array().expect("records");
    for record in records {
        near("M_j,Rd", moment(record), number(&record["moment"]));
        let formula = record["formula"].as_str().expect("a formula");
        assert!(answer.report.contains(formula), "{formula}");
    }
    records.len()
}

fn example(name: &str) -> Answer {
    let file = format!("{}/examples/{name}/joint.yaml", env!("CARGO_MANIFEST_DIR"));
    assert!(Path::new(&file).exists());
    Answer::from(Bench::new(), &["check", &file, "--out", "out"])
}

/// M_j,Rd of the examples by hand from the printed numbers, to 1e-3.
#[test]
fn a_checker_computes_the_resistance_again_from_the_printed_numbers() {
    for name in [
        "double_sided",
        "one_sided_stiffened",
        "one_sided_unstiffened",
        "splice_extended",
        "splice_flush",
    ] {
        let answer = example(name);
        assert!(recomputed(&answer) >= 2, "{name}: both senses");
        let checks = answer.titled("moment resistance of the joint");
        for record in answer.result["component_method"].as_array().expect("records") {
            let same = checks.iter().find(|c| c["subject"] == record["subject"]);
            near(name, number(&same.expect("its check")["resistance"]), number(&record["moment"]));
        }
        // the columns of the table of T-stubs
        let head = answer.report.lines().find(|l| l.contains("ℓ_eff,cp") && l.starts_with('|'));
        let head = head.expect("a table of T-stubs");
        for column in ["m", "e", "n", "m2", "α", "ℓ_eff,cp", "ℓ_eff,nc", "mode", "ω"] {
            assert!(head.contains(&format!("| {column} |")), "{column}: {head}");
        }
    }
}

/// Joints with and without stiffeners, of one and of two beams, by a fixed rule of numbers.
#[test]
fn random_joints_can_be_computed_again() {
    let mut state = 20_261_125_u64;
    let mut pick = |of: &[&'static str]| {
        state =
            state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        of[(state >> 33) as usize % of.len()]
    };
    let mut found = 0;
    for _ in 0..10 {
        let column = pick(&["HEB200", "HEB260", "HEA300"]);
        let beam = pick(&["IPE300", "IPE360", "IPE400"]);
        let steel = pick(&["S235", "S355"]);
        let plate = pick(&["12", "15", "20", "25"]);
        let bolt = pick(&["M16", "M20", "M24"]);
        let stiffeners = pick(&["true", "false"]);
        let end = pick(&["[-90, 90]", "[-95, 40, 100]", "[-90, 20, 90]"]);
        let moment = pick(&["30", "-45", "60"]);
        let text = format!(
            "template: beam_to_column_end_plate\nmembers: {{column: {{profile: {column}, steel: \
             {steel}}}, beam: {{profile: {beam}, steel: S235}}}}\nplate: {{thickness: {plate}, \
             width: 200}}\nbolts: {{size: {bolt}, grade: \"8.8\", gauge: 110, rows: \
             {end}}}\nparameters: {{column_stiffeners: {stiffeners}}}\nloads: [{{name: U, end: \
             beam_right, at: column_face, My: {moment} kN m, Vz: 20 kN}}]\n"
        );
        let answer = Answer::to(&text);
        assert!(matches!(answer.code, 0 | 1 | 3), "{text}\n{}", answer.said);
        found += recomputed(&answer);
    }
    assert!(found >= 16, "{found} senses of bending");
}

/// A check of a load case changes with its load; one that does not has no load case. Here the
/// welds of a splice under three moments.
#[test]
fn a_check_that_needs_no_load_stands_once() {
    let answer = Answer::of("11-repeated-checks.yaml");
    for title in ["least throat", "least effective length"] {
        let found = answer.titled(title);
        assert_eq!(found.len(), 2, "flange and web");
        assert!(found.iter().all(|c| c.get("case").is_none()), "{found:?}");
        let line = |l: &&str| l.starts_with("| all |") && l.contains(title);
        assert_eq!(answer.report.lines().filter(line).count(), 1, "{title}");
    }
    none_repeats(&answer);
    // a strength heads the list, not a throat that is just large enough
    let head = "| case | check | required |";
    let first = answer.report.lines().skip_while(|l| !l.starts_with(head)).nth(2).expect("a row");
    assert!(first.contains("**") && !first.contains("least"), "{first}");
    // a throat below its least value fails in one line
    let thin = Answer::input("11-repeated-checks.yaml").replace("web_weld: 3", "web_weld: 2");
    let thin = Answer::to(&thin);
    assert_eq!(thin.code, 1, "{}", thin.said);
    let bullets = thin.report.lines().filter(|l| l.starts_with("- ") && l.contains("least throat"));
    assert_eq!(bullets.count(), 1, "{}", thin.report);
}

/// The same of a stiffened column, whose stiffeners have welds as well, and of one with a doubler.
#[test]
fn stiffeners_and_doublers_do_not_repeat_their_throats() {
    for more in ["stiffener_weld: 4", "stiffener_weld: 4, doubler: true, doubler_weld: 8"] {
        let text = format!(
            "template: beam_to_column_end_plate\nmembers: {{column: {{profile: HEB200, steel: \
             S235}}, beam: {{profile: IPE300, steel: S235}}}}\nplate: {{thickness: 15, width: \
             180}}\nbolts: {{size: M20, grade: \"8.8\", gauge: 100, rows: [-95, 95]}}\nparameters: \
             {{column_stiffeners: true, flange_weld: 6, web_weld: 4, {more}}}\nloads:\n  - {{name: \
             A, end: beam_right, at: column_face, My: 20 kN m, Vz: 20 kN}}\n  - {{name: B, end: \
             beam_right, at: column_face, My: 31 kN m, Vz: 33 kN}}\n"
        );
        let answer = Answer::to(&text);
        assert!(answer.code < 2, "{}", answer.said);
        assert!(!answer.titled("least throat").is_empty());
        none_repeats(&answer);
    }
}

/// No check of a load case has the same demand in all of several cases, unless it is zero.
fn none_repeats(answer: &Answer) {
    let checks = answer.checks();
    let loaded = checks.iter().filter(|c| c["case"].is_string() && c["demand"].is_number());
    for check in loaded {
        let same = |c: &&Value| {
            ["title", "subject", "demand", "resistance"].iter().all(|k| c[k] == check[k])
        };
        let repeats = checks.iter().filter(same).count();
        assert!(repeats == 1 || number(&check["demand"]) == 0.0, "{check}");
    }
}

/// Case 07: an elastic analysis calls one number the initial stiffness, S_j,ini of 6.3.1, and no
/// mark of Markdown is left on the page.
#[test]
fn one_number_is_the_initial_stiffness() {
    let bench = Bench::new().file("joint.yaml", Answer::input("07-stiffness-text.yaml"));
    let coarse = ["run", "joint.yaml", "--out", "out", "--size-factor", "3", "--max-passes", "1"];
    let answer = Answer::from(bench, &coarse);
    let stiffness = &answer.result["cases"][0]["joint_stiffness"];
    let (lower, by_hand) = (number(&stiffness["lower"]), number(&stiffness["component_method"]));
    assert!(lower > 0.0 && by_hand > 0.0, "{stiffness}");
    let said: Vec<&str> = answer.report.split("initial stiffness S_j,ini").collect();
    assert_eq!(said.len(), 2, "{}", answer.report);
    // the method's value stands in the same paragraph, under the same name
    assert!(said[1].lines().next().is_some_and(|l| l.contains("kN m/rad")), "{}", said[1]);
    let page = std::fs::read_to_string(answer.bench.path().join("out/report.html")).expect("HTML");
    // the script of the page has a power written so
    let text: String = page
        .split("<script")
        .map(|s| s.split_once("</script>").map_or(s, |(_, rest)| rest))
        .collect();
    assert!(!text.contains("**"), "a mark of Markdown");
    assert!(page.contains("initial stiffness"));
}
