//! What the national annexes change beside the partial factors.

use super::fixture::{ONE, checks, find, joint, near, used};
use crate::check::{Check, CheckId, Status};
use crate::end_plate::HandChecks;

const LIST: &str = "rules of the national annex that are not covered";

fn of(annex: &str, more: &str) -> HandChecks {
    checks(&format!("code: {{annex: {annex}}}\n{}", joint(more, ONE)))
}

/// A plate of 15 mm: a ≥ √15 − 0.5 = 3.373 mm on the web; the rib of 7.1 mm stands on the plate.
/// The stiffeners of 10.7 mm stand on a flange of 15 mm.
#[test]
fn germany_has_least_throats_beside_thick_parts() {
    let title = "least throat beside the thicker part";
    let h = of("DE", "flange_weld: 5, web_weld: 3, stiffener_weld: 3.3, rib: true, rib_weld: 3.4");
    for (part, status) in [
        ("beam flange", Status::Ok),
        ("beam web", Status::Failed),
        ("column stiffeners", Status::Failed),
        ("rib", Status::Ok),
    ] {
        let check = find(&h, part, title);
        assert_eq!(check.status, status, "{check:#?}");
        near(check.demand.unwrap_or(f64::NAN), 15f64.sqrt() - 0.5, 1e-9);
    }
    let none = |h: &HandChecks| h.checks.iter().all(|c: &Check| c.id().title() != title);
    assert!(none(&of("FR", "flange_weld: 5, web_weld: 3")) && none(&of("DE", "")));
    // exactly at the limit: √(3.5²) − 0.5 = 3 of a plate of 12.25 mm
    let thin = joint("web_weld: 3", ONE).replace("thickness: 15", "thickness: 12.25");
    let h = checks(&format!("code: {{annex: Germany}}\n{thin}"));
    assert_eq!(find(&h, "beam web", title).status, Status::Ok);
}

#[test]
fn germany_excludes_bolts_of_class_6_8() {
    for (grade, excluded) in [("4.8", true), ("5.8", true), ("6.8", true), ("5.6", false)] {
        let text = joint("", ONE).replace("\"8.8\"", &format!("\"{grade}\""));
        let h = checks(&format!("code: {{annex: DE}}\n{text}"));
        let found = h
            .checks
            .iter()
            .any(|c| c.id() == CheckId::AnnexBoltClass && c.status == Status::Failed);
        assert_eq!(found, excluded, "{grade}");
    }
}

/// Every annex lists what is left out; the recommended values have no list.
#[test]
fn what_an_annex_changes_and_the_checks_leave_out_is_listed() {
    for annex in
        ["UK", "DE", "FR", "NL", "NO", "AT", "BE", "CH", "DK", "FI", "IE", "IT", "LU", "SE"]
    {
        let h = of(annex, "");
        assert!(
            find(&h, &format!("annex {annex}"), LIST).formula().to_string().contains("not covered")
        );
    }
    let none = |h: &HandChecks| h.checks.iter().all(|c| c.id().title() != LIST);
    assert!(none(&of("recommended", "")) && none(&checks(&joint("", ONE))));
}

/// f_y of the product standard is that of the UK annex: a warning where Table 3.1 gives it.
#[test]
fn uk_yield_strengths_are_those_of_the_product_standard() {
    let title = "yield strengths by the product standard";
    assert_eq!(find(&of("UK", ""), "annex UK", title).status, Status::Warning);
    let by_product = of("UK, fy_source: product_standard", "");
    assert!(by_product.checks.iter().all(|c| c.id().title() != title));
}

/// HEM200 (t_f = 25) with a plate of 22 mm and M20 8.8: both above 20/1.9 · √(800/235) = 19.42 mm,
/// so that no row has more than F_t1 h_r/h_1. A plate of 19 mm lets the rows be plastic.
#[test]
fn uk_na_2_7_limits_the_rows_by_a_triangle() {
    let text = |thickness: f64, code: &str| {
        let text = joint("", ONE).replace("HEB200", "HEM200");
        format!("{code}{}", text.replace("thickness: 15", &format!("thickness: {thickness}")))
    };
    let uk = "code: {annex: UK}\n";
    let forces = |h: &HandChecks| -> Vec<f64> {
        let row = |c: &&Check| {
            c.subject.to_string().starts_with("tension at the top, row")
                && c.id() == CheckId::RowTension
        };
        h.checks.iter().filter(row).filter_map(|c| c.resistance).collect()
    };
    let (plain, limited) = (checks(&text(22.0, "")), checks(&text(22.0, uk)));
    let [free, held] = [&plain, &limited].map(forces);
    // rows at 190 and 90 mm above the axis, the centre of compression at −144.65 mm
    let share = (90.0 + 144.65) / (190.0 + 144.65);
    near(held[0], free[0], 1e-9);
    assert!(free[1] > share * free[0], "{free:?}");
    near(held[1], share * held[0], 1e-9);
    let moment = |h: &HandChecks| {
        let title = "moment resistance of the joint";
        find(h, "tension at the top", title).resistance.unwrap_or(f64::NAN)
    };
    assert!(moment(&limited) < moment(&plain));
    assert!(used(find(&limited, "beam_right", "moment and axial force of the joint")) > 0.0);
    let [thin, thin_uk] = ["", uk].map(|code| moment(&checks(&text(19.0, code))));
    assert_eq!(thin, thin_uk);
    let rule = find(&limited, "bolt rows", "forces of the bolt rows");
    assert!(rule.formula().to_string().contains("triangle"), "{rule:#?}");
}
