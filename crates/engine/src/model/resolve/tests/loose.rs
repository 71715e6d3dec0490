//! Parts that can move.

use super::*;
use bracket_base::math::rigid_motion::rigid_displacement;

fn text(interfaces: &str, rest: &str, bodies: &str) -> String {
    format!(
        "mesh: m.msh\nanalysis: elastic\nmaterials: {{s: {{E: 210000, nu: 0.3}}}}\nbodies: \
         {bodies}\n{interfaces}\n{rest}\n"
    )
}

fn loose(mesh: TetMesh, text: &str) -> String {
    let d = model(mesh, text).expect_err("loose").into_first();
    assert_eq!((d.code, d.fault.exit_code()), ("model/loose-part", 2), "{d:?}");
    assert!(d.help.expect("help").contains("support"));
    d.message
}

const ALL: &str = "{A: s, B: s, C: s}";

#[test]
fn frictionless_contact_lets_a_part_slide() {
    let contact = "interfaces: [{between: [A, B], law: contact, mu: 0}]\nsupports: [{face: LEFT, \
                   fix: [x, y, z]}]";
    // pressed on: three free motions in the plane of contact, on which the pressure does no work
    let m = model(row(), &text(contact, "loads: [{face: RIGHT, traction: [-1, 0, 0]}]", ALL))
        .expect("pressed");
    assert_eq!((m.parts.len(), m.free_modes.len(), m.notes.len()), (2, 3, 3));
    for mode in &m.free_modes {
        assert_eq!(mode.motions[0], [0.0; 6]);
        for x in [[20.0, 0.0, 0.0], [20.0, 10.0, 0.0], [20.0, 0.0, 10.0]] {
            assert!(rigid_displacement(&mode.motions[1], [0.0; 3], x)[0].abs() < 1e-9, "{mode:?}");
        }
    }
    for words in
        ["part B+C can move along y", "part B+C can move along z", "part B+C can turn about x"]
    {
        assert_eq!(
            m.notes.iter().filter(|n| n.to_string().starts_with(words)).count(),
            1,
            "{:?}",
            m.notes
        );
    }
    // with weight it falls
    let why = loose(row(), &text(contact, "loads: [{body: B, force: [0, 0, -1.0e-4]}]", ALL));
    assert!(why.starts_with("part B+C can move along z"), "{why}");
    // friction counts as holding
    let rough = contact.replace("mu: 0", "mu: 0.1, friction: associated");
    let m = model(row(), &text(&rough, "loads: [{body: B, force: [0, 0, -1.0e-4]}]", ALL))
        .expect("rough");
    assert!(m.free_modes.is_empty());
}

#[test]
fn a_body_in_free_space() {
    let bare = |loads: &str| text("", loads, ALL);
    let m = model(row(), &bare("")).expect("no load, no support");
    assert_eq!(m.free_modes.len(), 6);
    assert!(m.notes[0].to_string().contains("no load"));
    // loads in equilibrium
    let pull = "loads: [{face: LEFT, traction: [-1, 0, 0]}, {face: RIGHT, pressure: -1}]";
    let m = model(row(), &bare(pull)).expect("pulled at both ends");
    assert_eq!(m.free_modes.len(), 6);
    // three translations, three rotations about axes through the middle
    for (words, n) in [("move along", 3), ("turn about", 3), ("through (20, 5, 5)", 3)] {
        assert_eq!(
            m.notes.iter().filter(|w| w.to_string().contains(words)).count(),
            n,
            "{:?}",
            m.notes
        );
    }
    let why = loose(row(), &bare("loads: [{face: RIGHT, traction: [-1, 0, 0]}]"));
    assert!(why.starts_with("part A+B+C can move along x;"), "{why}");
    // a couple
    let why = loose(
        row(),
        &bare("loads: [{face: LEFT, traction: [0, -1, 0]}, {face: RIGHT, traction: [0, 1, 0]}]"),
    );
    assert!(why.starts_with("part A+B+C can turn about z through (20, 5, 5);"), "{why}");
}

#[test]
fn loads_of_any_size_are_judged_alike() {
    for scale in ["e-9", "e0", "e9"] {
        let pull = format!(
            "loads: [{{face: LEFT, traction: [-1.0{scale}, 0, 0]}}, {{face: RIGHT, traction: \
             [1.0{scale}, 0, 0]}}]"
        );
        assert_eq!(model(row(), &text("", &pull, ALL)).expect("in balance").free_modes.len(), 6);
        let push = format!("loads: [{{face: LEFT, traction: [-1.0{scale}, 0, 0]}}]");
        assert!(loose(row(), &text("", &push, ALL)).contains("along x"));
    }
}

#[test]
fn parts_that_touch_in_an_edge_are_loose() {
    let mut mesh = cubes(&[([0, 0, 0], "BASE"), ([1, 1, 0], "TOP")]);
    name(&mut mesh, "DOWN", |x| x[1] == 0.0);
    name(&mut mesh, "UP", |x| x[1] == 20.0);
    let rest = "supports: [{face: DOWN, fix: [x, y, z]}]\nloads: [{face: UP, traction: [0, 3, 0]}]";
    let t = text("", rest, "{BASE: s, TOP: s}");
    let why = loose(mesh.clone(), &t);
    assert!(why.starts_with("part TOP can move along y"), "{why}");
    // one body in two pieces: the pieces are numbered
    let mut one = cubes(&[([0, 0, 0], "B"), ([2, 0, 0], "B")]);
    name(&mut one, "DOWN", |x| x[2] == 0.0 && x[0] <= 10.0);
    let t = text(
        "",
        "supports: [{face: DOWN, fix: [x, y, z]}]\nloads: [{body: ALL, force: [0, 0, -1]}]",
        "{B: s}",
    );
    let why = loose(one, &t);
    assert!(why.starts_with("part B#2 can move along z"), "{why}");
}

#[test]
fn supports_hold_what_they_hold() {
    // x fixed on one end: it may still slide along y and z and turn about x
    let t = text(
        "",
        "supports: [{face: LEFT, fix: [x]}]\nloads: [{face: RIGHT, traction: [1, 0, 0]}]",
        ALL,
    );
    assert_eq!(model(row(), &t).expect("pulled").free_modes.len(), 3);
    let t = text(
        "",
        "supports: [{face: FLOOR, law: contact, mu: 0}]\nloads: [{body: ALL, force: [0, 0, -1]}]",
        ALL,
    );
    assert_eq!(model(row(), &t).expect("lies on the floor").free_modes.len(), 3);
    let t = text(
        "",
        "supports: [{face: FLOOR, law: contact, mu: 0}]\nloads: [{body: ALL, force: [0, 1, -1]}]",
        ALL,
    );
    assert!(loose(row(), &t).starts_with("part A+B+C can move along y;"));
}

#[test]
fn rigid_faces_hold_their_held_motions() {
    let rigid = |free: &str, more: &str| {
        let r = format!(
            "rigid: [{{face: RIGHT, components: [x, y, z], free: [{free}], at: [40, 5, 5]{more}}}]"
        );
        text("", &r, ALL)
    };
    assert!(model(row(), &rigid("", "")).expect("all held").free_modes.is_empty());
    let m = model(row(), &rigid("rz, ux", "")).expect("two free, no action");
    assert_eq!(m.free_modes.len(), 2);
    let why = loose(row(), &rigid("rz, ux", ", moment: [0, 0, 1.0e6]"));
    assert!(why.starts_with("part A+B+C can turn about z through (40, 5, "), "{why}");
    let why = loose(row(), &rigid("rz, ux", ", dead_force: [2, 0, 0]"));
    assert!(why.starts_with("part A+B+C can move along x;"), "{why}");
    // held at the other end: the action is carried
    let held = format!(
        "{}\nsupports: [{{face: LEFT, fix: [x, y, z]}}]",
        rigid("rz, ux", ", moment: [0, 0, 1.0e6]")
    );
    assert!(model(row(), &held).expect("held").free_modes.is_empty());
}

#[test]
fn two_parts_may_move_together() {
    let t = text(
        "interfaces: [{between: [A, B], law: contact, mu: 0.3, friction: associated}]",
        "loads: [{face: RIGHT, traction: [-1, 0, 0]}]",
        ALL,
    );
    let why = loose(row(), &t);
    assert!(why.starts_with("parts A, B+C can move along x together;"), "{why}");
}
