//! Bounds of the load factor as types: a number is a bound only with its certificate, and only
//! [`FactorBracket::new`] joins two bounds.

use crate::certify::bracket::Contradiction;
use crate::certify::limit_certificate::{LowerCertificate, UpperCertificate};
use crate::certify::tolerance::{TOLERANCE, in_order};

/// A lower bound of the limit load factor; strict if its certificate is.
#[derive(Clone, Debug, PartialEq)]
pub struct LowerFactor {
    certificate: LowerCertificate,
}

/// An upper bound of the limit load factor; strict if its certificate is.
#[derive(Clone, Debug, PartialEq)]
pub struct UpperFactor {
    certificate: UpperCertificate,
}

/// True when every residual is within [`TOLERANCE`].
fn within<const N: usize>(residuals: [Option<f64>; N]) -> bool {
    residuals.into_iter().flatten().all(|r| r <= TOLERANCE)
}

impl LowerFactor {
    /// The bound that a certificate proves.
    pub fn new(certificate: LowerCertificate) -> Self {
        Self { certificate }
    }
    /// Value, rounded down; zero is exact because no live load acts then.
    pub fn value(&self) -> f64 {
        let factor = self.certificate.factor;
        if factor == 0.0 { 0.0 } else { factor.next_down() }
    }
    /// The certificate of the bound.
    pub fn certificate(&self) -> &LowerCertificate {
        &self.certificate
    }
    /// True when every residual is within [`TOLERANCE`], the stress within the yield surface and
    /// the tractions of welds within their strength, the allowance for the residuals included.
    pub fn is_strict(&self) -> bool {
        let c = &self.certificate;
        c.factor.is_finite()
            && within([Some(c.equilibrium), Some(c.traction_jump), c.contact])
            && c.worst() + c.cover <= 1.0
    }
}

impl UpperFactor {
    /// The bound that a certificate proves.
    pub fn new(certificate: UpperCertificate) -> Self {
        Self { certificate }
    }
    /// Value including the allowance for the residuals, rounded up.
    pub fn value(&self) -> f64 {
        (self.certificate.factor + self.certificate.cover).next_up()
    }
    /// The certificate of the bound.
    pub fn certificate(&self) -> &UpperCertificate {
        &self.certificate
    }
    /// True when every residual is within [`TOLERANCE`] and the live loads do positive work.
    pub fn is_strict(&self) -> bool {
        let c = &self.certificate;
        self.value().is_finite()
            && c.live_power > 0.0
            && within([Some(c.volume), Some(c.rigid), Some(c.compatibility), c.contact])
    }
}

/// Both bounds of one load factor.
#[derive(Clone, Debug, PartialEq)]
pub struct FactorBracket {
    lower: LowerFactor,
    upper: UpperFactor,
}

impl FactorBracket {
    /// Joins two bounds; refuses NaN, and lower > upper beyond the tolerance.
    pub fn new(lower: LowerFactor, upper: UpperFactor) -> Result<Self, Contradiction> {
        let (low, up) = (lower.value(), upper.value());
        if in_order(low, up) {
            Ok(Self { lower, upper })
        } else {
            Err(Contradiction { lower: low, upper: up })
        }
    }

    /// The lower bound.
    pub fn lower(&self) -> &LowerFactor {
        &self.lower
    }

    /// The upper bound.
    pub fn upper(&self) -> &UpperFactor {
        &self.upper
    }

    /// `(λ_up − λ_low) / λ_low`; infinite when the lower bound is not positive.
    pub fn gap(&self) -> f64 {
        let (low, up) = (self.lower.value(), self.upper.value());
        if low > 0.0 { (up - low) / low } else { f64::INFINITY }
    }

    /// True when both bounds are strict.
    pub fn is_strict(&self) -> bool {
        self.lower.is_strict() && self.upper.is_strict()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn lower(factor: f64) -> LowerFactor {
        LowerFactor::new(LowerCertificate {
            factor,
            utilisation: 1.0 - 1e-9,
            ..LowerCertificate::default()
        })
    }

    fn upper(factor: f64) -> UpperFactor {
        UpperFactor::new(UpperCertificate {
            factor,
            live_power: 1.0,
            ..UpperCertificate::default()
        })
    }

    /// Lower above upper is refused, numbers equal to rounding are not, and the gap is relative to
    /// the lower bound.
    #[test]
    fn joins_only_what_agrees() {
        let bracket = FactorBracket::new(lower(2.0), upper(2.5)).expect("in order");
        assert!((bracket.gap() - 0.25).abs() < 1e-12 && bracket.is_strict());
        assert!(FactorBracket::new(lower(2.0), upper(2.0 * (1.0 - 1e-12))).is_ok());
        assert!(FactorBracket::new(lower(2.0), upper(1.99)).is_err());
        assert!(FactorBracket::new(lower(2.0), upper(f64::NAN)).is_err());
        assert!(FactorBracket::new(lower(f64::NAN), upper(2.0)).is_err());
        assert_eq!(
            FactorBracket::new(lower(0.0), upper(1.0)).expect("in order").gap(),
            f64::INFINITY
        );
        assert!(lower(3.0).value() < 3.0 && upper(3.0).value() > 3.0);
    }

    /// Each residual alone makes a bound not strict.
    #[test]
    fn strict_only_within_tolerance() {
        let bad = 2.0 * TOLERANCE;
        let l = |f: fn(&mut LowerCertificate, f64), x: f64| {
            let mut c = lower(1.0).certificate;
            f(&mut c, x);
            LowerFactor::new(c).is_strict()
        };
        assert!(lower(1.0).is_strict() && upper(1.0).is_strict());
        assert!(!l(|c, x| c.equilibrium = x, bad) && !l(|c, x| c.traction_jump = x, bad));
        assert!(
            !l(|c, x| c.contact = Some(x), bad)
                && !l(|c, x| c.cover = x, bad)
                && !l(|c, x| c.utilisation = x, 1.1)
        );
        assert!(!l(|c, x| c.equilibrium = x, f64::NAN) && !l(|c, x| c.utilisation = x, f64::NAN));
        let u = |f: fn(&mut UpperCertificate, f64), x: f64| {
            let mut c = upper(1.0).certificate;
            f(&mut c, x);
            UpperFactor::new(c).is_strict()
        };
        assert!(
            !u(|c, x| c.volume = x, bad)
                && !u(|c, x| c.rigid = x, bad)
                && !u(|c, x| c.compatibility = x, bad)
        );
        assert!(!u(|c, x| c.contact = Some(x), bad) && !u(|c, x| c.live_power = x, -1.0));
        assert!(!u(|c, x| c.volume = x, f64::NAN) && !u(|c, x| c.factor = x, f64::NAN));
    }
}
