//! Compares one bound of a result with the bound recomputed from its field.

use crate::result::result_file::CaseResult;
use bracket_engine::certify::TOLERANCE;
use serde::Serialize;

/// A claimed and a recomputed bound.
#[derive(Clone, Debug, Serialize)]
pub struct Finding {
    /// Load case.
    pub case: String,
    /// Name of the bound.
    pub bound: &'static str,
    /// Value in the result.
    pub claimed: f64,
    /// Value that the certificate of the stored field gives.
    pub recomputed: f64,
    /// Worst residual of the certificate.
    pub worst_residual: f64,
    /// Worst residual at random points.
    pub worst_at_random_points: f64,
    /// True if the recomputed certificate is strict, at the random points as well.
    pub strict: bool,
    /// True if the claim is confirmed.
    pub confirmed: bool,
}

/// The numbers of a finding.
pub struct Numbers {
    /// Value in the result.
    pub claimed: f64,
    /// Value that the certificate of the stored field gives.
    pub recomputed: f64,
    /// Worst residual of the certificate.
    pub residual: f64,
    /// Worst residual at random points.
    pub at_random_points: f64,
}

impl Finding {
    /// Confirms a claim if the numbers agree to 1e-9 and, where strictness is claimed, the
    /// certificate is strict at the random points as well.
    pub fn new(
        case: &CaseResult,
        bound: &'static str,
        numbers: Numbers,
        strict: bool,
        claims_strict: bool,
    ) -> Self {
        let Numbers { claimed, recomputed, residual, at_random_points } = numbers;
        let same = (claimed - recomputed).abs() <= 1e-9 * claimed.abs().max(recomputed.abs());
        let admissible = strict && at_random_points <= TOLERANCE;
        Self {
            case: case.name.clone(),
            bound,
            claimed,
            recomputed,
            worst_residual: residual,
            worst_at_random_points: at_random_points,
            strict: admissible,
            confirmed: same && (admissible || !claims_strict),
        }
    }
}
