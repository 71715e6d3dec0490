//! Fillet welds against both methods of 4.5.3.1, their lengths, full strength and compression. The
//! expected numbers are computed here, from the outline of the profiles.

use super::fixture::{checks, find, near, step, used};
use crate::check::{Check, Status};
use crate::end_plate::HandChecks;
use std::f64::consts::SQRT_2;

/// h, b, t_w, t_f and r of a profile \[mm\].
#[derive(Clone, Copy)]
struct Beam {
    name: &'static str,
    h: f64,
    b: f64,
    tw: f64,
    tf: f64,
    r: f64,
}

const BEAMS: [Beam; 4] = [
    Beam { name: "IPE300", h: 300.0, b: 150.0, tw: 7.1, tf: 10.7, r: 15.0 },
    Beam { name: "IPE400", h: 400.0, b: 180.0, tw: 8.6, tf: 13.5, r: 21.0 },
    Beam { name: "IPE500", h: 500.0, b: 200.0, tw: 10.2, tf: 16.0, r: 21.0 },
    Beam { name: "HEA300", h: 290.0, b: 300.0, tw: 8.5, tf: 14.0, r: 27.0 },
];

/// Grade, f_y, f_u and β_w.
const STEELS: [(&str, f64, f64, f64); 3] =
    [("S235", 235.0, 360.0, 0.8), ("S275", 275.0, 430.0, 0.85), ("S355", 355.0, 490.0, 0.9)];

/// A flush splice with fillet welds.
fn splice(b: &Beam, steel: &str, throats: [f64; 2], actions: &str, more: &str) -> HandChecks {
    let (edge, row) = (0.5 * b.h + 10.0, 0.5 * b.h - b.tf - 60.0);
    checks(&format!(
        "template: beam_splice\nmembers: {{beam: {{profile: {}, steel: {steel}}}}}\nplate: \
         {{thickness: 20, z: [-{edge}, {edge}]}}\nbolts: {{size: M20, grade: \"8.8\", gauge: 100, \
         rows: [-{row}, {row}]}}\nparameters: {{flange_weld: {}, web_weld: {}}}\nloads: [{{name: \
         A, end: beam_right, at: bolt_plane, {actions}}}]\n{more}",
        b.name, throats[0], throats[1]
    ))
}

fn weld<'a>(h: &'a HandChecks, part: &str) -> &'a Check {
    let place = format!("beam_right, {part}");
    let found = h
        .checks
        .iter()
        .find(|c| c.subject.text() == *place && c.id().title().starts_with("fillet weld"));
    found.unwrap_or_else(|| panic!("no weld of the {part}"))
}

/// Numbers between 0 and 1 from a linear congruential generator.
fn numbers(mut seed: u64) -> impl FnMut() -> f64 {
    move || {
        seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (seed >> 11) as f64 / (1u64 << 53) as f64
    }
}

/// Title and utilisation of a weld under forces per length across and along it, by 4.5.3.3 and by
/// the stresses of 4.5.3.2; `full` is the utilisation of a weld as strong as its plate.
fn by_hand(
    [across, along]: [f64; 2],
    a: f64,
    (fu, beta): (f64, f64),
    full: Option<f64>,
) -> (&'static str, f64) {
    let (gamma, resultant) = (1.25, (across * across + along * along).sqrt());
    let simple = resultant / (fu / 3f64.sqrt() / (beta * gamma) * a);
    let normal = across / a / 2f64.sqrt();
    let equivalent = (normal * normal + 3.0 * (normal * normal + (along / a).powi(2))).sqrt();
    let directed = (equivalent / (fu / (beta * gamma))).max(normal / (0.9 * fu / gamma));
    match (simple <= 1.0, directed <= 1.0, full) {
        (true, ..) => ("fillet weld, simplified method", simple),
        (_, false, Some(full)) => ("fillet weld of full strength", full),
        _ => ("fillet weld, directional method", directed),
    }
}

/// Thirty random welds of flange and web under M, V and N of any size.
#[test]
fn thirty_random_fillet_welds_against_both_methods() {
    let mut next = numbers(38);
    let mut titles = Vec::new();
    for turn in 0..30 {
        let b = &BEAMS[(4.0 * next()) as usize];
        let (grade, fy, fu, beta) = STEELS[(3.0 * next()) as usize];
        let [a, aw] = [3.0 + (8.0 * next()).round(), 3.0 + (4.0 * next()).round()];
        let plastic = b.b * b.tf * fy * (b.h - b.tf);
        let full = |t: f64| t * fy * beta * 1.25 / (2f64.sqrt() * fu);
        // every fifth is just as strong as its flange, under more than the flange can bring
        let (a, share) = if turn % 5 == 4 { (full(b.tf).ceil(), 1.1) } else { (a, next()) };
        let m = (1.2 * share * plastic / 1e6).round() * 1e6;
        let v = (0.9 * next() * b.h * b.tw * fy / 3f64.sqrt() / 1e3).round() * 1e3;
        let n = if turn % 3 == 0 {
            0.0
        } else {
            ((next() - 0.5) * b.b * b.tf * fy / 1e3).round() * 1e3
        };
        let actions = format!("My: {} kN m, Vz: {} kN, N: {} kN", m / 1e6, -v / 1e3, n / 1e3);
        let h = splice(b, grade, [a, aw], &actions, "");

        // the flanges: M on their lever arm and half of N each, at most what they yield with
        let (lever, most) = (b.h - b.tf, b.b * b.tf * fy);
        let upper = m / lever + n / 2.0;
        let lower = -m / lever + n / 2.0;
        let force = upper.abs().max(lower.abs()).min(most);
        let length = 2.0 * b.b - b.tw - 2.0 * b.r - 8f64.sqrt() * a;
        let full = (a >= full(b.tf)).then_some(force / most);
        let want = by_hand([force / length, 0.0], a, (fu, beta), full);
        let got = weld(&h, "beam flange");
        assert_eq!(got.id().title(), want.0, "{turn}: {} {actions}: {got:#?}", b.name);
        near(used(got), want.1, 1e-9);
        titles.push(want.0);

        // the web: V, and what the flanges cannot take, at most what it yields with
        let left = |f: f64| f.signum() * (f.abs() - most).max(0.0);
        let (axial, moment) =
            (left(upper) + left(lower), (left(upper) - left(lower)) * lever / 2.0);
        let l = b.h - 2.0 * (b.tf + b.r) - 2.0 * aw;
        let across = (axial.abs() / l + 6.0 * moment.abs() / (l * l)) / 2.0;
        let along = v / l / 2.0;
        let mises = (across * across + 3.0 * along * along).sqrt();
        let part = (b.tw * fy / 2.0 / mises).min(1.0);
        let want = by_hand([part * across, part * along], aw, (fu, beta), None);
        let got = weld(&h, "beam web");
        assert_eq!(got.id().title(), want.0, "{turn}: {} {actions}: {got:#?}", b.name);
        near(used(got), want.1, 1e-9);
        titles.push(want.0);
    }
    for title in ["simplified method", "directional method", "full strength"] {
        assert!(titles.iter().any(|t| t.ends_with(title)), "no case of {title}");
    }
}

/// IPE400, a = 10 mm: 2 · 180 − 8.6 − 2 · 21 = 309.4 mm all round, less 2√2 · 10 = 28.28 at the
/// root fillets, or 6 · 10 by the letter. IPE450 with 9 mm: 328.6, 303.1 and 274.6 mm. A single run
/// of the web loses 2 a unless it is welded all round.
#[test]
fn clause_4_5_1_effective_lengths_by_the_ends() {
    let ipe450 = Beam { name: "IPE450", h: 450.0, b: 190.0, tw: 9.4, tf: 14.6, r: 21.0 };
    for (beam, a, lengths) in
        [(BEAMS[1], 10.0, [281.1157, 249.4, 309.4]), (ipe450, 9.0, [303.1442, 274.6, 328.6])]
    {
        for (ends, length) in ["returned", "open", "all_round"].into_iter().zip(lengths) {
            let more = format!("welds: {{ends: {ends}}}\n");
            let h = splice(&beam, "S355", [a, 5.0], "My: 100 kN m, Vz: -50 kN", &more);
            let flange = weld(&h, "beam flange");
            near(step(flange, "l_eff"), length, 1e-6);
            assert!(
                flange.formula().to_string().contains("l_eff = 2 b − t_w − 2 r"),
                "{}",
                flange.formula()
            );
            let web = beam.h - 2.0 * (beam.tf + beam.r);
            let loss = if ends == "all_round" { 0.0 } else { 10.0 };
            near(step(weld(&h, "beam web"), "l_eff"), web - loss, 1e-9);
            let rule = find(&h, "welds", "effective length of fillet welds");
            assert!(rule.formula().to_string().contains(ends), "{}", rule.formula());
        }
    }
    // the open runs inside, (180 − 8.6)/2 − 21 − 20 = 44.7 mm, are less than 6 · 10 mm, 4.5.1(2)
    for (ends, status) in [("open", Status::Failed), ("returned", Status::Ok)] {
        let more = format!("welds: {{ends: {ends}}}\n");
        let h = splice(&BEAMS[1], "S355", [10.0, 5.0], "My: 100 kN m", &more);
        let least = find(&h, "beam flange", "least effective length");
        assert_eq!(least.status, status, "{least:#?}");
    }
}

/// 10 kN m and Vy = 200 kN on IPE300 with a = 4 mm: 34.57 kN across and half of Vy along the weld
/// of a flange, 251.59 mm long, also where the web has a butt weld. Vy does not stress the web
/// welds.
#[test]
fn the_welds_of_the_flanges_carry_the_horizontal_shear() {
    let length = 2.0 * 150.0 - 7.1 - 2.0 * 15.0 - 8.0 * SQRT_2;
    let across = 10e6 / (300.0 - 10.7);
    for web in [0.0, 4.0] {
        let of = |actions: &str| splice(&BEAMS[0], "S235", [4.0, web], actions, "");
        let h = of("My: 10 kN m, Vy: 200 kN, Vz: -20 kN");
        let demand = |h: &HandChecks, part| weld(h, part).demand.expect("a demand");
        near(demand(&h, "beam flange"), f64::hypot(across, 100e3) / length, 1e-9);
        if web > 0.0 {
            let alone = of("My: 10 kN m, Vz: -20 kN");
            near(demand(&h, "beam web"), demand(&alone, "beam web"), 1e-9);
        }
    }
}

/// N = −900 kN and 10 kN m on IPE300: 450 + 34.57 kN are more than the flange's 150 · 10.7 · 235 =
/// 377.2 kN. Welds of 4 mm carry 4 · 360/√2 · 251.59 = 256.2 kN; those of 5 mm are stronger than
/// the flange. With a contact the welds have the moment, or a quarter of the compression: 121.1 kN.
#[test]
fn welds_carry_the_compression_unless_there_is_a_contact() {
    let of = |a: f64, contact: bool| {
        let more = format!("welds: {{bearing_in_contact: {contact}}}\n");
        splice(&BEAMS[0], "S235", [a, 4.0], "My: 10 kN m, N: -900 kN, Vz: -40 kN", &more)
    };
    let open = of(4.0, false);
    let flange = weld(&open, "beam flange");
    assert_eq!(flange.status, Status::Failed);
    near(used(flange), 377.175 / 256.17, 1e-3);
    let web = weld(&open, "beam web");
    // 484.57 − 377.18 and 415.43 − 377.18 kN of the two flanges, 107.39 − 38.26 kN at 144.65 mm
    let across = (145.65e3 / 240.6 + 6.0 * 69.13e3 * 144.65 / 240.6f64.powi(2)) / 2.0;
    let along = 40e3 / 240.6 / 2.0;
    near(used(web), across.hypot(along) / (4.0 * 360.0 / 3f64.sqrt()), 1e-3);
    let strong = of(5.0, false);
    assert_eq!(weld(&strong, "beam flange").id().title(), "fillet weld of full strength");
    assert_eq!(weld(&strong, "beam flange").status, Status::Ok);
    let contact = of(4.0, true);
    let q = 121.14e3 / 251.586;
    near(used(weld(&contact, "beam flange")), q / (4.0 * 360.0 / 3f64.sqrt()), 1e-3);
    // the web has the shear force alone
    near(used(weld(&contact, "beam web")), along / (4.0 * 360.0 / 3f64.sqrt()), 1e-9);
}
