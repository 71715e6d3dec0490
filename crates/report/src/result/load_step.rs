//! A load step of elastoplastic analysis: bounds and estimates at a part of the demand, or beyond it.
//!
//! With the load factor λ let `C(λ) = −Π*(λ)`: the largest value of `λ F·u − W(u)` over admissible
//! displacements, W the energy stored and dissipated. As a maximum of functions that are linear in
//! λ, C is convex, and its slope is the work `F·u` of the loads at load factor 1. So the slope at a
//! step is at least that of every chord to a lower step, and at most that of every chord to a
//! higher one. The bounds of Π* bound C at the ends of a chord:
//!
//! `(−upper_i + lower_j)/(λ_i − λ_j) ≤ F·u ≤ (−lower_k + upper_i)/(λ_k − λ_i)`, j < i < k.
//!
//! This holds with initial gaps, preload and dead loads too, because all steps have the same W. It
//! does not hold for shifted cones, whose shift differs from step to step.

use crate::result::case_result::{CaseResult, FaceMotion};
use crate::result::energy_case::only_load;
use crate::result::quantity::{FrictionModel, LoadSize, Upper};
use bracket_base::math::vec3;
use bracket_base::say;
use bracket_base::words::Text;
use bracket_codes::route::BoltSections;
use bracket_engine::model::AnalysisModel;
use serde::{Deserialize, Serialize};

/// Bounds and estimates at a load factor.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct LoadStep {
    /// The factor of the live loads.
    pub factor: f64,
    /// Lower bound of the potential energy \[N mm\].
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub lower: Option<f64>,
    /// Upper bound of the potential energy \[N mm\].
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub upper: Option<f64>,
    /// True if both numbers are bounds.
    pub strict: bool,
    /// The only load at this factor, of the whole structure; absent with several loads.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub load: Option<LoadSize>,
    /// Lower bound of the displacement of the only load in its own direction \[mm; rad for a
    /// moment\].
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub load_displacement_at_least: Option<f64>,
    /// Upper bound of it; none at the last step.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub load_displacement_at_most: Option<f64>,
    /// Motion of each loaded rigid face: an estimate.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub face_motions: Vec<FaceMotion>,
    /// Forces in the sections of the bolts from both fields: estimates.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub bolts: Vec<BoltSections>,
}

impl LoadStep {
    /// The step at load factor 1: the case itself.
    pub fn of_case(case: &CaseResult) -> Self {
        let bolts = case.evidence.as_ref().map_or(Vec::new(), |e| e.bolts.clone());
        Self::of(1.0, case, bolts)
    }

    /// The step of an entry at this load factor, with the forces of its bolts.
    pub fn of(factor: f64, entry: &CaseResult, bolts: Vec<BoltSections>) -> Self {
        Self {
            factor,
            lower: entry.lower,
            upper: entry.upper.and_then(Upper::finite),
            strict: entry.is_strict(),
            load: None,
            load_displacement_at_least: entry.load_displacement_at_least,
            load_displacement_at_most: None,
            face_motions: entry.face_motions.clone(),
            bolts,
        }
    }

    /// Largest displacement of a loaded face \[mm\]: an estimate.
    pub fn displacement(&self) -> Option<f64> {
        self.face_motions.iter().map(|m| vec3::norm(m.displacement)).reduce(f64::max)
    }

    /// Largest rotation of a loaded face \[rad\]: an estimate.
    pub fn turn(&self) -> Option<f64> {
        self.face_motions.iter().map(FaceMotion::turn).reduce(f64::max)
    }
}

/// Adds the only load of `model`, which is that at load factor 1, to every step, and the bounds of
/// its displacement by the energies of the other steps.
pub fn add_loads(steps: &mut [LoadStep], model: &AnalysisModel, problem: FrictionModel) {
    let Some(load) = only_load(model).filter(|load| load.value() > 0.0) else { return };
    steps.iter_mut().for_each(|step| step.load = Some(load.times(step.factor)));
    if problem != FrictionModel::ShiftedCones {
        // without dead loads and preload nothing is stored at load factor 0: gaps are open
        let from_zero = !model.has_dead_loads() && !model.has_preload();
        enclose(steps, load.value(), from_zero);
    }
}

/// The bounds by chords for a load of this size; `from_zero`: C vanishes at load factor 0.
fn enclose(steps: &mut [LoadStep], size: f64, from_zero: bool) {
    // of each strict step the load factor and the bounds of C
    let of_step = |s: &LoadStep| Some([s.factor, -s.upper?, -s.lower?]).filter(|_| s.strict);
    let mut known: Vec<[f64; 3]> = steps.iter().filter_map(of_step).collect();
    known.extend(from_zero.then_some([0.0; 3]));
    for step in steps {
        let Some([at, low, _]) = of_step(step) else { continue };
        let chord = |rise: f64, run: f64| rise / (run * size);
        let below = known.iter().filter(|k| k[0] < at).map(|k| chord(low - k[2], at - k[0]));
        let above = known.iter().filter(|k| k[0] > at).map(|k| chord(k[2] - low, k[0] - at));
        let (least, most) = (below.reduce(f64::max), above.reduce(f64::min));
        let own = step.load_displacement_at_least;
        step.load_displacement_at_least = own.into_iter().chain(least).reduce(f64::max);
        step.load_displacement_at_most = most;
    }
}

/// The warning about load steps that the run did not analyse.
pub fn without_steps(factors: &[f64]) -> Text {
    let each = factors.iter().map(|f| Text::given(bracket_base::diag::number(*f)));
    say!(
        "load steps that were not analysed, because the time ended or the bolts could not be \
         tightened: {}",
        Text::joined(", ", each)
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A spring of stiffness 2 that yields at a force of 3 beside an elastic one of stiffness 1,
    /// under 6: displacement 1 at half of the load, 3 at all of it.
    #[test]
    fn chords_enclose_the_displacement() {
        let energy = |f: f64| {
            let u = if f <= 4.5 { f / 3.0 } else { f - 3.0 };
            let yielding = if u <= 1.5 { u * u } else { 3.0 * u - 2.25 };
            0.5 * u * u + yielding - f * u
        };
        let step = |factor: f64| LoadStep {
            factor,
            lower: Some(energy(6.0 * factor) - 1e-3),
            upper: Some(energy(6.0 * factor) + 1e-3),
            strict: true,
            ..LoadStep::default()
        };
        let mut steps = [0.25, 0.5, 0.75, 1.0].map(step);
        enclose(&mut steps, 6.0, true);
        for (step, u) in steps.iter().zip([0.5, 1.0, 1.5, 3.0]) {
            let (low, high) = (step.load_displacement_at_least, step.load_displacement_at_most);
            assert!(low.is_some_and(|low| low <= u), "{step:?}");
            assert!(high.is_none_or(|high| high >= u), "{step:?}");
            assert_eq!(high.is_none(), step.factor == 1.0);
        }
    }
}
