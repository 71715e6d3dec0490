//! S_j,ini of joints under one moment, bounded from both sides.

use crate::built::{joint, model};
use bracket::analysis::elastic;
use bracket::analysis::event::silent;
use bracket::analysis::pass::PassOptions;
use bracket::assembly::{Facts, Joint};
use bracket::checks::{JointStiffness, PureMoment, hand_checks};
use bracket::diag::Place;
use bracket::model::AnalysisKind;
use bracket::model::resolve::resolve;
use bracket::result::energy_case::case_result;
use bracket::result::stiffness::joint_stiffness;

/// The load cases of one moment of a joint.
fn moments(joint: &Joint) -> Vec<PureMoment> {
    let e = joint.facts.as_ref().and_then(Facts::end_plate).unwrap();
    hand_checks(e).moments().cloned().collect()
}

/// The stiffness of the first load case's joint, from an elastic analysis on a coarse mesh.
fn stiffness(name: &str, spec: &str) -> Option<JointStiffness> {
    let joint = joint(spec);
    let (file, mesh) = model(&joint, 4.0, false, AnalysisKind::Elastic);
    let m = resolve(&file, mesh, &|_| Place::default()).unwrap_or_else(|e| panic!("{e:#?}"));
    let pass = elastic::run(&m, &PassOptions::default(), &silent()).unwrap();
    let entry = case_result("A", &m, &pass, None);
    assert!(entry.certificate.is_some_and(|c| c.strict), "{name}");
    let s = joint_stiffness(&entry, moments(&joint).iter());
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
    let of = |text: &str| moments(&joint(text));
    assert_eq!(of(&splice(250, "My: 10 kN m")).len(), 1);
    for load in [
        "My: 10 kN m, Vz: 5 kN",
        "My: 10 kN m, N: 30 kN, factor: [My]",
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
fn one_sided([above, below, beam]: [u32; 3]) -> String {
    format!(
        "template: beam_to_column_end_plate\nmembers: {{column: {{profile: HEB160, steel: S235}}, \
         beam: {{profile: IPE200, steel: S235, length: 6 m}}}}\nplate: {{thickness: 12, width: \
         120, z: [-110, 110]}}\nbolts: {{size: M16, grade: \"8.8\", gauge: 80, rows: [-60, \
         60]}}\nparameters: {{column_above: {above}, column_below: {below}, beam_length: {beam}, \
         column_stiffeners: false}}\nfriction: {{mu: 0}}\nloads: [{{name: A, end: beam_right, at: \
         bolt_plane, My: 10 kN m}}]\n"
    )
}

/// Stubs of any length give the same S_j,ini: the middles of the brackets agree within 3 %,
/// although the rotations that they come from do not. The shortest is the template's default.
#[test]
fn the_stiffness_does_not_depend_on_the_lengths_of_column_and_beam() {
    let of = |lengths: [u32; 3]| {
        let s = stiffness(&format!("stubs of {lengths:?}"), &one_sided(lengths)).unwrap();
        let turn = 0.5 * (s.rotation[0] + s.rotation[1]);
        (0.5 * (s.lower + s.upper.unwrap()), turn)
    };
    let found = [[300, 300, 250], [600, 600, 250], [1000, 600, 400]].map(of);
    let (first, turn) = found[0];
    for (middle, _) in found {
        assert!((middle / first - 1.0).abs() < 0.03, "{found:?}");
    }
    assert!((found[2].1 / turn - 1.0).abs() > 0.1, "{found:?}");
}

/// The rotation of the column as a bar under the couple of the beam's flanges, by numerical
/// integration in many steps; HE 260 B with IPE 450, clamped at its foot and held sideways at its
/// head.
/// `shear`: A_v \[mm²\].
fn rotation_of_the_column(above: f64, below: f64, shear: f64) -> f64 {
    let (z, l) = (450.0 - 14.6, above + below);
    let (flexural, modulus) = (210e3 * 14920e4, 210e3 / 2.6);
    let steps = 40_000;
    let ds = l / f64::from(steps);
    // ∫ s²/EI + ∫ 1/GA, ∫ s f/EI + ∫ f'/GA, ∫ f²/EI
    let (mut rr, mut r1, mut one) = (l / (modulus * shear), 1.0 / (modulus * shear), 0.0);
    for i in 0..steps {
        let s = (f64::from(i) + 0.5) * ds;
        let f = ((s - (above - 0.5 * z)) / z).clamp(0.0, 1.0);
        rr += s * s / flexural * ds;
        r1 += s * f / flexural * ds;
        one += f * f / flexural * ds;
    }
    one - r1 * r1 / rr
}

/// The joint of `tests/cases`, with the default column and with longer ones, at any beam: what is
/// subtracted is the rotation of the column as a bar. A load on both beams that balances does not
/// bend it, a splice has none.
#[test]
fn the_column_is_taken_out_as_a_bar() {
    let path =
        concat!(env!("CARGO_MANIFEST_DIR"), "/tests/cases/20-stiffness-with-column-bending.yaml");
    let text = std::fs::read_to_string(path).unwrap();
    let of = |more: &str| {
        let changed = text.replace("web_weld: 5", &format!("web_weld: 5{more}"));
        let [m] = &moments(&joint(&changed))[..] else { panic!("one moment") };
        m.column_rotation.unwrap()
    };
    // the shear formula of HE 260 B over web, fillets and flanges gives 2560 mm²
    assert!(of("") < 0.0, "the panel is relieved by more than the column bends");
    assert_eq!(of(""), of("\n  column_above: 600\n  column_below: 600"));
    for (above, below) in
        [(600.0, 600.0), (450.0, 450.0), (900.0, 900.0), (1500.0, 700.0), (800.0, 3000.0)]
    {
        let found = of(&format!("\n  column_above: {above}\n  column_below: {below}"));
        let bar = |area| 100e6 * rotation_of_the_column(above, below, area);
        let [less, more] = [bar(2540.0), bar(2580.0)];
        assert!(less < found && found < more, "{above} {below}: {less} {found} {more}");
        let beam =
            of(&format!("\n  column_above: {above}\n  column_below: {below}\n  beam_length: 900"));
        assert_eq!(beam, found);
    }
    let both = text.replace("web_weld: 5", "web_weld: 5\n  double_sided: true").replace(
        "analysis:",
        "  - {name: ULS1, end: beam_left, at: column_face, My: 100 kN m}\nanalysis:",
    );
    let both = moments(&joint(&both));
    assert_eq!(both.len(), 2);
    assert!(both.iter().all(|m| m.column_rotation == Some(0.0)));
    let [splice] = &moments(&joint(&splice(250, "My: 10 kN m")))[..] else { panic!("one moment") };
    assert_eq!(splice.column_rotation, Some(0.0));
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
