//! Decides after each pass whether a further mesh is made, and with how many tets: the mesh that
//! reaches the target in the least time within the limits.

use crate::refine::optimum::Curve;

/// Limits at which adaptation ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Limits {
    /// Target of the relative gap.
    pub target_gap: f64,
    /// Largest number of meshes.
    pub max_passes: u32,
    /// Largest number of tets.
    pub max_macro_tets: usize,
}

/// Expected size, gap and time of a pass.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Prediction {
    /// Tets.
    pub tets: f64,
    /// Relative gap, with the loss from imperfect maps of the contributions.
    pub gap: f64,
    /// Relative gap without that loss.
    pub ideal_gap: f64,
    /// Time of mesher and both programs \[s\].
    pub seconds: f64,
    /// A larger mesh is to follow within the limits.
    pub first_of_two: bool,
}

/// A pass that gave a bracket.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Step {
    /// Tets.
    pub tets: usize,
    /// Relative gap.
    pub gap: f64,
    /// Time of mesher and both programs \[s\].
    pub seconds: f64,
    /// Memory of its larger program \[bytes\]; 0 where there is no forecast.
    pub bytes: u64,
    /// Its prediction; `None` for the first pass.
    pub predicted: Option<Prediction>,
}

/// Time and memory left for further passes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Budget {
    /// Wall time \[s\].
    pub seconds: f64,
    /// Memory \[bytes\]; `None`: unknown.
    pub bytes: Option<u64>,
}

/// Why there is no further pass.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stop {
    /// The target gap is reached.
    Target,
    /// The largest number of meshes is used up.
    Passes,
    /// The largest number of tets allows no mesh that is much better.
    Tets,
    /// The remaining time allows no mesh that is much better.
    Time,
    /// The memory allows no mesh that is much better.
    Memory,
    /// No tet contributes to the gap: refinement cannot narrow it.
    Nothing,
    /// The remesher made the same mesh again.
    SameMesh,
    /// What was asked for is decided already.
    Decided,
}

/// The decision.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Next {
    /// No further mesh.
    Stop(Stop),
    /// A further mesh with this prediction.
    Refine(Prediction),
}

/// Ratio of the numbers of tets of successive candidate meshes.
const LADDER: f64 = 1.12;

/// Largest growth of the number of tets in one pass where the target is out of reach: beyond it the
/// contributions of the coarser mesh are no reliable guide.
const GROWTH: f64 = 4.0;

/// Growth from the first to the second of two meshes, where the limits allow one that a single step
/// of [`GROWTH`] does not reach. The first is the smaller, the more the last one may be: a joint
/// that takes ten minutes spent a third of them on a mesh that the last one exceeded by a third.
const SECOND_GROWTH: f64 = 3.0;

/// A pass is not worth its time where its expected gap exceeds this fraction of the best gap.
const GAIN: f64 = 0.9;

/// Where the target is out of reach, a mesh must have this many times the tets of the largest mesh
/// before: a redesign of about the same size moved no bound of real joints by more than 0.1 %, and
/// took the time of a larger mesh for the other bound.
const LARGER: f64 = 1.15;

/// Initial estimate of the ratio of real to ideal gap for a four-fold growth of the mesh, and at
/// least for any redesign. The contributions come from another mesh, and the mesher follows the
/// wanted sizes only roughly.
pub const LOSS: f64 = 1.15;

/// Range of that ratio. Elements that follow the directions of a field gain more than the ideal gap
/// of their sizes promises.
const LOSSES: [f64; 2] = [0.65, 2.0];

/// Initial estimate of the exponent of the time of a pass in its number of tets.
const TIME_EXPONENT: f64 = 1.5;

/// Range of that exponent as learned from two passes. Small meshes suggest less than large ones
/// take: from 27 to 38 thousand tets to 80 to 108 thousand the time of an iteration grew with
/// exponents of 1.4 to 1.9, and a mesh that does not end in time costs minutes for nothing.
const TIME_EXPONENTS: [f64; 2] = [1.55, 2.0];

/// Exponent of the memory of a pass in its number of tets.
const MEMORY_EXPONENT: f64 = 1.33;

/// Fraction of the remaining time and memory that a pass may be expected to take.
const CAUTION: f64 = 0.9;

/// Corrections of predictions learned from earlier passes.
struct Experience<'a> {
    last: &'a Step,
    /// ln of the ratio of real to ideal gap for a four-fold growth.
    loss: f64,
    time_exponent: f64,
}

/// Number of tets to request from the mesher so that it makes `tets`: corrected by the ratios of
/// made to requested tets of earlier passes.
pub fn order(steps: &[Step], tets: f64) -> f64 {
    let made = steps.iter().filter_map(|s| s.predicted.map(|p| s.tets as f64 / p.tets));
    // starts from one pass with the ratio 1
    let (sum, count) = made.fold((0.0, 1.0), |(sum, count), ratio| (sum + ratio.ln(), count + 1.0));
    tets / f64::exp(sum / count).clamp(0.5, 2.0)
}

fn growth(from: f64, to: f64) -> f64 {
    (to / from).ln().max(0.0) / 4f64.ln()
}

impl<'a> Experience<'a> {
    /// `loss`: the ratio before any pass shows it.
    fn of(steps: &'a [Step], loss: f64) -> Option<Self> {
        let last = steps.last()?;
        let mut loss = (loss.ln(), 1.0);
        for pair in steps.windows(2) {
            let Some(p) = pair[1].predicted else { continue };
            let found = (pair[1].gap / p.ideal_gap).ln()
                / growth(pair[0].tets as f64, pair[1].tets as f64).max(1.0);
            if found.is_finite() {
                loss = (loss.0 + found, loss.1 + 1.0);
            }
        }
        let time_exponent = match steps {
            [.., a, b] if b.tets as f64 > 1.2 * a.tets as f64 => ((b.seconds / a.seconds).ln()
                / (b.tets as f64 / a.tets as f64).ln())
            .clamp(TIME_EXPONENTS[0], TIME_EXPONENTS[1]),
            _ => TIME_EXPONENT,
        };
        Some(Self {
            last,
            loss: (loss.0 / loss.1).clamp(LOSSES[0].ln(), LOSSES[1].ln()),
            time_exponent,
        })
    }

    fn seconds(&self, tets: f64) -> f64 {
        self.last.seconds * (tets / self.last.tets as f64).powf(self.time_exponent)
    }

    /// Number of tets of a pass that takes the given time \[s\].
    fn tets_in(&self, seconds: f64) -> f64 {
        self.last.tets as f64
            * (seconds / self.last.seconds.max(1e-3)).max(0.0).powf(1.0 / self.time_exponent)
    }

    fn prediction(&self, curve: &Curve, tets: f64, from: f64) -> Prediction {
        let ideal_gap = self.last.gap * curve.gap_at(tets);
        let gap = ideal_gap * (self.loss * growth(from, tets).max(1.0)).exp();
        Prediction { tets, gap, ideal_gap, seconds: self.seconds(tets), first_of_two: false }
    }

    /// Tets of the second mesh where the target is out of reach, and whether a larger one is to
    /// follow. `most`: tets of the largest mesh within the limits; `seconds`: time for both.
    fn first_step(&self, most: f64, seconds: f64) -> (f64, bool) {
        let present = self.last.tets as f64;
        let both = 1.0 + SECOND_GROWTH.powf(-self.time_exponent);
        let end = most.min(self.tets_in(seconds / both));
        if end > GROWTH * present {
            (GROWTH.min(end / (SECOND_GROWTH * present)) * present, true)
        } else {
            (most.min(GROWTH * present), false)
        }
    }
}

/// Decides after the passes `steps`. `best_gap`: relative gap of the best bracket so far; `loss`:
/// ratio of real to ideal gap for a four-fold growth, before any pass shows it; `curve`: computes
/// the curve of possible next meshes up to a number of tets, called only where it is needed.
/// Returns the curve with a decision to refine.
pub fn next(
    steps: &[Step],
    best_gap: f64,
    limits: &Limits,
    budget: &Budget,
    loss: f64,
    curve: &mut dyn FnMut(f64) -> Curve,
) -> (Next, Option<Curve>) {
    if best_gap <= limits.target_gap {
        return (Next::Stop(Stop::Target), None);
    }
    let passes_left = (limits.max_passes as usize).saturating_sub(steps.len());
    let experience = match Experience::of(steps, loss) {
        Some(e) if passes_left > 0 => e,
        _ => return (Next::Stop(Stop::Passes), None),
    };
    let last = experience.last;
    // the tightest limit of the number of tets
    let mut cap = (limits.max_macro_tets as f64, Stop::Tets);
    let by_time = experience.tets_in(CAUTION * budget.seconds);
    if by_time < cap.0 {
        cap = (by_time, Stop::Time);
    }
    if let (Some(bytes), true) = (budget.bytes, last.bytes > 0) {
        let by_memory = last.tets as f64
            * (CAUTION * bytes as f64 / last.bytes as f64).powf(1.0 / MEMORY_EXPONENT);
        if by_memory < cap.0 {
            cap = (by_memory, Stop::Memory);
        }
    }
    let curve = curve(cap.0);
    let Some([few, many]) = curve.range() else { return (Next::Stop(Stop::Nothing), None) };
    let most = many.min(cap.0);
    if most < few {
        return (Next::Stop(cap.1), None);
    }
    let present = last.tets as f64;
    let rungs = ((most / few).ln() / LADDER.ln()).ceil().max(1.0) as usize;
    let ladder: Vec<f64> =
        (0..=rungs).map(|i| few * (most / few).powf(i as f64 / rungs as f64)).collect();
    // the coarsest mesh that reaches the target, designed from contributions on `from` tets
    let reaches = |from: f64| {
        let hit = |n: &&f64| experience.prediction(&curve, **n, from).gap <= limits.target_gap;
        ladder.iter().filter(|n| **n >= from || from == present).find(hit).copied()
    };
    let mut best: Option<(f64, f64)> = reaches(present).map(|n| (experience.seconds(n), n));
    if passes_left > 1 {
        for &middle in ladder.iter().filter(|n| **n > present) {
            let Some(end) = reaches(middle).filter(|end| *end > middle) else { continue };
            let seconds = experience.seconds(middle) + experience.seconds(end);
            if best.is_none_or(|b| seconds < b.0) && seconds <= budget.seconds {
                best = Some((seconds, middle));
            }
        }
    }
    let (tets, first_of_two) = match best {
        Some((_, tets)) => (tets, reaches(present) != Some(tets)),
        // target out of reach: as far as the limits and a reliable design allow
        None if passes_left == 1 => (most, false),
        None if steps.len() == 1 => experience.first_step(most, CAUTION * budget.seconds),
        None => (most.min(GROWTH * present), false),
    };
    let prediction = Prediction { first_of_two, ..experience.prediction(&curve, tets, present) };
    let largest = steps.iter().map(|s| s.tets).max().unwrap_or(0) as f64;
    let small = tets < LARGER * largest || prediction.gap > GAIN * best_gap;
    if best.is_none() && !first_of_two && small {
        return (Next::Stop(cap.1), None);
    }
    (Next::Refine(prediction), Some(curve))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::refine::optimum::{Estimate, PARTS};

    const LIMITS: Limits = Limits { target_gap: 0.02, max_passes: 6, max_macro_tets: 200_000 };
    const ENDLESS: Budget = Budget { seconds: f64::INFINITY, bytes: None };

    fn step(tets: usize, gap: f64) -> Step {
        Step {
            tets,
            gap,
            seconds: 1e-3 * (tets as f64).powf(TIME_EXPONENT),
            bytes: 100_000 * tets as u64,
            predicted: None,
        }
    }

    /// A smooth problem on N tets: the gap goes with N^(−4/3).
    fn smooth(tets: usize) -> impl FnMut(f64) -> Curve {
        move |most| {
            let estimate = Estimate {
                contributions: vec![1.0; tets],
                rates: vec![2.0; tets],
                directions: Vec::new(),
                least_parts: PARTS[0],
            };
            estimate.curve(most, &|wanted| wanted.to_vec())
        }
    }

    fn decide(steps: &[Step], limits: &Limits, budget: &Budget) -> Next {
        let last = steps[steps.len() - 1];
        next(steps, last.gap, limits, budget, LOSS, &mut smooth(last.tets)).0
    }

    #[test]
    fn the_target_is_reached_by_the_coarsest_mesh_that_can() {
        // half the gap: 2^(3/4) times the tets, and some more for the loss of the design
        let Next::Refine(p) = decide(&[step(1000, 0.04)], &LIMITS, &ENDLESS) else {
            panic!("a pass")
        };
        assert!(p.gap <= 0.02 && p.tets > 1681.0 && p.tets < 2100.0, "{p:?}");
        assert!((p.seconds / (1.0e-3 * p.tets.powf(TIME_EXPONENT)) - 1.0).abs() < 0.1, "{p:?}");
        assert_eq!(decide(&[step(1000, 0.019)], &LIMITS, &ENDLESS), Next::Stop(Stop::Target));
    }

    /// A distant target is reached in two passes: the first is cheap and gives better
    /// contributions.
    #[test]
    fn a_distant_target_is_reached_in_steps() {
        let limits = Limits { target_gap: 1e-3, ..LIMITS };
        let Next::Refine(p) = decide(&[step(1000, 0.04)], &limits, &ENDLESS) else {
            panic!("a pass")
        };
        assert!(p.gap > limits.target_gap && p.tets > 1500.0 && p.tets < 40_000.0, "{p:?}");
        // with one pass left it is reached in one
        let once = Limits { max_passes: 2, ..limits };
        let Next::Refine(p) = decide(&[step(1000, 0.04)], &once, &ENDLESS) else {
            panic!("a pass")
        };
        assert!(p.gap <= limits.target_gap, "{p:?}");
    }

    #[test]
    fn every_limit_ends_it() {
        let first = step(1000, 0.04);
        let far = Limits { target_gap: 1e-5, ..LIMITS };
        assert_eq!(
            decide(&[first], &Limits { max_passes: 1, ..far }, &ENDLESS),
            Next::Stop(Stop::Passes)
        );
        assert_eq!(
            decide(&[first], &Limits { max_macro_tets: 1050, ..far }, &ENDLESS),
            Next::Stop(Stop::Tets)
        );
        let time = Budget { seconds: first.seconds, bytes: None };
        assert_eq!(decide(&[first], &far, &time), Next::Stop(Stop::Time));
        let memory = Budget { seconds: f64::INFINITY, bytes: Some(first.bytes) };
        assert_eq!(decide(&[first], &far, &memory), Next::Stop(Stop::Memory));
        // a pass uses the budget without exceeding it
        for (limits, left) in [
            (Limits { max_macro_tets: 3000, ..far }, ENDLESS),
            (far, Budget { seconds: 4.0 * first.seconds, bytes: None }),
            (far, Budget { seconds: f64::INFINITY, bytes: Some(4 * first.bytes) }),
        ] {
            let Next::Refine(p) = decide(&[first], &limits, &left) else { panic!("a pass") };
            assert!(p.tets <= 3000.0 * (1.0 + 1e-9) && p.seconds <= left.seconds, "{p:?}");
        }
        let none = |_| {
            Estimate {
                contributions: vec![0.0; 8],
                rates: vec![2.0; 8],
                directions: Vec::new(),
                least_parts: PARTS[0],
            }
            .curve(1e5, &|w| w.to_vec())
        };
        let mut none = none;
        assert_eq!(
            next(&[first], 0.04, &far, &ENDLESS, LOSS, &mut none).0,
            Next::Stop(Stop::Nothing)
        );
    }

    /// Where the time allows one mesh that is more than four times as large, a small mesh comes
    /// first and the large one after it, not a mesh of four times the size.
    #[test]
    fn a_small_mesh_comes_before_the_last() {
        let far = Limits { target_gap: 1e-5, ..LIMITS };
        let with = |steps: &[Step], times: f64| {
            let budget = Budget { seconds: times * steps[0].seconds, bytes: None };
            let Next::Refine(p) = decide(steps, &far, &budget) else { panic!("a pass") };
            p
        };
        let first = step(1000, 0.2);
        let direct = with(&[first], 6.0);
        assert!(!direct.first_of_two && direct.tets > 3000.0, "{direct:?}");
        let small = with(&[first], 12.0);
        assert!(small.first_of_two && small.tets < 2000.0, "{small:?}");
        let second = Step { predicted: Some(small), ..step(small.tets as usize, 0.16) };
        let left = 12.0 - small.seconds / first.seconds;
        let last = with(&[first, second], left);
        assert!(!last.first_of_two && last.tets > 4.0 * 1000.0, "{last:?}");
        assert!(last.seconds <= left * first.seconds, "{last:?}");
        // without end of time, the largest reliable step
        let Next::Refine(far) = decide(&[first], &far, &ENDLESS) else { panic!("a pass") };
        assert!(far.first_of_two && far.tets == GROWTH * 1000.0, "{far:?}");
    }

    /// Where the target is out of reach, a design of the same size is not worth its time, however
    /// much better it promises to be.
    #[test]
    fn a_mesh_for_a_distant_target_grows() {
        let far = Limits { target_gap: 1e-5, ..LIMITS };
        let steps = [step(1000, 0.2), step(4000, 0.1)];
        let mut uneven = |most: f64| {
            let few = |i: usize| if i < 400 { 1.0 } else { 1e-3 };
            let estimate = Estimate {
                contributions: (0..4000).map(few).collect(),
                rates: vec![2.0; 4000],
                directions: Vec::new(),
                least_parts: PARTS[0],
            };
            estimate.curve(most, &|wanted| wanted.to_vec())
        };
        let mut with = |times: f64| {
            let budget = Budget { seconds: times * steps[1].seconds, bytes: None };
            next(&steps, 0.1, &far, &budget, LOSS, &mut uneven).0
        };
        assert_eq!(with(1.2), Next::Stop(Stop::Time));
        let Next::Refine(p) = with(3.0) else { panic!("a pass") };
        assert!(p.tets >= LARGER * 4000.0 && p.gap < GAIN * 0.1, "{p:?}");
    }

    /// A mesher that makes more tets than requested gets a smaller request.
    #[test]
    fn requests_learn_from_the_mesher() {
        let predicted = Prediction {
            tets: 2000.0,
            gap: 0.02,
            ideal_gap: 0.018,
            seconds: 1.0,
            first_of_two: false,
        };
        let second = Step { predicted: Some(predicted), ..step(2400, 0.02) };
        assert_eq!(order(&[step(1000, 0.04)], 3000.0), 3000.0);
        assert!((order(&[step(1000, 0.04), second], 3000.0) - 3000.0 / 1.2f64.sqrt()).abs() < 1e-9);
    }

    /// A pass that missed its prediction makes the next prediction less optimistic, also where the
    /// mesh does not grow.
    #[test]
    fn predictions_learn_from_misses() {
        let predicted = Prediction {
            tets: 2000.0,
            gap: 0.02,
            ideal_gap: 0.018,
            seconds: 1.0,
            first_of_two: false,
        };
        let of = |gap| {
            let second = Step { predicted: Some(predicted), ..step(2000, gap) };
            Experience::of(&[step(1000, 0.04), second], LOSS).map(|e| e.loss).unwrap_or_default()
        };
        assert!(of(0.03) > of(0.018) && of(0.03) > LOSS.ln());
        let second = Step { predicted: Some(predicted), ..step(2000, 0.03) };
        let steps = [step(1000, 0.04), second];
        let Next::Refine(p) = decide(&steps, &LIMITS, &ENDLESS) else { panic!("a pass") };
        assert!(p.gap > 1.2 * p.ideal_gap, "{p:?}");
    }
}
