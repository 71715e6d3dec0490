//! What the members at a node leave.

use super::frame::{BASE, JOINTS, SECTIONS, Section, sap2000};
use crate::bench::{Bench, expect};
use serde_json::{Value, json};

fn joints(sections: &[Section], table: &str) -> Vec<Value> {
    let bench = Bench::new()
        .file("forces.txt", sap2000(sections))
        .file("joints.csv", table)
        .file("base.yaml", BASE);
    let args = ["import", "forces.txt", "--joints", "joints.csv", "--base", "base.yaml"];
    let more = ["--mapping", "sap2000", "--format", "json", "-o", "out"];
    let (out, _) = expect(&bench, &[&args[..], &more].concat(), 0);
    let mut found: Value = serde_json::from_str(&out).expect("JSON");
    serde_json::from_value(found["joints"].take()).expect("a list")
}

/// The frame with other actions at one section.
fn with(member: &str, x: f64, change: [f64; 3]) -> Vec<Section> {
    let mut sections = SECTIONS.to_vec();
    let mut changed = 0;
    for s in sections.iter_mut().filter(|s| s.member == member && s.x == x) {
        s.actions = [0, 1, 2].map(|i| s.actions[i] + change[i]);
        changed += 1;
    }
    assert_eq!(changed, 1);
    sections
}

#[test]
fn a_frame_in_equilibrium_leaves_nothing() {
    for joint in joints(&SECTIONS, JOINTS) {
        assert_eq!(joint["vertical_residual"]["kN"], 0.0, "{joint}");
        assert_eq!(joint["moment_residual"]["kNm"], 0.0, "{joint}");
    }
    // the z axis of the column to the other side
    let mut turned = SECTIONS.to_vec();
    for s in turned.iter_mut().filter(|s| s.member.starts_with('C')) {
        s.actions[2] = -s.actions[2];
    }
    for joint in joints(&turned, JOINTS) {
        assert_eq!(joint["moment_residual"]["kNm"], 0.0, "{joint}");
    }
}

#[test]
fn a_load_at_the_node_is_what_is_left() {
    // 25 kN down at A: the column below has them too
    let found = joints(&with("C1", 4.0, [-25.0, 0.0, 0.0]), JOINTS);
    assert_eq!(found[0]["vertical_residual"], json!({"kN": 25.0, "case": "ULS1"}));
    assert_eq!(found[1]["vertical_residual"]["kN"], 0.0);
    // a moment of 4 kN m at B
    let found = joints(&with("C4", 0.0, [0.0, 0.0, 4.0]), JOINTS);
    assert_eq!(found[1]["moment_residual"], json!({"kNm": 4.0, "case": "ULS1"}));
    assert_eq!(found[0]["moment_residual"]["kNm"], 0.0);
}

/// Without a member of the column nothing is said; with moments that act at its face the moment is
/// left out.
#[test]
fn what_cannot_be_summed_is_left_out() {
    let alone = "joint,end,member,station\nA,beam_right,B1,start\n";
    let face = "joint,end,member,station,at,column_below,column_above\n\
                A,beam_right,B1,start,column_face,C1,C2\n";
    let found = joints(&SECTIONS, alone);
    assert!(found[0]["vertical_residual"].is_null() && found[0]["column"].is_null(), "{found:?}");
    let found = joints(&SECTIONS, face);
    assert_eq!(found[0]["vertical_residual"]["kN"], 0.0);
    assert!(found[0]["moment_residual"].is_null(), "{found:?}");
}
