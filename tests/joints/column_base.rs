//! Column bases from their specs: what checks and model know of concrete and anchors, bounds
//! against hand values, and what no analysis may decide.

use crate::built::{bounds, joint, model};
use bracket::assembly::{Facts, Joint};
use bracket::checks::{Binding, Check, CheckId, Status, joint_checks};
use bracket::model::AnalysisKind;
use bracket::model::file::{Axis, Law};

/// A base of a HEB 200 with two rows of anchors outside the flanges.
fn base(plate: &str, parameters: &str, load: &str) -> Joint {
    let column = "{column: {profile: HEB200, steel: S235}}";
    let anchors = "{size: M20, grade: \"8.8\", rows: [-140, 140]}";
    joint(&format!(
        "template: column_base\nmembers: {column}\nplate: {{width: 260, {plate}}}\nbolts: \
         {anchors}\nparameters: {{plate_length: 360, {parameters}}}\nfriction: {{mu: 0}}\n\
         loads: [{{name: ULS1, end: column, at: bolt_plane, {load}}}]\n"
    ))
}

/// F_t,Rd = 0.9 · 800 · 245/1.25 of an M20 8.8 anchor \[N\].
const PULL: f64 = 141_120.0;

fn find(checks: &[Check], id: CheckId) -> Vec<&Check> {
    checks.iter().filter(|c| c.id() == id).collect()
}

/// The checks take plate, anchors, welds and column from the geometry, and leave nothing out.
#[test]
fn the_checks_know_all_of_a_base() {
    for parameters in ["", "flange_weld: 8, web_weld: 5", "anchors_carry_shear: true"] {
        let joint = base("thickness: 30", parameters, "N: -400 kN, My: 30 kN m, Vz: 20 kN");
        let Some(Facts::ColumnBase(e)) = &joint.facts else { panic!("{:?}", joint.facts) };
        assert_eq!(e.not_checked, [], "{parameters}");
        assert!(joint.content.members.iter().all(|m| m.known), "{parameters}");
        let checks = joint_checks(&joint).checks;
        let open: Vec<_> = checks.iter().filter(|c| c.status == Status::Undecided).collect();
        assert!(open.is_empty(), "{parameters}: {open:#?}");
    }
}

/// f_jd = β_j k_j f_cd = 2/3 · min(1 + 600/360, 1 + 600/360, 1 + 600/260, 3) · 25/1.5 under all of
/// the plate but the patch that holds it sideways; the anchors end 8 d + 30 mm below it.
#[test]
fn the_model_stands_on_concrete() {
    let joint = base("thickness: 30", "", "N: -400 kN, My: 30 kN m");
    let f_jd = 2.0 / 3.0 * (1.0 + 600.0 / 360.0) * 25.0 / 1.5;
    for kind in [AnalysisKind::Limit, AnalysisKind::Elastic] {
        let (file, mesh) = model(&joint, 3.0, true, kind);
        let ground: Vec<_> =
            file.supports.iter().filter(|s| s.face.starts_with("GROUND")).collect();
        assert_eq!(ground.len(), 4);
        for s in ground {
            assert_eq!((s.law, s.mu), (Some(Law::Contact), Some(0.0)), "{s:?}");
            let limited = kind == AnalysisKind::Limit;
            let want = limited.then_some(f_jd);
            assert_eq!(s.strength.is_some(), want.is_some(), "{s:?}");
            assert!(s.strength.is_none_or(|f| (f / f_jd - 1.0).abs() < 1e-12), "{s:?}");
        }
        let anchors = file.supports.iter().filter(|s| s.face.starts_with("ANCHORAGE"));
        assert_eq!(anchors.filter(|s| s.fix == [Axis::X, Axis::Y, Axis::Z]).count(), 4);
        let deepest = mesh.nodes.iter().map(|x| x[2]).fold(f64::INFINITY, f64::min);
        assert!((deepest + 8.0 * 20.0 + 30.0).abs() < 1e-6, "{deepest}");
        if kind == AnalysisKind::Limit {
            let pulls = file.resultant_limits.iter().filter(|l| l.name.ends_with(": tension"));
            let pulls: Vec<f64> = pulls.map(|l| l.at_most).collect();
            assert_eq!(pulls.len(), 4);
            assert!(pulls.iter().all(|p| (p / PULL - 1.0).abs() < 1e-9), "{pulls:?}");
        }
    }
}

/// Lifted, a thick plate carries F_t,Rd of its four anchors. Pressed, it sinks into weak concrete
/// at f_jd under the plate without the holes and the patch.
#[test]
fn bounds_of_a_base_under_axial_force() {
    let lifted = base("thickness: 60", "", "N: 1 kN");
    let (file, mesh) = model(&lifted, 2.5, false, AnalysisKind::Limit);
    let [low, up] = bounds("lifted", &file, &mesh).map(|x| x * 1e3);
    let exact = 4.0 * PULL;
    assert!(up <= exact * (1.0 + 1e-5) && low <= exact, "[{low}, {up}] for {exact}");
    assert!(low >= 0.95 * exact, "[{low}, {up}] for {exact}");

    let concrete = "concrete_f_ck: 12, concrete_edge: 0, concrete_depth: 300";
    let pressed = base("thickness: 60", concrete, "N: -1 kN");
    let (file, mesh) = model(&pressed, 2.5, false, AnalysisKind::Limit);
    let [low, up] = bounds("pressed", &file, &mesh).map(|x| x * 1e3);
    let holes = 4.0 * std::f64::consts::PI * 10.0 * 10.0;
    let exact = 2.0 / 3.0 * 12.0 / 1.5 * (360.0 * 260.0 - holes - 10.0 * 10.0);
    assert!(
        (low / exact - 1.0).abs() < 1e-5 && (up / exact - 1.0).abs() < 1e-5,
        "[{low}, {up}] for {exact}"
    );
    // the code counts the holes as bearing
    let checks = joint_checks(&pressed).checks;
    let code = find(&checks, CheckId::BaseCompression)[0].resistance.expect("N_Rd");
    assert!((code / (2.0 / 3.0 * 12.0 / 1.5 * 360.0 * 260.0) - 1.0).abs() < 1e-9, "{code}");
}

/// The patch carries any shear and torsion in the model: where neither friction nor anchors are
/// known to carry it, no analysis decides.
#[test]
fn shear_and_torsion_are_beside_the_analysis() {
    let cases = [
        ("", "N: -400 kN, Vz: 100 kN", CheckId::BaseShear, Status::Failed),
        ("", "N: -400 kN, Vy: 60 kN, Vz: 60 kN", CheckId::BaseShear, Status::Failed),
        (
            "anchors_carry_shear: true",
            "N: -400 kN, Vy: 200 kN",
            CheckId::BaseShear,
            Status::Undecided,
        ),
        ("", "N: -400 kN, T: 1 kN m", CheckId::TorsionOfJoint, Status::Undecided),
        ("", "N: 50 kN", CheckId::Anchorage, Status::Undecided),
    ];
    for (parameters, load, id, status) in cases {
        let checks = joint_checks(&base("thickness: 30", parameters, load)).checks;
        let found = find(&checks, id);
        assert!(!found.is_empty(), "{load}");
        let right = |c: &&Check| c.status == status && c.binding == Binding::Beside;
        assert!(found.iter().any(right), "{load}: {found:#?}");
    }
    // friction carries the resultant of 60 and 50 kN
    let checks =
        joint_checks(&base("thickness: 30", "", "N: -400 kN, Vy: 60 kN, Vz: 50 kN")).checks;
    let shear = find(&checks, CheckId::BaseShear)[0];
    let used = shear.utilisation.expect("a demand");
    assert!((used - 60f64.hypot(50.0) / 80.0).abs() < 1e-9, "{shear:#?}");
}
