//! `bracket schema`.

use super::{Common, Outcome};
use crate::diag::{Diagnostic, Diagnostics};
use crate::model::file::ModelFile;
use crate::spec::ConnectionSpec;
use clap::ValueEnum;
use schemars::JsonSchema;
use serde_json::Value;

/// Which input file.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub enum Kind {
    /// SPEC.yaml, for `bracket run`.
    #[default]
    Spec,
    /// MODEL.yaml, for `bracket analyse`.
    Model,
}

/// Print the JSON Schema of an input file.
#[derive(Debug, clap::Args)]
pub struct SchemaArgs {
    /// Which input file.
    #[arg(value_enum, default_value = "spec")]
    pub kind: Kind,
}

/// Runs `bracket schema`.
pub fn run(args: &SchemaArgs, _common: &Common) -> Outcome {
    print!("{}", text(args.kind)?);
    Ok(0)
}

/// The schema as JSON text. Draft-07, which the YAML language servers of editors understand.
pub fn text(kind: Kind) -> Result<String, Diagnostics> {
    fn of<T: JsonSchema>() -> Value {
        schemars::generate::SchemaSettings::draft07().into_generator().into_root_schema_for::<T>().to_value()
    }
    let mut schema = match kind {
        Kind::Spec => of::<ConnectionSpec>(),
        Kind::Model => of::<ModelFile>(),
    };
    plain(&mut schema);
    serde_json::to_string_pretty(&schema).map(|t| t + "\n").map_err(|e| {
        Diagnostic::environment("schema/write", format!("the schema cannot be written as JSON: {e}")).into()
    })
}

/// Doc comments escape square brackets for rustdoc; people who read the schema need them plain.
fn plain(value: &mut Value) {
    match value {
        Value::String(s) if s.contains('\\') && !s.starts_with('^') => *s = s.replace("\\[", "[").replace("\\]", "]"),
        Value::Array(list) => list.iter_mut().for_each(plain),
        Value::Object(map) => map.values_mut().for_each(plain),
        _ => {}
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::path::Path;

    #[test]
    fn committed_schemas_are_fresh() {
        for (kind, name) in [(Kind::Spec, "spec"), (Kind::Model, "model")] {
            let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("schemas/{name}.schema.json"));
            let fresh = text(kind).expect("a schema is JSON");
            if std::env::var_os("BRACKET_WRITE_SCHEMAS").is_some() {
                std::fs::write(&path, &fresh).expect("schemas/ is writable");
            }
            let committed = std::fs::read_to_string(&path).unwrap_or_default();
            assert!(
                committed == fresh,
                "schemas/{name}.schema.json is old: bracket schema {name} > schemas/{name}.schema.json"
            );
        }
    }

    #[test]
    fn schemas_are_draft_07_and_strict() {
        for kind in [Kind::Spec, Kind::Model] {
            let schema: Value = serde_json::from_str(&text(kind).expect("a schema")).expect("JSON");
            assert_eq!(schema["$schema"], "http://json-schema.org/draft-07/schema#");
            assert_eq!(schema["additionalProperties"], false);
        }
    }
}
