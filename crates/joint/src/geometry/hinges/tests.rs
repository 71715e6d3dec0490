//! Zones of the paper's joint, by hand from its dimensions, and the bolts that its loads pull.

use super::*;
use crate::assembly::Assembly;
use crate::assembly::assembly::{Action, FaceLoad, FaceRule, FaceSupport, Surface};
use crate::geometry::fixtures::paper_joint;

/// The zone of the positive right-hand bolt in row `z`, in the plate between `faces`.
fn zone_at(joint: &Assembly, z: f64, faces: [f64; 2]) -> Option<Zone> {
    let inside = |zone: &Zone| {
        [zone.min[0], zone.max[0]] == faces
            && zone.min[1] < 50.0
            && zone.max[1] > 50.0
            && zone.min[2] < z
            && zone.max[2] > z
    };
    zones(&Scene::new(joint, false)).into_iter().find(inside)
}

#[test]
fn a_zone_reaches_from_its_bolt_to_the_toes_around_it() {
    let joint = paper_joint();
    // three bolts of the quarter, each in the end plate and in the flange of the column
    assert_eq!(zones(&Scene::new(&joint, false)).len(), 6);
    // The beam's flange is 35 mm above the bolt at z = −215, and nothing stands nearer: 4/3 · 35 =
    // 46.67 mm towards y = 0, 40 mm to the edge at y = 90, 35 mm to that at z = −250.
    let plate = zone_at(&joint, -215.0, [100.0, 115.0]).expect("the bolt's zone in the plate");
    let by_hand = [[100.0, 50.0 - 140.0 / 3.0, -250.0], [115.0, 90.0, -180.0 + 7.5]];
    for (found, want) in [plate.min, plate.max].into_iter().zip(by_hand) {
        for k in 0..3 {
            assert!((found[k] - want[k]).abs() < 1e-9, "{found:?} {want:?}");
        }
    }
    assert_eq!(plate.thickness, 15.0);
    // The column's stiffener is level with the beam's flange. Two chords replace the fillet of
    // radius 18 mm between flange and web. They meet at the distance ρ from its centre, which lies
    // 18 mm above the flange and 22.5 mm from y = 0; they keep the area, ρ sin 45° = 18 π/4. At
    // 3.75 mm above the flange the lower chord stands at `toe`. The column does not end near the
    // bolt.
    let across = 18.0 * std::f64::consts::FRAC_PI_4;
    let toe = 22.5 - across * 3.75 / (18.0 - across);
    let column = zone_at(&joint, -215.0, [85.0, 100.0]).expect("the bolt's zone in the flange");
    assert!((column.min[2] + 215.0 + 140.0 / 3.0).abs() < 1e-9, "{column:?}");
    assert!((column.max[2] + 172.5).abs() < 1e-9, "{column:?}");
    assert!((column.min[1] - (toe - 7.5)).abs() < 1e-3, "{column:?}");
    assert!((column.max[1] - (50.0 + 140.0 / 3.0)).abs() < 1e-9, "{column:?}");
}

/// The paper's joint with the column held and forces at the end of the right beam.
fn cantilever(cases: &[([f64; 3], [f64; 3])]) -> Assembly {
    let mut joint = paper_joint();
    let end = Surface::Plane {
        axis: 0,
        at: 1115.0,
        min: [1115.0, -85.0, -180.0],
        max: [1115.0, 85.0, 180.0],
    };
    joint.faces.push(FaceRule {
        name: "END".into(),
        part: "BEAM_R".into(),
        surface: end,
        imprint: false,
    });
    joint.supports = vec![FaceSupport { face: "LOAD_TOP".into(), fix: [true; 3], ground: None }];
    let load = |(i, (force, moment)): (usize, &([f64; 3], [f64; 3]))| FaceLoad {
        face: "END".into(),
        case: i.to_string(),
        action: Action::Resultant { at: [100.0, 0.0, 0.0], force: *force, moment: *moment },
        dead: false,
    };
    joint.loads = cases.iter().enumerate().map(load).collect();
    joint.symmetry.clear();
    joint
}

/// Bolts that turn with the beam about the centroid of the group at z = −76.7: a positive moment
/// about y moves the top of the right beam away from the column.
#[test]
fn only_pulled_bolts_have_zones() {
    let rows = |cases: &[([f64; 3], [f64; 3])]| -> Vec<f64> {
        let joint = cantilever(cases);
        let mut shanks: Vec<f64> = joint
            .parts
            .iter()
            .filter(|p| p.role == PartRole::Bolt)
            .filter_map(|p| Shank::of(&p.solid))
            .filter(|s| s.start[1] > 0.0 && pulled::may_be(&joint, s))
            .map(|s| s.start[0].signum() * s.start[2])
            .collect();
        shanks.sort_by(f64::total_cmp);
        shanks
    };
    let up = ([0.0; 3], [0.0, 1e6, 0.0]);
    let down = ([0.0; 3], [0.0, -1e6, 0.0]);
    assert_eq!(rows(&[up]), [110.0]);
    assert_eq!(rows(&[down]), [-215.0, -125.0]);
    assert_eq!(rows(&[up, down]), [-215.0, -125.0, 110.0]);
    assert_eq!(rows(&[([1e3, 0.0, 0.0], [0.0; 3])]).len(), 3);
    // pushed through the centroid: no bolt is pulled, and none of the other beam
    let pushed = ([-1e3, 0.0, 0.0], [0.0, 1e3 * 230.0 / 3.0, 0.0]);
    assert_eq!(rows(&[pushed]), Vec::<f64>::new());
    // Moment about z: the bolts on one side of the web. A force across the end at x = 1115 has
    // the lever 1015 mm.
    assert_eq!(rows(&[([0.0; 3], [0.0, 0.0, -1e6])]).len(), 3);
    assert_eq!(rows(&[([0.0; 3], [0.0, 0.0, 1e6])]).len(), 0);
    // the joint of the paper rests on both beams: the forces of its bolts are not known
    let joint = paper_joint();
    let bolts = joint.parts.iter().filter(|p| p.role == PartRole::Bolt);
    assert!(bolts.filter_map(|p| Shank::of(&p.solid)).all(|s| pulled::may_be(&joint, &s)));
}
