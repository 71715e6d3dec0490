//! Which mesh comes next: the one that reaches the target in the least time, as far as limits
//! allow; or none.

use crate::refine::optimum::Curve;

/// Where adaptation ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Limits {
    /// Relative gap asked for.
    pub target_gap: f64,
    /// Meshes at most.
    pub max_passes: u32,
    /// Tets at most.
    pub max_macro_tets: usize,
}

/// What was expected of a pass.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Prediction {
    /// Tets.
    pub tets: f64,
    /// Relative gap, the imperfection of the map included.
    pub gap: f64,
    /// The same without it.
    pub ideal_gap: f64,
    /// Seconds of mesher and both programs.
    pub seconds: f64,
}

/// A pass that gave a bracket.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Step {
    /// Tets.
    pub tets: usize,
    /// Its relative gap.
    pub gap: f64,
    /// Seconds of mesher and both programs.
    pub seconds: f64,
    /// Memory of its larger program \[bytes\]; 0 where nobody can tell.
    pub bytes: u64,
    /// What was expected of it; `None` for the first.
    pub predicted: Option<Prediction>,
}

/// What is left of the machine.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Left {
    /// Wall time \[s\].
    pub seconds: f64,
    /// Memory \[bytes\]; `None`: nobody can tell.
    pub bytes: Option<u64>,
}

/// Why there is no further pass.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stop {
    /// The gap asked for is reached.
    Target,
    /// As many meshes as allowed were used.
    Passes,
    /// As many tets as allowed would not help enough.
    Tets,
    /// So would what the time left allows.
    Time,
    /// So would what the memory allows.
    Memory,
    /// No tet contributes to the gap: refinement cannot narrow it.
    Nothing,
}

/// What to do.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Next {
    /// End.
    Stop(Stop),
    /// A mesh that is expected to give this.
    Refine(Prediction),
}

/// Factor between the meshes that are considered.
const LADDER: f64 = 1.12;

/// Growth beyond which a map of the coarser mesh is not trusted, where the target is out of reach
/// anyway.
const GROWTH: f64 = 4.0;

/// A pass that is expected to leave more of the gap than this is not worth its time.
const GAIN: f64 = 0.9;

/// How much larger than ideal the gap turns out for every four-fold growth of the mesh, and for any
/// redesign at least, before any experience: the map comes from another mesh, and the mesher
/// follows it roughly.
const LOSS: f64 = 1.15;

/// Exponent of a pass's time in its number of tets, before any experience.
const TIME_EXPONENT: f64 = 1.35;

/// Exponent of its memory.
const MEMORY_EXPONENT: f64 = 1.33;

/// Part of what is left that a pass may be expected to take.
const CAUTION: f64 = 0.9;

/// What earlier passes teach about predictions.
struct Experience<'a> {
    last: &'a Step,
    /// ln of the loss for every four-fold growth.
    loss: f64,
    time_exponent: f64,
}

/// Tets to ask of the mesher for so many: what it made of earlier orders teaches what it will make
/// of this one.
pub fn order(steps: &[Step], tets: f64) -> f64 {
    let made = steps.iter().filter_map(|s| s.predicted.map(|p| s.tets as f64 / p.tets));
    // an order that was met counts as the experience before any
    let (sum, count) = made.fold((0.0, 1.0), |(sum, count), ratio| (sum + ratio.ln(), count + 1.0));
    tets / f64::exp(sum / count).clamp(0.5, 2.0)
}

fn growth(from: f64, to: f64) -> f64 {
    (to / from).ln().max(0.0) / 4f64.ln()
}

impl<'a> Experience<'a> {
    fn of(steps: &'a [Step]) -> Option<Self> {
        let last = steps.last()?;
        let mut loss = (LOSS.ln(), 1.0);
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
            .clamp(1.0, 2.0),
            _ => TIME_EXPONENT,
        };
        Some(Self { last, loss: (loss.0 / loss.1).clamp(0.8f64.ln(), 2f64.ln()), time_exponent })
    }

    fn seconds(&self, tets: f64) -> f64 {
        self.last.seconds * (tets / self.last.tets as f64).powf(self.time_exponent)
    }

    /// Tets of a pass of so many seconds.
    fn tets_in(&self, seconds: f64) -> f64 {
        self.last.tets as f64
            * (seconds / self.last.seconds.max(1e-3)).max(0.0).powf(1.0 / self.time_exponent)
    }

    fn prediction(&self, curve: &Curve, tets: f64, from: f64) -> Prediction {
        let ideal_gap = self.last.gap * curve.gap_at(tets);
        let gap = ideal_gap * (self.loss * growth(from, tets).max(1.0)).exp();
        Prediction { tets, gap, ideal_gap, seconds: self.seconds(tets) }
    }
}

/// Decides after some passes; `best_gap`: of the best bracket so far; `curve`: what the next mesh
/// could give, asked for only where it is needed, with the largest number of tets of interest.
pub fn next(
    steps: &[Step],
    best_gap: f64,
    limits: &Limits,
    left: &Left,
    curve: &mut dyn FnMut(f64) -> Curve,
) -> (Next, Option<Curve>) {
    if best_gap <= limits.target_gap {
        return (Next::Stop(Stop::Target), None);
    }
    let passes_left = (limits.max_passes as usize).saturating_sub(steps.len());
    let experience = match Experience::of(steps) {
        Some(e) if passes_left > 0 => e,
        _ => return (Next::Stop(Stop::Passes), None),
    };
    let last = experience.last;
    // the tightest of the limits, and which it is
    let mut cap = (limits.max_macro_tets as f64, Stop::Tets);
    let by_time = experience.tets_in(CAUTION * left.seconds);
    if by_time < cap.0 {
        cap = (by_time, Stop::Time);
    }
    if let (Some(bytes), true) = (left.bytes, last.bytes > 0) {
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
    // the coarsest mesh that reaches the target, its map coming from a mesh of `from` tets
    let reaches = |from: f64| {
        let hit = |n: &&f64| experience.prediction(&curve, **n, from).gap <= limits.target_gap;
        ladder.iter().filter(|n| **n >= from || from == present).find(hit).copied()
    };
    let mut best: Option<(f64, f64)> = reaches(present).map(|n| (experience.seconds(n), n));
    if passes_left > 1 {
        for &middle in ladder.iter().filter(|n| **n > present) {
            let Some(end) = reaches(middle).filter(|end| *end > middle) else { continue };
            let seconds = experience.seconds(middle) + experience.seconds(end);
            if best.is_none_or(|b| seconds < b.0) && seconds <= left.seconds {
                best = Some((seconds, middle));
            }
        }
    }
    let tets = match best {
        Some((_, tets)) => tets,
        // out of reach: as far as limits and trust allow
        None if passes_left == 1 => most,
        None => most.min(GROWTH * present),
    };
    let prediction = experience.prediction(&curve, tets, present);
    if best.is_none() && prediction.gap > GAIN * best_gap {
        return (Next::Stop(cap.1), None);
    }
    (Next::Refine(prediction), Some(curve))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::refine::optimum::Estimate;

    const LIMITS: Limits = Limits { target_gap: 0.02, max_passes: 6, max_macro_tets: 200_000 };
    const ENDLESS: Left = Left { seconds: f64::INFINITY, bytes: None };

    fn step(tets: usize, gap: f64) -> Step {
        Step {
            tets,
            gap,
            seconds: 1e-3 * (tets as f64).powf(1.3),
            bytes: 100_000 * tets as u64,
            predicted: None,
        }
    }

    /// A smooth problem on so many tets: the gap goes with N^(−4/3).
    fn smooth(tets: usize) -> impl FnMut(f64) -> Curve {
        move |most| {
            let estimate = Estimate { contributions: vec![1.0; tets], rates: vec![2.0; tets] };
            estimate.curve(most, &|wanted| wanted.to_vec())
        }
    }

    fn decide(steps: &[Step], limits: &Limits, left: &Left) -> Next {
        let last = steps[steps.len() - 1];
        next(steps, last.gap, limits, left, &mut smooth(last.tets)).0
    }

    #[test]
    fn the_target_is_reached_by_the_coarsest_mesh_that_can() {
        // twice the gap: 2^(3/4) times the tets and a bit for what the map misses
        let Next::Refine(p) = decide(&[step(1000, 0.04)], &LIMITS, &ENDLESS) else {
            panic!("a pass")
        };
        assert!(p.gap <= 0.02 && p.tets > 1681.0 && p.tets < 2100.0, "{p:?}");
        assert!((p.seconds / (1.0e-3 * p.tets.powf(1.3)) - 1.0).abs() < 0.1, "{p:?}");
        assert_eq!(decide(&[step(1000, 0.019)], &LIMITS, &ENDLESS), Next::Stop(Stop::Target));
    }

    /// A long way is gone in two passes: the first is cheap and its map better.
    #[test]
    fn a_long_way_is_gone_in_steps() {
        let limits = Limits { target_gap: 1e-3, ..LIMITS };
        let Next::Refine(p) = decide(&[step(1000, 0.04)], &limits, &ENDLESS) else {
            panic!("a pass")
        };
        assert!(p.gap > limits.target_gap && p.tets > 1500.0 && p.tets < 40_000.0, "{p:?}");
        // with one pass left it is gone at once
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
        let time = Left { seconds: first.seconds, bytes: None };
        assert_eq!(decide(&[first], &far, &time), Next::Stop(Stop::Time));
        let memory = Left { seconds: f64::INFINITY, bytes: Some(first.bytes) };
        assert_eq!(decide(&[first], &far, &memory), Next::Stop(Stop::Memory));
        // what is left is used: no prediction goes beyond it
        for (limits, left) in [
            (Limits { max_macro_tets: 3000, ..far }, ENDLESS),
            (far, Left { seconds: 4.0 * first.seconds, bytes: None }),
            (far, Left { seconds: f64::INFINITY, bytes: Some(4 * first.bytes) }),
        ] {
            let Next::Refine(p) = decide(&[first], &limits, &left) else { panic!("a pass") };
            assert!(p.tets <= 3000.0 * (1.0 + 1e-9) && p.seconds <= left.seconds, "{p:?}");
        }
        let none = |_| {
            Estimate { contributions: vec![0.0; 8], rates: vec![2.0; 8] }
                .curve(1e5, &|w| w.to_vec())
        };
        let mut none = none;
        assert_eq!(next(&[first], 0.04, &far, &ENDLESS, &mut none).0, Next::Stop(Stop::Nothing));
    }

    /// A mesher that makes more than it is asked for is asked for less.
    #[test]
    fn orders_learn_from_what_was_made() {
        let predicted = Prediction { tets: 2000.0, gap: 0.02, ideal_gap: 0.018, seconds: 1.0 };
        let second = Step { predicted: Some(predicted), ..step(2400, 0.02) };
        assert_eq!(order(&[step(1000, 0.04)], 3000.0), 3000.0);
        assert!((order(&[step(1000, 0.04), second], 3000.0) - 3000.0 / 1.2f64.sqrt()).abs() < 1e-9);
    }

    /// A pass that fell short of its prediction makes the next prediction humbler, also where the
    /// mesh does not grow.
    #[test]
    fn experience_teaches() {
        let predicted = Prediction { tets: 2000.0, gap: 0.02, ideal_gap: 0.018, seconds: 1.0 };
        let of = |gap| {
            let second = Step { predicted: Some(predicted), ..step(2000, gap) };
            Experience::of(&[step(1000, 0.04), second]).map(|e| e.loss).unwrap_or_default()
        };
        assert!(of(0.03) > of(0.018) && of(0.03) > LOSS.ln());
        let second = Step { predicted: Some(predicted), ..step(2000, 0.03) };
        let steps = [step(1000, 0.04), second];
        let Next::Refine(p) = decide(&steps, &LIMITS, &ENDLESS) else { panic!("a pass") };
        assert!(p.gap > 1.2 * p.ideal_gap, "{p:?}");
    }
}
