//! Tables and folders that are refused.

use super::*;

#[test]
fn duplicate_names_are_refused_with_both_places() {
    let twice = format!("{HEAD}{GOOD}{}", GOOD.replace("MY200", "my-200"));
    let d = fault(&[("own.csv", &twice)]);
    assert_eq!((d.code, d.place.line), ("catalog/duplicate-name", Some(3)));
    assert!(
        d.message.contains("own.csv line 2") && d.message.contains("own.csv line 3"),
        "{}",
        d.message
    );
    let d = fault(&[("own.csv", &profile_with("name", "HE 200 B"))]);
    assert!(
        d.message.contains("catalogs/profiles_i.csv line") && d.message.contains("own.csv line 2"),
        "{}",
        d.message
    );
}

#[test]
fn wrong_cells_name_file_line_and_column() {
    for (column, value, expected) in [
        ("h_mm", "", "the cell is empty"),
        ("h_mm", "0", "0 must be greater than 0"),
        ("b_mm", "-200", "-200 must be greater than 0"),
        ("tw_mm", "NaN", "`NaN` is not a finite number"),
        ("tf_mm", "inf", "`inf` is not a finite number"),
        ("r_mm", "-1", "-1 must not be negative"),
        ("A_cm2", "78.1 cm2", "`78.1 cm2` is not a number"),
        ("Iy_cm4", "1e999", "is not a finite number"),
        ("name", "", "the cell is empty"),
        ("h_mm", "60", "60 must exceed 2 (tf + r) = 66"),
        ("b_mm", "40", "40 must exceed tw + 2 r = 45"),
    ] {
        let d = fault(&[("own.csv", &profile_with(column, value))]);
        assert_eq!(
            (d.code, d.fault, d.place.line),
            ("catalog/bad-cell", Fault::Input, Some(2)),
            "{column}={value}"
        );
        assert!(d.place.file.as_deref().is_some_and(|f| f.ends_with("own.csv")));
        assert!(d.message.contains(column) && d.message.contains(expected), "{}", d.message);
    }
}

#[test]
fn wrong_tables_are_refused() {
    let header = |from: &str, to: &str| format!("{}{GOOD}", HEAD.replace(from, to));
    for (text, code, expected) in [
        (header("tw_mm", "tw_m"), "catalog/missing-column", "no column `tw_mm`, is it `tw_m`"),
        (header("r_mm", "It_cm4"), "catalog/missing-column", "no column `r_mm` (nor `r_area_mm`)"),
        (header("r_mm", "r_area"), "catalog/unknown-column", "did you mean `r_area_mm`?"),
        (header("b_mm", "h_mm"), "catalog/bad-cell", "the header is there twice"),
        (format!("{HEAD}MY200,own\n"), "catalog/not-csv", "the row has 2 cells, the header 16"),
        (
            format!("{HEAD}{}", GOOD.repeat(100_001)),
            "catalog/not-csv",
            "more than 100000 rows are not read",
        ),
        ("a,".repeat(1000) + "a\n", "catalog/not-csv", "more than 1000 columns are not read"),
        ("a,b\n1,2\n".into(), "catalog/unknown-table", "fit no kind"),
        (String::new(), "catalog/unknown-table", "fit no kind"),
        (
            "class,slip_factor_mu,surface_treatment\nE,-0.1,oiled\n".into(),
            "catalog/bad-cell",
            "must not be negative",
        ),
        (
            "standard,grade,t_over_mm,t_up_to_mm,ReH_min_MPa,Rm_min_MPa,basis\nEN \
             1,S1,0,16,235,360,read\n"
                .into(),
            "catalog/bad-cell",
            "`EN 1 S1` is in no table of steels",
        ),
        (
            "standard,grade,t_over_mm,t_up_to_mm,ReH_min_MPa,Rm_min_MPa,basis\nEN \
             10025-6,S460Q,16,40,440,570,read\n"
                .into(),
            "catalog/bad-cell",
            "16 does not continue",
        ),
        (
            "grade,fyb_MPa,fub_MPa,alpha_v_threads_in_shear_plane,alpha_v_shank_in_shear_plane,\
             preloadable\n9.9,900,800,0.6,0.6,no\n"
                .into(),
            "catalog/bad-cell",
            "800 is below fyb = 900",
        ),
        (
            "grade,fyb_MPa,fub_MPa,alpha_v_threads_in_shear_plane,alpha_v_shank_in_shear_plane,\
             preloadable\n9.9,800,900,0.6,0.6,maybe\n"
                .into(),
            "catalog/bad-cell",
            "neither `yes` nor `no`",
        ),
        (
            include_str!("../../../../../catalogs/bolts.csv")
                .replace("M18,no,18,2.5,254.5,192,20,", "MX18,no,18,2.5,254.5,192,17,")
                .lines()
                .enumerate()
                .filter(|(i, l)| *i == 0 || l.starts_with("MX18"))
                .map(|(_, l)| format!("{l}\n"))
                .collect(),
            "catalog/bad-cell",
            "the hole 17 must exceed 18",
        ),
    ] {
        let d = fault(&[("own.csv", &text)]);
        assert_eq!(d.code, code, "{}", d.message);
        assert!(d.message.contains(expected), "{}", d.message);
        assert!(d.place.file.is_some() && d.help.is_some());
    }
}

#[test]
fn folders_that_cannot_be_read_are_named() {
    let missing: Diagnostic =
        Catalog::load_dir(Path::new("no/such/folder")).expect_err("missing").into();
    assert_eq!((missing.code, missing.fault), ("catalog/unreadable", Fault::Input));
    let empty = tempfile::tempdir().expect("temporary folder");
    let empty: Diagnostic = Catalog::load_dir(empty.path()).expect_err("empty").into();
    assert_eq!(empty.code, "catalog/empty");
}

#[test]
fn a_refused_folder_leaves_the_catalogue_as_it_was() {
    let dir = tempfile::tempdir().expect("temporary folder");
    std::fs::write(dir.path().join("a.csv"), format!("{HEAD}{GOOD}")).expect("write");
    std::fs::write(dir.path().join("b.csv"), profile_with("h_mm", "x").replace("MY200", "MY300"))
        .expect("write");
    let mut catalog = builtin();
    let before = catalog.profiles().len();
    assert!(catalog.merge(dir.path()).is_err());
    assert_eq!(catalog.profiles().len(), before);
    assert!(catalog.profile("MY200").is_err());
}

/// Values that no such part can have, each in an own table, with the line and the character of the
/// cell.
#[test]
fn values_that_no_part_can_have_are_refused() {
    const STEEL: &str = "standard,grade,fy_t_le_40_MPa,fu_t_le_40_MPa,fy_t_40_to_80_MPa,\
                         fu_t_40_to_80_MPa,E_MPa,nu,density_kg_per_m3,beta_w";
    const GRADE: &str = "grade,fyb_MPa,fub_MPa,alpha_v_threads_in_shear_plane,\
                         alpha_v_shank_in_shear_plane,preloadable";
    const FACTOR: &str = "factor,recommended_value,applies_to,standard";
    const CLASS: &str = "class,slip_factor_mu,surface_treatment";
    let bolts = include_str!("../../../../../catalogs/bolts.csv");
    let row = |text: &str, name: &str| {
        let found = text.lines().find(|l| l.starts_with(name)).expect("a row");
        found.replacen(name, "My,", 1)
    };
    let m20 = row(bolts, "M20,");
    let bolt = |old: &str, new: &str| {
        assert!(m20.contains(old), "{m20} {old}");
        format!("{}\n{}\n", bolts.lines().next().expect("a header"), m20.replacen(old, new, 1))
    };
    let steel = |cells: &str| format!("{STEEL}\nown,My235,{cells}\n");
    let grade = |cells: &str| format!("{GRADE}\nmy,{cells},yes\n");
    for (text, column, words) in [
        (steel("35500,51000,335,470,210000,0.3,7850,0.9"), "fy_t_le_40_MPa", "100 and 1300"),
        (steel("355,510,335,470,210,0.3,7850,0.9"), "E_MPa", "150000 and 230000"),
        (steel("355,510,335,470,210000,0.3,7850,0.09"), "beta_w", "0.7 and 1.2"),
        (steel("355,510,335,47000,210000,0.3,7850,0.9"), "fu_t_40_to_80_MPa", "200 and 1700"),
        (steel("355,510,335,470,210000,0.5,7850,0.9"), "nu", "0.2 and 0.4"),
        (steel("355,510,335,470,210000,0.3,7.85,0.9"), "density_kg_per_m3", "7000 and 8500"),
        (grade("640,9000,0.6,0.6"), "fub_MPa", "250 and 1700"),
        (grade("640,800,6,0.6"), "alpha_v_threads_in_shear_plane", "0.3 and 0.7"),
        (bolt(",245,", ",2450,"), "As_mm2", "must exceed"),
        (bolt(",245,", ",298,"), "As_mm2", "contradicts d = 20 mm and its pitch 2.5 mm"),
        (steel("235,360,460,550,210000,0.3,7850,0.9"), "fy_t_40_to_80_MPa", "thinner parts"),
        (bolt("314.2,245,", "3142,2450,"), "A_mm2", "contradicts d = 20 mm"),
        (format!("{FACTOR}\ngamma_M2,0.125,bolts,own\n"), "recommended_value", "0.5 and 3"),
        (format!("{CLASS}\nZ,5,blasted\n"), "slip_factor_mu", "between 0 and 1"),
    ] {
        let d = fault(&[("own.csv", &text)]);
        assert_eq!((d.code, d.fault, d.place.line), ("catalog/bad-cell", Fault::Input, Some(2)));
        assert!(d.message.contains(column) && d.message.contains(words), "{}", d.message);
        // the cell begins behind as many commas as its header
        let at = |line: &str, character: usize| {
            line.chars().take(character - 1).filter(|c| *c == ',').count()
        };
        let (head, cells) = text.split_once('\n').expect("two lines");
        let header = head.split(',').position(|h| h == column).expect("a header");
        assert_eq!(at(cells, d.place.column.expect("a character")), header, "{column}");
    }
    for (column, value) in [("It_cm4", "100000"), ("mass_kg_per_m", "1")] {
        let text = match HEAD.contains(column) {
            true => profile_with(column, value),
            false => format!("{},{column}\n{},{value}\n", HEAD.trim_end(), GOOD.trim_end()),
        };
        let d = fault(&[("own.csv", &text)]);
        assert!(d.code == "catalog/bad-cell" && d.message.contains(column), "{}", d.message);
    }
}

/// Comments and empty lines above a row do not move the line that is named.
#[test]
fn comments_are_lines() {
    let text = format!(
        "{HEAD}# source: own\n\n{}",
        profile_with("h_mm", "0").lines().last().expect("a row")
    );
    let d = fault(&[("own.csv", &text)]);
    assert_eq!((d.code, d.place.line), ("catalog/bad-cell", Some(4)));
}
