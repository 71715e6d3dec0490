//! Tests of specs that cannot be built. Each gives one code, one place and a message that names the
//! remedy.

use super::tests::{PAPER, joint, with};
use bracket_base::diag::{Diagnostic, Fault};

/// A change to the paper's spec, and the content of the first fault it must give.
struct Case {
    old: &'static str,
    new: &'static str,
    code: &'static str,
    path: &'static str,
    /// Words that the message and the help must contain.
    words: &'static [&'static str],
}

const CASES: &[Case] = &[
    Case {
        old: "profile: HEB200",
        new: "profile: HEB2O0",
        code: "catalog/unknown-name",
        path: "members.column.profile",
        words: &[
            "`HEB2O0` is not in the catalogue",
            "did you mean `HEB200`?",
            "bracket catalog list",
        ],
    },
    Case {
        old: "profile: IPE360, steel: S235",
        new: "profile: IPE360, steel: S235, length: 6",
        code: "spec/value",
        path: "members.beam.length",
        words: &["a system length of 6 mm", "from 100 mm to 100 m", "`length: 6 m`"],
    },
    Case {
        old: "profile: IPE360, steel: S235",
        new: "profile: IPE360, steel: S235, length: 6 kN",
        code: "yaml/quantity",
        path: "members.beam.length",
        words: &["`6 kN` is not a length"],
    },
    Case {
        old: "plate: {thickness: 15,",
        new: "plate: {thickness: -15,",
        code: "spec/range",
        path: "plate.thickness",
        words: &["`plate.thickness` is -15 mm", "4 mm to 100 mm"],
    },
    Case {
        old: "plate: {thickness: 15, width: 180, z: [-250, 200]}\n",
        new: "",
        code: "spec/missing",
        path: "plate.thickness",
        words: &["`plate.thickness` is missing", "thickness of the end plates", "bracket new"],
    },
    Case {
        old: "plate: {thickness: 15,",
        new: "plate: {thickness: 15 kN,",
        code: "yaml/quantity",
        path: "plate.thickness",
        words: &["`15 kN` is not a length", "mm, cm, m"],
    },
    Case {
        old: "pressure: 45 MPa",
        new: "pressure: 45",
        code: "yaml/quantity",
        path: "loads[0].pressure",
        words: &["stress 45 needs a unit", "write `45 MPa`"],
    },
    Case {
        old: "pressure: 45 MPa",
        new: "pressure: .nan",
        code: "yaml/not-finite",
        path: "loads[0].pressure",
        words: &["finite"],
    },
    Case {
        old: "grade: \"8.8\",",
        new: "grade: \"8.8\", preload: 98.7,",
        code: "spec/range",
        path: "bolts.preload",
        words: &[
            "`bolts.preload` is 98.7 f_ub A_s",
            "0.8 f_ub A_s, at which the thread of M18 8.8 yields",
        ],
    },
    Case {
        old: "grade: \"8.8\",",
        new: "grade: \"8.8\", preload: 0,",
        code: "spec/range",
        path: "bolts.preload",
        words: &["above 0, up to 122.9 kN"],
    },
    Case {
        old: "grade: \"8.8\",",
        new: "grade: \"8.8\", preload: 123 kN,",
        code: "spec/range",
        path: "bolts.preload",
        words: &["`bolts.preload` is 123 kN", "up to 122.9 kN"],
    },
    Case {
        old: "grade: \"8.8\",",
        new: "grade: \"8.8\", preload: 98.7 mm,",
        code: "yaml/quantity",
        path: "bolts.preload",
        words: &["`98.7 mm` is not a force", "or `none`, or a part of f_ub A_s"],
    },
    Case {
        old: "grade: \"8.8\",",
        new: "grade: \"8.8\", preload: full,",
        code: "yaml/quantity",
        path: "bolts.preload",
        words: &["`full` is not a force", "or `none`"],
    },
    Case {
        old: "grade: \"8.8\",",
        new: "grade: \"8.8\", preload: .inf,",
        code: "yaml/not-finite",
        path: "bolts.preload",
        words: &["finite"],
    },
    Case {
        old: "grade: \"8.8\",",
        new: "grade: \"8.8\", preload: [0.7],",
        code: "yaml/type",
        path: "bolts.preload",
        words: &["`none`, a part of f_ub A_s (0.7), or a force with its unit"],
    },
    Case {
        old: "grade: \"8.8\",",
        new: "grade: \"5.6\", preload: 0.7,",
        code: "spec/value",
        path: "bolts.preload",
        words: &["bolts of grade 5.6 are not made to be preloaded", "use grade 8.8 or 10.9"],
    },
    Case {
        old: "rows: [-215, -125, 110]",
        new: "rows: [-215, -125, 190]",
        code: "spec/rule",
        path: "bolts.rows[2]",
        words: &["the bolt row at 190 mm does not lie on the end plate", "186.5 mm"],
    },
    Case {
        old: "rows: [-215, -125, 110]",
        new: "rows: [-125, -115, 110]",
        code: "spec/rule",
        path: "bolts.rows[1]",
        words: &[
            "the bolt rows at -125 mm and -115 mm overlap: 10 mm apart",
            "28 mm",
            "44 mm apart",
        ],
    },
    Case {
        old: "rows: [-215, -125, 110]",
        new: "rows: [-215, -125, 170]",
        code: "spec/rule",
        path: "bolts.rows[2]",
        words: &["the row at 170 mm collide with the beam flange at 173.65 mm", "20.85 mm away"],
    },
    Case {
        old: "gauge: 100",
        new: "gauge: 60",
        code: "spec/rule",
        path: "bolts.gauge",
        words: &["gauge 60 mm leaves no room", "at least 79 mm"],
    },
    Case {
        old: "gauge: 100",
        new: "gauge: 160",
        code: "spec/rule",
        path: "bolts.gauge",
        words: &["bolts leave the end plate (180 mm wide)", "at most 148 mm"],
    },
    Case {
        old: "size: M18",
        new: "size: M39",
        code: "spec/rule",
        path: "bolts.size",
        words: &["no gauge has room for these bolts", "take smaller bolts"],
    },
    Case {
        old: "z: [-250, 200]",
        new: "z: [-250, 150]",
        code: "spec/rule",
        path: "plate.z",
        words: &["from -250 mm to 150 mm does not cover the beam", "to 180 mm or higher"],
    },
    Case {
        old: "size: M18",
        new: "size: M19",
        code: "catalog/unknown-name",
        path: "bolts.size",
        words: &["`M19` is not in the catalogue", "the nearest are `M18` and `M20`"],
    },
    Case {
        old: "beam_length: 1000",
        new: "beam_lenght: 1000",
        code: "spec/unknown-name",
        path: "parameters.beam_lenght",
        words: &[
            "no parameter `beam_lenght`, did you mean `beam_length`?",
            "known here: hole_clearance",
        ],
    },
    Case {
        old: "support_distance: 900",
        new: "support_distance: 995",
        code: "spec/rule",
        path: "parameters.support_distance",
        words: &[
            "the support ends 1002.5 mm from the end plate, beyond the beam",
            "at most 992.5 mm",
        ],
    },
    Case {
        old: "section: column_top",
        new: "section: column_tip",
        code: "spec/unknown-name",
        path: "loads[0].section",
        words: &["no section `column_tip`, did you mean `column_top`?", "column_bottom"],
    },
    Case {
        old: "section: column_top, pressure: 45 MPa",
        new: "end: beam_left, at: column_face, My: 120 kN m",
        code: "spec/value",
        path: "loads[0]",
        words: &["no member ends", "section by `pressure`", "`beam_to_column_end_plate`"],
    },
    Case {
        old: "loads: [{name: TOP, section: column_top, pressure: 45 MPa}]\n",
        new: "",
        code: "spec/missing",
        path: "loads",
        words: &["`loads` is missing", "section: column_top"],
    },
    Case {
        old: "beam: {profile: IPE360, steel: S235}",
        new: "bean: {profile: IPE360, steel: S235}",
        code: "spec/unknown-name",
        path: "members.bean",
        words: &["has no member `bean`, did you mean `beam`?", "column, beam"],
    },
    Case {
        old: "steel: S235}, beam",
        new: "steel: S236}, beam",
        code: "catalog/unknown-name",
        path: "members.column.steel",
        words: &["`S236` is not in the catalogue", "did you mean `S235`?"],
    },
    Case {
        old: "template: double_sided_end_plate",
        new: "template: double_sided_end_plates",
        code: "template/unknown",
        path: "template",
        words: &["did you mean `double_sided_end_plate`?", "bracket templates"],
    },
    Case {
        old: "mu: 0.3",
        new: "mu: -0.3",
        code: "spec/range",
        path: "friction.mu",
        words: &["`friction.mu` is -0.3", "0 to 2"],
    },
    Case {
        old: "{mu: 0.3, law",
        new: "{mu: 0.3, class: C, law",
        code: "spec/value",
        path: "friction.class",
        words: &["both given", "keep one"],
    },
    Case {
        old: "kind: elastic",
        new: "kind: [elastic, elastik]",
        code: "yaml/unknown-value",
        path: "analysis.kind[1]",
        words: &[
            "`elastik` is not a value known",
            "did you mean `elastic`?",
            "elastoplastic, limit",
        ],
    },
    Case {
        old: "hole_clearance: 0}",
        new: "hole_clearance: 2 kN}",
        code: "spec/value",
        path: "parameters.hole_clearance",
        words: &["`2 kN` is not a length", "mm, cm, m"],
    },
    Case {
        old: "law: associated}",
        new: "law: associated, mu: 0.2}",
        code: "yaml/duplicate-key",
        path: "friction.mu",
        words: &["mu"],
    },
];

fn first_fault(text: &str) -> Diagnostic {
    let faults = joint(text).map(drop).expect_err("the spec is wrong");
    assert_eq!(faults.exit_code(), 2);
    faults.into_first()
}

#[test]
fn every_bad_spec_is_told_what_where_and_how_to_cure_it() {
    let mut wrong = Vec::new();
    for case in CASES {
        let text = with(case.old, case.new);
        let d = first_fault(&text);
        let said = format!("{} {}", d.message, d.help.clone().unwrap_or_default());
        let lacks: Vec<&&str> = case.words.iter().filter(|w| !said.contains(**w)).collect();
        // the reported line must be the changed one or, where an entry is missing, any line of the
        // file
        let line = PAPER[..PAPER.find(case.old).expect("old")].matches('\n').count() + 1;
        let at_line = d.place.line.is_some_and(|l| l == line || case.code == "spec/missing");
        let right = d.code == case.code
            && d.place.path.as_deref() == Some(case.path)
            && lacks.is_empty()
            && at_line;
        if !(right && d.fault == Fault::Input && d.help.is_some()) {
            wrong.push(format!(
                "`{}` -> `{}` (line {line}): lacks {lacks:?}\n{d:#?}",
                case.old, case.new
            ));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n\n"));
}

#[test]
fn all_faults_are_told_at_once() {
    let text = with("profile: HEB200", "profile: HEB999")
        .replace("size: M18", "size: M999")
        .replace("mu: 0.3", "mu: 9");
    let faults = joint(&text).map(drop).expect_err("three faults");
    let paths: Vec<&str> = faults.iter().filter_map(|d| d.place.path.as_deref()).collect();
    assert_eq!(paths, ["members.column.profile", "bolts.size", "friction.mu"]);
}

#[test]
fn a_faulty_template_of_the_user_is_named() {
    let folder = tempfile::tempdir().expect("a folder");
    let (_, shipped) = super::template_file::SHIPPED
        .iter()
        .find(|(n, _)| *n == "double_sided_end_plate")
        .expect("shipped");
    let spec = with("template: double_sided_end_plate", "template: mine.yaml");
    let build = |template: &str| {
        std::fs::write(folder.path().join("mine.yaml"), template).expect("writable");
        let parsed = bracket_base::yaml::parse(&spec, std::path::Path::new("joint.yaml"))
            .expect("the spec is sound");
        let catalog = crate::catalog::Catalog::builtin().expect("sound");
        let joint = super::build(&parsed, folder.path(), &catalog, super::tests::code());
        joint.map(drop)
    };
    assert!(build(shipped).is_ok());
    let fault = |old: &str, new: &str| {
        assert_eq!(shipped.matches(old).count(), 1, "{old}");
        build(&shipped.replace(old, new)).expect_err(new).into_first()
    };
    let d = fault("{name: face, value: column.h / 2}", "{name: face, value: beam_start}");
    assert_eq!(d.code, "template/wrong");
    assert!(d.message.contains("these values need each other: "), "{d:#?}");
    assert!(d.message.contains("face") && d.message.contains("beam_start"), "{d:#?}");
    let d = fault("{name: face, value: column.h / 2}", "{name: face, value: colum.h / 2}");
    assert!(d.message.contains("unknown name `colum.h`, did you mean `column.h`?"), "{d:#?}");
    let d = fault("{name: face, value: column.h / 2}", "{name: face, value: column.h / }");
    assert_eq!((d.code, d.place.line.is_some()), ("yaml/expression", true), "{d:#?}");
    let d = fault("size: 1.85 * column.tf", "size: 1.85 * 2");
    assert!(d.message.contains("a length [mm] is wanted, this number has no unit"), "{d:#?}");
    let d = fault("{part: COLUMN, thickness: column.tf}", "{part: COLUMNS, thickness: column.tf}");
    assert!(d.message.contains("there is no part `COLUMNS`"), "{d:#?}");
    // each fault is reported in the template's file, on the line of its entry
    for (old, new) in [
        ("{name: face, value: column.h / 2}", "{name: face, value: colum.h / 2}"),
        (
            "- name: room_for_a_gauge\n    that: gauge_least",
            "- name: room_for_a_gauge\n    that: gauge_leats",
        ),
        ("  width: plate.width\n", "  width: plate.widht\n"),
        ("  - name: COLUMN\n", "  - name: column\n"),
    ] {
        let d = fault(old, new);
        let line = shipped[..shipped.find(old).expect("it is there")].matches('\n').count() + 1;
        assert_eq!(
            d.place.file.as_deref().and_then(|f| f.file_name()),
            Some("mine.yaml".as_ref()),
            "{new}: {d:#?}"
        );
        assert_eq!(d.place.line, Some(line), "{new}: {d:#?}");
    }
}
