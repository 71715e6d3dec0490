//! Input outside the range of the rules is never OK by code, and reductions of the code are made.

use super::answer::Answer;
use serde_json::Value;

const TITLE: &str = "outside the range of the rules";

/// Clauses of the checks of what lies outside the rules.
fn clauses(answer: &Answer) -> Vec<&str> {
    answer.titled(TITLE).into_iter().filter_map(|c| c["clause"].as_str()).collect()
}

fn changed(text: &str, changes: &[(&str, &str)]) -> Answer {
    let text = changes.iter().fold(text.to_owned(), |t, (a, b)| {
        assert!(t.contains(a), "{a} of {t}");
        t.replace(a, b)
    });
    Answer::to(&text)
}

fn number(check: &Value, key: &str) -> f64 {
    check[key].as_f64().unwrap_or_else(|| panic!("{key} of {check}"))
}

fn near(got: f64, want: f64) {
    assert!((got / want - 1.0).abs() < 1e-6, "{got} is not {want}");
}

#[test]
fn bolts_beyond_the_flange_tips_have_no_t_stub() {
    let text = Answer::input("38-wide_plate_50.yaml");
    let case = Answer::of("38-wide_plate_50.yaml");
    assert_eq!((case.code, case.verdict()), (3, "undecided"), "{}", case.said);
    assert!(case.said.contains("beyond the tips of the beam flange"), "{}", case.said);
    // beside a column, and with a small excess
    let column = "beam: {profile: IPE200, steel: S235}, column: {profile: HEB300, steel: S235}";
    for changes in [
        vec![
            ("beam_splice", "beam_to_column_end_plate"),
            ("beam: {profile: IPE200, steel: S235}", column),
            ("parameters: {}", "parameters: {column_stiffeners: false}"),
            ("gauge: 240", "gauge: 160"),
        ],
        vec![("gauge: 240", "gauge: 101")],
    ] {
        let other = changed(&text, &changes);
        assert_eq!(other.verdict(), "undecided", "{}", other.said);
    }
    // at the tips there is a resistance: M_j,Rd is known, and 50 kN m are refused or carried
    let at = changed(&text, &[("gauge: 240", "gauge: 100"), ("My: 50 kN m", "My: 5 kN m")]);
    assert_eq!(at.verdict(), "ok", "{}", at.said);
}

#[test]
fn steels_and_bolts_beyond_the_tables_are_never_ok() {
    let text = Answer::input("40-s690_12.9.yaml");
    let case = Answer::of("40-s690_12.9.yaml");
    assert_eq!((case.code, case.verdict()), (3, "undecided"), "{}", case.said);
    let (steel, bolts) = ("EN 1993-1-8:2005 1.1(1)", "EN 1993-1-8:2005 3.1.1(3), Table 3.1");
    assert_eq!(clauses(&case), [steel, bolts]);
    assert!(case.said.contains("EN 1993-1-12") || case.report.contains("EN 1993-1-12"));
    // each alone
    let strong_bolts = changed(&text, &[("S690Q", "S355")]);
    assert_eq!((clauses(&strong_bolts), strong_bolts.verdict()), (vec![bolts], "undecided"));
    let strong_plate = changed(
        &text,
        &[("S690Q", "S355"), ("steel: S355}\nbolts", "steel: S690Q}\nbolts"), ("12.9", "10.9")],
    );
    assert_eq!((clauses(&strong_plate), strong_plate.verdict()), (vec![steel], "undecided"));
    // S460 and 10.9 are the last ones inside
    let inside = changed(&text, &[("S690Q", "S460M"), ("12.9", "10.9")]);
    assert_eq!((clauses(&inside), inside.verdict()), (vec![], "ok"), "{}", inside.said);
    // ASTM A490 has f_ub = 1040 MPa, A325 has 830
    let foreign = |grade: &str| {
        changed(&text, &[("S690Q", "S355"), ("12.9", grade), ("size: M20", "size: HR M20")])
    };
    assert_eq!(clauses(&foreign("A490")), [bolts]);
    assert!(clauses(&foreign("A325")).is_empty());
}

#[test]
fn holes_beyond_oversize_have_no_resistance_in_bearing_or_slip() {
    let text = Answer::input("41-hole_26_for_M16.yaml");
    let case = Answer::of("41-hole_26_for_M16.yaml");
    assert_eq!((case.code, case.verdict()), (3, "undecided"), "{}", case.said);
    assert_eq!(clauses(&case), ["EN 1090-2:2008 Table 11, EN 1993-1-8:2005 3.6.1(4)"]);
    assert!(case.titled("bearing resistance at a bolt").is_empty());
    // oversize: M16 up to 20 mm, M24 up to 30 mm
    let m24 = [("size: M16", "size: M24"), ("HEB240", "HEB300"), ("gauge: 100", "gauge: 120")];
    for (clearance, more, undecided) in [
        ("4", vec![], false),
        ("4.1", vec![], true),
        ("6", m24.to_vec(), false),
        ("6.1", m24.to_vec(), true),
    ] {
        let hole = format!("hole_clearance: {clearance}");
        let changes: Vec<_> =
            [("hole_clearance: 10", hole.as_str())].into_iter().chain(more).collect();
        let other = changed(&text, &changes);
        assert_eq!(other.verdict() == "undecided", undecided, "{clearance}: {}", other.said);
    }
    // slip that must not occur is as undecided
    let category = changed(
        &text,
        &[
            (
                "size: M16, grade: \"8.8\"",
                "size: HR M16, grade: \"8.8\", preload: 0.7, category: C",
            ),
            ("mu: 0", "mu: 0.3"),
        ],
    );
    let title = "slip of the preloaded bolts at the ultimate limit state (category C)";
    assert_eq!(category.titled(title)[0]["status"], "undecided", "{}", category.said);
}

/// Bolts in holes with 2 mm clearance: 0.85 · 0.6 · 800 · 84.3/1.25 N = 27.5 kN for M12 8.8, the
/// value of published tables; 0.85 · 0.5 · 1000 · 115/1.25 N = 39.1 kN for M14 10.9.
#[test]
fn small_bolts_in_wide_holes_carry_less_shear() {
    let text = Answer::input("41-hole_26_for_M16.yaml");
    let of = |size: &str, grade: &str, clearance: &str| {
        let (size, grade) = (format!("size: {size}"), format!("\"{grade}\""));
        let hole = format!("hole_clearance: {clearance}");
        // L_j = 180 mm is no long joint of M12
        let rows = ("rows: [-90, 90, 190]", "rows: [-90, 90]");
        let changes = [
            ("size: M16", size.as_str()),
            ("\"8.8\"", &grade),
            ("hole_clearance: 10", &hole),
            rows,
        ];
        changed(&text, &changes)
    };
    let shear =
        |a: &Answer| number(a.titled("shear resistance of a bolt, per plane")[0], "resistance");
    let m12 = of("M12", "8.8", "2");
    near(shear(&m12), 0.85 * 0.6 * 800.0 * 84.3 / 1.25);
    assert!((shear(&m12) - 27.5e3).abs() < 50.0);
    near(shear(&of("M14", "10.9", "2")), 0.85 * 0.5 * 1000.0 * 115.0 / 1.25);
    near(shear(&of("M12", "8.8", "1")), 0.6 * 800.0 * 84.3 / 1.25);
    near(shear(&of("M12", "4.6", "2")), 0.6 * 400.0 * 84.3 / 1.25);
    near(shear(&of("M16", "8.8", "2")), 0.6 * 800.0 * 157.0 / 1.25);
    // plates of 15 mm carry more in bearing than the bolts in shear: no reduction of bearing,
    // though the hole is wider than normal
    let inner = |a: &Answer| {
        let all = a.titled("bearing resistance at a bolt");
        let of = all.into_iter().find(|c| c["subject"] == "end plate, inner bolt, vertical force");
        number(of.expect("the check"), "resistance")
    };
    // p1 = 180 mm, d0 = 14 mm: α_b = 1, k1 = 2.5
    near(inner(&m12), 2.5 * 360.0 * 12.0 * 15.0 / 1.25);
    assert_eq!(m12.titled("round holes with 2 mm clearance of small bolts").len(), 1);
    // in a plate of 4 mm with e2 = 20 mm bearing would govern: the holes are oversize; d0 = 16 mm,
    // k1 = 2.8 · 20/16 − 1.7 = 1.8
    let thin = changed(
        &text,
        &[
            ("size: M16", "size: M14"),
            ("\"8.8\"", "\"10.9\""),
            ("clearance: 10", "clearance: 2"),
            ("thickness: 15", "thickness: 4"),
            ("width: 200", "width: 150"),
            ("gauge: 100", "gauge: 110"),
            ("rows: [-90, 90, 190]", "rows: [-90, 90]"),
        ],
    );
    near(inner(&thin), 0.8 * 1.8 * 360.0 * 14.0 * 4.0 / 1.25);
    near(shear(&thin), 0.85 * 0.5 * 1000.0 * 115.0 / 1.25);
}

/// L_j between the outermost rows: β_Lf = 1 − (L_j − 15 d)/(200 d).
#[test]
fn long_joints_carry_less_shear_per_bolt() {
    let of = |rows: &str, size: &str| {
        Answer::to(&format!(
            "template: beam_splice\nmembers: {{beam: {{profile: IPE600, steel: S235}}}}\nplate: \
             {{thickness: 20, width: 220, z: [-310, 310]}}\nbolts: {{size: {size}, grade: \"8.8\", \
             gauge: 110, rows: {rows}}}\nloads: [{{name: U, end: beam_right, at: bolt_plane, My: \
             50 kN m, Vz: -100 kN}}]\n"
        ))
    };
    let shear =
        |a: &Answer| number(a.titled("shear resistance of a bolt, per plane")[0], "resistance");
    // M16: 490 mm > 15 · 16 = 240 mm; M20: 490 mm > 300 mm; M24: 340 mm < 360 mm
    let long = of("[-245, 0, 245]", "M16");
    near(shear(&long), (1.0 - 250.0 / 3200.0) * 0.6 * 800.0 * 157.0 / 1.25);
    near(shear(&of("[-245, 0, 245]", "M20")), (1.0 - 190.0 / 4000.0) * 0.6 * 800.0 * 245.0 / 1.25);
    near(shear(&of("[-170, 0, 170]", "M24")), 0.6 * 800.0 * 353.0 / 1.25);
    let group = &long.titled("shear of the bolt group, reduced for tension")[0];
    assert!(group["formula"].as_str().is_some_and(|f| f.contains("β_Lf")), "{group}");
}

#[test]
fn thicknesses_without_rules_are_undecided_or_refused() {
    let of = |beam: &str, thickness: &str, more: &str| {
        Answer::to(&format!(
            "template: beam_splice\nmembers: {{beam: {{profile: {beam}, steel: S235}}}}\nplate: \
             {{thickness: {thickness}, width: 200, z: [-165, 165], steel: S235}}\nbolts: {{size: \
             M16, grade: \"8.8\", gauge: 80, rows: [-95, 95]}}\n{more}loads: [{{name: U, end: \
             beam_right, at: bolt_plane, My: 1 kN m}}]\n"
        ))
    };
    for thickness in ["4", "80"] {
        let a = of("IPE300", thickness, "");
        assert_eq!((clauses(&a), a.verdict()), (vec![], "ok"), "{thickness}: {}", a.said);
    }
    // the web of an IPE80 is 3.8 mm thick and welded, that of an IPE100 4.1 mm
    let small = |beam: &str| {
        let text = Answer::input("38-wide_plate_50.yaml");
        let rows = ("rows: [-50, 50, 130]", "rows: [0]");
        let bolts = [("IPE200", beam), ("M20", "M12"), ("gauge: 240", "gauge: 44"), rows];
        let rest = [("width: 300", "width: 80"), ("z: [-105, 165]", "z: [-60, 60]")];
        let loads = [("My: 50 kN m", "My: 0.3 kN m"), ("Vz: -20 kN", "Vz: -1 kN")];
        changed(&text, &[bolts.as_slice(), &rest, &loads].concat())
    };
    let (thin, enough) = (small("IPE80"), small("IPE100"));
    assert_eq!((clauses(&thin), thin.verdict()), (vec!["EN 1993-1-8:2005 4.1(1)"], "undecided"));
    assert_eq!((clauses(&enough), enough.verdict()), (vec![], "ok"), "{}", enough.said);
    // a stiffener of 3.5 mm is welded as well
    let column = Answer::input("32-cap_plate_compression.yaml");
    let thin =
        changed(&column, &[("column_stiffener_thickness: 8", "column_stiffener_thickness: 3.5")]);
    assert_eq!(clauses(&thin), ["EN 1993-1-8:2005 4.1(1)"], "{}", thin.said);
    // Table 3.1 ends at 80 mm; the product standard goes on, where the spec asks for it
    let thick = of("IPE300", "85", "");
    assert!(thick.code == 2 && thick.said.contains("Table 3.1"), "{}", thick.said);
    let product = of("IPE300", "85", "code: {fy_source: product_standard}\n");
    assert_eq!(product.verdict(), "ok", "{}", product.said);
}
