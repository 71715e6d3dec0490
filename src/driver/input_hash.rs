//! The hash of the input of a result: of everything that its numbers depend on.

use crate::driver::meshing::{Extent, sizes};
use crate::driver::spec_context::own_rows;
use crate::driver::spec_file::SpecFile;
use bracket_base::diag::{Diagnostic, Diagnostics};
use bracket_engine::model::AnalysisKind;
use bracket_joint::geometry::Scene;
use bracket_joint::geometry::geo_script::{Purpose, Sizing, script};
use bracket_report::result::result_file::input_hash;
use serde_json::Value;

/// Hash of the input of a run. `models` are the texts of the model files on the first mesh: they
/// contain the values of the catalogue and the template. The script contains those of the mesher.
pub fn spec_hash(
    input: &SpecFile,
    kinds: &[AnalysisKind],
    extent: Extent,
    models: &[String],
) -> String {
    let scene = Scene::new(&input.joint.assembly, extent.full);
    let asked = &input.spec.value.analysis.mesh;
    let sizes = Sizing::Rule(sizes(asked, kinds, extent.size_factor));
    let geo = script(&scene, Purpose::Mesh { layers: asked.layers, sizes });
    let mut pieces: Vec<(&str, &[u8])> =
        vec![("spec", input.text.as_bytes()), ("geo", geo.as_bytes())];
    pieces.extend(models.iter().map(|m| ("model", m.as_bytes())));
    let own = own_rows(input);
    if !own.is_empty() {
        pieces.push(("catalogue", own.as_bytes()));
    }
    pieces.extend(input.load_table.iter().map(|t| ("loads", t.as_bytes())));
    input_hash(&pieces)
}

/// Hash of the input of the hand checks. The facts as passed to them contain the values of the
/// catalogue and the template.
pub fn checked_hash(input: &SpecFile) -> Result<String, Diagnostics> {
    let fault = |e: serde_json::Error| {
        Diagnostic::environment("cli/check", format!("the joint cannot be written: {e}"))
    };
    // the values without the name of their family
    let mut seen = match serde_json::to_value(&input.joint.facts).map_err(fault)? {
        Value::Object(family) => family.into_iter().next().map_or(Value::Null, |(_, of)| of),
        none => none,
    };
    if !input.catalog.own_tables().is_empty() {
        without_files(&mut seen);
    }
    let seen = seen.to_string();
    let mut pieces: Vec<(&str, &[u8])> =
        vec![("spec", input.text.as_bytes()), ("joint", seen.as_bytes())];
    pieces.extend(input.load_table.iter().map(|t| ("loads", t.as_bytes())));
    Ok(input_hash(&pieces))
}

/// Hash of a model file and its mesh.
pub fn model_hash(text: &str, mesh: &[u8]) -> String {
    input_hash(&[("model", text.as_bytes()), ("mesh", mesh)])
}

/// Removes the paths of tables: the result has copies of the user's tables in another folder.
fn without_files(value: &mut Value) {
    match value {
        Value::Object(keys) => {
            if let Some(Value::Object(source)) = keys.get_mut("source") {
                source.remove("file");
            }
            keys.values_mut().for_each(without_files);
        }
        Value::Array(items) => items.iter_mut().for_each(without_files),
        _ => {}
    }
}
