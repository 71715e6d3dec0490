//! Which actions to analyse next, so that few limit analyses bound all load cases of a group.
//!
//! The load cases around the largest component of their actions form a bundle of rays. Rays through
//! the corners of a box around the bundle contain all of it, where the bundle's own outermost cases
//! would be many. What an analysis will prove is not known before: it is estimated from the
//! mechanisms of the analyses that ran. The estimate decides only what runs, no bound.

use crate::driver::combinations::cover::Cover;
use bracket_base::math::gauge::gauge;
use bracket_engine::certify::half_space::Actions;

/// Components that vary by less than this, relative to the largest one, are noise.
const NOISE: f64 = 0.02;
/// Share of the weights for the corners of the box; the rest is for noise.
const SHARE: f64 = 0.8;
/// Components whose corners are analysed at most.
const MOST_CORNERS: usize = 2;
/// Load cases that are tried as the next one.
const TRIED: usize = 12;
/// Load cases, the worst ones, by which a choice is weighed: each takes a linear program.
const WEIGHED: usize = 300;

/// What runs next.
#[derive(Clone, Debug, PartialEq)]
pub enum Next {
    /// A load case, by its index.
    Case(usize),
    /// Actions of no load case.
    Directions(Vec<Actions>),
}

/// The next analyses, for the load cases `open`, the worst first; there is at least one. A load
/// case unless other actions are expected to decide more cases for each analysis; `cases_only`: a
/// load case in any case.
pub fn next(cover: &Cover, open: &[usize], cases_only: bool) -> Next {
    let alone = Next::Case(open[0]);
    if cover.runs.is_empty() || open.len() < 2 {
        return alone;
    }
    let forecast = Forecast::new(cover);
    let targets: Vec<Vec<f64>> = open.iter().map(|&i| cover.scaled(cover.actions(i))).collect();
    let weighed = &targets[..targets.len().min(WEIGHED)];
    let (mut best, mut most) = (alone, 0.0);
    for (k, target) in weighed.iter().enumerate().take(TRIED) {
        // its own analysis decides a case, whatever it proves of others
        let others = [&weighed[..k], &weighed[k + 1..]].concat();
        let decided = 1.0 + forecast.decided(&others, std::slice::from_ref(target)) as f64;
        if decided > most {
            (best, most) = (Next::Case(open[k]), decided);
        }
    }
    let kinds: &[Corners] = if cases_only { &[] } else { &[Corners::Box, Corners::Simplex] };
    for bundle in kinds.iter().filter_map(|c| rays(&targets, *c)) {
        let decided = forecast.decided(weighed, &bundle) as f64 / bundle.len() as f64;
        if decided > most {
            let actions = bundle.iter().map(|p| cover.unscaled(p)).collect();
            (best, most) = (Next::Directions(actions), decided);
        }
    }
    best
}

/// What analyses are expected to prove.
struct Forecast<'a> {
    cover: &'a Cover,
    /// Carried points of the analyses that ran.
    points: Vec<Vec<f64>>,
    /// Load factor times the sum of the coordinates, of the best analysis.
    reach: f64,
    /// Lower over upper bound of the analyses, the mean.
    tightness: f64,
}

impl<'a> Forecast<'a> {
    fn new(cover: &'a Cover) -> Self {
        let known: Vec<(Vec<f64>, f64)> = cover
            .runs
            .iter()
            .filter_map(|r| Some((cover.scaled(&r.actions), r.lower()?)))
            .collect();
        let points =
            known.iter().map(|(a, l)| a.iter().map(|x| l * x).collect()).collect::<Vec<Vec<_>>>();
        let reach = points.iter().map(|p| length(p)).fold(0.0, f64::max);
        let ratios: Vec<f64> = cover
            .runs
            .iter()
            .filter_map(|r| Some(r.lower()? / r.half_space.as_ref()?.factor(&r.actions)?))
            .collect();
        let tightness = match ratios.len() {
            0 => 1.0,
            n => ratios.iter().sum::<f64>() / n as f64,
        };
        Self { cover, points, reach, tightness }
    }

    /// The lower bound that an analysis of this point is expected to give.
    fn factor(&self, point: &[f64]) -> f64 {
        let actions = self.cover.unscaled(point);
        let bounds = self.cover.runs.iter().filter_map(|r| r.half_space.as_ref()?.factor(&actions));
        let bound = bounds.fold(f64::INFINITY, f64::min) * self.tightness;
        // mechanisms of other actions may bound these far beyond what they carry
        bound.min(2.0 * self.reach / length(point))
    }

    /// How many of the targets analyses of `more` are expected to prove as carried.
    fn decided(&self, targets: &[Vec<f64>], more: &[Vec<f64>]) -> usize {
        let mut points = self.points.clone();
        points.extend(more.iter().map(|p| {
            let factor = self.factor(p);
            p.iter().map(|x| factor * x).collect()
        }));
        let carried = |t: &&Vec<f64>| {
            gauge(&points, t).is_some_and(|weights| weights.iter().sum::<f64>() <= 1.0)
        };
        targets.iter().filter(carried).count()
    }
}

fn length(point: &[f64]) -> f64 {
    point.iter().map(|x| x.abs()).sum()
}

/// How the components that vary most are enclosed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Corners {
    /// By all corners of a box: 2ⁿ rays.
    Box,
    /// By a simplex around the box: n + 1 rays that reach further.
    Simplex,
}

/// Rays whose cone contains every target in which the largest component of the first target has the
/// same sign; `None` where these targets lie on one ray.
fn rays(targets: &[Vec<f64>], corners: Corners) -> Option<Vec<Vec<f64>>> {
    let first = targets.first()?;
    let (main, size) = first
        .iter()
        .map(|x| x.abs())
        .enumerate()
        .fold((0, 0.0), |best, x| if x.1 > best.1 { x } else { best });
    let sign = first[main].signum();
    // cases without much of it lie across, and would open the cone to a half space
    let beside: Vec<&Vec<f64>> = targets.iter().filter(|t| sign * t[main] > 0.1 * size).collect();
    let range = |k: usize| {
        let ratio = |t: &&Vec<f64>| t[k] / t[main].abs();
        let of = beside.iter().map(ratio);
        let (low, high) =
            of.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), x| (l.min(x), h.max(x)));
        (0.5 * (low + high), 0.5 * (high - low))
    };
    let ranges: Vec<(f64, f64)> = (0..first.len()).map(range).collect();
    let mut varying: Vec<usize> = (0..first.len()).filter(|&k| ranges[k].1 > 1e-9).collect();
    varying.sort_by(|a, b| ranges[*b].1.total_cmp(&ranges[*a].1));
    let large = varying.iter().filter(|&&k| ranges[k].1 > NOISE).count().min(MOST_CORNERS);
    let (wide, noise) = varying.split_at(large);
    if varying.is_empty() {
        return None;
    }
    let centre: Vec<f64> = ranges.iter().map(|r| r.0).collect();
    // a point of the box is `share` of a point of the wide part and the rest of one of the noise
    let share = if noise.is_empty() { 1.0 } else { SHARE };
    let offsets = |of: &[usize], scale: f64, corners: Corners| -> Vec<Vec<(usize, f64)>> {
        let half = |k: usize| scale * ranges[k].1;
        match corners {
            Corners::Box => (0..1usize << of.len())
                .map(|bits| {
                    let side = |i: usize| if bits >> i & 1 == 1 { 1.0 } else { -1.0 };
                    of.iter().enumerate().map(|(i, &k)| (k, side(i) * half(k))).collect()
                })
                .collect(),
            // {x_k ≥ −h_k, Σ x_k/h_k ≤ n}
            Corners::Simplex => (0..=of.len())
                .map(|vertex| {
                    let reach = |i: usize| {
                        if i + 1 == vertex { 2.0 * of.len() as f64 - 1.0 } else { -1.0 }
                    };
                    of.iter().enumerate().map(|(i, &k)| (k, reach(i) * half(k))).collect()
                })
                .collect(),
        }
    };
    let mut moved = Vec::new();
    if !wide.is_empty() {
        moved.extend(offsets(wide, 1.0 / share, corners));
    }
    if !noise.is_empty() {
        let rest = if wide.is_empty() { 1.0 } else { 1.0 - share };
        moved.extend(offsets(noise, 1.0 / rest, Corners::Simplex));
    }
    let ray = |offset: Vec<(usize, f64)>| {
        let mut ray = centre.clone();
        offset.into_iter().for_each(|(k, d)| ray[k] += d);
        ray.iter().map(|x| size * x).collect()
    };
    Some(moved.into_iter().map(ray).collect())
}

#[cfg(test)]
mod tests {
    use super::*;
    use bracket_engine::model::AnalysisKind;
    use bracket_report::result::case_result::CaseResult;
    use bracket_report::result::certificate::Certificate;
    use bracket_report::result::derived_bounds::Run;
    use bracket_report::result::quantity::{FrictionModel, Quantity};

    /// Thirty load cases of one face, of which the first was analysed and is carried 1.5 times.
    fn cover() -> Cover {
        let case = |i: usize| {
            let wave = |k: usize| ((3 + 7 * i + 5 * k * i * i) % 13) as f64 / 6.0 - 1.0;
            let size = 1e6 * (30 - i) as f64;
            let force = |k: usize| 4e-3 * size * wave(k);
            (format!("LC{i}"), vec![[force(1), 0.0, force(2), 0.0, size, 0.0]])
        };
        let mut cover = Cover::new((0..30).map(case).collect());
        let of = (Quantity::LoadFactor, FrictionModel::Frictionless);
        let certificate = Some(Certificate { strict: true, ..Certificate::default() });
        let entry = CaseResult {
            lower: Some(1.5),
            certificate,
            ..CaseResult::empty("LC0", AnalysisKind::Limit, of)
        };
        let actions = cover.actions(0).clone();
        cover.runs.push(Run { entry, actions, half_space: None });
        cover
    }

    /// Directions around many load cases decide more than any of them, if they may; else the load
    /// case that decides most, one after the other until none is open.
    #[test]
    fn directions_or_load_cases() {
        let cover = cover();
        let open = cover.open();
        // two others lie on the ray of the first
        assert_eq!(open.len(), 27);
        let Next::Directions(rays) = next(&cover, &open, false) else { panic!("a load case") };
        assert_eq!(rays.len(), 3);
        let Next::Case(_) = next(&cover, &open, true) else { panic!("directions") };
        assert_eq!(next(&cover, &open[..1], false), Next::Case(open[0]));
    }

    /// Whatever varies, each target is within the cone of the rays.
    #[test]
    fn rays_enclose_their_targets() {
        let wave =
            |i: usize, k: usize| ((3 + 7 * i + 11 * i * i + 5 * k * i) % 23) as f64 / 11.0 - 1.0;
        for (spreads, box_rays, simplex_rays) in [
            ([0.0, 0.3, 0.2, 0.0, 0.0], 4, 3),
            ([0.0, 0.3, 0.0, 0.0, 0.0], 2, 2),
            ([0.0, 0.4, 0.3, 0.01, 0.005], 7, 6),
            ([0.0, 0.01, 0.0, 0.0, 0.002], 3, 3),
        ] {
            let target = |i: usize| -> Vec<f64> {
                let size = 1.0 - 0.02 * i as f64;
                let at = |k: usize| if k == 0 { 1.0 } else { spreads[k] * wave(i, k) };
                (0..5).map(|k| size * at(k)).collect()
            };
            let targets: Vec<Vec<f64>> = (0..40).map(target).collect();
            for (corners, count) in [(Corners::Box, box_rays), (Corners::Simplex, simplex_rays)] {
                let rays = rays(&targets, corners).expect("they vary");
                assert_eq!(rays.len(), count, "{spreads:?}");
                for t in &targets {
                    assert!(gauge(&rays, t).is_some(), "{spreads:?} {corners:?}: {t:?}");
                }
            }
        }
        let line: Vec<Vec<f64>> = (1..9).map(|i| vec![0.1 * i as f64, 0.05 * i as f64]).collect();
        assert_eq!(rays(&line, Corners::Box), None);
    }
}
