//! Dimensions, and quantities in internal units.

use std::fmt;

/// Exponents of length, force and angle. Every physical quantity in the program has a dimension of
/// this form.
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
    /// Dimension of the quantity.
    pub dim: Dim,
}

/// One inch \[mm\], exact.
pub(super) const INCH: f64 = 25.4;
/// One foot \[mm\], exact.
const FOOT: f64 = 12.0 * INCH;
/// One pound-force \[N\], exact: 0.45359237 kg at 9.80665 m/s².
const POUND: f64 = 4.448_221_615_260_5;

/// Suffix, factor to the internal unit, and dimension of each unit.
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
    ("°", std::f64::consts::PI / 180.0, Dim::ANGLE),
];

/// Factor and dimension of a unit suffix. `*`, `·` and repeated blanks between factors count as one
/// blank.
pub fn unit(suffix: &str) -> Option<(f64, Dim)> {
    let spaced = suffix.replace(['*', '·', '\u{a0}'], " ").replace('²', "2");
    let name = spaced.split_whitespace().collect::<Vec<_>>().join(" ");
    UNITS.iter().find(|(n, _, _)| *n == name).map(|&(_, factor, dim)| (factor, dim))
}
