//! Lengths of angles, channels and hollow sections, against exact values of the meshed section.

use crate::built::{bounds, model};
use bracket::assembly::Joint;
use bracket::catalog::Catalog;
use bracket::checks::design_code::build;
use bracket::mesh::TetMesh;
use bracket::model::AnalysisKind;
use bracket::spec::ConnectionSpec;
use bracket::yaml;
use std::path::Path;

/// What support and end, which hinder the contraction of the section, add to what it carries: the
/// lower bounds have up to 4e-5 more than A f_y at 140 mm and 5e-4 at 60 mm.
const HELD: f64 = 1e-4;

const ANY: &str = "[i, angle, channel, rhs, chs]";

/// A length of section along x between a support and an end. Both hold the section across, see [`HELD`].
fn length(
    profile: &str,
    sections: &str,
    entry: &str,
    rest: &str,
    load: &str,
) -> Result<Joint, String> {
    let folder = tempfile::tempdir().unwrap();
    let face = |x: &str| format!("{{axis: x, at: {x}, y: [-1 m, 1 m], z: [-1 m, 1 m]}}");
    let template = format!(
        "name: strut\ntitle: Strut\nmembers:\n  - {{role: strut, about: strut, sections: \
         {sections}, profile: IPE100, steel: S235}}\nparameters: []\nparts:\n  - name: A\n    \
         label: strut\n    role: member\n    steel: [strut]\n    thickness: strut.t\n    size: 2 * strut.t\n    \
         solids:\n      - profile: {{member: strut, along: x, depth: z, from: 0 mm, to: 140 mm\
         {entry}}}\n{rest}supports:\n  - {{name: FOOT, part: A, fix: [x, y, z], face: {}}}\nends:\n  - \
         {{name: far, about: far end, part: A, outward: 1, depth: z, face: {}, points: \
         {{bolt_plane: [140 mm, 0 mm, 0 mm]}}}}\n",
        face("0 mm"),
        face("140 mm"),
    );
    std::fs::write(folder.path().join("strut.yaml"), template).unwrap();
    let spec = format!(
        "template: strut.yaml\nmembers: {{strut: {{profile: {profile}, steel: S235}}}}\nfriction: \
         {{mu: 0}}\nloads: [{{name: LOAD, end: far, at: bolt_plane, {load}}}]\n"
    );
    let parsed = yaml::parse::<ConnectionSpec>(&spec, Path::new("joint.yaml")).unwrap();
    build(&parsed, folder.path(), &Catalog::builtin().unwrap()).map_err(|e| format!("{e:#?}"))
}

/// Volume of a mesh and its centroid times it.
fn moments(mesh: &TetMesh) -> (f64, [f64; 3]) {
    let mut out = (0.0, [0.0; 3]);
    for e in 0..mesh.tets.len() {
        let [a, b, c, d] = mesh.corners(e);
        let edge = |p: [f64; 3]| -> [f64; 3] { std::array::from_fn(|k| p[k] - a[k]) };
        let (u, v, w) = (edge(b), edge(c), edge(d));
        let volume = ((u[0] * (v[1] * w[2] - v[2] * w[1]) - u[1] * (v[0] * w[2] - v[2] * w[0])
            + u[2] * (v[0] * w[1] - v[1] * w[0]))
            / 6.0)
            .abs();
        out.0 += volume;
        for k in 0..3 {
            out.1[k] += volume * (a[k] + b[k] + c[k] + d[k]) / 4.0;
        }
    }
    out
}

fn volume(mesh: &TetMesh) -> f64 {
    moments(mesh).0
}

/// Volume of the meshed length, against the table.
fn meshed(profile: &str, entry: &str, factor: f64) -> f64 {
    let joint = length(profile, ANY, entry, "", "N: 1 kN").unwrap();
    let (file, mesh) = model(&joint, factor, false, AnalysisKind::Limit);
    println!("{profile}: {} tets, symmetry {}", mesh.tets.len(), file.symmetry);
    volume(&mesh) * f64::from(file.symmetry)
}

/// The mesh holds the area of each section, with planes at mid-thickness.
#[test]
fn meshed_lengths_have_the_area_of_their_sections() {
    let catalog = Catalog::builtin().unwrap();
    for (profile, entry, within) in [
        ("CHS114.3x6.3", "", 1e-6),
        ("RHS120x80x6", "", 0.01),
        ("L100x10", "", 0.01),
        ("L100x10", ", flip: [y, z]", 0.01),
        ("UPE100", "", 0.01),
        ("UPN100", ", flip: [y]", 0.01),
    ] {
        let p = catalog.shaped().iter().find(|p| p.name == profile).unwrap();
        let ratio = meshed(profile, entry, 2.0) / (140.0 * 1e2 * p.area) - 1.0;
        println!("{profile}: {ratio}");
        assert!(ratio.abs() < within, "{profile}: {ratio}");
    }
}

/// N = A f_y of the meshed section, and M = W_pl f_y of a tube.
#[test]
fn a_tube_carries_its_area_and_its_plastic_modulus() {
    // corners of a regular polygon with n sides and the area of a circle, radius r: the half above
    // a line through two corners has the first moment S = (R³/6) sin(2π/n) Σ (sin a_i + sin a_i+1)
    let first_moment = |radius: f64| {
        let n = 24;
        let step = std::f64::consts::TAU / f64::from(n);
        let r = radius * (step / step.sin()).sqrt();
        let at = |i: i32| (step * f64::from(i)).sin();
        let sum: f64 = (0..n / 2).map(|i| at(i) + at(i + 1)).sum();
        r.powi(3) * step.sin() * sum / 6.0
    };
    let (d, t) = (48.3, 5.0);
    let area = std::f64::consts::PI * t * (d - t);
    let w_pl = 2.0 * (first_moment(d / 2.0) - first_moment(d / 2.0 - t));
    for (load, exact) in [("N: 1 kN", area * 0.235), ("My: 1 kNm", w_pl * 235e-6)] {
        let joint = length("CHS48.3x5", ANY, "", "", load).unwrap();
        let (file, mesh) = model(&joint, 2.0, false, AnalysisKind::Limit);
        let [low, up] = bounds(load, &file, &mesh);
        println!("{load}: {exact} in [{low}, {up}]");
        let holds = low <= exact * (1.0 + HELD) && up >= exact * (1.0 - 1e-6);
        assert!(holds, "[{low}, {up}] {exact}");
        assert!(up / low < 1.1, "[{low}, {up}]");
    }
}

/// N along an angle, a channel and a rectangular tube through the centroid: A f_y of the meshed
/// section.
#[test]
fn open_and_rectangular_sections_carry_their_area() {
    for profile in ["L50x5", "UPE80", "RHS50x30x5"] {
        let of = |entry: &str| {
            let joint = length(profile, ANY, entry, "", "N: 1 kN").unwrap();
            model(&joint, 2.0, false, AnalysisKind::Limit)
        };
        let (file, mesh) = of("");
        let (volume, moment) = moments(&mesh);
        let exact = volume * f64::from(file.symmetry) / 140.0 * 0.235;
        let (file, mesh) = match profile {
            "L50x5" => {
                let [_, y, z] = moment.map(|m| -m / volume);
                of(&format!(", centre: [0 mm, {y} mm, {z} mm]"))
            }
            "UPE80" => of(&format!(", centre: [0 mm, {} mm, 0 mm]", -moment[1] / volume)),
            _ => (file, mesh),
        };
        let [low, up] = bounds(profile, &file, &mesh);
        let holds = low <= exact * (1.0 + HELD) && up >= exact * (1.0 - 1e-6);
        assert!(holds, "[{low}, {up}] {exact}");
        assert!(up / low < 1.03, "[{low}, {up}]");
    }
}

/// Wrong sections and entries are refused with their place.
#[test]
fn wrong_sections_are_refused() {
    let with = |profile: &str, sections: &str, entry: &str, rest: &str| {
        length(profile, sections, entry, rest, "N: 1 kN").expect_err(profile)
    };
    let turned = "        turn: {about: y, by: 10 deg}\n";
    for (said, words) in [
        (with("RHS120x80x6", "[i]", "", ""), "members are I or H sections"),
        (with("L100x10", "[rhs, chs]", "", ""), "L100x10 is an angle"),
        (with("L100x10", "[rhs, chs]", "", ""), "rectangular hollow section or a circular"),
        (with("CHS114x6", ANY, "", ""), "CHS114.3x6.3"),
        (with("RHS120x80x6", ANY, ", flip: [y]", ""), "leave it out"),
        (with("UPE100", ANY, ", flip: [z]", ""), "`flip` along z"),
        (with("L100x10", ANY, ", flip: [x]", ""), "`flip` along x"),
        (with("CHS114.3x6.3", ANY, "", turned), "cannot be turned"),
    ] {
        assert!(said.contains(words), "{words}: {said}");
    }
}
