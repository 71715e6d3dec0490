//! A spec with a table in place of a list of loads.

use super::*;
use bracket_base::yaml;
use std::path::PathBuf;

const RFEM: &str = "Member No.;Node No.;Location x [m];LC/CO;N [kN];V-z [kN];M-y [kNm]\n\
                    12;3;0,00;CO1;5,5;20,0;-30,0\n12;4;6,00;CO1;5,5;-22,5;-31,0\n\
                    12;3;0,00;CO2;0,0;0,0;0,0\n12;4;6,00;CO2;0,0;0,0;0,0\n\
                    13;4;0,00;CO1;1,0;2,0;-3,0\n12;3;0,00;SLS1;1,0;2,0;-3,0\n\
                    12;4;6,00;SLS1;1,0;-2,0;-3,0\n";

fn spec(text: &str, loads: &str) -> (tempfile::TempDir, Parsed<ConnectionSpec>) {
    let dir = tempfile::tempdir().expect("a folder");
    std::fs::write(dir.path().join("forces.csv"), text).expect("written");
    let spec = format!("template: beam_splice\nloads: {loads}\n");
    let parsed = yaml::parse::<ConnectionSpec>(&spec, Path::new("joint.yaml"))
        .unwrap_or_else(|e| panic!("{e:?}"));
    (dir, parsed)
}

fn expanded(text: &str, loads: &str) -> Parsed<ConnectionSpec> {
    let (dir, mut spec) = spec(text, loads);
    expand(&mut spec, dir.path(), None).unwrap_or_else(|e| panic!("{loads}: {e:?}"));
    spec
}

fn refused(text: &str, loads: &str) -> Diagnostic {
    let (dir, mut spec) = spec(text, loads);
    expand(&mut spec, dir.path(), None).map(drop).expect_err(loads).into_first()
}

fn told(l: &LoadSpec) -> (&str, Vec<f64>) {
    (&l.name, l.actions().into_iter().map(|(_, v)| v).collect())
}

/// The rows of a section of a member become load cases with their places; at the end of the member
/// the shear force turns.
#[test]
fn rows_of_a_section() {
    let of = "{table: forces.csv, mapping: rfem, member: 12, station: start, cases: [\"CO*\", \
              SLS1], \
              state: {SLS: \"SLS*\"}, end: beam_right, at: node}";
    let start = expanded(RFEM, of);
    let loads = &start.value.loads;
    assert_eq!(told(&loads[0]), ("CO1", vec![5.5e3, -20e3, 30e6]));
    assert_eq!(told(&loads[1]), ("CO2", vec![0.0; 3]));
    assert_eq!((loads.len(), loads[2].state), (3, LimitState::Serviceability));
    assert_eq!(
        (loads[0].end.as_deref(), loads[0].at),
        (Some("beam_right"), Some(ActionPoint::Node))
    );
    let place = start.index.place("loads[1].My");
    assert_eq!((place.line, place.file.map(|f| f.ends_with("forces.csv"))), (Some(4), Some(true)));
    let end = expanded(RFEM, &of.replace("start", "end"));
    assert_eq!(told(&end.value.loads[0]), ("CO1", vec![5.5e3, -22.5e3, 31e6]));
    let at = expanded(RFEM, &of.replace("start", "6.0, flip: true"));
    assert_eq!(told(&at.value.loads[0]), told(&end.value.loads[0]));
    let node = expanded(RFEM, &of.replace("station: start", "node: 4, flip: true"));
    assert_eq!(told(&node.value.loads[0]), told(&end.value.loads[0]));
    // the spec is shown as it was given
    assert!(start.value.loads.as_given().table.is_some());
}

/// Columns of the table say what the spec says elsewhere; equal rows count once.
#[test]
fn ends_points_and_states_of_columns() {
    let text = "case,end,at,state,N [kN]\nA,beam_left,node,SLS,1\nA,beam_right,,SLS,2\n\
                A,beam_right,,SLS,2\n";
    let spec = expanded(text, "{table: forces.csv, at: bolt_plane}");
    let loads = &spec.value.loads;
    assert_eq!(loads.len(), 2);
    assert_eq!((loads[0].at, loads[1].at), (Some(ActionPoint::Node), Some(ActionPoint::BoltPlane)));
    assert_eq!(loads[0].state, LimitState::Serviceability);
}

/// What is stored of a table gives the same loads to the last bit, also numbers that another reader
/// might take for thousands.
#[test]
fn a_stored_table_is_the_same() {
    let text = "case;N [kip];My [kip ft];end;at\nA;0,1;-1e-3;beam_right;node\nB;7;0,123456789;\
                beam_right;node\n";
    let (dir, mut first) = spec(text, "{table: forces.csv, state: {SLS: B}}");
    expand(&mut first, dir.path(), None).unwrap_or_else(|e| panic!("{e:?}"));
    let stored = dir.path().join("loads.csv");
    std::fs::write(&stored, written(&first.value.loads)).expect("written");
    let (_, mut again) = spec("", "{table: forces.csv}");
    expand(&mut again, Path::new("elsewhere"), Some(&stored)).unwrap_or_else(|e| panic!("{e:?}"));
    assert_eq!(*first.value.loads, *again.value.loads);
    std::fs::write(&stored, "case,N [N]\nA,123.456\nB,66000\n").expect("written");
    let (_, mut again) = spec("", "{table: forces.csv}");
    expand(&mut again, Path::new(""), Some(&stored)).unwrap_or_else(|e| panic!("{e:?}"));
    assert_eq!(told(&again.value.loads[0]), ("A", vec![123.456]));
}

#[test]
fn what_is_wrong_with_the_choice_of_rows() {
    let base = "{table: forces.csv, mapping: rfem, end: beam_right, at: node";
    for (rest, why, help, path) in [
        ("", "at which end of the member", "`flip: true`", Some("loads.flip")),
        (", flip: true", "rows of several members", "`12`, `13`", Some("loads.table")),
        (", flip: true, member: 14", "no member `14`", "`12`, `13`", Some("loads.member")),
        (", flip: true, member: 12, node: 9", "no node `9`", "`3`, `4`", Some("loads.node")),
        (
            ", flip: true, member: 12, station: 2.5",
            "`CO1` has no row at the station 2.5",
            "`0,00`",
            Some("loads.station"),
        ),
        (
            ", flip: true, member: 12, cases: LC1",
            "no load case of the table is `LC1`",
            "`*`",
            Some("loads.cases"),
        ),
        (", flip: true, member: 12", "stands in the lines 2 and 3", "`member`, `station`", None),
    ] {
        let d = refused(RFEM, &format!("{base}{rest}}}"));
        assert!(d.message.contains(why), "{rest}: {d:#?}");
        assert!(d.help.as_deref().is_some_and(|h| h.contains(help)), "{rest}: {d:#?}");
        assert_eq!(d.place.path.as_deref(), path, "{rest}: {d:#?}");
        assert!(d.place.line.is_some(), "{rest}: {d:#?}");
    }
    for (rest, why) in [
        (", state: {SLS: \"S*\", ULS: \"*\"}", "`SLS1` is of two limit states"),
        (", state: {SLS: GZG}", "no load case of the table is `GZG`"),
    ] {
        let d = refused(RFEM, &format!("{base}, member: 12, station: end{rest}}}"));
        assert!(d.message.contains(why) && d.help.is_some(), "{rest}: {d:#?}");
    }
    let late = RFEM.replace("12;3;0,00;CO2;", "12;3;0,50;CO2;");
    let d = refused(&late, &format!("{base}, member: 12, station: start}}"));
    assert!(d.message.contains("`CO2` has its start at another station"), "{d:#?}");
    let start_alone: Vec<&str> = RFEM.lines().filter(|l| !l.contains("6,00")).collect();
    let d = refused(&start_alone.join("\n"), &format!("{base}, member: 12, station: end}}"));
    assert!(d.message.contains("no section beyond the start") && d.place.line.is_some(), "{d:#?}");
    let merged = RFEM.replace("12;4;6,00;CO2", ";4;6,00;CO2");
    let d = refused(&merged, &format!("{base}, member: 12, station: start}}"));
    assert!(d.message.contains("the row has no member") && d.place.line == Some(5), "{d:#?}");
    let loads = "{table: forces.csv}";
    for (text, why) in [
        ("case,N [kN],at\nA,1,top\n", "`top` is no point"),
        ("case,N [kN],state\nA,1,uls\n", "`uls` is no limit state"),
        ("case,N [kN]\n,1\n", "no name of a load case"),
        ("N [kN]\n1\n", "no name of a load case"),
        ("case,N [kN]\nA,1\nA,2\n", "the lines 2 and 3 with different actions"),
    ] {
        let d = refused(text, loads);
        assert!(d.message.contains(why) && d.help.is_some(), "{text}: {d:#?}");
        assert!(d.place.line.is_some() && d.place.file.is_some(), "{text}: {d:#?}");
    }
    let (dir, mut none) = spec("", "{table: absent.csv}");
    let d = expand(&mut none, dir.path(), None).map(drop).expect_err("absent").into_first();
    assert!(d.message.contains("`") && d.message.contains("cannot be read"), "{d:#?}");
    let station = "template: a\nloads: {table: a.csv, station: middle}\n";
    let d = yaml::parse::<ConnectionSpec>(station, &PathBuf::from("j.yaml")).map(drop);
    let d = d.expect_err("no station").into_first();
    assert!(d.place.path.as_deref() == Some("loads.station"), "{d:#?}");
}

#[test]
fn patterns_of_names() {
    for (pattern, name, fits) in [
        ("ULS*", "ULS1", true),
        ("ULS*", "XULS1", false),
        ("*SLS", "COSLS", true),
        ("A*B*C", "AxBxC", true),
        ("A*B*C", "AxC", false),
        ("*", "", true),
        ("A", "A", true),
        ("A", "AB", false),
        ("A*A", "A", false),
    ] {
        assert_eq!(matches(pattern, name), fits, "{pattern} {name}");
    }
}
