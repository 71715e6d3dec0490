//! Parameters of a template: kind, range, default.

use crate::spec::connection::ParameterValue;
use crate::spec::expr::Expr;
use schemars::JsonSchema;
use serde::Deserialize;

/// What a parameter holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum ParameterKind {
    /// A length.
    Length,
    /// A pure number.
    Number,
    /// An angle.
    Angle,
    /// True or false.
    Flag,
    /// A list of lengths; `name.1` is the first.
    Lengths,
}

/// A parameter of the spec. `plate.*` and `bolts.*` stand there; everything else under
/// `parameters`.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Parameter {
    /// Name.
    pub name: String,
    /// What it holds.
    pub kind: ParameterKind,
    /// Smallest value allowed.
    pub min: Option<Expr>,
    /// Largest value allowed.
    pub max: Option<Expr>,
    /// Length of a list, if fixed.
    pub count: Option<usize>,
    /// Value where the spec gives none; absent: the spec must give one.
    pub default: Option<Default>,
    /// Value of the starter where there is no default, as the spec would say it.
    pub example: Option<ParameterValue>,
    /// When it has an effect; absent: always. A spec that gives it without effect gets a warning.
    pub used_if: Option<Expr>,
    /// What it is.
    pub about: String,
}

/// A default: one expression, or one expression per entry of a list.
#[derive(Clone, Debug)]
pub enum Default {
    /// One expression for one value.
    One(Expr),
    /// One expression per entry of a list.
    Many(Vec<Expr>),
}

impl Default {
    /// The expressions.
    pub fn expressions(&self) -> &[Expr] {
        match self {
            Default::One(e) => std::slice::from_ref(e),
            Default::Many(list) => list,
        }
    }

    /// The expressions as text.
    pub fn text(&self) -> String {
        match self {
            Default::One(e) => e.text().to_owned(),
            Default::Many(list) => {
                format!("[{}]", list.iter().map(Expr::text).collect::<Vec<_>>().join(", "))
            }
        }
    }
}

impl<'de> Deserialize<'de> for Default {
    fn deserialize<D: serde::Deserializer<'de>>(d: D) -> Result<Self, D::Error> {
        use serde::de::{self, IntoDeserializer};
        struct V;
        impl<'de> de::Visitor<'de> for V {
            type Value = Default;
            fn expecting(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                f.write_str("an expression or a list of expressions")
            }
            fn visit_bool<E: de::Error>(self, v: bool) -> Result<Default, E> {
                Expr::deserialize(v.into_deserializer()).map(Default::One)
            }
            fn visit_f64<E: de::Error>(self, v: f64) -> Result<Default, E> {
                Expr::deserialize(v.into_deserializer()).map(Default::One)
            }
            fn visit_i64<E: de::Error>(self, v: i64) -> Result<Default, E> {
                self.visit_f64(v as f64)
            }
            fn visit_u64<E: de::Error>(self, v: u64) -> Result<Default, E> {
                self.visit_f64(v as f64)
            }
            fn visit_str<E: de::Error>(self, v: &str) -> Result<Default, E> {
                Expr::deserialize(v.into_deserializer()).map(Default::One)
            }
            fn visit_seq<A: de::SeqAccess<'de>>(self, mut seq: A) -> Result<Default, A::Error> {
                let mut list = Vec::new();
                while let Some(e) = seq.next_element()? {
                    list.push(e);
                }
                Ok(Default::Many(list))
            }
        }
        d.deserialize_any(V)
    }
}

impl JsonSchema for Default {
    fn schema_name() -> std::borrow::Cow<'static, str> {
        "Default".into()
    }
    fn json_schema(g: &mut schemars::SchemaGenerator) -> schemars::Schema {
        let expression = g.subschema_for::<Expr>();
        schemars::json_schema!({
            "description": "A default: one expression, or one per entry of a list.",
            "anyOf": [expression, {"type": "array", "items": expression}],
        })
    }
}
