//! The first place at which two JSON values differ.

use serde_json::{Map, Value};

/// Relative difference allowed between a claimed and a recomputed number.
const SAME: f64 = 1e-9;

/// A sentence about the first place at which two values differ. Numbers agree up to their rounding
/// errors. `place` is the path of the values.
pub fn first_difference(claimed: &Value, found: &Value, place: &str) -> Option<String> {
    let differ = || {
        let shown = |v: &Value| {
            let text = if v.is_null() { "nothing".into() } else { v.to_string() };
            text.chars().take(120).collect::<String>()
        };
        Some(format!("{place} is {}, computed again it is {}", shown(claimed), shown(found)))
    };
    match (claimed, found) {
        (Value::Number(a), Value::Number(b)) => {
            let (a, b) = (a.as_f64().unwrap_or(f64::NAN), b.as_f64().unwrap_or(f64::NAN));
            // NaN never agrees
            let same = (a - b).abs() <= SAME * a.abs().max(b.abs());
            if same { None } else { differ() }
        }
        (Value::Array(a), Value::Array(b)) if a.len() == b.len() => {
            let mut pairs = a.iter().zip(b).enumerate();
            pairs.find_map(|(i, (a, b))| first_difference(a, b, &format!("{place}[{i}]")))
        }
        (Value::Object(a), Value::Object(b)) => {
            let keys = a.keys().chain(b.keys().filter(|k| !a.contains_key(*k)));
            let of =
                |map: &Map<String, Value>, key: &String| map.get(key).cloned().unwrap_or_default();
            keys.into_iter()
                .find_map(|k| first_difference(&of(a, k), &of(b, k), &format!("{place}.{k}")))
        }
        (a, b) if a == b => None,
        _ => differ(),
    }
}
