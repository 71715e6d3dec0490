//! The types of `SPEC.yaml` (docs/contract.md), the engineer's description of a connection.
//!
//! The fixed part is the same for all templates. Further values that a template needs are given
//! under `parameters`. Values that may be left out are `Option`s in these types: their defaults
//! come from the template and depend on the profiles.

use super::analysis::AnalysisSpec;
use super::code::Code;
use super::friction::FrictionSpec;
use super::load_table::Loads;
use super::polygon::PolygonSpec;
use super::welds::WeldSpec;
use super::word::{word, word_or_none, word_or_none_schema, word_schema};
use bracket_base::units::{self, Force, INVALID_QUANTITY, Kind, Length, Moment};
use schemars::JsonSchema;
use serde::{Deserialize, Deserializer, Serialize, de};
use std::collections::BTreeMap;
use std::fmt;
use std::path::PathBuf;

/// A whole `SPEC.yaml`. Bare numbers are lengths in mm; forces, moments and stresses carry a
/// suffix.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ConnectionSpec {
    /// Title block of the report.
    #[serde(default, deserialize_with = "null_is_default")]
    pub project: Project,
    /// Design code and its factors.
    #[serde(default, deserialize_with = "null_is_default")]
    pub code: Code,
    /// Name of a connection template (`bracket templates`), or the path of your own, relative to
    /// this file.
    pub template: String,
    /// Folder with catalogue tables of your own (`.csv`), relative to this file; `--catalog` wins
    /// over it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub catalog: Option<PathBuf>,
    /// Members by role.
    #[serde(default, deserialize_with = "null_is_default")]
    pub members: BTreeMap<String, MemberSpec>,
    /// End plate.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub plate: Option<PlateSpec>,
    /// Bolts.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub bolts: Option<BoltSpec>,
    /// Parameters of the template beyond the fixed part, by name.
    #[serde(
        default,
        deserialize_with = "null_is_default",
        skip_serializing_if = "BTreeMap::is_empty"
    )]
    pub parameters: BTreeMap<String, ParameterValue>,
    /// How the fillet welds are made.
    #[serde(
        default,
        deserialize_with = "null_is_default",
        skip_serializing_if = "WeldSpec::is_default"
    )]
    pub welds: WeldSpec,
    /// Friction on contact surfaces.
    #[serde(default, deserialize_with = "null_is_default")]
    pub friction: FrictionSpec,
    /// Loads.
    #[serde(default, deserialize_with = "null_is_default")]
    pub loads: Loads,
    /// Capacity polygon of two actions at a member end.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub polygon: Option<PolygonSpec>,
    /// What to compute and how far.
    #[serde(default, deserialize_with = "null_is_default")]
    pub analysis: AnalysisSpec,
}

/// Reads an empty key, such as `parameters:` with only comments below it, as a key that is left
/// out.
fn null_is_default<'de, T: Default + Deserialize<'de>, D: Deserializer<'de>>(
    d: D,
) -> Result<T, D::Error> {
    Ok(Option::deserialize(d)?.unwrap_or_default())
}

/// Title block of the report.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct Project {
    /// Title; names the joint.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(schema_with = "word_or_none_schema")]
    pub title: Option<String>,
    /// Project number.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(schema_with = "word_or_none_schema")]
    pub number: Option<String>,
    /// Author.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(schema_with = "word_or_none_schema")]
    pub author: Option<String>,
    /// Checker.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(schema_with = "word_or_none_schema")]
    pub checker: Option<String>,
    /// Date, as it shall be printed.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(schema_with = "word_or_none_schema")]
    pub date: Option<String>,
    /// Revision.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(schema_with = "word_or_none_schema")]
    pub revision: Option<String>,
    /// Language of the reports.
    #[serde(skip_serializing_if = "Language::is_default")]
    pub language: Language,
}

/// Language of the reports.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Language {
    /// English.
    #[default]
    En,
    /// German.
    De,
}

impl Language {
    /// All languages.
    pub const ALL: [Self; 2] = [Self::En, Self::De];

    /// Its code, as in HTML and in specs.
    pub fn code(self) -> &'static str {
        match self {
            Language::En => "en",
            Language::De => "de",
        }
    }

    fn is_default(&self) -> bool {
        *self == Language::default()
    }
}

/// A member.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct MemberSpec {
    /// Profile in the catalogue: `HEB200`.
    #[serde(deserialize_with = "word")]
    #[schemars(schema_with = "word_schema")]
    pub profile: String,
    /// Steel grade in the catalogue: `S235`.
    #[serde(deserialize_with = "word")]
    #[schemars(schema_with = "word_schema")]
    pub steel: String,
    /// System length: of a beam between the centres of the columns, of a column its storey height.
    /// It decides the class of the joint by stiffness.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub length: Option<Length>,
    /// Column: axial force beside the joint, tension positive; its compression reduces the web's
    /// resistance (k_wc).
    #[serde(default, rename = "N_Ed", skip_serializing_if = "Option::is_none")]
    pub n_ed: Option<Force>,
    /// Column: largest moment above or below the node about the strong axis (k_wc); at least half
    /// of what the beams bring to the node.
    #[serde(default, rename = "M_Ed", skip_serializing_if = "Option::is_none")]
    pub m_ed: Option<Moment>,
    /// Column: what its shear forces take off that of the web panel, (V_c1 − V_c2)/2 of EN 1993-1-8
    /// 5.3(3); positive against what a positive My of the right beam brings (of the left beam: a
    /// negative one).
    #[serde(default, rename = "V_Ed", skip_serializing_if = "Option::is_none")]
    pub v_ed: Option<Force>,
}

/// End plate.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct PlateSpec {
    /// Thickness.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub thickness: Option<Length>,
    /// Width across the beam.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub width: Option<Length>,
    /// Lower and upper edge, z from the beam axis, up positive.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub z: Option<[Length; 2]>,
    /// Steel grade; left out: the one the template says.
    #[serde(deserialize_with = "word_or_none", skip_serializing_if = "Option::is_none")]
    #[schemars(schema_with = "word_or_none_schema")]
    pub steel: Option<String>,
}

/// Bolts.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct BoltSpec {
    /// Size in the catalogue: `M18`.
    #[serde(deserialize_with = "word")]
    #[schemars(schema_with = "word_schema")]
    pub size: String,
    /// Property class: `8.8`.
    #[serde(deserialize_with = "word")]
    #[schemars(schema_with = "word_schema")]
    pub grade: String,
    /// Distance between the bolt columns.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub gauge: Option<Length>,
    /// Rows: z from the beam axis, up positive.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub rows: Option<Vec<Length>>,
    /// Preload; left out: none.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub preload: Option<PreloadSpec>,
    /// Category of the connection; left out: slip is information.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub category: Option<BoltCategory>,
}

/// Category of a bolted connection, EN 1993-1-8:2005 Table 3.2.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub enum BoltCategory {
    /// In shear, bearing type.
    A,
    /// In shear, preloaded: no slip at serviceability (load cases with `state: SLS`).
    B,
    /// In shear, preloaded: no slip at the ultimate limit state.
    C,
    /// In tension, not preloaded.
    D,
    /// In tension, preloaded.
    E,
}

/// Preload of every bolt.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum PreloadSpec {
    /// No preload: the bolts are tightened by hand.
    None,
    /// A fraction of the tensile strength of the thread, `f_ub A_s`: 0.7 for F_p,C of EN
    /// 1993-1-8:2005 3.9.1(2).
    Part(f64),
    /// A force \[N\].
    Force(f64),
}

impl<'de> Deserialize<'de> for PreloadSpec {
    // written by hand, because an untagged enum does not report what is wrong with a number or a
    // unit
    fn deserialize<D: Deserializer<'de>>(d: D) -> Result<Self, D::Error> {
        struct V;
        impl de::Visitor<'_> for V {
            type Value = PreloadSpec;
            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("`none`, a part of f_ub A_s (0.7), or a force with its unit (98.7 kN)")
            }
            fn visit_str<E: de::Error>(self, v: &str) -> Result<PreloadSpec, E> {
                if v == "none" {
                    return Ok(PreloadSpec::None);
                }
                let force = units::parse(v, Kind::Force).map(PreloadSpec::Force);
                force.map_err(|e| {
                    E::custom(format_args!(
                        "{INVALID_QUANTITY}{e}; or `none`, or a part of f_ub A_s: 0.7"
                    ))
                })
            }
            fn visit_f64<E: de::Error>(self, v: f64) -> Result<PreloadSpec, E> {
                Ok(PreloadSpec::Part(v))
            }
            fn visit_i64<E: de::Error>(self, v: i64) -> Result<PreloadSpec, E> {
                Ok(PreloadSpec::Part(v as f64))
            }
            fn visit_u64<E: de::Error>(self, v: u64) -> Result<PreloadSpec, E> {
                Ok(PreloadSpec::Part(v as f64))
            }
        }
        d.deserialize_any(V)
    }
}

impl Serialize for PreloadSpec {
    fn serialize<S: serde::Serializer>(&self, s: S) -> Result<S::Ok, S::Error> {
        match self {
            PreloadSpec::None => s.serialize_str("none"),
            PreloadSpec::Part(part) => s.serialize_f64(*part),
            PreloadSpec::Force(force) => units::Force(*force).serialize(s),
        }
    }
}

impl JsonSchema for PreloadSpec {
    fn schema_name() -> std::borrow::Cow<'static, str> {
        "PreloadSpec".into()
    }
    fn json_schema(g: &mut schemars::SchemaGenerator) -> schemars::Schema {
        let force = g.subschema_for::<units::Force>();
        schemars::json_schema!({
            "description": "Preload of every bolt: `none`, a part of f_ub A_s \
                (0.7: F_p,C of EN 1993-1-8 3.9.1), or a force.",
            "anyOf": [
                {"const": "none"},
                {"type": "number", "exclusiveMinimum": 0, "maximum": 1},
                force,
            ],
        })
    }
}

/// The value of a template parameter: a number, a text with a unit, true or false, or a list of
/// lengths.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
#[serde(untagged)]
pub enum ParameterValue {
    /// True or false.
    Flag(bool),
    /// A bare number.
    Number(f64),
    /// A number with a unit.
    Text(String),
    /// A list.
    List(Vec<Length>),
}

impl<'de> Deserialize<'de> for ParameterValue {
    fn deserialize<D: Deserializer<'de>>(d: D) -> Result<Self, D::Error> {
        struct V;
        impl<'de> de::Visitor<'de> for V {
            type Value = ParameterValue;
            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("a number, a text with a unit, true or false, or a list of lengths")
            }
            fn visit_bool<E>(self, v: bool) -> Result<ParameterValue, E> {
                Ok(ParameterValue::Flag(v))
            }
            fn visit_f64<E>(self, v: f64) -> Result<ParameterValue, E> {
                Ok(ParameterValue::Number(v))
            }
            fn visit_i64<E>(self, v: i64) -> Result<ParameterValue, E> {
                Ok(ParameterValue::Number(v as f64))
            }
            fn visit_u64<E>(self, v: u64) -> Result<ParameterValue, E> {
                Ok(ParameterValue::Number(v as f64))
            }
            fn visit_str<E>(self, v: &str) -> Result<ParameterValue, E> {
                Ok(ParameterValue::Text(v.to_owned()))
            }
            fn visit_seq<A: de::SeqAccess<'de>>(
                self,
                mut seq: A,
            ) -> Result<ParameterValue, A::Error> {
                let mut list = Vec::new();
                while let Some(l) = seq.next_element()? {
                    list.push(l);
                }
                Ok(ParameterValue::List(list))
            }
        }
        d.deserialize_any(V)
    }
}
