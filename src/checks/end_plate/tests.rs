//! Hand checks of the paper's joint from its spec, and of specs whose detailing is wrong.

use super::{HandChecks, hand_checks};
use crate::assembly::build;
use crate::catalog::Catalog;
use crate::checks::check::{Check, Status, Topic, Unit};
use crate::diag::{Diagnostic, Diagnostics};
use crate::spec::{ConnectionSpec, yaml};
use std::path::Path;

const PAPER: &str = include_str!("../../../examples/paper_joint/joint.yaml");
const TEMPLATE: &str = include_str!("../../../templates/double_sided_end_plate.yaml");

fn of_spec(text: &str, base: &Path) -> Result<HandChecks, Diagnostics> {
    let spec = yaml::parse::<ConnectionSpec>(text, Path::new("joint.yaml"))?;
    let joint = build(&spec, base, &Catalog::builtin().expect("the shipped catalogue is sound"))?;
    Ok(joint.end_plate.as_ref().map(hand_checks).unwrap_or_default())
}

pub(super) fn checks(text: &str) -> HandChecks {
    of_spec(text, Path::new(".")).unwrap_or_else(|faults| panic!("{faults:#?}"))
}

/// The paper's spec with one piece of text replaced.
fn with(old: &str, new: &str) -> String {
    assert_eq!(PAPER.matches(old).count(), 1, "`{old}`");
    PAPER.replace(old, new)
}

pub(super) fn find<'a>(h: &'a HandChecks, subject: &str, title: &str) -> &'a Check {
    let found = h.checks.iter().find(|c| c.subject.starts_with(subject) && c.title == title);
    found.unwrap_or_else(|| panic!("no `{title}` of `{subject}` in {:#?}", h.checks))
}

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
    assert_eq!(find(&h, "column web", "room for a wrench").status, Status::Ok);
    // grip 30, two washers of 3, nut 15.8, pitch 2.5: the next length is 55
    assert!(
        find(&h, "M18 8.8", "least length of the bolt")
            .formula
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
        assert!(finite && !c.clause.is_empty() && !c.formula.is_empty(), "{c:#?}");
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
            .filter(|c| c.subject.starts_with(sense) && c.title == "tension resistance of a row");
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

/// Wrong detailing that the templates let pass is told by distance, limit and clause.
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
        assert_eq!((c.title.as_str(), c.resistance), (title, Some(provided)), "{c:#?}");
        assert_eq!(c.clause, "EN 1993-1-8:2005 Table 3.3");
        assert!(c.utilisation.is_some_and(|u| u > 1.0) && c.formula.contains(" < "), "{c:#?}");
    }
    // holes made wider ask for wider edges: d0 = 18 + 10
    let h = checks(&with("hole_clearance: 0}", "hole_clearance: 10}"));
    assert_eq!(find(&h, "end plate", "end distance").demand, Some(1.2 * 28.0));
}

/// Two rows outside the flange: the code's tables end, the rest of the checks stands.
#[test]
fn what_the_code_does_not_cover_is_said() {
    let h = checks(
        &with("z: [-250, 200]", "z: [-300, 200]")
            .replace("[-215, -125, 110]", "[-270, -215, -125, 110]"),
    );
    assert_eq!(h.notes.len(), 1, "{:?}", h.notes);
    assert!(
        h.notes[0]
            .starts_with("component method, tension at the bottom: two rows or more lie outside"),
        "{:?}",
        h.notes
    );
    assert!(h.checks.iter().any(|c| c.subject == "tension at the top"));
}

/// A template's `hand_checks` that make no sense are told by key.
#[test]
fn wrong_hand_checks_of_a_template_are_told_by_key() {
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

/// A one-sided joint with the given loads.
pub(super) fn loaded(loads: &str) -> HandChecks {
    checks(&joint("", loads))
}

pub(super) fn joint(more: &str, loads: &str) -> String {
    format!(
        "template: beam_to_column_end_plate\nmembers: {{column: {{profile: HEB200, steel: S235}}, \
         beam: {{profile: IPE300, steel: S235}}}}\nplate: {{thickness: 15}}\nbolts: {{size: M20, \
         grade: \"8.8\", rows: [-90, 90, 190]}}\nparameters: {{{more}}}\nloads: [{loads}]\n"
    )
}

const M20: (f64, f64) = (0.9 * 800.0 * 245.0 / 1.25, 0.6 * 800.0 * 245.0 / 1.25);

/// The moment at the bolt plane is that of the node less the shear force times half of the column's
/// depth, for beams on both sides; given at the face it is the same.
#[test]
fn actions_are_moved_to_the_bolt_plane() {
    let at = |end: &str, at: &str, my: f64| {
        format!("{{name: A, end: {end}, at: {at}, My: {my} kN m, Vz: -80 kN, N: 10 kN}}")
    };
    for (end, more) in [("beam_right", ""), ("beam_left", "double_sided: true")] {
        let [node, face] = [("node", 60.0), ("column_face", 60.0 - 0.1 * 80.0)]
            .map(|(point, my)| checks(&joint(more, &at(end, point, my))).comparisons.remove(0));
        assert!((node.demand - 52e6).abs() < 1.0, "{}", node.demand);
        assert!(
            (node.demand / face.demand - 1.0).abs() < 1e-12 && node.resistance == face.resistance
        );
    }
}

/// β from the moments at the node, each in its beam's own sense: 5.3(8).
#[test]
fn clause_5_3_8_beta_of_two_beams() {
    let cases = [
        (100.0, 100.0, [0.0, 0.0]),
        (100.0, -100.0, [2.0, 2.0]),
        (100.0, 40.0, [0.6, 1.5]),
        (100.0, 0.0, [1.0, 2.0]),
        (100.0, -300.0, [2.0, 4.0 / 3.0]),
    ];
    for (right, left, want) in cases {
        let load = |end: &str, my: f64| {
            format!("{{name: A, end: {end}, at: node, My: {my} kN m, N: 1 kN}}")
        };
        let loads = [load("beam_right", right), load("beam_left", left)].join(", ");
        let found: Vec<f64> = checks(&joint("double_sided: true", &loads))
            .comparisons
            .iter()
            .map(|c| c.beta)
            .collect();
        assert!(
            found.iter().zip(want).all(|(a, b)| (a - b).abs() < 1e-12),
            "{right} {left}: {found:?}"
        );
    }
    assert_eq!(
        loaded("{name: A, end: beam_right, at: node, My: 40 kN m}").comparisons[0].beta,
        1.0
    );
}

/// Without a moment every bolt carries the shear force; with one, bolts in tension carry what Table
/// 3.4 leaves, so that every bolt of a row meets the interaction exactly where the sum of them
/// does.
#[test]
fn clause_6_2_2_shear_goes_where_tension_leaves_room() {
    let h = loaded("{name: A, end: beam_right, at: bolt_plane, Vz: -100 kN}");
    let shear = find(&h, "beam_right", "shear of all bolts, with what their tension leaves");
    let (resistance, used) =
        (shear.resistance.unwrap_or(f64::NAN), shear.utilisation.unwrap_or(f64::NAN));
    assert!((resistance / (6.0 * M20.1) - 1.0).abs() < 1e-12, "{resistance}");
    assert!(
        (used / (100e3 / (6.0 * M20.1)) - 1.0).abs() < 1e-12 && shear.case.as_deref() == Some("A"),
        "{used}"
    );
    let h = loaded("{name: A, end: beam_right, at: bolt_plane, Vz: -400 kN, My: 50 kN m}");
    let shear = find(&h, "beam_right", "shear of all bolts, with what their tension leaves");
    let left: f64 = shear.values.iter().map(|s| 2.0 * (1.0 - s.value / (1.4 * M20.0))).sum();
    assert!(
        (shear.resistance.unwrap_or(f64::NAN) / (left * M20.1) - 1.0).abs() < 1e-12,
        "{shear:#?}"
    );
    assert!(shear.values.iter().all(|s| (0.0..=M20.0).contains(&s.value)), "{shear:#?}");
    let total = shear.utilisation.unwrap_or(f64::NAN);
    let both = find(&h, "beam_right, row", "shear and tension of a bolt");
    let most = shear.values.iter().map(|s| s.value).fold(0.0, f64::max);
    // u (1 − t) + t with t = F_t,Ed/(1.4 F_t,Rd)
    let t = most / (1.4 * M20.0);
    assert!(
        (both.utilisation.unwrap_or(f64::NAN) - (total * (1.0 - t) + t)).abs() < 1e-12,
        "{both:#?}"
    );
    let failed = h.checks.iter().any(|c| c.topic == Topic::Bolts && c.status == Status::Failed);
    assert!(failed == (total > 1.0), "{total}");
    // ten times the shear force fails shear, interaction and bearing
    let h = loaded("{name: A, end: beam_right, at: bolt_plane, Vz: -4000 kN, My: 50 kN m}");
    let failed: Vec<&str> =
        h.checks.iter().filter(|c| c.status == Status::Failed).map(|c| c.title.as_str()).collect();
    assert!(
        failed.contains(&"bearing resistance at a bolt") && failed.contains(&"shear of the beam"),
        "{failed:?}"
    );
}

/// Six preloaded bolts: F_s,Rd = μ F_p,C/γ_M3 each, a pull takes 0.8 of its share off, a moment
/// nothing (3.9.2(3)). More than that is a warning, for slip is not said to be prevented; without
/// preload or friction there is no such check.
#[test]
fn clause_3_9_slip_of_preloaded_bolts() {
    let title = "slip of the preloaded bolts at the ultimate limit state (category C)";
    let h = |preload: &str, mu: &str, load: &str| {
        let text = joint("", &format!("{{name: A, end: beam_right, at: bolt_plane, {load}}}"));
        checks(&format!(
            "{}friction: {{mu: {mu}}}\n",
            text.replace("\"8.8\",", &format!("\"8.8\", preload: {preload},"))
        ))
    };
    let force = 0.7 * 800.0 * 245.0;
    for (said, load, clamp, shear) in [
        ("0.7", "Vz: -100 kN", force, 100e3),
        ("0.7", "Vz: -100 kN, My: 40 kN m", force, 100e3),
        ("0.7", "Vz: -100 kN, N: 60 kN", force - 0.8 * 10e3, 100e3),
        ("0.7", "Vz: -100 kN, N: -60 kN", force, 100e3),
        ("50 kN", "Vz: -60 kN, Vy: 80 kN", 50e3, 100e3),
    ] {
        let found = h(said, "0.2", load);
        let slip = find(&found, "beam_right", title);
        let (want, used) = (0.2 * clamp / 1.25, slip.utilisation.unwrap_or(f64::NAN));
        assert!(
            (slip.resistance.unwrap_or(f64::NAN) / want - 1.0).abs() < 1e-12,
            "{load}: {slip:#?}"
        );
        assert!((used / (shear / 6.0 / want) - 1.0).abs() < 1e-12, "{load}: {slip:#?}");
        assert_eq!(slip.status, if used > 1.0 { Status::Warning } else { Status::Ok }, "{load}");
    }
    for (said, mu) in [("none", "0.2"), ("0.7", "0")] {
        assert!(h(said, mu, "Vz: -100 kN").checks.iter().all(|c| c.title != title));
    }
}

/// The sense of the moment, the part of M_j,Rd it asks, and the load factor at which nothing is
/// left; fixed actions stay.
#[test]
fn clause_6_2_7_1_moment_and_axial_force() {
    let h = loaded("{name: A, end: beam_right, at: bolt_plane, My: -30 kN m}");
    let c = &h.comparisons[0];
    let bottom = find(&h, "tension at the bottom", "moment resistance of the joint").resistance;
    assert_eq!((c.sense.as_str(), Some(c.resistance)), ("tension at the bottom", bottom));
    assert!((c.factor.unwrap_or(f64::NAN) * 30e6 / c.resistance - 1.0).abs() < 1e-12, "{c:#?}");
    let check = find(&h, "beam_right", "moment and axial force of the joint");
    assert!(
        (check.utilisation.unwrap_or(f64::NAN) - 30e6 / c.resistance).abs() < 1e-12,
        "{check:#?}"
    );
    // half of it fixed: twice as far to go
    let fixed =
        "{name: A, end: beam_right, at: bolt_plane, My: -15 kN m, Vz: -10 kN, factor: [Vz]}";
    assert_eq!(
        loaded(fixed).comparisons[0].factor,
        None,
        "the shear force alone never uses up the moment"
    );
    // 6 % of N_pl,Rd counts, 4 % does not
    let plastic = 5381.0 * 235.0;
    for (share, counts) in [(0.04_f64, false), (0.06, true), (-0.06, true)] {
        let n = share * plastic * 1e-3;
        let h = loaded(&format!(
            "{{name: A, end: beam_right, at: bolt_plane, My: -30 kN m, N: {n} kN}}"
        ));
        let check = find(&h, "beam_right", "moment and axial force of the joint");
        let symbol = if share > 0.0 { "N_j,Rd in tension" } else { "N_j,Rd in compression" };
        let axial = check.values.iter().find(|s| s.symbol == symbol).map_or(f64::NAN, |s| s.value);
        let (used, bending) = (check.utilisation.unwrap_or(f64::NAN), 30e6 / c.resistance);
        // never less than the moment alone; no more than the straight line of formula 6.24
        let most = bending + if counts { (n * 1e3).abs() / axial } else { 0.0 };
        assert!(
            used >= bending - 1e-12 && used <= most + 1e-9,
            "{share}: {used} {most} {check:#?}"
        );
        assert!(axial > 100e3 && axial <= plastic * 1.001, "{axial}");
    }
    // what exceeds M_j,Rd fails, whatever its bolts carry: nothing is clipped
    let h = loaded("{name: A, end: beam_right, at: bolt_plane, My: 300 kN m}");
    assert_eq!(
        find(&h, "beam_right", "moment and axial force of the joint").status,
        Status::Failed
    );
    let bolts = find(
        &h,
        "beam_right, row",
        "tension of a bolt, prying included, by the row forces of the component method",
    );
    assert!(
        bolts.status == Status::Failed && bolts.utilisation.is_some_and(|u| u > 1.5),
        "{bolts:#?}"
    );
    assert!(h.failed());
    // three times what the beam itself carries is most likely a unit
    assert!(
        h.notes.iter().any(|n| n.contains("My = 300 kN m") && n.contains("M_pl,Rd")),
        "{:?}",
        h.notes
    );
}

/// V_wp,Ed = (M_b1 − M_b2)/z, once for both sides; equal moments leave the panel without shear.
#[test]
fn clause_5_3_3_web_panel_between_two_beams() {
    let of = |left: f64| {
        let load =
            |end: &str, my: f64| format!("{{name: A, end: {end}, at: bolt_plane, My: {my} kN m}}");
        checks(&joint(
            "double_sided: true",
            &[load("beam_right", 40.0), load("beam_left", left)].join(", "),
        ))
    };
    let h = of(10.0);
    let panel: Vec<&Check> =
        h.checks.iter().filter(|c| c.title.starts_with("column web panel in shear (")).collect();
    assert_eq!(panel.len(), 1, "{panel:#?}");
    let z = find(&h, "tension at the top, β = 0.75", "initial rotational stiffness");
    let z = z.values.iter().find(|s| s.symbol == "z_eq").map_or(f64::NAN, |s| s.value);
    assert!((panel[0].demand.unwrap_or(f64::NAN) * z / 30e6 - 1.0).abs() < 1e-12, "{panel:#?}");
    assert!(
        of(40.0)
            .checks
            .iter()
            .all(|c| c.case.is_none() || !c.title.starts_with("column web panel"))
    );
}

/// Throats of the spec are checked, by hand: flange welds under M/(h − t_f), web welds under V.
#[test]
fn clause_4_5_3_3_welds_with_a_throat() {
    let h = checks(&joint(
        "flange_weld: 6, web_weld: 2.5",
        "{name: A, end: beam_right, at: bolt_plane, My: 40 kN m, Vz: -80 kN}",
    ));
    let strength = |a: f64| a * 360.0 / (3f64.sqrt() * 0.8 * 1.25);
    let flange = find(&h, "beam_right, beam flange", "fillet weld, simplified method");
    let length = 300.0 - 7.1 - 30.0 - 2.0 * std::f64::consts::SQRT_2 * 6.0;
    let want = 40e6 / (300.0 - 10.7) / length / strength(6.0);
    assert!((flange.utilisation.unwrap_or(f64::NAN) / want - 1.0).abs() < 1e-9, "{flange:#?}");
    let web = find(&h, "beam_right, beam web", "fillet weld, simplified method");
    assert!(
        (web.utilisation.unwrap_or(f64::NAN) - 40e3 / (248.6 - 5.0) / strength(2.5)).abs() < 1e-9,
        "{web:#?}"
    );
    assert_eq!(find(&h, "beam_right, beam web", "least throat").status, Status::Failed);
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
        h.checks.iter().all(|c| !c.subject.contains("column") && !c.title.contains("column web")),
        "{h:#?}"
    );
    assert!(
        find(&h, "M20 8.8", "least length of the bolt")
            .formula
            .contains("grip + washers + nut + pitch = 30 ")
    );
    let elastic = find(&h, "tension at the top", "rotational stiffness for elastic analysis");
    assert!(
        elastic.formula.ends_with(&format!(
            "/3 = {}",
            Unit::Rotational.show(elastic.resistance.unwrap_or(0.0))
        ))
    );
}

/// Where neither plate nor flange is thin enough for its bolts, the numbers say so.
#[test]
fn thick_plates_and_soft_bolts_are_brittle() {
    let text = joint("", "{name: A, end: beam_right, at: bolt_plane, My: 40 kN m}");
    assert_eq!(checks(&text).brittle, None);
    let thick = text
        .replace("thickness: 15", "thickness: 30")
        .replace("profile: HEB200", "profile: HEM200");
    let thick = thick.replace("size: M20, grade: \"8.8\"", "size: M16, grade: \"4.6\"");
    let why = checks(&thick).brittle.expect("no rule holds");
    assert!(
        why.contains("t = 30 mm > 0.36 d")
            && why.contains("t = 25 mm > (d/1.9)")
            && why.contains("1.9 F_t,Rd"),
        "{why}"
    );
}

/// A doubler thinner than the web does not count and is told; one that counts adds b_s t_w to the
/// shear area.
#[test]
fn clause_6_2_6_1_a_doubler_counts_or_is_told() {
    let load = "{name: A, end: beam_right, at: bolt_plane, My: 40 kN m}";
    let area = |h: &HandChecks| {
        let panel = find(h, "tension at the top", "column web panel in shear");
        panel.values.iter().find(|s| s.symbol == "A_vc").map_or(f64::NAN, |s| s.value)
    };
    let (bare, thin) =
        (loaded(load), checks(&joint("doubler: true, doubler_thickness: 6, rib: true", load)));
    assert!(
        thin.notes[0].contains("rib")
            && thin.notes[1].contains("t_s = 6 mm is less than t_wc = 9 mm"),
        "{:?}",
        thin.notes
    );
    assert_eq!(area(&bare), area(&thin));
    let counts = checks(&joint("doubler: true", load));
    assert!((area(&counts) - area(&bare) - 134.0 * 9.0).abs() < 1e-9 && counts.notes.is_empty());
}

/// A plate wider than the column's flange is told with both numbers; columns of bolts outside of
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
    assert!(check.formula.contains("b_p = 250 mm > b_fc of HEB200 = 200 mm"), "{}", check.formula);
    assert!(!h.failed(), "{h:#?}");
    let h = checks(&wide("200", "110"));
    assert!(h.checks.iter().all(|c| c.title != title));
    let d = of_spec(&wide("300", "220"), std::path::Path::new("."))
        .expect_err("bolts beside the flange")
        .into_first();
    assert_eq!((d.code, d.place.path.as_deref()), ("spec/rule", Some("bolts.gauge")));
    for words in ["gauge 220 mm", "300 mm wide", "column flange (200 mm wide)"] {
        assert!(d.message.contains(words), "{d:#?}");
    }
}
