//! What a spec says and what it leaves out: defaults, limits, own templates, files that are no
//! spec.

use super::PLAIN;
use super::answer::Answer;
use crate::bench::Bench;
use std::path::Path;

const COLUMN: &str = "template: beam_to_column_end_plate
members: {column: {profile: HEB200, steel: S235}, beam: {profile: IPE300, steel: S235}}
plate: {thickness: 15, width: 160, z: [-165, 230]}
bolts: {size: M20, grade: \"8.8\", gauge: 100, rows: [-90, 90, 190]}
loads: [{name: U, end: beam_right, at: column_face, My: 40 kN m, Vz: -40 kN}]
";

fn has(answer: &Answer, words: &[&str]) {
    for w in words {
        let found = answer.said.contains(w) || answer.report.contains(w);
        assert!(found, "no `{w}` in {}\n{}", answer.said, answer.report);
    }
}

/// `bracket check` of a file with these bytes.
fn check(name: &str, bytes: &[u8]) -> Answer {
    Answer::from(Bench::new().file(name, bytes), &["check", name, "--out", "out"])
}

/// The resistance is that of an independent implementation of the component method.
#[test]
fn no_part_that_nobody_wrote_makes_a_joint_hold() {
    let answer = Answer::of("04-stiffeners-by-default.yaml");
    assert_eq!((answer.code, answer.verdict()), (1, "not_ok"), "{}", answer.said);
    let checks = answer.titled("moment and axial force of the joint");
    let [moment] = checks[..] else { panic!("{checks:?}") };
    let used = moment["utilisation"].as_f64().expect("a number");
    assert!((used * 282.6 / 290.0 - 1.0).abs() < 1e-3, "{used}");
    assert!(!answer.report.contains("| column stiffener |"), "{}", answer.report);
    // written, they are there
    let text = Answer::input("04-stiffeners-by-default.yaml");
    for (more, part) in [
        ("column_stiffeners: true", "| column stiffener | 4 |"),
        ("doubler: true", "| web doubler | 1 |"),
        ("rib: true", "| rib | 1 |"),
    ] {
        has(&Answer::to(&format!("{text}parameters: {{{more}}}\n")), &[part]);
    }
}

/// 14.6 mm of IPE450 and 9 mm of HEB200 are no thicknesses of plates; 15 and 10 are.
#[test]
fn default_thicknesses_are_those_of_plates_in_stock() {
    let text = COLUMN
        .replace("IPE300", "IPE450")
        .replace("width: 160, z: [-165, 230]", "width: 200, z: [-240, 310]")
        .replace("rows: [-90, 90, 190]", "rows: [-150, 150, 270]");
    let answer =
        Answer::to(&format!("{text}parameters: {{column_stiffeners: true, doubler: true}}\n"));
    has(&answer, &["column_stiffener_thickness", "stock(beam.tf)"]);
    let part = |name: &str| {
        let row = answer.report.lines().find(|l| l.starts_with(&format!("| {name} |")));
        row.unwrap_or_else(|| panic!("no {name}: {}", answer.report)).to_owned()
    };
    assert!(
        part("column stiffener").contains("| 15 × 95.5 × 170 |"),
        "{}",
        part("column stiffener")
    );
    assert!(part("column stiffener").contains("| 4 |"));
    assert!(part("web doubler").contains("| 10 × 134 ×"), "{}", part("web doubler"));
}

#[test]
fn an_excerpt_is_the_text_of_the_file_in_its_encoding() {
    let answer = Answer::of("09-utf16-excerpt.yaml");
    assert_eq!(answer.code, 2);
    has(&answer, &["profile: HEB201, steel: S355", "template: beam_splice", "HEB201"]);
    let text = PLAIN.replace("IPE300", "IPE301");
    let units = |bytes: fn(u16) -> [u8; 2], mark: [u8; 2]| -> Vec<u8> {
        mark.into_iter().chain(text.encode_utf16().flat_map(bytes)).collect()
    };
    let little = units(u16::to_le_bytes, [0xff, 0xfe]);
    let big = units(u16::to_be_bytes, [0xfe, 0xff]);
    let marked = [b"\xef\xbb\xbf".to_vec(), text.clone().into_bytes()].concat();
    for bytes in [little, big, marked] {
        let answer = check("joint.yaml", &bytes);
        has(&answer, &["members: {beam: {profile: IPE301, steel: S235}}", "joint.yaml:2:27"]);
        assert!(!answer.said.contains('\u{fffd}') && !answer.said.contains('\0'));
    }
}

#[test]
fn a_file_of_another_program_is_named() {
    let answer = Answer::of("10-foreign-file.xml");
    assert_eq!(answer.code, 2);
    has(&answer, &["this is an XML file, not a spec", "Bracket reads YAML", "`bracket new"]);
    let long =
        format!("<?xml version='1.0'?>\n<OpenModel>{}</OpenModel>", "<P x='1'/>".repeat(5000));
    let xlsx = b"PK\x03\x04\x14\0\x06\0\x08\0\0\0!\0[Content_Types].xmlPK\x03\x04xl/workbook.xml";
    let files: [(&str, &[u8], &str); 10] = [
        ("a.xml", long.as_bytes(), "an XML file"),
        ("a.xlsx", xlsx, "an Excel file"),
        ("a.yaml", xlsx, "an Excel file"),
        ("a.zip", b"PK\x03\x04\0\0spec.yaml", "a ZIP archive"),
        ("a.ifc", b"ISO-10303-21;\nHEADER;\nFILE_SCHEMA(('IFC4'));\n", "an IFC file"),
        ("a.stp", b"ISO-10303-21;\nHEADER;\nFILE_SCHEMA(('AP214'));\n", "a STEP file"),
        ("a.pdf", b"%PDF-1.7\n%\xe2\xe3\xcf\xd3\n", "a PDF file"),
        ("a.json", b"{\"joint\": {\"beam\": \"IPE300\"}}", "a JSON file"),
        ("a.csv", b"name;N;V\nJ1;1,5;2\n", "a table (CSV)"),
        ("a.xls", b"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1\0\0", "a Word or Excel file"),
    ];
    for (name, bytes, what) in files {
        let answer = check(name, bytes);
        assert_eq!(answer.code, 2, "{name}: {}", answer.said);
        has(&answer, &[what, "not a spec", "Bracket reads YAML"]);
        assert!(answer.said.len() < 1000, "{}", answer.said);
    }
    // a spec in JSON is one
    assert_eq!(Answer::of("33-units_width_at_limit_ft.yaml").code, 0);
}

#[test]
fn what_no_check_covers_is_drawn_listed_and_named() {
    let answer = Answer::of("21-own-template-gusset.yaml");
    assert_eq!((answer.code, answer.verdict()), (3, "undecided"), "{}", answer.said);
    has(&answer, &["not checked: GUSSET_R", "| lower gusset | 1 | 12 × 15 × 200 |"]);
    has(&answer, &["| end plate | 1 |", "| bolt | 6 |", "GUSSET_R to BEAM_R"]);
    assert!(answer.said.contains("not checked: GUSSET_R"), "{}", answer.said);
    let drawing = answer.bench.read("out/drawing.svg");
    for words in ["6 bolts M18", ">end plate 15", "beam IPE300", "1 × lower gusset 12 × 15 × 200"]
    {
        assert!(drawing.contains(words), "{words}: {drawing}");
    }
    assert!(!drawing.contains("2 end plates") && !drawing.contains("beams"), "{drawing}");
    // two beams
    let text = Answer::input("21-own-template-gusset.yaml");
    let two = Answer::to(&text.replace("parameters:", "parameters: {double_sided: true}"));
    has(&two, &["not checked: GUSSET_R, GUSSET_L", "| end plate | 2 |", "| bolt | 12 |"]);
    has(&two, &["| lower gusset | 2 |"]);
    assert_eq!(two.verdict(), "undecided");
}

/// A template can say why a part needs no check; what its checks count must be in its geometry.
#[test]
fn a_template_answers_for_its_parts() {
    let gusset = Answer::input("gusset.yaml");
    let spec = Answer::input("21-own-template-gusset.yaml");
    let with = |template: &str, spec: &str| {
        let bench = Bench::new().file("gusset.yaml", template).file("joint.yaml", spec);
        Answer::from(bench, &["check", "joint.yaml", "--out", "out"])
    };
    let aid = gusset.replace("role: plate", "role: plate\n    no_check: \"aid of assembly\"");
    let answer = with(&aid, &spec);
    assert_eq!((answer.code, answer.verdict()), (0, "ok"), "{}", answer.said);
    has(&answer, &["not checked: GUSSET_R", "the template says: aid of assembly"]);
    // a column without the stiffeners that the hand checks count
    let bare = gusset.replace(
        "  - name: COLUMN\n",
        "  - name: COLUMN\n    solids:\n      - profile: {member: column, along: z, depth: x, \
         from: -column_below, to: column_above}\n",
    );
    let stiffened = spec.replace("parameters:", "parameters: {column_stiffeners: true}");
    let answer =
        with(&bare.replace("role: plate", "role: plate\n    no_check: \"aid\""), &stiffened);
    assert_eq!(answer.verdict(), "undecided", "{}", answer.said);
    has(&answer, &["not checked: stiffeners of the column", "counts it"]);
}

/// M18: 40 + 2 · 3 + 15.8 + 2.5 = 64.3 mm, so 65; with 20 mm 74.3, so 80.
#[test]
fn the_grip_is_that_of_all_plates_that_a_bolt_passes() {
    let answer = Answer::of("22-own-template-backing.yaml");
    has(&answer, &["M18 × 65, grip 40 mm", "order M18 × 65", "not checked: BACK_RP, BACK_RM"]);
    has(&answer, &["backing plate | 2 | 10 × 70 ×"]);
    assert_eq!((answer.code, answer.verdict()), (0, "ok"), "{}", answer.said);
    let text = Answer::input("22-own-template-backing.yaml");
    let thick = Answer::to(&text.replace("column_stiffeners: false", "backing_thickness: 20"));
    has(&thick, &["M18 × 80, grip 50 mm"]);
    // the same bolts without backing plates
    let plain = Answer::to(&text.replace("backing.yaml", "beam_to_column_end_plate"));
    has(&plain, &["M18 × 55, grip 30 mm"]);
    // a longer bolt is softer and develops less prying: never more resistance
    let moment = |a: &Answer| {
        let found = a.titled("moment and axial force of the joint");
        found.first().and_then(|c| c["resistance"].as_f64()).expect("a resistance")
    };
    assert!(moment(&answer) <= moment(&plain) * (1.0 + 1e-9));
    // a packing between end plate and flange is no backing plate
    let back = Answer::input("backing.yaml");
    let column = "      - {part: COLUMN, thickness: column.tf}\n";
    let between = back.replace(column, "").replace(
        "thickness: backing_thickness}\n  - base",
        &format!("thickness: backing_thickness}}\n{column}  - base"),
    );
    let bench = Bench::new().file("backing.yaml", between).file("joint.yaml", &text);
    let packed = Answer::from(bench, &["check", "joint.yaml", "--out", "out"]);
    assert_eq!(packed.verdict(), "undecided", "{}", packed.said);
    has(&packed, &["not checked: BOLT_R1P", "3.6.1(12)"]);
}

/// 150 mm in feet is 150 mm; the least width of a plate is the width of its beam.
#[test]
fn a_value_at_its_limit_is_accepted_in_every_unit() {
    let answer = Answer::of("33-units_width_at_limit_ft.yaml");
    assert_eq!(answer.code, 0, "{}", answer.said);
    for (profile, b, z) in
        [("IPE330", 160.0, 180.0), ("IPE360", 170.0, 195.0), ("IPE400", 180.0, 215.0)]
    {
        for (unit, size) in [("ft", 304.8), ("in", 25.4), ("m", 1000.0), ("cm", 10.0)] {
            let text = PLAIN
                .replace("IPE300", profile)
                .replace("width: 150", &format!("width: {} {unit}", b / size))
                .replace("[-160, 160]", &format!("[{} {unit}, {} {unit}]", -z / size, z / size))
                .replace("gauge: 80", "gauge: 100")
                .replace("[-95, 95]", "[-60, 60]");
            let answer = Answer::to(&text);
            assert_ne!(answer.code, 2, "{text}: {}", answer.said);
        }
    }
    let narrow = Answer::to(&PLAIN.replace("width: 150", "width: 149.999"));
    has(&narrow, &["`plate.width` is 149.999 mm; allowed: 150 mm"]);
}

#[test]
fn a_default_is_within_its_limits_or_names_its_cause() {
    let answer = Answer::of("34-default_column_below.yaml");
    assert_ne!(answer.code, 2, "{}", answer.said);
    for more in ["column_above: 300", "column_above: 235, beam_length: 300", "column_below: 1 m"] {
        let text = format!("{COLUMN}parameters: {{{more}}}\n");
        assert_ne!(Answer::to(&text).code, 2, "{more}");
    }
    // a template whose default can leave its range
    let mine = "extends: beam_to_column_end_plate\nname: mine\ntitle: Mine\nparameters:\n  - {\
                name: column_below, default: column_above}\n  - base\n";
    let spec = COLUMN
        .replace("beam_to_column_end_plate", "mine.yaml")
        .replace("[-165, 230]", "[-230, 165]")
        .replace("[-90, 90, 190]", "[-190, -90, 90]");
    let bench = Bench::new()
        .file("mine.yaml", mine)
        .file("joint.yaml", format!("{spec}parameters: {{column_above: 165}}\n"));
    let answer = Answer::from(bench, &["check", "joint.yaml", "--out", "out"]);
    assert_eq!(answer.code, 2);
    has(
        &answer,
        &[
            "`column_below` is 165 mm by its default `column_above`",
            "`parameters.column_above` is 165 mm",
            "230 mm to 20000 mm",
            "joint.yaml:6",
        ],
    );
}

/// A grade without quotes is the grade: in a spec, in the base of a sweep and on its axes.
#[test]
fn a_grade_without_quotes_reads_the_same_everywhere() {
    let plain = PLAIN.replace("\"10.9\"", "10.9");
    let [quoted, unquoted] = [PLAIN, &plain].map(Answer::to);
    assert_eq!(unquoted.checks(), quoted.checks());
    let grade = |g: &str| Answer::to(&PLAIN.replace("\"10.9\"", g));
    assert_eq!(grade("10.90").checks(), quoted.checks());
    assert_eq!(grade("8.8").checks(), grade("\"8.8\"").checks());
    // as the base of a sweep, and on an axis
    let axes = "  plate.thickness: [12, 15]\n  bolts.size: [M16, M20]\n";
    let tables = |base: &str, axes: &str, rows: &str| {
        let sweep = format!(
            "base: joint.yaml\nfirst: checks\naxes:\n{axes}tables:\n  - {{title: T, rows: {rows}, \
             columns: plate.thickness, action: My}}\n"
        );
        let bench = Bench::new().file("joint.yaml", base).file("sweep.yaml", sweep);
        bench.run(&["batch", "sweep.yaml"]);
        bench.read("sweep/tables.md")
    };
    let table = tables(&plain, axes, "bolts.size");
    assert!(table.contains("| M16 | (") && table.contains("| M20 | ("), "{table}");
    assert_eq!(table, tables(PLAIN, axes, "bolts.size"));
    let axes = |grades: &str| format!("  plate.thickness: [12, 15]\n  bolts.grade: [{grades}]\n");
    let table = tables(&plain, &axes("8.8, 10.9"), "bolts.grade");
    assert!(table.contains("| 8.8 | (") && table.contains("| 10.9 | ("), "{table}");
    assert_eq!(table, tables(PLAIN, &axes("\"8.8\", \"10.9\""), "bolts.grade"));
}

#[test]
fn skewed_and_tapered_members_are_named_as_of_a_later_edition() {
    for (old, new) in [
        ("\nplate:", "\ntaper: {length: 500}\nplate:"),
        ("plate: {", "plate: {skew: 5, "),
        ("beam: {", "beam: {tapered: 5, "),
        ("\nplate:", "\nparameters: {skew_angle: 6}\nplate:"),
        ("template: beam_to_column_end_plate", "template: tapered_end_plate"),
        ("members: {", "members: {taper: {profile: IPE300, steel: S235}, "),
    ] {
        let answer = Answer::to(&COLUMN.replacen(old, new, 1));
        assert_eq!(answer.code, 2, "{new}: {}", answer.said);
        has(&answer, &["not in this edition"]);
    }
    let readme = Path::new(env!("CARGO_MANIFEST_DIR")).join("README.md");
    let readme = std::fs::read_to_string(readme).expect("README.md");
    assert!(readme.contains("tapered members are not in this edition"));
}

/// A row of an own table with dimensions alone: HEB200 of EN 10365 by another name gives the same
/// checks.
#[test]
fn own_profiles_need_their_dimensions_alone() {
    let table = "# source: drawing 12\nname,series,standard,h_mm,b_mm,tw_mm,tf_mm,r_mm,\
                 mass_kg_per_m,A_cm2,Iy_cm4,Iz_cm4,Wel_y_cm3,Wpl_y_cm3,Wel_z_cm3,Wpl_z_cm3\nMY200,\
                 own,drawing,200,200,9,15,18,,,,,,,,\n";
    let text = format!("{}catalog: tables\n", COLUMN.replace("HEB200", "MY200"));
    let bench = Bench::new().file("joint.yaml", text);
    std::fs::create_dir(bench.path().join("tables")).expect("made");
    let bench = bench.file("tables/own.csv", table);
    let own = Answer::from(bench, &["check", "joint.yaml", "--out", "out"]);
    let built_in = Answer::to(COLUMN);
    assert_eq!(own.verdict(), built_in.verdict(), "{}", own.said);
    let used = |a: &Answer| -> Vec<f64> {
        a.checks().iter().filter_map(|c| c["utilisation"].as_f64()).collect()
    };
    let (own, built_in) = (used(&own), used(&built_in));
    assert_eq!(own.len(), built_in.len());
    for (a, b) in own.iter().zip(&built_in) {
        assert!((a / b - 1.0).abs() < 2e-3, "{a} {b}");
    }
}
