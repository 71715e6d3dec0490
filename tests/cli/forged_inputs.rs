//! Results that do not fit their input: the input taken away, cases dropped, another symmetry,
//! another mesh, another model. The digests are written again each time.

use crate::bench::Bench;
use crate::forgeries::refuted;
use crate::limit_analysis::result;
use crate::verdicts::TEMPLATE;
use crate::{MODEL, bench, expect};
use serde_json::{Value, json};

fn write(bench: &Bench, file: &str, text: &str) {
    std::fs::write(bench.path().join(file), text).expect("written");
}

fn edit_json(bench: &Bench, file: &str, edit: impl Fn(&mut Value)) {
    let mut value: Value = serde_json::from_str(&bench.read(file)).expect("JSON");
    edit(&mut value);
    write(bench, file, &format!("{value:#}\n"));
}

/// Runs `forge` on a copy of the folder `from`, which `verify` must then refute with these words.
fn forged(bench: &Bench, from: &str, words: &str, forge: impl Fn(&str)) {
    let copy = bench.path().join("copy");
    let _ = std::fs::remove_dir_all(&copy);
    for (name, bytes) in bench.everything() {
        let Ok(rest) = name.strip_prefix(from) else { continue };
        let path = copy.join(rest);
        if bench.path().join(&name).is_dir() {
            std::fs::create_dir_all(path).expect("made");
        } else {
            std::fs::write(path, bytes).expect("written");
        }
    }
    forge("copy");
    refuted(bench, "copy", words);
}

fn remove(bench: &Bench, file: &str) {
    std::fs::remove_file(bench.path().join(file)).expect("removed");
}

#[test]
fn a_model_result_without_its_input_or_its_case_is_refuted() {
    let bench = bench(MODEL);
    expect(&bench, &["analyse", "block.yaml", "-q"], 0);
    let run = |words: &str, forge: &dyn Fn(&str)| forged(&bench, "block", words, forge);
    run("the input cannot be read", &|f| remove(&bench, &format!("{f}/report.json")));
    run("the input cannot be read", &|f| write(&bench, &format!("{f}/report.json"), "{}"));
    run("the input cannot be read", &|f| {
        edit_json(&bench, &format!("{f}/report.json"), |r| r["input_text"] = json!("\n"));
    });
    let without_cases = |f: &str| {
        edit_json(&bench, &format!("{f}/result.json"), |r| {
            r["cases"] = json!([]);
            r.as_object_mut().expect("keys").remove("asked").expect("was there");
        });
        remove(&bench, &format!("{f}/model.yaml"));
    };
    run("one entry in `asked` and one in `cases`", &without_cases);
    run("asked and name", &|f| {
        let to = |end: &str| format!("{f}/fields/other_{end}.vtu");
        for end in ["static", "kinematic"] {
            let from = bench.path().join(format!("{f}/fields/block_{end}.vtu"));
            std::fs::rename(from, bench.path().join(to(end))).expect("moved");
        }
        edit_json(&bench, &format!("{f}/result.json"), |r| {
            (r["cases"][0]["name"], r["asked"][0]) = (json!("other"), json!("other"));
        });
    });
    run("input_hash", &|f| {
        edit_json(&bench, &format!("{f}/result.json"), |r| r["input_hash"] = json!("0"));
    });
    // the result of a smaller load, presented as that of the model
    let weaker = MODEL.replace("[2, 0, -40]", "[1, 0, -20]");
    std::fs::create_dir(bench.path().join("weak")).expect("made");
    write(&bench, "weak/block.yaml", &weaker);
    write(&bench, "weak/m.msh", &bench.read("m.msh"));
    expect(&bench, &["analyse", "weak/block.yaml", "--out", "other", "-q"], 0);
    forged(&bench, "other", "model.yaml.loads[0]", |f| {
        write(&bench, &format!("{f}/report.json"), &bench.read("block/report.json"));
        let hash = result(&bench, "block")["input_hash"].clone();
        edit_json(&bench, &format!("{f}/result.json"), |r| r["input_hash"] = hash.clone());
    });
}

/// An arm on a wall, with its own template.
fn arm(side: f64, loads: &str) -> String {
    format!(
        "template: ./arm.yaml\nmembers: {{arm: {{profile: IPE80, steel: S235}}}}\nparameters: \
         {{side: {side} mm}}\nloads: [{loads}]\nanalysis: {{kind: limit, max_passes: 1}}\n"
    )
}

const ULS1: &str = "{name: ULS1, end: tip, at: node, My: 0.3 kN m}";
const ULS2: &str = "{name: ULS2, end: tip, at: node, My: 0.8 kN m}";

#[test]
fn a_result_that_is_not_of_its_joint_is_refuted() {
    let bench = Bench::new()
        .file("arm.yaml", TEMPLATE)
        .file("joint.yaml", arm(20.0, &format!("{ULS1}, {ULS2}")))
        .file("thick.yaml", arm(30.0, &format!("{ULS1}, {ULS2}")));
    // the second load is too large
    expect(&bench, &["run", "joint.yaml", "-q"], 1);
    expect(&bench, &["run", "thick.yaml", "-q"], 0);
    let run = |from: &str, words: &str, forge: &dyn Fn(&str)| forged(&bench, from, words, forge);
    let of =
        |f: &str, edit: &dyn Fn(&mut Value)| edit_json(&bench, &format!("{f}/result.json"), edit);
    // moved elsewhere, the folder still has its template
    std::fs::rename(bench.path().join("arm.yaml"), bench.path().join("gone.yaml")).expect("moved");
    let (out, _) = expect(&bench, &["verify", "joint"], 0);
    assert!(out.contains("recomputed: the models, `checks`"), "{out}");
    run("joint", "the input cannot be read", &|f| {
        std::fs::remove_dir_all(bench.path().join(f).join("input")).expect("removed");
    });
    // the case that fails is dropped
    run("joint", "asked is", &|f| {
        of(f, &|r| {
            r["cases"].as_array_mut().expect("cases").pop();
            r["asked"].as_array_mut().expect("names").pop();
            r["verdict"] = json!("ok");
        });
    });
    run("joint", "no warning says why", &|f| {
        of(f, &|r| drop(r["cases"].as_array_mut().expect("cases").pop()));
    });
    // twice as many copies, in the models too
    let copies = result(&bench, "joint")["symmetry"].as_u64().expect("a number");
    run("joint", "symmetry is", &|f| {
        of(f, &|r| r["symmetry"] = json!(2 * copies));
        for model in ["model.yaml", "model_ULS2.yaml"] {
            let file = format!("{f}/{model}");
            let text = bench.read(&file);
            let bare = text.replace(&format!("symmetry: {copies}\n"), "");
            write(&bench, &file, &format!("{bare}symmetry: {}\n", 2 * copies));
        }
    });
    // the bounds of a thicker arm
    run("thick", "mesh.msh: ", &|f| {
        write(&bench, &format!("{f}/report.json"), &bench.read("joint/report.json"));
        let hash = result(&bench, "joint")["input_hash"].clone();
        of(f, &|r| r["input_hash"] = hash.clone());
    });
    run("joint", "input_hash", &|f| of(f, &|r| r["input_hash"] = json!("0")));
    run("joint", "judgement", &|f| of(f, &|r| r["judgement"]["reason"] = json!("well")));
    expect(&bench, &["verify", "thick"], 0);
}

/// Tables of `--catalog` are stored with the result; without them it is refuted.
#[test]
fn own_tables_are_stored_with_the_result() {
    let table = "grade,fyb_MPa,fub_MPa,alpha_v_threads_in_shear_plane,\
                 alpha_v_shank_in_shear_plane,preloadable\nMY8.8,640,800,0.6,0.6,yes\n";
    let spec = crate::bench::JOINT.replace("\"8.8\"", "MY8.8");
    let bench = Bench::new().file("joint.yaml", spec);
    std::fs::create_dir(bench.path().join("mine")).expect("made");
    write(&bench, "mine/grades.csv", table);
    let out = bench.run(&["check", "joint.yaml", "--catalog", "mine", "--out", "joint", "-q"]);
    let code = out.status.code().expect("a code");
    assert!(code == 0 || code == 1, "{}", String::from_utf8_lossy(&out.stderr));
    assert_eq!(bench.read("joint/input/catalog/grades.csv"), table);
    std::fs::remove_dir_all(bench.path().join("mine")).expect("removed");
    expect(&bench, &["verify", "joint"], 0);
    // a stronger bolt in the table gives other checks
    forged(&bench, "joint", "REFUTED", |f| {
        write(&bench, &format!("{f}/input/catalog/grades.csv"), &table.replace("800", "1000"));
    });
    forged(&bench, "joint", "the input cannot be read", |f| {
        std::fs::remove_dir_all(bench.path().join(f).join("input")).expect("removed");
    });
}
