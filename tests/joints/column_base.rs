//! Column bases from their specs: what checks and model know of concrete and anchors, bounds
//! against hand values, and what no analysis may decide.

use crate::built::{bounds, joint, model, sharp_bounds};
use bracket::assembly::{Facts, Joint};
use bracket::checks::{Binding, Check, CheckId, Status, Topic, joint_checks};
use bracket::model::AnalysisKind;
use bracket::model::file::{Axis, Law};
use bracket_base::math::vec3::{add, area_vector, mul, norm, scale};
use std::f64::consts::PI;

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
/// the plate but the patch that keeps it in place; the anchors end 8 d + 30 mm below it.
#[test]
fn the_model_stands_on_concrete() {
    let joint = base("thickness: 30", "", "N: -400 kN, My: 30 kN m");
    let f_jd = 2.0 / 3.0 * (1.0 + 600.0 / 360.0) * 25.0 / 1.5;
    let c = 30.0 * (235.0_f64 / (3.0 * f_jd)).sqrt();
    let area = 260.0 * (15.0 + 2.0 * c);
    let settles = 22e3 * 3.3f64.powf(0.3) / (1.275 * area.sqrt());
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
            assert_eq!(s.stiffness.is_some(), !limited, "{s:?}");
            assert!(s.stiffness.is_none_or(|k| (k / settles - 1.0).abs() < 1e-12), "{s:?}");
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
            // 6.2.2(7): α_b = 0.44 − 0.0003 · 640
            let most = 0.248 * 800.0 * 245.0 / 1.25;
            let shears = file.resultant_limits.iter().filter(|l| l.name.ends_with(": shear"));
            let shears: Vec<f64> = shears.map(|l| l.at_most).collect();
            assert!(!shears.is_empty(), "{:#?}", file.resultant_limits);
            assert!(shears.iter().all(|v| (v / most - 1.0).abs() < 1e-9), "{shears:?}");
        }
    }
}

/// Anchors in the web plane of a pinned base cut no border of the ground.
#[test]
fn a_row_on_the_axis_of_the_column_is_meshed() {
    for (profile, size, gauge) in [("HEB200", "M20", 100), ("IPE400", "M30", 150)] {
        let pinned = joint(&format!(
            "template: column_base\nmembers: {{column: {{profile: {profile}, steel: S235}}}}\n\
             plate: {{thickness: 25, width: 300}}\nbolts: {{size: {size}, grade: \"8.8\", rows: \
             [0], gauge: {gauge}}}\nfriction: {{mu: 0}}\nloads: [{{name: ULS1, end: column, at: \
             bolt_plane, N: -300 kN}}]\n"
        ));
        let (file, mesh) = model(&pinned, 3.0, true, AnalysisKind::Limit);
        let ground = file.supports.iter().filter(|s| s.face.starts_with("GROUND"));
        assert_eq!((ground.count(), mesh.bodies.len()), (4, 4), "{:?}", mesh.bodies);
    }
}

/// Lifted, a thick plate carries F_t,Rd of its four anchors. Pressed, it sinks into weak concrete
/// at f_jd under the plate without the holes and the patch.
#[test]
fn bounds_of_a_base_under_axial_force() {
    let lifted = base("thickness: 60", "", "N: 1 kN");
    let (file, mesh) = model(&lifted, 2.0, false, AnalysisKind::Limit);
    let [low, up] = sharp_bounds("lifted", &file, &mesh).map(|x| x * 1e3);
    let exact = 4.0 * PULL;
    assert!(up <= exact * (1.0 + 1e-5) && low <= exact, "[{low}, {up}] for {exact}");
    assert!(low >= 0.95 * exact, "[{low}, {up}] for {exact}");

    let concrete = "concrete_f_ck: 12, concrete_edge: 0, concrete_depth: 300";
    let pressed = base("thickness: 60", concrete, "N: -1 kN");
    let (file, mesh) = model(&pressed, 2.5, false, AnalysisKind::Limit);
    let [low, up] = sharp_bounds("pressed", &file, &mesh).map(|x| x * 1e3);
    let holes = 4.0 * PI * 10.0 * 10.0;
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

/// The tractions at the edges of the plate balance shear and torsion, so that the small patch holds
/// nothing and limits no bound.
#[test]
fn shear_leaves_the_plate_at_its_edges() {
    let load = "N: -400 kN, Vy: 40 kN, Vz: 20 kN, My: 30 kN m, T: 2 kN m";
    let (file, mesh) = model(&base("thickness: 30", "", load), 3.0, false, AnalysisKind::Limit);
    let [mut x, mut y, mut torsion] = [0.0; 3];
    for entry in &file.loads {
        let (face, of) = (entry.face.as_ref().expect("a face"), entry.linear.as_ref());
        let of = of.expect("a linear traction");
        for t in &mesh.faces_named(face).expect("an edge").triangles {
            let corners = t.map(|n| mesh.nodes[n as usize]);
            let area = norm(area_vector(&corners));
            // the middles of the sides integrate a quadratic function exactly
            for k in 0..3 {
                let p = scale(0.5, add(corners[k], corners[(k + 1) % 3]));
                let t = add(of.traction0, mul(&of.gradient, p));
                (x, y) = (x + area / 3.0 * t[0], y + area / 3.0 * t[1]);
                torsion += area / 3.0 * (p[0] * t[1] - p[1] * t[0]);
            }
        }
    }
    // the depth of the column lies along x, and z' × x' = up: Vy acts along −y
    let near = |got: f64, size: f64| (got.abs() / size - 1.0).abs() < 1e-9;
    assert!(near(x, 20e3) && near(y, 40e3) && near(torsion, 2e6), "{x} {y} {torsion}");

    let sheared = base("thickness: 30", "", "N: -400 kN, Vz: 20 kN, My: 30 kN m");
    let (file, mesh) = model(&sheared, 3.0, true, AnalysisKind::Limit);
    let [low, up] = bounds("sheared", &file, &mesh);
    assert!(low > 2.2 && up < 2.75, "[{low}, {up}]");
}

/// Ribs are part of the column and welded to the plate; no check knows them, and they need a flat
/// wall.
#[test]
fn ribs_are_in_the_geometry_and_open_by_code() {
    let load = "N: -400 kN, My: 30 kN m";
    let ribbed = base("thickness: 20", "ribs: true, rib_weld: 6, rib_length: 60", load);
    let Some(Facts::ColumnBase(e)) = &ribbed.facts else { panic!("{:?}", ribbed.facts) };
    assert!(!e.not_checked.is_empty(), "the rib is seen");
    // along the web and its four root fillets: HEB200 has d = 134 and r = 18
    let seams = base("thickness: 20", "web_weld: 5", load).content.seams;
    let web: Vec<f64> = seams.iter().filter(|s| s.throat == 5.0).map(|s| s.length).collect();
    assert!(web.len() == 1 && (web[0] - 2.0 * (134.0 + PI * 18.0)).abs() < 1e-6, "{seams:?}");
    let open = joint_checks(&ribbed).checks.into_iter().any(|c| c.status == Status::Undecided);
    assert!(open);
    let (file, mesh) = model(&ribbed, 3.0, true, AnalysisKind::Limit);
    let welds = file.interfaces.iter().filter(|i| i.law == Law::Weld);
    assert_eq!(welds.count(), 2, "{:#?}", file.interfaces);
    // 90 mm high and 60 mm long, less the sloping edge from (15, 90) to (60, 15)
    let thick = 15.0;
    let area = 60.0 * 90.0 - 0.5 * 45.0 * 75.0;
    let plain = model(&base("thickness: 20", "", load), 3.0, true, AnalysisKind::Limit).1;
    let column = |m: &bracket::mesh::TetMesh| -> f64 {
        let body = m.bodies.iter().position(|b| b == "COLUMN").expect("the column") as u32;
        let own = (0..m.tets.len()).filter(|&e| m.tet_body[e] == body);
        own.map(|e| m.volume(e)).sum()
    };
    let more = column(&mesh) - column(&plain);
    assert!((more / (2.0 * area * thick) - 1.0).abs() < 1e-3, "{more} mm³");
}

/// A hollow column: its base is pressed on the frame or ring within c of its walls, and no check
/// knows how it bends; the weld round it and the column are checked.
#[test]
fn hollow_columns_are_checked_where_the_code_has_rules() {
    let hollow = |profile: &str, load: &str| {
        let column = format!("{{column: {{profile: {profile}, steel: S235}}}}");
        joint(&format!(
            "template: column_base\nmembers: {column}\nplate: {{width: 360, thickness: 20}}\n\
             bolts: {{size: M20, grade: \"8.8\", rows: [-150, 150], gauge: 200}}\nparameters: \
             {{plate_length: 400, flange_weld: 5, anchorage_checked: true}}\nfriction: {{mu: 0}}\n\
             loads: [{{name: ULS1, end: column, at: bolt_plane, {load}}}]\n"
        ))
    };
    // k_j: the smallest of 1 + 600/400, 1 + 600/400 and 1 + 600/360
    let f_jd = 2.0 / 3.0 * 2.5 * 25.0 / 1.5;
    let c = 20.0 * (235.0f64 / (3.0 * f_jd)).sqrt();
    let square = (200.0 + 2.0 * c).powi(2) - (184.0 - 2.0 * c).powi(2);
    let (outer, inner) = (219.1 + 2.0 * c, 203.1 - 2.0 * c);
    let ring = std::f64::consts::FRAC_PI_4 * (outer * outer - inner * inner);
    for (profile, area) in [("SHS200x8", square), ("CHS219.1x8", ring)] {
        let pressed = hollow(profile, "N: -400 kN, Vz: 20 kN");
        let Some(Facts::ColumnBase(e)) = &pressed.facts else { panic!("{:?}", pressed.facts) };
        assert_eq!(e.not_checked, [], "{profile}");
        assert!(pressed.content.members.iter().all(|m| m.known), "{profile}");
        // the weld runs round the outside once; cold-formed corners (EN 10219-2) have 2.5 t there
        let corner = |r: f64| 4.0 * 200.0 - (8.0 - 2.0 * PI) * r;
        let round = match profile {
            "CHS219.1x8" => [PI * 219.1 * (1.0 - 1e-6), PI * 219.1 * (1.0 + 1e-6)],
            _ => [corner(20.0) - 1e-3, corner(20.0) + 1e-3],
        };
        let lengths: Vec<f64> = pressed.content.seams.iter().map(|s| s.length).collect();
        assert!(
            lengths.len() == 1 && lengths[0] > round[0] && lengths[0] < round[1],
            "{lengths:?}"
        );
        let checks = joint_checks(&pressed).checks;
        assert!(checks.iter().all(|c| c.status != Status::Undecided), "{profile}: {checks:#?}");
        let code = find(&checks, CheckId::BaseCompression)[0].resistance.expect("N_Rd");
        assert!((code / (f_jd * area) - 1.0).abs() < 1e-9, "{profile}: {code}");

        let bent = joint_checks(&hollow(profile, "N: -400 kN, My: 20 kN m")).checks;
        assert!(find(&bent, CheckId::BaseCompression).is_empty());
        let open = find(&bent, CheckId::BaseMoment)[0];
        assert!(open.status == Status::Undecided && open.binding != Binding::Beside, "{open:#?}");
        // an anchor brings at most what it carries itself
        let anchorage = find(&bent, CheckId::Anchorage)[0];
        assert_ne!(anchorage.status, Status::Undecided, "{anchorage:#?}");
        // the weld round the column: N/A + M/W of the wall, times its thickness
        let weld = bent.iter().find(|c| c.topic == Topic::Welds && c.case.is_some());
        assert!(weld.and_then(|c| c.utilisation).is_some_and(|u| u > 0.3 && u < 1.0), "{weld:#?}");
    }
    // and the mesh has the area of the tube under the load
    let (file, mesh) =
        model(&hollow("CHS219.1x8", "N: -1 kN, My: 100 kN mm"), 4.0, false, AnalysisKind::Limit);
    assert!(file.interfaces.iter().any(|i| i.face.as_deref() == Some("WELD")), "{file:#?}");
    let tube = PI * (219.1 - 8.0) * 8.0;
    let end = mesh.faces_named("COLUMN").expect("the loaded section");
    let corners = |t: &[u32; 3]| t.map(|n| mesh.nodes[n as usize]);
    let meshed: f64 = end.triangles.iter().map(|t| norm(area_vector(&corners(t)))).sum();
    assert!(
        (2.0 * meshed / tube - 1.0).abs() < 1e-3 || (4.0 * meshed / tube - 1.0).abs() < 1e-3,
        "{meshed}"
    );
}

/// Shear and torsion leave the model at the edges of the plate: where neither friction nor anchors
/// are known to carry them, no analysis decides.
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
