//! Units at the border: one internal system (mm, N, MPa, N mm, rad) and the reading of numbers with
//! suffixes.
//!
//! A bare number is a length in mm wherever a length is expected. Forces, moments and stresses must
//! carry a suffix: a moment entered in the wrong unit is the costliest typing error there is.

use serde::{Deserialize, Deserializer, Serialize, Serializer, de};
use std::fmt;

/// Opens the message of a quantity that cannot be read, so that the YAML reader knows it from a
/// syntax error.
pub const INVALID_QUANTITY: &str = "invalid quantity: ";

/// Exponents of length, force and angle; everything the tool computes with is a product of these.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Dim {
    /// Exponent of length (mm).
    pub length: i8,
    /// Exponent of force (N).
    pub force: i8,
    /// Exponent of angle (rad).
    pub angle: i8,
}

impl Dim {
    /// A pure number.
    pub const NONE: Dim = Dim { length: 0, force: 0, angle: 0 };
    /// mm.
    pub const LENGTH: Dim = Dim { length: 1, force: 0, angle: 0 };
    /// N.
    pub const FORCE: Dim = Dim { length: 0, force: 1, angle: 0 };
    /// N mm.
    pub const MOMENT: Dim = Dim { length: 1, force: 1, angle: 0 };
    /// MPa = N/mm².
    pub const STRESS: Dim = Dim { length: -2, force: 1, angle: 0 };
    /// rad.
    pub const ANGLE: Dim = Dim { length: 0, force: 0, angle: 1 };

    /// Dimension of a product; `None` if an exponent leaves the range of the type.
    pub fn times(self, other: Dim) -> Option<Dim> {
        Some(Dim {
            length: self.length.checked_add(other.length)?,
            force: self.force.checked_add(other.force)?,
            angle: self.angle.checked_add(other.angle)?,
        })
    }

    /// Dimension of the `n`-th power; `None` if an exponent leaves the range of the type.
    pub fn power(self, n: i8) -> Option<Dim> {
        Some(Dim {
            length: self.length.checked_mul(n)?,
            force: self.force.checked_mul(n)?,
            angle: self.angle.checked_mul(n)?,
        })
    }
}

impl fmt::Display for Dim {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let word = match *self {
            Dim::NONE => "number",
            Dim::LENGTH => "length [mm]",
            Dim::FORCE => "force [N]",
            Dim::MOMENT => "moment [N mm]",
            Dim::STRESS => "stress [MPa]",
            Dim::ANGLE => "angle [rad]",
            Dim { length: 2, force: 0, angle: 0 } => "area [mm2]",
            _ => return write!(f, "[mm^{} N^{} rad^{}]", self.length, self.force, self.angle),
        };
        f.write_str(word)
    }
}

/// A number in internal units with its dimension.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Quantity {
    /// Value in mm, N, MPa, N mm, rad.
    pub value: f64,
    /// What it measures.
    pub dim: Dim,
}

/// An inch \[mm\], exact.
const INCH: f64 = 25.4;
/// A foot \[mm\], exact.
const FOOT: f64 = 12.0 * INCH;
/// A pound-force \[N\], exact: 0.45359237 kg at 9.80665 m/s².
const POUND: f64 = 4.448_221_615_260_5;

/// Suffix, factor to the internal unit, dimension.
const UNITS: &[(&str, f64, Dim)] = &[
    ("mm", 1.0, Dim::LENGTH),
    ("cm", 10.0, Dim::LENGTH),
    ("m", 1000.0, Dim::LENGTH),
    ("in", INCH, Dim::LENGTH),
    ("\"", INCH, Dim::LENGTH),
    ("ft", FOOT, Dim::LENGTH),
    ("N", 1.0, Dim::FORCE),
    ("kN", 1e3, Dim::FORCE),
    ("MN", 1e6, Dim::FORCE),
    ("lbf", POUND, Dim::FORCE),
    ("kip", 1e3 * POUND, Dim::FORCE),
    ("N mm", 1.0, Dim::MOMENT),
    ("N m", 1e3, Dim::MOMENT),
    ("kN mm", 1e3, Dim::MOMENT),
    ("kN cm", 1e4, Dim::MOMENT),
    ("kN m", 1e6, Dim::MOMENT),
    ("MN m", 1e9, Dim::MOMENT),
    ("kip in", 1e3 * POUND * INCH, Dim::MOMENT),
    ("kip ft", 1e3 * POUND * FOOT, Dim::MOMENT),
    ("Nmm", 1.0, Dim::MOMENT),
    ("Nm", 1e3, Dim::MOMENT),
    ("kNm", 1e6, Dim::MOMENT),
    ("MPa", 1.0, Dim::STRESS),
    ("GPa", 1e3, Dim::STRESS),
    ("N/mm2", 1.0, Dim::STRESS),
    ("kN/cm2", 10.0, Dim::STRESS),
    ("psi", POUND / (INCH * INCH), Dim::STRESS),
    ("ksi", 1e3 * POUND / (INCH * INCH), Dim::STRESS),
    ("rad", 1.0, Dim::ANGLE),
    ("deg", std::f64::consts::PI / 180.0, Dim::ANGLE),
];

/// Factor and dimension of a unit suffix; `*`, `·` and repeated blanks between factors count as one
/// blank.
pub fn unit(suffix: &str) -> Option<(f64, Dim)> {
    let spaced = suffix.replace(['*', '·', '\u{a0}'], " ").replace('²', "2");
    let name = spaced.split_whitespace().collect::<Vec<_>>().join(" ");
    UNITS.iter().find(|(n, _, _)| *n == name).map(|&(_, factor, dim)| (factor, dim))
}

/// What a field of an input file holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// A length; a bare number is mm.
    Length,
    /// A force; needs a suffix.
    Force,
    /// A moment; needs a suffix.
    Moment,
    /// A stress or pressure; needs a suffix.
    Stress,
}

impl Kind {
    /// The word for messages.
    pub fn word(self) -> &'static str {
        match self {
            Kind::Length => "length",
            Kind::Force => "force",
            Kind::Moment => "moment",
            Kind::Stress => "stress",
        }
    }

    /// The units a person may write.
    pub fn accepted(self) -> &'static str {
        match self {
            Kind::Length => "mm, cm, m, in, ft, or a bare number for mm",
            Kind::Force => "N, kN, MN, kip",
            Kind::Moment => "N mm, N m, kN cm, kN m, MN m, kip in, kip ft",
            Kind::Stress => "MPa, N/mm2, GPa, kN/cm2, ksi",
        }
    }

    /// The unit engineers write most.
    pub fn usual(self) -> &'static str {
        match self {
            Kind::Length => "mm",
            Kind::Force => "kN",
            Kind::Moment => "kN m",
            Kind::Stress => "MPa",
        }
    }

    /// Its dimension.
    pub fn dim(self) -> Dim {
        match self {
            Kind::Length => Dim::LENGTH,
            Kind::Force => Dim::FORCE,
            Kind::Moment => Dim::MOMENT,
            Kind::Stress => Dim::STRESS,
        }
    }
}

/// Why a text is not a quantity.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum UnitError {
    /// No number at the front.
    #[error("`{text}` is not a {}: write a number and a unit ({})", kind.word(), kind.accepted())]
    NotANumber {
        /// What was written.
        text: String,
        /// What was expected.
        kind: Kind,
    },
    /// The suffix is no unit of this kind.
    #[error("`{text}` is not a {}: `{suffix}` is not one of its units ({})", kind.word(), kind.accepted())]
    WrongUnit {
        /// What was written.
        text: String,
        /// Its suffix.
        suffix: String,
        /// What was expected.
        kind: Kind,
    },
    /// A fraction of anything but inches.
    #[error(
        "`{text}` is not a length: a fraction is of inches, `3/4 in` or `1 1/4 in`; of other \
         units write decimals"
    )]
    Fraction {
        /// What was written.
        text: String,
    },
    /// A comma among digits.
    #[error("`{text}` is not a {}: a number has a point before its decimals and nothing between its thousands{}", kind.word(), pointed(text))]
    Comma {
        /// What was written.
        text: String,
        /// What was expected.
        kind: Kind,
    },
    /// A unit is required.
    #[error("{} {number} needs a unit: write `{number} {}` ({})", kind.word(), kind.usual(), kind.accepted())]
    NoUnit {
        /// What was written.
        number: String,
        /// What was expected.
        kind: Kind,
    },
    /// NaN or infinity.
    #[error("{} must be finite, not {number}", kind.word())]
    NotFinite {
        /// What was written.
        number: String,
        /// What was expected.
        kind: Kind,
    },
}

/// Splits `120 kN m` into the number and its suffix.
fn split(text: &str) -> Option<(f64, &str)> {
    let text = text.trim();
    let bytes = text.as_bytes();
    let mut end = 0;
    for (i, &b) in bytes.iter().enumerate() {
        let exponent = matches!(b, b'e' | b'E')
            && bytes.get(i + 1).is_some_and(|c| c.is_ascii_digit() || b"+-".contains(c));
        let sign = matches!(b, b'+' | b'-') && (i == 0 || matches!(bytes[i - 1], b'e' | b'E'));
        if !(b.is_ascii_digit() || b == b'.' || exponent || sign) {
            break;
        }
        end = i + 1;
    }
    Some((text[..end].parse().ok()?, text[end..].trim()))
}

/// Splits `3/4 in`, `1 1/4 in`, `1-1/4"` into the number and its suffix; `None` where there is no
/// fraction.
fn split_fraction(text: &str) -> Option<(f64, &str)> {
    let text = text.trim();
    let (sign, body) = text.strip_prefix('-').map_or((1.0, text), |rest| (-1.0, rest));
    let body = body.trim_start();
    // (digits, rest); a fraction is of whole numbers
    let whole = |t: &str| -> Option<(f64, usize)> {
        let n = t.bytes().take_while(u8::is_ascii_digit).count();
        Some((t[..n].parse().ok()?, n))
    };
    let (first, n) = whole(body)?;
    let (units, top, rest) = match body[n..].strip_prefix('/') {
        Some(rest) => (0.0, first, rest),
        None => {
            let rest = body[n..].strip_prefix([' ', '-'])?.trim_start();
            let (top, n) = whole(rest)?;
            (first, top, rest[n..].strip_prefix('/')?)
        }
    };
    let (bottom, n) = whole(rest)?;
    (bottom != 0.0).then(|| (sign * (units + top / bottom), rest[n..].trim()))
}

/// `20.5 mm` for `20,5 mm`; `None` where the comma may stand between thousands, or for anything
/// else.
pub fn with_point(text: &str) -> Option<String> {
    let (whole, rest) = text.trim().split_once(',')?;
    let digits = whole.trim_start_matches(['+', '-']);
    let decimals: String = rest.chars().take_while(char::is_ascii_digit).collect();
    let unit = &rest[decimals.len()..];
    let a_number =
        !digits.is_empty() && digits.bytes().all(|b| b.is_ascii_digit()) && !decimals.is_empty();
    let clear = decimals.len() != 3 && !unit.contains([',', '.']);
    (a_number && clear).then(|| format!("{whole}.{decimals}{unit}"))
}

/// The end of a message about a comma.
fn pointed(text: &str) -> String {
    with_point(text).map_or_else(String::new, |t| format!("; write `{t}`"))
}

/// Reads a text as a quantity of the given kind, in internal units.
///
/// ```
/// use bracket::units::{Kind, parse};
/// assert_eq!(parse("1.5 cm", Kind::Length), Ok(15.0));
/// assert_eq!(parse("120 kN m", Kind::Moment), Ok(120.0e6));
/// assert!(parse("45", Kind::Stress).is_err());
/// ```
pub fn parse(text: &str, kind: Kind) -> Result<f64, UnitError> {
    let fraction = if kind == Kind::Length { split_fraction(text) } else { None };
    if let Some((number, suffix)) = fraction {
        return match unit(suffix) {
            Some((factor, Dim::LENGTH)) if factor == INCH => finite(inches(number), kind),
            _ => Err(UnitError::Fraction { text: text.to_owned() }),
        };
    }
    let (number, suffix) =
        split(text).ok_or_else(|| UnitError::NotANumber { text: text.to_owned(), kind })?;
    if suffix.is_empty() {
        return bare(number, kind);
    }
    match unit(suffix) {
        Some((factor, Dim::LENGTH)) if factor == INCH && kind == Kind::Length => {
            finite(inches(number), kind)
        }
        Some((factor, dim)) if dim == kind.dim() => finite(number * factor, kind),
        _ if suffix.starts_with(',') => Err(UnitError::Comma { text: text.to_owned(), kind }),
        _ => Err(UnitError::WrongUnit { text: text.to_owned(), suffix: suffix.to_owned(), kind }),
    }
}

/// Inches in mm, without the last digits of a product of decimal fractions: 0.75 in are 19.05 mm.
fn inches(number: f64) -> f64 {
    let mm = number * INCH;
    let rounded = (mm * 1e9).round() / 1e9;
    if rounded.is_finite() { rounded } else { mm }
}

/// A number without suffix: mm for a length, an error for everything else.
pub fn bare(number: f64, kind: Kind) -> Result<f64, UnitError> {
    match kind {
        Kind::Length => finite(number, kind),
        _ => Err(UnitError::NoUnit { number: number.to_string(), kind }),
    }
}

fn finite(value: f64, kind: Kind) -> Result<f64, UnitError> {
    if value.is_finite() {
        Ok(value)
    } else {
        Err(UnitError::NotFinite { number: value.to_string(), kind })
    }
}

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

/// A value with the larger unit that people write, where that reads back as the same number, else
/// with the internal one.
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
                    _ => schemars::json_schema!({"description": $doc, "type": "string", "pattern": $schema}),
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
    r#"^\s*([-+0-9.eE]+\s*(mm|cm|m|in|ft|\")?|-?([0-9]+[ -]+)?[0-9]+/[0-9]+\s*(in|\"))\s*$"#,
    "A length: bare number = mm, or with a suffix mm, cm, m, in, ft; inches also as fractions: \
     3/4 in, 1 1/4 in."
);
quantity!(
    Force,
    Kind::Force,
    "N",
    Some((1e3, "kN")),
    r"^\s*[-+0-9.eE]+\s*(N|kN|MN|lbf|kip)\s*$",
    "A force with a suffix: N, kN, MN, lbf, kip."
);
quantity!(
    Moment,
    Kind::Moment,
    "N mm",
    Some((1e6, "kN m")),
    r"^\s*[-+0-9.eE]+\s*(N mm|N m|kN mm|kN cm|kN m|MN m|Nmm|Nm|kNm|kip in|kip ft)\s*$",
    "A moment with a suffix: N mm, N m, kN cm, kN m, MN m, kip in, kip ft."
);
quantity!(
    Stress,
    Kind::Stress,
    "MPa",
    None,
    r"^\s*[-+0-9.eE]+\s*(MPa|GPa|N/mm2|kN/cm2|psi|ksi)\s*$",
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

#[cfg(test)]
mod tests;
