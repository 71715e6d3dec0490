//! What the help of a template's checks suggests is accepted by the checks and by the mesher's
//! clash check: help never leads into the next error.

use bracket::diag::Diagnostics;
use bracket::driver::spec_file;
use bracket::geometry::proximity;

/// Base, placeholder, wrong value, other placeholders with their values, and words of the help.
type Suggested = (&'static str, &'static str, &'static str, Given, &'static str);

/// Placeholders with their values.
type Given = &'static [(&'static str, &'static str)];

const COLUMN: &str = r#"template: beam_to_column_end_plate
members: {column: {profile: HEB200, steel: S235}, beam: {profile: IPE360, steel: S235}}
plate: {thickness: 15, width: WIDTH, z: Z}
bolts: {size: M16, grade: "8.8", gauge: GAUGE, rows: ROWS}
parameters: {EXTRA}
loads: [{name: A, end: beam_right, at: bolt_plane, My: 10 kN m}]
"#;
const SPLICE: &str = r#"template: beam_splice
members: {beam: {profile: IPE330, steel: S235}}
plate: {thickness: 15, width: WIDTH, z: Z}
bolts: {size: M20, grade: "8.8", gauge: GAUGE, rows: ROWS}
loads: [{name: A, end: beam_right, at: bolt_plane, My: 10 kN m}]
"#;
const STUB: &str = r#"template: t_stub
members: {tee: {profile: IPE300, steel: S235}}
bolts: {size: M16, grade: "8.8", gauge: GAUGE, rows: ROWS}
parameters: {length: 200, EXTRA}
loads: [{name: A, end: top, at: bolt_plane, N: 1 kN}]
"#;

/// Sound values of the words in capitals.
const SOUND: [(&str, [(&str, &str); 4]); 3] = [
    (COLUMN, [("WIDTH", "180"), ("Z", "[-250, 200]"), ("GAUGE", "100"), ("ROWS", "[-215, 110]")]),
    (SPLICE, [("WIDTH", "160"), ("Z", "[-185, 185]"), ("GAUGE", "90"), ("ROWS", "[-105, 105]")]),
    (STUB, [("WIDTH", ""), ("Z", ""), ("GAUGE", "90"), ("ROWS", "[-50, 50]")]),
];

/// A spec with its sound values, except those that are given.
fn spec(base: &str, given: &[(&str, &str)]) -> String {
    let (_, sound) = SOUND.iter().find(|s| s.0 == base).expect("a base");
    let all = given.iter().chain(sound).chain([&("EXTRA", "")]);
    all.fold(base.to_owned(), |text, (word, value)| text.replace(word, value))
}

/// The faults of a spec, those of the clash check included.
fn faults(text: &str) -> Result<(), Diagnostics> {
    let folder = tempfile::tempdir().expect("temporary folder");
    let path = folder.path().join("spec.yaml");
    std::fs::write(&path, text).expect("written");
    let file = spec_file::read(&path, None)?;
    proximity::check(&file.joint.assembly, &|| false).expect("it is not stopped")
}

/// The first number in millimetres after these words in the help of the first fault.
fn suggested(text: &str, words: &str) -> f64 {
    let fault = faults(text).expect_err(text).into_first();
    let help = fault.help.clone().unwrap_or_default();
    let (_, rest) = help.split_once(words).unwrap_or_else(|| panic!("{fault} {help}: {words}"));
    let number = rest.trim().split(' ').next().unwrap_or_default();
    number.parse().unwrap_or_else(|_| panic!("{help}"))
}

#[test]
fn values_that_help_suggests_pass_every_later_check() {
    let stiff = "column_stiffeners: true, column_stiffener_thickness: 12.7";
    // base, word, wrong value, other values, words before the number
    let cases: &[Suggested] = &[
        (COLUMN, "GAUGE", "40", &[], "at least"),
        (COLUMN, "GAUGE", "179", &[], "at most"),
        (COLUMN, "GAUGE", "40", &[("EXTRA", "double_sided: true")], "at least"),
        (SPLICE, "GAUGE", "40", &[], "at least"),
        (SPLICE, "GAUGE", "159", &[], "at most"),
        (STUB, "GAUGE", "30", &[], "at least"),
        (STUB, "GAUGE", "149", &[], "at most"),
        (STUB, "GAUGE", "30", &[("EXTRA", "welded: true, web_thickness: 10")], "at least"),
        (
            STUB,
            "web_height: 5",
            "web_height: 5",
            &[("EXTRA", "welded: true, web_height: 5")],
            "least",
        ),
    ];
    for (base, word, wrong, others, words) in cases {
        let of = |value: &str| {
            if word.contains(':') {
                // a parameter among the others
                let key = word.split(':').next().expect("a key");
                let others: Vec<(&str, String)> =
                    others.iter().map(|(k, v)| (*k, v.replace(word, value))).collect();
                let value = others.iter().map(|(k, v)| (*k, v.as_str())).collect::<Vec<_>>();
                assert!(value.iter().any(|v| v.1.contains(key)));
                spec(base, &value)
            } else {
                spec(base, &[&[(*word, value)], *others].concat())
            }
        };
        let number = suggested(&of(wrong), words);
        let value = match word.split_once(':') {
            Some((key, _)) => format!("{key}: {number}"),
            None => number.to_string(),
        };
        let again = of(&value);
        assert_eq!(faults(&again).map_err(|e| e.first().clone()), Ok(()), "{number}: {again}");
    }
    // two rows: the second one moves away from the first, from a flange, from an edge
    for (base, first, wrong, extra, words) in [
        (COLUMN, -110.0, -100.0, "", "at least"),
        (SPLICE, -20.0, -10.0, "", "at least"),
        (STUB, -20.0, -10.0, "", "at least"),
    ] {
        let of = |row: f64| {
            let rows = format!("[{first}, {row}]");
            spec(base, &[("ROWS", rows.as_str()), ("EXTRA", extra)])
        };
        let apart = suggested(&of(wrong), words);
        assert_eq!(faults(&of(first + apart)).map_err(|e| e.first().clone()), Ok(()), "{apart}");
    }
    for (base, other, wrong, extra) in
        [(COLUMN, -110.0, 165.0, ""), (COLUMN, -110.0, 172.0, stiff), (SPLICE, -105.0, 155.0, "")]
    {
        let of = |row: f64| {
            let rows = format!("[{other}, {row}]");
            spec(base, &[("ROWS", rows.as_str()), ("EXTRA", extra)])
        };
        let (away, from) = (suggested(&of(wrong), "at least"), suggested(&of(wrong), "away from"));
        let row = (from - away).floor();
        assert_eq!(faults(&of(row)).map_err(|e| e.first().clone()), Ok(()), "{row}");
    }
    for (base, other) in [(COLUMN, -110.0), (STUB, 0.0)] {
        let of = |row: f64| spec(base, &[("ROWS", format!("[{row}, {other}]").as_str())]);
        let row = suggested(&of(-1000.0), "between");
        assert_eq!(faults(&of(row)).map_err(|e| e.first().clone()), Ok(()), "{row}");
    }
    // the end plate, the outer bolts, the rib
    let tall = "[-180, 230]";
    let rib = ("EXTRA", "rib: true, rib_thickness: 80");
    for (given, word, words) in [
        (vec![("EXTRA", "outer_gauge: 120")], "120", "outer gauge of at least"),
        (vec![("EXTRA", "outer_gauge: 290")], "290", "outer gauge of at most"),
        (vec![("EXTRA", "rib: true"), ("Z", "[-250, 185]")], "185", "plate.z reach to"),
        (
            vec![rib, ("Z", tall), ("ROWS", "[-110, 209]"), ("GAUGE", "100")],
            "100",
            "gauge of at least",
        ),
    ] {
        // a column and a plate with room for four bolts in a row
        let base = |given: &[(&str, &str)]| {
            let given: Vec<(&str, &str)> =
                given.iter().copied().chain([("WIDTH", "300")]).collect();
            spec(COLUMN, &given).replace("HEB200", "HEB300")
        };
        let number = suggested(&base(&given), words).to_string();
        let mended: Vec<(&str, String)> =
            given.iter().map(|(k, v)| (*k, v.replace(word, &number))).collect();
        let mended: Vec<(&str, &str)> = mended.iter().map(|(k, v)| (*k, v.as_str())).collect();
        let again = base(&mended);
        assert_eq!(faults(&again).map_err(|e| e.first().clone()), Ok(()), "{number}: {again}");
    }
}
