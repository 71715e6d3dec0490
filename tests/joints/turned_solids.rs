//! Templates with turned solids, upright cuts and outlines, against exact values.

use crate::built::{bounds, model};
use bracket::assembly::Joint;
use bracket::catalog::Catalog;
use bracket::checks::design_code::build;
use bracket::mesh::TetMesh;
use bracket::model::AnalysisKind;
use bracket::spec::ConnectionSpec;
use bracket::yaml;
use std::path::Path;

/// A joint of a template of one's own without a profile: a strut along x between x = 0 and 200 mm.
fn strut(solids: &str, rest: &str, load: &str) -> Result<Joint, String> {
    let folder = tempfile::tempdir().unwrap();
    let template = [
        "name: strut\ntitle: Strut\nmembers: []\n",
        "parameters: [{name: slope, kind: angle, default: 0 deg, about: slope}]\n",
        "define:\n  - {name: rise, value: 200 mm * tan(slope)}\n",
        "parts:\n",
        solids,
        "\nsupports:\n  - {name: FOOT, part: A, fix: [x, y, z], face: {axis: x, at: 0 mm, ",
        "y: [-50 mm, 50 mm], z: [-50 mm, 50 mm]}}\n",
        rest,
    ]
    .concat();
    std::fs::write(folder.path().join("strut.yaml"), template).unwrap();
    let spec = format!("template: strut.yaml\nplate: {{steel: S235}}\nfriction: {{mu: 0}}\n{load}");
    let parsed = yaml::parse::<ConnectionSpec>(&spec, Path::new("joint.yaml")).unwrap();
    build(&parsed, folder.path(), &Catalog::builtin().unwrap()).map_err(|e| format!("{e:#?}"))
}

/// The end at x = 200 mm of a part, for a member that slopes.
fn end_of(part: &str) -> String {
    format!(
        "ends:\n  - {{name: far, about: far end, part: {part}, outward: 1, depth: z, slope: slope, \
         face: {{axis: x, at: 200 mm, y: [-50 mm, 50 mm], z: [-50 mm, 150 mm]}}, points: \
         {{bolt_plane: [200 mm, 0 mm, rise]}}}}\n"
    )
}

const PART: &str = "    role: plate\n    steel: [plate]\n    thickness: 10 mm\n    size: 10 mm\n";

/// A bar of 40 x 20 mm between two upright planes, turned by the slope.
fn bar(name: &str, from: &str, to: &str) -> String {
    let cut =
        |x: String| format!("          - box: {{x: [{x}], y: [-1 m, 1 m], z: [-1 m, 1 m]}}\n");
    [
        format!("  - name: {name}\n    label: bar\n{PART}    solids:\n"),
        "      - box: {x: [-100 mm, 400 mm], y: [-20 mm, 20 mm], z: [-10 mm, 10 mm]}\n".into(),
        "        turn: {about: y, by: -slope}\n        cut:\n".into(),
        cut(format!("-1 m, {from}")),
        cut(format!("{to}, 1 m")),
    ]
    .concat()
}

fn volume(mesh: &TetMesh) -> f64 {
    let of = |e| {
        let [a, b, c, d] = mesh.corners(e);
        let edge = |p: [f64; 3]| -> [f64; 3] { std::array::from_fn(|k| p[k] - a[k]) };
        let (u, v, w) = (edge(b), edge(c), edge(d));
        (u[0] * (v[1] * w[2] - v[2] * w[1]) - u[1] * (v[0] * w[2] - v[2] * w[0])
            + u[2] * (v[0] * w[1] - v[1] * w[0]))
            / 6.0
    };
    (0..mesh.tets.len()).map(of).sum::<f64>().abs()
}

/// N along a bar that slopes by 17° between upright ends: A f_y, and its volume is A times its
/// length. The load factor multiplies 1 kN.
#[test]
fn a_sloping_bar_carries_its_area_times_the_yield_strength_along_its_axis() {
    let joint = strut(
        &bar("A", "0 mm", "200 mm"),
        &end_of("A"),
        "parameters: {slope: 17 deg}\nloads: [{name: PULL, end: far, at: bolt_plane, N: 1 kN}]\n",
    )
    .unwrap();
    let (file, mesh) = model(&joint, 1.5, false, AnalysisKind::Limit);
    assert_eq!(file.symmetry, 2, "the plane of the slope is one of symmetry");
    let whole = 40.0 * 20.0 * 200.0 / 17f64.to_radians().cos();
    assert!((2.0 * volume(&mesh) / whole - 1.0).abs() < 1e-6);
    let exact = 40.0 * 20.0 * 0.235;
    let [low, up] = bounds("sloping bar", &file, &mesh);
    assert!(low <= exact && up >= exact * (1.0 - 1e-6), "[{low}, {up}] about {exact}");
    assert!(up / low < 1.02, "[{low}, {up}]");
}

/// The same bar in two pieces, welded on an upright plane: the traction there is σ cos φ. Fillet
/// welds with f_vw,d = 360/(√3 · 0.8 · 1.25) = 207.8 MPa and throats of 3 mm on both sides of 20 mm
/// have S = 2 · 3 · 207.8/20 = 62.4 MPa, so N = S A/cos φ.
#[test]
fn a_weld_across_a_sloping_bar_carries_its_strength_over_the_cosine() {
    let weld = "welds:\n  - {name: WELD, between: [A, B], throat: 3 mm, thickness: 20 mm, \
                imprint: false, face: {axis: x, at: 100 mm, y: [-20 mm, 20 mm], z: [-50 mm, 150 \
                mm]}}\n";
    let joint = strut(
        &(bar("A", "0 mm", "100 mm") + &bar("B", "100 mm", "200 mm")),
        &(weld.to_owned() + &end_of("B")),
        "parameters: {slope: 25 deg}\nloads: [{name: PULL, end: far, at: bolt_plane, N: 1 kN}]\n",
    )
    .unwrap();
    let (file, mesh) = model(&joint, 1.5, false, AnalysisKind::Limit);
    let strength = 2.0 * 3.0 * 360.0 / (3f64.sqrt() * 0.8 * 1.25) / 20.0;
    let exact = strength * 800.0 / 25f64.to_radians().cos() / 1e3;
    let [low, up] = bounds("oblique weld", &file, &mesh);
    assert!(low <= exact && up >= exact * (1.0 - 1e-6), "[{low}, {up}] about {exact}");
    assert!(up / low < 1.02, "[{low}, {up}]");
}

/// An outline that is a rectangle is a box; one with a notch on either side carries the section
/// between them.
#[test]
fn a_prism_carries_what_its_outline_leaves() {
    let prism = |outline: &str| {
        let head = format!("  - name: A\n    label: plate\n{PART}    solids:\n");
        let solid = "      - prism: {axis: y, from: -5 mm, to: 5 mm, outline: [";
        [&head, solid, outline, "]}\n"].concat()
    };
    let load = "loads: [{name: PULL, end: far, at: bolt_plane, N: 1 kN}]\n";
    let of = |outline: &str| {
        let joint = strut(&prism(outline), &end_of("A"), load).unwrap();
        let piece = &joint.content.pieces[0];
        assert_eq!(piece.sizes(), [10.0, 60.0, 200.0]);
        let (file, mesh) = model(&joint, 1.5, false, AnalysisKind::Limit);
        (bounds("prism", &file, &mesh), volume(&mesh) * f64::from(file.symmetry))
    };
    let rectangle = "[0 mm, -30 mm], [200 mm, -30 mm], [200 mm, 30 mm], [0 mm, 30 mm]";
    let ([low, up], whole) = of(rectangle);
    assert!((whole / (10.0 * 60.0 * 200.0) - 1.0).abs() < 1e-6, "{whole}");
    assert!(low <= 141.0 && up >= 141.0 * (1.0 - 1e-6) && up / low < 1.02, "[{low}, {up}]");
    // clockwise, a V of 10 mm on both edges: the section between them is 40 x 10 mm, and the
    // notches hinder its contraction in the plane: up to 2/√3
    let notched = "[0 mm, 30 mm], [90 mm, 30 mm], [100 mm, 20 mm], [110 mm, 30 mm], [200 mm, 30 \
                   mm], [200 mm, -30 mm], [110 mm, -30 mm], [100 mm, -20 mm], [90 mm, -30 mm], [0 \
                   mm, -30 mm]";
    let ([low, up], whole) = of(notched);
    assert!((whole / (10.0 * (60.0 * 200.0 - 200.0)) - 1.0).abs() < 1e-6, "{whole}");
    assert!(up >= 94.0 && low <= 94.0 * 2.0 / 3f64.sqrt(), "[{low}, {up}]");
}

/// What is wrong with a turn or an outline is said with its part.
#[test]
fn wrong_turns_and_outlines_are_refused() {
    let load = "loads: [{name: PULL, end: far, at: bolt_plane, N: 1 kN}]\n";
    let with = |solid: &str| {
        let part = format!("  - name: A\n    label: plate\n{PART}    solids:\n      - {solid}\n");
        strut(&part, &end_of("A"), load).expect_err(solid)
    };
    let prism =
        |rest: &str| format!("{{prism: {{axis: y, from: 0 mm, to: 10 mm, outline: {rest}}}}}");
    let flat = |from: &str, to: &str, rest: &str| {
        let outline = "outline: [[0 mm, 0 mm], [9 mm, 0 mm], [0 mm, 9 mm]]";
        format!("{{prism: {{axis: y, from: {from}, to: {to}, {outline}}}{rest}}}")
    };
    let cube = |rest: &str| {
        format!("{{box: {{x: [0 mm, 9 mm], y: [0 mm, 9 mm], z: [0 mm, 9 mm]}}{rest}}}")
    };
    for (solid, words) in [
        (prism("[[0 mm, 0 mm], [200 mm, 0 mm]]"), "three corners or more"),
        (prism("[[0 mm, 0 mm], [0 mm, 0 mm], [200 mm, 0 mm], [0 mm, 9 mm]]"), "no two at one"),
        (prism("[[0 mm, 0 mm], [200 mm, 0 mm], [0 mm, 30 mm], [200 mm, 30 mm]]"), "cross or touch"),
        (prism("[[0 mm, 0 deg], [200 mm, 0 mm], [0 mm, 30 mm]]"), "angle"),
        (flat("3 mm", "3 mm", ""), "no thickness"),
        (flat("0 mm", "3 mm", ", turn: {about: x, by: 3 deg}"), "about its own axis alone"),
        (cube(", turn: {about: x, by: 3 mm}"), "length"),
        (cube(", prism: {axis: y, from: 0 mm, to: 3 mm, outline: []}"), "one of them"),
    ] {
        let said = with(&solid);
        assert!(said.contains(words) && said.contains('A'), "{solid}: {said}");
    }
    for (slope, words) in [("6", "needs a unit"), ("6 mm", "deg, rad"), ("true", "an angle")] {
        let said = strut(
            &bar("A", "0 mm", "200 mm"),
            &end_of("A"),
            &format!("parameters: {{slope: {slope}}}\n{load}"),
        );
        let said = said.expect_err(slope);
        assert!(said.contains(words) && said.contains("slope"), "{slope}: {said}");
    }
}
