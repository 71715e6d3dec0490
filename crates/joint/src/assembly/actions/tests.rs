//! Tests of forces and moments at member ends: statics, symmetry, and rejected loads.

use super::PlaneActions;
use crate::assembly::Joint;
use crate::assembly::assembly::{Action, FaceLoad};
use crate::assembly::tests::{joint, ok};
use crate::spec::loads::LimitState;
use bracket_base::math::vec3;

/// A joint of an IPE300 on an HEB200 with 15 mm plates: the column face is at x = 100 mm, the beam
/// ends are at x = 115 + 400 mm.
fn spec(loads: &str) -> String {
    format!(
        "template: beam_to_column_end_plate\nmembers: {{column: {{profile: HEB200, steel: S235}}, \
         beam: {{profile: IPE300, steel: S235}}}}\nplate: {{thickness: 15}}\nbolts: {{size: M20, \
         grade: \"8.8\", rows: [-90, 90, 190]}}\nparameters: {{double_sided: true}}\nloads: \
         {loads}\n"
    )
}

fn resultant(j: &Joint, face: &str, dead: bool) -> ([f64; 3], [f64; 3], [f64; 3]) {
    let all: Vec<&FaceLoad> =
        j.assembly.loads.iter().filter(|l| l.face == face && l.dead == dead).collect();
    match all[..] {
        [FaceLoad { action: Action::Resultant { at, force, moment }, .. }] => {
            (*at, *force, *moment)
        }
        _ => panic!("{all:#?}"),
    }
}

#[test]
fn actions_turn_into_global_forces_of_the_same_sense_at_either_beam() {
    let end = |name: &str| {
        format!(
            "{{name: A, end: {name}, at: column_face, N: 30 kN, Vy: 10 kN, Vz: -2 kN, T: 5 kN m, \
             My: 7 kN m, Mz: 11 kN m}}"
        )
    };
    let j = ok(&spec(&format!("[{}, {}]", end("beam_right"), end("beam_left"))));
    // x′ = x and y′ = z × x = y at the right end; x′ = −x and y′ = z × −x = −y at the left end
    let right = resultant(&j, "BEAM_RIGHT", false);
    assert_eq!(right, ([100.0, 0.0, 0.0], [30e3, 10e3, -2e3], [5e6, 7e6, 11e6]));
    let left = resultant(&j, "BEAM_LEFT", false);
    assert_eq!(left, ([-100.0, 0.0, 0.0], [-30e3, -10e3, -2e3], [-5e6, -7e6, 11e6]));
    // a positive My puts the top in tension: at z > 0 its moment about the axis gives an outward
    // force
    for (moment, outward) in [(right.2, 1.0), (left.2, -1.0)] {
        let pull = vec3::cross([0.0, 0.0, 1.0], [outward, 0.0, 0.0]);
        assert!(vec3::dot(pull, moment) > 0.0);
    }
}

#[test]
fn factor_parts_what_grows_from_what_stays() {
    let load =
        "[{name: A, end: beam_right, at: node, N: 30 kN, Vz: -2 kN, My: 7 kN m, factor: [My, Vz]}]";
    let j = ok(&spec(load));
    assert_eq!(resultant(&j, "BEAM_RIGHT", false), ([0.0; 3], [0.0, 0.0, -2e3], [0.0, 7e6, 0.0]));
    assert_eq!(resultant(&j, "BEAM_RIGHT", true), ([0.0; 3], [30e3, 0.0, 0.0], [0.0; 3]));
    let all_dead = ok(&spec("[{name: A, end: beam_right, at: node, My: 7 kN m, dead: true}]"));
    assert_eq!(all_dead.assembly.loads.len(), 1);
    assert!(all_dead.assembly.loads[0].dead);
}

#[test]
fn symmetry_knows_moments_from_forces() {
    let axes = |loads: &str| -> Vec<usize> {
        ok(&spec(loads)).assembly.symmetry.iter().map(|s| s.axis).collect()
    };
    let pair = |right: &str, left: &str| {
        format!(
            "[{{name: A, end: beam_right, at: column_face, {right}}}, {{name: A, end: beam_left, \
             at: column_face, {left}}}]"
        )
    };
    assert_eq!(axes(&pair("My: 7 kN m, Vz: -1 kN", "My: 7 kN m, Vz: -1 kN")), [0, 1]);
    assert_eq!(axes(&pair("My: 7 kN m", "My: -7 kN m")), [1]);
    assert_eq!(axes(&pair("N: 7 kN", "N: 7 kN")), [0, 1]);
    assert_eq!(axes(&pair("Vy: 7 kN", "Vy: -7 kN")), [0]);
    assert_eq!(axes(&pair("Vy: 7 kN", "Vy: 7 kN")), [] as [usize; 0]);
    // a mirror keeps the moment about its normal, but x′ has the opposite direction at the left end
    assert_eq!(axes(&pair("T: 7 kN m", "T: -7 kN m")), [0]);
    assert_eq!(axes(&pair("T: 7 kN m", "T: 7 kN m")), [] as [usize; 0]);
    assert_eq!(axes(&pair("Mz: 7 kN m", "Mz: -7 kN m")), [0]);
    assert_eq!(axes("[{name: A, end: beam_right, at: column_face, My: 7 kN m}]"), [1]);
}

/// A wrong load, the path that the error reports, and words of the message and of its help.
const WRONG: &[(&str, &str, &[&str])] = &[
    (
        "end: beam_rigth, at: node, My: 7 kN m",
        "loads[0].end",
        &["no member end `beam_rigth`, did you mean `beam_right`?"],
    ),
    ("end: beam_right, My: 7 kN m", "loads[0]", &["does not say where", "at: column_face"]),
    ("end: beam_right, at: node", "loads[0]", &["no forces or moments", "My: 80 kN m"]),
    ("at: node, My: 7 kN m", "loads[0]", &["which member end", "bracket templates"]),
    ("end: beam_right, at: node, My: 7 kN", "loads[0].My", &["`7 kN` is not a moment"]),
    ("end: beam_right, at: node, My: 7", "loads[0].My", &["needs a unit"]),
    ("end: beam_right, at: nodes, My: 7 kN m", "loads[0].at", &["node"]),
    (
        "end: beam_right, at: node, My: 7 kN m, factor: [Vz]",
        "loads[0].factor",
        &["`Vz` carries the load factor but is not given"],
    ),
    (
        "end: beam_right, at: node, My: 7 kN m, factor: [My, My]",
        "loads[0].factor",
        &["`My` stands twice"],
    ),
    (
        "end: beam_right, at: node, My: 7 kN m, factor: [My], dead: true",
        "loads[0].factor",
        &["dead: true"],
    ),
    (
        "end: beam_right, at: node, My: 7 kN m, section: column_top",
        "loads[0]",
        &["mixes", "two loads with the same `name`"],
    ),
    ("end: beam_right, at: node, My: 7 kN m, pressure: 4 MPa", "loads[0]", &["mixes"]),
    ("end: beam_right, at: node, Mx: 7 kN m", "loads[0].Mx", &["unknown"]),
    ("end: beam_right, at: node, My: .nan", "loads[0].My", &["finite"]),
];

#[test]
fn wrong_actions_are_told_with_place_and_cure() {
    let mut wrong = Vec::new();
    for (load, path, words) in WRONG {
        let d =
            joint(&spec(&format!("[{{name: A, {load}}}]"))).map(drop).expect_err(load).into_first();
        let told = format!("{} {}", d.message, d.help.clone().unwrap_or_default());
        let lacks: Vec<_> = words.iter().filter(|w| !told.contains(**w)).collect();
        if d.place.path.as_deref() != Some(*path) || !lacks.is_empty() || d.help.is_none() {
            wrong.push(format!("{load}: lacks {lacks:?}\n{d:#?}"));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n\n"));
    let one_sided = spec("[{name: A, end: beam_left, at: node, My: 7 kN m}]")
        .replace("double_sided: true", "double_sided: false");
    let d = joint(&one_sided).map(drop).expect_err("there is no left beam").into_first();
    assert!(d.message.contains("no member end `beam_left`"), "{d:#?}");
    assert!(
        d.message.contains("`beam_to_column_end_plate` has it only where `double_sided`"),
        "{d:#?}"
    );
    assert!(d.help.as_ref().is_some_and(|h| h.contains("known here: beam_right")), "{d:#?}");
    let twice = "[{name: A, end: beam_right, at: node, My: 7 kN m}, {name: A, end: beam_right, \
                 at: node, N: 7 kN}]";
    let d = joint(&spec(twice)).map(drop).expect_err("twice").into_first();
    assert_eq!(d.place.path.as_deref(), Some("loads[1].end"), "{d:#?}");
}

/// Rounding is left out of the model, whose planes of symmetry are those of the load without it.
#[test]
fn rounding_is_no_load_and_keeps_the_symmetry() {
    let of = |more: &str| {
        let load =
            |end: &str| format!("{{name: A, end: {end}, at: bolt_plane, My: 80 kN m{more}}}");
        ok(&spec(&format!("[{}, {}]", load("beam_right"), load("beam_left"))))
    };
    let clean = of("");
    assert_eq!(clean.assembly.symmetry.len(), 2, "{:?}", clean.assembly.symmetry);
    for noise in [", T: 0.1 N m", ", Mz: 10 N m", ", Vy: 1 N", ", N: -0.01 N", ", Vz: 0.01 N"] {
        let noisy = of(noise);
        assert_eq!(noisy.assembly.symmetry, clean.assembly.symmetry, "{noise}");
        let moments = |j: &Joint| {
            ["BEAM_RIGHT", "BEAM_LEFT"].map(|face| {
                let (_, force, moment) = resultant(j, face, false);
                (force, moment)
            })
        };
        assert_eq!(moments(&noisy), moments(&clean), "{noise}");
        let case = |n: &crate::assembly::Neglected| (n.case.clone(), n.share < 0.01);
        assert!(noisy.neglected.iter().all(|n| case(n) == ("A".into(), true)), "{noise}");
        assert!(noisy.neglected.len() >= 2 && noisy.notes.len() == clean.notes.len() + 1);
    }
    // 2 % of T_Rd = I_t/t_f f_y/√3 = 201 200 mm⁴/10.7 mm · 136 MPa counts
    let twisted = of(", T: 0.052 kN m");
    assert!(twisted.neglected.is_empty() && twisted.assembly.symmetry.len() < 2);
}

/// A small shear force may turn about the bolt plane with a moment that counts; what acts is judged
/// there, each component by itself.
#[test]
fn actions_are_judged_at_the_bolt_plane() {
    let of = |load: &str| ok(&spec(&format!("[{{name: A, end: beam_right, {load}}}]")));
    let names = |j: &Joint| j.neglected.iter().map(|n| n.action.clone()).collect::<Vec<_>>();
    // 100 mm from the node to the plane: 3 kN of Vy turn with 0.3 kN m, more than 1 % of 29 kN m
    let j = of("at: node, My: 60 kN m, Vy: 3 kN");
    assert_eq!(names(&j), ["Vy"]);
    let (at, force, moment) = resultant(&j, "BEAM_RIGHT", false);
    assert_eq!((at, force), ([100.0, 0.0, 0.0], [0.0; 3]));
    assert_eq!(moment, [0.0, 60e6, -0.3e6]);
    // the given moment cancels at the plane
    let j = of("at: node, My: 60 kN m, Vy: 9 kN, Mz: 0.9 kN m");
    assert!(names(&j).is_empty(), "{:?}", j.neglected);
    // an axial force counts but as rounding: 0.01 % of 50 kN over V_pl,Rd
    assert!(names(&of("at: bolt_plane, N: 1 kN")).is_empty());
    assert!(names(&of("at: bolt_plane, N: 1 kN, Vz: -50 kN")).is_empty());
    assert_eq!(names(&of("at: bolt_plane, N: 0.01 kN, Vz: -50 kN")), ["N"]);
    // rounding of the only action of a case is nothing
    let j = of("at: bolt_plane, My: 1 N mm");
    assert!(names(&j) == ["My"] && j.idle.len() == 1 && j.assembly.loads.is_empty(), "{j:#?}");
}

/// A node above the middle of the depth at the plate has N on the height between them as well.
#[test]
fn the_moment_at_the_node_has_the_height_of_the_plane() {
    let actions = PlaneActions {
        case: "A".into(),
        end: "rafter".into(),
        live: [[-40e3, 0.0, -80e3], [0.0, 60e6, 0.0]],
        dead: [[0.0; 3]; 2],
        state: LimitState::Ultimate,
        outward: 1.0,
        from_node: 150.0,
        above_node: -200.0,
    };
    // the compression presses 200 mm below the node, with tension at the top
    assert!((actions.moment_at_node() - (60e6 + 12e6 + 8e6)).abs() < 1e-3);
}
