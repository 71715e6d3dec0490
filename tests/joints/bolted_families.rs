//! Joints whose bolts lap plates, from their specs: published numbers, what the templates and the
//! checks know of each other, drawings for the workshop.

use crate::built::joint;
use bracket::assembly::{Facts, Joint};
use bracket::catalog::Catalog;
use bracket::checks::design_code::build;
use bracket::checks::{Check, CheckId, Status, joint_checks};
use bracket::spec::ConnectionSpec;
use bracket::yaml;
use std::path::Path;

/// The fin plate of Steel Buildings in Europe, Part 5, 3.4: IPE A 550 of S275, plate 360 × 160 ×
/// 10, ten M20 8.8, V = 350 kN; the upper bolts lie 90 mm below the top of the beam.
const FIN: &str = r#"template: fin_plate
members: {column: {profile: HEB300, steel: S275}, beam: {profile: IPEA550, steel: S275}}
plate: {thickness: 10, width: 160, z: [-136.5, 223.5], steel: S275}
bolts: {size: M20, grade: "8.8", gauge: 60, rows: [-96.5, -26.5, 43.5, 113.5, 183.5]}
parameters: {two_columns: true, end_distance: 40, edge_distance: 50, weld: 8}
loads: [{name: ULS1, end: beam, at: column_face, Vz: -350 kN}]
"#;

const HEADER: &str = r#"template: header_plate
members: {column: {profile: HEB200, steel: S235}, beam: {profile: IPE300, steel: S235}}
plate: {thickness: 10, width: 160, z: [-100, 100]}
bolts: {size: M20, grade: "8.8", gauge: 100, rows: [-60, 0, 60]}
parameters: {weld: 4}
loads: [{name: ULS1, end: beam, at: column_face, Vz: -90 kN}]
"#;

const SPLICE: &str = r#"template: cover_plate_splice
members: {beam: {profile: UB457x191x67, steel: S275}}
plate: {thickness: 12, width: 180, steel: S275}
bolts: {size: M20, grade: "8.8", gauge: 120}
parameters:
  {flange_columns: [65, 135, 205], flange_cover: 285, web_rows: [-120, 0, 120],
   web_column: 75, web_columns: 2, web_pitch: 85, web_thickness: 10,
   web_height: 340, web_cover: 210}
loads: [{name: ULS1, end: beam_right, at: bolt_plane, My: 200 kN m, Vz: -150 kN, N: -150 kN}]
"#;

fn checks(joint: &Joint) -> Vec<Check> {
    joint_checks(joint).checks
}

fn find<'a>(checks: &'a [Check], subject: &str, id: CheckId) -> &'a Check {
    let found = checks.iter().find(|c| c.id() == id && c.subject.to_string().contains(subject));
    found.unwrap_or_else(|| panic!("no {id:?} of {subject} in {checks:#?}"))
}

/// Resistance against V = 350 kN \[kN\].
fn resistance(checks: &[Check], subject: &str, id: CheckId) -> f64 {
    let check = find(checks, subject, id);
    350.0 / check.utilisation.expect("a number")
}

/// The published resistances: bolts 584, bearing 605 and 624, plate 450, 497 and 483, web 953, 995
/// and 507 kN. The source rounds the bearing of one bolt to 89 kN, here 88.3.
#[test]
fn a_published_fin_plate_has_its_resistances() {
    let all = checks(&joint(FIN));
    let near = |subject: &str, id: CheckId, wanted: f64| {
        let found = resistance(&all, subject, id);
        assert!((found / wanted - 1.0).abs() < 0.01, "{subject}, {id:?}: {found}, {wanted}");
    };
    near("bolts", CheckId::BoltInGroup, 584.0);
    near("fin plate", CheckId::BearingInGroup, 605.0);
    near("beam web", CheckId::BearingInGroup, 624.0);
    near("fin plate", CheckId::GrossShear, 450.0);
    near("fin plate", CheckId::NetShear, 497.0);
    near("fin plate", CheckId::BlockTearing, 483.0);
    near("beam web", CheckId::GrossShear, 953.0);
    near("beam web", CheckId::NetShear, 995.0);
    near("beam web", CheckId::BlockTearing, 507.0);
    assert!(all.iter().all(|c| c.status != Status::Failed), "{all:#?}");
}

/// The published splice of crates/codes/src/cover_splice/tests/published.rs, read from a spec: N =
/// 150 kN in compression and My = 200 kN m give 68.7 kN in each bolt of the pushed flange and 122.6
/// kN in the corner bolt of the web.
#[test]
fn a_published_splice_has_its_forces() {
    let all = checks(&joint(SPLICE));
    let force = |subject: &str| {
        let of = |c: &&Check| {
            c.id() == CheckId::SpliceBoltShear && c.subject.to_string().contains(subject)
        };
        all.iter().filter(of).filter_map(|c| c.demand).fold(0.0, f64::max) * 1e-3
    };
    let (flange, web) = (force("lower flange"), force("web bolts"));
    assert!((flange / 68.7 - 1.0).abs() < 0.01, "{flange}");
    assert!((web / 122.6 - 1.0).abs() < 0.01, "{web}");
}

/// Gravity at the face of the support turns the bolts of a fin plate by V z; a moment given at the
/// face adds to it.
#[test]
fn the_moment_of_a_fin_plate_is_that_at_its_bolts() {
    let used = |loads: &str| {
        let all = checks(&joint(&FIN.replace("at: column_face, Vz: -350 kN", loads)));
        find(&all, "bolts", CheckId::BoltInGroup).utilisation.expect("a number")
    };
    let at_face = used("at: column_face, Vz: -350 kN");
    // 350 kN · 80 mm of hogging at the bolts' side is the same load, given at the bolts
    let at_bolts = used("at: bolt_plane, Vz: -350 kN, My: -28 kN m");
    assert!((at_face / at_bolts - 1.0).abs() < 1e-12, "{at_face} {at_bolts}");
    let centred = used("at: bolt_plane, Vz: -350 kN");
    assert!((centred * 94.08 * 10.0 / 350.0 - 1.0).abs() < 1e-3, "{centred}");
}

fn with_template(spec: &str, name: &str, changes: &[(&str, &str)]) -> Result<Joint, String> {
    let folder = tempfile::tempdir().expect("a folder");
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("templates/{name}.yaml"));
    let mut template = std::fs::read_to_string(path).expect("a template");
    for (old, new) in changes {
        assert!(template.contains(old), "{old}");
        template = template.replacen(old, new, 1);
    }
    std::fs::write(folder.path().join("mine.yaml"), template).expect("written");
    let text = spec.replace(&format!("template: {name}"), "template: mine.yaml");
    let spec = yaml::parse::<ConnectionSpec>(&text, Path::new("joint.yaml")).expect("a spec");
    let catalog = Catalog::builtin().expect("sound");
    build(&spec, folder.path(), &catalog).map_err(|e| format!("{e:?}"))
}

/// The checks see all of the shipped templates, and nothing that differs from them.
#[test]
fn checks_and_geometry_of_the_families_agree() {
    for (spec, name) in
        [(FIN, "fin_plate"), (HEADER, "header_plate"), (SPLICE, "cover_plate_splice")]
    {
        let whole = with_template(spec, name, &[]).expect("a joint");
        assert_eq!(whole.content.not_checked, [], "{name}");
        assert!(matches!(&whole.facts, Some(Facts::Simple(_) | Facts::CoverSplice(_))), "{name}");
    }
    let open = |spec: &str, name: &str, change: (&str, &str), words: &str| {
        let joint = with_template(spec, name, &[change]).expect("a joint");
        let told: Vec<String> =
            joint.content.not_checked.iter().map(|n| format!("{} {}", n.label, n.why)).collect();
        assert!(told.iter().any(|t| t.contains(words)), "{name}, {change:?}: {told:?}");
        let undecided = checks(&joint)
            .iter()
            .any(|c| c.id() == CheckId::NotChecked && c.status == Status::Undecided);
        assert!(undecided, "{name}, {change:?}");
    };
    let plate = "y: [side, side + plate.thickness]\n          z: [plate_bottom, plate_top]";
    let taller = "y: [side, side + plate.thickness]\n          z: [plate_bottom, plate_top + 4 mm]";
    open(FIN, "fin_plate", (plate, taller), "fin plate");
    open(FIN, "fin_plate", ("throat: weld\n", "throat: weld / 2\n"), "welds with a throat of 8 mm");
    open(
        FIN,
        "fin_plate",
        ("from: beam_start, to", "from: beam_start + 5 mm, to"),
        "another gap, or other notches",
    );
    open(
        HEADER,
        "header_plate",
        ("thickness: support_thickness}", "thickness: support_thickness + 1 mm}"),
        "other plies",
    );
    open(
        SPLICE,
        "cover_plate_splice",
        ("x: [-web_cover, web_cover]", "x: [-web_cover - 5 mm, web_cover]"),
        "web cover",
    );
}

/// Bolts that the checks do not count are refused.
#[test]
fn bolts_that_the_checks_do_not_see_are_refused() {
    let refused = |spec: &str, name: &str, change: (&str, &str), words: &str| {
        let fault = with_template(spec, name, &[change]).expect_err("refused");
        assert!(fault.contains(words), "{name}: {fault}");
    };
    refused(
        FIN,
        "fin_plate",
        ("columns: [first_column, last_column]", "columns: [first_column]"),
        "it sees 5 bolts, the geometry has 10",
    );
    refused(
        HEADER,
        "header_plate",
        ("columns: [-bolts.gauge / 2, bolts.gauge / 2]", "columns: [-40 mm, 40 mm]"),
        "it sees 6 bolts, the geometry has 6",
    );
    refused(
        SPLICE,
        "cover_plate_splice",
        ("web_columns: [web_column, last_web]", "web_columns: [web_column]"),
        "it sees 30 bolts, the geometry has 36",
    );
    refused(FIN, "fin_plate", ("kind: fin_plate", "kind: finplate"), "header_plate");
}

/// Notches shorten the flanges in drawing and checks, and take their steel out of the beam.
#[test]
fn notches_are_cut_out_of_the_beam() {
    let text = FIN.replace("weld: 8", "weld: 8, notch_length: 90, notch_depth: 45");
    let text = text
        .replace("[-136.5, 223.5]", "[-180, 180]")
        .replace("[-96.5, -26.5, 43.5, 113.5, 183.5]", "[-140, -70, 0, 70, 140]");
    let joint = joint(&text);
    let beam = joint.content.members.iter().find(|m| m.part == "BEAM").expect("a beam");
    let starts: Vec<f64> = beam.flanges.iter().map(|f| f[0][0]).collect();
    assert_eq!(starts, [250.0, 250.0], "150 + 10 + 90 mm");
    assert_eq!(beam.web.len(), 2, "beside the notches, and behind them");
    let Some(Facts::Simple(e)) = &joint.facts else { panic!("a simple joint") };
    assert_eq!([e.notches[0].length, e.notches[1].depth], [90.0, 45.0]);
    let all = checks(&joint);
    assert!(all.iter().any(|c| c.id() == CheckId::NotchMoment), "{all:#?}");
}
