use super::*;
use bracket_base::yaml;
use bracket_codes::design_code::build;
use bracket_joint::assembly::template_file::SHIPPED;

fn assemble(text: &str) -> bracket_joint::assembly::Joint {
    let spec = yaml::parse::<ConnectionSpec>(text, Path::new("new.yaml"))
        .unwrap_or_else(|e| panic!("{e:#?}\n{text}"));
    build(&spec, Path::new("."), &Catalog::builtin().expect("sound"))
        .unwrap_or_else(|e| panic!("{e:#?}\n{text}"))
}

#[test]
fn days_become_dates() {
    for (days, date) in [
        (0, "1970-01-01"),
        (58, "1970-02-28"),
        (59, "1970-03-01"),
        (11_016, "2000-02-29"),
        (19_782, "2024-02-29"),
        (19_783, "2024-03-01"),
        (20_088, "2024-12-31"),
        (20_089, "2025-01-01"),
        (47_540, "2100-02-28"),
        (47_541, "2100-03-01"),
    ] {
        assert_eq!(iso_date(days), date, "{days}");
    }
    let today = today();
    assert!(today.len() == 10 && today.as_str() > "2020", "{today}");
}

#[test]
fn every_starter_assembles_as_it_is_and_with_all_defaults_switched_on() {
    for (name, _) in SHIPPED {
        let (template, origin) = template_file::load(name, Path::new(".")).expect("shipped");
        let text =
            starter(&template, &origin, name, &Catalog::builtin().expect("sound"), "2024-02-29")
                .expect("a starter");
        let joint = assemble(&text);
        for words in ["  mu: 0 ", "  kind: limit ", "  date: \"2024-02-29\"\n"] {
            assert!(text.contains(words), "{name}: {words}");
        }
        for p in &template.parameters {
            let key = p.name.rsplit('.').next().expect("a name");
            assert!(text.contains(&format!("{key}: ")), "{name}: {} is not in the starter", p.name);
        }
        let mut on = String::new();
        for l in text.lines() {
            let trimmed = l.trim_start();
            let indent = &l[..l.len() - trimmed.len()];
            match trimmed.strip_prefix("# ") {
                Some(rest) if !indent.is_empty() => on.push_str(&format!("{indent}{rest}\n")),
                _ => on.push_str(&format!("{l}\n")),
            }
        }
        let all = assemble(&on);
        assert!(all.resolved.iter().all(|r| r.given), "{name}: {:#?}", all.resolved);
        // messages show nine decimals; the defaults are read back with that precision
        let text = |j: &bracket_joint::assembly::Joint| {
            serde_json::to_string(&j.assembly.parts).expect("JSON").len()
        };
        assert_eq!(joint.assembly.parts.len(), all.assembly.parts.len());
        assert!(text(&joint).abs_diff(text(&all)) < 200);
    }
}

/// Wherever the two folders are, the spec's folder and the path in the spec lead to the template's
/// file.
#[test]
fn a_template_by_path_is_named_as_the_spec_sees_it() {
    let folder = tempfile::tempdir().expect("a folder");
    let at = |path: &str| folder.path().join(path);
    std::fs::create_dir_all(at("joints/b 2/c")).expect("writable");
    std::fs::create_dir_all(at("own")).expect("writable");
    std::fs::write(at("own/t.yaml"), "x").expect("writable");
    let dots = |path: &str| at("joints").join("..").join(path);
    for (spec, told) in [
        ("joints/b 2/c/s.yaml", "../../../own/t.yaml"),
        ("own/s.yaml", "t.yaml"),
        ("s.yaml", "own/t.yaml"),
    ] {
        // an absolute path is kept; a relative one is converted to the spec's folder
        assert_eq!(seen_from(&at("own/t.yaml"), &at(spec)), at("own/t.yaml").display().to_string());
        let relative = relative_to_here(&dots("own/t.yaml"));
        assert_eq!(seen_from(&relative, &dots(spec)), told, "{spec}");
    }
    assert_eq!(seen_from(Path::new("absent.yaml"), &at("own/s.yaml")), "absent.yaml");
}

/// A path from the working folder up to the root and down again.
fn relative_to_here(path: &Path) -> PathBuf {
    let here =
        std::env::current_dir().expect("a working folder").canonicalize().expect("it exists");
    let up = here.components().skip(1).map(|_| Component::ParentDir);
    up.chain(path.components().skip(1)).collect()
}

#[test]
fn an_existing_file_is_left_alone() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("a.yaml");
    std::fs::write(&path, "mine").expect("writable");
    let e = write_new(&path, "yours").expect_err("it exists");
    assert_eq!((e.first().code, e.exit_code()), ("new/exists", 2));
    assert_eq!(std::fs::read_to_string(&path).expect("readable"), "mine");
    let e = write_new(&folder.path().join("no/a.yaml"), "yours").expect_err("no folder");
    assert_eq!(e.first().code, "new/no-folder");
}
