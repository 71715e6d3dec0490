//! Results that do not fit their input: the input taken away, cases dropped, another symmetry,
//! another mesh, another model. The digests are written again each time.

use super::forgeries::refuted;
use super::limit_analysis::result;
use super::verdicts::TEMPLATE;
use super::{MODEL, bench};
use crate::bench::Bench;
use crate::bench::expect;
use bracket::mesh::{msh, msh_write};
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

/// The model of a result names a mesh of its own choice: another one in the folder, beside the
/// given one or in place of a refined one, and one outside the folder.
#[test]
fn bounds_on_another_mesh_than_the_given_one_are_refuted() {
    let bench = bench(MODEL);
    expect(&bench, &["analyse", "block.yaml", "-q"], 0);
    // the same bodies and faces, twice as large
    let mut mesh = msh::read(&bench.path().join("m.msh")).expect("a mesh");
    mesh.nodes.iter_mut().flatten().for_each(|x| *x *= 2.0);
    let large = msh_write::text(&mesh);
    std::fs::create_dir(bench.path().join("large")).expect("made");
    write(&bench, "large/block.yaml", MODEL);
    write(&bench, "large/m.msh", &large);
    expect(&bench, &["analyse", "large/block.yaml", "--out", "other", "-q"], 0);
    let energies = |folder: &str| result(&bench, folder)["cases"][0]["lower"].clone();
    assert_ne!(energies("block"), energies("other"), "the mesh is another one");
    let hash = result(&bench, "block")["input_hash"].clone();
    let claim = |f: &str| {
        write(&bench, &format!("{f}/report.json"), &bench.read("block/report.json"));
        edit_json(&bench, &format!("{f}/result.json"), |r| r["input_hash"] = hash.clone());
        write(&bench, &format!("{f}/mesh.msh"), &bench.read("m.msh"));
    };
    let named = |f: &str, mesh: &str| {
        let model = format!("{f}/model.yaml");
        write(&bench, &model, &bench.read(&model).replace("mesh.msh", mesh));
    };
    forged(&bench, "other", "input_hash", |f| {
        claim(f);
        write(&bench, &format!("{f}/m2.msh"), &large);
        named(f, "m2.msh");
    });
    forged(&bench, "other", "digests.b3 does not list ../large/m.msh", |f| {
        claim(f);
        named(f, "../large/m.msh");
    });
    forged(&bench, "block", "the model asks for one", |f| {
        edit_json(&bench, &format!("{f}/result.json"), |r| {
            let row = r["cases"][0]["history"][0].clone();
            r["cases"][0]["history"].as_array_mut().expect("rows").insert(0, row);
        });
    });
    // the same for an adaptive analysis, which ends on a mesh of its own
    let adapt =
        format!("{MODEL}adapt: {{target_gap: 1e-9, max_passes: 2, max_macro_tets: 1000}}\n");
    write(&bench, "block.yaml", &adapt);
    write(&bench, "large/block.yaml", &adapt);
    for (model, out) in [("block.yaml", "block"), ("large/block.yaml", "other")] {
        expect(&bench, &["analyse", model, "--out", out, "-q"], 0);
        let (text, _) = expect(&bench, &["verify", out], 0);
        assert!(text.contains("confirmed"), "{text}");
        assert!(result(&bench, out)["cases"][0]["history"].as_array().expect("rows").len() > 1);
    }
    let hash = result(&bench, "block")["input_hash"].clone();
    forged(&bench, "other", "is not that of the mesh of the input", |f| {
        write(&bench, &format!("{f}/report.json"), &bench.read("block/report.json"));
        write(&bench, &format!("{f}/input/mesh.msh"), &bench.read("m.msh"));
        edit_json(&bench, &format!("{f}/result.json"), |r| r["input_hash"] = hash.clone());
    });
    forged(&bench, "block", "input_hash", |f| {
        write(&bench, &format!("{f}/input/mesh.msh"), &large);
    });
}

/// Keys that read like a claim, and a list of digests that leaves files out.
#[test]
fn what_a_result_does_not_have_is_refuted() {
    let bench = bench(MODEL);
    expect(&bench, &["analyse", "block.yaml", "-q"], 0);
    let key = |words: &str, edit: &dyn Fn(&mut Value)| {
        forged(&bench, "block", words, |f| edit_json(&bench, &format!("{f}/result.json"), edit));
    };
    key("`final_verdict` is no key", &|r| r["final_verdict"] = json!("ok"));
    key("`cases[0].certified` is no key", &|r| r["cases"][0]["certified"] = json!(9.9));
    key("`cases[0].certificate.by` is no key", &|r| {
        r["cases"][0]["certificate"]["by"] = json!({"name": "a checker"});
    });
    let list = bench.read("block/digests.b3");
    for lost in ["model.yaml", "mesh.msh", "report.json", "fields/block_static.vtu"] {
        let kept: Vec<&str> = list.lines().filter(|l| !l.ends_with(&format!("  {lost}"))).collect();
        assert!(kept.len() + 1 == list.lines().count(), "{lost}");
        write(&bench, "block/digests.b3", &format!("{}\n", kept.join("\n")));
        let (out, _) = expect(&bench, &["verify", "block"], 1);
        assert!(out.contains(&format!("digests.b3 does not list {lost}")), "{out}");
    }
    write(&bench, "block/digests.b3", &list);
    expect(&bench, &["verify", "block"], 0);
}

/// Two sections with the same height, width and area: volumes and areas of their joints agree, the
/// bounds of one are not those of the other.
#[test]
fn the_mesh_of_another_section_is_refuted() {
    let head = "name,series,standard,h_mm,b_mm,tw_mm,tf_mm,r_mm,mass_kg_per_m,A_cm2,Iy_cm4,\
                Iz_cm4,Wel_y_cm3,Wpl_y_cm3,Wel_z_cm3,Wpl_z_cm3";
    // h 100, b 60, without fillets: A = 2 b tf + (h - 2 tf) tw = 1200 mm2
    let row = |tf: f64| {
        let (h, b) = (100.0_f64, 60.0_f64);
        let tw = (1200.0 - 2.0 * b * tf) / (h - 2.0 * tf);
        let i_y = (b * h.powi(3) - (b - tw) * (h - 2.0 * tf).powi(3)) / 12.0;
        let i_z = (2.0 * tf * b.powi(3) + (h - 2.0 * tf) * tw.powi(3)) / 12.0;
        let w_pl = b * tf * (h - tf) + tw * (h / 2.0 - tf).powi(2);
        let w_pl_z = tf * b * b / 2.0 + (h - 2.0 * tf) * tw * tw / 4.0;
        format!(
            "{head}\nOWN100,O,own,{h},{b},{tw:.6},{tf},0,9.4,12.0,{:.4},{:.4},{:.4},{:.4},{:.4},\
             {:.4}\n",
            i_y / 1e4,
            i_z / 1e4,
            2e-3 * i_y / h,
            w_pl / 1e3,
            2e-3 * i_z / b,
            w_pl_z / 1e3
        )
    };
    let section = "      - box: {x: [0 mm, 3 * side], y: [-arm.b / 2, arm.b / 2], z: [-arm.h / 2, \
                   -arm.h / 2 + arm.tf]}
      - box: {x: [0 mm, 3 * side], y: [-arm.tw / 2, arm.tw / 2], z: [-arm.h / 2 + arm.tf, arm.h \
                   / 2 - arm.tf]}
      - box: {x: [0 mm, 3 * side], y: [-arm.b / 2, arm.b / 2], z: [arm.h / 2 - arm.tf, arm.h / \
                   2]}\n";
    let solid = TEMPLATE.lines().find(|l| l.contains("- box:")).expect("the arm is a box");
    let template = TEMPLATE
        .replace(&format!("{solid}\n"), section)
        .replace("y: [-side / 2, side / 2]", "y: [-arm.b / 2, arm.b / 2]")
        .replace("z: [-side / 2, side / 2]", "z: [-arm.h / 2, arm.h / 2]");
    let spec = arm(40.0, ULS1).replace("IPE80", "OWN100");
    let bench = Bench::new().file("arm.yaml", template).file("joint.yaml", spec);
    for (name, tf) in [("thin", 4.0), ("thick", 7.0)] {
        std::fs::create_dir(bench.path().join(name)).expect("made");
        write(&bench, &format!("{name}/own.csv"), &row(tf));
        let out = format!("of_{name}");
        let args = ["run", "joint.yaml", "--catalog", name, "--out", &out, "-q"];
        let code = bench.run(&args).status.code().expect("a code");
        assert!(code == 3 || code == 1, "{name}: {code}");
        expect(&bench, &["verify", &out], 0);
    }
    let (thin, thick) = (result(&bench, "of_thin"), result(&bench, "of_thick"));
    assert_ne!(thin["cases"][0]["upper"], thick["cases"][0]["upper"]);
    forged(&bench, "of_thick", "more than 0.01 mm beside that of its dimensions", |f| {
        write(&bench, &format!("{f}/input/catalog/own.csv"), &row(4.0));
    });
}

/// An arm on a wall, with its own template.
fn arm(side: f64, loads: &str) -> String {
    format!(
        "template: ./arm.yaml\nmembers: {{arm: {{profile: IPE80, steel: S235}}}}\nparameters: \
         {{side: {side} mm}}\nloads: [{loads}]\nanalysis: {{kind: limit, decide: false, \
         max_passes: 1}}\n"
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
    // the lower bound alone is no complete route
    expect(&bench, &["run", "thick.yaml", "-q"], 3);
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
