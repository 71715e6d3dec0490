//! The drawings of plates as an independent reader, ezdxf, finds them.

use crate::bench::Bench;
use crate::bench::expect;
use std::path::{Path, PathBuf};
use std::process::Command;

fn python() -> PathBuf {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    std::env::var_os("BRACKET_TEST_PYTHON")
        .map_or_else(|| root.join(".venv/bin/python"), PathBuf::from)
}

/// What ezdxf finds in a drawing, an entity a line.
fn read(file: &Path) -> String {
    let script = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/support/read_dxf.py");
    let run = Command::new(python()).arg(script).arg(file).output();
    let run = run.expect("a Python with ezdxf: scripts/setup.sh --test makes `.venv` with it");
    let found = String::from_utf8_lossy(&run.stdout).into_owned();
    assert!(run.status.success(), "{}", String::from_utf8_lossy(&run.stderr));
    let mut lines = found.lines();
    assert_eq!((lines.next(), lines.next()), (Some("AC1009"), Some("errors 0")), "{found}");
    found
}

/// Outline and holes are where the spec puts them; the words are ASCII.
#[test]
fn ezdxf_reads_plate_and_holes() {
    let spec = "template: beam_to_column_end_plate\nmembers: {column: {profile: HEB140, steel: \
                S235}, beam: {profile: IPE270, steel: S235}}\nplate: {thickness: 15, width: 135, \
                z: [-150, 212.5]}\nbolts: {size: M16, grade: \"8.8\", gauge: 76, rows: [-85, 85, \
                170]}\nloads: [{name: ULS1, end: beam_right, at: column_face, My: 20 kN m}]\n";
    let bench = Bench::new().file("joint.yaml", spec);
    expect(&bench, &["check", "joint.yaml", "--out", "r"], 0);
    let file = bench.path().join("r/end_plate.dxf");
    let found = read(&file);
    for (y, z) in [(-38, -85), (38, -85), (-38, 85), (38, 85), (-38, 170), (38, 170)] {
        assert!(found.contains(&format!("CIRCLE HOLES {y}.000000 {z}.000000 9.000000")), "{found}");
    }
    let count = |word: &str| found.lines().filter(|l| l.starts_with(word)).count();
    assert_eq!([count("CIRCLE"), count("LINE PLATE"), count("LINE CENTRES")], [6, 4, 12]);
    for edge in ["-67.500000 -150.000000 67.500000 -150.000000", "67.500000 212.500000 -67.500000"]
    {
        assert!(found.contains(edge), "{edge}: {found}");
    }
    assert!(found.contains("end plate 15 x 135 x 362.5 S235, 1 off"), "{found}");
    let bytes = std::fs::read(file).expect("read");
    assert!(bytes.is_ascii());
}

/// The note is in the language of the spec, and in ASCII.
#[test]
fn the_note_of_a_german_plate_is_german() {
    let spec = "project: {language: de}\ntemplate: beam_splice\nmembers: {beam: {profile: IPE270, \
                steel: S235}}\nplate: {thickness: 15, width: 135, z: [-150, 150]}\nbolts: {size: \
                M16, grade: \"8.8\", gauge: 76, rows: [-85, 85]}\nloads: [{name: ULS1, end: \
                beam_right, at: bolt_plane, My: 5 kN m}]\n";
    let bench = Bench::new().file("joint.yaml", spec);
    expect(&bench, &["check", "joint.yaml", "--out", "r"], 0);
    let dxf = bench.read("r/end_plate.dxf");
    assert!(dxf.is_ascii());
    for note in [
        "Stirnplatte 15 x 135 x 300 S235, 2 Stueck",
        "4 Loecher 18 mm fuer Schrauben M16",
        "alle Abmessungen in mm, Ursprung in der Traegerachse",
    ] {
        assert!(dxf.contains(&format!("\r\n{note}\r\n")), "{note}: {dxf}");
    }
    // report.md shows the drawings with German texts
    let (report, english) = (bench.read("r/report.md"), bench.read("r/drawing.svg"));
    assert!(report.contains("](drawing.de.svg)"), "{report}");
    let german = bench.read("r/drawing.de.svg");
    assert!(german.contains("Stirnplatte") && english.contains("end plate"), "{german}");
}

/// The covers of a splice: two flange covers are one drawing, with holes on both sides of the gap;
/// the two web covers another one.
#[test]
fn every_bolted_plate_has_its_drawing() {
    let spec = "template: cover_plate_splice\nmembers: {beam: {profile: IPE330, steel: \
                S235}}\nplate: {thickness: 12, width: 160}\nbolts: {size: M20, grade: \"8.8\", \
                gauge: 90}\nparameters: {flange_columns: [50, 120], flange_cover: 170, web_rows: \
                [-90, 0, 90], web_column: 60, web_thickness: 8, web_height: 260, web_cover: \
                100}\nloads: [{name: A, end: beam_right, at: bolt_plane, Vz: 10 kN}]\n";
    let bench = Bench::new().file("joint.yaml", spec);
    expect(&bench, &["check", "joint.yaml", "--out", "r"], 0);
    let drawing = |name: &str, note: &str, holes: &[(f64, f64)]| {
        let found = read(&bench.path().join(format!("r/{name}")));
        for (x, y) in holes {
            assert!(found.contains(&format!("CIRCLE HOLES {x:.6} {y:.6} 11.000000")), "{found}");
        }
        let circles = found.lines().filter(|l| l.starts_with("CIRCLE")).count();
        assert_eq!(circles, holes.len(), "{found}");
        assert!(found.contains(note), "{note}: {found}");
    };
    let along = [50.0, 120.0, 220.0, 290.0];
    let flange: Vec<(f64, f64)> = along.iter().flat_map(|x| [(*x, 35.0), (*x, 125.0)]).collect();
    drawing("flange_cover.dxf", "flange cover 12 x 340 x 160 S235, 2 off", &flange);
    let rows = [40.0, 130.0, 220.0];
    let web: Vec<(f64, f64)> = rows.iter().flat_map(|z| [(40.0, *z), (160.0, *z)]).collect();
    drawing("web_cover.dxf", "web cover 8 x 200 x 260 S235, 2 off", &web);
    let others = std::fs::read_dir(bench.path().join("r")).expect("a folder");
    let dxf = |e: &std::fs::DirEntry| e.path().extension().is_some_and(|x| x == "dxf");
    assert_eq!(others.filter_map(Result::ok).filter(dxf).count(), 2);
}
