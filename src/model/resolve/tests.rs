use super::*;

#[test]
fn reference_joint() {
    for name in ["9k", "33k"] {
        let path = format!("{}/tests/data/paper_quarter_{name}/model.yaml", env!("CARGO_MANIFEST_DIR"));
        let t = std::time::Instant::now();
        let m = load_model(Path::new(&path)).expect("reference model");
        println!("{:?} parts {:?} notes {:?} modes {}", t.elapsed(), m.parts, m.notes, m.free_modes.len());
        for i in &m.interfaces {
            println!("{} {}", i.name, i.faces.len());
        }
    }
}
