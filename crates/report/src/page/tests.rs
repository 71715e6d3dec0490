use super::*;
use crate::document::picture::PictureRef;
use crate::draw::options::Colours;
use crate::markdown::report_data::ReportData;
use crate::page::scene::{Field, Values};
use crate::sheet::Extent;
use crate::sheet::build::sheet;
use crate::sheet::head::Paper;
use bracket_engine::mesh::TetMesh;

const HOSTILE: &str = "<script>alert(1)</script> \"& '#eval' \u{202e}right\u{7}";

fn data() -> ReportData {
    let text = r#"{"project": [["title", "T"], ["number", "N"]], "input_name": "a.yaml",
        "input_text": "t: \"<i>\"\n", "input_read": "", "resolved": [], "demands": [],
        "catalogue_rows": [], "drawings": [], "schedule": {"columns": [], "rows": []},
        "pictures": [], "mesh_quality": {"columns": [], "rows": []}, "model": {"contact": false,
        "friction": false, "coulomb": false, "initial_gap": false, "preload": false,
        "facets": false, "symmetry": false}, "assumptions": [], "notes": []}"#;
    serde_json::from_str(text).expect("data of a report")
}

fn text(data: &ReportData, scene: &Scene) -> String {
    let picture = |name: &str| (name == "drawing.svg").then(|| b"foo".to_vec());
    let words = data.words();
    let sheet = sheet(data, &words, Extent::Full, Paper::A4);
    page(&sheet, scene, &words, picture).expect("page")
}

#[test]
fn texts_of_the_user_stay_text_and_pictures_are_inside() {
    let mut data = data();
    data.input.project.iter_mut().for_each(|l| l.1 = HOSTILE.into());
    data.input.drawings = ["drawing.svg", "gone.svg"]
        .map(|file| PictureRef {
            file: file.into(),
            caption: HOSTILE.into(),
            ..PictureRef::default()
        })
        .to_vec();
    data.input.text = HOSTILE.into();
    let mut scene = Scene::new(&[]);
    let mesh = TetMesh {
        nodes: vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
        tets: vec![[0, 1, 2, 3]],
        tet_body: vec![0],
        bodies: vec![HOSTILE.into()],
        ..TetMesh::default()
    };
    scene.add(HOSTILE, &mesh, &[None], Vec::new());
    let page = text(&data, &scene);
    for words in [
        "<title>&lt;script&gt;alert(1)&lt;/script&gt; &quot;&amp; &#39;#eval&#39;",
        "<img src=\"data:image/svg+xml;base64,Zm9v\" alt=\"&lt;script&gt;",
        "<dt>project number</dt><dd dir=\"auto\">&lt;script&gt;",
        "\"name\":\"\\u003cscript>alert(1)\\u003c/script> \\\"&",
    ] {
        assert!(page.contains(words), "{words}: {page}");
    }
    assert!(!page.contains("<script>alert") && !page.contains("gone.svg"));
    // the scene and the program, and nothing from elsewhere
    assert_eq!(page.matches("</script>").count(), 2);
    assert!(!page.contains("http://") && !page.contains("https://"));
    assert!(!text(&data, &Scene::new(&[])).contains("data-is=\"canvas\""));
}

/// Reads the numbers of a page back.
fn steps(packed: &serde_json::Value) -> Vec<f64> {
    const DIGITS: &str = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let text = packed["steps"].as_str().expect("text").trim_end_matches('=');
    let bits: Vec<u8> = text
        .chars()
        .flat_map(|c| {
            let digit = DIGITS.find(c).expect("a digit") as u8;
            (0..6).rev().map(move |b| digit >> b & 1)
        })
        .collect();
    let bytes: Vec<u8> = bits.chunks_exact(8).map(|b| b.iter().fold(0, |x, b| 2 * x + b)).collect();
    let [low, high] = ["low", "high"].map(|k| packed[k].as_f64().expect("number"));
    let number =
        |b: &[u8]| low + (high - low) / 65535.0 * f64::from(u16::from_le_bytes([b[0], b[1]]));
    bytes.chunks_exact(2).map(number).collect()
}

/// Tetrahedra are sorted by their parts, and the values at their corners with them.
#[test]
fn fields_follow_their_tetrahedra() {
    let mesh = TetMesh {
        nodes: (0..8).map(|i| [f64::from(i), f64::from(i * i), 1.0]).collect(),
        tets: vec![[0, 1, 2, 3], [4, 5, 6, 7], [1, 2, 3, 4]],
        tet_body: vec![1, 0, 1],
        bodies: vec!["BOLT_1".into(), "PLATE".into()],
        ..TetMesh::default()
    };
    let values: Vec<f64> = (0..12).map(f64::from).collect();
    let field = Field {
        title: "stress".into(),
        unit: "MPa",
        values: Values::Corners(values),
        colours: Colours::Fire,
        shown: None,
        motion: Some(&mesh.nodes),
    };
    let mut scene = Scene::new(&[0]);
    scene.add("A", &mesh, &[Some(900.0), Some(235.0)], vec![field.clone()]);
    scene.add("B", &mesh, &[Some(900.0), Some(235.0)], vec![field]);
    let json = serde_json::to_value(&scene).expect("JSON");
    assert_eq!(json["shapes"].as_array().expect("shapes").len(), 1);
    assert_eq!(json["shapes"][0]["parts"], serde_json::json!([[0, 1], [1, 2]]));
    assert_eq!(json["parts"][1]["fy"], 235.0);
    let near = |found: &[f64], wanted: &[f64]| {
        assert_eq!(found.len(), wanted.len());
        let most = wanted.iter().fold(0.0f64, |m, x| m.max(x.abs()));
        for (a, b) in found.iter().zip(wanted) {
            assert!((a - b).abs() <= 1e-5 * most, "{found:?} {wanted:?}");
        }
    };
    let order = [4.0, 5.0, 6.0, 7.0, 0.0, 1.0, 2.0, 3.0, 8.0, 9.0, 10.0, 11.0];
    near(&steps(&json["views"][1]["values"]), &order);
    let points: Vec<f64> = mesh.nodes.iter().flatten().copied().collect();
    near(&steps(&json["shapes"][0]["points"]), &points);
    near(&steps(&json["views"][0]["motion"]), &points);
}

/// A page that would become too large leaves cases out and names them.
#[test]
fn a_large_page_names_what_it_leaves_out() {
    let mut scene = Scene::new(&[]);
    for case in 0..4 {
        let nodes: Vec<[f64; 3]> =
            (0..200_000).map(|i| [f64::from(i), f64::from(case), 0.0]).collect();
        let mesh = TetMesh {
            tets: vec![[0, 1, 2, 3]],
            tet_body: vec![0],
            bodies: vec!["A".into()],
            nodes: nodes.clone(),
            ..TetMesh::default()
        };
        let field = Field {
            title: "x".into(),
            unit: "",
            values: Values::Nodes(vec![0.0; nodes.len()]),
            colours: Colours::Fire,
            shown: None,
            motion: None,
        };
        scene.add(&format!("case {case}"), &mesh, &[None], vec![field]);
    }
    assert_eq!(scene.left_out, ["case 1", "case 2", "case 3"]);
    assert_eq!((scene.shapes.len(), scene.views.len()), (1, 1));
}
