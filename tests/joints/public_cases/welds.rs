//! Fillet welds: either method, full strength, lengths, compression, steels without β_w.

use super::answer::Answer;
use serde_json::Value;

fn of<'a>(answer: &'a Answer, title: &str, subject: &str) -> &'a Value {
    let mut found = answer.titled(title).into_iter();
    found
        .find(|c| c["subject"].as_str().is_some_and(|s| s.contains(subject)))
        .unwrap_or_else(|| panic!("no `{title}` of `{subject}`"))
}

fn near(check: &Value, key: &str, want: f64) {
    let got = check[key].as_f64().unwrap_or(f64::NAN);
    assert!((got / want - 1.0).abs() < 1e-3, "{key} = {got}, not {want}: {check:#}");
}

/// 280 kN m over 386.5 mm on 281.1 mm: 2577 N/mm. Simplified 10 · 470/(√3 · 0.9 · 1.25) = 2412,
/// directional 10 · 470/(√2 · 0.9 · 1.25) = 2954 N/mm.
#[test]
fn a_flange_weld_that_the_simplified_method_refuses_holds_by_the_directional_one() {
    let answer = Answer::of("01-flange-weld-full-strength.yaml");
    assert_eq!((answer.code, answer.verdict()), (0, "ok"), "{}", answer.said);
    let weld = of(&answer, "fillet weld, directional method", "beam flange");
    near(weld, "demand", 2577.0);
    near(weld, "resistance", 2954.0);
    near(weld, "utilisation", 0.8723);
    let formula = weld["formula"].as_str().unwrap_or_default();
    for words in
        ["4.5.3.3: F_w,Rd", "2412", "4.5.3.2: F_w,Rd", "2954", "l_eff = 2 b − t_w − 2 r − 2 √2 a"]
    {
        assert!(formula.contains(words), "{words}: {formula}");
    }
    // by the letter, 249.4 mm: 2905 N/mm
    let text = Answer::input("01-flange-weld-full-strength.yaml") + "welds: {ends: open}\n";
    let open = Answer::to(&text);
    near(of(&open, "fillet weld, directional method", "beam flange"), "demand", 2904.8);
    // a weld that both methods refuse, and that is weaker than its flange, fails
    let thin = text.replace("flange_weld: 10", "flange_weld: 7");
    let thin = Answer::to(&thin);
    assert_eq!(thin.code, 1, "{}", thin.said);
    // 8.2 mm is more than the 8.112 mm of full strength
    let full = text.replace("flange_weld: 10", "flange_weld: 8.2");
    let full = Answer::to(&full);
    assert_eq!(of(&full, "fillet weld of full strength", "beam flange")["status"], "ok");
}

/// The web brings 240.6 · 7.1 · 235 = 401.4 kN, its weld carries 2 · 240.6 · 4 · 360/√2 = 490 kN.
#[test]
fn a_web_weld_of_full_strength_limits_no_row() {
    let title = "web weld no weaker than the rows in tension";
    let answer = Answer::of("02-web-weld-full-strength.yaml");
    assert_eq!((answer.code, answer.verdict()), (0, "ok"), "{}", answer.said);
    let weld = of(&answer, title, "tension at the top");
    near(weld, "utilisation", 401.43 / 489.97);
    let formula = weld["formula"].as_str().unwrap_or_default();
    assert!(
        formula.contains("401.4 kN") && formula.contains("goes through the flange"),
        "{formula}"
    );
    // 3.3 mm are still as strong as the web, 3.2 mm are not
    let text = Answer::input("02-web-weld-full-strength.yaml");
    for (throat, code) in [("3.3", 0), ("3.2", 1)] {
        let answer = Answer::to(&text.replace("web_weld: 4", &format!("web_weld: {throat}")));
        assert_eq!(answer.code, code, "{throat}: {}", answer.said);
    }
}

/// The flange brings 150 · 10.7 · 235 = 377.2 kN, welds of 4 mm carry 256.2 kN.
#[test]
fn welds_without_a_prepared_contact_carry_the_compression() {
    let answer = Answer::of("43-weld_under_compression.yaml");
    assert_eq!(answer.code, 1, "{}", answer.said);
    let weld = of(&answer, "fillet weld, directional method", "beam flange");
    assert_eq!(weld["status"], "failed");
    near(weld, "utilisation", 377.175 / 256.166);
    let text = Answer::input("43-weld_under_compression.yaml");
    let contact = text.replacen('{', "{\n \"welds\": {\"bearing_in_contact\": true},", 1);
    let contact = Answer::to(&contact);
    let welds = contact.checks().iter().filter(|c| c["topic"] == "welds");
    assert!(welds.clone().count() > 3 && welds.clone().all(|c| c["status"] != "failed"));
    // a smaller compression, within the flange: 34.57 + 100 kN
    let less = Answer::to(&text.replace("-900 kN", "-200 kN"));
    near(
        of(&less, "fillet weld, simplified method", "beam flange"),
        "utilisation",
        134.567e3 / 251.586 / (4.0 * 360.0 / 3f64.sqrt()),
    );
}

/// `check` leaves the welds undecided, `run` refuses; both name the key of the spec.
#[test]
fn a_steel_without_beta_w_is_named_at_its_weld() {
    let name = "08-astm-fillet-weld.yaml";
    let answer = Answer::of(name);
    assert_eq!((answer.code, answer.verdict()), (3, "undecided"), "{}", answer.said);
    let open = of(&answer, "strength of fillet welds", "beam and end plate");
    let words = open["formula"].as_str().unwrap_or_default();
    assert!(words.contains("A36") && words.contains("table of your own"), "{words}");
    let run = |text: &str| {
        let bench = crate::bench::Bench::new();
        Answer::from(bench.file("joint.yaml", text), &["run", "joint.yaml", "--out", "out"])
    };
    let text = Answer::input(name);
    let refused = run(&text);
    assert_eq!(refused.code, 2, "{}", refused.said);
    for words in ["`flange_weld`", "A36", "beta_w", "bracket check"] {
        assert!(refused.said.contains(words), "{words}: {}", refused.said);
    }
    for words in ["WELD_TOP", "throat of 0 mm"] {
        assert!(!refused.said.contains(words), "{words}: {}", refused.said);
    }
    let line = text.lines().position(|l| l.starts_with("parameters")).map_or(0, |l| l + 1);
    assert!(refused.said.contains(&format!("joint.yaml:{line}:")), "{}", refused.said);
    // the welds of the web are named alike
    let web = run(&text.replace("flange_weld", "web_weld"));
    assert!(web.code == 2 && web.said.contains("`web_weld`"), "{}", web.said);
    // a row of one's own with β_w makes them a check
    let table = "# source: own\nstandard,grade,fy_t_le_40_MPa,fu_t_le_40_MPa,fy_t_40_to_80_MPa,\
                 fu_t_40_to_80_MPa,E_MPa,nu,density_kg_per_m3,beta_w\nASTM A36,A36W,250,400,250,\
                 400,210000,0.3,7850,0.9\n";
    let own =
        text.replace("steel: A36", "steel: A36W").replace("template:", "catalog: .\ntemplate:");
    let bench = crate::bench::Bench::new().file("steel.csv", table).file("joint.yaml", own);
    let own = Answer::from(bench, &["check", "joint.yaml", "--out", "out"]);
    assert!(own.titled("strength of fillet welds").is_empty(), "{}", own.said);
    assert!(!own.titled("flange weld no weaker than the joint").is_empty(), "{}", own.said);
}
