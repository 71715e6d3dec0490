//! Joint, bolts and column web panel under the actions of load cases.

use super::fixture::{checks, find, joint, loaded, notes};
use crate::check::{Check, Status, Topic};
use crate::end_plate::{Comparison, HandChecks};

const M20: (f64, f64) = (0.9 * 800.0 * 245.0 / 1.25, 0.6 * 800.0 * 245.0 / 1.25);

fn first(checks: &HandChecks) -> Comparison {
    checks.comparisons().next().expect("a load case").clone()
}

/// The moment at the bolt plane is that of the node less the shear force times half of the column's
/// depth, for beams on both sides; given at the face it is the same.
#[test]
fn actions_are_moved_to_the_bolt_plane() {
    let at = |end: &str, at: &str, my: f64| {
        format!("{{name: A, end: {end}, at: {at}, My: {my} kN m, Vz: -80 kN, N: 10 kN}}")
    };
    for (end, more) in [("beam_right", ""), ("beam_left", "double_sided: true")] {
        let [node, face] = [("node", 60.0), ("column_face", 60.0 - 0.1 * 80.0)]
            .map(|(point, my)| first(&checks(&joint(more, &at(end, point, my)))));
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
        // β has nine decimals, so that it does not hang on the unit of the moments
        (100.0, -300.0, [2.0, 1.333_333_333]),
    ];
    for (right, left, want) in cases {
        let load = |end: &str, my: f64| {
            format!("{{name: A, end: {end}, at: node, My: {my} kN m, N: 1 kN}}")
        };
        let loads = [load("beam_right", right), load("beam_left", left)].join(", ");
        let found: Vec<f64> =
            checks(&joint("double_sided: true", &loads)).comparisons().map(|c| c.beta).collect();
        assert!(
            found.iter().zip(want).all(|(a, b)| (a - b).abs() < 1e-12),
            "{right} {left}: {found:?}"
        );
    }
    assert_eq!(first(&loaded("{name: A, end: beam_right, at: node, My: 40 kN m}")).beta, 1.0);
}

/// Without a moment every bolt carries the shear force; with one, bolts in tension carry what Table
/// 3.4 allows, so that every bolt of a row reaches the interaction exactly where the sum of all
/// bolts does.
#[test]
fn clause_6_2_2_shear_goes_where_tension_leaves_room() {
    let h = loaded("{name: A, end: beam_right, at: bolt_plane, Vz: -100 kN}");
    let shear = find(&h, "beam_right", "shear of the bolt group, reduced for tension");
    let (resistance, used) =
        (shear.resistance.unwrap_or(f64::NAN), shear.utilisation.unwrap_or(f64::NAN));
    assert!((resistance / (6.0 * M20.1) - 1.0).abs() < 1e-12, "{resistance}");
    assert!(
        (used / (100e3 / (6.0 * M20.1)) - 1.0).abs() < 1e-12 && shear.case.as_deref() == Some("A"),
        "{used}"
    );
    let h = loaded("{name: A, end: beam_right, at: bolt_plane, Vz: -400 kN, My: 50 kN m}");
    let shear = find(&h, "beam_right", "shear of the bolt group, reduced for tension");
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
        h.checks.iter().filter(|c| c.status == Status::Failed).map(|c| c.id().title()).collect();
    assert!(
        failed.contains(&"bearing resistance at a bolt") && failed.contains(&"shear of the beam"),
        "{failed:?}"
    );
}

/// The sense of the moment, its fraction of M_j,Rd, and the load factor at which the resistance is
/// reached; fixed actions stay constant.
#[test]
fn clause_6_2_7_1_moment_and_axial_force() {
    let h = loaded("{name: A, end: beam_right, at: bolt_plane, My: -30 kN m}");
    let c = &first(&h);
    let bottom = find(&h, "tension at the bottom", "moment resistance of the joint").resistance;
    assert_eq!(
        (c.sense.to_string().as_str(), Some(c.resistance)),
        ("tension at the bottom", bottom)
    );
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
        first(&loaded(fixed)).factor,
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
    // a moment above M_j,Rd fails whatever the bolts carry: no demand is capped
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
    // three times the resistance of the beam itself is most likely a wrong unit
    assert!(
        notes(&h).iter().any(|n| n.contains("My = 300 kN m") && n.contains("M_pl,Rd")),
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
    let panel: Vec<&Check> = h
        .checks
        .iter()
        .filter(|c| c.id().title().starts_with("column web panel in shear ("))
        .collect();
    assert_eq!(panel.len(), 1, "{panel:#?}");
    let z = find(&h, "tension at the top, β = 0.75", "initial rotational stiffness");
    let z = z.values.iter().find(|s| s.symbol == "z_eq").map_or(f64::NAN, |s| s.value);
    assert!((panel[0].demand.unwrap_or(f64::NAN) * z / 30e6 - 1.0).abs() < 1e-12, "{panel:#?}");
    assert!(
        of(40.0)
            .checks
            .iter()
            .all(|c| c.case.is_none() || !c.id().title().starts_with("column web panel"))
    );
}
