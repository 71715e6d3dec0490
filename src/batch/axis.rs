//! The values of an axis: a list, a range of numbers, or a range of profiles.

use super::dimension::{Dimension, Setting};
use super::spec_path::SpecPath;
use bracket_base::diag::{Diagnostic, Place};
use bracket_base::units::plain_minus;
use bracket_base::yaml::PlaceIndex;
use bracket_joint::catalog::{Catalog, IProfile};
use serde_json::{Map, Number, Value};

/// Most values of one axis; a range with a tiny step is a slip of the pen.
const MOST: usize = 100_000;

/// Relative distance from a whole number of steps up to which the end of a range is a step.
const WHOLE: f64 = 1e-6;

/// Reads the axis `key: value` of a sweep file.
pub fn dimension(
    key: &str,
    value: &Value,
    catalog: &Catalog,
    index: &PlaceIndex,
) -> Result<Dimension, Box<Diagnostic>> {
    let at = format!("axes.{key}");
    let fault = |message: String, help: &str| {
        let d = Diagnostic::input("sweep/axis", message).help(help);
        Box::new(Diagnostic { place: index.place(&at), ..d })
    };
    let paths: Vec<SpecPath> =
        key.split(',').map(SpecPath::parse).collect::<Result<_, _>>().map_err(|e| {
            fault(e, "an axis is a path of the spec, or several with commas between them")
        })?;
    let linked = paths.len() > 1;
    let entries: Vec<Value> = match value {
        Value::Array(list) => list.clone(),
        Value::String(range) if !linked => profiles(range, catalog).map_err(|e| {
            fault(
                format!("axis `{key}`: {e}"),
                "write a list `[IPE200, IPE240]` or a range `IPE200..IPE400`",
            )
        })?,
        Value::Object(range) if !linked => numbers(range).map_err(|e| {
            fault(format!("axis `{key}`: {e}"), "write `{from: 10, to: 25, step: 5}`")
        })?,
        _ => {
            let help = "write a list of values, a range `{from: 10, to: 25, step: 5}` or a range \
                        of profiles `IPE200..IPE400`; linked paths take a list of lists";
            return Err(fault(format!("the axis `{key}` has no list of values"), help));
        }
    };
    if entries.is_empty() {
        return Err(fault(format!("the axis `{key}` has no values"), "give at least one value"));
    }
    let from_list = value.is_array();
    let steps = entries.into_iter().enumerate().map(|(i, entry)| {
        let place: Place = match from_list {
            true => index.place(&format!("{at}[{i}]")),
            false => index.place(&at),
        };
        let values = match (linked, entry) {
            (false, value) => vec![value],
            (true, Value::Array(list)) if list.len() == paths.len() => list,
            (true, other) => {
                let message = format!(
                    "axis `{key}`: the entry `{other}` does not give {} values",
                    paths.len()
                );
                let d = Diagnostic::input("sweep/axis", message)
                    .help("write a list with one value for each path: `[[M16, 80], [M20, 90]]`");
                return Err(Box::new(Diagnostic { place, ..d }));
            }
        };
        let given = |v: Value| match v {
            Value::Null => None,
            v => Some(v),
        };
        let values = values.into_iter().map(given).collect();
        Ok(Setting { name: None, values, expect: None, notes: Vec::new(), place })
    });
    let steps = steps.collect::<Result<Vec<_>, Box<Diagnostic>>>()?;
    Ok(Dimension {
        what: format!("the axis `{key}`"),
        table: false,
        paths,
        notes: Vec::new(),
        steps,
    })
}

/// The profiles of a range `IPE200..IPE400`, in the order of the catalogue.
fn profiles(range: &str, catalog: &Catalog) -> Result<Vec<Value>, String> {
    let Some((first, last)) = range.split_once("..") else {
        return Err(format!("`{range}` is neither a list nor a range"));
    };
    let find = |name: &str| catalog.profile(name.trim()).map_err(|e| e.to_string());
    let (first, last) = (find(first)?, find(last)?);
    if first.series != last.series {
        return Err(format!(
            "`{}` is of the series {}, `{}` of {}",
            first.name, first.series, last.name, last.series
        ));
    }
    let series: Vec<&IProfile> =
        catalog.profiles().iter().filter(|p| p.series == first.series).collect();
    let at = |p: &IProfile| series.iter().position(|s| s.name == p.name).unwrap_or(0);
    let (a, b) = (at(first), at(last));
    if a > b {
        return Err(format!("`{}` stands after `{}` in the catalogue", first.name, last.name));
    }
    Ok(series[a..=b].iter().map(|p| Value::String(p.name.clone())).collect())
}

/// The numbers of a range `{from, to, step}`; all three have the same unit, or none.
fn numbers(range: &Map<String, Value>) -> Result<Vec<Value>, String> {
    let keys = ["from", "to", "step"];
    if let Some(other) = range.keys().find(|k| !keys.contains(&k.as_str())) {
        let hint = bracket_base::diag::did_you_mean(other, keys);
        return Err(format!("unknown key `{other}` in a range{hint}"));
    }
    let read = |key: &str| match range.get(key) {
        Some(Value::Number(n)) => Ok((n.as_f64().unwrap_or(f64::NAN), String::new())),
        Some(Value::String(text)) => {
            let text = plain_minus(text.trim());
            let split = text.find(|c: char| c.is_alphabetic()).unwrap_or(text.len());
            let number = text[..split].trim();
            let value = number.parse().map_err(|_| format!("`{key}: {text}` is not a number"))?;
            Ok((value, text[split..].trim().to_string()))
        }
        Some(other) => Err(format!("`{key}: {other}` is not a number")),
        None => Err(format!("the range lacks `{key}`")),
    };
    let ((from, unit), (to, of_to), (step, of_step)) = (read("from")?, read("to")?, read("step")?);
    if unit != of_to || unit != of_step {
        return Err(format!(
            "`from`, `to` and `step` have the units `{unit}`, `{of_to}`, `{of_step}`"
        ));
    }
    if ![from, to, step].iter().all(|x: &f64| x.is_finite()) || step == 0.0 {
        return Err("a range needs finite numbers and a step that is not zero".into());
    }
    let count = (to - from) / step;
    if count < -WHOLE {
        return Err(format!("the step {step} leads from {from} away from {to}"));
    }
    if count > MOST as f64 {
        return Err(format!("the range has {count:.0} steps; at most {MOST} are allowed"));
    }
    let steps = (count * (1.0 + WHOLE) + WHOLE).floor() as usize;
    (0..=steps)
        .map(|i| {
            // nine digits hide the rounding of 0.1 + 0.2
            let value: f64 = format!("{:.9}", from + i as f64 * step).parse().unwrap_or(f64::NAN);
            if !unit.is_empty() {
                return Ok(Value::String(format!("{value} {unit}")));
            }
            let number = Number::from_f64(value).ok_or("a step is not finite")?;
            Ok(Value::Number(number))
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;
    use std::path::Path;

    fn read(key: &str, value: Value) -> Result<Vec<Vec<Option<Value>>>, String> {
        let catalog = Catalog::builtin().expect("the shipped catalogue");
        let index = PlaceIndex::new(Path::new("sweep.yaml"));
        let made = dimension(key, &value, &catalog, &index);
        made.map(|d| d.steps.into_iter().map(|s| s.values).collect()).map_err(|d| d.message)
    }

    fn flat(key: &str, value: Value) -> Vec<Value> {
        let steps = read(key, value).expect("an axis");
        steps.into_iter().map(|s| s[0].clone().expect("a value")).collect()
    }

    #[test]
    fn lists_and_ranges() {
        assert_eq!(flat("plate.thickness", json!([10, "12 mm"])), [json!(10), json!("12 mm")]);
        assert_eq!(
            flat("plate.thickness", json!({"from": 10, "to": 25, "step": 5})),
            [10.0, 15.0, 20.0, 25.0].map(|x| json!(x))
        );
        assert_eq!(
            flat("x", json!({"from": "0.1 kN", "to": "0.3 kN", "step": "0.1 kN"})),
            ["0.1 kN", "0.2 kN", "0.3 kN"].map(|x| json!(x))
        );
        assert_eq!(flat("x", json!({"from": 3, "to": 1, "step": -1})).len(), 3);
        let pasted = json!({"from": "−2 kN", "to": "0 kN", "step": "1 kN"});
        assert_eq!(flat("x", pasted), ["-2 kN", "-1 kN", "0 kN"].map(|x| json!(x)));
        assert_eq!(
            flat("members.beam.profile", json!("IPE200..IPE270")),
            ["IPE200", "IPE220", "IPE240", "IPE270"].map(|x| json!(x))
        );
        let linked = read("bolts.size, bolts.gauge", json!([["M16", 80], ["M20", null]]));
        assert_eq!(
            linked,
            Ok(vec![vec![Some(json!("M16")), Some(json!(80))], vec![Some(json!("M20")), None]])
        );
    }

    #[test]
    fn faults() {
        for (key, value, why) in [
            ("t", json!([]), "no values"),
            ("t", json!(5), "no list"),
            ("t", json!({"from": 1, "to": 2}), "lacks `step`"),
            ("t", json!({"from": 1, "to": 2, "stop": 1}), "did you mean `step`"),
            ("t", json!({"from": 1, "to": 2, "step": 0}), "not zero"),
            ("t", json!({"from": 1, "to": 2, "step": -1}), "away from"),
            ("t", json!({"from": 0, "to": 1, "step": 1e-9}), "at most"),
            ("t", json!({"from": "1 mm", "to": 2, "step": 1}), "units"),
            ("p", json!("IPE200"), "neither"),
            ("p", json!("IPE200..HEB300"), "series"),
            ("p", json!("IPE400..IPE200"), "stands after"),
            ("p", json!("IPE200..IPE999"), "not in the catalogue"),
            ("a, b", json!([[1]]), "does not give 2 values"),
            ("a, b", json!({"from": 1, "to": 2, "step": 1}), "no list"),
            ("a..b", json!([1]), "not a path"),
        ] {
            let fault = read(key, value.clone()).expect_err(key);
            assert!(fault.contains(why), "{key} {value}: {fault}");
        }
    }
}
