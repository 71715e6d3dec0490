//! Recomputation of the bounds of the energy.

use super::case_files::{CaseFiles, POINTS};
use super::finding::{Finding, Numbers};
use crate::result::energy_case::case_result;
use crate::result::fields::field_files::{
    displacement_grid, read_displacement, read_shift, read_stress, shift_grid, stress_grid,
    yielding_stress_grid,
};
use crate::result::fields::plastic_file::{plastic_grid, read_plastic};
use crate::result::preload::{close_cuts, of_cut};
use crate::result::result_file::CaseResult;
use bracket_base::diag::{Diagnostic, Diagnostics};
use bracket_engine::analysis::energy_pass::EnergyPass;
use bracket_engine::analysis::preloaded_bolt::preloaded_bolts;
use bracket_engine::certify::bracket::{Bracket, LowerBound, UpperBound};
use bracket_engine::certify::certificate::{certify_displacement, certify_stress};
use bracket_engine::certify::contributions::{contributions, plastic_contributions};
use bracket_engine::certify::coulomb_shift::distance_from_coulomb;
use bracket_engine::certify::fields::DisplacementField;
use bracket_engine::certify::plastic_certificate::{
    certify_plastic_motion, certify_yielding_stress,
};
use bracket_engine::certify::sampling::{sample, sample_lower};
use bracket_engine::model::AnalysisKind;
use bracket_engine::model::AnalysisModel;
use bracket_engine::model::loads::Loads;

/// Largest distance of the shift of the contact cones from the slips of the displacement, as a
/// fraction of the largest slip. The fixed point ends far below this value; a shift that
/// contradicts Coulomb's law is above it.
const FAR_FROM_COULOMB: f64 = 0.02;

impl CaseFiles<'_> {
    /// Recomputes the bounds of the energy and the entry made from them.
    pub fn energies(
        &self,
        refuted: &mut Vec<String>,
    ) -> Result<(Vec<Finding>, CaseResult, EnergyPass), Diagnostics> {
        let Self { model: given, case, wanted: [kinematic, statics, _], .. } = *self;
        let claims_strict = case.certificate.is_some_and(|c| c.strict);
        let yields = given.analysis == AnalysisKind::Elastoplastic;
        let mut findings = Vec::new();
        let mut pass =
            EnergyPass { fixed_point: case.fixed_point.clone(), ..EnergyPass::default() };
        let bounded = case.lower.is_some() || case.upper.is_some();
        if given.has_coulomb_friction() && (bounded || self.has("shift")) {
            pass.shift = read_shift(given, &self.field("shift")?).map_err(Diagnostic::from)?;
        }
        let mut model = AnalysisModel { shift: pass.shift.clone(), ..given.clone() };
        close_cuts(&mut model, &case.preload);
        for bolt in &model.preload {
            let claimed = of_cut(&case.preload, bolt);
            if bounded && claimed.is_none_or(|t| t.force != bolt.force) {
                refuted.push(format!(
                    "{}: the preload of `{}` is not that of the model",
                    case.name, bolt.body
                ));
            }
        }
        let model = &model;
        if let Some(claimed) = self.claim(case.lower, "static").filter(|_| statics) {
            let stress = read_stress(model, &self.field("static")?).map_err(Diagnostic::from)?;
            let mut random = sample(model, None, Some(&stress), POINTS);
            let certificate = match yields {
                true => {
                    let inside = sample_lower(model, &stress, 1.0, POINTS);
                    random.traction_jump = random.traction_jump.max(inside.utilisation - 1.0);
                    certify_yielding_stress(model, &stress)
                }
                false => certify_stress(model, &stress, Loads::ALL),
            };
            let bound = LowerBound::new(certificate, model.symmetry);
            let c = bound.certificate();
            let over = c.weld.map_or(0.0, |used| used - 1.0).max(c.yields.unwrap_or(0.0));
            let worst = c.equilibrium.max(c.traction_jump).max(c.contact.unwrap_or(0.0)).max(over);
            let random = random.traction_jump.max(random.traction_cone).max(random.weld - 1.0);
            let numbers = Numbers {
                claimed,
                recomputed: bound.value(),
                residual: worst,
                at_random_points: random,
            };
            findings.push(Finding::new(case, "lower", numbers, bound.is_strict(), claims_strict));
            pass.lower = Some(bound);
            pass.stress = Some(stress);
        }
        let upper = self.claim(case.upper.and_then(|u| u.finite()), "kinematic");
        let mut displacement = None;
        if let Some(claimed) = upper.filter(|_| kinematic) {
            let bytes = self.field("kinematic")?;
            let (nodes, certificate) = if yields {
                let field = read_plastic(model, &bytes).map_err(Diagnostic::from)?;
                let certificate = certify_plastic_motion(model, &field);
                let nodes = field.nodes.clone();
                pass.plastic = Some(field);
                (nodes, certificate)
            } else {
                let u = read_displacement(model, &bytes).map_err(Diagnostic::from)?;
                let certificate = certify_displacement(model, &u);
                (u, certificate)
            };
            let off = distance_from_coulomb(model, &pass.shift, &nodes);
            if off > FAR_FROM_COULOMB {
                refuted.push(format!(
                    "{}: the shift of the contact cones is off the slips of Coulomb's law by \
                     {off:.1e} of the largest",
                    case.name
                ));
            }
            let random = sample(model, Some(&nodes), None, POINTS).gap_cone;
            let bound = UpperBound::new(certificate, model.symmetry);
            let c = bound.certificate();
            let worst = c.compatibility.max(c.contact.unwrap_or(0.0));
            let numbers = Numbers {
                claimed,
                recomputed: bound.value(),
                residual: worst,
                at_random_points: random,
            };
            findings.push(Finding::new(case, "upper", numbers, bound.is_strict(), claims_strict));
            pass.upper = Some(bound);
            displacement = Some(nodes);
        }
        self.compare_fields(model, &pass, displacement.as_ref(), refuted)?;
        pass.preload =
            preloaded_bolts(model, pass.lower.as_ref().map(|l| &l.certificate().tensions[..]));
        if let (Some(l), Some(u)) = (&pass.lower, &pass.upper) {
            match Bracket::new(l.clone(), u.clone()) {
                Ok(b) => pass.bracket = Some(b),
                Err(e) => refuted.push(format!("{}: {e}", case.name)),
            }
        }
        let entry = case_result(&case.name, given, &pass, None);
        Ok((findings, entry, pass))
    }

    /// Compares what the field files contain beside their fields.
    fn compare_fields(
        &self,
        model: &AnalysisModel,
        pass: &EnergyPass,
        displacement: Option<&DisplacementField>,
        refuted: &mut Vec<String>,
    ) -> Result<(), Diagnostics> {
        if !pass.shift.faces.is_empty() {
            self.compare_grid("shift", &shift_grid(model, &pass.shift), refuted)?;
        }
        if let Some(stress) = &pass.stress {
            let yields = model.analysis == AnalysisKind::Elastoplastic;
            let of_field = if yields { yielding_stress_grid } else { stress_grid };
            self.compare_grid("static", &of_field(model, stress), refuted)?;
        }
        let Some(u) = displacement else { return Ok(()) };
        let shares = pass.stress.as_ref().map(|stress| match &pass.plastic {
            Some(plastic) => plastic_contributions(model, plastic, stress).elements,
            None => contributions(model, u, stress).elements,
        });
        let grid = match &pass.plastic {
            Some(plastic) => plastic_grid(model, plastic, shares.as_deref()),
            None => displacement_grid(model, u, shares.as_deref()),
        };
        self.compare_grid("kinematic", &grid, refuted)
    }
}
