//! `analysis: limit` by the compiled program: its answers, its files, what `verify` reports on
//! them, and the inputs that it refuses.
//!
//! ```text
//!  |[=======]→ t     a bar of 30 × 10 × 12 mm on rollers, t = 100 MPa: collapse at f_y/t = 2.35
//! ```

use super::limit_verify::edit_field;
use super::mesh;
use crate::bench::expect;
use crate::bench::{Bench, Want, none_wrong, refusal};
use crate::common::Block;
use bracket::mesh::msh_write;
use bracket::result::fields::vtu::VtuGrid;
use serde_json::{Value, json};

pub const BAR: &str = "\
mesh: m.msh
analysis: limit
materials: {steel: {E: 210000, nu: 0.3, fy: 235}}
bodies: {B: steel}
supports:
  - {face: X0, fix: [x]}
  - {face: Y0, fix: [y]}
  - {face: Z0, fix: [z]}
loads:
  - {face: X1, traction: [100, 0, 0]}
";

const EXACT: f64 = 2.35;

/// A block on a base under half of the pressure that it can carry: proportional pressure, contact,
/// friction.
pub const STACK: &str = "\
mesh: m.msh
analysis: limit
materials: {steel: {E: 210000, nu: 0.3, fy: 235}}
bodies: {BASE: steel, BLOCK: steel}
interfaces:
  - {between: [BLOCK, BASE], law: contact, mu: 0.3, friction: associated}
supports:
  - {face: Z0, fix: [x, y, z]}
  - {face: X0, fix: [x]}
  - {face: Y0, fix: [y]}
loads:
  - {face: Z1, traction: [0, 0, -100]}
";

fn bar_mesh() -> String {
    msh_write::text(&Block::new([3, 2, 2], [30.0, 10.0, 12.0]).jittered(3).mesh(
        &["B"],
        |_| 0,
        |_, _| false,
    ))
}

pub fn bar(model: &str) -> Bench {
    Bench::new().file("bar.yaml", model).file("m.msh", bar_mesh())
}

pub fn result(bench: &Bench, folder: &str) -> Value {
    serde_json::from_str(&bench.read(&format!("{folder}/result.json"))).expect("JSON")
}

pub fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or_else(|| panic!("a number, not {value}"))
}

#[test]
fn a_bar_collapses_where_it_must() {
    let bench = bar(BAR);
    let (_, err) = expect(&bench, &["analyse", "bar.yaml"], 0);
    // the bounds are rounded outwards; the exact 28.2 kN lies between them
    assert!(
        err.contains("bar: load factor between 2.3499") && err.contains("(certified)"),
        "{err}"
    );
    assert!(err.contains("collapse load between 28.19") && err.contains(" and 28.20"), "{err}");

    let result = result(&bench, "bar");
    assert_eq!(result["verdict"], "none");
    let case = &result["cases"][0];
    for (key, value) in
        [("analysis", "limit"), ("quantity", "load_factor"), ("problem", "frictionless")]
    {
        assert_eq!(case[key], value);
    }
    let (lower, upper) = (number(&case["lower"]), number(&case["upper"]));
    assert!(lower <= EXACT && upper >= EXACT, "{lower} {upper}");
    let gap = number(&case["gap"]);
    assert!(gap < 1e-5 && (gap - (upper - lower) / lower).abs() < 1e-12, "{gap}");
    let certificate = &case["certificate"];
    assert_eq!(certificate["strict"], true);
    for key in ["equilibrium", "traction_jump", "compatibility", "volume"] {
        let residual = number(&certificate[key]);
        assert!((0.0..=1e-9).contains(&residual), "{key} {residual}");
    }
    let inside = number(&certificate["yield"]);
    assert!(inside <= 0.0 && inside > -1e-4, "{inside}");
    assert!(certificate.get("contact").is_none() && case.get("load_displacement").is_none());
    assert!(case.get("frictionless").is_none() && case.get("associated").is_none());
    assert!((number(&case["load"]["force"]) - 12_000.0).abs() < 1e-6);
    assert_eq!(case["limiting_part"], "B");
    assert_eq!(case["dissipation"], json!([{"part": "B", "share": 1.0}]));
    let row = &case["history"][0];
    for program in ["kinematic", "static"] {
        assert_eq!(row[program]["status"], "optimal");
        assert!(number(&row[program]["iterations"]) > 2.0);
    }

    let report = bench.read("bar/report.md");
    for words in [
        "load factor at collapse lies between **2.3499",
        "The given load of the whole structure is 12.00 kN; the load at collapse lies between",
        "nearest to the yield surface in body **B**",
        "| B | 100.0 |",
        "![Case bar: mechanism of the upper bound, coloured by its dissipation: 100 % in B; half",
        "![Case bar: zones that limit the lower bound, coloured where more strength would raise",
        "Limit analysis: rigid, perfectly plastic",
        "| bar | volume |",
    ] {
        assert!(report.contains(words), "lacks {words}\n{report}");
    }
    if cfg!(feature = "pdf") {
        let pdf = bench.path().join("bar/report.pdf");
        let run = std::process::Command::new("pdftotext").arg(pdf).arg("-").output();
        let text = run.expect("pdftotext, of the package poppler-utils").stdout;
        let text = String::from_utf8_lossy(&text).split_whitespace().collect::<Vec<_>>().join(" ");
        for words in ["load factor at collapse lies between 2.3499", "≥ 2.34", "≤ 2.3"] {
            assert!(text.contains(words), "lacks {words}\n{text}");
        }
        let german = ["report", "bar", "--full", "--language", "de", "--format", "json"];
        let told: Value = serde_json::from_slice(&bench.run(&german).stdout).expect("JSON");
        assert_eq!(told["untranslated"], json!([]));
    }
    assert!(bench.path().join("bar/mechanism_bar.png").is_file());
    assert!(bench.path().join("bar/limiting_bar.png").is_file());
    let grid = |kind: &str| {
        let bytes =
            std::fs::read(bench.path().join(format!("bar/fields/bar_{kind}.vtu"))).expect("field");
        VtuGrid::from_bytes(&bytes).expect("our own file")
    };
    let (kinematic, stress) = (grid("kinematic"), grid("static"));
    assert_eq!(kinematic.point_array("velocity").map(|a| a.1), Some(3));
    // the power dissipated in the tets equals the power of the load at the upper bound
    let factor = dissipated(&kinematic) / power_of_the_pull(&kinematic);
    assert!((factor / upper - 1.0).abs() < 1e-8, "{factor} {upper}");
    let used = &stress.cell_array("utilisation").expect("utilisations").2;
    assert!(used.iter().all(|u| (0.99..=1.0).contains(u)), "{used:?}");
}

/// Dissipation densities times the volumes of the tets.
fn dissipated(grid: &VtuGrid) -> f64 {
    let density = &grid.cell_array("dissipation_density").expect("densities").2;
    let volume = |cell: &[u32]| {
        let [a, b, c, d] = [0, 1, 2, 3].map(|i| grid.points[cell[i] as usize]);
        let [p, q, r] = [b, c, d].map(|x| [0, 1, 2].map(|k| x[k] - a[k]));
        let cross =
            [q[1] * r[2] - q[2] * r[1], q[2] * r[0] - q[0] * r[2], q[0] * r[1] - q[1] * r[0]];
        (0..3).map(|k| p[k] * cross[k]).sum::<f64>().abs() / 6.0
    };
    grid.cells.chunks_exact(10).zip(density).map(|(cell, d)| volume(cell) * d).sum()
}

/// The power of 100 MPa on the velocities along x of the end x = 30 mm. The integral of a quadratic
/// function over a face depends on its mid-side nodes alone.
fn power_of_the_pull(grid: &VtuGrid) -> f64 {
    let v = &grid.point_array("velocity").expect("velocities").2;
    // the corners of each face, then its mid-side nodes, in the order of a quadratic tet: 01 12 02
    // 03 13 23
    let faces = [[0, 1, 2, 4, 5, 6], [0, 1, 3, 4, 8, 7], [1, 2, 3, 5, 9, 8], [0, 2, 3, 6, 9, 7]];
    let mut power = 0.0;
    for (cell, face) in grid.cells.chunks_exact(10).flat_map(|c| faces.map(|f| (c, f))) {
        let [a, b, c] = [0, 1, 2].map(|i| grid.points[cell[face[i]] as usize]);
        if [a, b, c].iter().all(|x| (x[0] - 30.0).abs() < 1e-9) {
            let area = 0.5 * ((b[1] - a[1]) * (c[2] - a[2]) - (b[2] - a[2]) * (c[1] - a[1])).abs();
            power +=
                100.0 * area / 3.0 * (3..6).map(|i| v[3 * cell[face[i]] as usize]).sum::<f64>();
        }
    }
    power
}

#[test]
fn one_bound_alone_is_certified_too() {
    for (bounds, has, lacks) in [("static", "lower", "upper"), ("kinematic", "upper", "lower")] {
        let bench = bar(&format!("{BAR}bounds: {bounds}\n"));
        expect(&bench, &["analyse", "bar.yaml", "-q"], 0);
        let case = &result(&bench, "bar")["cases"][0];
        assert!((number(&case[has]) / EXACT - 1.0).abs() < 1e-5, "{case}");
        assert!(case.get(lacks).is_none() && case.get("gap").is_none(), "{case}");
        expect(&bench, &["verify", "bar"], 0);
    }
}

/// Dead loads are not multiplied: a dead tension of 100 MPa reduces the load factor by one.
#[test]
fn dead_loads_are_not_multiplied() {
    let bench = bar(&format!("{BAR}dead:\n  - {{face: X1, traction: [100, 0, 0]}}\n"));
    expect(&bench, &["analyse", "bar.yaml", "-q"], 0);
    let case = &result(&bench, "bar")["cases"][0];
    let (lower, upper) = (number(&case["lower"]), number(&case["upper"]));
    assert!(
        lower <= EXACT - 1.0 && upper >= EXACT - 1.0 && upper - lower < 1e-4,
        "{lower} {upper}"
    );
}

#[test]
fn dead_loads_that_nothing_can_carry_leave_no_lower_bound() {
    let bench = bar(&format!(
        "{BAR}dead:\n  - {{face: X1, traction: [0, 0, 0]}}\n  - {{face: Y1, traction: [0, 300, \
         0]}}\n"
    ));
    let (_, err) = expect(&bench, &["analyse", "bar.yaml"], 3);
    assert!(
        err.contains("the dead loads alone make it collapse") && !err.contains("(certified)"),
        "{err}"
    );
    let case = &result(&bench, "bar")["cases"][0];
    assert!(case.get("lower").is_none() && case.get("certificate").is_none(), "{case}");
}

/// The bar is pressed on one side and held on all others, so it has no mechanism. A pressure field
/// proves that the load has no limit, and `verify` repeats the proof.
#[test]
fn a_load_without_limit_is_proved_by_a_pressure() {
    let held = BAR.replace("loads:", "  - {face: Y1, fix: [y]}\n  - {face: Z1, fix: [z]}\nloads:");
    let bench = bar(&held.replace("[100, 0, 0]", "[-100, 0, 0]"));
    let (_, err) = expect(&bench, &["analyse", "bar.yaml"], 0);
    assert!(err.contains("bar: load factor without limit (certified)"), "{err}");
    let case = &result(&bench, "bar")["cases"][0];
    assert_eq!(case["upper"], "unbounded");
    assert!(
        case["certificate"]["strict"] == true
            && case.get("gap").is_none()
            && case.get("lower").is_none(),
        "{case}"
    );
    let (found, _) = expect(&bench, &["verify", "bar"], 0);
    assert!(found.contains("no limit") && found.matches("confirmed").count() == 1, "{found}");
    // a field that is not a pure pressure proves nothing
    edit_field(&bench, "bar_static_live.vtu", "stress_mandel", 1.01);
    let (found, _) = expect(bench.sealed("bar"), &["verify", "bar"], 1);
    assert!(found.contains("REFUTED"), "{found}");
    // a claim without a field proves nothing
    std::fs::remove_file(bench.path().join("bar/fields/bar_static_live.vtu")).expect("removed");
    expect(&bench, &["verify", "bar"], 2);
}

/// A block that only contact holds is lifted. It carries no load at all, and `verify` confirms the
/// motion that proves it.
#[test]
fn what_moves_without_load_carries_nothing() {
    for friction in ["associated", "coulomb"] {
        let model = STACK
            .replace("  - {face: X0, fix: [x]}\n  - {face: Y0, fix: [y]}\n", "")
            .replace("[0, 0, -100]", "[2, 0, 5]")
            .replace("associated", friction);
        let bench = Bench::new().file("stack.yaml", model).file("m.msh", mesh(60.0));
        let (_, err) = expect(&bench, &["analyse", "stack.yaml"], 0);
        assert!(err.contains("load factor 0, a mechanism needs no load (certified)"), "{err}");
        assert!(err.contains("part BLOCK moves along +z"), "{err}");
        let case = &result(&bench, "stack")["cases"][0];
        assert!(number(&case["lower"]) == 0.0 && number(&case["upper"]) == 0.0, "{case}");
        assert!(case["certificate"]["strict"] == true && case.get("gap").is_none(), "{case}");
        let report = bench.read("stack/report.md");
        assert!(report.contains("is **0**: a mechanism moves the structure freely"), "{report}");
        let (found, _) = expect(&bench, &["verify", "stack"], 0);
        assert!(found.contains("confirmed") && !found.contains("REFUTED"), "{found}");
        // velocities that press the block into its base prove nothing
        let name = "stack_kinematic.vtu";
        let path = bench.path().join("stack/fields").join(name);
        let mut bytes = std::fs::read(&path).expect("field");
        let grid = VtuGrid::from_bytes(&bytes).expect("our own file");
        let moved =
            grid.point_array("velocity").expect("velocities").2.iter().copied().fold(0.0, f64::max);
        let at = bytes
            .windows(8)
            .position(|w| w == moved.to_le_bytes())
            .expect("the value stands in the file");
        bytes[at..at + 8].copy_from_slice(&(-moved).to_le_bytes());
        std::fs::write(&path, bytes).expect("written");
        expect(bench.sealed("stack"), &["verify", "stack"], 1);
    }
}

/// Coulomb's law is bracketed from below by the problem without friction, and from above by the
/// problem with associated friction. The result contains both bounds.
#[test]
fn coulomb_friction_is_bracketed_by_the_two_problems_around_it() {
    let solved = |friction: &str, keys: &str| {
        let model = STACK.replace("friction: associated", friction) + keys;
        let bench = Bench::new().file("stack.yaml", model).file("m.msh", mesh(60.0));
        let (_, err) = expect(&bench, &["analyse", "stack.yaml"], 0);
        let (found, _) = expect(&bench, &["verify", "stack"], 0);
        (result(&bench, "stack")["cases"][0].clone(), bench.read("stack/report.md"), err, found)
    };
    let (associated, report, err, found) = solved("friction: associated", "");
    assert!(err.contains("once more, without friction"), "{err}");
    assert_eq!(found.matches("confirmed").count(), 3, "{found}");
    assert_eq!(associated["problem"], "associated");
    let smooth = number(&associated["frictionless"]["lower"]);
    let [lower, upper] = ["lower", "upper"].map(|k| number(&associated[k]));
    assert!(
        smooth > 2.0 && smooth <= lower * (1.0 + 1e-6) && lower < upper && upper < 4.0,
        "{associated}"
    );
    assert!(
        report.contains("Without dilation (Coulomb's law")
            && report.contains("static, frictionless"),
        "{report}"
    );

    let (coulomb, report, _, found) = solved("friction: coulomb", "");
    assert_eq!(found.matches("confirmed").count(), 3, "{found}");
    assert_eq!(coulomb["problem"], "coulomb");
    assert_eq!(number(&coulomb["lower"]), smooth);
    assert_eq!(number(&coulomb["upper"]), upper);
    assert_eq!(coulomb["associated"], json!({"lower": lower, "upper": upper}));
    assert_eq!(coulomb["certificate"]["strict"], true);
    assert!((number(&coulomb["gap"]) - (upper - smooth) / smooth).abs() < 1e-12);
    assert!(report.contains("Under Coulomb's law the load factor is at least"), "{report}");
    assert!(
        !report.contains("Fixed point") && coulomb.get("coulomb_estimate").is_none(),
        "{report}"
    );

    // on request the result has an estimate between the bounds; the bounds do not change
    let (estimated, report, err, found) = solved("friction: coulomb", "coulomb_estimate: true\n");
    assert_eq!(found.matches("confirmed").count(), 3, "{found}");
    assert_eq!([&estimated["lower"], &estimated["upper"]], [&coulomb["lower"], &coulomb["upper"]]);
    let estimate = number(&estimated["coulomb_estimate"]);
    assert!(smooth * (1.0 - 1e-3) <= estimate && estimate <= upper * (1.0 + 1e-3), "{estimated}");
    let run = &estimated["fixed_point"];
    assert!(number(&run["solves"]) <= 10.0 && number(&run["missing"]) < 0.02, "{run}");
    assert!(err.contains("Coulomb's law by a fixed point"), "{err}");
    assert!(
        report.contains("Fixed point for Coulomb friction: ")
            && report.contains("an estimate, not a bound"),
        "{report}"
    );
}

/// A block that only friction holds. Without load it is free to slide, so it is held at a point.
/// Without friction it cannot carry the load that pushes it.
#[test]
fn what_friction_alone_holds() {
    let solved = |traction: &str, code: i32| {
        let model = STACK
            .replace("  - {face: X0, fix: [x]}\n  - {face: Y0, fix: [y]}\n", "")
            .replace("[0, 0, -100]", traction)
            .replace("associated", "coulomb");
        let bench = Bench::new().file("stack.yaml", model).file("m.msh", mesh(60.0));
        let (_, err) = expect(&bench, &["analyse", "stack.yaml"], code);
        expect(&bench, &["verify", "stack"], 0);
        (result(&bench, "stack")["cases"][0].clone(), err)
    };
    let (pressed, _) = solved("[0, 0, -100]", 0);
    // the free block yields at f_y, and no bound exceeds this by more than the error of the mesh
    let [lower, upper] = ["lower", "upper"].map(|k| number(&pressed[k]));
    assert!(
        lower > 0.999 * EXACT && lower <= EXACT && (EXACT..1.05 * EXACT).contains(&upper),
        "{pressed}"
    );
    let (pushed, err) = solved("[2, 0, -100]", 3);
    assert!(
        err.contains("friction alone holds the structure")
            && err.contains("part BLOCK can move along x"),
        "{err}"
    );
    assert!(
        pushed.get("lower").is_none() && number(&pushed["associated"]["lower"]) > 1.0,
        "{pushed}"
    );
}

#[test]
fn what_limit_analysis_cannot_take_is_refused_with_place_and_cure() {
    let body = "  - {body: B, force: [0.1, 0, 0]}\n";
    let rows = [
        (
            BAR.replace(", fy: 235", ""),
            "model/never-yields",
            3,
            "no body has a yield strength",
            "an `fy`",
        ),
        (
            format!("{BAR}{body}"),
            "model/live-body-force",
            11,
            "a force in the body `B`",
            "under `dead`",
        ),
        (
            BAR.replace("loads:", "dead:"),
            "model/no-live-load",
            1,
            "no load carries the load factor",
            "under `loads`",
        ),
        (
            format!("{}dead:\n{body}", BAR.replace("[100, 0, 0]", "[0, 0, 0]")),
            "model/no-live-load",
            9,
            "no load carries the load factor",
            "under `loads`",
        ),
        (
            BAR.replace("fy: 235", "fy: -235"),
            "model/value",
            3,
            "`fy` of material `steel` is -235",
            "never",
        ),
        (
            BAR.replace("  - {face: X0, fix: [x]}\n", ""),
            "model/loose-part",
            0,
            "can move along x",
            "support",
        ),
    ];
    let results = rows.map(|(model, code, line, message, cure)| {
        let place = if line > 0 { format!("bar.yaml:{line}") } else { String::new() };
        let cure = if cure == "never" { "nothing yields" } else { cure };
        let bench = bar(&model);
        let want = Want { exit: 2, code, place: &place, message, cure };
        (message.to_string(), refusal(&bench, &mut bench.command(&["analyse", "bar.yaml"]), &want))
    });
    none_wrong(results.into());
}
