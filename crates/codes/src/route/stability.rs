//! Stability of the plates by reduced stress.

use super::evidence::CriticalFactors;
use super::facts::RouteFacts;
use super::step::{RouteStep, RouteUse, StepId, StepState};
use crate::eurocode::plate_buckling::reduction;
use crate::unit::Unit;
use bracket_base::say;
use bracket_base::words::Text;
use bracket_engine::estimate::buckling::conservative;

const SOURCE: &str = "EN 1993-1-5:2006 10, EN 1993-1-1:2005 6.3.1.2 (curve c)";
const SUPPLY: &str =
    "more time (`time_limit`) or memory, or a coarser mesh (a larger `--size-factor`)";
/// Critical factors above this are not computed: where α_ult,k is 4 or less, they reduce nothing.
pub const LARGEST_CRITICAL: f64 = 100.0;
/// Ratio of the element sizes of the two meshes.
const REFINED: f64 = 2.0;
/// Largest ratio of the factors of the two meshes from which a value follows that may refuse:
/// the ratio is 1.4 to 1.6 on first meshes of joints.
const LARGEST_RATIO: f64 = 2.0;

impl CriticalFactors {
    /// The critical factor that counts: 0.95 of what follows from the lowest one of either mesh.
    pub fn counted(&self) -> f64 {
        let [coarse, fine] = self.least();
        conservative(coarse, fine, REFINED)
    }

    /// The lowest factor of either mesh.
    fn least(&self) -> [f64; 2] {
        [&self.coarse, &self.fine].map(|m| m.first().map_or(LARGEST_CRITICAL, |m| m.factor))
    }
}

/// The step: `ρ α_ult,k/γ_M1 ≥ 1` with `α_ult,k = γ_M0 λ_low` and the curve that errs to the safe
/// side.
pub(super) fn stability(
    facts: &RouteFacts,
    critical: Option<&CriticalFactors>,
    unknown: Option<&Text>,
    lower: Option<f64>,
) -> RouteStep {
    let (Some(factors), Some(lower)) = (critical, lower) else {
        let finding = match unknown {
            Some(why) => say!("the critical factor is not known: {}", why),
            None => "the critical factor is not known".into(),
        };
        return RouteStep::open(StepId::Stability, finding, SOURCE, SUPPLY);
    };
    let critical = factors.counted();
    let first = factors.fine.first().or(factors.coarse.first());
    let stable = || say!("nothing buckles up to {}", crate::unit::number(LARGEST_CRITICAL));
    let part = first.map_or_else(stable, |m| Text::given(&m.part));
    let ultimate = facts.factors.gamma_m0 * lower;
    let rho = reduction(ultimate, critical);
    let numbers = [ultimate, critical, rho].map(crate::unit::number);
    let [ultimate_words, critical_words, rho_words] = numbers;
    let what = say!(
        "γ_M1/(ρ α_ult,k) with α_ult,k = {}, α_cr = {} ({}), ρ = {}",
        ultimate_words,
        critical_words,
        part,
        rho_words
    );
    let row = RouteUse {
        what,
        value: facts.factors.gamma_m1 / (rho * ultimate),
        spread: None,
        limit: 1.0,
        unit: Unit::Number,
        source: SOURCE.into(),
    };
    let next = "a thicker plate, a stiffener, or less load";
    let step = RouteStep::of_uses(StepId::Stability, StepState::Estimated, vec![row], SOURCE, next);
    let [coarse, fine] = factors.least();
    if !step.holds() && coarse > LARGEST_RATIO * fine {
        let [coarse, fine] = [coarse, fine].map(crate::unit::number);
        let finding =
            say!("the critical factor is {} on the mesh, {} on one twice as fine", coarse, fine);
        return step.left_open(finding, "a finer mesh (a smaller `--size-factor`)");
    }
    step
}
