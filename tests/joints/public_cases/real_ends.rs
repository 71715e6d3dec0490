//! Ends of a column: bearing, block tearing, compressed zones and welds of stiffeners see where it
//! really ends.

use super::answer::Answer;
use serde_json::Value;

/// The check with a title and a subject that begins with `subject`.
fn check(answer: &Answer, title: &str, subject: &str) -> Value {
    let found = answer
        .titled(title)
        .into_iter()
        .find(|c| c["subject"].as_str().is_some_and(|s| s.starts_with(subject)));
    found.unwrap_or_else(|| panic!("`{title}` of `{subject}`: {}", answer.said)).clone()
}

fn number(check: &Value, key: &str) -> f64 {
    check[key].as_f64().unwrap_or_else(|| panic!("{key} of {check}"))
}

fn near(got: f64, want: f64) {
    assert!((got / want - 1.0).abs() < 1e-6, "{got} is not {want}");
}

const BEARING: &str = "bearing resistance at a bolt";

/// e1 = 32 mm, d0 = 22 mm: α_d = 32/66, k1 = 2.5. F_b,Rd = 2.5 · 0.4848 · 360 · 20 · 9.5/1.25 N =
/// 66.33 kN in the column flange; without an end 136.8 kN.
const AT_THE_END: f64 = 2.5 * (32.0 / 66.0) * 360.0 * 20.0 * 9.5 / 1.25;
const FAR: f64 = 2.5 * 360.0 * 20.0 * 9.5 / 1.25;

#[test]
fn the_real_end_of_the_column_is_an_end_distance_of_its_flange() {
    let down = Answer::of("30-bearing_hanging_column2.yaml");
    let bearing = check(&down, BEARING, "column flange, beam_right");
    near(number(&bearing, "resistance"), AT_THE_END);
    assert!((number(&bearing, "utilisation") - 1.25).abs() < 0.005, "{bearing}");
    assert_eq!((down.code, down.verdict()), (1, "not_ok"), "{}", down.said);
    // two blocks of the flange: 307 − 1.5 · 22 mm in shear, 40 − 11 mm in tension
    let blocks = 2.0 * 9.5 * (360.0 * 29.0 / 1.25 + 235.0 * 274.0 / 3f64.sqrt());
    near(number(&check(&down, "block tearing", "column flange"), "resistance"), blocks);
}

#[test]
fn the_end_counts_where_the_force_points_to_it_and_where_it_is_real() {
    let text = Answer::input("30-bearing_hanging_column2.yaml");
    let of = |changes: &[(&str, &str)]| {
        let changed = changes.iter().fold(text.clone(), |t, (a, b)| {
            assert!(t.contains(a), "{a}");
            t.replace(a, b)
        });
        Answer::to(&changed)
    };
    // the same joint upside down
    let above = of(&[
        ("z: [-212, 165]", "z: [-165, 212]"),
        ("rows: [-180, 95]", "rows: [-95, 180]"),
        (
            "column_ends_below: true, column_below: 212",
            "column_ends_above: true, column_above: 212",
        ),
        ("Vz: -330 kN", "Vz: 330 kN"),
        ("My: 1 kN m", "My: -1 kN m"),
    ]);
    near(number(&check(&above, BEARING, "column flange, beam_right"), "resistance"), AT_THE_END);
    assert_eq!(above.verdict(), "not_ok");
    // an uplift presses the flange away from its end; a column that continues has none, however
    // short the modelled piece is
    for change in [("Vz: -330 kN", "Vz: 330 kN"), ("ends_below: true", "ends_below: false")] {
        let other = of(&[change]);
        let bearing = check(&other, BEARING, "column flange, beam_right");
        near(number(&bearing, "resistance"), FAR);
        assert_eq!(bearing["status"], "ok");
        assert!(
            other.titled("block tearing").iter().all(|c| c["subject"] == "end plate, beam_right"),
            "nothing tears out of a column that goes on"
        );
    }
}

/// HEB200 with stiffeners of 8 mm, 95.5 mm wide, and 15 ε t_w = 135 mm of web on either side as far
/// as the column reaches: the stiffeners end at z = 148.65 mm.
#[test]
fn the_web_beside_a_cap_plate_counts_as_far_as_it_goes() {
    let text = Answer::input("32-cap_plate_compression.yaml");
    let area = |web: f64| 2.0 * 95.5 * 8.0 + (135.0 + 8.0 + web) * 9.0;
    let title = "stiffened column web in compression";
    let resistance = |a: &Answer| number(&check(a, title, "tension at the bottom"), "resistance");
    let case = Answer::of("32-cap_plate_compression.yaml");
    near(resistance(&case), 235.0 * area(155.0 - 148.65));
    assert!((resistance(&case) - 675e3).abs() < 0.5e3);
    for (change, web) in [
        (("column_above: 155", "column_above: 200"), 200.0 - 148.65),
        (("column_above: 155", "column_above: 400"), 135.0),
        (("column_ends_above: true", "column_ends_above: false"), 135.0),
    ] {
        near(resistance(&Answer::to(&text.replace(change.0, change.1))), 235.0 * area(web));
    }
    // between the two pairs of stiffeners each has half of the web: 140.65 mm of 15 t_w = 315 mm
    let thick = text.replace("HEB200", "HEM300").replace("gauge: 100", "gauge: 120");
    let area = 289.0 * 8.0 + (140.65 + 8.0 + 155.0 - 148.65) * 21.0;
    near(resistance(&Answer::to(&thick)), 235.0 * area);
}

/// 6.35 mm of column above the stiffeners have room for fillets with a leg of 5.66 mm (a = 4 mm),
/// not of 7.07 mm (a = 5 mm): two seams are left of four. Each is (200 − 9)/2 − 23 − 2 a long and
/// carries a · 360/(√3 · 0.8 · 1.25).
#[test]
fn stiffeners_at_an_end_have_welds_where_there_is_room() {
    let text = Answer::input("32-cap_plate_compression.yaml");
    let of = |weld: &str, end: &str| {
        let text = text.replace("stiffener_weld: 0", &format!("stiffener_weld: {weld}"));
        let answer = Answer::to(&text.replace("column_above: 155", end));
        let title = "fillet welds of the column stiffeners";
        number(
            &check(&answer, title, "beam_right, compressed stiffeners to the column flange"),
            "resistance",
        )
    };
    let welds = |count: f64, a: f64| count * (72.5 - 2.0 * a) * a * 360.0 / 3f64.sqrt();
    near(of("4", "column_above: 155"), welds(4.0, 4.0));
    near(of("5", "column_above: 155"), welds(2.0, 5.0));
    near(of("5", "column_above: 160"), welds(4.0, 5.0));
}
