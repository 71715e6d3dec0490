//! Reads numbers with unit suffixes.

use super::dim::{Dim, INCH, unit};
use std::borrow::Cow;

/// Kind of quantity that a field of an input file contains.
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
    /// An angle; needs a suffix.
    Angle,
}

impl Kind {
    /// The word for messages.
    pub fn word(self) -> &'static str {
        match self {
            Kind::Length => "length",
            Kind::Force => "force",
            Kind::Moment => "moment",
            Kind::Stress => "stress",
            Kind::Angle => "angle",
        }
    }

    /// The word with its article, for messages.
    pub fn one(self) -> &'static str {
        match self {
            Kind::Length => "a length",
            Kind::Force => "a force",
            Kind::Moment => "a moment",
            Kind::Stress => "a stress",
            Kind::Angle => "an angle",
        }
    }

    /// The accepted units, for messages.
    pub fn accepted(self) -> &'static str {
        match self {
            Kind::Length => "mm, cm, m, in, ft, or a bare number for mm",
            Kind::Force => "N, kN, MN, kip",
            Kind::Moment => "N mm, N m, kN cm, kN m, MN m, kip in, kip ft",
            Kind::Stress => "MPa, N/mm2, GPa, kN/cm2, ksi",
            Kind::Angle => "deg, rad",
        }
    }

    /// The unit that engineers use most.
    pub fn usual(self) -> &'static str {
        match self {
            Kind::Length => "mm",
            Kind::Force => "kN",
            Kind::Moment => "kN m",
            Kind::Stress => "MPa",
            Kind::Angle => "deg",
        }
    }

    /// Its dimension.
    pub fn dim(self) -> Dim {
        match self {
            Kind::Length => Dim::LENGTH,
            Kind::Force => Dim::FORCE,
            Kind::Moment => Dim::MOMENT,
            Kind::Stress => Dim::STRESS,
            Kind::Angle => Dim::ANGLE,
        }
    }
}

/// Reason why a text is not a quantity.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum UnitError {
    /// The text does not begin with a number.
    #[error("`{text}` is not {}: write a number and a unit ({})", kind.one(), kind.accepted())]
    NotANumber {
        /// The text as written.
        text: String,
        /// The expected kind.
        kind: Kind,
    },
    /// The suffix is not a unit of this kind.
    #[error(
        "`{text}` is not {}: `{suffix}` is not one of its units ({})",
        kind.one(),
        kind.accepted()
    )]
    WrongUnit {
        /// The text as written.
        text: String,
        /// Its suffix.
        suffix: String,
        /// The expected kind.
        kind: Kind,
    },
    /// A fraction with a unit other than inches.
    #[error(
        "`{text}` is not a length: a fraction is of inches, `3/4 in` or `1 1/4 in`; of other \
         units write decimals"
    )]
    Fraction {
        /// The text as written.
        text: String,
    },
    /// The number contains a comma.
    #[error(
        "`{text}` is not {}: a number has a point before its decimals and nothing between its \
         thousands{}",
        kind.one(),
        pointed(text)
    )]
    Comma {
        /// The text as written.
        text: String,
        /// The expected kind.
        kind: Kind,
    },
    /// The unit is missing.
    #[error(
        "{} {number} needs a unit: write `{number} {}` ({})",
        kind.word(),
        kind.usual(),
        kind.accepted()
    )]
    NoUnit {
        /// The number as written.
        number: String,
        /// The expected kind.
        kind: Kind,
    },
    /// The number is NaN or infinite.
    #[error("{} must be finite, not {number}", kind.word())]
    NotFinite {
        /// The number as written.
        number: String,
        /// The expected kind.
        kind: Kind,
    },
}

/// A text with the minus sign of typesetting (U+2212), which reports print, as that of a keyboard:
/// numbers of a report can be pasted into an input.
pub fn plain_minus(text: &str) -> Cow<'_, str> {
    match text.contains('−') {
        true => Cow::Owned(text.replace('−', "-")),
        false => Cow::Borrowed(text),
    }
}

/// Splits `120 kN m` into the number and its suffix.
pub(super) fn split(text: &str) -> Option<(f64, &str)> {
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

/// Splits `3/4 in`, `1 1/4 in`, `1-1/4"` into the number and its suffix. `None` if the text has no
/// fraction.
fn split_fraction(text: &str) -> Option<(f64, &str)> {
    let text = text.trim();
    let (sign, body) = text.strip_prefix('-').map_or((1.0, text), |rest| (-1.0, rest));
    let body = body.trim_start();
    // (value, number of digits); both parts of a fraction are whole numbers
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

/// Replaces a decimal comma: `20.5 mm` for `20,5 mm`. `None` if the comma may separate thousands,
/// as in `1,250`, or if the text has any other form.
pub fn with_point(text: &str) -> Option<String> {
    let (whole, rest) = text.trim().split_once(',')?;
    let digits = whole.trim_start_matches(['+', '-', '−']);
    let decimals: String = rest.chars().take_while(char::is_ascii_digit).collect();
    let unit = &rest[decimals.len()..];
    let a_number =
        !digits.is_empty() && digits.bytes().all(|b| b.is_ascii_digit()) && !decimals.is_empty();
    let thousands = decimals.len() == 3 && digits.len() <= 3 && !digits.starts_with('0');
    let clear = !thousands && !unit.contains([',', '.']);
    (a_number && clear).then(|| format!("{whole}.{decimals}{unit}"))
}

/// Last part of a message about a comma: the text with a decimal point, if it is clear.
fn pointed(text: &str) -> String {
    with_point(text).map_or_else(String::new, |t| format!("; write `{t}`"))
}

/// Reads a text as a quantity of the given kind, in internal units.
///
/// ```
/// use bracket_base::units::{Kind, parse};
/// assert_eq!(parse("1.5 cm", Kind::Length), Ok(15.0));
/// assert_eq!(parse("120 kN m", Kind::Moment), Ok(120.0e6));
/// assert!(parse("45", Kind::Stress).is_err());
/// ```
pub fn parse(text: &str, kind: Kind) -> Result<f64, UnitError> {
    let plain = plain_minus(text);
    let text = &*plain;
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

/// Converts inches to mm and removes the rounding error of the product: 0.75 in are exactly 19.05
/// mm.
fn inches(number: f64) -> f64 {
    let mm = number * INCH;
    let rounded = (mm * 1e9).round() / 1e9;
    if rounded.is_finite() { rounded } else { mm }
}

/// Value of a number without suffix: mm for a length, an error for every other kind.
pub fn bare(number: f64, kind: Kind) -> Result<f64, UnitError> {
    match kind {
        Kind::Length => finite(number, kind),
        _ => Err(UnitError::NoUnit { number: crate::diag::number(number), kind }),
    }
}

fn finite(value: f64, kind: Kind) -> Result<f64, UnitError> {
    if value.is_finite() {
        Ok(value)
    } else {
        Err(UnitError::NotFinite { number: crate::diag::number(value), kind })
    }
}
