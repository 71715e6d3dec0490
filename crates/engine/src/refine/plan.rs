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
mod tests;
