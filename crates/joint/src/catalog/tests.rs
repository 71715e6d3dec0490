//! Checks of the shipped tables: recomputed properties, pinned values, names.

use super::*;
use crate::spec::code::FySource;
use bracket_base::diag::Fault;
use std::path::Path;

mod wrong;

fn builtin() -> Catalog {
    Catalog::builtin().expect("the shipped catalogue loads")
}

/// Writes the tables into a folder and merges it into the built-in catalogue.
fn merged(tables: &[(&str, &str)]) -> Result<Catalog, CatalogError> {
    let dir = tempfile::tempdir().expect("temporary folder");
    for (file, text) in tables {
        std::fs::write(dir.path().join(file), text).expect("write table");
    }
    Catalog::with_dir(dir.path())
}

fn fault(tables: &[(&str, &str)]) -> Diagnostic {
    merged(tables).expect_err("the table is wrong").into()
}

const HEAD: &str = "name,series,standard,h_mm,b_mm,tw_mm,tf_mm,r_mm,mass_kg_per_m,A_cm2,Iy_cm4,\
                    Iz_cm4,Wel_y_cm3,Wpl_y_cm3,Wel_z_cm3,Wpl_z_cm3\n";
const GOOD: &str =
    "MY200,own,works drawing,200,200,9,15,18,61.3,78.1,5696,2003,569.6,642.5,200.3,305.8\n";

fn profile_with(cell: &str, value: &str) -> String {
    let column = HEAD.trim_end().split(',').position(|h| h == cell).expect("column");
    let mut cells: Vec<&str> = GOOD.trim_end().split(',').collect();
    cells[column] = value;
    format!("{HEAD}{}\n", cells.join(","))
}

/// The outline formulae reproduce HEB 200 of EN 10365: A = 78.08 cm², I_y = 5696 cm⁴, read from two
/// tables.
#[test]
fn outline_of_heb200() {
    let catalog = builtin();
    let p = catalog.profile("HEB200").expect("HEB200");
    assert!((p.outline_area() / 100.0 - 78.08).abs() < 0.005, "{}", p.outline_area());
    assert!((p.outline_i_y() / 1.0e4 - 5696.0).abs() < 0.5, "{}", p.outline_i_y());
}

/// The closed fillet formula agrees with a midpoint sum over the clear depth between the flanges.
#[test]
fn outline_i_y_equals_numerical_integration() {
    let catalog = builtin();
    for name in ["IPE80", "HEM100", "UB533x210x92", "W14X90"] {
        let p = catalog.profile(name).expect("profile");
        let clear = p.h / 2.0 - p.tf;
        let mut area = p.b * p.tf;
        let mut i_y = p.b * (p.h.powi(3) / 8.0 - clear.powi(3)) / 3.0;
        let n = 100_000;
        for k in 0..n {
            let z = (f64::from(k) + 0.5) * clear / f64::from(n);
            let inside = (p.r - (clear - z)).max(0.0);
            let width = p.tw
                + 2.0 * if inside > 0.0 { p.r - (p.r * p.r - inside * inside).sqrt() } else { 0.0 };
            area += width * clear / f64::from(n);
            i_y += width * z * z * clear / f64::from(n);
        }
        assert!((p.outline_area() / (2.0 * area) - 1.0).abs() < 1e-6, "{name}");
        assert!((p.outline_i_y() / (2.0 * i_y) - 1.0).abs() < 1e-6, "{name}");
    }
}

/// The recomputed A and I_y of every shipped European and British I section agree with the table
/// within 0.5 %, without exception.
#[test]
fn european_sections_reproduce_their_tables() {
    let catalog = builtin();
    let european: Vec<_> = catalog.profiles().iter().filter(|p| p.series != "W").collect();
    assert_eq!(european.len(), 294);
    for p in european {
        for (quantity, difference) in ["A", "I_y"].iter().zip(p.mismatch()) {
            assert!(
                difference.abs() <= PROPERTY_TOLERANCE,
                "{} {quantity} {:+.3} %",
                p.name,
                100.0 * difference
            );
        }
    }
}

/// Second moment and plastic moduli of the formulas against strips of the section, and every
/// property of every built-in row against its dimensions.
#[test]
fn every_property_follows_from_the_dimensions() {
    let catalog = builtin();
    let p = catalog.profile("HEB200").expect("there");
    let (mut i_z, mut w_y, mut w_z) = (0.0, 0.0, 0.0);
    let n = 200_000;
    let step = p.h / 2.0 / f64::from(n);
    for k in 0..n {
        // a strip of the upper half
        let z = (f64::from(k) + 0.5) * step;
        let clear = p.h / 2.0 - p.tf;
        let inside = (p.r - (clear - z)).max(0.0);
        let fillet = if inside > 0.0 { p.r - (p.r * p.r - inside * inside).sqrt() } else { 0.0 };
        let width = if z > clear { p.b } else { p.tw + 2.0 * fillet };
        w_y += 2.0 * width * z * step;
        w_z += 2.0 * width * width / 4.0 * step;
        i_z += 2.0 * width.powi(3) / 12.0 * step;
    }
    for (found, exact) in
        [(p.outline_i_z(), i_z), (p.outline_w_pl_y(), w_y), (p.outline_w_pl_z(), w_z)]
    {
        assert!((found / exact - 1.0).abs() < 1e-5, "{found} {exact}");
    }
    for p in catalog.profiles().iter() {
        for (column, given, outline) in p.properties() {
            let off = (outline / given - 1.0).abs();
            assert!(off < 0.05, "{} {column}: {given}, by its dimensions {outline}", p.name);
        }
    }
}

/// W shapes, with the root radius that reproduces the area. The area agrees within 0.5 %, except
/// for W18X234: its flanges and web alone (r = 0) already exceed the tabulated area by 0.513 %. For
/// I_y the American tables print dimensions and I to three figures; 54 of the 289 rows differ by
/// more than 0.5 %, the worst (W12X53) by 0.98 %. The test pins these numbers, so that a change of
/// the data or of the formula makes it fail.
#[test]
fn w_shapes_reproduce_their_tables_with_known_exceptions() {
    let catalog = builtin();
    let w: Vec<_> = catalog.profiles().iter().filter(|p| p.series == "W").collect();
    assert_eq!(w.len(), 289);
    let over = |i: usize| {
        w.iter().filter(|p| p.mismatch()[i].abs() > PROPERTY_TOLERANCE).collect::<Vec<_>>()
    };
    let [area, i_y] = [over(0), over(1)];
    assert_eq!(area.iter().map(|p| p.name.as_str()).collect::<Vec<_>>(), ["W18X234"]);
    assert!(area[0].r == 0.0 && area[0].mismatch()[0] < 0.0052);
    assert_eq!(i_y.len(), 54);
    let worst = i_y
        .iter()
        .max_by(|a, b| a.mismatch()[1].abs().total_cmp(&b.mismatch()[1].abs()))
        .expect("not empty");
    assert_eq!(worst.name, "W12X53");
    assert!(worst.mismatch()[1].abs() < 0.0099);
}

#[test]
fn names_are_found_in_every_spelling() {
    let catalog = builtin();
    for (spelling, name) in [
        ("HE200B", "HEB200"),
        ("HE 200 B", "HEB200"),
        ("HEB 200", "HEB200"),
        ("HEB200", "HEB200"),
        ("ipe360", "IPE360"),
        ("UB 533x210x92", "UB533x210x92"),
        ("533x210x92UB", "UB533x210x92"),
        ("W14X90", "W14X90"),
        ("HE 160 AA", "HEAA160"),
    ] {
        assert_eq!(catalog.profile(spelling).expect(spelling).name, name);
    }
    for p in catalog.profiles() {
        assert_eq!(catalog.profile(&p.name).expect("own name"), p);
    }
    assert_eq!(catalog.bolt("m 18").expect("M18").stress_area, 192.0);
    assert_eq!(catalog.bolt("HV M20").expect("HV").nut_height, 16.0);
    assert_eq!(catalog.bolt("HR M20").expect("HR").hole_normal, 22.0);
    assert_eq!(catalog.bolt_grade("8.8").expect("8.8").fub, 800.0);
    assert_eq!(catalog.friction_class("c").expect("C").mu, 0.3);
    assert_eq!(catalog.partial_factor("gamma_M2").expect("gamma_M2").value, 1.25);
}

#[test]
fn unknown_names_come_with_a_proposal() {
    let catalog = builtin();
    for (error, expected) in [
        (
            catalog.profile("HEB205").err(),
            "profile `HEB205` is not in the catalogue, the nearest are `HEB200` and `HEB220`",
        ),
        (catalog.profile("IPE 36").err(), "did you mean `IPE360`?"),
        (catalog.profile("IPE410").err(), "the nearest are `IPE400` and `IPE450`"),
        (catalog.profile("IPE 440").err(), "the nearest are `IPE450` and `IPE400`"),
        (catalog.profile("IPE410A").err(), "the nearest are `IPEA400` and `IPEA450`"),
        (catalog.profile("HE 210 B").err(), "the nearest are `HEB200` and `HEB220`"),
        (catalog.profile("HEB2000").err(), "did you mean `HEB200`?"),
        (catalog.profile("HEB1500").err(), "the nearest is `HEB1000`"),
        (catalog.profile("HEV200").err(), "did you mean `HE"),
        (catalog.profile("HEB2O0").err(), "did you mean `HEB200`?"),
        (
            catalog.profile("533x210x95 UB").err(),
            "the nearest are `UB533x210x92` and `UB533x210x101`",
        ),
        (catalog.profile("UB 530x210").err(), "the nearest are `UB533x210x"),
        (catalog.profile("W14x91").err(), "the nearest are `W14X90` and `W14X"),
        (catalog.bolt("M19").err(), "the nearest are `M18` and `M20`"),
        (catalog.bolt_grade("8.9").err(), "did you mean `8.8`?"),
        (catalog.steel("S325").err(), "did you mean `S235`?"),
        (catalog.friction_class("E").err(), "friction class `E` is not in the catalogue"),
        (catalog.partial_factor("gama_M0").err(), "did you mean `gamma_M0`?"),
    ] {
        let error = error.expect("unknown").to_string();
        assert!(error.contains(expected), "{error}");
    }
    let d: Diagnostic = catalog.profile("XYZ").expect_err("unknown").into();
    assert_eq!((d.code, d.fault.exit_code()), ("catalog/unknown-name", 2));
    assert!(d.help.is_some_and(|h| h.contains("bracket catalog list profiles")));
}

/// 36 ksi and 50 ksi have the values of the metric editions. There is no β_w, because EN 1993-1-8
/// Table 4.1 does not list these grades.
#[test]
fn astm_grades_have_the_metric_values_of_their_standards() {
    let catalog = builtin();
    for (name, fy, fu) in [
        ("A36", 250.0, 400.0),
        ("A572 Gr. 50", 345.0, 450.0),
        ("ASTM A992/A992M A992", 345.0, 450.0),
    ] {
        let s = catalog.steel(name).expect(name);
        assert_eq!(
            (s.fy(15.0).ok(), s.fu(60.0).ok(), s.beta_w),
            (Some(fy), Some(fu), None),
            "{name}"
        );
        assert!(
            catalog
                .provenance(&s.source.file)
                .and_then(|p| p.standard.clone())
                .is_some_and(|s| s.to_string().contains("ASTM"))
        );
    }
    for (name, fyb, fub) in [("A325M", 660.0, 830.0), ("F3125 Grade A490", 940.0, 1040.0)] {
        let g = catalog.bolt_grade(name).expect(name);
        assert_eq!((g.fyb, g.fub, g.preloadable), (fyb, fub, true), "{name}");
    }
    assert!(
        catalog.steel("A572-42").is_err()
            && catalog.steel("A500").is_err()
            && catalog.bolt_grade("A307").is_err()
    );
}

#[test]
fn steels_step_down_with_thickness() {
    let catalog = builtin();
    let s = catalog.steel("S355").expect("S355");
    assert_eq!((s.e, s.nu, s.density, s.beta_w), (210_000.0, 0.3, 7850.0, Some(0.9)));
    for (t, table, product) in [
        (10.0, 355.0, 355.0),
        (16.0, 355.0, 355.0),
        (16.1, 355.0, 345.0),
        (40.0, 355.0, 345.0),
        (40.1, 335.0, 335.0),
        (80.0, 335.0, 325.0),
    ] {
        assert_eq!(s.fy(t).expect("t"), table, "{t}");
        assert_eq!(s.fy_by(FySource::ProductStandard, t).expect("t"), product, "{t}");
    }
    assert_eq!((s.fu(40.0).expect("t"), s.fu(41.0).expect("t")), (490.0, 470.0));
    for t in [0.0, -1.0, 80.1, f64::NAN, f64::INFINITY] {
        assert!(matches!(s.fy(t), Err(CatalogError::Thickness { limit: 80.0, .. })), "{t}");
    }
    assert_eq!(s.fy_by(FySource::ProductStandard, 150.0).expect("t"), 295.0);
    assert_eq!(catalog.steel("S355 J2+N").expect("quality letters"), s);
    assert_eq!(catalog.steel("EN 10025-2 S355").expect("full name"), s);
    assert!(matches!(
        catalog.steel("S460Q").expect("S460Q").fy_by(FySource::ProductStandard, 10.0),
        Err(CatalogError::NoProductBands { .. })
    ));
    let error = catalog.steel("S235H").expect_err("two standards").to_string();
    assert!(error.contains("EN 10210-1 S235H") && error.contains("EN 10219-1 S235H"), "{error}");
    assert_eq!(catalog.steel("EN 10219-1 S235H").expect("full name").bands.len(), 1);
    assert!(catalog.steel("S450").expect("S450").beta_w.is_none());
}

#[test]
fn fy_source_is_written_as_in_the_spec() {
    for (value, text) in
        [(FySource::Table31, "\"table_3_1\""), (FySource::ProductStandard, "\"product_standard\"")]
    {
        assert_eq!(serde_json::to_string(&value).expect("json"), text);
    }
}

#[test]
fn every_shipped_table_has_provenance() {
    let catalog = builtin();
    assert!(catalog.warnings().is_empty());
    let files = catalog.provenance.keys().cloned().collect::<Vec<_>>();
    assert_eq!(files.len(), 17);
    for p in catalog.profiles() {
        let provenance = catalog.provenance(&p.source.file).expect("provenance");
        assert!(provenance.standard.is_some() && !provenance.read_from.is_empty());
    }
    let heb = catalog.profile("HEB200").expect("HEB200");
    assert!(
        catalog
            .provenance(&heb.source.file)
            .expect("provenance")
            .read_from
            .contains("EN 10365:2017")
    );
    let line = include_str!("../../../../catalogs/profiles_i.csv")
        .lines()
        .nth(heb.source.line - 1)
        .expect("line");
    assert!(line.starts_with("HEB200,"), "{line}");
}

#[test]
fn a_user_folder_adds_rows_and_warns_of_odd_sections() {
    let text = format!("# source: works drawing 12\n{HEAD}{GOOD}");
    let catalog = merged(&[("own.csv", &text)]).expect("good table");
    let p = catalog.profile("my 200").expect("added");
    assert_eq!((p.source.line, p.r), (3, 18.0));
    assert_eq!(
        catalog.provenance(&p.source.file).map(|s| s.read_from.as_str()),
        Some("works drawing 12")
    );
    assert!(catalog.warnings().is_empty());

    let catalog = merged(&[("own.csv", &profile_with("A_cm2", "79.0"))]).expect("only a warning");
    let [warning] = catalog.warnings() else { panic!("one warning: {:?}", catalog.warnings()) };
    assert!(
        warning.message.contains("A recomputed") && warning.message.contains("-1.16 %"),
        "{}",
        warning.message
    );
    assert_eq!(warning.place.line, Some(2));
    let catalog = merged(&[("own.csv", &profile_with("Iy_cm4", "5600"))]).expect("only a warning");
    assert!(catalog.warnings()[0].message.contains("I_y recomputed"));
    assert!(
        merged(&[("own.csv", &profile_with("Iy_cm4", "5720"))])
            .expect("0.42 %")
            .warnings()
            .is_empty()
    );
}

/// The rows of EN 10365 with all properties left empty get those of the outline, which are the
/// tabulated ones within their rounding.
#[test]
fn empty_properties_follow_from_the_outline() {
    let builtin = builtin();
    let tabulated: Vec<&IProfile> =
        builtin.profiles().iter().filter(|p| !p.computed && p.standard == "EN 10365").collect();
    assert!(tabulated.len() >= 90, "{}", tabulated.len());
    let rows = tabulated.iter().map(|p| {
        format!("MY{},own,drawing,{},{},{},{},{},,,,,,,,\n", p.name, p.h, p.b, p.tw, p.tf, p.r)
    });
    let text = format!("{HEAD}{}", rows.collect::<String>());
    let catalog = merged(&[("own.csv", &text)]).expect("rows without properties");
    for p in tabulated {
        let own = catalog.profile(&format!("MY{}", p.name)).expect("added");
        assert!(own.computed);
        for ((column, own, _), (_, table, _)) in own.properties().into_iter().zip(p.properties()) {
            assert!((own / table - 1.0).abs() < 0.005, "{} {column}: {own} {table}", p.name);
        }
        // tables give the mass with three figures
        assert!((own.mass / p.mass - 1.0).abs() < 0.012, "{}: {} {}", p.name, own.mass, p.mass);
    }
    // one empty cell among given ones
    let one = merged(&[("own.csv", &profile_with("Iy_cm4", ""))]).expect("one empty cell");
    let own = one.profile("MY200").expect("added");
    assert!((own.i_y - 5696.0).abs() < 0.5 && own.area == 78.1 && own.computed, "{own:?}");
    // dimensions have no default
    let d = fault(&[("own.csv", &profile_with("tw_mm", ""))]);
    assert!(d.message.contains("the cell is empty"), "{}", d.message);
}

/// The project's own folder is a valid user folder. Every table of it is read.
#[test]
fn the_shipped_folder_loads_as_a_user_folder() {
    let catalog = Catalog::load_dir(&Path::new(env!("CARGO_MANIFEST_DIR")).join("../../catalogs"))
        .expect("loads");
    assert_eq!(catalog.profiles().len(), builtin().profiles().len());
    assert_eq!(catalog.bolts().len(), builtin().bolts().len());
    assert_eq!(catalog.shaped().len(), builtin().shaped().len());
    let unused = catalog.warnings().iter().filter(|w| w.code == "catalog/unused-table").count();
    assert_eq!(unused, 0);
}

#[test]
fn a_bolt_size_that_is_not_made_is_answered_with_its_neighbours() {
    let catalog = Catalog::builtin().expect("sound");
    for (name, told) in [
        ("M21", ", the nearest are `M20` and `M22`"),
        ("m 19", ", the nearest are `M18` and `M20`"),
        ("HV M21", ", the nearest are `HV M20` and `HV M22`"),
        ("M500", ", the nearest is `M"),
        ("M1", ", did you mean `M10`?"),
    ] {
        let message = catalog.bolt(name).expect_err(name).to_string();
        assert!(message.contains(told), "{name}: {message}");
    }
    // no size at all: the closest spelling is suggested, if there is one
    for name in ["", "M", "bolt", "Mx", "MNAN", "8.8"] {
        let message = catalog.bolt(name).expect_err(name).to_string();
        assert!(!message.contains("nearest"), "{name}: {message}");
    }
}
