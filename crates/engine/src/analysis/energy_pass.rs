//! The pass of an elastic or elastic, perfectly plastic analysis: bounds of the potential energy.

use crate::analysis::cone_shift::FixedPointRun;
use crate::analysis::engine::Finished;
use crate::analysis::pass::{PassError, check_identity};
use crate::analysis::preloaded_bolt::{PreloadedBolt, preloaded_bolts};
use crate::analysis::program::Program;
use crate::analysis::program_outcome::{ProgramOutcome, outcomes};
use crate::certify::PlasticField;
use crate::certify::bracket::{Bracket, LowerBound, UpperBound};
use crate::certify::contributions::{Contributions, contributions, plastic_contributions};
use crate::certify::fields::{DisplacementField, StressField};
use crate::model::AnalysisModel;
use crate::model::opening::ConeShift;

/// Fields and bounds of the potential energy on one mesh.
#[derive(Clone, Debug, Default)]
pub struct EnergyPass {
    /// Outcome of the kinematic program.
    pub kinematic: Option<ProgramOutcome>,
    /// Outcome of the static program.
    pub statics: Option<ProgramOutcome>,
    /// Displacements of an optimal kinematic program.
    pub displacement: Option<DisplacementField>,
    /// The same with plastic strain, in an elastic, perfectly plastic analysis.
    pub plastic: Option<PlasticField>,
    /// Stresses of an optimal static program.
    pub stress: Option<StressField>,
    /// The upper bound.
    pub upper: Option<UpperBound>,
    /// The lower bound.
    pub lower: Option<LowerBound>,
    /// Both bounds.
    pub bracket: Option<Bracket>,
    /// Contributions to the gap of the meshed part, when both fields exist.
    pub contributions: Option<Contributions>,
    /// The preloaded bolts, their cuts frozen.
    pub preload: Vec<PreloadedBolt>,
    /// Coulomb friction: convergence of the fixed point.
    pub fixed_point: Option<FixedPointRun>,
    /// Coulomb friction: shift of the contact cones in the problem that the bounds belong to.
    pub shift: ConeShift,
}

impl EnergyPass {
    /// Adds outcome, field and bound of the kinematic program.
    pub(crate) fn add_kinematic(
        &mut self,
        kinematic: Option<Finished<(DisplacementField, UpperBound)>>,
    ) {
        let Some(k) = kinematic else { return };
        self.kinematic = Some(k.outcome);
        if let Some((field, bound)) = k.answer {
            self.displacement = Some(field);
            self.upper = Some(bound);
        }
    }

    /// Adds outcome, field and bound of the static program.
    pub(crate) fn add_static(&mut self, statics: Option<Finished<(StressField, LowerBound)>>) {
        let Some(s) = statics else { return };
        self.statics = Some(s.outcome);
        if let Some((field, bound)) = s.answer {
            self.stress = Some(field);
            self.lower = Some(bound);
        }
    }

    /// Joins the two bounds and checks that the contributions sum to the gap.
    pub(crate) fn join(&mut self, model: &AnalysisModel) -> Result<(), PassError> {
        self.preload =
            preloaded_bolts(model, self.lower.as_ref().map(|l| &l.certificate().tensions[..]));
        if let (Some(l), Some(u)) = (&self.lower, &self.upper) {
            self.bracket = Some(Bracket::new(l.clone(), u.clone())?);
        }
        if let (Some(u), Some(s)) = (&self.displacement, &self.stress) {
            let c = match &self.plastic {
                Some(u) => plastic_contributions(model, u, s),
                None => contributions(model, u, s),
            };
            // the identity holds only where both fields are admissible
            if let Some(b) = self.bracket.as_ref().filter(|b| b.is_strict()) {
                let copies = f64::from(model.symmetry);
                // with preload both energies may vanish
                let strain = b.lower().certificate().strain_energy.unwrap_or(0.0);
                check_identity(
                    [b.lower().value() / copies, b.upper().value() / copies],
                    strain,
                    c.total(),
                )?;
            }
            self.contributions = Some(c);
        }
        Ok(())
    }

    /// The programs that ran or were to run.
    pub fn runs(&self) -> impl Iterator<Item = (Program, &ProgramOutcome)> {
        outcomes(&self.kinematic, &self.statics)
    }
}
