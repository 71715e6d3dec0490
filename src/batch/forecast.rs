//! Forecast of the time that the cases of a plan take.

use super::plan::Plan;
use super::screen::Kit;
use crate::spec::connection::ConnectionSpec;
use serde::Deserialize;

/// Time of the checks of a case on one core \[s\].
const CHECKS: f64 = 5e-4;

/// Time of finite elements of a case without a time limit \[s\].
const USUAL: f64 = 900.0;

/// Part of its time limit that an analysis uses as a rule: the next mesh does not fit any more.
const USED: f64 = 0.9;

/// Meshing, pictures and report of a case \[s\].
const AROUND: f64 = 15.0;

/// Seconds of each case, if every case that may be analysed is analysed.
pub fn seconds(plan: &Plan, kit: &Kit) -> Vec<f64> {
    let header = &plan.header;
    let checks = if header.first.is_some() { CHECKS } else { 0.0 };
    let elements = header.first.is_none() || header.then.is_some();
    let one = |index: u64| {
        if !elements {
            return checks;
        }
        let spec = kit.spec(&header.expansion, index).ok();
        let limit = spec
            .and_then(|s| ConnectionSpec::deserialize(&s).ok())
            .and_then(|s| s.analysis.time_limit);
        checks + AROUND + limit.map_or(USUAL, |t| USED * t.0)
    };
    plan.cases.iter().map(|c| one(c.index)).collect()
}
