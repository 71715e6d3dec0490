//! Elastoplastic analysis of an ordinary joint: what yields and where, how far the loaded end
//! turns, what the bolts carry.

use super::answer::Answer;
use crate::bench::Bench;
use serde_json::Value;

/// The joint of case 20 with a thinner plate under a moment \[kN m\], on a coarse mesh.
fn under(moment: f64) -> Answer {
    let text = Answer::input("20-stiffness-with-column-bending.yaml")
        .replace("kind: elastic", "kind: elastoplastic")
        .replace("My: 100 kN m", &format!("My: {moment} kN m"))
        .replace("thickness: 16 mm", "thickness: 10 mm")
        .replace("size: auto", "layers: false");
    let bench = Bench::new().file("joint.yaml", text);
    let coarse = ["--size-factor", "4", "--max-passes", "1"];
    Answer::from(bench, &[&["run", "joint.yaml", "--out", "out"], &coarse[..]].concat())
}

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or_else(|| panic!("a number, not {value}"))
}

/// Rotation of the loaded end \[rad\].
fn turn(case: &Value) -> f64 {
    assert_eq!(case["face_motions"][0]["face"], "BEAM_RIGHT");
    let r = case["face_motions"][0]["rotation"].as_array().expect("three numbers");
    assert_eq!([number(&r[0]), number(&r[2])], [0.0; 2], "only bending in the plane of symmetry");
    number(&r[1])
}

#[test]
#[ignore = "heavy: more than a minute"]
fn a_small_moment_leaves_it_elastic_and_a_large_one_makes_plate_and_bolts_yield() {
    let small = under(20.0);
    assert!(small.said.contains("ULS1: no part yields; BEAM_RIGHT turns by"), "{}", small.said);
    let case = &small.result["cases"][0];
    // contact without gaps and elastic parts: the work of the moment is twice the energy
    let of_energy = -2.0 * number(&case["upper"]) / 20e6;
    let elastic = turn(case);
    assert!((elastic / of_energy - 1.0).abs() < 1e-5, "{elastic} {of_energy}");
    // the lever arm is at most that of the top row, z = 270 mm, to the plate's end, z = −315 mm
    let bolts = case["static_forces"]["bolts"].as_array().expect("bolts");
    let tension: f64 = bolts.iter().map(|b| number(&b["tension"])).sum();
    assert!(2.0 * tension > 20e6 / 585.0, "{tension}");
    assert!(small.said.contains("largest bolt tension"), "{}", small.said);

    let large = under(200.0);
    let case = &large.result["cases"][0];
    assert!(turn(case) > 10.05 * elastic, "{} {elastic}", turn(case));
    let parts = case["yielding"].as_array().expect("parts");
    let strain = |part: &str| {
        let of = parts.iter().find(|p| p["part"] == part).expect("a part");
        number(&of["plastic_strain"])
    };
    assert!(strain("PLATE_R") > 1e-3 && strain("PLATE_R") < 0.02, "{}", strain("PLATE_R"));
    assert!(strain("BOLT_R4P") > 1e-4 && strain("BEAM_R") == 0.0);
    for words in [
        "ULS1: largest plastic strain 0.",
        " % in BOLT_R4P at x, y, z = ",
        "yielded: BOLT_R4P, PLATE_R",
    ] {
        assert!(large.said.contains(words), "lacks {words}: {}", large.said);
    }
    assert!(large.report.contains("The loaded face BEAM_RIGHT turns by"), "{}", large.report);
    let verified = large.bench.run(&["verify", "out"]);
    assert_eq!(verified.status.code(), Some(0));
    // a rotation that the field does not give is refuted
    let path = large.bench.path().join("out/result.json");
    let mut forged = large.result.clone();
    forged["cases"][0]["face_motions"][0]["rotation"][1] = (1.001 * turn(case)).into();
    std::fs::write(path, forged.to_string()).expect("written");
    let refuted = large.bench.run(&["verify", "out"]);
    assert_eq!(refuted.status.code(), Some(1));
    let said = String::from_utf8_lossy(&refuted.stdout).into_owned();
    assert!(said.contains("face_motions is not what the fields give"), "{said}");
}
