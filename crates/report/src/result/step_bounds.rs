//! Load steps from the entries of their analyses, with bounds of the displacement of the load.
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

use crate::result::case_result::CaseResult;
use crate::result::energy_case::only_load;
use crate::result::load_step::LoadStep;
use crate::result::quantity::{FrictionModel, Upper};
use bracket_codes::route::BoltSections;
use bracket_engine::model::AnalysisModel;

/// The step at load factor 1: the case itself.
pub fn step_of_case(case: &CaseResult) -> LoadStep {
    step_of(1.0, case, case.evidence.as_ref().map_or(Vec::new(), |e| e.bolts.clone()))
}

/// The step of an entry at this load factor, with the forces of its bolts.
pub fn step_of(factor: f64, entry: &CaseResult, bolts: Vec<BoltSections>) -> LoadStep {
    LoadStep {
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
