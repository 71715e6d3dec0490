//! Inputs of `tests/cases` that people gave the program, and further ones of the same kinds. Each
//! is answered by the compiled program as a user gets it.

mod annexes;
mod answer;
mod column_section;
mod elastoplastic_joint;
mod joint_verdict;
mod moment_and_axial;
mod printed_formulas;
mod random_joints;
mod shear_across;
mod small_actions;

mod given_input;
mod outside_range;
mod printout;
mod real_ends;
mod units;
mod welds;

use self::answer::Answer;

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
