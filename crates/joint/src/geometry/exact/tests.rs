use super::*;
use crate::assembly::assembly::{Part, PartRole, Solid};

fn part(solid: Solid) -> Part {
    Part {
        name: "P".into(),
        label: "part".into(),
        role: PartRole::Plate,
        material: "s".into(),
        solid,
        convex: vec![],
        mid_planes: vec![],
        oblique_planes: vec![],
        size: 10.0,
    }
}

fn body(part: &Part, planes: Vec<usize>) -> Body<'_> {
    let solid = FlatSolid::from_solid(&part.solid);
    let whole = solid.bounds();
    Body { part, solid, whole, bounds: whole, planes }
}

fn drilled(lo: f64, hi: f64) -> Solid {
    Solid::Difference(vec![
        Solid::Box { min: [lo, -30.0, -40.0], max: [hi, 30.0, 40.0] },
        Solid::Cylinder {
            base: [lo, 0.0, 5.0],
            axis: [1.0, 0.0, 0.0],
            radius: 9.0,
            length: hi - lo,
            segments: 12,
        },
    ])
}

#[test]
fn volume_of_a_drilled_plate_is_exact() {
    let p = part(drilled(0.0, 15.0));
    let hole = std::f64::consts::PI * 81.0;
    let whole = volume(&body(&p, vec![]));
    assert!((whole / (15.0 * (4800.0 - hole)) - 1.0).abs() < 1e-9, "{whole}");
    let half = volume(&body(&p, vec![1]));
    assert!((half / whole - 0.5).abs() < 1e-9, "{half}");
}

/// A bar of 20 x 10 mm that slopes by 20° between two upright cuts 100 mm apart, with a wedge
/// on it: area times length along the slope, and what of the wedge is not in the bar.
#[test]
fn volume_of_a_sloping_bar_between_upright_cuts_is_exact() {
    let turn = crate::assembly::turn::Turn { axis: 1, angle: -20f64.to_radians(), at: [0.0; 3] };
    let block = |x: [f64; 2]| Solid::Box { min: [x[0], -50.0, -300.0], max: [x[1], 50.0, 300.0] };
    let bar = turn.solid(&Solid::Box { min: [-50.0, 0.0, -10.0], max: [300.0, 20.0, 0.0] });
    let cut = |solid| Solid::Difference(vec![solid, block([-200.0, 0.0]), block([100.0, 400.0])]);
    let (sin, cos) = 20f64.to_radians().sin_cos();
    let p = part(cut(bar.clone()));
    let exact = 20.0 * 10.0 * 100.0 / cos;
    let found = volume(&body(&p, vec![]));
    assert!((found / exact - 1.0).abs() < 1e-9, "{found} {exact}");
    // a triangle upright on the x axis, of which the bar's upper side cuts off a smaller one
    let wedge =
        crate::assembly::block::prism(1, [0.0, 20.0], &[[0.0, 0.0], [40.0, 0.0], [0.0, 100.0]]);
    let p = part(Solid::Union(vec![cut(bar), wedge]));
    let found = volume(&body(&p, vec![]));
    // above the line z = x tan 20° below the hypotenuse z = 40 − 0.4 x
    let above = 0.5 * 40.0 * 40.0 / (0.4 + sin / cos);
    // between the two sides of the bar the wedge adds nothing, below the lower side it does
    let lower = 10.0 / cos;
    let corner = lower / (sin / cos);
    let below = if corner < 100.0 {
        // the region z ≥ 0 below z = x tan 20° − 10/cos 20° and below the hypotenuse
        let meet = (40.0 + lower) / (sin / cos + 0.4);
        0.5 * (100.0 - corner) * (40.0 - 0.4 * meet)
    } else {
        0.0
    };
    let exact = exact + 20.0 * (above + below);
    assert!((found / exact - 1.0).abs() < 1e-9, "{found} {exact}");
}

#[test]
fn contact_of_two_drilled_plates_and_of_shank_and_hole_is_exact() {
    let (a, b) = (part(drilled(0.0, 15.0)), part(drilled(15.0, 25.0)));
    let area = contact_area(&body(&a, vec![]), &body(&b, vec![]), None);
    assert!((area / (4800.0 - std::f64::consts::PI * 81.0) - 1.0).abs() < 1e-5, "{area}");
    let shank = part(Solid::Cylinder {
        base: [25.0, 0.0, 5.0],
        axis: [-1.0, 0.0, 0.0],
        radius: 9.0,
        length: 25.0,
        segments: 12,
    });
    let r = crate::assembly::facets::polygon_radius(9.0, 12);
    let mantle = 24.0 * r * (std::f64::consts::PI / 12.0).sin() * 15.0;
    let area = contact_area(&body(&shank, vec![]), &body(&a, vec![]), None);
    assert!((area / mantle - 1.0).abs() < 1e-5, "{area} {mantle}");
}

#[test]
fn contact_is_restricted_to_its_surface() {
    let (a, b) = (part(drilled(0.0, 15.0)), part(drilled(15.0, 25.0)));
    let plane =
        |axis, at| Surface::Plane { axis, at, min: [0.0, -30.0, 20.0], max: [0.0, 10.0, 35.0] };
    let area = |s: &Surface| contact_area(&body(&a, vec![]), &body(&b, vec![]), Some(s));
    assert!((area(&plane(0, 15.0)) / 600.0 - 1.0).abs() < 1e-9);
    assert_eq!(area(&plane(0, 14.0)), 0.0);
    let shank = Solid::Cylinder {
        base: [25.0, 0.0, 5.0],
        axis: [-1.0, 0.0, 0.0],
        radius: 9.0,
        length: 25.0,
        segments: 12,
    };
    let shank = part(shank);
    let on =
        Surface::Mantle { base: [4.0, 0.0, 5.0], axis: [1.0, 0.0, 0.0], radius: 9.0, length: 5.0 };
    let r = crate::assembly::facets::polygon_radius(9.0, 12);
    let exact = 24.0 * r * (std::f64::consts::PI / 12.0).sin() * 5.0;
    let found = contact_area(&body(&shank, vec![]), &body(&a, vec![]), Some(&on));
    assert!((found / exact - 1.0).abs() < 1e-5, "{found} {exact}");
}

#[test]
fn outer_face_leaves_out_what_another_part_covers() {
    let (a, b) = (
        part(drilled(0.0, 15.0)),
        part(Solid::Box { min: [15.0, 10.0, -40.0], max: [20.0, 30.0, 40.0] }),
    );
    let bodies = [body(&a, vec![]), body(&b, vec![])];
    let area = outer_area(&bodies, 0, 0, 15.0, [0.0, -30.0, -40.0], [0.0, 30.0, 40.0]);
    let exact = 4800.0 - std::f64::consts::PI * 81.0 - 1600.0;
    assert!((area / exact - 1.0).abs() < 1e-5, "{area} {exact}");
}
