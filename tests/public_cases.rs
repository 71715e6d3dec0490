//! Inputs of `tests/cases` that people gave the program, and further ones of the same kinds. Each
//! is answered by the compiled program as a user gets it.

#[path = "public_cases/annexes.rs"]
mod annexes;
#[path = "public_cases/answer.rs"]
mod answer;
#[path = "cli/bench.rs"]
mod bench;
#[path = "public_cases/column_section.rs"]
mod column_section;
#[path = "public_cases/elastoplastic_joint.rs"]
mod elastoplastic_joint;
#[path = "public_cases/joint_verdict.rs"]
mod joint_verdict;
#[path = "public_cases/moment_and_axial.rs"]
mod moment_and_axial;
#[path = "common/numbers.rs"]
mod numbers;
#[path = "public_cases/random_joints.rs"]
mod random_joints;
#[path = "public_cases/shear_across.rs"]
mod shear_across;
#[path = "public_cases/small_actions.rs"]
mod small_actions;

#[path = "public_cases/given_input.rs"]
mod given_input;
#[path = "public_cases/outside_range.rs"]
mod outside_range;
#[path = "public_cases/printout.rs"]
mod printout;
#[path = "public_cases/real_ends.rs"]
mod real_ends;
#[path = "public_cases/units.rs"]
mod units;
#[path = "public_cases/welds.rs"]
mod welds;

use answer::Answer;

/// A stiffened end plate with an ordinary load, as a start for changes.
const PLAIN: &str = "template: beam_splice
members: {beam: {profile: IPE300, steel: S235}}
plate: {thickness: 15, width: 150, z: [-160, 160]}
bolts: {size: M16, grade: \"10.9\", gauge: 80, rows: [-95, 95]}
loads: [{name: U, end: beam_right, at: bolt_plane, My: 20 kN m}]
";

#[test]
fn a_plain_splice_is_ok_by_code() {
    let answer = Answer::to(PLAIN);
    assert_eq!((answer.code, answer.verdict()), (0, "ok"), "{}", answer.said);
    assert!(answer.checks().iter().any(|c| c["title"] == "moment and axial force of the joint"));
    let refused = Answer::to(&PLAIN.replace("IPE300", "IPE301"));
    assert_eq!(refused.code, 2, "{}", refused.said);
}
