//! Bounds as types: a number is a bound only with its certificate, and only [`Bracket::new`] joins
//! two bounds.

use crate::certify::certificate::{KinematicCertificate, StaticCertificate};
use crate::certify::tolerance::{TOLERANCE, in_order};

/// A lower bound −Π_c of the exact potential energy \[N mm\]; strict if its certificate is.
#[derive(Clone, Debug, PartialEq)]
pub struct LowerBound {
    value: f64,
    /// `½ ∫ σ:C⁻¹:σ` of the whole structure \[N mm\]; `None` without preload.
    strain_energy: Option<f64>,
    certificate: StaticCertificate,
}

/// An upper bound Π_p of the exact potential energy \[N mm\]; strict if its certificate is.
#[derive(Clone, Debug, PartialEq)]
pub struct UpperBound {
    value: f64,
    certificate: KinematicCertificate,
}

impl LowerBound {
    /// The bound that a certificate proves; the structure consists of `copies` of the meshed part.
    pub fn new(certificate: StaticCertificate, copies: u32) -> Self {
        let strain_energy = certificate.strain_energy.map(|e| e * f64::from(copies));
        Self { value: -certificate.energy * f64::from(copies), strain_energy, certificate }
    }
    /// Value \[N mm\].
    pub fn value(&self) -> f64 {
        self.value
    }
    /// The certificate of the bound.
    pub fn certificate(&self) -> &StaticCertificate {
        &self.certificate
    }
    /// True when every residual is within [`TOLERANCE`] and no weld carries more than its
    /// strength.
    pub fn is_strict(&self) -> bool {
        let c = &self.certificate;
        self.value.is_finite()
            && c.yields.is_none_or(|y| y <= 0.0)
            && [Some(c.equilibrium), Some(c.traction_jump), c.contact]
                .into_iter()
                .flatten()
                .all(|r| r <= TOLERANCE)
            && c.weld.is_none_or(|used| used <= 1.0)
    }
}

impl UpperBound {
    /// The bound that a certificate proves; the structure consists of `copies` of the meshed part.
    pub fn new(certificate: KinematicCertificate, copies: u32) -> Self {
        Self { value: certificate.energy * f64::from(copies), certificate }
    }
    /// Value \[N mm\].
    pub fn value(&self) -> f64 {
        self.value
    }
    /// The certificate of the bound.
    pub fn certificate(&self) -> &KinematicCertificate {
        &self.certificate
    }
    /// True when every residual is within [`TOLERANCE`].
    pub fn is_strict(&self) -> bool {
        let c = &self.certificate;
        self.value.is_finite()
            && [Some(c.compatibility), c.contact].into_iter().flatten().all(|r| r <= TOLERANCE)
    }
}

/// Two bounds that contradict each other, or a bound that is NaN: one of the two fields is wrong.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error(
    "the lower bound {lower:.9e} is not below the upper bound {upper:.9e}: one of the two fields \
     is not admissible"
)]
pub struct Contradiction {
    /// Lower bound.
    pub lower: f64,
    /// Upper bound.
    pub upper: f64,
}

/// Both bounds of the same quantity.
#[derive(Clone, Debug, PartialEq)]
pub struct Bracket {
    lower: LowerBound,
    upper: UpperBound,
}

impl Bracket {
    /// Joins two bounds; refuses NaN, and lower > upper beyond the tolerance.
    pub fn new(lower: LowerBound, upper: UpperBound) -> Result<Self, Contradiction> {
        if in_order(lower.value, upper.value) {
            Ok(Self { lower, upper })
        } else {
            Err(Contradiction { lower: lower.value, upper: upper.value })
        }
    }

    /// The lower bound.
    pub fn lower(&self) -> &LowerBound {
        &self.lower
    }

    /// The upper bound.
    pub fn upper(&self) -> &UpperBound {
        &self.upper
    }

    /// Relative gap `(Π_p + Π_c) / |Π_c|`; 0 when both energies vanish.
    ///
    /// With preload the energy may pass through zero: the gap is then relative to the largest of
    /// `|Π_p|`, `|Π_c|` and `½ ∫ σ:C⁻¹:σ`.
    ///
    /// # Source
    /// Paper, equation (7).
    pub fn gap(&self) -> f64 {
        let (lower, upper) = (self.lower.value.abs(), self.upper.value.abs());
        let scale = match self.lower.strain_energy {
            Some(energy) => lower.max(upper).max(energy),
            None if lower > 0.0 => lower,
            None => upper,
        };
        if scale > 0.0 { (self.upper.value - self.lower.value) / scale } else { 0.0 }
    }

    /// True when both bounds are strict.
    pub fn is_strict(&self) -> bool {
        self.lower.is_strict() && self.upper.is_strict()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn lower(value: f64) -> LowerBound {
        LowerBound::new(StaticCertificate { energy: -value, ..StaticCertificate::default() }, 1)
    }

    fn upper(value: f64) -> UpperBound {
        UpperBound::new(
            KinematicCertificate { energy: value, ..KinematicCertificate::default() },
            1,
        )
    }

    /// Lower above upper and NaN are refused; values equal to rounding are accepted.
    #[test]
    fn joins_only_bounds_in_order() {
        assert!(Bracket::new(lower(-2.0), upper(-1.5)).is_ok());
        assert!(Bracket::new(lower(-2.0), upper(-2.0 * (1.0 + 1e-12))).is_ok());
        assert!(Bracket::new(lower(-2.0), upper(-2.01)).is_err());
        assert!(Bracket::new(lower(f64::NAN), upper(1.0)).is_err());
        assert!(Bracket::new(lower(1.0), upper(f64::NAN)).is_err());
        assert!(Bracket::new(lower(f64::NAN), upper(f64::NAN)).is_err());
    }
}
