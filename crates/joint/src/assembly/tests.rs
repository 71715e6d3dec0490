//! Tests of the paper's joint built from its spec, and of the symmetry of its variants.

use super::assembly::{Action, FaceLoad, OutlineEdge, Part, PartRole, Solid, Surface};
use super::{CodeValues, Joint, build};
use crate::catalog::Catalog;
use crate::spec::ConnectionSpec;
use crate::spec::code::{ConcreteFactors, Edition, PartialFactors};
use crate::strength::{Nominal, NominalStrength};
use bracket_base::diag::Diagnostics;
use bracket_base::yaml;
use bracket_engine::model::FrictionLaw;
use std::path::Path;

pub(super) const PAPER: &str = include_str!("../../../../examples/paper_joint/joint.yaml");

pub(super) fn joint(text: &str) -> Result<Joint, Diagnostics> {
    let spec = yaml::parse::<ConnectionSpec>(text, Path::new("joint.yaml"))?;
    let catalog = Catalog::builtin().expect("the shipped catalogue is sound");
    build(&spec, Path::new("."), &catalog, code())
}

/// A code whose factors are 1. Every beam is an IPE300 of S235: 235 MPa, in shear 135.7 MPa.
pub(super) fn code() -> CodeValues {
    CodeValues {
        edition: Edition::Ec2005,
        factors: PartialFactors {
            gamma_m0: 1.0,
            gamma_m1: 1.0,
            gamma_m2: 1.0,
            gamma_m3: 1.0,
            gamma_m3_ser: 1.0,
            gamma_m7: 1.0,
            concrete: ConcreteFactors::RECOMMENDED,
        },
        annex: None,
        resolved: Vec::new(),
        notes: Vec::new(),
        members: [("beam".into(), [[1264e3, 461.6e3, 268.4e3], [2.55e6, 147.7e6, 29.4e6]])].into(),
        faults: Vec::new(),
    }
}

pub(crate) fn ok(text: &str) -> Joint {
    joint(text).unwrap_or_else(|faults| panic!("{faults:#?}"))
}

/// The paper's spec with one piece of text replaced; the text must occur exactly once.
pub(super) fn with(old: &str, new: &str) -> String {
    assert_eq!(PAPER.matches(old).count(), 1, "`{old}`");
    PAPER.replace(old, new)
}

fn axes(text: &str) -> Vec<usize> {
    ok(text).assembly.symmetry.iter().map(|s| s.axis).collect()
}

fn part<'a>(j: &'a Joint, name: &str) -> &'a Part {
    j.assembly.parts.iter().find(|p| p.name == name).unwrap_or_else(|| panic!("no part {name}"))
}

/// Lowest and highest corner of a solid's vertices. Arcs need no extra treatment: in every solid of
/// the paper's joint they bulge inwards.
fn extent(s: &Solid) -> ([f64; 3], [f64; 3]) {
    let mut points = Vec::new();
    match s {
        Solid::Box { min, max } => points.extend([*min, *max]),
        Solid::Prism { origin, u, v, start, edges, length } => {
            let n = bracket_base::math::vec3::cross(*u, *v);
            let ends = edges.iter().map(|e| match e {
                OutlineEdge::Line { to } | OutlineEdge::Arc { to, .. } => *to,
            });
            for q in ends.chain([*start]) {
                for h in [0.0, *length] {
                    points
                        .push([0, 1, 2].map(|k| origin[k] + q[0] * u[k] + q[1] * v[k] + h * n[k]));
                }
            }
        }
        Solid::Cylinder { base, axis, length, .. } => {
            points.extend([*base, [0, 1, 2].map(|k| base[k] + length * axis[k])]);
        }
        Solid::Union(list) => {
            points.extend(list.iter().flat_map(|s| <[[f64; 3]; 2]>::from(extent(s))))
        }
        Solid::Difference(list) => return extent(&list[0]),
    }
    let fold = |f: fn(f64, f64) -> f64| {
        points.iter().skip(1).fold(points[0], |a, b| [0, 1, 2].map(|k| f(a[k], b[k])))
    };
    (fold(f64::min), fold(f64::max))
}

fn close(got: ([f64; 3], [f64; 3]), want: ([f64; 3], [f64; 3])) {
    for k in 0..3 {
        assert!(
            (got.0[k] - want.0[k]).abs() < 1e-4 && (got.1[k] - want.1[k]).abs() < 1e-4,
            "{got:?} is not {want:?}"
        );
    }
}

/// The expected extents were measured on `paper_quarter_9k.msh` (the quarter x, y > 0) and
/// completed by symmetry.
#[test]
fn paper_joint_has_the_extents_of_the_reference_mesh() {
    let j = ok(PAPER);
    close(extent(&part(&j, "COLUMN").solid), ([-100.0, -100.0, -350.0], [100.0, 100.0, 350.0]));
    close(extent(&part(&j, "PLATE_R").solid), ([100.0, -90.0, -250.0], [115.0, 90.0, 200.0]));
    close(extent(&part(&j, "PLATE_L").solid), ([-115.0, -90.0, -250.0], [-100.0, 90.0, 200.0]));
    close(extent(&part(&j, "BEAM_R").solid), ([115.0, -85.0, -180.0], [1115.0, 85.0, 180.0]));
    close(
        extent(&part(&j, "BOLT_R1P").solid),
        ([69.2, 34.41154273, -228.5], [126.5, 65.58845727, -201.5]),
    );
    close(
        extent(&part(&j, "BOLT_R2P").solid),
        ([69.2, 34.41154273, -138.5], [126.5, 65.58845727, -111.5]),
    );
    close(
        extent(&part(&j, "BOLT_R3P").solid),
        ([69.2, 34.41154273, 96.5], [126.5, 65.58845727, 123.5]),
    );
    close(
        extent(&part(&j, "BOLT_L3M").solid),
        ([-126.5, -65.58845727, 96.5], [-69.2, -34.41154273, 123.5]),
    );
    // column stiffener level with the beam's upper flange, and support stiffener of the beam: both
    // lie between the flanges, flush with their edges
    let Solid::Difference(list) = &part(&j, "COLUMN").solid else { panic!("the column has holes") };
    assert_eq!(list.len(), 1 + 12);
    let Solid::Union(pieces) = &list[0] else { panic!("the column has stiffeners") };
    close(extent(&pieces[1]), ([-85.0, -100.0, 167.3], [85.0, 100.0, 180.0]));
    close(extent(&pieces[2]), ([-85.0, -100.0, -180.0], [85.0, 100.0, -167.3]));
    let Solid::Union(pieces) = &part(&j, "BEAM_R").solid else { panic!("the beam has stiffeners") };
    close(extent(&pieces[1]), ([1007.5, -85.0, -167.3], [1022.5, 85.0, 167.3]));
}

#[test]
fn paper_joint_is_complete() {
    let a = ok(PAPER).assembly;
    let names: Vec<&str> = a.parts.iter().map(|p| p.name.as_str()).collect();
    assert_eq!(
        names[..7],
        ["COLUMN", "PLATE_R", "PLATE_L", "BEAM_R", "BEAM_L", "BOLT_R1P", "BOLT_R1M"]
    );
    assert_eq!(a.parts.iter().filter(|p| p.role == PartRole::Bolt).count(), 12);
    assert_eq!(a.parts.len(), 17);
    // two plates, and per bolt: nut, shank in plate, shank in column; the tied head is no interface
    assert_eq!(a.interfaces.len(), 2 + 12 * 3);
    assert!(
        a.interfaces
            .iter()
            .all(|i| i.mu == 0.3 && i.friction == FrictionLaw::Associated && i.gap == 0.0)
    );
    let support = a.faces.iter().find(|f| f.name == "SUPPORT_R").expect("the right support");
    let Surface::Plane { axis, at, min, max } = support.surface else {
        panic!("a support is a plane")
    };
    assert_eq!((axis, at, support.imprint), (2, -180.0, true));
    assert_eq!((min, max), ([1007.5, -85.0, -180.0], [1022.5, 85.0, -180.0]));
    assert!(a.supports.iter().all(|s| s.fix == [true; 3]) && a.supports.len() == 2);
    assert_eq!(a.loads.len(), 1);
    assert_eq!(
        (a.loads[0].face.as_str(), a.loads[0].action),
        ("COLUMN_TOP", Action::Traction([0.0, 0.0, -45.0]))
    );
    assert_eq!(
        a.materials["S235"],
        super::assembly::PartMaterial {
            e: 210_000.0,
            nu: 0.3,
            strength: NominalStrength::Steel(Nominal::new(235.0)),
            fu: Some(Nominal::new(360.0)),
        }
    );
}

#[test]
fn bolt_material_is_nominal() {
    let a = ok(PAPER).assembly;
    let NominalStrength::Bolt(bolt) = a.materials["bolt_M18_8_8"].strength else {
        panic!("a bolt")
    };
    assert_eq!((bolt.fub, bolt.stress_area), (Nominal::new(800.0), 192.0));
    assert!((bolt.shank_area - std::f64::consts::PI * 81.0).abs() < 1e-9, "{bolt:?}");
}

#[test]
fn every_thin_piece_has_its_middle_plane_unless_switched_off() {
    let j = ok(PAPER);
    let column: Vec<(usize, f64)> =
        part(&j, "COLUMN").mid_planes.iter().map(|m| (m.axis, m.at)).collect();
    let near = |got: &[(usize, f64)], want: &[(usize, f64)]| {
        assert_eq!(got.len(), want.len(), "{got:?}");
        assert!(
            got.iter().zip(want).all(|(g, w)| g.0 == w.0 && (g.1 - w.1).abs() < 1e-9),
            "{got:?} {want:?}"
        );
    };
    near(&column, &[(0, 92.5), (0, -92.5), (1, 0.0), (2, 173.65), (2, -173.65)]);
    let beam: Vec<(usize, f64)> =
        part(&j, "BEAM_R").mid_planes.iter().map(|m| (m.axis, m.at)).collect();
    near(&beam, &[(2, 173.65), (2, -173.65), (1, 0.0), (0, 1015.0)]);
    let plate = &part(&j, "PLATE_R").mid_planes;
    near(&[(plate[0].axis, plate[0].at)], &[(0, 107.5)]);
    let off = ok(&with("target_gap: 0.05}", "mesh: {layers: false}}"));
    assert!(off.assembly.parts.iter().all(|p| p.mid_planes.is_empty()));
}

#[test]
fn loads_decide_which_planes_of_symmetry_are_left() {
    let top = "{name: TOP, section: column_top, pressure: 45 MPa}";
    let both = |extra: &str| with(top, &format!("{top}, {extra}"));
    assert_eq!(axes(PAPER), [0, 1]);
    assert_eq!(axes(&with("pressure: 45 MPa", "traction: [1 MPa, 0 MPa, 0 MPa]")), [1]);
    assert_eq!(axes(&with("pressure: 45 MPa", "traction: [0 MPa, 1 MPa, 0 MPa]")), [0]);
    assert_eq!(
        axes(&with("pressure: 45 MPa", "traction: [1 MPa, 1 MPa, 0 MPa]")),
        [] as [usize; 0]
    );
    assert_eq!(axes(&both("{name: SIDE, section: beam_right_end, pressure: 1 MPa}")), [1]);
    let pair = "{name: S, section: beam_right_end, pressure: 1 MPa}, {name: S, section: \
                beam_left_end, pressure: 1 MPa}";
    assert_eq!(axes(&both(pair)), [0, 1]);
    // the same two pressures in two load cases: neither case is symmetric
    let cases = "{name: A, section: beam_right_end, pressure: 1 MPa}, {name: B, section: \
                 beam_left_end, pressure: 1 MPa}";
    assert_eq!(axes(&both(cases)), [1]);
}

#[test]
fn geometry_decides_too() {
    // rows, plate and supports are symmetric about the beam axis: only the load and the supports
    // prevent symmetry about z = 0
    let j = ok(&with("rows: [-215, -125, 110]}", "rows: [-110, 110]}")
        .replace("z: [-250, 200]", "z: [-220, 220]"));
    assert_eq!(j.assembly.symmetry.len(), 2);
    let mut a = j.assembly;
    a.supports.clear();
    a.loads.clear();
    assert_eq!(super::symmetry::planes(&a).len(), 3);
    if let Solid::Difference(list) = &mut a.parts[1].solid {
        list.pop();
    }
    // one hole less in one plate: no symmetry plane remains, because the planes that map the plate
    // onto itself map the missing hole onto an existing one
    assert!(super::symmetry::planes(&a).is_empty());
}

#[test]
fn hole_clearance_is_an_initial_gap_and_keeps_the_geometry() {
    let j = ok(&with("hole_clearance: 0}", "hole_clearance: 2 mm, head_contact: true}"));
    let gaps = |word: &str| -> Vec<f64> {
        let named = |i: &&super::assembly::InterfaceRule| {
            i.surface.as_ref().is_some_and(|(n, _)| n.starts_with(word))
        };
        j.assembly.interfaces.iter().filter(named).map(|i| i.gap).collect()
    };
    assert_eq!(gaps("SHANK_"), [1.0; 24]);
    assert_eq!(gaps("NUT_"), [0.0; 12]);
    assert_eq!(gaps("HEAD_"), [0.0; 12]);
    assert_eq!(part(&j, "PLATE_R").solid, part(&ok(PAPER), "PLATE_R").solid);
}

#[test]
fn defaults_and_stiffeners_make_the_paper_joint() {
    let short = "
template: double_sided_end_plate
members: {column: {profile: HE 200 B, steel: S235}, beam: {profile: IPE 360, steel: S235}}
plate: {thickness: 1.5 cm}
bolts: {size: M18, grade: 8.8, rows: [-215, -125, 110]}
parameters: {column_stiffeners: true, column_stiffener_thickness: 12.7}
friction: {class: C, law: associated}
loads: [{name: TOP, section: column_top, pressure: 45 N/mm2}]
";
    let (mut a, b) = (ok(short).assembly, ok(PAPER).assembly);
    a.name = b.name.clone();
    let gauge = |text: &str| {
        ok(text).resolved.into_iter().find(|r| r.name == "bolts.gauge").map(|r| r.value.to_string())
    };
    assert_eq!(gauge(short).as_deref(), Some("100 mm"));
    assert_eq!(a, b);
}

/// Volume of a convex piece, for comparison with the section's area; only for prisms and boxes.
fn volume(s: &Solid) -> f64 {
    match s {
        Solid::Box { min, max } => (0..3).map(|k| max[k] - min[k]).product(),
        Solid::Prism { start, edges, length, .. } => {
            let mut last = *start;
            let mut twice = 0.0;
            for e in edges {
                let OutlineEdge::Line { to } = e else {
                    panic!("convex pieces have straight edges")
                };
                twice += last[0] * to[1] - last[1] * to[0];
                last = *to;
            }
            twice / 2.0 * length
        }
        _ => panic!("no such piece"),
    }
}

#[test]
fn convex_pieces_cover_the_part_and_spare_the_holes() {
    let j = ok(PAPER);
    let plate = part(&j, "PLATE_R");
    assert!(plate.convex.iter().all(|s| volume(s) > 0.0), "a piece is inside out");
    let sum: f64 = plate.convex.iter().map(volume).sum();
    let exact = (180.0 * 450.0 - 6.0 * std::f64::consts::PI * 81.0) * 15.0;
    // the polygons left free enclose the meshed circles: the sum is slightly below the plate, never
    // above
    assert!(sum < exact && sum > exact * 0.995, "{sum} {exact}");
    let column = part(&j, "COLUMN");
    assert!(column.convex.iter().all(|s| volume(s) > 0.0), "a piece is inside out");
    let sum: f64 = column.convex.iter().map(volume).sum();
    let section =
        7808.0 * 700.0 + 2.0 * 170.0 * 191.0 * 12.7 - 12.0 * std::f64::consts::PI * 81.0 * 15.0;
    // stiffener boxes pass through web and fillets, where volume is counted twice
    let twice = 2.0 * 12.7 * 170.0 * 9.0;
    assert!((sum - section - twice).abs() < 0.01 * section, "{sum} {section}");
}

/// A small part of a load breaks symmetry like a large one, in any unit; rounding does not.
#[test]
fn a_load_is_symmetric_up_to_rounding_relative_to_its_size() {
    let planes = |action: Action| -> Vec<usize> {
        let mut a = ok(PAPER).assembly;
        a.loads[0].action = action;
        super::symmetry::planes(&a).iter().map(|s| s.axis).collect()
    };
    let z = 350.0;
    let resultant =
        |force: [f64; 3], moment: [f64; 3]| Action::Resultant { at: [0.0, 0.0, z], force, moment };
    assert_eq!(planes(Action::Traction([0.0, 0.0, -45.0])), [0, 1]);
    assert_eq!(planes(Action::Traction([1e-7, 0.0, -45.0])), [1]);
    assert_eq!(planes(Action::Traction([0.0, 1e-15, -45.0])), [0, 1]);
    assert_eq!(planes(resultant([0.0, 0.0, -1e5], [0.0; 3])), [0, 1]);
    assert_eq!(planes(resultant([1.0, 0.0, -1e5], [0.0; 3])), [1]);
    assert_eq!(planes(resultant([0.0, 1e-3, -1e5], [0.0; 3])), [0]);
    assert_eq!(planes(resultant([1e-8, -1e-8, -1e5], [0.0; 3])), [0, 1]);
    // a load below the grid of 1e-6 still counts
    assert_eq!(planes(resultant([1e-7, 0.0, 0.0], [0.0; 3])), [1]);
    assert_eq!(planes(resultant([0.0, 0.0, -1e5], [0.0, 1e-7, 0.0])), [1]);
    // two loads that are mirror images up to rounding, then up to one newton
    let pair = |right: f64| {
        let mut a = ok(PAPER).assembly;
        // on the top of the column, which both planes halve
        let top = a.loads[0].clone();
        for (x, force) in [(-50.0, 1e5), (50.0, right)] {
            let (at, force) = ([x, 0.0, z], [0.0, 0.0, -force]);
            let action = Action::Resultant { at, force, moment: [0.0; 3] };
            a.loads.push(FaceLoad { action, ..top.clone() });
        }
        super::symmetry::planes(&a).iter().map(|s| s.axis).collect::<Vec<_>>()
    };
    assert_eq!(pair(1e5), [0, 1]);
    assert_eq!(pair(1e5 * (1.0 + 4.0 * f64::EPSILON)), [0, 1]);
    assert_eq!(pair(1e5 + 1.0), [1]);
}

/// A connection type unknown to the program, in a user's file: two lapped plates and a bolt.
#[test]
fn a_new_connection_type_needs_no_rust() {
    let template = "
name: lap
title: Two lapped plates
members: []
parameters:
  - {name: thickness, kind: length, min: 1 mm, about: thickness of both plates, default: 10 mm}
  - {name: overlap, kind: length, about: length of the lap, default: 4 * bolt.d}
  - {name: steel_part, kind: flag, about: unused, default: thickness > 5 mm}
parts:
  - name: LOWER
    label: lower plate
    role: plate
    steel: [plate]
    thickness: thickness
    size: thickness
    solids: [{box: {x: [-200 mm, overlap / 2], y: [-40 mm, 40 mm], z: [-thickness, 0]}}]
  - name: UPPER
    label: upper plate
    role: plate
    steel: [plate]
    thickness: thickness
    size: thickness
    solids: [{box: {x: [-overlap / 2, 200 mm], y: [-40 mm, 40 mm], z: [0, thickness]}}]
bolts:
  - name: BOLT
    label: the bolt
    axis: z
    toward: -1
    head: [0, 0, thickness]
    corner: x
    through: [{part: UPPER, thickness: thickness}, {part: LOWER, thickness: thickness}]
    head_contact: true
    nut_contact: true
    shank_gap: 0.5 mm
    size: bolt.d / 2
contacts:
  - {name: LAP, between: [LOWER, UPPER], face: {axis: z, at: 0, x: [-overlap / 2, overlap / 2], y: \
                    [-40 mm, 40 mm]}}
sections:
  - {name: end, about: end of the upper plate, part: UPPER, outward: 1, face: {axis: x, at: 200 \
                    mm, y: [-40 mm, 40 mm], z: [0, thickness]}}
supports:
  - {name: FIXED, part: LOWER, fix: [x, y, z], face: {axis: x, at: -200 mm, y: [-40 mm, 40 mm], z: \
                    [-thickness, 0]}}
";
    let folder = tempfile::tempdir().expect("a folder");
    std::fs::write(folder.path().join("lap.yaml"), template).expect("writable");
    let spec = "
template: lap.yaml
plate: {steel: S355}
bolts: {size: M20, grade: '10.9'}
parameters: {thickness: 1.2 cm}
loads: [{name: PULL, section: end, traction: [100 MPa, 0 MPa, 0 MPa]}]
";
    let spec = yaml::parse::<ConnectionSpec>(spec, Path::new("s.yaml")).expect("sound");
    let catalog = Catalog::builtin().expect("sound");
    let j = build(&spec, folder.path(), &catalog, code()).unwrap_or_else(|e| panic!("{e:#?}"));
    assert_eq!(j.assembly.symmetry.iter().map(|s| s.axis).collect::<Vec<_>>(), [1]);
    assert_eq!(j.assembly.interfaces.len(), 1 + 2 + 2);
    close(extent(&part(&j, "UPPER").solid), ([-40.0, -40.0, 0.0], [200.0, 40.0, 12.0]));
    let (min, max) = extent(&part(&j, "BOLT").solid);
    assert!(
        (min[2] - (-12.0 - 18.0)).abs() < 1e-9 && (max[2] - (12.0 + 12.5)).abs() < 1e-9,
        "{min:?} {max:?}"
    );
    for (right, wrong, told) in [
        ("outward: 1", "outward: 2", "`outward` is 2, not 1 or -1"),
        ("outward: 1", "outward: 0", "`outward` is 0, not 1 or -1"),
        ("{name: thickness,", "{name: plate.length,", "a spec has no `plate.length`"),
    ] {
        assert!(template.contains(right), "{right}");
        std::fs::write(folder.path().join("lap.yaml"), template.replace(right, wrong))
            .expect("writable");
        let e = build(&spec, folder.path(), &catalog, code()).expect_err(wrong);
        assert!(format!("{e:?}").contains(told), "{e:?}");
    }
}
