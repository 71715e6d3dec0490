//! Forged results: who changes a value of `result.json` or a derived array of a field file and
//! writes the digests again is refuted, unless the documentation calls the value recorded.

use super::limit_analysis::{BAR, STACK, bar, number, result};
use super::{MODEL, bench, mesh};
use crate::bench::expect;
use crate::bench::{Bench, Edit};
use bracket::driver::verify_folder::{RECORDED, verify_folder};
use bracket::result::fields::vtu::VtuGrid;
use serde_json::{Value, json};

/// Writes the result and the digests of a folder again.
fn forge(bench: &Bench, folder: &str, value: &Value) {
    std::fs::write(bench.path().join(folder).join("result.json"), format!("{value:#}\n"))
        .expect("written");
    bench.sealed(folder);
}

/// `verify` must refute the folder with these words; returns what it says.
pub fn refuted(bench: &Bench, folder: &str, words: &str) -> String {
    let (out, _) = expect(bench.sealed(folder), &["verify", folder], 1);
    assert!(out.contains("REFUTED") && out.contains(words), "`{words}` in\n{out}");
    out
}

/// The pointers of all leaves of a value: numbers, texts, booleans.
fn leaves(value: &Value, at: &str, out: &mut Vec<String>) {
    match value {
        Value::Array(items) => {
            items.iter().enumerate().for_each(|(i, v)| leaves(v, &format!("{at}/{i}"), out));
        }
        Value::Object(keys) => {
            keys.iter().for_each(|(k, v)| leaves(v, &format!("{at}/{k}"), out));
        }
        _ => out.push(at.into()),
    }
}

/// The key of a pointer as the list of recorded keys writes it.
fn key(pointer: &str) -> String {
    let part = |p: &str| match p.parse::<usize>() {
        Ok(_) => "[]".to_string(),
        Err(_) => format!(".{p}"),
    };
    pointer.split('/').skip(1).map(part).collect::<String>().trim_start_matches('.').into()
}

fn is_recorded(pointer: &str) -> bool {
    let key = key(pointer);
    RECORDED.iter().any(|r| {
        key.strip_prefix(r).is_some_and(|rest| rest.is_empty() || rest.starts_with(['.', '[']))
    })
}

/// The changes of a leaf; `None`: it is removed.
fn changes(leaf: &Value) -> Vec<Option<Value>> {
    let mut out = match leaf {
        Value::Number(n) => {
            let x = n.as_f64().expect("a number");
            let by = [1.01 * x, x * (1.0 + 1e-6)].map(|y| Some(json!(y)));
            let next = n.as_u64().map(|n| Some(json!(n + 1)));
            // a zero stays zero
            by.into_iter().filter(|_| x != 0.0).chain(next).collect()
        }
        Value::String(s) => vec![Some(json!(format!("{s}x")))],
        Value::Bool(b) => vec![Some(json!(!b))],
        _ => Vec::new(),
    };
    out.push(None);
    out
}

fn changed(result: &Value, pointer: &str, change: Option<Value>) -> Value {
    let mut forged = result.clone();
    match change {
        Some(value) => *forged.pointer_mut(pointer).expect("the leaf") = value,
        None => {
            let (above, last) = pointer.rsplit_once('/').expect("a pointer");
            match forged.pointer_mut(above).expect("its parent") {
                Value::Array(items) => drop(items.remove(last.parse().expect("an index"))),
                Value::Object(keys) => drop(keys.remove(last)),
                _ => unreachable!("a leaf has no leaves"),
            }
        }
    }
    forged
}

/// Every leaf of the result, changed in every way, is refuted or refused, or it is recorded.
fn every_leaf(bench: &Bench, folder: &str) {
    let honest = result(bench, folder);
    let path = bench.path().join(folder);
    let confirmed = || verify_folder(&path).is_ok_and(|v| v.confirmed());
    forge(bench, folder, &honest);
    assert!(confirmed(), "{:?}", verify_folder(&path).map(|v| v.refuted));
    let mut all = Vec::new();
    leaves(&honest, "", &mut all);
    let mut accepted = Vec::new();
    let proved: Vec<&String> = all.iter().filter(|p| !is_recorded(p)).collect();
    assert!(proved.len() > 25, "{proved:?}");
    for pointer in proved {
        let leaf = honest.pointer(pointer).expect("a leaf");
        for change in changes(leaf) {
            // digits of residuals below 1e-13 are rounding errors
            let residual = pointer.contains("/certificate/");
            let moved =
                |c: &Value| (c.as_f64().unwrap_or(1.0) - leaf.as_f64().unwrap_or(0.0)).abs();
            if residual && change.as_ref().is_some_and(|c| moved(c) <= 1e-13) {
                continue;
            }
            let words = format!("{pointer} {leaf} -> {change:?}");
            forge(bench, folder, &changed(&honest, pointer, change));
            if confirmed() {
                accepted.push(words);
            }
        }
    }
    assert!(accepted.is_empty(), "{} accepted:\n{}", accepted.len(), accepted.join("\n"));
    forge(bench, folder, &honest);
    assert!(confirmed());
}

#[test]
fn every_leaf_of_a_limit_analysis_is_proved_or_recorded() {
    let bench = bar(BAR);
    expect(&bench, &["analyse", "bar.yaml", "-q"], 0);
    every_leaf(&bench, "bar");
}

#[test]
fn every_leaf_of_an_elastic_analysis_with_contact_is_proved_or_recorded() {
    let bench = bench(MODEL);
    expect(&bench, &["analyse", "block.yaml", "-q"], 0);
    every_leaf(&bench, "block");
}

/// Every recorded key stands in the table of the documentation.
#[test]
fn recorded_keys_are_documented() {
    let page = include_str!("../../../docs/results.md");
    for key in RECORDED {
        assert!(page.contains(&format!("`{key}`")), "`{key}` is not in docs/results.md");
    }
}

#[test]
fn histories_with_more_than_the_meshes_prove_are_refuted() {
    let bench = bench(MODEL);
    expect(&bench, &["analyse", "block.yaml", "-q"], 0);
    let honest = result(&bench, "block");
    let edits: [Edit<'_>; 7] = [
        ("stand in an earlier row", &|rows| {
            let mut row = rows[0].clone();
            row["seconds"] = json!(1.0);
            rows.as_array_mut().expect("rows").push(row);
        }),
        // a mesh that nobody has, with tight bounds, before and after the true one
        ("the best bounds of history", &|rows| {
            let mut row = rows[0].clone();
            row["lower"] = json!(number(&row["upper"]) * (1.0 + 1e-6));
            rows.as_array_mut().expect("rows").insert(0, row);
        }),
        ("so_far does not have", &|rows| {
            let mut row = rows[0].clone();
            row["so_far"]["lower"] = row["upper"].clone();
            rows.as_array_mut().expect("rows").push(row);
        }),
        ("sizes of their mesh", &|rows| rows[0]["macro_tets"] = json!(100_000)),
        ("sizes of their mesh", &|rows| rows[0]["static_dofs"] = json!(100_000)),
        // a program without a bound would no longer stand against the result
        ("a program that the model asks for", &|rows| {
            let row = rows[0].as_object_mut().expect("a row");
            ["static", "static_dofs"].iter().for_each(|key| drop(row.remove(*key)));
        }),
        ("no row of history", &|rows| *rows = json!([])),
    ];
    for (words, edit) in edits {
        let mut forged = honest.clone();
        edit(&mut forged["cases"][0]["history"]);
        forge(&bench, "block", &forged);
        refuted(&bench, "block", words);
    }
    // a bound taken away with its place in the history: its field is there
    for (bound, kept) in [("lower", "upper"), ("upper", "lower")] {
        let mut forged = honest.clone();
        let case = forged["cases"][0].as_object_mut().expect("a case");
        ["gap", bound, "load_displacement"].iter().for_each(|key| drop(case.remove(*key)));
        let row = case["history"][0].as_object_mut().expect("a row");
        ["gap", bound].iter().for_each(|key| drop(row.remove(*key)));
        let far = row["so_far"].as_object_mut().expect("keys");
        ["gap", bound].iter().for_each(|key| drop(far.remove(*key)));
        assert!(case.contains_key(kept));
        forge(&bench, "block", &forged);
        refuted(&bench, "block", "the presence of lower or upper");
    }
}

/// With friction, the bound without it decides a verdict: it cannot be taken away, nor be changed.
#[test]
fn the_bound_without_friction_stays() {
    let mesh = mesh(60.0);
    let bench = Bench::new().file("stack.yaml", STACK).file("m.msh", mesh);
    expect(&bench, &["analyse", "stack.yaml", "-q"], 0);
    let honest = result(&bench, "stack");
    assert!(honest["cases"][0]["frictionless"]["lower"].is_f64(), "{honest}");
    for change in [None, Some(json!({"lower": 1.0}))] {
        forge(&bench, "stack", &changed(&honest, "/cases/0/frictionless", change));
        refuted(&bench, "stack", "frictionless");
    }
    let run = "/cases/0/history/0/static_frictionless";
    assert!(honest.pointer(run).is_some(), "{honest}");
    forge(&bench, "stack", &changed(&honest, run, None));
    refuted(&bench, "stack", "the program behind the bound without friction");
    forge(&bench, "stack", &honest);
    expect(&bench, &["verify", "stack"], 0);
}

/// Changes the largest number of an array of a field file in place.
fn edit_array(bench: &Bench, file: &str, array: &str) {
    let path = bench.path().join(file);
    let bytes = std::fs::read(&path).expect("field");
    let mut grid = VtuGrid::from_bytes(&bytes).expect("our own file");
    let arrays = grid.point_data.iter_mut().chain(&mut grid.cell_data).chain(&mut grid.field_data);
    let values = arrays.into_iter().find(|a| a.0 == array);
    let values = &mut values.unwrap_or_else(|| panic!("no array {array}")).2;
    let largest = (0..values.len()).max_by(|&i, &k| values[i].abs().total_cmp(&values[k].abs()));
    let largest = largest.expect("values");
    values[largest] = 1.001 * values[largest] + 1e-3;
    std::fs::write(&path, grid.to_bytes().expect("writes")).expect("written");
}

#[test]
fn derived_arrays_of_field_files_are_those_of_their_fields() {
    let elastic = bench(MODEL);
    expect(&elastic, &["analyse", "block.yaml", "-q"], 0);
    let limit = bar(BAR);
    expect(&limit, &["analyse", "bar.yaml", "-q"], 0);
    let plastic =
        bench(&MODEL.replace("elastic", "elastoplastic").replace("0.3}}", "0.3, fy: 60}}"));
    expect(&plastic, &["analyse", "block.yaml", "-q"], 0);
    for (bench, file, array) in [
        (&elastic, "block/fields/block_static.vtu", "von_mises_MPa"),
        (&elastic, "block/fields/block_static.vtu", "body"),
        (&elastic, "block/fields/block_kinematic.vtu", "gap_contribution_N_mm"),
        (&limit, "bar/fields/bar_static.vtu", "utilisation"),
        (&limit, "bar/fields/bar_kinematic.vtu", "dissipation_density"),
        (&plastic, "block/fields/block_kinematic.vtu", "equivalent_plastic_strain"),
        (&plastic, "block/fields/block_kinematic.vtu", "gap_contribution_N_mm"),
    ] {
        let honest = std::fs::read(bench.path().join(file)).expect("field");
        edit_array(bench, file, array);
        let folder = file.split('/').next().expect("a folder");
        refuted(bench, folder, &format!("array `{array}`"));
        std::fs::write(bench.path().join(file), honest).expect("written");
        expect(bench.sealed(folder), &["verify", folder], 0);
    }
}
