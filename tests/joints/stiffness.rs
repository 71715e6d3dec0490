//! S_j,ini of joints under one moment, bounded from both sides.

use crate::built::{joint, model};
use bracket::analysis::elastic;
use bracket::analysis::event::silent;
use bracket::analysis::pass::PassOptions;
use bracket::checks::{JointStiffness, hand_checks};
use bracket::diag::Place;
use bracket::model::resolve::resolve;
use bracket::result::energy_case::case_result;
use bracket::result::stiffness::joint_stiffness;
use bracket::spec::analysis::AnalysisKind;

/// The stiffness of the first load case's joint, from an elastic analysis on a coarse mesh.
fn stiffness(name: &str, spec: &str) -> Option<JointStiffness> {
    let joint = joint(spec);
    let (file, mesh) = model(&joint, 4.0, false, AnalysisKind::Elastic);
    let m = resolve(&file, mesh, &|_| Place::default()).unwrap_or_else(|e| panic!("{e:#?}"));
    let pass = elastic::run(&m, &PassOptions::default(), &silent()).unwrap();
    let entry = case_result("A", &m, &pass, None);
    assert!(entry.certificate.is_some_and(|c| c.strict), "{name}");
    let s = joint_stiffness(&entry, &hand_checks(joint.end_plate.as_ref().unwrap()).moments);
    if let Some(s) = &s {
        println!(
            "{name}: {} tets, φ [{:.4}, {:.4}] mrad, beam {:.4}, S_j,ini [{:.0}, {:.0}] kN m/rad, \
             component method {:.0}",
            m.mesh.tets.len(),
            1e3 * s.rotation[0],
            1e3 * s.rotation[1],
            1e3 * s.beam_rotation,
            1e-6 * s.lower,
            1e-6 * s.upper.unwrap_or(f64::NAN),
            1e-6 * s.component_method
        );
    }
    s
}

fn splice(length: u32, load: &str) -> String {
    format!(
        "template: beam_splice\nmembers: {{beam: {{profile: IPE200, steel: S235}}}}\nplate: \
         {{thickness: 12, width: 110, z: [-110, 110]}}\nbolts: {{size: M16, grade: \"8.8\", \
         gauge: 70, rows: [-60, 60]}}\nparameters: {{beam_length: {length}}}\nfriction: {{mu: \
         0}}\nloads: [{{name: A, end: beam_right, at: bolt_plane, {load}}}]\n"
    )
}

/// The bending of the stubs is subtracted. With stubs of 500 mm instead of 250 mm both bounds of
/// the rotation grow by M ΔL/(E I_b), within a few per cent because of the stresses near the ends
/// and the different mesh. The brackets of S_j,ini contain the same stiffness.
#[test]
fn the_stiffness_does_not_depend_on_the_length_of_the_stubs() {
    let [short, long] =
        [250, 500].map(|l| stiffness(&format!("stubs of {l}"), &splice(l, "My: 10 kN m")).unwrap());
    let beam = long.beam_rotation - short.beam_rotation;
    // two stubs, IPE200
    assert!((beam / (10e6 * 500.0 / (210e3 * 1943e4)) - 1.0).abs() < 1e-3, "{beam}");
    for k in 0..2 {
        let grown = (long.rotation[k] - short.rotation[k]) / beam;
        assert!((grown - 1.0).abs() < 0.05, "{grown}: {short:?} {long:?}");
    }
    let (a, b) = (short.upper.unwrap(), long.upper.unwrap());
    assert!(short.lower <= b && long.lower <= a, "{short:?} {long:?}");
    assert!(short.classes.is_empty() && short.column_rotation == 0.0);
}

/// With any load beside the moment, or with a gap, the energy is no longer M φ/2 and no stiffness
/// is printed.
#[test]
fn a_shear_force_or_a_gap_gives_no_stiffness() {
    let of = |text: &str| hand_checks(joint(text).end_plate.as_ref().unwrap()).moments;
    assert_eq!(of(&splice(250, "My: 10 kN m")).len(), 1);
    for load in [
        "My: 10 kN m, Vz: 5 kN",
        "My: 10 kN m, N: 1 kN, factor: [My]",
        "Mz: 1 kN m",
        "My: 10 kN m, T: 0.1 kN m",
    ] {
        assert!(of(&splice(250, load)).is_empty(), "{load}");
    }
    let gap = splice(250, "My: 10 kN m")
        .replace("beam_length: 250", "beam_length: 250, hole_clearance: 2, head_contact: false");
    assert!(stiffness("with a gap", &gap).is_none());
}

/// A one-sided joint; lengths of the column above and below the beam's axis, and of the beam.
fn one_sided([above, below, beam]: [u32; 3], more: &str) -> String {
    format!(
        "template: beam_to_column_end_plate\nmembers: {{column: {{profile: HEB160, steel: S235}}, \
         beam: {{profile: IPE200, steel: S235, length: 6 m}}}}\nplate: {{thickness: 12, width: 120, \
         z: [-110, 110]}}\nbolts: {{size: M16, grade: \"8.8\", gauge: 80, rows: [-60, \
         60]}}\nparameters: {{column_above: {above}, column_below: {below}, beam_length: \
         {beam}{more}}}\nfriction: {{mu: 0}}\nloads: [{{name: A, end: beam_right, at: bolt_plane, \
         My: 10 kN m}}]\n"
    )
}

/// Stubs of any length give the same S_j,ini: the middles of the brackets agree within 3 %,
/// although the rotations that they come from do not. The default of the template is the shortest.
#[test]
fn the_stiffness_does_not_depend_on_the_lengths_of_column_and_beam() {
    for more in [", column_stiffeners: false", ", column_stiffeners: true"] {
        let of = |lengths: [u32; 3]| {
            let s = stiffness(&format!("{lengths:?}{more}"), &one_sided(lengths, more)).unwrap();
            let middle = 0.5 * (s.lower + s.upper.unwrap());
            (middle, 0.5 * (s.rotation[0] + s.rotation[1]))
        };
        let stubs = [[300, 300, 250], [600, 600, 250], [1000, 600, 400], [1000, 1000, 250]];
        let found = stubs.map(of);
        let (first, turns) = found[0];
        for (middle, _) in found {
            assert!((middle / first - 1.0).abs() < 0.03, "{found:?}");
        }
        assert!(found.iter().any(|(_, turn)| (turn / turns - 1.0).abs() > 0.1), "{found:?}");
    }
}

/// One-sided joint: the class at a span of 6 m follows from the boundaries of 5.2.2.5 and the
/// bracket.
#[test]
fn a_joint_at_a_column_has_a_class() {
    let spec = "template: beam_to_column_end_plate\nmembers: {column: {profile: HEB160, steel: \
                S235}, beam: {profile: IPE200, steel: S235, length: 6 m}}\nplate: {thickness: 12, \
                width: 120, z: [-110, 110]}\nbolts: {size: M16, grade: \"8.8\", gauge: 80, rows: \
                [-60, 60]}\nfriction: {mu: 0}\nloads: [{name: A, end: beam_right, at: bolt_plane, \
                My: 10 kN m}]\n";
    let s = stiffness("one-sided", spec).unwrap();
    assert!(s.column_rotation != 0.0 && s.classes.len() == 2, "{s:?}");
    // E I_b/L_b of IPE200, 1943 cm⁴, over 6 m
    let unit = 210e3 * 1943e4 / 6000.0;
    for (class, k) in s.classes.iter().zip([8.0, 25.0]) {
        let of = |stiffness: f64| {
            if stiffness >= k * unit {
                0
            } else if stiffness > 0.5 * unit {
                1
            } else {
                2
            }
        };
        let found = class.class.unwrap().map(|c| c as usize);
        assert_eq!(found, [of(s.lower), of(s.upper.unwrap_or(f64::INFINITY))], "{s:?}");
    }
}
