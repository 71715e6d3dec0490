//! Numbers with units: accepted input, refused input, output.

use super::*;

#[test]
fn reads_what_engineers_write() {
    let cases: &[(&str, Kind, f64)] = &[
        ("15", Kind::Length, 15.0),
        ("15 mm", Kind::Length, 15.0),
        ("1.5cm", Kind::Length, 15.0),
        ("-0.25 m", Kind::Length, -250.0),
        ("1e1 mm", Kind::Length, 10.0),
        ("80 kN", Kind::Force, 80e3),
        ("120 kN m", Kind::Moment, 120e6),
        ("120 kNm", Kind::Moment, 120e6),
        ("120 kN·m", Kind::Moment, 120e6),
        ("-3 N*mm", Kind::Moment, -3.0),
        ("45 MPa", Kind::Stress, 45.0),
        ("4.5 kN/cm2", Kind::Stress, 45.0),
        ("45 N/mm²", Kind::Stress, 45.0),
        ("0.75 in", Kind::Length, 19.05),
        ("3/4 in", Kind::Length, 19.05),
        ("1 1/4 in", Kind::Length, 31.75),
        ("1-1/4\"", Kind::Length, 31.75),
        ("-1 1/2 in", Kind::Length, -38.1),
        ("- 3/8in", Kind::Length, -9.525),
        ("-8\"", Kind::Length, -203.2),
        ("20 ft", Kind::Length, 6096.0),
        // the minus sign of typesetting, as a report prints it
        ("−250", Kind::Length, -250.0),
        ("−43.2 kN m", Kind::Moment, -43.2e6),
        ("−1 1/2 in", Kind::Length, -38.1),
        ("25 kip", Kind::Force, 111_205.540_381_512_5),
        ("100 kip ft", Kind::Moment, 135_581_794.833_140_04),
        ("12 kip in", Kind::Moment, 1_355_817.948_331_400_4),
        ("50 ksi", Kind::Stress, 344.737_864_658_418),
    ];
    for (text, kind, want) in cases {
        let got = parse(text, *kind).unwrap_or_else(|e| panic!("{text}: {e}"));
        assert!((got - want).abs() <= 1e-12 * want.abs(), "{text}: {got} instead of {want}");
    }
}

#[test]
fn refuses_wrong_and_missing_units_by_name() {
    let cases: &[(&str, Kind, &[&str])] = &[
        ("45", Kind::Stress, &["stress 45 needs a unit", "45 MPa"]),
        ("120", Kind::Moment, &["moment 120 needs a unit", "write `120 kN m`"]),
        ("15 kN", Kind::Length, &["length", "`kN` is not one of its units", "mm, cm, m"]),
        ("15 furlong", Kind::Length, &["`furlong`"]),
        ("45 Mpa", Kind::Stress, &["`Mpa`", "MPa"]),
        ("thick", Kind::Length, &["`thick` is not a length"]),
        ("20,5 mm", Kind::Length, &["a point before its decimals", "; write `20.5 mm`"]),
        ("-20,5", Kind::Length, &["; write `-20.5`"]),
        ("1e999 mm", Kind::Length, &["finite"]),
        ("", Kind::Force, &["not a force"]),
        ("3/4", Kind::Length, &["a fraction is of inches", "`3/4 in`"]),
        ("3/4 mm", Kind::Length, &["a fraction is of inches", "write decimals"]),
        ("1 1/4", Kind::Length, &["a fraction is of inches"]),
        ("3/0 in", Kind::Length, &["`/0 in` is not one of its units"]),
        ("3/ in", Kind::Length, &["`/ in` is not one of its units"]),
        ("1/2/3 in", Kind::Length, &["a fraction is of inches"]),
        ("1.5 1/4 in", Kind::Length, &["`1/4 in` is not one of its units"]),
        ("5' 3\"", Kind::Length, &["is not one of its units"]),
        ("6 inch", Kind::Length, &["`inch`", "in, ft"]),
        ("6 IN", Kind::Length, &["`IN`", "in, ft"]),
        ("3/4 kip", Kind::Force, &["`/4 kip` is not one of its units"]),
        ("5 in", Kind::Force, &["`in` is not one of its units"]),
        ("5 kip", Kind::Moment, &["`kip` is not one of its units", "kip ft"]),
    ];
    for (text, kind, words) in cases {
        let message = parse(text, *kind).expect_err(text).to_string();
        for word in *words {
            assert!(message.contains(word), "`{text}`: `{message}` lacks `{word}`");
        }
    }
}

#[test]
fn inches_become_the_millimetres_that_people_print() {
    for (text, mm) in [
        ("0.75 in", "19.05"),
        ("1.1 in", "27.94"),
        ("13/16 in", "20.6375"),
        ("1/64 in", "0.396875"),
    ] {
        assert_eq!(parse(text, Kind::Length).map(|x| x.to_string()).as_deref(), Ok(mm), "{text}");
    }
}

#[test]
fn a_comma_is_told_to_be_a_point_only_where_it_must_be() {
    for (text, told) in
        [("0,3", Some("0.3")), ("+1,25 kN", Some("+1.25 kN")), ("1,5cm", Some("1.5cm"))]
    {
        assert_eq!(with_point(text).as_deref(), told, "{text}");
    }
    // the comma may separate thousands, there are two commas, or the text is not a number
    for text in ["1,200 mm", "1,2,3", "1,2.5", ",5", "1,", "a,5", "12 mm", ""] {
        assert_eq!(with_point(text), None, "{text}");
    }
    let message = parse("1,200 mm", Kind::Length).expect_err("thousands").to_string();
    assert!(
        message.contains("nothing between its thousands") && !message.contains("write"),
        "{message}"
    );
}

#[test]
fn times_need_a_unit() {
    assert_eq!(Seconds::parse("20 min"), Ok(Seconds(1200.0)));
    assert!(Seconds::parse("20").is_err());
    assert!(Seconds::parse("-1 s").is_err());
}

/// A value that the report shows for the input reads back as the same number.
#[test]
fn forces_and_moments_are_written_in_the_unit_people_use() {
    fn text(value: impl serde::Serialize) -> String {
        serde_json::to_value(value)
            .ok()
            .and_then(|v| v.as_str().map(str::to_owned))
            .expect("a text")
    }
    for (newton, written) in
        [(80e3, "80 kN"), (-150.0, "-0.15 kN"), (99.0, "99 N"), (0.0, "0 N"), (98_700.0, "98.7 kN")]
    {
        let shown = text(Force(newton));
        assert_eq!((shown.as_str(), parse(&shown, Kind::Force)), (written, Ok(newton)));
    }
    for moment in [120e6, 1.0, 0.1e6, 123_456_789.123, -7.3e9, 1e6 / 3.0] {
        let shown = text(Moment(moment));
        assert_eq!(parse(&shown, Kind::Moment), Ok(moment), "{shown}");
    }
    assert_eq!(text(Moment(120e6)), "120 kN m");
}
