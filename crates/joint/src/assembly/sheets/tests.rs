use super::*;
use crate::assembly::Joint;
use crate::assembly::tests::{PAPER, ok};
use std::collections::BTreeMap;

const STIFFENED: &str = include_str!("../../../../../examples/one_sided_stiffened/joint.yaml");
const SPLICE: &str = include_str!("../../../../../examples/splice_extended/joint.yaml");

fn list(joint: &Joint) -> Vec<Sheet> {
    sheets(&joint.content, &joint.assembly)
}

/// Thickness of the sheets of each part and kind, as many times as there are sheets.
fn thicknesses(sheets: &[Sheet]) -> BTreeMap<(&str, &str), Vec<f64>> {
    let mut out: BTreeMap<_, Vec<f64>> = BTreeMap::new();
    for s in sheets {
        let kind = match s.kind {
            SheetKind::Plate => "plate",
            SheetKind::Flange => "flange",
            SheetKind::Web => "web",
        };
        let rounded = (s.thickness() * 1e9).round() / 1e9;
        out.entry((s.part.as_str(), kind)).or_default().push(rounded);
    }
    out
}

/// HEB200 15/9, IPE360 12.7/8, end plates 15, stiffeners 12.7 and 15 on both sides of the webs.
#[test]
fn every_plate_flange_and_web_of_the_paper_joint_once() {
    let joint = ok(PAPER);
    let all = list(&joint);
    let want = [
        (("BEAM_L", "flange"), vec![12.7; 2]),
        (("BEAM_L", "plate"), vec![15.0; 2]),
        (("BEAM_L", "web"), vec![8.0]),
        (("BEAM_R", "flange"), vec![12.7; 2]),
        (("BEAM_R", "plate"), vec![15.0; 2]),
        (("BEAM_R", "web"), vec![8.0]),
        (("COLUMN", "flange"), vec![15.0; 2]),
        (("COLUMN", "plate"), vec![12.7; 4]),
        (("COLUMN", "web"), vec![9.0]),
        (("PLATE_L", "plate"), vec![15.0]),
        (("PLATE_R", "plate"), vec![15.0]),
    ];
    assert_eq!(thicknesses(&all), BTreeMap::from(want));
}

/// HEB200 and IPE300 with stiffeners of 10.7; IPE400 13.5/8.6 with plates of 20.
#[test]
fn plates_of_other_examples() {
    let stiffened = ok(STIFFENED);
    let want = [
        (("BEAM_R", "flange"), vec![10.7; 2]),
        (("BEAM_R", "web"), vec![7.1]),
        (("COLUMN", "flange"), vec![15.0; 2]),
        (("COLUMN", "plate"), vec![10.7; 4]),
        (("COLUMN", "web"), vec![9.0]),
        (("PLATE_R", "plate"), vec![15.0]),
    ];
    assert_eq!(thicknesses(&list(&stiffened)), BTreeMap::from(want));
    let splice = ok(SPLICE);
    let want = [
        (("BEAM_L", "flange"), vec![13.5; 2]),
        (("BEAM_L", "web"), vec![8.6]),
        (("BEAM_R", "flange"), vec![13.5; 2]),
        (("BEAM_R", "web"), vec![8.6]),
        (("PLATE_L", "plate"), vec![20.0]),
        (("PLATE_R", "plate"), vec![20.0]),
    ];
    assert_eq!(thicknesses(&list(&splice)), BTreeMap::from(want));
}

fn sheet<'a>(all: &'a [Sheet], part: &str, kind: SheetKind) -> &'a Sheet {
    all.iter().find(|s| s.part == part && s.kind == kind).expect("a sheet")
}

/// Heads of M20, 30 mm across flats, lie on the end plate, the nuts inside on the right flange of
/// the column, none on the left one.
#[test]
fn bearings_of_heads_and_nuts() {
    let all = list(&ok(STIFFENED));
    let plate = sheet(&all, "PLATE_R", SheetKind::Plate);
    let places: Vec<[f64; 3]> = plate.bearings.iter().map(|b| b.centre).collect();
    assert_eq!(places.len(), 6);
    assert!(plate.bearings.iter().all(|b| b.radius == 15.0 && b.centre[0] == 115.0));
    assert!(places.contains(&[115.0, -50.0, 190.0]), "{places:?}");
    let flanges: Vec<&Sheet> =
        all.iter().filter(|s| s.part == "COLUMN" && s.kind == SheetKind::Flange).collect();
    let count = |right: bool| {
        let of = flanges.iter().filter(|f| (f.extent[0][0] > 0.0) == right);
        of.map(|f| f.bearings.len()).sum::<usize>()
    };
    assert_eq!((count(true), count(false)), (6, 0));
    assert!(sheet(&all, "BEAM_R", SheetKind::Web).bearings.is_empty());
}

fn rectangles(plate: &Plate) -> Vec<([f64; 2], [f64; 2])> {
    let of = |z: &Zone| match z {
        Zone::Rectangle { min, max } => Some((*min, *max)),
        Zone::Disc { .. } => None,
    };
    plate.excluded.iter().filter_map(of).collect()
}

fn mesh() -> TetMesh {
    let bodies = ["BOLT", "COLUMN", "PLATE_R", "BEAM_R"].map(str::to_owned).to_vec();
    TetMesh { bodies, ..TetMesh::default() }
}

/// The end plate, 15 thick and 160 × 395, carries the toes of the beam: along the web ±3.55, along
/// the flanges ±75. It has none from the column, which it only touches.
#[test]
fn zones_of_the_end_plate_follow_the_beam() {
    let all = list(&ok(STIFFENED));
    let plate = sheet(&all, "PLATE_R", SheetKind::Plate).plate(&mesh(), &[]).expect("meshed");
    assert_eq!((plate.body, plate.extent[2], plate.mirrored), (2, [100.0, 115.0], [false; 3]));
    let found = rectangles(&plate);
    let near = |(min, max): ([f64; 2], [f64; 2])| {
        let close = |a: [f64; 2], b: [f64; 2]| (0..2).all(|i| (a[i] - b[i]).abs() < 1e-9);
        assert!(found.iter().any(|z| close(z.0, min) && close(z.1, max)), "{min:?} {max:?}");
    };
    let t = 7.5;
    for side in [-3.55, 3.55] {
        near(([side - t, -139.3 - t], [side + t, 139.3 + t]));
    }
    for level in [-150.0, -139.3, 139.3, 150.0] {
        near(([-75.0 - t, level - t], [75.0 + t, level + t]));
    }
    for side in [-75.0, 75.0] {
        near(([side - t, 139.3 - t], [side + t, 150.0 + t]));
    }
    // web: two toes, its ends meet the flanges of the same height; flanges: four edges each
    assert_eq!(found.len(), 2 + 2 + 2 * 4, "{found:?}");
}

/// The web of the column, cut by the plane of symmetry y = 0, is half as deep in the mesh. Its
/// zones lie along both flanges and around the stiffeners.
#[test]
fn half_of_a_web_behind_a_plane_of_symmetry() {
    let all = list(&ok(STIFFENED));
    let web = sheet(&all, "COLUMN", SheetKind::Web);
    let half = web.plate(&mesh(), &[SymmetryPlane { axis: 1 }]).expect("meshed");
    assert_eq!((half.mirrored, half.thickness()), ([false, false, true], 9.0));
    assert_eq!(half.extent[2], [0.0, 4.5]);
    let found = rectangles(&half);
    let z = &web.extent[2];
    // along the flanges, over the whole length of the column
    let along = |x: f64| {
        found.iter().any(|(min, max)| {
            (min[0] - (x - 4.5)).abs() < 1e-9
                && (max[0] - (x + 4.5)).abs() < 1e-9
                && max[1] - min[1] > z[1] - z[0]
        })
    };
    assert!(along(-85.0) && along(85.0), "{found:?}");
    let across = |level: f64| found.iter().any(|(min, _)| (min[1] - (level - 4.5)).abs() < 1e-9);
    assert!(across(139.3) && across(150.0) && across(-139.3) && across(-150.0), "{found:?}");
    // a stiffener on the far side is not meshed, one of the other side is whole
    let plates = all.iter().filter(|s| s.part == "COLUMN" && s.kind == SheetKind::Plate);
    let kept = plates.filter(|s| s.plate(&mesh(), &[SymmetryPlane { axis: 1 }]).is_some());
    assert_eq!(kept.count(), 2);
    assert_eq!(web.plate(&TetMesh::default(), &[]), None);
}

/// A haunched rafter at 6°: the slab of its flange, of its web and of the haunch flange hold the
/// middles of what is drawn of them, at mid-thickness; the plate and the flange of the haunch leave
/// their toes on the rafter.
#[test]
fn sloping_sheets_have_axes_of_their_own() {
    let spec = include_str!("../../../../../examples/haunched_eaves/joint.yaml");
    let joint = ok(spec);
    let all = list(&joint);
    let rafter = |kind: SheetKind| {
        let of = move |s: &&Sheet| s.part == "RAFTER" && s.kind == kind;
        all.iter().filter(of).collect::<Vec<_>>()
    };
    assert_eq!(
        [SheetKind::Flange, SheetKind::Web, SheetKind::Plate].map(|k| rafter(k).len()),
        [2, 1, 2]
    );
    let (sin, cos) = 6f64.to_radians().sin_cos();
    let near = |a: V3, b: V3| (0..3).all(|k| (a[k] - b[k]).abs() < 1e-12);
    for s in rafter(SheetKind::Flange).into_iter().chain(rafter(SheetKind::Web)) {
        let [u, v, n] = s.axes();
        let along = [cos, 0.0, sin];
        assert!(near(u, along), "{s:?}");
        let across = [0.0, 1.0, 0.0];
        let up = [-sin, 0.0, cos];
        let flat = s.kind == SheetKind::Flange;
        assert!(near(v, if flat { across } else { up }) && near(n, if flat { up } else { across }));
        // what is drawn of it is between its faces
        let length: Vec<_> = joint.content.members.iter().filter(|m| m.part == s.part).collect();
        let blocks = length[0].solids();
        let inside = |b: &&Block| {
            let c = b.corners();
            let middle: V3 =
                std::array::from_fn(|k| c.iter().map(|p| p[k]).sum::<f64>() / c.len() as f64);
            let own = [u, v, n].map(|a| dot(middle, a));
            let mesh = meshed(&joint);
            let plate = s.plate(&mesh, &[]).expect("a plate");
            (0..2).all(|i| plate.extent[i][0] < own[i] && own[i] < plate.extent[i][1])
                && (own[2] - 0.5 * (plate.extent[2][0] + plate.extent[2][1])).abs() < 1e-6
        };
        assert_eq!(blocks.iter().filter(inside).count(), 1, "{s:?}");
        assert!(!s.edges.is_empty(), "{s:?}");
    }
}

/// A mesh that knows the names of the bodies alone.
fn meshed(joint: &Joint) -> TetMesh {
    let bodies = joint.assembly.parts.iter().map(|p| p.name.clone()).collect();
    TetMesh { bodies, ..TetMesh::default() }
}
