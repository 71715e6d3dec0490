//! Plans of passes whose errors, times and memories follow known laws.

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
    let Next::Refine(p) = decide(&[step(1000, 0.04)], &LIMITS, &ENDLESS) else { panic!("a pass") };
    assert!(p.gap <= 0.02 && p.tets > 1681.0 && p.tets < 2100.0, "{p:?}");
    assert!((p.seconds / (1.0e-3 * p.tets.powf(TIME_EXPONENT)) - 1.0).abs() < 0.1, "{p:?}");
    assert_eq!(decide(&[step(1000, 0.019)], &LIMITS, &ENDLESS), Next::Stop(Stop::Target));
}

/// A distant target is reached in two passes: the first is cheap and gives better
/// contributions.
#[test]
fn a_distant_target_is_reached_in_steps() {
    let limits = Limits { target_gap: 1e-3, ..LIMITS };
    let Next::Refine(p) = decide(&[step(1000, 0.04)], &limits, &ENDLESS) else { panic!("a pass") };
    assert!(p.gap > limits.target_gap && p.tets > 1500.0 && p.tets < 40_000.0, "{p:?}");
    // with one pass left it is reached in one
    let once = Limits { max_passes: 2, ..limits };
    let Next::Refine(p) = decide(&[step(1000, 0.04)], &once, &ENDLESS) else { panic!("a pass") };
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
    assert_eq!(next(&[first], 0.04, &far, &ENDLESS, LOSS, &mut none).0, Next::Stop(Stop::Nothing));
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
    let predicted =
        Prediction { tets: 2000.0, gap: 0.02, ideal_gap: 0.018, seconds: 1.0, first_of_two: false };
    let second = Step { predicted: Some(predicted), ..step(2400, 0.02) };
    assert_eq!(order(&[step(1000, 0.04)], 3000.0), 3000.0);
    assert!((order(&[step(1000, 0.04), second], 3000.0) - 3000.0 / 1.2f64.sqrt()).abs() < 1e-9);
}

/// A pass that missed its prediction makes the next prediction less optimistic, also where the
/// mesh does not grow.
#[test]
fn predictions_learn_from_misses() {
    let predicted =
        Prediction { tets: 2000.0, gap: 0.02, ideal_gap: 0.018, seconds: 1.0, first_of_two: false };
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
