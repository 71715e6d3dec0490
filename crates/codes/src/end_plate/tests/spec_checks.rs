//! Hand checks of whole specs: the paper's joint, wrong detailing, other templates, joints that the
//! code does not cover.

use super::fixture::{PAPER, TEMPLATE, checks, find, joint, loaded, notes, of_spec, with};
use crate::check::{Check, CheckId, Status, Topic, Unit};
use crate::end_plate::HandChecks;
use bracket_base::diag::Diagnostic;

#[test]
fn the_paper_joint_fails_no_check() {
    let h = checks(PAPER);
    assert!(
        !h.failed(),
        "{:#?}",
        h.checks.iter().filter(|c| c.status == Status::Failed).collect::<Vec<_>>()
    );
    assert!(h.notes.is_empty(), "{:?}", h.notes);
    let e2 = find(&h, "end plate", "edge distance");
    assert_eq!((e2.demand, e2.resistance, e2.status), (Some(24.0), Some(40.0), Status::Ok));
    assert_eq!(find(&h, "end plate", "end distance").resistance, Some(35.0));
    assert_eq!(find(&h, "end plate", "pitch of the rows").resistance, Some(90.0));
    // 235 mm from the lower to the upper rows, 200 mm are allowed where steel is exposed
    assert_eq!(
        find(&h, "end plate", "pitch of the rows, exposed or compressed steel").status,
        Status::Warning
    );
    assert_eq!(find(&h, "column web", "spanner clearance").status, Status::Ok);
    // grip 30, two washers of 3, nut 15.8, pitch 2.5: the next length is 55
    assert!(
        find(&h, "M18 8.8", "least length of the bolt")
            .formula()
            .to_string()
            .ends_with("order M18 × 55, 6 for each end plate")
    );
    // every value is a number, every formula shows its result
    for c in &h.checks {
        let finite = c
            .values
            .iter()
            .map(|s| s.value)
            .chain(c.demand)
            .chain(c.resistance)
            .all(f64::is_finite);
        assert!(finite && !c.clause.is_empty() && !c.formula().is_empty(), "{c:#?}");
    }
    // in the order of the topics
    assert!(h.checks.windows(2).all(|w| w[0].topic <= w[1].topic));
}

/// Tension at the bottom has the two rows far from the upper flange, so more moment than tension at
/// the top with its one row; both are sums of row forces times lever arms.
#[test]
fn the_component_method_answers_for_both_senses() {
    let h = checks(PAPER);
    let moment = |sense: &str| {
        let c = find(&h, sense, "moment resistance of the joint");
        assert_eq!(
            (c.unit, c.status, c.topic),
            (Unit::Moment, Status::Information, Topic::ComponentMethod)
        );
        let rows = h
            .checks
            .iter()
            .filter(|c| c.subject.to_string().starts_with(sense) && c.id() == CheckId::RowTension);
        let lever =
            |c: &Check| c.values.iter().find(|s| s.symbol == "h_r").map_or(f64::NAN, |s| s.value);
        let sum: f64 = rows.map(|c| lever(c) * c.resistance.unwrap_or(f64::NAN)).sum();
        let value = c.resistance.unwrap_or(f64::NAN);
        assert!((sum / value - 1.0).abs() < 1e-12, "{sum} {value}");
        value
    };
    let (top, bottom) = (moment("tension at the top"), moment("tension at the bottom"));
    assert!(bottom > top && top > 20e6 && bottom < 250e6, "{top} {bottom}");
    for sense in ["tension at the top", "tension at the bottom"] {
        let stiffness = find(&h, sense, "initial rotational stiffness");
        assert_eq!((stiffness.unit, stiffness.topic), (Unit::Rotational, Topic::Stiffness));
    }
}

/// Wrong detailing that the templates accept is reported with distance, limit and clause.
#[test]
fn wrong_detailing_fails_with_its_clause() {
    let wrong = [
        // M18: d0 = 20, e ≥ 24, p1 ≥ 44, p2 ≥ 48
        ("rows: [-215, -125, 110]", "rows: [-227, -125, 110]", "end distance", 23.0),
        ("rows: [-215, -125, 110]", "rows: [-215, -125, -85, 110]", "pitch of the rows", 40.0),
        ("width: 180, z", "width: 170, z", "edge distance", 22.0),
        ("z: [-250, 200]", "z: [-236, 200]", "end distance", 21.0),
    ];
    for (old, new, title, provided) in wrong {
        let mut text = with(old, new);
        if title == "edge distance" {
            text = text.replace("gauge: 100", "gauge: 126");
        }
        let h = checks(&text);
        let failed: Vec<&Check> = h.checks.iter().filter(|c| c.status == Status::Failed).collect();
        assert!(h.failed() && failed.len() == 1, "{new}: {failed:#?}");
        let c = failed[0];
        assert_eq!((c.id().title(), c.resistance), (title, Some(provided)), "{c:#?}");
        assert_eq!(c.clause, "EN 1993-1-8:2005 Table 3.3");
        assert!(
            c.utilisation.is_some_and(|u| u > 1.0) && c.formula().to_string().contains(" < "),
            "{c:#?}"
        );
    }
    // holes made wider ask for wider edges: d0 = 18 + 10
    let h = checks(&with("hole_clearance: 0}", "hole_clearance: 10}"));
    assert_eq!(find(&h, "end plate", "end distance").demand, Some(1.2 * 28.0));
}

/// Two rows outside the flange: the tables of the code do not cover them; the other checks remain.
#[test]
fn joints_that_the_code_does_not_cover_are_reported() {
    let h = checks(
        &with("z: [-250, 200]", "z: [-300, 200]")
            .replace("[-215, -125, 110]", "[-270, -215, -125, 110]"),
    );
    assert_eq!(h.notes.len(), 1, "{:?}", h.notes);
    assert!(
        notes(&h)[0]
            .starts_with("component method, tension at the bottom: two rows or more lie outside"),
        "{:?}",
        h.notes
    );
    assert!(h.checks.iter().any(|c| c.subject.text() == "tension at the top"));
}

/// Wrong values in the `hand_checks` of a template are reported by key.
#[test]
fn wrong_hand_checks_of_a_template_are_reported_by_key() {
    let folder = tempfile::tempdir().expect("a folder");
    let spec = with("template: double_sided_end_plate", "template: mine.yaml");
    let fault = |old: &str, new: &str| -> Diagnostic {
        let (before, entry) = TEMPLATE.split_at(TEMPLATE.find("hand_checks:").expect("the entry"));
        assert_eq!(entry.matches(old).count(), 1, "{old}");
        std::fs::write(
            folder.path().join("mine.yaml"),
            [before, &entry.replace(old, new)].concat(),
        )
        .expect("writable");
        of_spec(&spec, folder.path()).expect_err(new).into_first()
    };
    let wrong = [
        (
            "  column: column\n",
            "  column: post\n",
            "hand_checks.column",
            "there is no member `post`",
        ),
        ("  beam: beam\n", "  beam: beem\n", "hand_checks.beam", "there is no member `beem`"),
        (
            "  rows: bolts.rows\n",
            "  rows: bolts.row\n",
            "hand_checks.rows",
            "did you mean `bolts.rows`",
        ),
        (
            "  rows: bolts.rows\n",
            "  rows: bolts.gauge\n",
            "hand_checks.rows",
            "is not a list parameter",
        ),
        (
            "  thickness: plate.thickness\n",
            "  thickness: 0 mm\n",
            "hand_checks.thickness",
            "it must be above 0",
        ),
        (
            "  gauge: bolts.gauge\n",
            "  gauge: -bolts.gauge\n",
            "hand_checks.gauge",
            "it must be above 0",
        ),
        (
            "  width: plate.width\n",
            "  width: plate.widht\n",
            "hand_checks.width",
            "did you mean `plate.width`",
        ),
        (
            "  top: plate_top\n",
            "  top: plate_bottom - 1 mm\n",
            "hand_checks.top",
            "is not above the lower edge",
        ),
        ("  beta: 0\n", "  beta: 3\n", "hand_checks.beta", "3 does not lie between 0 and 2"),
        ("  beta: 0\n", "  beta: 1 mm\n", "hand_checks.beta", "number"),
        (
            "if(column_ends_above, column_above, 0 mm)",
            "5 kN",
            "hand_checks.column_above",
            "length [mm]",
        ),
        (
            "bolt.d + hole_clearance, bolt.hole)",
            "bolt.d, bolt.d / 2)",
            "hand_checks.hole",
            "at least 18 mm",
        ),
    ];
    for (old, new, at, words) in wrong {
        let d = fault(old, new);
        assert_eq!(d.code, "template/wrong", "{new}: {d:#?}");
        assert!(d.message.contains(at) && d.message.contains(words), "{new}: {d:#?}");
    }
    // keys are checked by the reader
    let d = fault("  gauge: bolts.gauge\n", "");
    assert!(d.message.contains("gauge"), "{d:#?}");
    let d = fault("  beta: 0\n", "  beta: 0\n  betta: 0\n");
    assert!(d.message.contains("betta"), "{d:#?}");
    let d = fault(
        "  steel: [plate, beam]\n  thickness: plate.thickness",
        "  steel: [rib]\n  thickness: plate.thickness",
    );
    assert!(d.message.contains("none of rib has a steel in the spec"), "{d:#?}");
}

/// A beam on one side shears the web panel: β = 1, and the panel is among the limits.
#[test]
fn other_templates_have_the_checks_they_ask_for() {
    let spec = "template: beam_to_column_end_plate\nmembers: {column: {profile: HEB200, steel: \
                S235}, beam: {profile: IPE300, steel: S235}}\nplate: {thickness: 15}\nbolts: \
                {size: M18, grade: \"8.8\", rows: [-90, 90, 190]}\nloads: [{name: ULS1, end: \
                beam_right, at: column_face, My: 40 kN m}]\n";
    let h = checks(spec);
    assert!(!h.failed() && h.notes.is_empty(), "{h:#?}");
    assert_eq!(
        find(&h, "tension at the top", "column web panel in shear").status,
        Status::Information
    );
    let top = find(&h, "tension at the top", "moment resistance of the joint")
        .resistance
        .unwrap_or(f64::NAN);
    let bottom = find(&h, "tension at the bottom", "moment resistance of the joint")
        .resistance
        .unwrap_or(f64::NAN);
    assert!(top > bottom, "the extended side is on top: {top} {bottom}");
}

/// Without the entry there are no hand checks, and no error.
#[test]
fn a_template_without_hand_checks_has_none() {
    let folder = tempfile::tempdir().expect("a folder");
    let start = TEMPLATE.find("hand_checks:").expect("the entry");
    let end = start + TEMPLATE[start..].find("\n\n").expect("its end");
    std::fs::write(
        folder.path().join("mine.yaml"),
        [&TEMPLATE[..start], &TEMPLATE[end..]].concat(),
    )
    .expect("writable");
    let spec = with("template: double_sided_end_plate", "template: mine.yaml");
    assert_eq!(of_spec(&spec, folder.path()).expect("sound"), HandChecks::default());
}

/// A splice has its plates, no column; its bolts reach through both.
#[test]
fn a_splice_has_no_column() {
    let h = checks(
        "template: beam_splice\nmembers: {beam: {profile: IPE300, steel: S235}}\nplate: \
         {thickness: 15}\nbolts: {size: M20, grade: \"8.8\", rows: [-90, 90, 190]}\nloads: \
         [{name: A, end: beam_right, at: bolt_plane, My: 40 kN m}]\n",
    );
    assert!(!h.failed() && h.notes.is_empty(), "{h:#?}");
    assert!(
        h.checks.iter().all(|c| {
            !c.subject.to_string().contains("column") && !c.id().title().contains("column web")
        }),
        "{h:#?}"
    );
    assert!(
        find(&h, "M20 8.8", "least length of the bolt")
            .formula()
            .to_string()
            .contains("l = grip + n_w t_w + nut + pitch = 30 + 2 · 3 + ")
    );
    let elastic = find(&h, "tension at the top", "rotational stiffness for elastic analysis");
    assert!(
        elastic.formula().to_string().ends_with(&format!(
            "/3 = {}",
            Unit::Rotational.show(elastic.resistance.unwrap_or(0.0))
        ))
    );
}

/// Where neither plate nor flange is thin enough for its bolts, the reason states the numbers.
#[test]
fn thick_plates_and_soft_bolts_are_brittle() {
    let text = joint("", "{name: A, end: beam_right, at: bolt_plane, My: 40 kN m}");
    assert_eq!(checks(&text).brittle, None);
    let thick = text
        .replace("thickness: 15", "thickness: 30")
        .replace("profile: HEB200", "profile: HEM200");
    let thick = thick.replace("size: M20, grade: \"8.8\"", "size: M16, grade: \"4.6\"");
    let why = |text: &str| checks(text).brittle.expect("no rule holds").to_string();
    let (why, uk) = (why(&thick), why(&format!("code: {{annex: UK}}\n{thick}")));
    assert!(why.contains("t = 30 mm > 0.36 d") && why.contains("1.9 F_t,Rd"), "{why}");
    assert!(!why.contains("/1.9 = "), "the rule of the UK annex: {why}");
    assert!(uk.contains("t = 25 mm > d √(f_ub/f_y)/1.9 = "), "{uk}");
}

/// A doubler thinner than the web does not count and is reported; one that counts adds b_s t_w to
/// the shear area.
#[test]
fn clause_6_2_6_1_a_doubler_counts_or_is_reported() {
    let load = "{name: A, end: beam_right, at: bolt_plane, My: 40 kN m}";
    let area = |h: &HandChecks| {
        let panel = find(h, "tension at the top", "column web panel in shear");
        panel.values.iter().find(|s| s.symbol == "A_vc").map_or(f64::NAN, |s| s.value)
    };
    let (bare, thin) =
        (loaded(load), checks(&joint("doubler: true, doubler_thickness: 6, rib: true", load)));
    let told = notes(&thin);
    assert!(
        told[0].contains("rib") && told[1].contains("t_s = 6 mm is less than t_wc = 9 mm"),
        "{told:?}"
    );
    assert_eq!(area(&bare), area(&thin));
    let counts = checks(&joint("doubler: true", load));
    assert!((area(&counts) - area(&bare) - 134.0 * 9.0).abs() < 1e-9 && counts.notes.is_empty());
}

/// A plate wider than the column flange is reported with both numbers; columns of bolts outside of
/// the flange are refused before.
#[test]
fn a_plate_wider_than_the_flange_is_a_warning_and_bolts_beside_it_an_error() {
    let load = "{name: ULS1, end: beam_right, at: column_face, My: 40 kN m}";
    let wide = |width: &str, gauge: &str| {
        joint("", load)
            .replace("{thickness: 15}", &format!("{{thickness: 15, width: {width}}}"))
            .replace("rows:", &format!("gauge: {gauge}, rows:"))
    };
    let title = "end plate no wider than the column flange, where it bears";
    let h = checks(&wide("250", "110"));
    let check = find(&h, "end plate", title);
    assert_eq!(
        (check.status, check.demand, check.resistance),
        (Status::Warning, Some(250.0), Some(200.0))
    );
    assert!(
        check.formula().to_string().contains("b_p = 250 mm > b_fc of HEB200 = 200 mm"),
        "{}",
        check.formula()
    );
    assert!(!h.failed(), "{h:#?}");
    let h = checks(&wide("200", "110"));
    assert!(h.checks.iter().all(|c| c.id().title() != title));
    let d = of_spec(&wide("300", "220"), std::path::Path::new("."))
        .expect_err("bolts beside the flange")
        .into_first();
    assert_eq!((d.code, d.place.path.as_deref()), ("spec/rule", Some("bolts.gauge")));
    for words in ["gauge 220 mm", "300 mm wide", "column flange (200 mm wide)"] {
        assert!(d.message.contains(words), "{d:#?}");
    }
}

/// The shipped examples are sound joints: none of their hand checks fails.
#[test]
fn the_examples_fail_no_check() {
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples");
    let mut seen = 0;
    for entry in std::fs::read_dir(folder).expect("the examples") {
        let path = entry.expect("an example").path().join("joint.yaml");
        let Ok(text) = std::fs::read_to_string(&path) else { continue };
        let h = checks(&text);
        seen += 1;
        let failed: Vec<_> =
            h.checks.iter().filter(|c| c.status == Status::Failed).map(Check::sentence).collect();
        assert!(failed.is_empty(), "{}: {failed:#?}", path.display());
    }
    assert!(seen >= 5, "{seen}");
}
