//! Units of the values of a check, and how reports print them.

use serde::{Deserialize, Serialize};

/// Unit of a value of a check. Values are always in the internal units.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub enum Unit {
    /// A pure number.
    #[default]
    #[serde(rename = "-")]
    Number,
    /// Length \[mm\].
    #[serde(rename = "mm")]
    Length,
    /// Area \[mm²\].
    #[serde(rename = "mm2")]
    Area,
    /// Force \[N\].
    #[serde(rename = "N")]
    Force,
    /// Force per length \[N/mm\].
    #[serde(rename = "N/mm")]
    ForcePerLength,
    /// Stress \[MPa\].
    #[serde(rename = "MPa")]
    Stress,
    /// Moment \[N mm\].
    #[serde(rename = "N mm")]
    Moment,
    /// Rotational stiffness \[N mm/rad\].
    #[serde(rename = "N mm/rad")]
    Rotational,
}

impl Unit {
    /// Factor from the internal unit to the printed one, and the name of the printed one: forces in
    /// kN, moments in kN m.
    pub fn printed(self) -> (f64, &'static str) {
        match self {
            Unit::Number => (1.0, ""),
            Unit::Length => (1.0, "mm"),
            Unit::Area => (1.0, "mm²"),
            Unit::Force => (1e-3, "kN"),
            Unit::ForcePerLength => (1.0, "N/mm"),
            Unit::Stress => (1.0, "MPa"),
            Unit::Moment => (1e-6, "kN m"),
            Unit::Rotational => (1e-6, "kN m/rad"),
        }
    }

    /// A value as a report prints it, with its unit.
    pub fn show(self, value: f64) -> String {
        let (factor, name) = self.printed();
        let text = number(value * factor);
        if name.is_empty() { text } else { format!("{text} {name}") }
    }
}

/// A number with four significant digits, all digits of whole numbers, no trailing zeros.
pub fn number(x: f64) -> String {
    if x == 0.0 || !x.is_finite() {
        return if x == 0.0 { "0".into() } else { x.to_string() };
    }
    let power = x.abs().log10().floor();
    if !(-4.0..9.0).contains(&power) {
        return format!("{x:.3e}");
    }
    let text = format!("{x:.*}", (3 - power as i32).max(0) as usize);
    match text.contains('.') {
        true => text.trim_end_matches('0').trim_end_matches('.').to_owned(),
        false => text,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_keep_four_digits_and_no_zeros() {
        let cases = [
            (0.0, "0"),
            (0.9, "0.9"),
            (90432.0, "90432"),
            (1.25, "1.25"),
            (2.11818, "2.118"),
            (-33.4, "-33.4"),
        ];
        for (x, text) in
            cases.into_iter().chain([(1e12, "1.000e12"), (1234.5, "1234"), (0.0001, "0.0001")])
        {
            assert_eq!(number(x), text);
        }
        assert_eq!(Unit::Force.show(90_432.0), "90.43 kN");
        assert_eq!(Unit::Number.show(0.606), "0.606");
    }
}
