//! Wrong inputs: each is reported in one message with code, line and remedy.

use super::*;

/// Old text, new text, code, line, part of the message, part of the remedy.
const WRONG: &[(&str, &str, &str, usize, &str, &str)] = &[
    (
        "analysis: elastic\nmaterials: {steel: {E: 210000, nu: 0.3}}\nbodies: {A: steel, B: \
         steel, C: steel}\ninterfaces:\n  - {between: [B, A], law: contact, mu: 0.3, friction: \
         associated}\n",
        "analysis: limit\nmaterials: {steel: {E: 210000, nu: 0.3}}\nbodies: {A: steel, B: steel, \
         C: steel}\n",
        "model/never-yields",
        3,
        "no body has a yield strength and no interface can open or slip",
        "bodies without one are rigid",
    ),
    (
        "E: 210000",
        "E: -1",
        "model/value",
        3,
        "`E` of material `steel` is -1, it must be 1e-9 MPa to 1e15 MPa",
        "210000",
    ),
    ("nu: 0.3}", "nu: 0.5}", "model/value", 3, "`nu` of material `steel` is 0.5", "0.4999"),
    ("nu: 0.3}", "nu: 0.499995}", "model/value", 3, "and at most 0.49999", "0.4999"),
    ("nu: 0.3}", "nu: 0.3, fy: 1e12}", "model/value", 3, "1e-9 MPa to 1e9 MPa", "leave `fy` out"),
    ("nu: 0.3}", "nu: .nan}", "yaml/not-finite", 3, "materials.steel.nu", "finite"),
    (
        "nu: 0.3}",
        "nu: 0.3, fy: 0}",
        "model/value",
        3,
        "`fy` of material `steel` is 0",
        "leave `fy` out",
    ),
    (
        "nu: 0.3}",
        "nu: 0.3, rho: 7}",
        "yaml/unknown-key",
        3,
        "unknown key `rho` in `materials.steel`",
        "E, nu, fy",
    ),
    (
        "B: steel, ",
        "",
        "model/no-material",
        4,
        "body `B` of the mesh has no material",
        "add `B: MATERIAL`",
    ),
    (
        "B: steel, ",
        "B: steel, B: steel, ",
        "yaml/duplicate-key",
        4,
        "`B` in `bodies` stands twice",
        "keep one",
    ),
    (
        "C: steel}",
        "C: steal}",
        "model/unknown-material",
        4,
        "did you mean `steel`?",
        "the materials are: steel",
    ),
    (
        "C: steel}",
        "C: steel, BOLT: steel}",
        "model/unknown-body",
        4,
        "no physical volume `BOLT`",
        "A, B, C",
    ),
    (
        "[B, A]",
        "[B, D]",
        "model/unknown-body",
        6,
        "no physical volume `D`",
        "the bodies are: A, B, C",
    ),
    ("[B, A]", "[A, A]", "model/interface", 6, "`A` is named twice", "two different"),
    (
        "[B, A]",
        "[C, A]",
        "model/no-contact",
        6,
        "the bodies `C` and `A` have no face in common",
        "nodes: split",
    ),
    (
        "between: [B, A]",
        "face: A_B",
        "model/unknown-face",
        6,
        "no physical surface `A_B`, did you mean `AB`?",
        "LEFT, INSIDE",
    ),
    (
        "between: [B, A]",
        "face: INSIDE",
        "model/no-contact",
        6,
        "lies inside the body `A`",
        "two bodies",
    ),
    (
        "between: [B, A]",
        "face: LEFT",
        "model/no-contact",
        6,
        "2 of the 2 triangles of `LEFT` are outer faces",
        "two bodies",
    ),
    (
        "between: [B, A]",
        "between: [B, A], face: BC",
        "model/no-contact",
        6,
        "no face in common on `BC`",
        "pair",
    ),
    ("between: [B, A], ", "", "model/interface", 6, "needs `between`", "between: [BODY_A, BODY_B]"),
    (
        "supports:",
        "  - {face: AB, law: tied}\nsupports:",
        "model/face-twice",
        7,
        "already named by interfaces[0]",
        "once",
    ),
    ("mu: 0.3, ", "", "model/contact", 6, "needs its friction coefficient", "mu: 0"),
    ("mu: 0.3", "mu: -0.1", "model/value", 6, "`mu` is -0.1", "mu: 0"),
    ("mu: 0.3", "mu: 0.3, gap: -1", "model/value", 6, "the gap of `B-A` is -1 mm", "overlap"),
    (
        "mu: 0.3",
        "mu: 0.3, gap: {quadratic: [0.4, 0, -0.05, 0, 0, 0, 0, 0, 0, 0]}",
        "model/value",
        6,
        "(20, 10, ",
        "overlap",
    ),
    ("friction: associated", "friction: columb", "yaml/unknown-value", 6, "columb", "coulomb"),
    (
        "friction: associated",
        "throat: 5",
        "model/interface",
        6,
        "`throat` has no meaning for `law: contact`",
        "remove",
    ),
    (
        "contact, mu: 0.3, friction: associated",
        "weld, throat: 5",
        "model/interface",
        6,
        "the weld lacks `thickness` and `strength`",
        "strength_traction",
    ),
    (
        "contact, mu: 0.3, friction: associated",
        "tied, mu: 0.3",
        "model/interface",
        6,
        "`mu` has no meaning for `law: tied`",
        "remove",
    ),
    ("face: LEFT", "face: LEFD", "model/unknown-face", 8, "did you mean `LEFT`?", "RIGHT"),
    (
        "face: LEFT",
        "face: AB",
        "model/not-outer",
        8,
        "lie in the contact between `A` and `B`",
        "free outer faces",
    ),
    (
        "face: LEFT",
        "face: BC",
        "model/not-outer",
        8,
        "between the bodies `B` and `C`, which are tied",
        "free outer faces",
    ),
    ("face: LEFT", "face: INSIDE", "model/not-outer", 8, "lie inside body `A`", "free outer faces"),
    ("fix: [x, y, z]", "fix: [x, x]", "model/value", 8, "`x` is listed twice", "once"),
    ("fix: [x, y, z]", "fix: [x, w]", "yaml/unknown-value", 8, "`w` is not a value", "x, y, z"),
    (
        "fix: [x, y, z]",
        "law: tied",
        "model/support",
        8,
        "a law other than contact",
        "fix: [x, y, z]",
    ),
    (
        ", fix: [x, y, z]",
        "",
        "model/support",
        8,
        "needs either `fix` or `law: contact`",
        "fix: [x, y, z]",
    ),
    (
        "fix: [x, y, z]",
        "fix: [x], law: contact, mu: 0",
        "model/support",
        8,
        "either `fix` or",
        "fix: [x, y, z]",
    ),
    (
        "fix: [x, y, z]",
        "fix: [x, y, z], mu: 0.3",
        "model/support",
        8,
        "have no effect on the fixed face",
        "law: contact",
    ),
    (
        "loads:",
        "  - {face: LEFT, law: contact, mu: 0}\nloads:",
        "model/held-twice",
        9,
        "component x of the face `LEFT`",
        "leave the component out",
    ),
    (
        "loads:",
        "rigid:\n  - {face: LEFT, components: [z]}\nloads:",
        "model/held-twice",
        10,
        "component z of the face `LEFT` is rigid and also fixed",
        "leave",
    ),
    (
        "loads:",
        "rigid:\n  - {face: RIGHT, components: []}\nloads:",
        "model/rigid",
        10,
        "no components",
        "[x, y, z]",
    ),
    (
        "loads:",
        "rigid:\n  - {face: RIGHT, components: [x], force: [5, 0, 0]}\nloads:",
        "model/rigid",
        10,
        "a force in a motion that is held: `ux`",
        "add `ux` to `free`",
    ),
    (
        "loads:",
        "rigid:\n  - {face: RIGHT, components: [x], free: [uy]}\nloads:",
        "model/rigid",
        10,
        "`uy` of the rigid face `RIGHT` is not independent of its other free motions in [x]",
        "remove it",
    ),
    (
        "loads:",
        "rigid:\n  - {face: RIGHT, components: [y], free: [uy, rz]}\nloads:",
        "model/rigid",
        10,
        "`rz` of the rigid face",
        "remove it",
    ),
    (
        "traction: [-1, 0, 0]",
        "traction: [-1, 0, 0], pressure: 1",
        "model/load",
        10,
        "exactly one of",
        "divide a force",
    ),
    (
        "traction: [-1, 0, 0]",
        "force: [-1, 0, 0]",
        "model/load",
        10,
        "exactly one of",
        "divide a force",
    ),
    ("traction: [-1, 0, 0]", "traction: [-1, 0]", "yaml/type", 10, "array of length 3", "schema"),
    (
        "face: RIGHT, traction: [-1, 0, 0]",
        "body: C, pressure: 1",
        "model/load",
        10,
        "needs `force`",
        "N/mm³",
    ),
    ("face: RIGHT, traction", "traction", "model/load", 10, "on exactly one of them", "face: NAME"),
    (
        "face: RIGHT, traction: [-1, 0, 0]",
        "body: CC, force: [1, 0, 0]",
        "model/unknown-body",
        10,
        "did you mean `C`?",
        "A, B, C",
    ),
    ("loads:", "symmetry: 3\nloads:", "model/value", 9, "`symmetry` is 3", "1, 2, 4 or 8"),
    ("loads:", "adapt: {target_gap: 5}\nloads:", "model/value", 9, "`target_gap` is 5", "0.05"),
    ("loads:", "adapt: {target_gap: 0}\nloads:", "model/value", 9, "`target_gap` is 0", "0.05"),
    (
        "loads:",
        "adapt: {target_gap: .nan}\nloads:",
        "yaml/not-finite",
        9,
        "adapt.target_gap",
        "finite",
    ),
    (
        "loads:",
        "adapt: {target_gap: 0.1, max_passes: 0}\nloads:",
        "model/value",
        9,
        "`max_passes` is 0",
        "leave it out",
    ),
    (
        "loads:",
        "adapt: {target_gap: 0.1, max_macro_tets: 0}\nloads:",
        "model/value",
        9,
        "`max_macro_tets` is 0",
        "leave it out",
    ),
    ("loads:", "load: []\nloads:", "yaml/unknown-key", 9, "did you mean `loads`?", "loads, dead"),
];

#[test]
fn wrong_models_name_place_and_remedy() {
    for (old, new, code, line, message, help) in WRONG {
        assert!(GOOD.contains(old), "{old}");
        let text = GOOD.replacen(old, new, 1);
        let faults = model(row(), &text).expect_err(&text);
        let d = &faults.first();
        assert_eq!((d.code, d.place.line), (*code, Some(*line)), "{new}: {d:?}");
        assert!(d.message.contains(message), "{new}: {d:?}");
        assert!(d.help.as_deref().unwrap_or("").contains(help), "{new}: {d:?}");
        assert_eq!(d.place.file.as_deref(), Some(Path::new("model.yaml")));
        assert_eq!(faults.exit_code(), 2);
    }
}

#[test]
fn several_faults_are_reported_together() {
    let text =
        GOOD.replace("C: steel", "C: steal").replace("LEFT", "LEFD").replace("mu: 0.3", "mu: -1");
    let codes: Vec<_> = model(row(), &text).expect_err("three").iter().map(|d| d.code).collect();
    assert_eq!(codes, ["model/unknown-material", "model/value", "model/unknown-face"]);
}

#[test]
fn bodies_apart_are_not_in_contact() {
    // each body has its own nodes in the mesh, but the file states that they are shared
    let d = model(explode(&row()), GOOD).expect_err("apart").into_first();
    assert_eq!(d.code, "model/no-contact");
    assert!(d.help.expect("help").contains("nodes: split"));
    // without an interface between the bodies a note reports it
    let text =
        GOOD.replace("  - {between: [B, A], law: contact, mu: 0.3, friction: associated}\n", "");
    let text = text.replace("interfaces:\n", "").replace("face: RIGHT", "face: LEFT");
    let m = model(explode(&row()), &text).expect("three bodies apart");
    assert!(
        m.notes
            .iter()
            .any(|n| n.to_string().contains("12 nodes") || n.to_string().contains("8 nodes")),
        "{:?}",
        m.notes
    );
    assert_eq!(m.parts, ["A", "B", "C"]);
}
