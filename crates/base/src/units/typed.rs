//! Types for lengths, forces, moments, stresses and times in YAML files.

use super::parse::{Kind, bare, parse, split};
use serde::{Deserialize, Deserializer, Serialize, Serializer, de};
use std::fmt;

/// First words of the message about an invalid quantity. The YAML reader recognises the message by
/// them and does not report a syntax error.
pub const INVALID_QUANTITY: &str = "invalid quantity: ";

struct QuantityVisitor(Kind);

impl de::Visitor<'_> for QuantityVisitor {
    type Value = f64;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "a {} ({})", self.0.word(), self.0.accepted())
    }
    fn visit_f64<E: de::Error>(self, v: f64) -> Result<f64, E> {
        bare(v, self.0).map_err(|e| E::custom(format_args!("{INVALID_QUANTITY}{e}")))
    }
    fn visit_i64<E: de::Error>(self, v: i64) -> Result<f64, E> {
        self.visit_f64(v as f64)
    }
    fn visit_u64<E: de::Error>(self, v: u64) -> Result<f64, E> {
        self.visit_f64(v as f64)
    }
    fn visit_str<E: de::Error>(self, v: &str) -> Result<f64, E> {
        parse(v, self.0).map_err(|e| E::custom(format_args!("{INVALID_QUANTITY}{e}")))
    }
}

/// Writes a value in the larger unit that engineers use, if the text reads back as the same number;
/// otherwise in the internal unit.
fn shown(value: f64, unit: &str, large: Option<(f64, &str)>) -> String {
    match large {
        Some((factor, large))
            if value.abs() >= 0.1 * factor && (value / factor) * factor == value =>
        {
            format!("{} {large}", value / factor)
        }
        _ => format!("{value} {unit}"),
    }
}

macro_rules! quantity {
    ($name:ident, $kind:expr, $unit:literal, $large:expr, $schema:literal, $doc:literal) => {
        #[doc = $doc]
        #[derive(Clone, Copy, Debug, Default, PartialEq, PartialOrd)]
        pub struct $name(
            /// Value in the internal unit.
            pub f64,
        );

        impl<'de> Deserialize<'de> for $name {
            fn deserialize<D: Deserializer<'de>>(d: D) -> Result<Self, D::Error> {
                d.deserialize_any(QuantityVisitor($kind)).map($name)
            }
        }

        impl Serialize for $name {
            fn serialize<S: Serializer>(&self, s: S) -> Result<S::Ok, S::Error> {
                s.collect_str(&shown(self.0, $unit, $large))
            }
        }

        impl schemars::JsonSchema for $name {
            fn schema_name() -> std::borrow::Cow<'static, str> {
                stringify!($name).into()
            }
            fn json_schema(_: &mut schemars::SchemaGenerator) -> schemars::Schema {
                let text = schemars::json_schema!({"type": "string", "pattern": $schema});
                match $kind {
                    Kind::Length => schemars::json_schema!({
                        "description": $doc,
                        "anyOf": [{"type": "number"}, text],
                    }),
                    _ => schemars::json_schema!({
                        "description": $doc,
                        "type": "string",
                        "pattern": $schema,
                    }),
                }
            }
        }
    };
}

quantity!(
    Length,
    Kind::Length,
    "mm",
    None,
    r#"^\s*([-−+0-9.eE]+\s*(mm|cm|m|in|ft|\")?|[-−]?([0-9]+[ -]+)?[0-9]+/[0-9]+\s*(in|\"))\s*$"#,
    "A length: bare number = mm, or with a suffix mm, cm, m, in, ft; inches also as fractions: \
     3/4 in, 1 1/4 in."
);
quantity!(
    Force,
    Kind::Force,
    "N",
    Some((1e3, "kN")),
    r"^\s*[-−+0-9.eE]+\s*(N|kN|MN|lbf|kip)\s*$",
    "A force with a suffix: N, kN, MN, lbf, kip."
);
quantity!(
    Moment,
    Kind::Moment,
    "N mm",
    Some((1e6, "kN m")),
    r"^\s*[-−+0-9.eE]+\s*(N mm|N m|kN mm|kN cm|kN m|MN m|Nmm|Nm|kNm|kip in|kip ft)\s*$",
    "A moment with a suffix: N mm, N m, kN cm, kN m, MN m, kip in, kip ft."
);
quantity!(
    Stress,
    Kind::Stress,
    "MPa",
    None,
    r"^\s*[-−+0-9.eE]+\s*(MPa|GPa|N/mm2|kN/cm2|psi|ksi)\s*$",
    "A stress or pressure with a suffix: MPa, N/mm2, GPa, kN/cm2, psi, ksi."
);

/// A span of time with a suffix: s, min, h \[s\].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Seconds(
    /// Seconds.
    pub f64,
);

impl Seconds {
    /// Reads `20 min`, `90 s`, `1.5 h`.
    pub fn parse(text: &str) -> Result<Self, String> {
        let fault =
            || format!("`{text}` is not a time: write a positive number and a unit (s, min, h)");
        let (number, suffix) = split(text).ok_or_else(fault)?;
        let factor = match suffix {
            "s" => 1.0,
            "min" => 60.0,
            "h" => 3600.0,
            _ => return Err(fault()),
        };
        if number.is_finite() && number > 0.0 { Ok(Seconds(number * factor)) } else { Err(fault()) }
    }
}

impl<'de> Deserialize<'de> for Seconds {
    fn deserialize<D: Deserializer<'de>>(d: D) -> Result<Self, D::Error> {
        struct V;
        impl de::Visitor<'_> for V {
            type Value = Seconds;
            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("a time with a unit (s, min, h)")
            }
            fn visit_str<E: de::Error>(self, v: &str) -> Result<Seconds, E> {
                Seconds::parse(v).map_err(|e| E::custom(format_args!("{INVALID_QUANTITY}{e}")))
            }
        }
        d.deserialize_any(V)
    }
}

impl Serialize for Seconds {
    fn serialize<S: Serializer>(&self, s: S) -> Result<S::Ok, S::Error> {
        s.collect_str(&format_args!("{} s", self.0))
    }
}

impl schemars::JsonSchema for Seconds {
    fn schema_name() -> std::borrow::Cow<'static, str> {
        "Seconds".into()
    }
    fn json_schema(_: &mut schemars::SchemaGenerator) -> schemars::Schema {
        schemars::json_schema!({
            "description": "A time with a suffix: s, min, h.",
            "type": "string",
            "pattern": r"^\s*[0-9.eE+]+\s*(s|min|h)\s*$",
        })
    }
}
