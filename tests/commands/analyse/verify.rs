//! `bracket verify` confirms the files that `bracket analyse` wrote, and refutes them after any
//! change.

use super::{MODEL, bench, mesh};
use crate::bench::expect;
use crate::bench::{Bench, Edit};
use bracket::result::fields::vtu::VtuGrid;
use serde_json::{Value, json};

/// A finished result.
fn solved() -> Bench {
    let bench = bench(MODEL);
    expect(&bench, &["analyse", "block.yaml", "-q"], 0);
    bench
}

fn edit_result(bench: &Bench, edit: impl Fn(&mut Value)) {
    let mut result: Value = serde_json::from_str(&bench.read("block/result.json")).expect("JSON");
    edit(&mut result);
    std::fs::write(bench.path().join("block/result.json"), format!("{result:#}\n"))
        .expect("written");
}

/// Changes the largest number of an array of a field file, in place.
fn edit_field(bench: &Bench, name: &str, array: &str, change: impl Fn(f64) -> f64) {
    let path = bench.path().join("block/fields").join(name);
    let mut bytes = std::fs::read(&path).expect("field");
    let grid = VtuGrid::from_bytes(&bytes).expect("our own file");
    let (_, _, values) = grid.point_array(array).unwrap_or_else(|| panic!("no array {array}"));
    let largest =
        values.iter().copied().max_by(|a, b| a.abs().total_cmp(&b.abs())).expect("values");
    // the file stores the arrays as they are in memory
    let at = bytes
        .windows(8)
        .position(|w| w == largest.to_le_bytes())
        .expect("the value stands in the file");
    bytes[at..at + 8].copy_from_slice(&change(largest).to_le_bytes());
    std::fs::write(&path, bytes).expect("written");
}

#[test]
fn an_untouched_result_is_confirmed() {
    let solved = solved();
    let after = |tamper: &dyn Fn(&Bench)| solved.verify_after("block", tamper);
    let (code, text) = after(&|_| {});
    assert_eq!(code, Some(0), "{text}");
    assert_eq!(text.matches("confirmed").count(), 2, "{text}");
    // a folder moved elsewhere is still complete: it contains mesh and model
    let (code, text) = after(&|b| {
        std::fs::rename(b.path().join("block"), b.path().join("moved")).expect("moved");
        std::fs::remove_file(b.path().join("m.msh")).expect("removed");
        std::fs::rename(b.path().join("moved"), b.path().join("block")).expect("moved back");
    });
    assert_eq!(code, Some(0), "{text}");
}

#[test]
fn a_changed_claim_is_refuted() {
    let solved = solved();
    let after = |tamper: &dyn Fn(&Bench)| solved.verify_after("block", tamper);
    for (bound, factor) in
        [("lower", 0.999_999), ("lower", 1.000_001), ("upper", 1.000_001), ("upper", 0.5)]
    {
        let (code, text) = after(&|b| {
            edit_result(b, |r| {
                let value = &mut r["cases"][0][bound];
                *value = (value.as_f64().expect("a bound") * factor).into();
            });
        });
        assert_eq!(code, Some(1), "{bound} × {factor}: {text}");
        assert_eq!(text.matches("REFUTED").count(), 1, "{bound} × {factor}: {text}");
    }
}

#[test]
fn a_changed_load_is_refuted() {
    let solved = solved();
    let after = |tamper: &dyn Fn(&Bench)| solved.verify_after("block", tamper);
    let force = |r: &Value| r["cases"][0]["load"]["force"].as_f64().expect("a force");
    let refuted = |edit: &dyn Fn(&mut Value), code: i32| {
        let (got, text) = after(&|b| edit_result(b, edit));
        assert_eq!(got, Some(code), "{text}");
        assert_eq!(text.contains("load is not what the fields give"), code == 1, "{text}");
    };
    refuted(&|r| r["cases"][0]["load"]["force"] = (1.001 * force(r)).into(), 1);
    refuted(&|r| r["cases"][0]["load"] = serde_json::json!({"moment": force(r)}), 1);
    refuted(&|r| drop(r["cases"][0].as_object_mut().and_then(|c| c.remove("load"))), 1);
}

#[test]
fn a_changed_field_is_refuted() {
    let solved = solved();
    let after = |tamper: &dyn Fn(&Bench)| solved.verify_after("block", tamper);
    for (file, array) in
        [("block_static.vtu", "stress_mandel"), ("block_kinematic.vtu", "displacement")]
    {
        for factor in [1.0001, -1.0] {
            let (code, text) = after(&|b| edit_field(b, file, array, |x| factor * x));
            assert_eq!(code, Some(1), "{file} × {factor}: {text}");
            assert!(text.contains("REFUTED"), "{file} × {factor}: {text}");
        }
        let (code, text) = after(&|b| edit_field(b, file, array, |_| f64::NAN));
        assert!(matches!(code, Some(1 | 2)), "{file} NaN: {text}");
        assert!(!text.contains("  confirmed\n") || text.contains("REFUTED"), "{file} NaN: {text}");
    }
}

#[test]
fn another_mesh_or_model_is_refuted_or_refused() {
    let solved = solved();
    let after = |tamper: &dyn Fn(&Bench)| solved.verify_after("block", tamper);
    // the same connectivity, another height: the fields have the right size but wrong values
    let (code, text) =
        after(&|b| std::fs::write(b.path().join("block/mesh.msh"), mesh(61.0)).expect("written"));
    assert_eq!(code, Some(2), "{text}");
    assert!(text.contains("is not where the mesh has it"), "{text}");
    // a mesh of another size
    let other = crate::common::Block::new([1, 1, 2], [20.0, 20.0, 60.0]);
    let other = bracket::mesh::msh_write::text(&other.mesh(
        &["BASE", "BLOCK"],
        |x| usize::from(x[2] > 30.0),
        |_, _| false,
    ));
    let (code, text) =
        after(&|b| std::fs::write(b.path().join("block/mesh.msh"), &other).expect("written"));
    assert_eq!(code, Some(2), "{text}");
    // softer steel, less friction, another load: the stored fields do not solve that problem or
    // have other energies
    for (old, new) in [("210000", "200000"), ("mu: 0.3", "mu: 0.01"), ("-40", "-41")] {
        let (code, text) = after(&|b| {
            let model = b.read("block/model.yaml");
            assert!(model.contains(old), "{old} in {model}");
            std::fs::write(b.path().join("block/model.yaml"), model.replacen(old, new, 1))
                .expect("written");
        });
        assert_eq!(code, Some(1), "{old} -> {new}: {text}");
    }
}

#[test]
fn what_is_missing_or_torn_is_named() {
    let solved = solved();
    let after = |tamper: &dyn Fn(&Bench)| solved.verify_after("block", tamper);
    for (file, words) in [
        ("result.json", "result.json"),
        ("mesh.msh", "mesh.msh"),
        ("model.yaml", "model.yaml"),
        ("fields/block_static.vtu", "block_static.vtu"),
    ] {
        let (code, text) =
            after(&|b| std::fs::remove_file(b.path().join("block").join(file)).expect("removed"));
        assert_eq!(code, Some(2), "{file}: {text}");
        assert!(text.contains(words) && text.contains("help: "), "{file}: {text}");
        let (code, text) = after(&|b| {
            let path = b.path().join("block").join(file);
            let bytes = std::fs::read(&path).expect("read");
            std::fs::write(&path, &bytes[..bytes.len() / 2]).expect("written");
        });
        assert_eq!(code, Some(2), "half of {file}: {text}");
        assert!(text.contains("help: "), "half of {file}: {text}");
    }
    let bench = Bench::new();
    let (_, err) = expect(&bench, &["verify", "nowhere"], 2);
    assert!(err.contains("nowhere") && err.contains("help: "), "{err}");
}

/// A splice under one moment: bolts, contact between the plates, a stiffness.
const SPLICE: &str = "\
template: beam_splice
members: {beam: {profile: IPE200, steel: S235}}
plate: {thickness: 15, width: 160}
bolts: {size: M16, grade: \"8.8\", rows: [-50, 50]}
friction: {mu: 0.3, law: associated}
loads: [{name: ULS1, end: beam_right, at: bolt_plane, My: 10 kN m}]
analysis: {kind: elastic, max_passes: 1}
";

#[test]
fn stiffness_and_bolt_forces_are_found_again_and_every_change_is_refuted() {
    let bench = Bench::new().file("joint.yaml", SPLICE);
    expect(&bench, &["run", "joint.yaml", "--size-factor", "4", "-q"], 0);
    let (out, _) = expect(&bench, &["verify", "joint"], 0);
    assert!(!out.contains("REFUTED"), "{out}");
    let result: Value = serde_json::from_str(&bench.read("joint/result.json")).expect("JSON");
    let write = |value: &Value| {
        std::fs::write(bench.path().join("joint/result.json"), format!("{value:#}"))
            .expect("written");
    };
    for (pointer, words) in [
        ("/joint_stiffness/lower", "joint_stiffness is not what"),
        ("/joint_stiffness/upper", "joint_stiffness is not what"),
        ("/joint_stiffness/rotation/0", "joint_stiffness is not what"),
        ("/joint_stiffness/moment", "joint_stiffness is not what"),
        ("/static_forces/bolts/0/tension", "the forces of bolt"),
        ("/static_forces/bolts/1/shear", "the forces of bolt"),
        ("/static_forces/contacts/0/compression", "the compression between the parts"),
        ("/static_forces/contacts/0/centre/2", "the compression between the parts"),
        ("/static_forces/load_factor", "the load factor is not that of the stress"),
    ] {
        let mut changed = result.clone();
        let value = changed
            .pointer_mut(&format!("/cases/0{pointer}"))
            .unwrap_or_else(|| panic!("no {pointer}"));
        // a shear that is almost zero beside the tension must be confirmed too
        *value = (value.as_f64().expect("a number") * 1.001 + 1e-3).into();
        write(&changed);
        let (out, _) = expect(bench.sealed("joint"), &["verify", "joint"], 1);
        assert!(out.contains("REFUTED: ULS1") && out.contains(words), "{pointer}: {out}");
    }
    // a bolt under another part, or moved, would have other forces; a bolt left out has none
    let edits: [Edit<'_>; 4] = [
        ("the place of bolt", &|f| f["bolts"][0]["place"]["position"][1] = json!(1.0e3)),
        ("the place of bolt", &|f| f["bolts"][0]["place"]["axis"] = json!([0.0, 0.0, 1.0])),
        ("the bolts are not those", &|f| drop(f["bolts"].as_array_mut().expect("bolts").pop())),
        ("static_forces are missing", &|f| *f = Value::Null),
    ];
    for (words, edit) in edits {
        let mut changed = result.clone();
        edit(&mut changed["cases"][0]["static_forces"]);
        if changed["cases"][0]["static_forces"].is_null() {
            changed["cases"][0].as_object_mut().expect("a case").remove("static_forces");
        }
        write(&changed);
        let (out, _) = expect(bench.sealed("joint"), &["verify", "joint"], 1);
        assert!(out.contains("REFUTED: ULS1") && out.contains(words), "{words}: {out}");
    }
    // the positions of the bolts
    let mut placeless = result.clone();
    for bolt in placeless["cases"][0]["static_forces"]["bolts"].as_array_mut().expect("bolts") {
        bolt.as_object_mut().expect("a bolt").remove("place").expect("its place");
    }
    write(&placeless);
    let (out, _) = expect(bench.sealed("joint"), &["verify", "joint"], 1);
    assert!(out.contains("the place of bolt"), "{out}");
    forgeries_of_what_the_spec_gives(&bench, &result);
}

/// Verdict, demand, checks and model are computed again from the spec; whoever changes one of them
/// and writes the digests again is refuted too.
fn forgeries_of_what_the_spec_gives(bench: &Bench, result: &Value) {
    let case = "/cases/0";
    for (pointer, value, words) in [
        ("/verdict", json!("none"), "verdict is \"none\""),
        ("/judgement/reason", json!("all is well"), "judgement.reason"),
        ("/judgement/governing", Value::Null, "judgement.governing"),
        (&format!("{case}/demand/verdict"), json!("not_ok"), "ULS1: demand.verdict"),
        (&format!("{case}/demand/by_code"), json!("none"), "ULS1: demand.by_code"),
        (&format!("{case}/demand/actions/0/value"), json!({"moment": 1.0e6}), "demand.actions[0]"),
        (&format!("{case}/demand/component_method"), json!([]), "demand.component_method"),
        ("/checks/0/utilisation", json!(0.1), "checks[0].utilisation"),
        ("/checks/3/status", json!("information"), "checks[3].status"),
        ("/checks", json!([]), "checks is"),
        ("/cases", json!([]), "`cases` lacks ULS1"),
        ("/asked", json!([]), "asked"),
    ] {
        let mut forged = result.clone();
        let place = forged.pointer_mut(pointer).unwrap_or_else(|| panic!("no {pointer}"));
        assert_ne!(*place, value, "{pointer}");
        *place = value;
        if pointer == "/judgement/governing" {
            forged["judgement"].as_object_mut().expect("keys").remove("governing");
        }
        let path = bench.path().join("joint/result.json");
        std::fs::write(path, format!("{forged:#}")).expect("written");
        let (out, _) = expect(bench.sealed("joint"), &["verify", "joint"], 1);
        assert!(out.contains("REFUTED: ") && out.contains(words), "{pointer}: {out}");
    }
    std::fs::write(bench.path().join("joint/result.json"), format!("{result:#}")).expect("written");
    expect(bench.sealed("joint"), &["verify", "joint"], 0);
    // a smaller load in the model alone: the bounds would be those of another joint
    let model = bench.read("joint/model.yaml");
    let forged = model.replacen("5000000", "2500000", 1);
    assert_ne!(model, forged, "{model}");
    std::fs::write(bench.path().join("joint/model.yaml"), forged).expect("written");
    let (out, _) = expect(bench.sealed("joint"), &["verify", "joint"], 1);
    assert!(out.contains("model.yaml"), "{out}");
}

/// Every file that the run wrote is bound by its digest.
#[test]
fn every_changed_file_is_refuted_by_its_digest() {
    let bench = Bench::new().file("joint.yaml", SPLICE);
    expect(&bench, &["check", "joint.yaml", "--out", "joint", "-q"], 0);
    let (out, _) = expect(&bench, &["verify", "joint"], 0);
    for words in ["claims no bound", "recomputed: `checks`, demands", "recorded, not recomp"] {
        assert!(out.contains(words), "{words}: {out}");
    }
    // the printed report may be written again
    expect(&bench, &["report", "joint", "--full"], 0);
    expect(&bench, &["verify", "joint"], 0);
    // a file of the user is none of the result's
    std::fs::write(bench.path().join("joint/notes.txt"), "mine").expect("written");
    expect(&bench, &["verify", "joint"], 0);
    let names: Vec<_> = bench.everything().into_iter().filter(|f| !f.1.is_empty()).collect();
    for (name, bytes) in names {
        let name = name.to_string_lossy().into_owned();
        if name == "joint.yaml" || name.ends_with("notes.txt") || name.ends_with("digests.b3") {
            continue;
        }
        let mut forged = bytes.clone();
        // a blank changes no meaning, and is a change
        forged.push(b' ');
        std::fs::write(bench.path().join(&name), &forged).expect("written");
        let (out, _) = expect(&bench, &["verify", "joint"], 1);
        assert!(out.contains("its digest differs"), "{name}: {out}");
        std::fs::write(bench.path().join(&name), bytes).expect("written");
    }
    expect(&bench, &["verify", "joint"], 0);
    std::fs::remove_file(bench.path().join("joint/digests.b3")).expect("removed");
    let (out, _) = expect(&bench, &["verify", "joint"], 1);
    assert!(out.contains("digests.b3 is missing"), "{out}");
}
