//! Welds of the beam and stiffeners of the column.

use super::fixture::{ONE, checks, find, joint, loaded, near, step, used, welded};
use crate::check::{Check, CheckId, Status};
use crate::design_code::build;
use crate::end_plate::{HandChecks, WeldItem, welds_list};
use bracket_base::yaml;
use bracket_joint::catalog::Catalog;
use bracket_joint::spec::ConnectionSpec;
use std::path::Path;

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
    assert_eq!(find(&h, "beam web", "least throat").status, Status::Failed);
}

/// A row below the flange acts on b_eff of the welds of the web. By hand, from the force of its
/// table: F/(2 √2 · 4 · b_eff), no more of b_eff than the weld is long, 300 − 2 (10.7 + 15) − 8 =
/// 240.6 mm; 40 kN of shear make 40e3/(2 · 4 · 240.6) = 20.78 MPa. Beyond M_j,Rd it grows further,
/// until the web yields: the throat of full strength is 7.1 · 235/(√2 · 360) = 3.2773 mm.
#[test]
fn clause_4_5_3_2_web_weld_beside_the_rows_in_tension() {
    let title = "web weld beside the rows in tension, directional method";
    let of = |my: f64, vz: f64| {
        let h = welded(&format!(
            "{{name: A, end: beam_right, at: bolt_plane, My: {my} kN m, Vz: {vz} kN}}"
        ));
        let check = find(&h, "beam_right, beam web, row", title).clone();
        (h, check)
    };
    let (h, check) = of(40.0, -40.0);
    assert!(check.subject.to_string().ends_with("row at z = 90 mm"), "{check:#?}");
    let row = find(&h, "tension at the top, row 2 at z = 90", "tension resistance of a row");
    let share = used(find(&h, "beam_right", "moment and axial force of the joint"));
    let force = share * row.resistance.unwrap_or(f64::NAN);
    // b_eff of the row, min(2 π m, α m), is longer than the weld
    let across = force / (2.0 * 2f64.sqrt() * 4.0 * 240.6);
    let want = (4.0 * across * across + 3.0 * 20.78 * 20.78).sqrt();
    near(step(&check, "σ_eq"), want, 1e-3);
    near(used(&check), want / 360.0, 1e-3);
    // without shear force it is in proportion to the moment, beyond M_j,Rd as well
    let [one, four, ten] = [40.0, 160.0, 400.0].map(|my| used(&of(my, 0.0).1));
    near(four, 4.0 * one, 1e-9);
    near(ten, 3.2773 / 4.0, 1e-4);
    assert!(
        10.0 * one > 1.0
            && of(400.0, 0.0).1.formula().to_string().contains("goes through the flange")
    );
    // a weaker weld than the web fails
    let load = "{name: A, end: beam_right, at: bolt_plane, My: 400 kN m}";
    let weak = checks(&joint("flange_weld: 6, web_weld: 3", load));
    let weak = find(&weak, "beam_right, beam web, row", title);
    near(used(weak), 3.2773 / 3.0, 1e-4);
    assert_eq!(weak.status, Status::Failed);
    // butt welds have no such check
    let none = loaded("{name: A, end: beam_right, at: bolt_plane, My: 40 kN m}");
    assert!(none.checks.iter().all(|c| c.id().title() != title));
}

/// Two welds of 4 mm on 300 − 7.1 − 30 − 2 √2 · 4 = 251.59 mm: 4 · 360/(√2 · 0.8 · 1.25) · 251.59 =
/// 256.2 kN, against M_j,Rd/289.3 mm and at most 150 · 10.7 · 235 = 377.2 kN. Welds of 3 mm, 254.41
/// mm long, carry 194.3 kN; those of 6 mm are more than the
/// 10.7 · 235/(√2 · 360) = 4.939 mm that are as strong as the flange.
#[test]
fn clause_6_2_3_4_welds_are_not_the_weakest() {
    let load = "{name: A, end: beam_right, at: bolt_plane, My: 40 kN m}";
    let title = "flange weld no weaker than the joint";
    let h = welded(load);
    let joint_of = |sense: &str| {
        find(&h, sense, "moment resistance of the joint").resistance.unwrap_or(f64::NAN)
    };
    let top = find(&h, "beam flange, tension at the top", title);
    near(top.resistance.unwrap_or(f64::NAN), 377.2e3, 1e-4);
    assert!(top.formula().to_string().contains("of full strength"), "{top:#?}");
    let four = checks(&joint("flange_weld: 4, web_weld: 4", load));
    near(
        find(&four, "beam flange, tension at the top", title).resistance.unwrap_or(f64::NAN),
        256.2e3,
        1e-3,
    );
    near(
        top.demand.unwrap_or(f64::NAN),
        (joint_of("tension at the top") / 289.3).min(377.2e3),
        1e-4,
    );
    assert_eq!(top.clause, "EN 1993-1-8:2005 6.2.3(4)");
    let thin = checks(&joint("flange_weld: 3, web_weld: 3", load));
    let top = find(&thin, "beam flange, tension at the top", title);
    near(top.resistance.unwrap_or(f64::NAN), 194.3e3, 1e-3);
    assert_eq!((top.status, thin.failed()), (Status::Failed, true), "{top:#?}");
    // no load bends it the other way: reported, not binding
    assert_ne!(find(&thin, "beam flange, tension at the bottom", title).status, Status::Failed);
    // butt welds state why they suffice
    let butt = loaded(load);
    let check = find(&butt, "beam flange, tension at the top", title);
    assert!(
        check.status == Status::Information
            && check.formula().to_string().contains("full penetration"),
        "{check:#?}"
    );
    let check =
        find(&butt, "beam web, tension at the top", "web weld no weaker than the rows in tension");
    assert!(
        check.status == Status::Information
            && check.formula().to_string().contains("full penetration"),
        "{check:#?}"
    );
    // web welds of 3 mm: F/(2 √2 a b_eff) of the rows at F_tr,Rd, all else as under a load without
    // shear force
    let web = find(
        &thin,
        "beam web, tension at the top, z = ",
        "web weld no weaker than the rows in tension",
    );
    let loaded = find(
        &thin,
        "beam_right, beam web, row",
        "web weld beside the rows in tension, directional method",
    );
    let share = used(find(&thin, "beam_right", "moment and axial force of the joint"));
    near(used(loaded), share * used(web), 1e-9);
}

/// 1.4 and 1.7 times M_j,Rd, at most M_pl,Rd = 628.4e3 · 235 = 147.7 kN m, at a lever arm of 289.3
/// mm and at most the flange's 377.2 kN.
#[test]
fn clause_6_2_3_5_welds_where_a_hinge_turns_in_the_joint() {
    let h = welded("{name: A, end: beam_right, at: bolt_plane, My: 40 kN m}");
    let moment = find(&h, "tension at the top", "moment resistance of the joint")
        .resistance
        .unwrap_or(f64::NAN);
    let title = "flange weld where a plastic hinge turns in the joint";
    let of = |c: &&Check| {
        c.id().title() == title && c.subject.text() == "beam flange, tension at the top"
    };
    let found: Vec<&Check> = h.checks.iter().filter(of).collect();
    assert_eq!(found.len(), 2, "{found:#?}");
    for (check, alpha) in found.into_iter().zip([1.4, 1.7]) {
        let want = ((alpha * moment).min(147.7e6) / 289.3).min(377.2e3);
        near(check.demand.unwrap_or(f64::NAN), want, 1e-3);
        assert_ne!(check.status, Status::Failed);
    }
}

/// HEB200 with stiffeners of 10.7 mm: (200 − 9)/2 − 23 = 72.5 mm are left of each, 2 · 72.5 · 10.7
/// · 235 = 364.6 kN. Web alone: b_eff = 10.7 + 5 · 33 + 30 = 205.7 mm, A_vc = 2483 mm², ω = 1/√(1 +
/// 1.3 (205.7 · 9/2483)²) = 0.7619, so 331.5 kN.
#[test]
fn clause_6_2_6_2_stiffeners_on_their_net_section() {
    let title = "crushing of the column web with the net section of its stiffeners";
    let of = |h: &HandChecks| find(h, "beam_right, compressed stiffeners", title).clone();
    let h = loaded(ONE);
    let check = of(&h);
    near(check.resistance.unwrap_or(f64::NAN), 364.6e3 + 331.5e3, 1e-3);
    let rows = h.checks.iter().filter(|c| {
        c.subject.to_string().starts_with("tension at the top, row")
            && c.id() == CheckId::RowTension
    });
    let sum: f64 = rows.filter_map(|c| c.resistance).sum();
    let share = used(find(&h, "beam_right", "moment and axial force of the joint"));
    near(check.demand.unwrap_or(f64::NAN), share * sum, 1e-9);
    // half of an axial compression is added: 20 kN; a larger clip leaves less: 2 · 45.5 · 10.7 ·
    // 235 = 228.8 kN
    let pushed = of(&loaded(&ONE.replace("My", "N: -40 kN, My")));
    near(pushed.demand.unwrap_or(f64::NAN), share * sum + 20e3, 1e-9);
    let cut = of(&checks(&joint("stiffener_clip: 50", ONE)));
    near(cut.resistance.unwrap_or(f64::NAN), 228.8e3 + 331.5e3, 1e-3);
    // with a compression that counts (5 % of N_pl are 63 kN) the equilibrium of the components
    // decides: all of it at most in one flange
    for push in [100.0, 200.0, 400.0] {
        let check = of(&loaded(&ONE.replace("My", &format!("N: -{push} kN, My"))));
        let force = check.demand.unwrap_or(f64::NAN);
        assert!((share * sum..=share * sum + 1e3 * push).contains(&force), "{push}: {force}");
    }
    // ten times the moment: ten times the force
    near(
        of(&loaded(&ONE.replace("40", "400"))).demand.unwrap_or(f64::NAN),
        10.0 * share * sum,
        1e-9,
    );
    assert!(
        checks(&joint("column_stiffeners: false", ONE))
            .checks
            .iter()
            .all(|c| c.id().title() != title)
    );
}

/// Rows at 190 and 90 mm beside the stiffener at 144.65 mm, gauge 110 mm: m = 50.5 − 14.4 = 36.1
/// mm, m2 = 45.35 − 5.35 = 40 and
/// 54.65 − 5.35 = 49.3 mm.
#[test]
fn clause_6_2_6_3_stiffeners_in_tension() {
    let h = checks(&joint("", ONE).replace("rows:", "gauge: 110, rows:"));
    let check =
        find(&h, "beam_right, stiffeners in tension", "net section of the stiffeners in tension");
    let share = used(find(&h, "beam_right", "moment and axial force of the joint"));
    let row = |place: &str| {
        let row = find(&h, &format!("tension at the top, {place}"), "tension resistance of a row");
        share * row.resistance.unwrap_or(f64::NAN)
    };
    let (first, second) = (row("row 1 at z = 190"), row("row 2 at z = 90"));
    let bent = first * 36.1 / 76.1 + second * 36.1 / 85.4;
    // the web alone: ω b_eff · 9 · 235 with b_eff of the two rows without stiffeners
    let web =
        check.values.iter().find(|s| s.symbol == "b_eff of the web").map_or(f64::NAN, |s| s.value);
    let omega = 1.0 / (1.0 + 1.3 * (web * 9.0 / 2483.0_f64).powi(2)).sqrt();
    let want = bent.max(first + second - omega * web * 9.0 * 235.0);
    near(check.demand.unwrap_or(f64::NAN), want, 1e-3);
    near(check.resistance.unwrap_or(f64::NAN), 364.6e3, 1e-3);
}

/// Throat 4: 4 · 360/(√3 · 0.8 · 1.25) = 831.4 N/mm; four welds of 72.5 − 8 = 64.5 mm on the flange
/// carry 214.5 kN, four of 200 − 2 (15 + 23) − 8 = 116 mm on the web 385.8 kN. The compressed
/// stiffeners take 364.6/696.1 of the force.
#[test]
fn clause_4_5_3_3_welds_of_stiffeners() {
    let title = "fillet welds of the column stiffeners";
    let h = checks(&joint("stiffener_weld: 4", ONE));
    let flange = find(&h, "beam_right, compressed stiffeners to the column flange", title);
    near(flange.resistance.unwrap_or(f64::NAN), 214.5e3, 1e-3);
    let crushing = "crushing of the column web with the net section of its stiffeners";
    let force = find(&h, "beam_right, compressed", crushing).demand.unwrap_or(f64::NAN);
    near(flange.demand.unwrap_or(f64::NAN), force * 364.6 / 696.1, 1e-3);
    let web = h
        .checks
        .iter()
        .find(|c| c.id().title() == title && c.subject.to_string().ends_with("to the column web"))
        .expect("web");
    near(web.resistance.unwrap_or(f64::NAN), 385.8e3, 1e-3);
    // equal moments on both sides balance: the web's welds have nothing to carry
    let both = ["right", "left"].map(|s| ONE.replace("right", s)).join(", ");
    let h = checks(&joint("stiffener_weld: 4, double_sided: true", &both));
    let web = h
        .checks
        .iter()
        .find(|c| c.id().title() == title && c.subject.to_string().ends_with("to the column web"))
        .expect("web");
    assert_eq!((web.demand, web.status), (Some(0.0), Status::Ok));
    let thin = checks(&joint("stiffener_weld: 2", ONE));
    assert_eq!(find(&thin, "column stiffeners", "least throat").status, Status::Failed);
    assert!(loaded(ONE).checks.iter().all(|c| c.id().title() != title), "butt welds have none");
}

/// IPE300: b = 150, t_w = 7.1, t_f = 10.7, r = 15; HEB200 with clips of the root radius, 18 mm, and
/// 5 mm. Seams on both sides of a part, one for butt welds; metal of 6²·L for the flanges.
#[test]
fn the_list_of_welds_has_every_seam() {
    let list = |more: &str| {
        let spec = joint(more, ONE);
        let spec = yaml::parse::<ConnectionSpec>(&spec, Path::new("joint.yaml")).expect("a spec");
        let catalog = Catalog::builtin().expect("catalogue");
        let joint = build(&spec, Path::new("."), &catalog).expect("a joint");
        welds_list(joint.facts.as_ref(), &joint.content)
    };
    let fillets = list("double_sided: true, flange_weld: 6, web_weld: 4, stiffener_weld: 5");
    let seams = |items: &[WeldItem]| -> Vec<(usize, Option<f64>)> {
        items.iter().map(|i| (i.count, i.length.map(|l| (100.0 * l).round() / 100.0))).collect()
    };
    let want = [(4, 150.0), (8, 56.45), (4, 248.6), (16, 72.5), (8, 124.0)];
    assert_eq!(seams(&fillets), want.map(|(n, l)| (n, Some(l))));
    near(fillets[0].mass().unwrap_or(f64::NAN), 7.85e-6 * 36.0 * 600.0, 1e-9);
    let butt = list("flange_weld: 0, web_weld: 0");
    let want = [(2, 150.0), (1, 248.6), (8, 72.5), (4, 124.0)];
    assert_eq!(seams(&butt), want.map(|(n, l)| (n, Some(l))));
    assert!(butt.iter().all(|i| i.mass().is_none()));
    let more = list("doubler: true, doubler_weld: 7, rib: true, rib_weld: 4");
    for place in ["web doubler, all round", "rib to end plate", "rib to beam flange"] {
        assert!(more.iter().any(|i| i.place == place), "{more:#?}");
    }
}

/// A plate of 9 mm needs 9/√2 = 6.364 mm; its part of the panel, 9/(2483 + 134 · 9) of the shear
/// force a mm, runs along its welds.
#[test]
fn clause_6_2_6_1_welds_of_a_doubler() {
    let of = |a: f64| {
        checks(&joint(&format!("doubler: true, doubler_thickness: 9, doubler_weld: {a}"), ONE))
    };
    let throat = "throat of the welds of a web doubler";
    assert_eq!(find(&of(6.3), "web doubler", throat).status, Status::Failed);
    let h = of(6.4);
    let check = find(&h, "web doubler", throat);
    assert_eq!(check.status, Status::Ok);
    near(check.demand.unwrap_or(f64::NAN), 6.364, 1e-4);
    let flow = find(&h, "beam_right, web doubler", "shear flow in the welds of a web doubler");
    let panel = h
        .checks
        .iter()
        .find(|c| c.case.is_some() && c.id().title().starts_with("column web panel"))
        .expect("panel");
    near(flow.demand.unwrap_or(f64::NAN), panel.demand.unwrap_or(f64::NAN) * 9.0 / 3689.0, 1e-3);
    near(flow.resistance.unwrap_or(f64::NAN), 6.4 * 207.85, 1e-3);
}

/// A rib of 7.1 mm S235: 7.1 · 235 · 0.8 · 1.25/(√2 · 360) = 3.277 mm.
#[test]
fn clause_4_5_3_2_welds_as_strong_as_the_rib() {
    let of = |a: f64| checks(&joint(&format!("rib: true, rib_thickness: 7.1, rib_weld: {a}"), ONE));
    let title = "throat of welds as strong as the rib";
    let h = of(3.0);
    let check = find(&h, "rib", title);
    near(check.demand.unwrap_or(f64::NAN), 3.277, 1e-3);
    assert_eq!((check.status, find(&of(4.0), "rib", title).status), (Status::Failed, Status::Ok));
}
