//! Loads and actions in the units that engineers use. The rounding is that of
//! [`bracket_base::math::figures`].

use crate::result::case_result::CaseResult;
use crate::result::demand::ActionValue;
use crate::result::quantity::{LoadSize, Quantity, Upper};
pub use bracket_base::math::figures::{
    Rounding, bracket, fixed, percent_up, residual, significant, utilisation,
};

impl CaseResult {
    /// The bracket of the only load at collapse, rounded outwards, and its unit; `None` unless both
    /// bounds are finite and positive.
    pub fn collapse_load(&self) -> Option<(String, String, &'static str)> {
        let (Quantity::LoadFactor, Some(load)) = (self.quantity, self.load) else { return None };
        let (lower, Upper::Finite(upper)) = (self.lower.filter(|l| *l > 0.0)?, self.upper?) else {
            return None;
        };
        let size = load.value() * load.scale();
        let (low, high) = bracket((lower * size).next_down(), (upper * size).next_up(), 3);
        Some((low, high, load.unit()))
    }
}

/// A fraction in percent, with three digits.
pub fn percent(fraction: f64) -> String {
    significant(100.0 * fraction, 3, Rounding::Nearest)
}

impl LoadSize {
    /// Unit of the report.
    pub fn unit(self) -> &'static str {
        match self {
            LoadSize::Force(_) => "kN",
            LoadSize::Moment(_) => "kN m",
        }
    }

    /// Factor from the internal unit to that of the report.
    pub fn scale(self) -> f64 {
        match self {
            LoadSize::Force(_) => 1e-3,
            LoadSize::Moment(_) => 1e-6,
        }
    }

    /// The value in words: `351.4 kN`.
    pub fn words(self) -> String {
        format!(
            "{} {}",
            significant(self.value() * self.scale(), 4, Rounding::Nearest),
            self.unit()
        )
    }

    /// The motion on which the load does work, and the unit of that motion.
    pub fn moves(self) -> (&'static str, &'static str) {
        match self {
            LoadSize::Force(_) => ("displacement", "mm"),
            LoadSize::Moment(_) => ("rotation", "rad"),
        }
    }
}

impl ActionValue {
    /// Value in the unit of the report, and the unit.
    pub(crate) fn shown(self) -> (f64, &'static str) {
        match self {
            ActionValue::Force(v) => (1e-3 * v, "kN"),
            ActionValue::Moment(v) => (1e-6 * v, "kN m"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn loads_are_reported_in_the_units_of_engineers() {
        let text = |l: LoadSize| {
            format!(
                "{}, {} in {}, {}/{}",
                l.words(),
                l.moves().0,
                l.moves().1,
                l.unit(),
                l.moves().1
            )
        };
        assert_eq!(text(LoadSize::Force(351_360.0)), "351.4 kN, displacement in mm, kN/mm");
        assert_eq!(text(LoadSize::Moment(12.5e6)), "12.50 kN m, rotation in rad, kN m/rad");
    }
}
