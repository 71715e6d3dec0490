//! Tests of templates that extend other templates.

use super::template::{Check, Template};
use super::template_file::load;
use bracket_base::diag::Diagnostic;
use std::path::Path;

const BASE: &str = "
name: base
title: The base
members: [{role: beam, about: a beam, profile: IPE300, steel: S235}]
parameters:
  - {name: a, kind: length, min: 1 mm, default: 10 mm, about: first}
  - {name: b, kind: length, default: 2 * a, about: second}
  - {name: c, kind: flag, default: false, about: third}
checks:
  - {name: small, that: a <= b, at: parameters.a, say: no, help: less}
parts: []
hand_checks: {beam: beam, steel: [beam], thickness: a, width: a, bottom: -a, top: a, gauge: a,
  rows: r, hole: b}
starter_load: {name: PULL, section: end, pressure: 1 MPa}
";

/// Writes `base.yaml` and `mine.yaml` (and `third.yaml`, if given), then loads `mine.yaml`.
fn loaded(mine: &str, third: Option<&str>) -> Result<Template, Vec<Diagnostic>> {
    let folder = tempfile::tempdir().expect("a folder");
    let write = |file: &str, text: &str| {
        std::fs::write(folder.path().join(file), text).expect("writable");
    };
    write("base.yaml", BASE);
    write("mine.yaml", mine);
    third.iter().for_each(|t| write("third.yaml", t));
    let relative = |d: Diagnostic| {
        let mut d = d;
        d.place.file = d.place.file.map(|f| f.file_name().expect("a file").into());
        d
    };
    load("./mine.yaml", folder.path())
        .map(|(t, _)| t)
        .map_err(|faults| faults.into_iter().map(relative).collect())
}

fn names(t: &Template) -> Vec<&str> {
    t.parameters.iter().map(|p| p.name.as_str()).collect()
}

#[test]
fn what_a_template_leaves_out_is_that_of_its_base() {
    let t = loaded("extends: ./base.yaml\nname: mine\n", None).expect("sound");
    assert_eq!((t.name.as_str(), t.title.as_str()), ("mine", "The base"));
    assert_eq!(names(&t), ["a", "b", "c"]);
    assert_eq!(t.members[0].profile, "IPE300");
}

#[test]
fn a_list_is_that_of_the_template_with_the_keys_and_the_rest_of_its_base() {
    let t = loaded(
        "extends: ./base.yaml
name: mine
members: [{role: beam, profile: IPE400}]
parameters: [{name: d, kind: number, default: 1, about: new}, base, {name: a, default: 20 mm}]
checks: [{name: small, say: too small}]
hand_checks: {top: 2 * a}
starter_load: {name: TURN, end: right, at: node}
",
        None,
    )
    .expect("sound");
    assert_eq!(names(&t), ["d", "b", "c", "a"]);
    let a = &t.parameters[3];
    assert_eq!((a.about.as_str(), a.min.as_ref().map(|m| m.text())), ("first", Some("1 mm")));
    assert!(format!("{:?}", a.default).contains("20 mm"));
    assert_eq!((t.members[0].profile.as_str(), t.members[0].steel.as_str()), ("IPE400", "S235"));
    let Check { that, say, .. } = &t.checks[0];
    assert_eq!((that.text(), say.as_str()), ("a <= b", "too small"));
    let hand = t.hand_checks.as_ref().and_then(|h| h.end_plate()).expect("there");
    assert_eq!((hand.top.text(), hand.bottom.text()), ("2 * a", "-a"));
    // a load is replaced as a whole: no key of the base's load is merged in
    assert_eq!(t.starter_load.expect("there").section, None);
    let without = "extends: ./base.yaml\nname: mine\nparameters: [{name: c}, {name: a}]\n";
    assert_eq!(names(&loaded(without, None).expect("sound")), ["c", "a"]);
}

#[test]
fn a_base_may_extend_another_one_or_a_shipped_one() {
    let third = "extends: base.yaml\nname: third\nparameters: [base, {name: b, about: changed}]\n";
    let t = loaded("extends: third.yaml\nname: mine\n", Some(third)).expect("sound");
    assert_eq!(names(&t), ["a", "c", "b"]);
    assert_eq!(t.parameters[2].about, "changed");
    let t = loaded("extends: t_stub\nname: mine\n", None).expect("sound");
    let (shipped, _) = load("t_stub", Path::new(".")).expect("shipped");
    assert_eq!((t.title, t.parts.len()), (shipped.title, shipped.parts.len()));
}

#[test]
fn wrong_bases_are_one_clear_message_each() {
    let third = "extends: ./mine.yaml\nname: third\n";
    let entry = "extends: ./base.yaml\nname: mine\nparameters: [base, {name: d}]\n";
    let kind = "extends: ./base.yaml\nname: mine\nparameters:\n  - {name: a, kind: lenght}\n";
    for (mine, code, words, file, line) in [
        ("name: m\nextends: t_stab\n", "template/unknown", "did you mean `t_stub`", "mine.yaml", 2),
        ("extends: ./no.yaml\nname: m\n", "template/unreadable", "no.yaml", "mine.yaml", 1),
        ("extends: ./mine.yaml\nname: m\n", "template/circle", "extend each other", "mine.yaml", 1),
        ("extends: third.yaml\nname: m\n", "template/circle", "third.yaml", "third.yaml", 1),
        ("extends: [a]\nname: m\n", "yaml/type", "`extends` is not a text", "mine.yaml", 1),
        ("extends: ./base.yaml\nname: m\nparts: 3\n", "yaml/type", "`parts`", "mine.yaml", 3),
        ("extends: ./base.yaml\nname: m\nbolts: [base]\n", "yaml/type", "bolts", "mine.yaml", 3),
        (entry, "yaml/missing-key", "lacks the key `kind`", "mine.yaml", 3),
        (kind, "yaml/unknown-value", "did you mean `length`?", "mine.yaml", 4),
    ] {
        let faults = loaded(mine, Some(third)).expect_err(mine);
        assert_eq!(faults.len(), 1, "{mine}: {faults:#?}");
        let d = &faults[0];
        assert_eq!(d.code, code, "{mine}: {d:#?}");
        assert!(d.message.contains(words), "{mine}: {d:#?}");
        let place = (d.place.file.as_deref(), d.place.line);
        assert_eq!(place, (Some(Path::new(file)), Some(line)), "{mine}: {d:#?}");
    }
}

/// A list that took the rest of its base twice would double with every file of a chain.
#[test]
fn the_rest_of_a_list_is_taken_once() {
    let text = "extends: ./base.yaml\nname: mine\nparameters: [base, base]\n";
    let d = loaded(text, None).expect_err("twice").remove(0);
    let place = (d.place.file.as_deref(), d.place.path.as_deref());
    assert_eq!(place, (Some(Path::new("mine.yaml")), Some("parameters[3]")), "{d:?}");
}

#[test]
fn a_key_that_is_no_text_is_refused_beside_extends_too() {
    let d = loaded("extends: ./base.yaml\nname: mine\n1: x\n", None).expect_err("a number");
    assert!(d[0].message.contains('1'), "{d:?}");
}

#[test]
fn a_chain_has_an_end() {
    let folder = tempfile::tempdir().expect("a folder");
    for i in 0..20 {
        let text = format!("extends: ./t{}.yaml\nname: t{i}\n", i + 1);
        std::fs::write(folder.path().join(format!("t{i}.yaml")), text).expect("writable");
    }
    let faults = load("./t0.yaml", folder.path()).expect_err("too long");
    let d = faults.into_first();
    assert_eq!(d.code, "template/chain", "{d:?}");
    assert!(d.place.file.is_some_and(|f| f.ends_with("t15.yaml")) && d.help.is_some());
}
