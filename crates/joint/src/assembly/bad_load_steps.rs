//! Tests of wrong load steps: each gives one fault with its line.

use super::tests::{joint, with};

/// Wrong load steps, the code, the place and a part of the message.
const STEPS: &[(&str, &str, &str, &str)] = &[
    ("[0.5, 0.25]", "spec/value", "analysis.load_steps[1]", "0.25 is not above 0.5"),
    ("[0.5, 0.5]", "spec/value", "analysis.load_steps[1]", "0.5 is not above 0.5"),
    ("[0, 1]", "spec/value", "analysis.load_steps[0]", "0 is not above 0 and up to 10"),
    ("[-0.5, 1]", "spec/value", "analysis.load_steps[0]", "-0.5 is not above 0"),
    ("[1, 11]", "spec/value", "analysis.load_steps[1]", "11 is not above 0 and up to 10"),
    ("[.nan]", "yaml/not-finite", "analysis.load_steps[0]", "finite"),
    ("[1, .inf]", "yaml/not-finite", "analysis.load_steps[1]", "finite"),
    ("0.5", "yaml/type", "analysis.load_steps", "a list"),
    ("[0.5, half]", "yaml/type", "analysis.load_steps[1]", "half"),
    ("[50 %, 1]", "yaml/type", "analysis.load_steps[0]", "50 %"),
    ("{first: 0.5}", "yaml/type", "analysis.load_steps", "a list"),
];

/// Each wrong list of load steps is one fault, at the step.
#[test]
fn wrong_load_steps_are_one_fault_each() {
    let wrong = |steps: &str, kind: &str, code: &str, path: &str, word: &str| {
        let new = format!("kind: {kind}, load_steps: {steps}");
        let faults = joint(&with("kind: elastic", &new)).map(drop).expect_err(steps);
        assert_eq!((faults.iter().count(), faults.exit_code()), (1, 2), "{steps}: {faults:?}");
        let d = faults.into_first();
        let text = format!("{} {}", d.message, d.help.clone().unwrap_or_default());
        println!("{steps}: {} {:?} {text}", d.code, d.place);
        let place = (d.code, d.place.path.as_deref(), d.place.line.is_some());
        assert_eq!(place, (code, Some(path), true), "{steps}: {text}");
        assert!(text.contains(word), "{steps}: {text}");
    };
    for (steps, code, path, word) in STEPS {
        wrong(steps, "elastoplastic", code, path, word);
    }
    let many: Vec<String> = (1..=21).map(|i| format!("{}", 0.1 * f64::from(i))).collect();
    let many = format!("[{}]", many.join(", "));
    wrong(&many, "elastoplastic", "spec/value", "analysis.load_steps", "21 load steps");
    wrong("[0.5, 1]", "elastic", "spec/value", "analysis.load_steps", "without elastoplastic");
}
