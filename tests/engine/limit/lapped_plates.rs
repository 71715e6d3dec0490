//! Two plates lapped with one bolt: tension and shear of the bolt as in EN 1993-1-8 Table 3.4,
//! bearing of either ply and punching, as limits on the resultants of cuts of the bolt.

use super::resultant_limits::model;
use crate::common::grid::Grid;
use crate::common::limit::sharp_factors;
use crate::common::triangles_where;
use crate::common::yielding::FY;
use bracket::mesh::NamedFaces;
use bracket::model::AnalysisModel;
use std::f64::consts::PI;

/// Two rigid plates of 4 mm lapped with one bolt. The bolt is square, 4 x 4 mm, with heads of 8 x
/// 8 mm, and touches the plates without friction. It has cuts between the plates and under both
/// heads.
///
/// ```text
///          ┌────┐        z = 11
///   ───────┴────┴───     z = 8    UPPER, pulled along x and z
///   ─────────┐┌─────     z = 4
///   ───────┬────┬───     z = 0    LOWER, held
///          └────┘        z = -3
/// ```
fn lapped(force: [f64; 3], limits: &str) -> AnalysisModel {
    let across = vec![-8.0, -4.0, -2.0, 0.0, 2.0, 4.0, 8.0];
    let planes = [across.clone(), across, vec![-3.0, 0.0, 2.0, 4.0, 6.0, 8.0, 11.0]];
    let body = |c: [f64; 3]| {
        let within = |half: f64| c[0].abs() < half && c[1].abs() < half;
        match c[2] {
            z if !(0.0..8.0).contains(&z) => within(4.0).then_some(0),
            _ if within(2.0) => Some(0),
            z => Some(if z < 4.0 { 1 } else { 2 }),
        }
    };
    let mut mesh = Grid::new(planes).mesh(&["BOLT", "LOWER", "UPPER"], body, |_, _| true);
    for z in [0.0, 4.0, 8.0] {
        let on = |x: [f64; 3]| x[2] == z && x[0].abs() <= 2.0 && x[1].abs() <= 2.0;
        let triangles = triangles_where(&mesh, on);
        mesh.faces.push(NamedFaces { name: format!("CUT{z}"), triangles });
    }
    for (name, x, low) in [("HELD", -8.0, 0.0), ("PULLED", 8.0, 4.0)] {
        let on = |p: [f64; 3]| p[0] == x && p[2] >= low && p[2] <= low + 4.0;
        mesh.faces.push(NamedFaces { name: name.into(), triangles: triangles_where(&mesh, on) });
    }
    let contact = |a: &str, b: &str| format!("- {{between: [{a}, {b}], law: contact, mu: 0}}\n");
    let contacts =
        [("BOLT", "LOWER"), ("BOLT", "UPPER"), ("LOWER", "UPPER")].map(|(a, b)| contact(a, b));
    let cuts = ["0", "4", "8"].map(|z| format!("- {{body: BOLT, cut: CUT{z}, axis: [0, 0, 1]}}\n"));
    let text = format!(
        "bodies: {{BOLT: s, LOWER: r, UPPER: r}}\ninterfaces:\n{}supports:\n- {{face: HELD, fix: \
         [x, y, z]}}\nrigid:\n- {{face: PULLED, components: [x, y, z], free: [ux, uy, uz], at: [8, \
         0, 6], force: {force:?}}}\ncuts:\n{}resultant_limits:\n{limits}",
        contacts.concat(),
        cuts.concat()
    );
    model(&text, mesh)
}

/// The bolt of [`lapped`]: F_t,Rd, F_v,Rd and their interaction in every cut.
fn bolt_of_lap(tension: f64, shear: f64) -> String {
    let kappa = shear / (1.4 * tension);
    let in_cut = |z: &str| {
        let across = "[[1, 0, 0], [0, 1, 0]]";
        format!(
            "- {{name: tension {z}, cuts: [CUT{z}], along: [0, 0, 1], at_most: {tension:?}}}\n- \
             {{name: shear {z}, cuts: [CUT{z}], across: {across}, at_most: {shear:?}}}\n- {{name: \
             both {z}, cuts: [CUT{z}], along: [0, 0, {kappa:?}], across: {across}, at_most: \
             {shear:?}}}\n"
        )
    };
    ["0", "4", "8"].map(in_cut).concat()
}

/// Both bounds within 1e-4 of the resistance of the lap, on either side of it.
fn carries(name: &str, m: &AnalysisModel, want: f64) {
    let [low, up] = sharp_factors(name, m).map(|x| x * FY);
    println!("{name}: [{low}, {up}] for {want}");
    assert!(
        low <= want * (1.0 + 1e-9) && up >= want * (1.0 - 1e-9),
        "{name}: [{low}, {up}], {want}"
    );
    assert!(
        (low / want - 1.0).abs() < 1e-4 && (up / want - 1.0).abs() < 1e-4,
        "{name}: [{low}, {up}], {want}"
    );
}

/// One bolt in two plates by Table 3.4 at eight directions of the force.
#[test]
fn a_lap_in_tension_and_shear() {
    let (tension, shear) = (600.0, 480.0);
    for i in 0..8 {
        let angle = f64::from(i) / 7.0 * PI / 2.0;
        let (n, v) = (angle.cos(), angle.sin());
        let both = shear / (v + shear / (1.4 * tension) * n);
        let want = both.min(tension / n.max(1e-12));
        let m = lapped([v, 0.0, n], &bolt_of_lap(tension, shear));
        carries(&format!("{:.0} degrees from the axis", angle.to_degrees()), &m, want);
    }
}

/// Bearing of the bolt on either ply, and punching under a head, each below the resistance of the
/// bolt itself.
#[test]
fn a_lap_in_bearing_and_punching() {
    let bearing = |cuts: &str, along: f64, most: f64| {
        format!("- {{name: bearing, {cuts}, along: [{along}, 0, 0], at_most: {most:?}}}\n")
    };
    let bolt = bolt_of_lap(600.0, 480.0);
    let upper = "cuts: [CUT4], minus: [CUT8]";
    let lower = "cuts: [CUT0], minus: [CUT4]";
    for (name, force, limit, want) in [
        // the upper ply pushes the bolt along x, the lower one against it
        ("upper ply", [1.0, 0.0, 0.0], bearing(upper, 1.0, 300.0), 300.0),
        ("upper ply, other sense", [1.0, 0.0, 0.0], bearing(upper, -1.0, 300.0), 480.0),
        ("lower ply", [1.0, 0.0, 0.0], bearing(lower, -1.0, 250.0), 250.0),
        ("pushed back", [-1.0, 0.0, 0.0], bearing(lower, 1.0, 200.0), 200.0),
        (
            "punching",
            [0.0, 0.0, 1.0],
            "- {name: punching, cuts: [CUT8], along: [0, 0, 1], at_most: 350}\n".into(),
            350.0,
        ),
    ] {
        carries(name, &lapped(force, &format!("{bolt}{limit}")), want);
    }
}
