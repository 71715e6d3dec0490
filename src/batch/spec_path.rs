//! Paths into a spec: `plate.thickness`, `bolts.rows[0]`, `loads.ULS1.My`.

use serde::{Deserialize, Deserializer, Serialize, Serializer, de};
use serde_json::{Map, Value};
use std::fmt;

/// A step of a path.
#[derive(Clone, Debug, PartialEq, Eq)]
enum Setting {
    /// A key; in a list the name of an entry.
    Key(String),
    /// The position in a list.
    Index(usize),
}

/// A path into a spec.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SpecPath {
    text: String,
    steps: Vec<Setting>,
}

impl SpecPath {
    /// Reads a path; the error states what is wrong with it.
    pub fn parse(text: &str) -> Result<Self, String> {
        let text = text.trim();
        let mut steps = Vec::new();
        for part in text.split('.') {
            let (key, mut rest) = part.split_at(part.find('[').unwrap_or(part.len()));
            if key.is_empty() || key.contains(|c: char| c.is_whitespace() || c == ']') {
                return Err(format!("`{text}` is not a path such as `plate.thickness`"));
            }
            steps.push(Setting::Key(key.into()));
            while let Some(inner) = rest.strip_prefix('[') {
                let end = inner.find(']').unwrap_or(inner.len());
                let Ok(index) = inner[..end].parse() else {
                    return Err(format!("`{text}`: `[{}` is not a position", &inner[..end]));
                };
                steps.push(Setting::Index(index));
                rest = inner.get(end + 1..).unwrap_or("");
            }
            if !rest.is_empty() {
                return Err(format!("`{text}`: `{rest}` after a position"));
            }
        }
        Ok(Self { text: text.into(), steps })
    }

    /// The path as it was written.
    pub fn text(&self) -> &str {
        &self.text
    }

    /// Writes a value at the path. Mappings on the way are made where they are missing; entries of
    /// lists must exist, unless the position is the next one.
    pub fn set(&self, spec: &mut Value, value: Value) -> Result<(), String> {
        let mut at = spec;
        for step in &self.steps {
            if at.is_null() {
                *at = Value::Object(Map::new());
            }
            at = match (step, at) {
                (Setting::Key(key), Value::Object(map)) => {
                    map.entry(key.clone()).or_insert(Value::Null)
                }
                (Setting::Key(key), Value::Array(list)) => self.named(list, key)?,
                (Setting::Index(i), Value::Array(list)) => {
                    if *i == list.len() {
                        list.push(Value::Null);
                    }
                    let n = list.len();
                    list.get_mut(*i).ok_or_else(|| format!("`{self}`: the list has {n} entries"))?
                }
                (Setting::Key(key), _) => {
                    return Err(format!(
                        "`{self}`: `{key}` is a key of something that has no keys"
                    ));
                }
                (Setting::Index(i), _) => {
                    return Err(format!(
                        "`{self}`: `[{i}]` is a position in something that is no list"
                    ));
                }
            };
        }
        *at = value;
        Ok(())
    }

    /// The entry of a list with this name.
    fn named<'a>(&self, list: &'a mut [Value], key: &str) -> Result<&'a mut Value, String> {
        let is = |v: &Value| v.get("name").and_then(Value::as_str) == Some(key);
        let names: Vec<String> = list
            .iter()
            .filter_map(|v| v.get("name").and_then(Value::as_str).map(str::to_owned))
            .collect();
        let mut found = list.iter_mut().filter(|v| is(v));
        match (found.next(), found.next()) {
            (Some(one), None) => Ok(one),
            (Some(_), Some(_)) => Err(format!(
                "`{self}`: several entries have the name `{key}`; write the position, `[0]` for \
                 the first"
            )),
            (None, _) => {
                let hint = bracket_base::diag::did_you_mean(key, names.iter().map(String::as_str));
                Err(format!("`{self}`: no entry has the name `{key}`{hint}"))
            }
        }
    }

    /// The value at the path.
    pub fn get<'a>(&self, spec: &'a Value) -> Option<&'a Value> {
        let mut at = spec;
        for step in &self.steps {
            at = match (step, at) {
                (Setting::Key(key), Value::Object(map)) => map.get(key)?,
                (Setting::Key(key), Value::Array(list)) => {
                    list.iter().find(|v| v.get("name").and_then(Value::as_str) == Some(key))?
                }
                (Setting::Index(i), Value::Array(list)) => list.get(*i)?,
                _ => return None,
            };
        }
        Some(at)
    }
}

impl fmt::Display for SpecPath {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.text)
    }
}

impl Serialize for SpecPath {
    fn serialize<S: Serializer>(&self, s: S) -> Result<S::Ok, S::Error> {
        s.serialize_str(&self.text)
    }
}

impl<'de> Deserialize<'de> for SpecPath {
    fn deserialize<D: Deserializer<'de>>(d: D) -> Result<Self, D::Error> {
        let text = String::deserialize(d)?;
        Self::parse(&text).map_err(de::Error::custom)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    fn path(text: &str) -> SpecPath {
        SpecPath::parse(text).expect("a path")
    }

    #[test]
    fn values_are_set_and_read() {
        let mut spec =
            json!({"bolts": {"rows": [-1, 2]}, "loads": [{"name": "A", "My": "1 kN m"}]});
        for (at, value) in [
            ("bolts.rows[1]", json!(7)),
            ("bolts.rows[2]", json!(9)),
            ("plate.thickness", json!(12)),
            ("loads.A.My", json!("3 kN m")),
            ("loads[0].Vz", json!("4 kN")),
            ("template", json!("x")),
        ] {
            path(at).set(&mut spec, value.clone()).expect(at);
            assert_eq!(path(at).get(&spec), Some(&value), "{at}");
        }
        assert_eq!(spec["bolts"]["rows"], json!([-1, 7, 9]));
        assert_eq!(path("plate.width").get(&spec), None);
    }

    #[test]
    fn faults_of_paths() {
        for text in ["", ".", "a..b", "a b", "a[x]", "a[0]b", "a]", "[0]"] {
            assert!(SpecPath::parse(text).is_err(), "{text}");
        }
        let spec =
            json!({"rows": [1], "t": 2, "loads": [{"name": "A"}, {"name": "A"}, {"name": "B"}]});
        for (at, why) in [
            ("rows[2]", "has 1 entries"),
            ("rows.x", "no entry has the name `x`"),
            ("t.x", "has no keys"),
            ("t[0]", "no list"),
            ("loads.A.My", "several entries"),
            ("loads.b.My", "did you mean `B`"),
        ] {
            let fault = path(at).set(&mut spec.clone(), json!(1)).expect_err(at);
            assert!(fault.contains(why), "{at}: {fault}");
        }
    }
}
