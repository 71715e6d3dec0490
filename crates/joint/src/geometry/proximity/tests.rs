use super::*;
use crate::geometry::fixtures::{lap_joint, paper_joint};

fn messages(assembly: &Assembly) -> Vec<(String, String)> {
    match check(assembly, &|| false).expect("not stopped") {
        Ok(()) => vec![],
        Err(d) => d.into_iter().map(|d| (d.code.to_string(), d.message)).collect(),
    }
}

#[test]
fn a_stopped_check_gives_no_answer() {
    assert!(check(&paper_joint(), &|| true).is_none());
}

/// The search looks for a stop between all its expensive steps, wherever it is.
#[test]
fn the_check_stops_at_every_step() {
    let joint = paper_joint();
    let steps = Cell::new(0);
    let count = || {
        steps.set(steps.get() + 1);
        false
    };
    assert!(check(&joint, &count).is_some());
    let all = steps.get();
    assert!(all > 4 * joint.parts.len(), "{all} steps of {} parts", joint.parts.len());
    for last in [joint.parts.len() / 2, joint.parts.len() + 1, all / 2, all - 1] {
        steps.set(0);
        let stop = || {
            steps.set(steps.get() + 1);
            steps.get() > last
        };
        assert!(check(&joint, &stop).is_none());
        assert_eq!(steps.get(), last + 1, "it ends at once");
    }
}

/// Two plates with `n` × `n` bolts, the plates in convex pieces around each hole.
fn many_bolts(n: usize) -> Assembly {
    let mut joint = lap_joint();
    let bolt = joint.parts.pop().expect("the bolt");
    let pitch = 60.0;
    let size = pitch * n as f64;
    let at = |i: usize| pitch * (i as f64 + 0.5);
    for plate in &mut joint.parts {
        let z = plate.mid_planes[0].at;
        let whole = Solid::Box { min: [0.0, 0.0, z - 5.0], max: [size, size, z + 5.0] };
        let mut cut = vec![whole];
        plate.convex = Vec::new();
        for (x, y) in (0..n * n).map(|k| (at(k / n), at(k % n))) {
            cut.push(Solid::Cylinder {
                base: [x, y, z - 5.0],
                axis: [0.0, 0.0, 1.0],
                radius: 8.0,
                length: 10.0,
                segments: 16,
            });
            let piece = |a: [f64; 2], b: [f64; 2]| Solid::Box {
                min: [x + a[0], y + b[0], z - 5.0],
                max: [x + a[1], y + b[1], z + 5.0],
            };
            plate.convex.extend([
                piece([-30.0, -8.0], [-30.0, 30.0]),
                piece([8.0, 30.0], [-30.0, 30.0]),
                piece([-8.0, 8.0], [-30.0, -8.0]),
                piece([-8.0, 8.0], [8.0, 30.0]),
            ]);
        }
        plate.solid = Solid::Difference(cut);
    }
    let of_bolt = joint.interfaces.split_off(1);
    for k in 0..n * n {
        let name = format!("BOLT_{k}");
        joint.parts.push(Part { name: name.clone(), ..bolt.clone() });
        crate::geometry::fixtures::move_part(&mut joint, &name, [at(k / n), at(k % n), 0.0]);
        for mut rule in of_bolt.clone() {
            rule.between[0] = name.clone();
            joint.interfaces.push(rule);
        }
    }
    joint
}

/// The expensive part of the check grows with the number of bolts, not with its square. A bolt of
/// five rows costs 89 pairs of pieces: overlap, thin gaps and interface with both plates; one of 23
/// rows, which has more neighbours on average, costs 96.
#[test]
fn the_work_for_five_hundred_bolts_is_bounded() {
    let pairs = |n: usize| {
        let joint = many_bolts(n);
        let search = Search { stop: &|| false, pairs: Cell::new(0) };
        assert_eq!(search.faults(&joint), Some(vec![]));
        search.pairs.get()
    };
    let (few, many) = (pairs(5), pairs(23));
    assert!(few > 25 && many <= 100 * 23 * 23, "{few} and {many} pairs");
    assert!(many as f64 <= 1.2 * few as f64 * (23.0 * 23.0) / 25.0, "{few} and {many} pairs");
}

/// Bolts of all rows are too near to a plate by the same length: that is one message.
#[test]
fn faults_with_one_cause_are_one_message() {
    let mut joint = many_bolts(2);
    for k in 0..4 {
        crate::geometry::fixtures::move_part(&mut joint, &format!("BOLT_{k}"), [0.0, 0.0, -3.0]);
    }
    let m = messages(&joint);
    let clashes: Vec<_> = m.iter().filter(|m| m.0 == "geometry/clash").collect();
    assert_eq!(clashes.len(), 1, "{m:?}");
    assert!(
        clashes[0].1.contains("(BOLT_0)") && clashes[0].1.ends_with("(and 3 more pairs alike)")
    );
}

#[test]
fn sound_joints_pass() {
    assert_eq!(messages(&lap_joint()), vec![]);
    assert_eq!(messages(&paper_joint()), vec![]);
}

#[test]
fn bolt_head_in_the_other_plate_is_a_clash() {
    let mut joint = lap_joint();
    // The bolt moves 3 mm along its axis, and its head enters the upper plate.
    crate::geometry::fixtures::move_part(&mut joint, "BOLT", [0.0, 0.0, -3.0]);
    let m = messages(&joint);
    assert!(
        m.iter().any(|(c, t)| c == "geometry/clash"
            && t.contains("bolt (BOLT)")
            && t.contains("3.000 mm")),
        "{m:?}"
    );
}

#[test]
fn overlapping_bolts_are_named() {
    let mut joint = paper_joint();
    // The bolt at −125 mm moves to 7 mm below the one at 110 mm: heads and shanks overlap.
    crate::geometry::fixtures::move_part(&mut joint, "BOLT_RP2", [0.0, 0.0, 228.0]);
    let m = messages(&joint);
    assert!(
        m.iter().any(|(c, t)| c == "geometry/clash"
            && t.contains("BOLT_RP2")
            && t.contains("BOLT_RP3")),
        "{m:?}"
    );
}

#[test]
fn half_a_millimetre_of_air_is_refused() {
    let mut joint = lap_joint();
    crate::geometry::fixtures::move_part(&mut joint, "LOWER", [0.0, 0.0, -0.5]);
    let m = messages(&joint);
    assert!(
        m.iter().any(|(c, t)| c == "geometry/gap" && t.contains("LOWER") && t.contains("0.500 mm")),
        "{m:?}"
    );
}

#[test]
fn pieces_that_leave_room_around_a_shank_are_no_gap() {
    let mut joint = lap_joint();
    // Convex pieces of the upper plate with a square window half a millimetre wider than the
    // hole.
    let upper = joint.parts.iter_mut().find(|p| p.name == "UPPER").expect("the fixture has it");
    let cuboid =
        |x: [f64; 2], y: [f64; 2]| Solid::Box { min: [x[0], y[0], 0.0], max: [x[1], y[1], 10.0] };
    upper.convex = vec![
        cuboid([-40.0, -8.5], [-30.0, 30.0]),
        cuboid([8.5, 40.0], [-30.0, 30.0]),
        cuboid([-8.5, 8.5], [-30.0, -8.5]),
        cuboid([-8.5, 8.5], [8.5, 30.0]),
    ];
    assert_eq!(messages(&joint), vec![]);
}

#[test]
fn contact_between_parts_apart_is_refused() {
    let mut joint = lap_joint();
    crate::geometry::fixtures::move_part(&mut joint, "LOWER", [0.0, 0.0, -8.0]);
    let m = messages(&joint);
    assert!(m.iter().any(|(c, t)| c == "geometry/apart" && t.contains("8.000 mm")), "{m:?}");
}

#[test]
fn clearance_too_small_gives_reason_and_numbers() {
    let mut joint = paper_joint();
    joint.clearances.push(crate::assembly::assembly::Clearance {
        between: ["BOLT_RP1".into(), "BOLT_RP2".into()],
        min: 70.0,
        reason: "wrench".into(),
    });
    let m = messages(&joint);
    // pitch of 90 mm minus the width across flats of 27 mm
    assert!(m.len() == 1 && m[0].0 == "geometry/clearance" && m[0].1.contains("63.0 mm"), "{m:?}");
}

/// A sloping flange on an end plate leaves an open corner beside its contact, at any slope: that is
/// no gap. A plate 0.4 mm away from another one is, also where the two meet at an end.
#[test]
fn an_open_corner_beside_a_contact_is_no_gap() {
    let spec = include_str!("../../../../../examples/haunched_eaves/joint.yaml");
    for slope in ["0.5", "4", "7", "8.5", "12", "15", "22", "-6"] {
        let rows = "plate: {thickness: 25}";
        let spec = spec.replace("plate: {thickness: 25, z: [-421, 500]}", rows);
        let spec = spec.replace("[-320, 230, 330, 456]", "[-320, 230, 330]");
        let spec = spec.replace("slope: 6 deg", &format!("slope: {slope} deg"));
        let joint = crate::assembly::tests::ok(&spec);
        let found = check(&joint.assembly, &|| false).expect("not stopped");
        assert!(found.is_ok(), "{slope}: {found:#?}");
    }
    let mut joint = lap_joint();
    let block = |min: [f64; 3], max: [f64; 3]| Solid::Box { min, max };
    joint.parts.truncate(2);
    joint.interfaces.clear();
    joint.clearances.clear();
    // an L that touches at its foot and leaves a slot of 0.4 mm above it
    let foot = block([-40.0, -30.0, -10.0], [40.0, 30.0, 0.0]);
    let wall = block([20.4, -30.0, 0.0], [40.0, 30.0, 50.0]);
    let stud = block([0.0, -30.0, 0.0], [20.0, 30.0, 50.0]);
    (joint.parts[0].convex, joint.parts[0].solid) = (vec![stud.clone()], stud);
    joint.parts[1].convex = vec![foot.clone(), wall.clone()];
    joint.parts[1].solid = Solid::Union(vec![foot, wall]);
    let faults = check(&joint, &|| false).expect("not stopped").expect_err("a slot");
    assert!(format!("{faults:?}").contains("0.400"), "{faults:#?}");
}
