//! Remaining time of a solve, estimated at first from its forecast, then from its own pace.

use bracket_engine::solve::Iteration;

/// Iterations of a typical solve.
const TYPICAL: f64 = 20.0;

/// Number of iterations from which the trend is computed.
const WINDOW: usize = 5;

/// Number of iterations after which only the trend counts. The first iterations are not
/// representative, because their steps are short.
const SETTLED: f64 = 8.0;

/// Slowest assumed trend, in decades per iteration: a stalled solve ends earlier than its trend
/// predicts.
const SLOWEST: f64 = 0.1;

/// The iterations of one solve so far, and the remaining time they predict.
#[derive(Clone, Debug, Default)]
pub struct Pace {
    tolerance: f64,
    forecast: Option<f64>,
    /// Seconds since the solve began and log₁₀ of the larger of gap and residual, by iteration.
    iterations: Vec<(f64, f64)>,
    last: Option<u32>,
}

impl Pace {
    /// The pace of a solve that ends at `tolerance` and is expected to take `forecast` seconds.
    pub fn new(tolerance: f64, forecast: Option<f64>) -> Self {
        Self { tolerance, forecast, iterations: Vec::new(), last: None }
    }

    /// Adds the next iteration. If the numbers start again, another solver has taken over, and its
    /// pace is measured anew.
    pub fn add(&mut self, i: &Iteration) {
        if self.last.is_some_and(|last| i.number <= last) {
            self.iterations.clear();
            self.forecast = None;
        }
        self.last = Some(i.number);
        // a gap that is not finite yet counts as no progress
        let merit = i.gap.max(i.residual).log10();
        self.iterations.push((i.seconds, if merit.is_finite() { merit.min(0.0) } else { 0.0 }));
    }

    /// Seconds left after the last iteration; `None` if nothing is known yet.
    pub fn left(&self) -> Option<f64> {
        let done = self.iterations.len().saturating_sub(1);
        let (Some(&(start, _)), Some(&(now, merit))) =
            (self.iterations.first(), self.iterations.last())
        else {
            return self.forecast;
        };
        if done == 0 {
            return self.forecast.map(|f| (f - now).max(1.0));
        }
        let each = (now - start) / done as f64;
        let window = done.min(WINDOW);
        let slope = ((self.iterations[done - window].1 - merit) / window as f64).max(SLOWEST);
        let trend = ((merit - self.tolerance.log10()) / slope).clamp(1.0, 3.0 * TYPICAL);
        let usual = (TYPICAL - done as f64).max(2.0);
        let weight = (done as f64 / SETTLED).min(1.0);
        Some(each * (weight * trend + (1.0 - weight) * usual))
    }

    /// Share of the whole solve that is done, 0 to 1.
    pub fn share(&self) -> f64 {
        let spent = self.iterations.last().map_or(0.0, |t| t.0);
        self.left().filter(|left| spent + left > 0.0).map_or(0.0, |left| spent / (spent + left))
    }
}

/// A duration in words: `about 40 s`, `about 3 min`, `about 2.5 h`.
pub fn about(seconds: f64) -> String {
    if !seconds.is_finite() {
        return "an unknown time".into();
    }
    if seconds < 1.0 {
        "under 1 s".into()
    } else if seconds < 10.0 {
        format!("about {:.0} s", seconds)
    } else if seconds < 90.0 {
        format!("about {:.0} s", 5.0 * (seconds / 5.0).round())
    } else if seconds < 5400.0 {
        format!("about {:.0} min", seconds / 60.0)
    } else {
        format!("about {:.1} h", seconds / 3600.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn at(number: u32, gap: f64, seconds: f64) -> Iteration {
        Iteration { number, gap, residual: 0.1 * gap, step: 0.9, seconds }
    }

    /// Ten seconds per iteration and one decade per two iterations: 18 iterations from 1 to 1e-9.
    #[test]
    fn the_forecast_counts_until_the_pace_is_known() {
        let mut pace = Pace::new(1e-9, Some(200.0));
        assert_eq!(pace.left(), Some(200.0));
        pace.add(&at(0, 1.0, 10.0));
        assert_eq!(pace.left(), Some(190.0));
        assert_eq!(pace.share(), 0.05);
        let mut before = f64::INFINITY;
        for k in 1..18 {
            pace.add(&at(k, 10f64.powf(-0.5 * f64::from(k)), 10.0 + 10.0 * f64::from(k)));
            let left = pace.left().expect("known");
            let truth = 10.0 * f64::from(18 - k);
            // the weight of the typical 20 iterations decreases steadily
            assert!((left - truth).abs() <= 20.0 && left < before, "{k}: {left} against {truth}");
            assert!(k < 8 || (left - truth).abs() < 1e-6, "{k}: {left} against {truth}");
            before = left;
        }
        assert!(pace.share() > 0.9);
    }

    #[test]
    fn nothing_known_is_nothing_said() {
        let mut pace = Pace::new(1e-9, None);
        assert_eq!((pace.left(), pace.share()), (None, 0.0));
        pace.add(&at(0, 1.0, 0.0));
        assert_eq!((pace.left(), pace.share()), (None, 0.0));
        pace.add(&at(1, f64::INFINITY, 2.0));
        let left = pace.left().expect("known");
        assert!(left > 20.0 && left < 200.0, "{left}");
        pace.add(&at(2, f64::NAN, 4.0));
        assert!(pace.left().is_some_and(f64::is_finite));
    }

    #[test]
    fn stalls_and_other_solvers_do_not_run_away() {
        let mut pace = Pace::new(1e-9, Some(10.0));
        for k in 0..30 {
            pace.add(&at(k, 1e-3, f64::from(k)));
        }
        assert!(pace.left().is_some_and(|l| l <= 60.0));
        // beyond its tolerance there is at least one iteration to come
        pace.add(&at(30, 1e-12, 30.0));
        assert!(pace.left().is_some_and(|l| (0.5..60.0).contains(&l)));
        // another solver takes over: its first iteration gives no pace yet
        pace.add(&at(0, 1.0, 31.0));
        assert_eq!(pace.left(), None);
        pace.add(&at(1, 0.5, 41.0));
        assert!(pace.left().is_some_and(|l| l > 100.0));
    }

    #[test]
    fn durations_read_well() {
        let words = [0.2, 4.4, 42.0, 88.0, 100.0, 3000.0, 9000.0, f64::INFINITY].map(about);
        let expected = [
            "under 1 s",
            "about 4 s",
            "about 40 s",
            "about 90 s",
            "about 2 min",
            "about 50 min",
            "about 2.5 h",
            "an unknown time",
        ];
        assert_eq!(words, expected);
    }
}
