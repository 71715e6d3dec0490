//! Checks of welds, stiffeners, beam, slip and classes of a joint from its spec.

use super::HandChecks;
use super::tests::{checks, find, joint, loaded};
use crate::checks::check::{Check, Status};

/// IPE300 on HEB200, S235, M20 8.8; welds of 6 and 4 mm.
fn welded(loads: &str) -> HandChecks {
    checks(&joint("flange_weld: 6, web_weld: 4", loads))
}

fn used(c: &Check) -> f64 {
    c.utilisation.unwrap_or(f64::NAN)
}

fn step(c: &Check, symbol: &str) -> f64 {
    c.values.iter().find(|s| s.symbol == symbol).map_or(f64::NAN, |s| s.value)
}

fn near(a: f64, b: f64, part: f64) {
    assert!((a / b - 1.0).abs() < part, "{a} is not {b}");
}

/// A row below the flange pulls at b_eff of the web's welds. By hand, from the force of its table: F/(2 √2 · 4 · b_eff), no more of
/// b_eff than the weld is long, 300 − 2 (10.7 + 15) − 8 = 240.6 mm; 40 kN of shear make 40e3/(2 · 4 · 240.6) = 20.78 MPa.
/// Beyond M_j,Rd it grows on.
#[test]
fn clause_4_5_3_2_web_weld_beside_the_rows_in_tension() {
    let title = "web weld beside the rows in tension, directional method";
    let of = |my: f64, vz: f64| {
        let h = welded(&format!("{{name: A, end: beam_right, at: bolt_plane, My: {my} kN m, Vz: {vz} kN}}"));
        let check = find(&h, "beam_right, beam web, row", title).clone();
        (h, check)
    };
    let (h, check) = of(40.0, -40.0);
    assert!(check.subject.ends_with("row at z = 90 mm"), "{check:#?}");
    let row = find(&h, "tension at the top, row 2 at z = 90", "tension resistance of a row");
    let share = used(find(&h, "beam_right", "moment and axial force of the joint"));
    let force = share * row.resistance.unwrap_or(f64::NAN);
    // b_eff of the row, min(2 π m, α m), is longer than the weld
    let across = force / (2.0 * 2f64.sqrt() * 4.0 * 240.6);
    let want = (4.0 * across * across + 3.0 * 20.78 * 20.78).sqrt();
    near(step(&check, "σ_eq"), want, 1e-3);
    near(used(&check), want / 360.0, 1e-3);
    // without shear force it is in proportion to the moment, beyond M_j,Rd as well
    let [one, ten] = [40.0, 400.0].map(|my| used(&of(my, 0.0).1));
    near(ten, 10.0 * one, 1e-9);
    assert!(of(400.0, 0.0).1.status == if ten > 1.0 { Status::Failed } else { Status::Ok });
    // butt welds have no such check
    let none = loaded("{name: A, end: beam_right, at: bolt_plane, My: 40 kN m}");
    assert!(none.checks.iter().all(|c| c.title != title));
}

/// Two welds of 6 mm on 300 − 7.1 − 30 − 2 √2 · 6 = 245.93 mm: 6 · 360/(√3 · 0.8 · 1.25) · 245.93 = 306.7 kN, against M_j,Rd/289.3 mm
/// and at most 150 · 10.7 · 235 = 377.2 kN. Welds of 3 mm, 254.41 mm long, carry 158.6 kN.
#[test]
fn clause_6_2_3_4_welds_are_not_the_weakest() {
    let load = "{name: A, end: beam_right, at: bolt_plane, My: 40 kN m}";
    let title = "flange weld no weaker than the joint";
    let h = welded(load);
    let joint_of = |sense: &str| find(&h, sense, "moment resistance of the joint").resistance.unwrap_or(f64::NAN);
    let top = find(&h, "beam flange, tension at the top", title);
    near(top.resistance.unwrap_or(f64::NAN), 306.7e3, 1e-4);
    near(top.demand.unwrap_or(f64::NAN), (joint_of("tension at the top") / 289.3).min(377.2e3), 1e-4);
    assert_eq!(top.clause, "EN 1993-1-8:2005 6.2.3(4)");
    let thin = checks(&joint("flange_weld: 3, web_weld: 3", load));
    let top = find(&thin, "beam flange, tension at the top", title);
    near(top.resistance.unwrap_or(f64::NAN), 158.6e3, 1e-3);
    assert_eq!((top.status, thin.failed()), (Status::Failed, true), "{top:#?}");
    // no load bends it the other way: told, not binding
    assert_ne!(find(&thin, "beam flange, tension at the bottom", title).status, Status::Failed);
    // butt welds say why they hold
    let butt = loaded(load);
    let check = find(&butt, "beam flange, tension at the top", title);
    assert!(check.status == Status::Information && check.formula.contains("full penetration"), "{check:#?}");
}

/// 1.4 and 1.7 times M_j,Rd, at most M_pl,Rd = 628.4e3 · 235 = 147.7 kN m, at a lever arm of 289.3 mm and at most the flange's 377.2 kN.
#[test]
fn clause_6_2_3_5_welds_where_a_hinge_turns_in_the_joint() {
    let h = welded("{name: A, end: beam_right, at: bolt_plane, My: 40 kN m}");
    let moment = find(&h, "tension at the top", "moment resistance of the joint").resistance.unwrap_or(f64::NAN);
    let title = "flange weld where a plastic hinge turns in the joint";
    let of = |c: &&Check| c.title == title && c.subject == "beam flange, tension at the top";
    let found: Vec<&Check> = h.checks.iter().filter(of).collect();
    assert_eq!(found.len(), 2, "{found:#?}");
    for (check, alpha) in found.into_iter().zip([1.4, 1.7]) {
        let want = ((alpha * moment).min(147.7e6) / 289.3).min(377.2e3);
        near(check.demand.unwrap_or(f64::NAN), want, 1e-3);
        assert_ne!(check.status, Status::Failed);
    }
}
