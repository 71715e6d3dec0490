//! Wrong entries of `preload`: each is reported with code, place and remedy.

use super::*;

/// Wrong entry of `preload`, code, part of the message, part of the remedy.
const PRELOAD: &[(&str, &str, &str, &str)] = &[
    (
        "{body: AA, cut: INSIDE, axis: [1, 0, 0], force: 5}",
        "model/unknown-body",
        "no physical volume `AA`",
        "A, B, C",
    ),
    (
        "{body: A, cut: INSIDES, axis: [1, 0, 0], force: 5}",
        "model/unknown-face",
        "did you mean `INSIDE`",
        "INSIDE",
    ),
    (
        "{body: A, cut: INSIDE, axis: [0, 0, 0], force: 5}",
        "model/value",
        "no direction",
        "[1, 0, 0]",
    ),
    (
        "{body: A, cut: INSIDE, axis: [1, 0, 0], force: 0}",
        "model/value",
        "is 0 N",
        "needs no entry",
    ),
    (
        "{body: A, cut: INSIDE, axis: [1, 0, 0], force: -98700}",
        "model/value",
        "is -98700 N",
        "needs no entry",
    ),
    (
        "{body: A, cut: INSIDE, axis: [1, 0, 0], force: .inf}",
        "yaml/not-finite",
        "preload[0].force",
        "finite",
    ),
    ("{body: A, cut: INSIDE, axis: [1, 0], force: 5}", "yaml/type", "axis", ""),
    ("{body: A, cut: INSIDE, axis: [1, 0, 0]}", "yaml/missing-key", "`force`", ""),
    (
        "{body: A, cut: INSIDE, axis: [0, 1, 0], force: 5}",
        "model/preload",
        "runs along the axis",
        "`axis`",
    ),
    (
        "{body: A, cut: LEFT, axis: [1, 0, 0], force: 5}",
        "model/preload",
        "outer faces",
        "BooleanFragments",
    ),
    (
        "{body: A, cut: AB, axis: [1, 0, 0], force: 5}",
        "model/preload",
        "between `",
        "inside the body",
    ),
    (
        "{body: B, cut: BC, axis: [1, 0, 0], force: 5}",
        "model/preload",
        "between `",
        "inside the body",
    ),
    (
        "{body: B, cut: INSIDE, axis: [1, 0, 0], force: 5}",
        "model/preload",
        "inside the body `A`",
        "inside the body",
    ),
    (
        "{body: A, cut: PART, axis: [1, 0, 0], force: 5}",
        "model/preload",
        "does not sever the body `A`",
        "whole cross-section",
    ),
];

#[test]
fn wrong_preloads_name_place_and_remedy() {
    let mut mesh = row();
    let whole = mesh.faces_named("INSIDE").expect("named").triangles.clone();
    mesh.faces
        .push(crate::mesh::NamedFaces { name: "PART".into(), triangles: whole[..1].to_vec() });
    let of = |entries: &str| {
        model(mesh.clone(), &GOOD.replace("loads:", &format!("preload:\n{entries}loads:")))
    };
    for (entry, code, message, help) in PRELOAD {
        let e = of(&format!("  - {entry}\n")).expect_err(entry);
        let d = e.first();
        let text = format!("{} {:?}", d.message, d.place);
        assert_eq!(d.code, *code, "{entry}: {text}");
        assert!(text.contains(message) || d.message.contains(message), "{entry}: {text}");
        let remedy = d.help.clone().unwrap_or_default();
        assert!(remedy.contains(help), "{entry}: {remedy}");
    }
    // the same cut twice
    let good = "  - {body: A, cut: INSIDE, axis: [1, 0, 0], force: 5}\n";
    let e = of(&format!("{good}{good}")).expect_err("twice");
    assert_eq!(e.first().code, "model/face-twice", "{:?}", e.first());
    // and the good one: both halves are one part, and the cut is open between them
    let m = of(good).expect("good");
    assert_eq!(m.parts, ["A", "B+C"]);
    assert_eq!((m.preload.len(), m.preload[0].faces.len(), m.preload[0].closure), (1, 2, None));
    for f in &m.preload[0].faces {
        let x = f.nodes_a.map(|n| m.mesh.nodes[n as usize]);
        assert!(bracket_base::math::vec3::area_vector(&x)[0] > 0.0);
        assert!(f.nodes_a.iter().zip(f.nodes_b).all(|(a, b)| *a != b));
    }
}
