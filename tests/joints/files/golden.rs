//! `report.md` and `result.json` of a made-up joint against the files in `tests/golden`.
//!
//! After an intended change, run this and read the difference:
//! `BRACKET_UPDATE_GOLDEN=1 cargo test --release --test joints golden`.

use bracket::checks::formula::{Number, Traced};
use bracket::checks::subject::{Part, Place};
use bracket::checks::{Check, CheckId, Judgement, Status, Topic, Unit, Worked};
use bracket::model::AnalysisKind;
use bracket::report::document::picture::PictureRef;
use bracket::report::document::table::Table;
use bracket::report::markdown::compose::report_markdown;
use bracket::report::markdown::report_data::CatalogueRow;
use bracket::report::markdown::report_data::InputFacts;
use bracket::report::markdown::report_data::ModelTraits;
use bracket::report::markdown::report_data::ReportData;
use bracket::report::markdown::report_data::ResolvedValue;
use bracket::result::result_file::CaseResult;
use bracket::result::result_file::Certificate;
use bracket::result::result_file::FrictionModel;
use bracket::result::result_file::HistoryRow;
use bracket::result::result_file::LoadSize;
use bracket::result::result_file::PeakPressure;
use bracket::result::result_file::ProgramRun;
use bracket::result::result_file::Quantity;
use bracket::result::result_file::RawBracket;
use bracket::result::result_file::ResultFile;
use bracket::result::result_file::Tool;
use bracket::result::result_file::Upper;
use bracket::result::result_file::Verdict;
use bracket::words::Text;
use std::path::Path;

fn compare(name: &str, text: &str) {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/golden").join(name);
    if std::env::var_os("BRACKET_UPDATE_GOLDEN").is_some() {
        std::fs::write(&path, text).expect("golden files can be written");
    }
    let wanted = std::fs::read_to_string(&path).unwrap_or_default();
    if let Some((i, (a, b))) =
        text.lines().zip(wanted.lines()).enumerate().find(|(_, (a, b))| a != b)
    {
        panic!("{name}, line {}:\n  is     {a}\n  wanted {b}", i + 1);
    }
    assert_eq!(text, wanted, "{name} ends differently");
}

fn run(iterations: u32) -> ProgramRun {
    ProgramRun {
        seconds: 12.25,
        iterations,
        status: "optimal".into(),
        assembly_seconds: Some(0.5),
        solve_seconds: Some(11.25),
        peak_memory_mib: Some(512),
        ..ProgramRun::default()
    }
}

fn case(name: &str) -> CaseResult {
    CaseResult {
        lower: Some(-334_201.713),
        upper: Some(Upper::Finite(-318_891.744)),
        gap: Some(0.045_810_6),
        load: Some(LoadSize::Force(3_513_363.0)),
        load_displacement: Some([0.181_53, 0.190_246]),
        certificate: Some(Certificate {
            strict: true,
            equilibrium: Some(3.141e-13),
            traction_jump: Some(2e-14),
            yield_: None,
            contact: Some(0.0),
            compatibility: Some(7.77e-16),
            volume: None,
        }),
        history: vec![HistoryRow {
            macro_tets: 8899,
            kinematic_dofs: Some(49_290),
            static_dofs: Some(210_006),
            lower: Some(-334_201.713),
            upper: Some(Upper::Finite(-318_891.744)),
            gap: Some(0.045_810_6),
            kinematic: Some(run(18)),
            static_: Some(run(26)),
            static_frictionless: None,
            seconds: None,
            so_far: None,
            predicted: None,
            mesh_seconds: Some(3.0),
            peak_memory_mib: Some(1024),
        }],
        peak_contact_pressure: Some(PeakPressure { kinematic: Some(247.31), static_: Some(268.4) }),
        ..CaseResult::empty(
            name,
            AnalysisKind::Elastic,
            (Quantity::PotentialEnergy, FrictionModel::Associated),
        )
    }
}

fn checks() -> Vec<Check> {
    let table = |title| ("EN 1993-1-8:2005 Table 3.3", title);
    let plate = (Topic::Detailing, Part::EndPlate);
    let (f_ub, a_s) = (Traced::stress("f_ub", 800.0), Traced::area("A_s", 192.0));
    let force = Traced::number("k2", 0.9) * f_ub * a_s / Traced::number("γ_M2", 1.25);
    let tension = Worked::of(
        "EN 1993-1-8:2005 Table 3.4",
        CheckId::BoltTensionResistance,
        "F_t,Rd",
        force,
        Unit::Force,
    );
    let bolt = Place::Bolt { size: "M18".into(), grade: "8.8".into() };
    let d0 = |factor: f64| Traced::from(factor) * Traced::length("d0", 20.0);
    vec![
        Check::at_least(plate, table(CheckId::EdgeDistance), "e2", d0(1.2), 22.0, Status::Failed),
        Check::at_least(plate, table(CheckId::PitchOfRows), "p1", d0(2.2), 90.0, Status::Failed),
        Check::at_most(
            plate,
            table(CheckId::PitchOfRowsExposed),
            "p1",
            (Traced::from(14.0) * Traced::length("t", 15.0)).min(Traced::from(200.0)),
            235.0,
            Status::Warning,
        ),
        tension
            .with("k2", 0.9, Unit::Number)
            .with("A_s", 192.0, Unit::Area)
            .information(Topic::Bolts, bolt),
    ]
}

fn result() -> ResultFile {
    let mut limit = case("ULS1");
    limit.analysis = AnalysisKind::Limit;
    limit.quantity = Quantity::LoadFactor;
    limit.problem = FrictionModel::Coulomb;
    limit.lower = Some(1.234_56);
    limit.upper = Some(Upper::Finite(1.301_23));
    limit.gap = Some((1.301_23 - 1.234_56) / 1.234_56);
    limit.utilisation = Some([0.7685, 0.81]);
    limit.frictionless = Some(RawBracket { lower: Some(1.234_56), upper: Some(1.2512.into()) });
    limit.associated = Some(RawBracket { lower: Some(1.28), upper: Some(1.301_23.into()) });
    limit.coulomb_estimate = Some(1.2744);
    limit.load = None;
    limit.load_displacement = None;
    limit.certificate =
        Some(Certificate { strict: false, yield_: Some(2.5e-7), ..Default::default() });
    limit.history =
        vec![HistoryRow { macro_tets: 120, upper: Some(Upper::UNBOUNDED), ..Default::default() }];
    limit.peak_contact_pressure = None;
    limit.warnings = vec!["the yield residual is above its tolerance".into()];
    ResultFile {
        cases: vec![case("TOP"), limit],
        checks: checks(),
        tool: Tool { name: "bracket".into(), version: "0.0.0-golden".into() },
        judgement: Some(Judgement {
            verdict: Verdict::NotOk,
            route: None,
            by_code: Verdict::NotOk,
            by_analysis: Verdict::Undecided,
            reason: "TOP: a check fails: end distance, end plate, utilisation 1.04 (EN \
                     1993-1-8:2005 Table 3.3)"
                .into(),
            governing: None,
            steps: Vec::new(),
        }),
        ..ResultFile::new("0123456789abcdef", 4, Verdict::NotOk)
    }
}

fn data() -> ReportData {
    let pair = |a: &str, b: &str| (a.to_string(), b.to_string());
    let input = InputFacts {
        language: Default::default(),
        project: vec![
            pair("title", "Paper's joint"),
            pair("number", "2026-01"),
            pair("author", "A | B"),
            pair("revision", "A"),
        ],
        name: "joint.yaml".into(),
        read: "template: double_sided_end_plate\nplate:\n  thickness: 15 mm\n  width: 180 \
                     mm\n"
            .into(),
        text: "template: double_sided_end_plate\nplate: {thickness: 15, width: 180}  # ``` \
                     stays inside\n"
            .into(),
        resolved: vec![ResolvedValue {
            name: "bolts.hole".into(),
            value: "18".into(),
            unit: "mm".into(),
            origin: "computed: hole = shank".into(),
        }],
        demands: vec![],
        plane_actions: Table::default(),
        plane_note: Text::default(),
        catalogue_rows: vec![CatalogueRow {
            own: false,
            kind: "profile".into(),
            name: "HEB200".into(),
            source: "EN 10365:2017".into(),
            values: vec![pair("h [mm]", "200"), pair("b [mm]", "200")],
        }],
        drawings: vec![PictureRef {
            file: "drawing.svg".into(),
            caption: "Side view of the joint".into(),
            ..PictureRef::default()
        }],
        schedule: Table {
            columns: ["part", "number", "all [kg]"].map(Text::given).to_vec(),
            rows: vec![["bolt", "12", "4.35"].map(Text::given).to_vec()],
        },
        butt_welds: false,
        welds: Table {
            columns: ["weld", "seams", "all [mm]"].map(Text::given).to_vec(),
            rows: vec![["beam web", "2", "542"].map(Text::given).to_vec()],
        },
        supports: Table {
            columns: ["support", "part", "section", "held along"].map(Text::given).to_vec(),
            rows: vec![["FOOT", "COLUMN", "z = -300 mm", "x y z"].map(Text::given).to_vec()],
        },
    };
    ReportData {
        input,
        result: result(),
        pictures: vec![PictureRef {
            file: "mesh.png".into(),
            caption: "The meshed joint".into(),
            ..PictureRef::default()
        }],
        mesh_quality: Table {
            columns: ["body", "tets", "least dihedral [°]"].map(Text::given).to_vec(),
            rows: vec![["COLUMN", "3120", "11.2"].map(Text::given).to_vec()],
        },
        model: ModelTraits {
            contact: true,
            friction: true,
            facets: true,
            symmetry: true,
            ..Default::default()
        },
        assumptions: vec!["One bolt head of each pair is glued to its plate.".into()],
        notes: vec![],
        words: Default::default(),
    }
}

#[test]
fn golden_report() {
    compare("report.md", &report_markdown(&data(), &data().words()));
}

#[test]
fn golden_result() {
    compare("result.json", &result().to_json().expect("valid"));
}

#[test]
fn golden_result_has_the_keys_of_the_contract_in_its_order() {
    let text = result().to_json().expect("valid");
    let keys = [
        "schema",
        "tool",
        "name",
        "version",
        "input_hash",
        "symmetry",
        "verdict",
        "cases",
        "name",
        "analysis",
        "quantity",
        "problem",
        "lower",
        "upper",
        "gap",
        "load",
        "force",
        "load_displacement",
        "certificate",
        "strict",
        "equilibrium",
        "traction_jump",
        "contact",
        "compatibility",
        "history",
        "macro_tets",
        "kinematic_dofs",
        "static_dofs",
        "lower",
        "upper",
        "gap",
        "kinematic",
        "seconds",
        "iterations",
        "status",
        "static",
        "seconds",
        "iterations",
        "status",
        "mesh_seconds",
        "peak_memory_mib",
        "checks",
        "topic",
        "subject",
        "clause",
        "title",
        "formula",
        "demand",
        "resistance",
        "utilisation",
        "unit",
        "status",
    ];
    let mut at = 0;
    for key in keys {
        let quoted = format!("\"{key}\":");
        at += text[at..]
            .find(&quoted)
            .unwrap_or_else(|| panic!("`{key}` is missing or out of order"))
            + quoted.len();
    }
}

#[test]
fn estimates_are_never_called_bounds() {
    let mut data = data();
    for case in &mut data.result.cases {
        case.certificate = None;
    }
    let page = report_markdown(&data, &data.words());
    assert!(page.contains("estimates, not bounds"));
    for claim in [
        "lies between",
        "is at least **",
        "can be carried by the model;",
        "bounds are those of the whole structure",
    ] {
        assert!(!page.contains(claim), "{claim}");
    }
}
