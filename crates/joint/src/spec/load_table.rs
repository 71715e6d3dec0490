//! A table of load cases in place of a list: what a frame program exports.

use super::loads::{ActionPoint, LimitState, LoadSpec};
use super::word::{Word, word_or_none};
use crate::forces::{Asked, Program, Quantity};
use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::de::value::{MapAccessDeserializer, SeqAccessDeserializer};
use serde::{Deserialize, Deserializer, Serialize, Serializer, de};
use std::collections::BTreeMap;
use std::fmt;
use std::ops::{Deref, DerefMut};
use std::path::PathBuf;

/// The loads of a spec: a list, or the table from which one is made.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Loads {
    /// The table, until it is read.
    pub table: Option<LoadTable>,
    /// The table from which the list was made.
    read_from: Option<LoadTable>,
    list: Vec<LoadSpec>,
}

impl Loads {
    /// Takes the table that is to be read; the loads remember it.
    pub fn take_table(&mut self) -> Option<LoadTable> {
        self.read_from = self.table.take();
        self.read_from.clone()
    }

    /// The loads as the spec gives them: the table, where a table was read.
    #[must_use]
    pub fn as_given(&self) -> Self {
        match &self.read_from {
            Some(table) => Self { table: Some(table.clone()), ..Self::default() },
            None => self.clone(),
        }
    }
}

impl Deref for Loads {
    type Target = Vec<LoadSpec>;
    fn deref(&self) -> &Vec<LoadSpec> {
        &self.list
    }
}

impl DerefMut for Loads {
    fn deref_mut(&mut self) -> &mut Vec<LoadSpec> {
        &mut self.list
    }
}

impl From<Vec<LoadSpec>> for Loads {
    fn from(list: Vec<LoadSpec>) -> Self {
        Self { list, ..Self::default() }
    }
}

impl Serialize for Loads {
    fn serialize<S: Serializer>(&self, s: S) -> Result<S::Ok, S::Error> {
        match &self.table {
            Some(table) => table.serialize(s),
            None => self.list.serialize(s),
        }
    }
}

impl<'de> Deserialize<'de> for Loads {
    fn deserialize<D: Deserializer<'de>>(d: D) -> Result<Self, D::Error> {
        struct V;
        impl<'de> de::Visitor<'de> for V {
            type Value = Loads;
            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("a list of loads, or a table: `{table: forces.csv}`")
            }
            fn visit_unit<E>(self) -> Result<Loads, E> {
                Ok(Loads::default())
            }
            fn visit_seq<A: de::SeqAccess<'de>>(self, seq: A) -> Result<Loads, A::Error> {
                Vec::deserialize(SeqAccessDeserializer::new(seq)).map(Loads::from)
            }
            fn visit_map<A: de::MapAccess<'de>>(self, map: A) -> Result<Loads, A::Error> {
                let table = LoadTable::deserialize(MapAccessDeserializer::new(map))?;
                Ok(Loads { table: Some(table), ..Loads::default() })
            }
        }
        d.deserialize_any(V)
    }
}

impl JsonSchema for Loads {
    fn schema_name() -> std::borrow::Cow<'static, str> {
        "Loads".into()
    }
    fn json_schema(generator: &mut SchemaGenerator) -> Schema {
        let list = generator.subschema_for::<Vec<LoadSpec>>();
        let table = generator.subschema_for::<LoadTable>();
        json_schema!({"anyOf": [list, table, {"type": "null"}]})
    }
}

/// A table of load cases, each row one: CSV or a sheet of a workbook.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct LoadTable {
    /// The file, relative to this one.
    pub table: PathBuf,
    /// Sheet of a workbook.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub sheet: Option<String>,
    /// The program whose headers, axes and signs the table has; left out: those of Bracket.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub mapping: Option<Program>,
    /// Headers by quantity, with a unit where the table has none and with a minus sign where the
    /// table has the opposite sign: `My: "M-y [kNm]"`, `N: -FX`.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub columns: BTreeMap<Quantity, String>,
    /// Only the rows of this member.
    #[serde(default, deserialize_with = "word_or_none", skip_serializing_if = "Option::is_none")]
    pub member: Option<String>,
    /// Only the rows of this node.
    #[serde(default, deserialize_with = "word_or_none", skip_serializing_if = "Option::is_none")]
    pub node: Option<String>,
    /// Only the rows at this place of the member: `start`, `end`, or the distance from the start in
    /// the unit of the table.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub station: Option<Station>,
    /// True if the member runs into the joint. Needed with `mapping`, unless `station` is `start`
    /// or `end`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub flip: Option<bool>,
    /// Only these load cases; `*` stands for any letters: `ULS*`.
    #[serde(default, deserialize_with = "patterns", skip_serializing_if = "Vec::is_empty")]
    #[schemars(schema_with = "patterns_schema")]
    pub cases: Vec<String>,
    /// Limit states by names of load cases: `SLS: "SLS*"`; the others are ultimate.
    #[serde(default, deserialize_with = "states", skip_serializing_if = "BTreeMap::is_empty")]
    #[schemars(schema_with = "states_schema")]
    pub state: BTreeMap<LimitState, Vec<String>>,
    /// Member end the actions act on, where no column says it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub end: Option<String>,
    /// Where they act, likewise.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub at: Option<ActionPoint>,
    /// Who asks for it; no key of a spec.
    #[serde(skip)]
    pub asked: Asked,
}

impl LoadTable {
    /// Whether the station says at which end of the member the joint is.
    pub fn at_an_end(&self) -> bool {
        matches!(self.station, Some(Station::Start | Station::End))
    }

    /// Whether the joint is at the end of the member, so that x′ is opposite to the member's x.
    pub fn runs_into_the_joint(&self) -> bool {
        self.flip.unwrap_or(self.station == Some(Station::End))
    }
}

/// A place on a member.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Station {
    /// Its first section.
    Start,
    /// Its last section.
    End,
    /// Distance from the start, in the unit of the table.
    At(f64),
}

impl fmt::Display for Station {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Station::Start => f.write_str("start"),
            Station::End => f.write_str("end"),
            Station::At(x) => write!(f, "{x}"),
        }
    }
}

impl Serialize for Station {
    fn serialize<S: Serializer>(&self, s: S) -> Result<S::Ok, S::Error> {
        match self {
            Station::At(x) => s.serialize_f64(*x),
            other => s.serialize_str(&other.to_string()),
        }
    }
}

impl<'de> Deserialize<'de> for Station {
    fn deserialize<D: Deserializer<'de>>(d: D) -> Result<Self, D::Error> {
        struct V;
        impl de::Visitor<'_> for V {
            type Value = Station;
            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("start, end or a number")
            }
            fn visit_str<E: de::Error>(self, v: &str) -> Result<Station, E> {
                match v {
                    "start" => Ok(Station::Start),
                    "end" => Ok(Station::End),
                    other => Err(E::invalid_value(de::Unexpected::Str(other), &self)),
                }
            }
            fn visit_f64<E>(self, v: f64) -> Result<Station, E> {
                Ok(Station::At(v))
            }
            fn visit_i64<E>(self, v: i64) -> Result<Station, E> {
                Ok(Station::At(v as f64))
            }
            fn visit_u64<E>(self, v: u64) -> Result<Station, E> {
                Ok(Station::At(v as f64))
            }
        }
        d.deserialize_any(V)
    }
}

impl JsonSchema for Station {
    fn schema_name() -> std::borrow::Cow<'static, str> {
        "Station".into()
    }
    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        json_schema!({"anyOf": [{"enum": ["start", "end"]}, {"type": "number"}]})
    }
}

/// One pattern or a list of them.
#[derive(Deserialize)]
#[serde(untagged)]
enum Patterns {
    One(Word),
    Many(Vec<Word>),
}

impl From<Patterns> for Vec<String> {
    fn from(patterns: Patterns) -> Self {
        match patterns {
            Patterns::One(one) => vec![one.0],
            Patterns::Many(many) => many.into_iter().map(|w| w.0).collect(),
        }
    }
}

fn patterns<'de, D: Deserializer<'de>>(d: D) -> Result<Vec<String>, D::Error> {
    Patterns::deserialize(d).map(Into::into)
}

fn states<'de, D: Deserializer<'de>>(d: D) -> Result<BTreeMap<LimitState, Vec<String>>, D::Error> {
    let read = BTreeMap::<LimitState, Patterns>::deserialize(d)?;
    Ok(read.into_iter().map(|(state, patterns)| (state, patterns.into())).collect())
}

fn patterns_schema(_: &mut SchemaGenerator) -> Schema {
    let word = json_schema!({"type": ["string", "number"]});
    json_schema!({"anyOf": [word, {"type": "array", "items": word}]})
}

fn states_schema(generator: &mut SchemaGenerator) -> Schema {
    let patterns = patterns_schema(generator);
    json_schema!({"type": "object", "properties": {"ULS": patterns, "SLS": patterns},
        "additionalProperties": false})
}
