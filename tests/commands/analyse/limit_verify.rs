//! `analysis: limit`: `verify` confirms a finished result and refutes a changed one.

use super::limit_analysis::{BAR, bar, number, result};
use crate::bench::Bench;
use crate::bench::expect;
use bracket::result::fields::vtu::VtuGrid;
use serde_json::Value;

/// Changes a number of an array of a field file, in place.
pub fn edit_field(bench: &Bench, name: &str, array: &str, factor: f64) {
    let path = bench.path().join("bar/fields").join(name);
    let mut bytes = std::fs::read(&path).expect("field");
    let grid = VtuGrid::from_bytes(&bytes).expect("our own file");
    let (_, _, values) = grid.point_array(array).or(grid.field_array(array)).expect("the array");
    let largest =
        values.iter().copied().max_by(|a, b| a.abs().total_cmp(&b.abs())).expect("values");
    let at = bytes
        .windows(8)
        .position(|w| w == largest.to_le_bytes())
        .expect("the value stands in the file");
    bytes[at..at + 8].copy_from_slice(&(factor * largest).to_le_bytes());
    std::fs::write(&path, bytes).expect("written");
}

fn edit_result(bench: &Bench, edit: impl Fn(&mut Value)) {
    let mut all = result(bench, "bar");
    edit(&mut all["cases"][0]);
    std::fs::write(bench.path().join("bar/result.json"), format!("{all:#}\n")).expect("written");
}

/// A block pushed along its clamped face slips on it. The result and the report tell the share, and
/// `verify` recomputes it.
#[test]
fn slip_on_a_support() {
    let yaml = BAR
        .replace("{face: Z0, fix: [z]}", "{face: Z0, fix: [x, y, z]}")
        .replace("  - {face: X0, fix: [x]}\n  - {face: Y0, fix: [y]}\n", "")
        .replace("{face: X1, traction", "{face: Z1, traction");
    let bench = bar(&yaml);
    expect(&bench, &["analyse", "bar.yaml", "-q"], 0);
    let whole = result(&bench, "bar");
    let case = &whole["cases"][0];
    let slip = &case["support_slip"][0];
    assert_eq!(slip["support"], "Z0");
    let share = number(&slip["share"]);
    assert!(share > 0.01 && share <= 1.0, "{case}");
    // shares of bodies and supports make the whole
    assert!((share + number(&case["dissipation"][0]["share"]) - 1.0).abs() < 1e-12, "{case}");
    // slip on the whole face, k over 100 MPa, bounds the load from above
    assert!(number(&case["upper"]) <= 2.35 / 3.0f64.sqrt() * 1.0001, "{case}");
    assert!(bench.read("bar/report.md").contains("slip on support Z0"));
    expect(&bench, &["verify", "bar"], 0);
    edit_result(&bench, |c| c["support_slip"][0]["share"] = (0.9 * share).into());
    let (code, text) = {
        let run = bench.sealed("bar").run(&["verify", "bar"]);
        (run.status.code(), String::from_utf8_lossy(&run.stdout).into_owned())
    };
    assert_eq!(code, Some(1), "{text}");
    assert!(text.contains("support_slip is not what the fields give"), "{text}");
}

#[test]
fn verify_confirms_what_is_true_and_refutes_the_rest() {
    let solved = bar(BAR);
    expect(&solved, &["analyse", "bar.yaml", "-q"], 0);
    let after = |tamper: &dyn Fn(&Bench)| solved.verify_after("bar", tamper);
    let (code, text) = after(&|_| {});
    assert_eq!((code, text.matches("confirmed").count()), (Some(0), 2), "{text}");
    for (bound, factor) in
        [("lower", 1.000_001), ("lower", 0.999_999), ("upper", 0.999_999), ("upper", 2.0)]
    {
        let (code, text) =
            after(&|b| edit_result(b, |c| c[bound] = (factor * number(&c[bound])).into()));
        assert_eq!(code, Some(1), "{bound} × {factor}: {text}");
        assert!(text.contains("REFUTED"), "{text}");
    }
    // claim and file changed alike: the stresses are not in equilibrium with that factor
    let (code, text) = after(&|b| {
        edit_field(b, "bar_static.vtu", "load_factor", 1.01);
        edit_result(b, |c| c["lower"] = (1.01 * number(&c["lower"])).into());
    });
    assert_eq!(code, Some(1), "{text}");
    for (file, array) in [("bar_static.vtu", "stress_mandel"), ("bar_kinematic.vtu", "velocity")] {
        let (code, text) = after(&|b| edit_field(b, file, array, 1.0001));
        assert_eq!(code, Some(1), "{file}: {text}");
    }
    let shares: [&dyn Fn(&mut Value); 3] = [
        &|c| c["dissipation"][0]["share"] = 0.5.into(),
        &|c| c["limiting_part"] = "A".into(),
        &|c| c["gap"] = 0.5.into(),
    ];
    for edit in shares {
        let (code, text) = after(&|b| edit_result(b, edit));
        assert_eq!(code, Some(1), "{text}");
        assert!(text.contains("is not what the fields give"), "{text}");
    }
    // a weaker steel: the stresses leave its yield surface, and the mechanism dissipates less
    let (code, text) = after(&|b| {
        let model = b.read("bar/model.yaml");
        assert!(model.contains("235"), "{model}");
        std::fs::write(b.path().join("bar/model.yaml"), model.replace("235", "230"))
            .expect("written");
    });
    assert_eq!((code, text.matches("REFUTED").count() >= 2), (Some(1), true), "{text}");
}
