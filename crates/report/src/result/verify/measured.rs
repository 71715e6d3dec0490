//! The estimates for the route of analysis on the last mesh, from the stored fields.

use super::derived::Reference;
use crate::result::case_result::CaseResult;
use crate::result::evidence::Side;
use bracket_engine::analysis::energy_pass::EnergyPass;
use bracket_engine::model::{AnalysisKind, AnalysisModel};
use serde_json::{Value, json};
use std::collections::BTreeMap;

/// Relative difference allowed between a claimed and a recomputed number: the fields are read back
/// to the last digits.
const SAME: f64 = 1e-6;

/// What the stored fields give otherwise; `None` if the estimates agree, or if nothing says what is
/// measured.
pub(super) fn measured_differences(
    claimed: &CaseResult,
    passes: &[(AnalysisModel, EnergyPass)],
    reference: Option<&Reference>,
) -> Option<String> {
    let none = claimed.evidence.is_none() && claimed.critical.is_none();
    let of_kind = claimed.analysis == AnalysisKind::Elastoplastic;
    let plan = match reference?.evidence.as_ref().filter(|_| of_kind) {
        Some(plan) => plan,
        None if none => return None,
        None => return Some("`evidence` is given, and the spec asks for none".into()),
    };
    let (Some(first), Some(last)) = (passes.first(), passes.last()) else {
        return (!none).then(|| "`evidence` is given without fields of an energy".into());
    };
    let [upper, lower] = [first, last].map(|(model, pass)| Side { model, pass });
    let found = json!(plan.measure(upper, lower));
    let given = json!(claimed.evidence);
    let parts = ["tets", "bolts", "plates", "welds"].map(|key| (key, &given[key], &found[key]));
    let differs = parts.into_iter().find(|(_, a, b)| !same(a, b));
    if let Some((key, ..)) = differs {
        return Some(format!("`evidence` is not that of the stored fields: {key}"));
    }
    // without them their step is open: nothing is claimed
    claimed.critical.as_ref()?;
    let critical = json!(plan.critical(upper, lower).ok().map(|b| b.factors));
    (!same(&json!(claimed.critical), &critical))
        .then(|| "`critical` is not what the stored fields give".into())
}

/// Whether two values are equal, but for the last digits of numbers: beside the largest number with
/// the same key.
pub(super) fn same(a: &Value, b: &Value) -> bool {
    let mut sizes = BTreeMap::new();
    [a, b].into_iter().for_each(|of| largest(of, "", &mut sizes));
    near(a, b, "", &sizes)
}

/// The largest size of the numbers below each key.
fn largest<'a>(of: &'a Value, key: &'a str, sizes: &mut BTreeMap<&'a str, f64>) {
    match of {
        Value::Number(n) => {
            let size = sizes.entry(key).or_default();
            *size = size.max(n.as_f64().map_or(0.0, f64::abs));
        }
        Value::Array(all) => all.iter().for_each(|x| largest(x, key, sizes)),
        Value::Object(all) => all.iter().for_each(|(key, x)| largest(x, key, sizes)),
        _ => {}
    }
}

fn near(a: &Value, b: &Value, key: &str, sizes: &BTreeMap<&str, f64>) -> bool {
    match (a, b) {
        (Value::Number(a), Value::Number(b)) => {
            let within = SAME * sizes.get(key).copied().unwrap_or(0.0);
            matches!((a.as_f64(), b.as_f64()), (Some(a), Some(b)) if (a - b).abs() <= within)
        }
        (Value::Array(a), Value::Array(b)) => {
            a.len() == b.len() && a.iter().zip(b).all(|(a, b)| near(a, b, key, sizes))
        }
        (Value::Object(a), Value::Object(b)) => {
            let other =
                |(key, a): (&String, &Value)| b.get(key).is_some_and(|b| near(a, b, key, sizes));
            a.len() == b.len() && a.iter().all(other)
        }
        (a, b) => a == b,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A small number beside a large one of another key is compared with its own size.
    #[test]
    fn a_strain_is_not_compared_with_a_coordinate() {
        let of = |strain: f64, x: f64| json!([{"membrane": strain, "membrane_at": [x, 0.0]}]);
        assert!(same(&of(1e-3, 60.0), &of(1e-3 + 1e-12, 60.0 + 1e-6)));
        assert!(!same(&of(1e-3, 60.0), &of(1.1e-3, 60.0)));
        assert!(!same(&of(1e-3, 60.0), &of(1e-3, 60.1)));
        assert!(!same(&of(1e-3, 60.0), &json!([])) && !same(&of(1e-3, 60.0), &Value::Null));
    }
}
