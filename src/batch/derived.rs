//! Values that follow from others: `bolts.rows` from the depth of the beam.

use super::spec_path::SpecPath;
use bracket_base::diag::Diagnostic;
use bracket_base::units::Dim;
use bracket_base::yaml::PlaceIndex;
use bracket_joint::assembly::scope::Scope;
use bracket_joint::spec::expr::{self, Expr};
use serde::{Deserialize, Serialize};
use serde_json::{Number, Value};

/// A path and the expressions of its value.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Derived {
    /// The path that is set.
    pub path: SpecPath,
    /// Whether the value is a list.
    list: bool,
    /// The expressions as text.
    texts: Vec<String>,
}

impl Derived {
    /// Reads the entry `key: value` of `set`.
    pub fn read(key: &str, value: &Value, index: &PlaceIndex) -> Result<Self, Box<Diagnostic>> {
        let fault = |message: String| {
            let d = Diagnostic::input("sweep/set", message).help(
                "write an expression of names such as `beam.h`, `bolt.d` and `plate.thickness`, \
                 or a list of them: `[-beam.h / 2 + 60 mm, beam.h / 2 - 60 mm]`",
            );
            Box::new(Diagnostic { place: index.place(&format!("set.{key}")), ..d })
        };
        let path = SpecPath::parse(key).map_err(fault)?;
        let one = |v: &Value| match v {
            Value::String(text) => Ok(text.clone()),
            Value::Number(n) => Ok(n.to_string()),
            other => Err(fault(format!("`set.{key}`: `{other}` is no expression"))),
        };
        let texts: Vec<String> = match value {
            Value::Array(list) => list.iter().map(one).collect::<Result<_, _>>()?,
            other => vec![one(other)?],
        };
        for text in &texts {
            Expr::parse(text).map_err(|e| fault(format!("`set.{key}`: {e}")))?;
        }
        Ok(Self { path, list: value.is_array(), texts })
    }

    /// The names that the expressions use.
    pub fn names(&self) -> Vec<String> {
        let parsed = self.texts.iter().filter_map(|t| Expr::parse(t).ok());
        parsed.flat_map(|e| e.names().into_iter().map(str::to_owned).collect::<Vec<_>>()).collect()
    }

    /// Writes the value into a spec whose names are `scope`.
    pub fn set(&self, spec: &mut Value, scope: &Scope) -> Result<(), String> {
        let mut values = Vec::with_capacity(self.texts.len());
        for text in &self.texts {
            let value = Expr::parse(text).and_then(|e| e.eval(&mut |n| scope.get(n)));
            let value = value.map_err(|e| format!("`{}`: {e}", self.path))?;
            values.push(as_json(value));
        }
        let value = match self.list {
            true => Value::Array(values),
            false => values.swap_remove(0),
        };
        self.path.set(spec, value)
    }
}

/// A value as a spec writes it: lengths and numbers without a unit, the others with theirs.
fn as_json(value: expr::Value) -> Value {
    match value {
        expr::Value::Truth(t) => Value::Bool(t),
        expr::Value::Quantity(q) if q.dim == Dim::LENGTH || q.dim == Dim::NONE => {
            // nine decimals hide the rounding error of decimal input
            Number::from_f64((1e9 * q.value).round() / 1e9).map_or(Value::Null, Value::Number)
        }
        other => Value::String(other.to_string()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;
    use std::path::Path;

    fn read(value: Value) -> Result<Derived, Box<Diagnostic>> {
        Derived::read("bolts.rows", &value, &PlaceIndex::new(Path::new("sweep.yaml")))
    }

    #[test]
    fn values_follow_from_names() {
        let mut scope = Scope::default();
        scope.set("beam.h", expr::Value::length(300.0));
        scope.set("F", expr::Value::force(2e3));
        for (value, want) in [
            (json!(["-beam.h / 2 + 60 mm", "beam.h / 2 - 60 mm"]), json!([-90.0, 90.0])),
            (json!("2 * F"), json!("4000 N")),
            (json!("beam.h > 200 mm"), json!(true)),
            (json!(7), json!(7.0)),
        ] {
            let mut spec = json!({});
            read(value).expect("an entry").set(&mut spec, &scope).expect("a value");
            assert_eq!(spec, json!({"bolts": {"rows": want}}));
        }
        let unknown = read(json!("beam.x")).expect("an entry").set(&mut json!({}), &scope);
        assert!(unknown.is_err_and(|e| e.contains("unknown name `beam.x`")));
        assert!(read(json!("1 +")).is_err() && read(json!({"a": 1})).is_err());
    }
}
