//! `bracket catalog` as users and scripts call it.

use std::process::{Command, Output};

fn bracket(args: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_bracket"))
        .arg("catalog")
        .args(args)
        .output()
        .expect("bracket starts")
}

fn stdout(args: &[&str]) -> String {
    let out = bracket(args);
    assert_eq!(out.status.code(), Some(0), "{args:?}: {}", String::from_utf8_lossy(&out.stderr));
    assert!(out.stderr.is_empty(), "{args:?}");
    String::from_utf8(out.stdout).expect("UTF-8")
}

fn refused(args: &[&str]) -> String {
    let out = bracket(args);
    assert_eq!(out.status.code(), Some(2), "{args:?}");
    assert!(out.stdout.is_empty(), "{args:?}: data on an error");
    String::from_utf8(out.stderr).expect("UTF-8")
}

#[test]
fn kinds_have_rows() {
    let text = stdout(&[]);
    for (kind, rows) in [
        ("profiles", 583),
        ("sections", 538),
        ("bolts", 32),
        ("bolt-grades", 9),
        ("steels", 28),
        ("friction", 4),
        ("factors", 8),
        ("annexes", 15),
    ] {
        let line = text.lines().find(|l| l.split_whitespace().next() == Some(kind)).expect(kind);
        assert_eq!(line.split_whitespace().nth(1), Some(rows.to_string().as_str()));
        assert_eq!(stdout(&["list", kind]).lines().count(), rows + 1);
        let json: serde_json::Value =
            serde_json::from_str(&stdout(&["list", kind, "--format", "json"])).expect("JSON");
        assert_eq!(json.as_array().map(Vec::len), Some(rows));
    }
}

#[test]
fn a_series_is_listed_alone() {
    let text = stdout(&["list", "profiles", "--series", "he aa"]);
    assert_eq!(text.lines().count(), 25);
    assert!(text.lines().skip(1).all(|l| l.starts_with("HEAA")));
    assert!(refused(&["list", "profiles", "--series", "HEC"]).contains("did you mean `HE"));
    assert!(refused(&["list", "bolts", "--series", "HEB"]).contains("narrows profiles only"));
}

/// Angles, channels and hollow sections show their kind and all dimensions.
#[test]
fn a_section_is_shown_with_its_shape() {
    let text = stdout(&["show", "L100x10"]);
    for part in ["section\n", "shape: angle", "h 100 mm", "t 10 mm", "area: 19.2 cm2"] {
        assert!(text.contains(part), "{part}: {text}");
    }
    let text = stdout(&["show", "CHS168.3x8"]);
    assert!(text.contains("shape: chs, d 168.3 mm, t 8 mm"), "{text}");
    let list = stdout(&["list", "sections"]);
    assert!(list.contains("rectangular hollow section"), "{list}");
    assert!(refused(&["show", "L100x11"]).contains("did you mean `L100x10`"));
}

#[test]
fn a_row_is_shown_with_unit_and_source() {
    for spelling in [&["show", "HE200B"][..], &["show", "HE 200 B"], &["show", "HE", "200", "B"]] {
        let text = stdout(spelling);
        for line in [
            "name: HEB200",
            "h: 200 mm",
            "area: 78.08 cm2",
            "i_y: 5696 cm4",
            "source: catalogs/profiles_i.csv line 49",
        ] {
            assert!(text.lines().any(|l| l.trim() == line), "{line} in\n{text}");
        }
        assert!(text.contains("EN 10365:2017"));
    }
    assert!(stdout(&["show", "M18"]).lines().any(|l| l.trim() == "area: 254.5 mm2"));
    let json: serde_json::Value =
        serde_json::from_str(&stdout(&["show", "S355", "--format", "json"])).expect("JSON");
    assert_eq!(json[0]["row"]["bands"][1]["fy"], 335.0);
    assert!(json[0]["provenance"]["read_from"].is_string());
}

#[test]
fn unknown_and_ambiguous_names_are_refused() {
    assert!(refused(&["show", "HEB205"]).contains("did you mean `HEB200`?"));
    assert!(refused(&["show", "S235H"]).contains("EN 10219-1 S235H"));
}

#[test]
fn a_folder_of_ones_own_is_added() {
    let dir = tempfile::tempdir().expect("temporary folder");
    let path = dir.path().to_str().expect("UTF-8 path");
    assert!(refused(&["list", "friction", "--dir", path]).contains("no .csv file"));
    std::fs::write(
        dir.path().join("own.csv"),
        "class,slip_factor_mu,surface_treatment\nE,0.15,painted\n",
    )
    .expect("write");
    assert!(stdout(&["list", "friction", "--dir", path]).contains("painted"));
    assert!(stdout(&["show", "E", "--dir", path]).contains("mu: 0.15"));
    std::fs::write(
        dir.path().join("own.csv"),
        "class,slip_factor_mu,surface_treatment\nC,0.15,painted\n",
    )
    .expect("write");
    assert!(
        refused(&["list", "friction", "--dir", path])
            .contains("catalogs/friction_classes.csv line 4")
    );
}
