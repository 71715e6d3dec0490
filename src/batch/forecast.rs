//! Forecast of the time that the cases of a plan take.

use super::expansion::typed;
use super::plan::Plan;
use super::screen::Kit;
use rayon::prelude::*;
use serde_json::Value;
use std::path::Path;

/// Time of the checks of a case on one core \[s\].
const CHECKS: f64 = 5e-4;

/// Time of finite elements of a case without a time limit \[s\].
const USUAL: f64 = 900.0;

/// Part of its time limit that an analysis uses as a rule: the next mesh does not fit any more.
const USED: f64 = 0.9;

/// Start, pictures and report of a case \[s\].
const AROUND: f64 = 3.0;

/// The time limit of the analysis of a spec, read from `file` \[s\].
pub fn time_limit(spec: &Value, file: &Path) -> Option<f64> {
    let spec = typed(spec, file).ok()?;
    spec.analysis.time_limit.map(|t| t.0)
}

/// Time of finite elements of a case whose analysis has a time limit \[s\].
pub fn elements(limit: Option<f64>) -> f64 {
    AROUND + limit.map_or(USUAL, |t| USED * t)
}

/// Seconds of each case, if every case that may be analysed is analysed.
pub fn seconds(plan: &Plan, kit: &Kit) -> Vec<f64> {
    let header = &plan.header;
    let checks = if header.first.is_some() { CHECKS } else { 0.0 };
    if !header.meshes() {
        return vec![checks; plan.cases.len()];
    }
    let limit = |index: u64| time_limit(&kit.spec(&header.expansion, index).ok()?, &kit.file);
    let one = |index: u64| checks + elements(limit(index));
    let paths = header.expansion.paths();
    if paths.into_iter().any(|p| p.starts_with("analysis")) {
        return plan.cases.par_iter().map(|c| one(c.index)).collect();
    }
    // all have the time limit of the base
    vec![plan.cases.first().map_or(0.0, |c| one(c.index)); plan.cases.len()]
}

/// The time left in a sweep. What the finished cases took corrects the forecasts of the others.
#[derive(Clone, Debug, Default)]
pub struct TimeLeft {
    /// Forecast of the cases that are not finished \[s\].
    open: f64,
    /// Forecast of the finished ones \[s\].
    forecast: f64,
    /// Time that they took \[s\].
    taken: f64,
}

impl TimeLeft {
    /// The time left for cases with these forecasts \[s\].
    pub fn new(forecasts: impl Iterator<Item = f64>) -> Self {
        Self { open: forecasts.sum(), ..Self::default() }
    }

    /// A case ended after `taken` seconds; `None`: it is not needed, or was there already.
    pub fn ended(&mut self, forecast: f64, taken: Option<f64>) {
        self.open -= forecast;
        if let Some(taken) = taken {
            self.forecast += forecast;
            self.taken += taken;
        }
    }

    /// Seconds left, with this number of cases side by side.
    pub fn seconds(&self, workers: usize) -> f64 {
        let ratio = if self.forecast > 0.0 { self.taken / self.forecast } else { 1.0 };
        (ratio * self.open / workers.max(1) as f64).max(0.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Cases that take half of their forecast halve the time left.
    #[test]
    fn finished_cases_correct_the_forecast() {
        let mut left = TimeLeft::new([600.0; 4].into_iter());
        assert_eq!(left.seconds(2), 1200.0);
        left.ended(600.0, Some(300.0));
        assert_eq!(left.seconds(2), 450.0);
        left.ended(600.0, None);
        assert_eq!(left.seconds(1), 600.0);
    }
}
