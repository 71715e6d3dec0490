//! Recomputation of the bounds of the load factor.

use super::case_files::{CaseFiles, POINTS};
use super::finding::{Finding, Numbers};
use crate::result::fields::field_files::{
    lower_grid, read_lower, read_stress, read_velocity, stress_grid, velocity_grid,
};
use crate::result::file_names::{DEAD_FIELD, LIVE_FIELD};
use crate::result::limit_case::limit_case_result;
use crate::result::result_file::CaseResult;
use crate::result::result_file::FrictionModel;
use crate::result::result_file::RawBracket;
use crate::result::result_file::Upper;
use bracket_base::diag::{Diagnostic, Diagnostics};
use bracket_engine::analysis::limit::{self, LimitPass};
use bracket_engine::certify::fields::StressField;
use bracket_engine::certify::free_mechanism::FreeMechanism;
use bracket_engine::certify::free_mechanism::certify_free;
use bracket_engine::certify::free_mechanism::is_free;
use bracket_engine::certify::limit_certificate::{
    certify_lower, certify_upper, dissipation_densities,
};
use bracket_engine::certify::sampling::{sample_live, sample_lower, sample_upper};
use bracket_engine::certify::unlimited::Unlimited;
use bracket_engine::certify::unlimited::certify_unlimited;
use bracket_engine::certify::velocity_field::VelocityField;
use bracket_engine::certify::{FactorBracket, LowerFactor, UpperFactor};
use bracket_engine::model::AnalysisModel;

/// Kind of the field file with the stress of the lower bound without friction.
const SMOOTH_FIELD: &str = "static_frictionless";

impl CaseFiles<'_> {
    /// Recomputes the bounds of the load factor and the entry made from them.
    pub fn factors(
        &self,
        refuted: &mut Vec<String>,
    ) -> Result<(Vec<Finding>, CaseResult, LimitPass), Diagnostics> {
        let Self { model, case, wanted: [kinematic, statics, frictionless], .. } = *self;
        let claims_strict = case.certificate.is_some_and(|c| c.strict);
        let coulomb = case.problem == FrictionModel::Coulomb;
        let mut findings = Vec::new();
        let mut pass = LimitPass::default();
        let raw = if coulomb { case.associated.and_then(|a| a.lower) } else { case.lower };
        if let Some(claimed) = self.claim(raw, "static").filter(|_| statics) {
            // a raw bound beside the answer is reported only if it is strict
            let (mut found, bound, stress) =
                self.lower_factor(model, "static", claimed, claims_strict || coulomb, refuted)?;
            found.bound = if coulomb { "lower, associated" } else { "lower" };
            findings.extend((raw.is_some() || bound.is_strict() || !coulomb).then_some(found));
            pass.lower = Some(bound);
            pass.stress = Some(stress);
        }
        let smooth =
            case.frictionless.and_then(|f| f.lower).or(if coulomb { case.lower } else { None });
        if let Some(claimed) = self.claim(smooth, SMOOTH_FIELD).filter(|_| frictionless) {
            let without = model.without_friction();
            let strict = claims_strict || !coulomb;
            let (mut found, bound, stress) =
                self.lower_factor(&without, SMOOTH_FIELD, claimed, strict, refuted)?;
            found.bound = if coulomb { "lower" } else { "lower, frictionless" };
            findings.extend((smooth.is_some() || bound.is_strict() || coulomb).then_some(found));
            pass.frictionless = Some(bound);
            pass.frictionless_stress = Some(stress);
        }
        let upper = self.claim(case.upper.and_then(|u| u.finite()), "kinematic");
        if let Some(claimed) = upper.filter(|_| kinematic) {
            let field =
                read_velocity(model, &self.field("kinematic")?).map_err(Diagnostic::from)?;
            if claimed == 0.0 {
                let certificate = certify_free(model, &field);
                let free = is_free(&certificate);
                let worst = certificate
                    .rigid
                    .max(certificate.compatibility)
                    .max(certificate.contact.unwrap_or(0.0));
                // velocities that are not a free mechanism do not prove that the bound is zero
                let recomputed = if free { 0.0 } else { f64::INFINITY };
                let random = sample_upper(&model.on_rigid_ground(), &field, POINTS).gap_cone;
                let rests = vec![0.0; model.mesh.tets.len()];
                self.compare_grid("kinematic", &velocity_grid(model, &field, rests), refuted)?;
                findings.push(Finding::new(
                    case,
                    "upper",
                    Numbers { claimed, recomputed, residual: worst, at_random_points: random },
                    free,
                    claims_strict,
                ));
                pass.free = free.then_some(FreeMechanism { field, certificate });
            } else {
                let (found, bound) = self.upper_factor(&field, claimed, claims_strict);
                let densities = dissipation_densities(model, &field, limit::SUBDIVISIONS);
                self.compare_grid("kinematic", &velocity_grid(model, &field, densities), refuted)?;
                findings.push(found);
                pass.upper = Some(bound);
                pass.velocity = Some(field);
            }
        }
        for (lower, bracket) in
            [(&pass.lower, &mut pass.bracket), (&pass.frictionless, &mut pass.coulomb)]
        {
            let (Some(l), Some(u)) = (lower, &pass.upper) else { continue };
            match FactorBracket::new(l.clone(), u.clone()) {
                Ok(b) => *bracket = Some(b),
                Err(e) => refuted.push(format!("{}: {e}", case.name)),
            }
        }
        let unbounded = matches!(case.upper, Some(Upper::Unbounded(_)));
        if unbounded && claims_strict || self.has(LIVE_FIELD) {
            let (found, unlimited) = self.no_limit(refuted)?;
            findings.push(found);
            pass.unlimited = Some(unlimited);
        }
        let mut found = limit_case_result(&case.name, model, &pass, None);
        // without strict proof the claim remains an estimate
        if let Some(Upper::Unbounded(_)) = case.upper {
            found.upper = case.upper;
            if let Some(raw) = case.associated.filter(|a| a.upper == case.upper) {
                let lower = found.associated.and_then(|a| a.lower);
                found.associated = Some(RawBracket { lower, ..raw });
            }
        }
        Ok((findings, found, pass))
    }

    /// The upper bound of stored velocities.
    fn upper_factor(
        &self,
        field: &VelocityField,
        claimed: f64,
        claims_strict: bool,
    ) -> (Finding, UpperFactor) {
        let sampled = sample_upper(self.model, field, POINTS);
        let bound = UpperFactor::new(certify_upper(self.model, field, limit::SUBDIVISIONS));
        let c = bound.certificate();
        let worst = [c.volume, c.rigid, c.compatibility, c.contact.unwrap_or(0.0)]
            .into_iter()
            .fold(0.0, f64::max);
        let numbers = Numbers {
            claimed,
            recomputed: bound.value(),
            residual: worst,
            at_random_points: sampled.strain.max(sampled.gap_cone).max(sampled.held),
        };
        (Finding::new(self.case, "upper", numbers, bound.is_strict(), claims_strict), bound)
    }

    /// Proves from the stored fields that the load factor has no limit. The numbers of the finding
    /// are the remaining deviator, because nothing else is claimed.
    fn no_limit(&self, refuted: &mut Vec<String>) -> Result<(Finding, Unlimited), Diagnostics> {
        let model = self.model;
        let field = read_stress(model, &self.field(LIVE_FIELD)?).map_err(Diagnostic::from)?;
        let dead = match model.has_dead_loads() {
            true => Some(read_lower(model, &self.field(DEAD_FIELD)?).map_err(Diagnostic::from)?.0),
            false => None,
        };
        self.compare_grid(LIVE_FIELD, &stress_grid(model, &field), refuted)?;
        if let Some(dead) = &dead {
            self.compare_grid(DEAD_FIELD, &lower_grid(model, dead, 0.0), refuted)?;
        }
        let certificate = certify_unlimited(model, &field, dead.as_ref());
        let c = &certificate;
        let residuals = [c.equilibrium, c.traction_jump, c.deviator, c.contact.unwrap_or(0.0)];
        let worst = residuals.into_iter().fold(0.0, f64::max);
        let sampled = sample_live(model, &field, POINTS);
        let numbers =
            Numbers { claimed: 0.0, recomputed: 0.0, residual: worst, at_random_points: sampled };
        let found = Finding::new(self.case, "no limit", numbers, certificate.is_strict(), true);
        Ok((found, Unlimited { field, dead, certificate }))
    }

    /// The lower bound of a stored stress field of `model`.
    fn lower_factor(
        &self,
        model: &AnalysisModel,
        kind: &str,
        claimed: f64,
        claims_strict: bool,
        refuted: &mut Vec<String>,
    ) -> Result<(Finding, LowerFactor, StressField), Diagnostics> {
        let (stress, factor) = read_lower(model, &self.field(kind)?).map_err(Diagnostic::from)?;
        self.compare_grid(kind, &lower_grid(model, &stress, factor), refuted)?;
        let sampled = sample_lower(model, &stress, factor, POINTS);
        let bound = LowerFactor::new(certify_lower(model, &stress, factor));
        let c = bound.certificate();
        let outside = (c.worst() + c.cover - 1.0).max(0.0);
        let residuals = [c.equilibrium, c.traction_jump, c.contact.unwrap_or(0.0), outside];
        let worst = residuals.into_iter().fold(0.0, f64::max);
        let random =
            sampled.traction_jump.max(sampled.traction_cone).max(sampled.utilisation - 1.0);
        let numbers = Numbers {
            claimed,
            recomputed: bound.value(),
            residual: worst,
            at_random_points: random,
        };
        Ok((
            Finding::new(self.case, "lower", numbers, bound.is_strict(), claims_strict),
            bound,
            stress,
        ))
    }
}
