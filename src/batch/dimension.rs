//! Values of a sweep that change together: an axis, linked axes, or the rows of a table.

use super::spec_path::SpecPath;
use bracket_base::diag::Place;
use bracket_codes::verdict::Verdict;
use serde::{Deserialize, Serialize};
use serde_json::Value;

/// The values of one step of a dimension.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Setting {
    /// Name of the joint, if the table gives one.
    pub name: Option<String>,
    /// Values in the order of the paths; `None`: the value of the base stays.
    pub values: Vec<Option<Value>>,
    /// The verdict that the table expects.
    pub expect: Option<Verdict>,
    /// Texts of the notes, in the order of their columns.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub notes: Vec<String>,
    /// Where the step is written; for messages while the sweep is planned.
    #[serde(skip)]
    pub place: Place,
}

impl Setting {
    /// The name of the joint, or the values where the table gives none.
    pub fn name(&self) -> String {
        self.name.clone().unwrap_or_else(|| {
            self.values.iter().flatten().map(words).collect::<Vec<_>>().join(" ")
        })
    }
}

/// Values that change together.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Dimension {
    /// The axis or the file in words, for messages.
    pub what: String,
    /// Whether the steps are the rows of the table.
    #[serde(default)]
    pub table: bool,
    /// The paths that change.
    pub paths: Vec<SpecPath>,
    /// Columns of notes, which change nothing and stand in the tables of results.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub notes: Vec<String>,
    /// Their values.
    pub steps: Vec<Setting>,
}

impl Dimension {
    /// Writes the values of a step into a spec; the error names the path that cannot be written.
    pub fn set(&self, step: &Setting, spec: &mut Value) -> Result<(), (&SpecPath, String)> {
        for (path, value) in self.paths.iter().zip(&step.values) {
            if let Some(value) = value {
                path.set(spec, value.clone()).map_err(|e| (path, e))?;
            }
        }
        Ok(())
    }
}

/// A value as text, as a table shows it.
pub fn words(value: &Value) -> String {
    match value {
        Value::String(s) => s.clone(),
        Value::Number(n) => n.as_f64().map_or_else(|| n.to_string(), |x| x.to_string()),
        Value::Array(list) => list.iter().map(words).collect::<Vec<_>>().join(" "),
        other => other.to_string(),
    }
}
