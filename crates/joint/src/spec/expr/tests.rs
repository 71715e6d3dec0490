//! Expressions: values, errors and hostile input.

use super::*;
use bracket_base::units::Quantity;

fn eval(text: &str) -> Result<Value, ExprError> {
    Expr::parse(text)?.eval(&mut |name| match name {
        "plate.thickness" => Ok(Value::length(15.0)),
        "F" => Ok(Value::Quantity(Quantity { value: 8e3, dim: Dim::FORCE })),
        "n" => Ok(Value::number(3.0)),
        other => Err(format!("unknown name `{other}`")),
    })
}

#[test]
fn values() {
    let cases: &[(&str, &str)] = &[
        ("1 + 2 * 3", "7"),
        ("2 ^ 3 ^ 2", "512"),
        ("-2 ^ 2", "-4"),
        ("10 - 3 - 2", "5"),
        ("−2 − −3 mm / 1 mm", "1"),
        ("8 / 2 / 2", "2"),
        ("(1 + 2) * 3", "9"),
        ("plate.thickness + 1 cm", "25 mm"),
        ("2 * plate.thickness", "30 mm"),
        ("plate.thickness ^ 2", "225 area [mm2]"),
        ("sqrt(plate.thickness ^ 2)", "15 mm"),
        ("F / plate.thickness ^ 2 - 5 N/mm2", "30.555555556 MPa"),
        ("120 kN m", "120000000 N mm"),
        ("5 mm * 10", "50 mm"),
        ("2 kN * n / 3 kN", "2"),
        ("min(3, 1, 2) + max(1, 2)", "3"),
        ("round_up(101 mm, 5 mm)", "105 mm"),
        ("round_up(0.1 mm + 0.2 mm, 0.1 mm)", "0.3 mm"),
        ("ceil(2.1)", "3"),
        ("stock(14.6 mm)", "15 mm"),
        ("stock(8 mm)", "8 mm"),
        ("stock(1.2 * 10 mm)", "12 mm"),
        ("stock(1 mm)", "4 mm"),
        ("stock(40.1 mm)", "50 mm"),
        ("stock(201 mm)", "250 mm"),
        ("0.1 mm + 0.2 mm <= 0.3 mm", "true"),
        ("0.3 mm >= 0.1 mm + 0.2 mm", "true"),
        ("0.1 mm + 0.2 mm > 0.3 mm", "false"),
        ("0.1 mm + 0.2 mm == 0.3 mm", "true"),
        ("0.300001 mm > 0.3 mm", "true"),
        ("abs(-3 mm)", "3 mm"),
        ("6 deg", "6 deg"),
        ("2 * 0.5 rad + 0 deg", "57.295779513 deg"),
        ("sin(30 deg)", "0.5"),
        ("10 mm / cos(60 deg)", "20 mm"),
        ("tan(-45 deg)", "-1"),
        ("atan(3 mm / 3 mm)", "45 deg"),
        ("if(n > 2, 1 mm, 2 mm)", "1 mm"),
        ("n >= 3 and not (n == 4) or false", "true"),
        ("false and 1 / 0 > 1", "false"),
        ("1e3", "1000"),
        ("-0 * 1", "0"),
    ];
    for (text, want) in cases {
        let got = eval(text).unwrap_or_else(|e| panic!("{text}: {e}"));
        assert_eq!(&got.to_string(), want, "{text}");
    }
}

#[test]
fn faults_point_at_their_operand() {
    let cases: &[(&str, &str, &str)] = &[
        ("plate.thickness + F", "F", "units do not match"),
        ("plate.thickness + 5", "5", "units do not match"),
        ("1 / 0", "1 / 0", "not finite"),
        ("sqrt(-1)", "sqrt(-1)", "not finite"),
        ("10 ^ 400", "10 ^ 400", "not finite"),
        ("1 + ", "end", "ends too early"),
        ("1 + )", ")", "expected"),
        ("2 3", "3", "unexpected text"),
        ("plate.t", "plate.t", "unknown name"),
        ("mni(1, 2)", "mni(1, 2)", "did you mean `min`?"),
        ("abs(1, 2)", "abs(1, 2)", "takes 1 argument"),
        ("1 mm ^ 0.5", "0.5", "whole exponent"),
        ("not 3", "3", "true or false"),
        ("stock(12)", "12", "takes a thickness"),
        ("sin(30)", "30", "takes an angle"),
        ("cos(1 mm)", "1 mm", "takes an angle"),
        ("atan(1 deg)", "1 deg", "without unit"),
        ("6 deg + 1 mm", "1 mm", "units do not match"),
        ("1 + (2 > 1)", "(2 > 1)", "a number is wanted"),
        ("a $ b", "$", "character"),
        ("1 mm + (1 mm ^ 16) ^ 8", "(1 mm ^ 16) ^ 8", "exponent"),
    ];
    for (text, at, words) in cases {
        let e = eval(text).expect_err(text);
        assert_eq!(e.excerpt(), *at, "{text}: {e}");
        assert!(e.to_string().contains(words), "{text}: `{e}` lacks `{words}`");
    }
}

#[test]
fn deep_nesting_is_refused() {
    let text = format!("{}1{}", "(".repeat(450), ")".repeat(450));
    assert!(Expr::parse(&text).expect_err("too deep").to_string().contains("deeply"));
    let text = format!("{}1", "-".repeat(900));
    assert!(Expr::parse(&text).expect_err("too deep").to_string().contains("deeply"));
    // a tree as deep as its terms are many
    let text = vec!["0 mm"; 12_000].join(" + ");
    let message = Expr::parse(&text).expect_err("too long").to_string();
    assert!(message.contains("at most 1000"), "{}", &message[..80]);
}

#[test]
fn bare_numbers_are_lengths_only_as_plain_yaml_numbers() {
    let mut none = |_: &str| Err("none".to_owned());
    assert_eq!(Expr::number(5.0).eval_as(Dim::LENGTH, &mut none), Ok(5.0));
    assert!(Expr::parse("2 + 3").expect("parses").eval_as(Dim::LENGTH, &mut none).is_err());
    assert!(Expr::parse("2 kN").expect("parses").eval_as(Dim::LENGTH, &mut none).is_err());
}

proptest::proptest! {
    #[test]
    fn never_panics(text in "[-+*/^()<>=!.,a-z0-9 µ]{0,40}") {
        let value = Expr::parse(&text).and_then(|e| e.eval(&mut |_| Ok(Value::length(1.0))));
        if let Ok(Value::Quantity(q)) = value {
            proptest::prop_assert!(q.value.is_finite());
        }
    }
}
