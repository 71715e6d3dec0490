//! `bracket schema`.

use super::common::{CommandResult, Common};
use crate::batch::sweep::Sweep;
use bracket_base::diag::{Diagnostic, Diagnostics, ExitStatus};
use bracket_base::yaml::REST;
use bracket_engine::model::file::ModelFile;
use bracket_joint::assembly::template::{Parameter, ParameterKind, Template};
use bracket_joint::assembly::template_file::{self, SHIPPED};
use bracket_joint::spec::ConnectionSpec;
use bracket_report::console::out;
use clap::ValueEnum;
use schemars::JsonSchema;
use serde_json::{Value, json};
use std::path::Path;

/// Which input file.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub enum Kind {
    /// SPEC.yaml, for `bracket run`.
    #[default]
    Spec,
    /// MODEL.yaml, for `bracket analyse`.
    Model,
    /// SWEEP.yaml, for `bracket batch`.
    Batch,
    /// A connection template of your own, for `template: ./FILE.yaml` of a spec.
    Template,
}

/// Print the JSON Schema of an input file.
#[derive(Debug, clap::Args)]
pub struct SchemaArgs {
    /// Which input file.
    #[arg(value_enum, default_value = "spec")]
    pub kind: Kind,
}

/// Runs `bracket schema`.
pub fn run(args: &SchemaArgs, _common: &Common) -> CommandResult {
    out::data(&text(args.kind)?)?;
    Ok(ExitStatus::Ok)
}

/// The schema as JSON text. It is draft-07, because the YAML language servers of editors support
/// it.
pub fn text(kind: Kind) -> Result<String, Diagnostics> {
    fn of<T: JsonSchema>() -> Value {
        schemars::generate::SchemaSettings::draft07()
            .into_generator()
            .into_root_schema_for::<T>()
            .to_value()
    }
    let mut schema = match kind {
        Kind::Spec => with_templates(of::<ConnectionSpec>())?,
        Kind::Model => of::<ModelFile>(),
        Kind::Batch => of::<Sweep>(),
        Kind::Template => with_extending(of::<Template>()),
    };
    plain(&mut schema);
    serde_json::to_string_pretty(&schema).map(|t| t + "\n").map_err(|e| {
        Diagnostic::environment(
            "schema/write",
            format!("the schema cannot be written as JSON: {e}"),
        )
        .into()
    })
}

/// Keys of a spec that may be left empty.
const EMPTY: [&str; 7] =
    ["project", "code", "members", "parameters", "friction", "loads", "analysis"];

/// The schema of a spec, with the members and parameters of each shipped template where the spec
/// names it.
fn with_templates(mut schema: Value) -> Result<Value, Diagnostics> {
    for key in EMPTY {
        let property = &mut schema["properties"][key];
        let mut filled = property.take();
        let about = filled.as_object_mut().and_then(|f| f.remove("description"));
        *property = json!({"anyOf": [filled, {"type": "null"}]});
        property["description"] = about.unwrap_or_default();
    }
    let mut each = Vec::new();
    for (name, _) in SHIPPED {
        let (template, _) = template_file::load(name, Path::new("."))?;
        let mut parameters = serde_json::Map::new();
        for p in template.parameters.iter().filter(|p| !p.name.contains('.')) {
            parameters.insert(p.name.clone(), parameter(p));
        }
        let members = template.members.iter().map(|m| {
            let member = json!({
                "description": m.about,
                "allOf": [{"$ref": "#/definitions/MemberSpec"}],
            });
            (m.role.clone(), member)
        });
        let members: serde_json::Map<String, Value> = members.collect();
        let only = |properties: serde_json::Map<String, Value>| {
            json!({
                "type": ["object", "null"],
                "properties": properties,
                "additionalProperties": false,
            })
        };
        each.push(json!({
            "if": {"properties": {"template": {"const": name}}, "required": ["template"]},
            "then": {"properties": {"parameters": only(parameters), "members": only(members)}},
        }));
    }
    schema["allOf"] = Value::Array(each);
    Ok(schema)
}

/// The schema of a parameter of a template.
fn parameter(p: &Parameter) -> Value {
    let mut about = p.about.clone();
    if let Some(default) = &p.default {
        about += &format!("; default: {}", default.text());
    }
    let mut schema = match p.kind {
        ParameterKind::Length => json!({"$ref": "#/definitions/Length"}),
        ParameterKind::Number => json!({"type": "number"}),
        ParameterKind::Angle => json!({
            "type": "string",
            "pattern": "^[-+−]?[0-9.]+([eE][-+]?[0-9]+)? *(deg|rad)$",
        }),
        ParameterKind::Flag => json!({"type": "boolean"}),
        ParameterKind::Lengths => {
            json!({"type": "array", "items": {"$ref": "#/definitions/Length"}})
        }
    };
    if schema.get("$ref").is_some() {
        // beside a reference draft-07 ignores all keys
        schema = json!({"allOf": [schema]});
    }
    schema["description"] = Value::String(about);
    schema
}

/// The entries of `hand_checks`, by family.
const FAMILIES: [&str; 4] =
    ["EndPlateEntry", "SimpleJointEntry", "CoverSpliceEntry", "ColumnBaseEntry"];

/// The schema of a template, or of a template that extends another one. In the latter every key
/// except `extends` may be left out, and in the entries of lists every key except the name.
fn with_extending(whole: Value) -> Value {
    let mut root = whole;
    let mut definitions = root["definitions"].take();
    let mut head = serde_json::Map::new();
    let mut template = serde_json::Map::new();
    for (key, value) in root.as_object_mut().map(std::mem::take).into_iter().flatten() {
        match key.as_str() {
            "definitions" => {}
            "$schema" | "title" => drop(head.insert(key, value)),
            _ => drop(template.insert(key, value)),
        }
    }
    let mut extending = template.clone();
    extending.insert("required".into(), json!(["extends"]));
    for property in extending["properties"].as_object_mut().into_iter().flat_map(|p| p.values_mut())
    {
        if let Some(entry) = property.pointer("/items/$ref").and_then(Value::as_str) {
            let entry = part_of(entry, &mut definitions);
            property["items"] = json!({"anyOf": [{"const": REST}, {"$ref": entry}]});
        }
    }
    let families = FAMILIES.map(
        |family| json!({"$ref": part_of(&format!("#/definitions/{family}"), &mut definitions)}),
    );
    extending["properties"]["hand_checks"] = json!({"anyOf": families});
    definitions["Template"] = Value::Object(template);
    definitions["ExtendingTemplate"] = Value::Object(extending);
    head.insert(
        "anyOf".into(),
        json!([
            {"$ref": "#/definitions/Template"},
            {"$ref": "#/definitions/ExtendingTemplate"},
        ]),
    );
    head.insert("definitions".into(), definitions);
    Value::Object(head)
}

/// Adds the definition of a partial entry, which takes the keys it leaves out from the entry with
/// its name, and returns the reference. An entry without a name must be complete.
fn part_of(entry: &str, definitions: &mut Value) -> String {
    let name = entry.trim_start_matches("#/definitions/");
    let mut part = definitions[name].clone();
    let named = ["name", "role"].into_iter().find(|k| !part["properties"][*k].is_null());
    match named {
        Some(key) => part["required"] = json!([key]),
        None if FAMILIES.contains(&name) => part["required"] = json!([]),
        None => return entry.to_owned(),
    }
    let of_base = format!("{name}OfBase");
    definitions[&of_base] = part;
    format!("#/definitions/{of_base}")
}

/// Removes the backslashes before square brackets. Rustdoc needs them in doc comments, but readers
/// of the schema do not.
fn plain(value: &mut Value) {
    match value {
        Value::String(s) if s.contains('\\') && !s.starts_with('^') => {
            *s = s.replace("\\[", "[").replace("\\]", "]")
        }
        Value::Array(list) => list.iter_mut().for_each(plain),
        Value::Object(map) => map.values_mut().for_each(plain),
        _ => {}
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use bracket_base::yaml;

    #[test]
    fn committed_schemas_are_fresh() {
        for (kind, name) in [
            (Kind::Spec, "spec"),
            (Kind::Model, "model"),
            (Kind::Batch, "batch"),
            (Kind::Template, "template"),
        ] {
            let path =
                Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("schemas/{name}.schema.json"));
            let fresh = text(kind).expect("a schema is JSON");
            if std::env::var_os("BRACKET_WRITE_SCHEMAS").is_some() {
                std::fs::write(&path, &fresh).expect("schemas/ is writable");
            }
            let committed = std::fs::read_to_string(&path).unwrap_or_default();
            assert!(
                committed == fresh,
                "schemas/{name}.schema.json is old: bracket schema {name} > \
                 schemas/{name}.schema.json"
            );
        }
    }

    /// The parts of `value` that a schema refuses, as paths with reasons. Only the keywords that
    /// our schemas use are evaluated.
    fn refused(value: &Value, schema: &Value, root: &Value, at: &str) -> Vec<String> {
        let sub = |key: &str| schema.get(key);
        let mut out = Vec::new();
        if let Some(name) = sub("$ref").and_then(Value::as_str) {
            let target = root
                .pointer(name.trim_start_matches('#'))
                .unwrap_or_else(|| panic!("{name} leads nowhere"));
            out.extend(refused(value, target, root, at));
        }
        if let (Some(condition), Some(then)) = (sub("if"), sub("then"))
            && refused(value, condition, root, at).is_empty()
        {
            out.extend(refused(value, then, root, at));
        }
        for one in sub("allOf").and_then(Value::as_array).into_iter().flatten() {
            out.extend(refused(value, one, root, at));
        }
        for key in ["anyOf", "oneOf"] {
            let Some(ways) = sub(key).and_then(Value::as_array) else { continue };
            if ways.iter().all(|way| !refused(value, way, root, at).is_empty()) {
                out.push(format!("{at}: {value} fits none of {key}"));
            }
        }
        let kind = match value {
            Value::Null => "null",
            Value::Bool(_) => "boolean",
            Value::Number(n) if n.is_f64() => "number",
            Value::Number(_) => "integer",
            Value::String(_) => "string",
            Value::Array(_) => "array",
            Value::Object(_) => "object",
        };
        let is = |wanted: &Value| wanted == kind || (wanted == "number" && kind == "integer");
        match sub("type") {
            Some(Value::Array(kinds)) if !kinds.iter().any(is) => out.push(format!("{at}: {kind}")),
            Some(wanted @ Value::String(_)) if !is(wanted) => out.push(format!("{at}: {kind}")),
            _ => {}
        }
        if sub("enum").and_then(Value::as_array).is_some_and(|e| !e.contains(value)) {
            out.push(format!("{at}: {value} is no word of the list"));
        }
        if sub("const").is_some_and(|c| c != value) {
            out.push(format!("{at}: {value}"));
        }
        match value {
            Value::Object(map) => {
                let known = sub("properties").and_then(Value::as_object);
                for (key, v) in map {
                    let below = format!("{at}.{key}");
                    match (known.and_then(|k| k.get(key)), sub("additionalProperties")) {
                        (Some(s), _) => out.extend(refused(v, s, root, &below)),
                        (None, Some(Value::Bool(false))) => {
                            out.push(format!("{below}: unknown key"))
                        }
                        (None, Some(s @ Value::Object(_))) => {
                            out.extend(refused(v, s, root, &below))
                        }
                        (None, _) => {}
                    }
                }
                for needed in sub("required").and_then(Value::as_array).into_iter().flatten() {
                    if !map.contains_key(needed.as_str().expect("a key")) {
                        out.push(format!("{at}: lacks {needed}"));
                    }
                }
            }
            Value::Array(list) => {
                for (i, v) in list.iter().enumerate() {
                    let item = match sub("items") {
                        Some(Value::Array(each)) => each.get(i),
                        item => item,
                    };
                    out.extend(
                        item.iter().flat_map(|s| refused(v, s, root, &format!("{at}[{i}]"))),
                    );
                }
            }
            _ => {}
        }
        out
    }

    /// The schema accepts the shipped templates, and it refuses what the reader refuses.
    #[test]
    fn the_schema_of_templates_fits_the_shipped_ones_and_refuses_ten_wrong_ones() {
        let schema: Value =
            serde_json::from_str(&text(Kind::Template).expect("a schema")).expect("JSON");
        let read =
            |text: &str| yaml::parse::<Value>(text, Path::new("t.yaml")).expect("YAML").value;
        for (name, text) in SHIPPED {
            assert_eq!(refused(&read(text), &schema, &schema, name), Vec::<String>::new());
        }
        let (_, text) = SHIPPED.iter().find(|(n, _)| *n == "t_stub").expect("shipped");
        for (old, new) in [
            ("title:", "titel:"),
            ("parts:", "part:"),
            ("kind: length", "kind: lenght"),
            ("role: member", "role: membre"),
            ("axis: z", "axis: w"),
            ("outward: ", "outwards: "),
            ("fix: [", "fix: [w, "),
            ("between: [", "betwixt: ["),
            ("toward: ", "toward: [1, 2] #"),
            ("members:", "members: 3\nx:"),
            ("name: t_stub", "name: [t_stub]"),
        ] {
            assert!(text.contains(old), "{old}");
            let wrong = text.replacen(old, new, 1);
            let value = yaml::parse::<Value>(&wrong, Path::new("t.yaml")).expect(new).value;
            assert!(
                !refused(&value, &schema, &schema, "").is_empty(),
                "the schema lets `{new}` pass"
            );
            assert!(
                yaml::parse::<Template>(&wrong, Path::new("t.yaml")).is_err(),
                "the reader lets `{new}` pass"
            );
        }
    }

    /// Reader and schema accept and refuse the same specs: numbers as names, empty keys, the
    /// parameters and members of the template.
    #[test]
    fn the_schema_of_specs_reads_as_the_program_does() {
        const SPEC: &str = "template: beam_splice
project: {number: 12}
members: {beam: {profile: IPE300, steel: S235}}
plate: {thickness: 15}
bolts: {size: M20, grade: \"10.9\", rows: [-90, 90, 190]}
parameters: {beam_length: 1 m, head_contact: true}
loads: [{name: 1, end: beam_right, at: bolt_plane, My: 20 kN m}]
";
        let schema: Value =
            serde_json::from_str(&text(Kind::Spec).expect("a schema")).expect("JSON");
        let catalog = bracket_joint::catalog::Catalog::builtin().expect("catalogue");
        let both = |spec: &str| {
            let value = yaml::parse::<Value>(spec, Path::new("t.yaml")).expect("YAML").value;
            let reads = yaml::parse::<ConnectionSpec>(spec, Path::new("t.yaml"))
                .and_then(|p| bracket_codes::design_code::build(&p, Path::new("."), &catalog));
            (refused(&value, &schema, &schema, ""), reads.map(drop))
        };
        for (old, new) in [
            ("", ""),
            ("\"10.9\"", "10.9"),
            ("\"10.9\"", "8.8"),
            ("{number: 12}", ""),
            ("{beam_length: 1 m, head_contact: true}", ""),
            ("1 m,", "1000,"),
        ] {
            let (faults, read) = both(&SPEC.replace(old, new));
            assert!(faults.is_empty() && read.is_ok(), "`{new}`: {faults:?} {read:?}");
        }
        for (old, new) in [
            ("beam_length: 1 m", "beam_lenght: 1 m"),
            ("beam_length: 1 m", "column_stiffeners: true"),
            ("beam_length: 1 m", "beam_length: true"),
            ("head_contact: true", "head_contact: 1"),
            ("members: {beam:", "members: {girder:"),
            ("\"10.9\"", "[10.9]"),
            ("name: 1,", "name: [1],"),
        ] {
            let (faults, read) = both(&SPEC.replace(old, new));
            assert!(!faults.is_empty() && read.is_err(), "`{new}`: {faults:?} {read:?}");
        }
        // a template of one's own has parameters of its own
        let own = SPEC.replace("beam_splice", "mine.yaml").replace("beam_length", "mine");
        assert!(both(&own).0.is_empty());
    }

    #[test]
    fn schemas_are_draft_07_and_strict() {
        for kind in [Kind::Spec, Kind::Model, Kind::Batch, Kind::Template] {
            let schema: Value = serde_json::from_str(&text(kind).expect("a schema")).expect("JSON");
            assert_eq!(schema["$schema"], "http://json-schema.org/draft-07/schema#");
            if kind != Kind::Template {
                assert_eq!(schema["additionalProperties"], false);
                continue;
            }
            for way in ["Template", "ExtendingTemplate"] {
                assert_eq!(schema["definitions"][way]["additionalProperties"], false);
            }
        }
    }
}
