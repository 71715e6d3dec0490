//! What a national annex changes is done, or listed as not covered.

use super::answer::Answer;

/// M_j,Rd with tension at the top \[kN m\].
fn moment(answer: &Answer) -> f64 {
    let found = answer.titled("moment resistance of the joint").into_iter();
    let mut top = found.filter(|c| c["subject"] == "tension at the top");
    top.next().and_then(|c| c["resistance"].as_f64()).unwrap_or(f64::NAN) / 1e6
}

/// Plate 22 mm and flange 32 mm with M20 8.8 on S275: 20/1.9 · √(800/275) = 17.95 mm.
#[test]
fn the_uk_annex_limits_the_rows_by_a_triangle_where_nothing_is_thin() {
    let answer = Answer::of("37-uk_na27.yaml");
    assert!((moment(&answer) / 260.0 - 1.0).abs() < 0.01, "{}", moment(&answer));
    let text = Answer::input("37-uk_na27.yaml");
    // without the annex, and with one that has no such rule, the rows are plastic
    for annex in ["recommended", "FR"] {
        let other = Answer::to(&text.replace("\"UK\"", &format!("\"{annex}\"")));
        assert!((moment(&other) / 360.0 - 1.0).abs() < 0.01, "{annex}: {}", moment(&other));
    }
    // a plate of 17 mm is thin enough
    let thin = text.replace("\"thickness\": 22", "\"thickness\": 17");
    let plain = Answer::to(&thin.replace("\"UK\"", "\"recommended\""));
    assert_eq!(moment(&Answer::to(&thin)), moment(&plain));
    // f_y of the product standard is not used: said
    assert_eq!(answer.titled("yield strengths by the product standard").len(), 1);
    assert!(answer.report.contains("not covered"), "{}", answer.report);
}

/// √50 − 0.5 = 6.571 mm.
#[test]
fn the_german_annex_has_a_least_throat_on_thick_plates() {
    let title = "least throat beside the thicker part";
    let answer = Answer::of("42-de_a3_on_50mm.yaml");
    assert_eq!(answer.code, 1, "{}", answer.said);
    let failed = answer.titled(title);
    assert_eq!(failed.len(), 2, "{failed:#?}");
    assert!(failed.iter().all(|c| c["status"] == "failed"), "{failed:#?}");
    let text = Answer::input("42-de_a3_on_50mm.yaml");
    let thick = text.replace("\"flange_weld\": 5", "\"flange_weld\": 6.6");
    let thick = Answer::to(&thick.replace("\"web_weld\": 3", "\"web_weld\": 6.6"));
    assert!(thick.titled(title).iter().all(|c| c["status"] == "ok"), "{}", thick.said);
    let class = Answer::to(&text.replace("\"8.8\"", "\"6.8\""));
    assert_eq!(class.titled("bolt class of the annex").len(), 1, "{}", class.said);
}
