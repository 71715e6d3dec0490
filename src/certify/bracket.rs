//! Bounds as types: a number is a bound only with its certificate, and only [`Bracket::new`] joins
//! two.

use crate::certify::certificate::{KinematicCertificate, StaticCertificate, TOLERANCE};

/// A lower bound, strict as far as its certificate says, of the exact potential energy, −Π_c \[N
/// mm\].
#[derive(Clone, Debug, PartialEq)]
pub struct LowerBound {
    value: f64,
    /// With preload: ½ ∫ σ:C⁻¹:σ of the whole structure \[N mm\].
    strain_energy: Option<f64>,
    certificate: StaticCertificate,
}

/// An upper bound, strict as far as its certificate says, of the exact potential energy, Π_p \[N
/// mm\].
#[derive(Clone, Debug, PartialEq)]
pub struct UpperBound {
    value: f64,
    certificate: KinematicCertificate,
}

impl LowerBound {
    /// From a certificate; `copies` of the meshed part make the structure.
    pub fn new(certificate: StaticCertificate, copies: u32) -> Self {
        let strain_energy = certificate.strain_energy.map(|e| e * f64::from(copies));
        Self { value: -certificate.energy * f64::from(copies), strain_energy, certificate }
    }
    /// Its value.
    pub fn value(&self) -> f64 {
        self.value
    }
    /// What it rests on.
    pub fn certificate(&self) -> &StaticCertificate {
        &self.certificate
    }
    /// True when every residual is within [`TOLERANCE`] and no weld bears more than its strength.
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
    /// From a certificate; `copies` of the meshed part make the structure.
    pub fn new(certificate: KinematicCertificate, copies: u32) -> Self {
        Self { value: certificate.energy * f64::from(copies), certificate }
    }
    /// Its value.
    pub fn value(&self) -> f64 {
        self.value
    }
    /// What it rests on.
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

/// Two bounds that contradict each other: one of them is wrong.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error(
    "the lower bound {lower:.9e} exceeds the upper bound {upper:.9e}: one of the two fields is \
     not admissible"
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
    /// Joins two bounds; refuses lower > upper beyond rounding.
    pub fn new(lower: LowerBound, upper: UpperBound) -> Result<Self, Contradiction> {
        let scale = lower.value.abs().max(upper.value.abs());
        if lower.value > upper.value + 1e-9 * scale {
            return Err(Contradiction { lower: lower.value, upper: upper.value });
        }
        Ok(Self { lower, upper })
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
    /// With preload, under which the energy passes through zero, the largest of `|Π_p|`, `|Π_c|`
    /// and `½ ∫ σ:C⁻¹:σ` takes the place of `|Π_c|`.
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
