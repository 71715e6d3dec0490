//! Forecast of the time that the cases of a plan take.

use super::plan::Plan;
use super::screen::Kit;
use crate::spec::connection::ConnectionSpec;
use serde::Deserialize;
use serde_json::Value;

/// Time of the checks of a case on one core \[s\].
const CHECKS: f64 = 5e-4;

/// Time of finite elements of a case without a time limit \[s\].
const USUAL: f64 = 900.0;

/// Part of its time limit that an analysis uses as a rule: the next mesh does not fit any more.
const USED: f64 = 0.9;

/// Meshing, pictures and report of a case \[s\].
const AROUND: f64 = 15.0;

/// The time limit of a spec's analysis \[s\].
pub fn time_limit(spec: &Value) -> Option<f64> {
    let spec = ConnectionSpec::deserialize(spec).ok()?;
    spec.analysis.time_limit.map(|t| t.0)
}

/// Seconds of each case, if every case that may be analysed is analysed.
pub fn seconds(plan: &Plan, kit: &Kit) -> Vec<f64> {
    let header = &plan.header;
    let checks = if header.first.is_some() { CHECKS } else { 0.0 };
    let elements = header.meshes();
    let one = |index: u64| {
        if !elements {
            return checks;
        }
        let spec = kit.spec(&header.expansion, index).ok();
        let limit = spec.and_then(|s| time_limit(&s));
        checks + AROUND + limit.map_or(USUAL, |t| USED * t)
    };
    plan.cases.iter().map(|c| one(c.index)).collect()
}
