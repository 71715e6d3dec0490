//! A shear force across the member, beside the vertical one.

use super::PLAIN;
use super::answer::Answer;

/// Utilisation of the largest check with a title.
fn used(answer: &Answer, title: &str) -> f64 {
    let all = answer.titled(title).into_iter().filter_map(|c| c["utilisation"].as_f64());
    all.reduce(f64::max).unwrap_or_else(|| panic!("{title}: {}", answer.said))
}

fn near(found: f64, wanted: f64) {
    assert!((found / wanted - 1.0).abs() < 2e-3, "{found} is not {wanted}");
}

/// Four M16 10.9 in two rows about the axis under Vy and Vz, by hand: F_v,Ed = √(Vy² + Vz²)/4.
#[test]
fn both_shear_forces_act_on_the_bolts_as_one_vector() {
    let of = |actions: &str| Answer::to(&PLAIN.replace("My: 20 kN m", actions));
    let shear = 0.5 * 1000.0 * 157.0 / 1.25;
    for (vy, vz) in [(60.0_f64, -80.0_f64), (-40.0, -30.0), (90.0, 0.0)] {
        let answer = of(&format!("Vy: {vy} kN, Vz: {vz} kN"));
        assert_eq!((answer.code, answer.verdict()), (0, "ok"), "{}", answer.said);
        near(used(&answer, "shear and tension of a bolt"), vy.hypot(vz) * 1e3 / 4.0 / shear);
        // e1 = (150 − 80)/2 = 35, d0 = 18: α_d = 35/54; e2 = 65 and p2 = 190 give k1 = 2.5
        let bearing = 2.5 * 35.0 / 54.0 * 360.0 * 16.0 * 15.0 / 1.25;
        let across = "bearing resistance at a bolt, across the member";
        near(used(&answer, across), vy.abs() * 1e3 / 4.0 / bearing);
        // tension along 190 − 18, shear along 2 (80 + 35 − 27)
        let block = 360.0 * 172.0 * 15.0 / 1.25 + 235.0 * 176.0 * 15.0 / 3f64.sqrt();
        near(used(&answer, "block tearing across the member"), vy.abs() * 1e3 / block);
        // A_v = A − h_w t_w = 5381 − 278.6 · 7.1
        let flanges = (5381.0 - 278.6 * 7.1) * 235.0 / 3f64.sqrt();
        near(used(&answer, "shear of the beam along its flanges"), vy.abs() * 1e3 / flanges);
        assert!(answer.checks().iter().all(|c| c["status"] != "undecided"));
    }
    let failing = of("Vy: 260 kN");
    assert_eq!((failing.code, failing.verdict()), (1, "not_ok"), "{}", failing.said);
}

/// Bolts whose centre lies above the axis carry the moment of Vy about it as well.
#[test]
fn bolts_above_the_axis_turn_under_a_force_across() {
    let text =
        PLAIN.replace("z: [-160, 160]", "z: [-160, 270]").replace("[-95, 95]", "[-95, 95, 220]");
    let answer = Answer::to(&text.replace("My: 20 kN m", "Vy: 40 kN"));
    assert_eq!(answer.verdict(), "ok", "{}", answer.said);
    // centre at 220/3; Σ r² = 2 Σ (z − c)² + 6 · 40²; the lowest bolts are farthest: 168.33
    let c: f64 = 220.0 / 3.0;
    let lever = |z: f64| (z - c).powi(2);
    let polar = 2.0 * (lever(-95.0) + lever(95.0) + lever(220.0)) + 6.0 * 1600.0;
    let across = 40e3 * (1.0 / 6.0 + c * (95.0 + c) / polar);
    let along = 40e3 * c * 40.0 / polar;
    near(
        used(&answer, "shear and tension of a bolt"),
        across.hypot(along) / (0.5 * 1000.0 * 157.0 / 1.25),
    );
}
