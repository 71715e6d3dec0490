//! Columns and plates that contacts, welds, preloaded cuts and rigid faces join or hold.
//!
//! ```text
//!   cantilever on the ground     stack of two plates
//!        |  |                    →|=========|←  t₁     k π² (D₁ + D₂) / b² (t₁ + t₂) where they
//!        |  |                    →|~~~~~~~~~|←         touch, k π² D₁ / b² t₁ where they do not
//!      __|__|__                  →|=========|←  t₂
//! ```

use super::{E, OPTIONS, field, pressed, zero};
use crate::common::solved::{resolve, solve};
use crate::common::{Block, mapped, triangles_where};
use bracket::certify::fields::{DisplacementField, StressField};
use bracket::estimate::buckling::{Buckling, buckling};
use bracket::mesh::{NamedFaces, TetMesh};
use bracket::model::AnalysisModel;
use std::f64::consts::PI;

/// Depth, width and height of the column.
const COLUMN: [f64; 3] = [10.0, 5.0, 100.0];

fn column() -> TetMesh {
    let below = |x: [f64; 3]| usize::from(x[2] > 50.0);
    let mut mesh = Block::new([2, 1, 12], COLUMN).mesh(&["A", "B"], below, |_, _| false);
    let triangles = triangles_where(&mesh, |x| x[2] == 25.0);
    mesh.faces.push(NamedFaces { name: "CUT".into(), triangles });
    mesh
}

fn model(rest: &str) -> AnalysisModel {
    let yaml = format!("materials: {{s: {{E: {E:?}, nu: 0.0}}}}\nbodies: {{A: s, B: s}}\n{rest}");
    resolve(&yaml, column()).expect("a sound model")
}

/// The buckling of a model under unit compression along z.
fn along_z(model: &AnalysisModel) -> Buckling {
    let stress = field(model, |_| [0.0, 0.0, -1.0, 0.0, 0.0, 0.0]);
    buckled(model, &stress)
}

fn buckled(model: &AnalysisModel, stress: &StressField) -> Buckling {
    buckling(model, &zero(model), stress, &OPTIONS).expect("an answer")
}

/// Euler's stress for the effective length, with the flexibility to shear (Engesser).
fn euler(length: f64) -> f64 {
    let stress = PI * PI * E * COLUMN[1].powi(2) / (12.0 * length * length);
    1.0 / (1.0 / stress + 1.2 / (0.5 * E))
}

/// The first factor is that of a column of the effective length, to half a percent.
fn is_column(name: &str, found: &Buckling, length: f64) {
    let factor = found.modes[0].factor;
    println!("{name}: {factor:.3}, closed form {:.3}", euler(length));
    assert!((factor / euler(length) - 1.0).abs() < 5e-3, "{name}: {factor} {}", euler(length));
}

#[test]
fn a_cantilever_with_a_weld_or_a_preloaded_cut_is_one_piece() {
    let clamped = "supports:\n- {face: Z0, fix: [x, y, z]}\nloads: []\n";
    let plain = along_z(&model(clamped));
    is_column("tied", &plain, 200.0);
    let weld = "interfaces:\n- {between: [A, B], law: weld, strength_traction: 1}\n";
    let welded = model(&format!("{weld}{clamped}"));
    assert_eq!(welded.welds.len(), 1);
    let found = along_z(&welded);
    is_column("welded", &found, 200.0);
    assert!((found.modes[0].factor / plain.modes[0].factor - 1.0).abs() < 1e-9);
    let preload = "preload:\n- {body: A, cut: CUT, axis: [0, 0, 1], force: 100}\n";
    let cut = model(&format!("{preload}{clamped}"));
    assert!(cut.preload[0].faces.len() == 4 && cut.preload[0].closure.is_none());
    let found_cut = along_z(&cut);
    assert!((found_cut.modes[0].factor / plain.modes[0].factor - 1.0).abs() < 1e-9);
    // the lower half is bent more
    let shares = &found.modes[0].share_by_body;
    assert!((shares.iter().sum::<f64>() - 1.0).abs() < 1e-12);
    // ∫ cos² over the halves
    assert!((shares[0] - (0.5 + 1.0 / PI)).abs() < 0.02, "{shares:?}");
}

#[test]
fn a_closed_contact_clamps_the_foot_of_a_column() {
    for (mu, name) in [("0", "smooth"), ("0.3, friction: associated", "rough")] {
        let on_ground = format!(
            "supports:\n- {{face: Z0, law: contact, mu: {mu}}}\nloads:\n- {{face: Z1, traction: \
             [0, 0, -1]}}\n"
        );
        let found = along_z(&model(&on_ground));
        is_column(name, &found, 200.0);
        // it slides in two directions and turns
        assert_eq!((found.held_motions, found.closed_faces, found.contact_faces), (3, 4, 4));
    }
}

#[test]
fn rigid_ends_are_hinges() {
    let ends = "rigid:\n- {face: Z0, components: [x, y, z], free: [rx], at: [5, 2.5, 0]}\n- \
                {face: Z1, components: [x, y, z], free: [uz, rx], at: [5, 2.5, 100], force: [0, 0, \
                -50]}\nloads: []\n";
    is_column("hinged", &along_z(&model(ends)), 100.0);
}

/// The two fields of a run give the same factor as the exact stress.
#[test]
fn fields_of_an_analysis_buckle_as_the_exact_ones() {
    let yaml = format!(
        "materials: {{s: {{E: {E:?}, nu: 0.0}}}}\nbodies: {{A: s, B: s}}\ninterfaces:\n- \
         {{between: [A, B], law: contact, mu: 0}}\nsupports:\n- {{face: Z0, fix: [x, y, \
         z]}}\nloads:\n- {{face: Z1, traction: [0, 0, -1]}}\n"
    );
    let solved = solve(&yaml, column());
    let (u, stress) = (solved.pass.displacement.expect("u"), solved.pass.stress.expect("σ"));
    let found = buckling(&solved.model, &u, &stress, &OPTIONS).expect("an answer");
    assert_eq!((found.held_motions, found.closed_faces), (3, 4));
    // a column that is free to slide at half of its height, where nothing shears it
    let exact = along_z(&solved.model);
    assert!((found.modes[0].factor / exact.modes[0].factor - 1.0).abs() < 1e-6);
    // lifted, the upper half is loose in every direction
    let lifted = DisplacementField {
        u: (0..u.u.len())
            .map(|i| if on_b(&solved.model, i) { [0.0, 0.0, 1.0] } else { u.u[i] })
            .collect(),
    };
    let open = buckling(&solved.model, &lifted, &stress, &OPTIONS).expect("an answer");
    assert_eq!((open.held_motions, open.closed_faces), (6, 0));
}

fn on_b(model: &AnalysisModel, node: usize) -> bool {
    let space = bracket::elements::space::Tet10Space::new(&model.mesh);
    let vertex = space.a_vertex(node) as u32;
    let tets = model.mesh.tets.iter().zip(&model.mesh.tet_body);
    tets.filter(|(_, b)| **b == 1).any(|(t, _)| t.contains(&vertex))
}

/// Two square plates of the thicknesses 1 and 2, a quarter of each, one on the other.
fn stack() -> AnalysisModel {
    let mesh = Block::new([8, 8, 2], [25.0, 25.0, 2.0]).mesh(
        &["THIN", "THICK"],
        |x| usize::from(x[2] > 1.0),
        |_, _| false,
    );
    let mesh = mapped(mesh, |x| [x[0], x[1], if x[2] > 1.5 { 3.0 } else { x[2] }]);
    let yaml = format!(
        "materials: {{s: {{E: {E:?}, nu: 0.3}}}}\nbodies: {{THIN: s, THICK: s}}\ninterfaces:\n- \
         {{between: [THIN, THICK], law: contact, mu: 0.2}}\nsupports:\n- {{face: X0, fix: \
         [x]}}\n- {{face: Y0, fix: [y]}}\n- {{face: X1, fix: [y, z]}}\n- {{face: Y1, fix: [x, \
         z]}}\nloads: []\n"
    );
    resolve(&yaml, mesh).expect("a sound model")
}

#[test]
fn plates_in_contact_bend_together_without_shear_between_them() {
    let model = stack();
    let d = |t: f64| E * t.powi(3) / (12.0 * (1.0 - 0.09));
    let at = |d: f64, t: f64| 4.0 * PI * PI * d / (50.0 * 50.0 * t);
    let across = |z: f64| {
        move |x: [f64; 3]| {
            let mut s = pressed(x);
            s[2] = z;
            s
        }
    };
    for (name, z, closed, exact) in
        [("touching", -1e-4, 128, at(d(1.0) + d(2.0), 3.0)), ("apart", 0.0, 0, at(d(1.0), 1.0))]
    {
        let found = buckled(&model, &field(&model, across(z)));
        let factor = found.modes[0].factor;
        println!("{name}: {factor:.2}, closed form {exact:.2}");
        assert_eq!((found.closed_faces, found.contact_faces), (closed, 128), "{name}");
        assert!((factor / exact - 1.0).abs() < 0.02, "{name}: {factor} {exact}");
    }
}
