//! What each fuzz target does with its bytes. Every reader must end with a value or an error, never
//! with a panic. What it accepts must keep a property that a second look can test.

use bracket::assembly::template_file;
use bracket::batch::sweep_file::SweepFile;
use bracket::catalog::Catalog;
use bracket::driver::spec_file;
use bracket::mesh::{msh, msh_write};
use bracket::model::file::ModelFile;
use bracket::model::resolve::resolve;
use bracket::result::fields::vtu::VtuGrid;
use bracket::spec::expr::{Expr, Value};
use bracket::yaml;
use bracket::units::{Dim, Quantity};
use std::path::Path;

/// A spec: parsed, its template evaluated, its joint built.
pub fn spec(data: &[u8]) {
    let Ok(folder) = tempfile::tempdir() else { return };
    let file = folder.path().join("joint.yaml");
    if std::fs::write(&file, data).is_err() {
        return;
    }
    if let Ok(read) = spec_file::read(&file, None) {
        assert!(!read.joint.assembly.parts.is_empty(), "a joint without a part");
    }
}

/// An expression of a template, with three names that have values.
pub fn expression(data: &[u8]) {
    let Ok(text) = std::str::from_utf8(data) else { return };
    let Ok(expression) = Expr::parse(text) else { return };
    let mut lookup = |name: &str| match name {
        "plate.thickness" => Ok(Value::Quantity(Quantity { value: 15.0, dim: Dim::LENGTH })),
        "n" => Ok(Value::Quantity(Quantity { value: 3.0, dim: Dim::NONE })),
        "flag" => Ok(Value::Truth(true)),
        _ => Err("unknown".to_string()),
    };
    let once = expression.eval(&mut lookup);
    // the same text has the same value
    let again = Expr::parse(expression.text()).map(|e| e.eval(&mut lookup));
    assert_eq!(format!("{:?}", Ok::<_, ()>(once)), format!("{:?}", again.map_err(|_| ())));
}

/// A template, and the starter spec built with it.
pub fn template(data: &[u8]) {
    let Ok(folder) = tempfile::tempdir() else { return };
    let file = folder.path().join("own.yaml");
    if std::fs::write(&file, data).is_err() || template_file::load("./own.yaml", folder.path()).is_err()
    {
        return;
    }
    let spec = "template: ./own.yaml\nmembers: {column: {profile: HEB200, steel: S235}, beam: {profile: \
                IPE300, steel: S235}}\nplate: {thickness: 15, z: [-165, 230]}\nbolts: {size: M20, grade: \
                \"8.8\", rows: [-90, 90, 190]}\nloads: [{name: A, end: beam_right, My: 10 kN m}]\n";
    let joint = folder.path().join("joint.yaml");
    if std::fs::write(&joint, spec).is_ok() {
        let _ = spec_file::read(&joint, None);
    }
}

/// A model file, resolved on the mesh of two cubes.
pub fn model(data: &[u8]) {
    let Ok(text) = std::str::from_utf8(data) else { return };
    let Ok(file) = yaml::parse::<ModelFile>(text, Path::new("model.yaml")) else { return };
    let cubes = include_bytes!("../seeds/msh/two_cubes.msh");
    let Ok((mesh, _)) = msh::parse(cubes, Path::new("two_cubes.msh")) else { return };
    if let Ok(model) = resolve(&file.value, mesh, &|path| file.index.place(path)) {
        assert_eq!(model.body_material.len(), model.mesh.bodies.len(), "a body without a material");
    }
}

/// A mesh: what is read is written and read again unchanged.
pub fn msh(data: &[u8]) {
    let Ok((mesh, _)) = msh::parse(data, Path::new("m.msh")) else { return };
    assert!((0..mesh.tets.len()).all(|e| mesh.volume(e) > 0.0), "a tet without volume");
    let text = msh_write::text(&mesh);
    let again = msh::parse(text.as_bytes(), Path::new("again.msh"));
    let (again, _) = again.expect("a mesh that the program wrote is read");
    assert_eq!(again.tets.len(), mesh.tets.len());
}

/// A field file: what is read is written and read again unchanged.
pub fn vtu(data: &[u8]) {
    let Ok(grid) = VtuGrid::from_bytes(data) else { return };
    if let Ok(bytes) = grid.to_bytes() {
        let again = VtuGrid::from_bytes(&bytes).expect("a file that the program wrote is read");
        assert_eq!(again.to_bytes().ok(), Some(bytes));
    }
}

/// A catalogue table of the user.
pub fn csv(data: &[u8]) {
    let Ok(folder) = tempfile::tempdir() else { return };
    if std::fs::write(folder.path().join("own.csv"), data).is_ok() {
        if let Ok(catalog) = Catalog::with_dir(folder.path()) {
            assert!(!catalog.profiles().is_empty(), "the built-in rows are gone");
        }
    }
}

/// A sweep with its base spec inline.
pub fn sweep(data: &[u8]) {
    let Ok(folder) = tempfile::tempdir() else { return };
    let file = folder.path().join("sweep.yaml");
    if std::fs::write(&file, data).is_err() {
        return;
    }
    let Ok(sweep) = SweepFile::read(&file, None) else { return };
    let Some(count) = sweep.expansion.count() else { return };
    for index in [0, count / 2, count.saturating_sub(1)] {
        if index < count {
            let _ = sweep.expansion.varied(index);
            assert!(!sweep.expansion.name(index).is_empty(), "a case without a name");
        }
    }
}
