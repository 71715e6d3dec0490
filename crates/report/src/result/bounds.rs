//! Types for the certified bounds of a load case, and joining the bounds of several passes.
//!
//! A pass returns its bounds with their certificates. Only [`Bracket::new`] and
//! [`FactorBracket::new`] join a lower and an upper bound; plain numbers appear only where the
//! entry of `result.json` is written.

use crate::result::certificate::Certificate;
use crate::result::quantity::Upper;
use bracket_engine::certify::bracket::{Bracket, Contradiction, LowerBound, UpperBound};
use bracket_engine::certify::{FactorBracket, LowerFactor, UpperFactor};

/// The bounds of one load case.
#[derive(Clone, Debug, PartialEq)]
pub enum CaseBounds {
    /// Bounds of the potential energy.
    Energy {
        /// The lower bound, if there is one.
        lower: Option<LowerBound>,
        /// The upper bound, if there is one.
        upper: Option<UpperBound>,
    },
    /// Bounds of the load factor.
    Factor {
        /// The lower bound, if there is one; under Coulomb's law the bound without friction.
        lower: Option<LowerFactor>,
        /// The upper limit, if there is one.
        upper: Option<FactorLimit>,
    },
}

/// The upper limit of a load factor.
#[derive(Clone, Debug, PartialEq)]
pub enum FactorLimit {
    /// Bounded by a mechanism that dissipates.
    Mechanism(UpperFactor),
    /// Bounded by this mechanism at zero load: the load factor is 0.
    FreeMechanism(UpperFactor),
    /// Not bounded: the loads can grow without limit.
    Unbounded,
}

/// The numbers of a joined bracket.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct JoinedNumbers {
    /// Lower bound, unit of the case's quantity.
    pub lower: f64,
    /// Upper bound, unit of the case's quantity.
    pub upper: f64,
    /// Relative gap, a fraction; `None` if it is infinite because the lower bound is 0.
    pub gap: Option<f64>,
}

impl CaseBounds {
    /// Value of the lower bound.
    pub fn lower(&self) -> Option<f64> {
        match self {
            CaseBounds::Energy { lower, .. } => lower.as_ref().map(LowerBound::value),
            CaseBounds::Factor { lower, .. } => lower.as_ref().map(LowerFactor::value),
        }
    }

    /// Value of the upper bound.
    pub fn upper(&self) -> Option<Upper> {
        match self {
            CaseBounds::Energy { upper, .. } => upper.as_ref().map(|b| Upper::Finite(b.value())),
            CaseBounds::Factor { upper, .. } => upper.as_ref().map(|limit| match limit {
                FactorLimit::Mechanism(b) => Upper::Finite(b.value()),
                FactorLimit::FreeMechanism(_) => Upper::Finite(0.0),
                FactorLimit::Unbounded => Upper::UNBOUNDED,
            }),
        }
    }

    /// Residuals of the stress field behind the lower bound.
    pub fn lower_certificate(&self) -> Option<Certificate> {
        match self {
            CaseBounds::Energy { lower, .. } => lower.as_ref().map(Certificate::from),
            CaseBounds::Factor { lower, .. } => lower.as_ref().map(Certificate::from),
        }
    }

    /// Residuals of the motion behind the upper bound; a load factor without limit has none.
    pub fn upper_certificate(&self) -> Option<Certificate> {
        match self {
            CaseBounds::Energy { upper, .. } => upper.as_ref().map(Certificate::from),
            CaseBounds::Factor { upper, .. } => match upper.as_ref()? {
                FactorLimit::Mechanism(b) | FactorLimit::FreeMechanism(b) => Some(b.into()),
                FactorLimit::Unbounded => None,
            },
        }
    }

    /// Joins the upper bound of `self` and the lower bound of `other` to a bracket of one quantity.
    /// `None` if one of them is missing or if the loads can grow without limit. Bounds that
    /// contradict each other are refused.
    pub fn join(&self, other: &Self) -> Result<Option<JoinedNumbers>, Contradiction> {
        match (self, other) {
            (
                CaseBounds::Energy { upper: Some(upper), .. },
                CaseBounds::Energy { lower: Some(lower), .. },
            ) => {
                let bracket = Bracket::new(lower.clone(), upper.clone())?;
                let (lower, upper) = (bracket.lower().value(), bracket.upper().value());
                Ok(Some(JoinedNumbers { lower, upper, gap: Some(bracket.gap()) }))
            }
            (
                CaseBounds::Factor { upper: Some(FactorLimit::Mechanism(upper)), .. },
                CaseBounds::Factor { lower: Some(lower), .. },
            ) => {
                let bracket = FactorBracket::new(lower.clone(), upper.clone())?;
                let gap = Some(bracket.gap()).filter(|g| g.is_finite());
                let (lower, upper) = (bracket.lower().value(), bracket.upper().value());
                Ok(Some(JoinedNumbers { lower, upper, gap }))
            }
            (
                CaseBounds::Factor { upper: Some(FactorLimit::FreeMechanism(_)), .. },
                CaseBounds::Factor { lower: Some(lower), .. },
            ) => {
                // the mechanism's own factor is negative if the dead loads drive it too: the limit
                // is then 0, and a positive lower bound contradicts it
                let lower = lower.value();
                if lower > 0.0 {
                    return Err(Contradiction { lower, upper: 0.0 });
                }
                Ok(Some(JoinedNumbers { lower, upper: 0.0, gap: None }))
            }
            _ => Ok(None),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use bracket_engine::certify::limit_certificate::{LowerCertificate, UpperCertificate};

    fn bounds(lower: Option<f64>, upper: Option<FactorLimit>) -> CaseBounds {
        let lower = lower.map(|factor| {
            LowerFactor::new(LowerCertificate { factor, ..LowerCertificate::default() })
        });
        CaseBounds::Factor { lower, upper }
    }

    fn mechanism(factor: f64) -> Option<FactorLimit> {
        let certificate = UpperCertificate { factor, ..UpperCertificate::default() };
        Some(FactorLimit::Mechanism(UpperFactor::new(certificate)))
    }

    /// The best bounds of two passes give a bracket with its gap. Bounds that contradict each other
    /// are refused with both numbers.
    #[test]
    fn bounds_of_two_passes_join_or_are_refused() {
        let (coarse, fine) = (bounds(Some(1.0), mechanism(1.5)), bounds(Some(1.2), mechanism(1.6)));
        let joined = coarse.join(&fine).expect("in order").expect("both bounds");
        assert!((joined.gap.expect("positive") - 0.25).abs() < 1e-12, "{joined:?}");
        let refused = bounds(None, mechanism(1.1)).join(&fine).expect_err("1.2 > 1.1");
        assert!(refused.lower < 1.2 && refused.upper > 1.1, "{refused:?}");
        assert_eq!(bounds(None, None).join(&fine), Ok(None));
        assert_eq!(bounds(None, Some(FactorLimit::Unbounded)).join(&fine), Ok(None));
    }

    /// A mechanism at zero load leaves no gap and contradicts every positive lower bound.
    #[test]
    fn a_free_mechanism_contradicts_a_positive_lower_bound() {
        let at_zero = UpperFactor::new(UpperCertificate::default());
        let free = bounds(Some(0.0), Some(FactorLimit::FreeMechanism(at_zero)));
        let joined = free.join(&free).expect("0 and 0").expect("both bounds");
        assert_eq!((joined.lower, joined.upper, joined.gap), (0.0, 0.0, None));
        assert!(free.join(&bounds(Some(0.1), None)).is_err());
    }
}
