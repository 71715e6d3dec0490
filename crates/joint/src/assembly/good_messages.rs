//! Tests of messages: suggestions that make sense, the place of the value that must change, values
//! without effect.

use super::tests::{PAPER, joint};

/// What a message suggests is something that the user can have meant.
#[test]
fn suggestions_make_sense() {
    let faults = |old: &str, new: &str| joint(&PAPER.replace(old, new)).map(drop).expect_err(new);
    let first = |old: &str, new: &str| faults(old, new).into_first();
    let d = first("steel: S235", "steel: S460");
    assert!(d.message.contains("did you mean `S460N`, `S460M` or `S460Q`?"), "{}", d.message);
    let d = first("profile: HEB200", "profile: UPE200");
    assert!(d.message.contains("this member takes I and H sections"), "{}", d.message);
    let d = first("mu: 0.3", "class: E");
    assert!(!d.message.contains("did you mean"), "{}", d.message);
    // one mistake is one message
    let both = faults("steel: S235", "steel: S234");
    assert_eq!(both.iter().count(), 1, "{both:#?}");
    let role = faults("column: {", "colum: {");
    assert_eq!(role.iter().count(), 1, "{role:#?}");
    assert!(role.into_first().message.contains("did you mean `column`?"));
}

const COLUMN_JOINT: &str = "\
template: beam_to_column_end_plate
members: {column: {profile: HEB200, steel: S235}, beam: {profile: IPE300, steel: S235}}
plate: {thickness: 15, width: 160, z: [-165, 230]}
bolts: {size: M20, grade: \"8.8\", gauge: 100, rows: [-90, 90, 190]}
loads: [{name: U, end: beam_right, at: column_face, My: 40 kN m}]
";

/// Faults of a joint between beam and column: the path, and words of message and help.
#[test]
fn a_fault_names_the_value_that_must_change() {
    for (old, new, path, words) in [
        ("thickness: 15", "thickness: 100", "plate.thickness", "not tabulated"),
        ("width: 160", "width: 100", "plate.width", "`beam.b` sets it"),
        (
            "loads:",
            "parameters: {column_above: 100}\nloads:",
            "parameters.column_above",
            "plate_top",
        ),
        (
            "loads:",
            "parameters: {outer_gauge: 120}\nloads:",
            "parameters.outer_gauge",
            "do not fit",
        ),
        ("size: M20", "preload: 500 kN, size: M20", "bolts.preload", "500 kN"),
        (
            "profile: HEB200, steel: S235",
            "profile: HEB200, steel: S235, length: 300",
            "members.column.length",
            "storey height",
        ),
        (
            "profile: IPE300, steel: S235",
            "profile: IPE300, steel: S235, length: 300",
            "members.beam.length",
            "depth of the beam",
        ),
        (
            "loads: [{name: U, end: beam_right, at: column_face, My: 40 kN m}]",
            "",
            "loads",
            "end: beam",
        ),
    ] {
        assert!(COLUMN_JOINT.contains(old), "{old}");
        let faults = joint(&COLUMN_JOINT.replace(old, new)).map(drop).expect_err(new);
        assert_eq!(faults.iter().count(), 1, "{faults:#?}");
        let d = faults.into_first();
        let said = format!("{} {}", d.message, d.help.clone().unwrap_or_default());
        assert_eq!(d.place.path.as_deref(), Some(path), "{d:#?}");
        assert!(said.contains(words), "{d:#?}");
    }
}

/// What a spec gives without effect is named, each once; the same with effect is not.
#[test]
fn values_without_effect_are_named() {
    let notes = |more: &str| {
        let text = COLUMN_JOINT.replace("loads:", &format!("{more}\nloads:"));
        let notes = joint(&text).expect("it builds").notes;
        notes.iter().map(ToString::to_string).collect::<Vec<_>>()
    };
    for (more, named) in [
        ("parameters: {doubler_thickness: 10}", "parameters.doubler_thickness"),
        ("parameters: {stiffener_weld: 5, column_stiffeners: false}", "parameters.stiffener_weld"),
        ("parameters: {rib_length: 100}", "parameters.rib_length"),
        ("welds: {ends: all_round}", "welds"),
        ("welds: {bearing_in_contact: true}", "welds"),
    ] {
        let notes = notes(more);
        assert_eq!(notes.len(), 1, "{more}: {notes:?}");
        assert!(notes[0].starts_with(&format!("`{named}` has no effect")), "{notes:?}");
    }
    for more in [
        "",
        "parameters: {doubler: true, doubler_thickness: 10}",
        "parameters: {stiffener_weld: 5, column_stiffeners: true}",
        "parameters: {flange_weld: 5}\nwelds: {ends: all_round}",
    ] {
        assert_eq!(notes(more), [""; 0], "{more}");
    }
}
