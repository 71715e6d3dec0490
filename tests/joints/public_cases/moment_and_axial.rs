//! Moment and axial force of the joint together, so that a hand can follow them.

use super::answer::Answer;
use serde_json::Value;

const CASE: &str = "39-mn_col_-30_-200.yaml";
const TITLE: &str = "moment and axial force of the joint";

/// Number behind a symbol of a check.
fn step(check: &Value, symbol: &str) -> f64 {
    let steps = check["values"].as_array().expect("values");
    let found = steps.iter().find(|s| s["symbol"] == symbol);
    found.unwrap_or_else(|| panic!("{symbol}: {check}"))["value"].as_f64().expect("a number")
}

/// Forces with their distance from the axis, from the symbols `F of the … at z = … mm`.
fn forces(check: &Value) -> Vec<(f64, f64)> {
    let steps = check["values"].as_array().expect("values");
    let of = |s: &Value| {
        let symbol = s["symbol"].as_str()?;
        let z = symbol.strip_prefix("F of the ")?.split("z = ").nth(1)?.strip_suffix(" mm")?;
        Some((z.parse().expect("a number"), s["value"].as_f64()?))
    };
    steps.iter().filter_map(of).collect()
}

/// The printed forces balance α times the actions, and both utilisations stand side by side.
#[test]
fn the_equilibrium_is_printed_with_its_forces() {
    let text = Answer::input(CASE);
    // IPE300, S235: M_j,Rd and N_j,Rd as printed; 5 % of N_pl,Rd are 63 kN
    for (my, axial) in [(-30.0_f64, -200.0_f64), (-30.0, 150.0), (45.0, -100.0), (20.0, 90.0)] {
        let text = text
            .replace("-30 kN m", &format!("{my} kN m"))
            .replace("\"N\": \"-200 kN\"", &format!("\"N\": \"{axial} kN\""));
        let answer = Answer::to(&text);
        let checks = answer.titled(TITLE);
        let check = checks.iter().find(|c| c["case"] == "U").expect("the check");
        let alpha = step(check, "α");
        let (sum, turned) = forces(check)
            .into_iter()
            .fold((0.0, 0.0), |(sum, turned), (z, f)| (sum + f, turned + z * f));
        // z is printed with four digits
        assert!((sum / (alpha * axial * 1e3) - 1.0).abs() < 1e-6, "{check}");
        assert!((turned / (alpha * my * 1e6) - 1.0).abs() < 1e-3, "{check}");
        let used = check["utilisation"].as_f64().expect("a number");
        let moment = step(check, "M_j,Rd");
        let bending = my.abs() * 1e6 / moment;
        assert!((used - bending.max(1.0 / alpha)).abs() < 1e-9, "{check}");
        let side = if axial > 0.0 { "N_j,Rd in tension" } else { "N_j,Rd in compression" };
        let linear = bending + axial.abs() * 1e3 / step(check, side);
        assert!((step(check, "linear sum (6.24)") - linear).abs() < 1e-9, "{check}");
        assert!(used <= linear + 1e-9, "the sum is on the safe side: {check}");
        let formula = check["formula"].as_str().expect("a formula");
        for words in ["Σ F =", "Σ F z =", "linear sum (6.24)", "does not bind", "2.5(1)"] {
            assert!(formula.contains(words), "{words}: {formula}");
        }
        if (my, axial) == (-30.0, -200.0) {
            assert!((used - 0.588).abs() < 5e-4 && (linear - 1.09).abs() < 5e-3, "{used} {linear}");
        }
    }
}
