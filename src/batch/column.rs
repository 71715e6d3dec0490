//! A column of a sweep's table: its path, and the unit in its header.

use super::spec_path::SpecPath;
use crate::checks::verdict::Verdict;
use crate::units::with_point;
use serde_json::{Number, Value};

/// What a column holds.
#[derive(Clone, Debug, PartialEq)]
pub enum Column {
    /// Names of the joints.
    Name,
    /// Expected verdicts.
    Expect,
    /// Values of a path of the spec, with the unit of bare numbers.
    Path(SpecPath, Option<String>),
}

impl Column {
    /// Reads a header: `name`, `expect`, or a path, with the unit of its numbers in brackets:
    /// `loads.ULS1.My [kN m]`.
    pub fn parse(header: &str) -> Result<Self, String> {
        let header = header.trim();
        if header.is_empty() {
            return Err("a column has no header".into());
        }
        match header.to_ascii_lowercase().as_str() {
            "name" => return Ok(Self::Name),
            "expect" => return Ok(Self::Expect),
            _ => {}
        }
        // a unit stands behind a blank: `rows[0]` is a position
        let (path, unit) =
            header.split_once(char::is_whitespace).map_or((header, ""), |(p, u)| (p, u.trim()));
        let unit = match unit {
            "" => None,
            u => {
                let inner = u
                    .strip_prefix('[')
                    .and_then(|u| u.strip_suffix(']'))
                    .or_else(|| u.strip_prefix('(').and_then(|u| u.strip_suffix(')')));
                let Some(inner) = inner else {
                    return Err(format!("`{header}`: write the unit in brackets, `[kN m]`"));
                };
                Some(inner.trim().to_string())
            }
        };
        Ok(Self::Path(SpecPath::parse(path)?, unit))
    }
}

/// The value of a cell; `None` if it is empty.
pub fn value(cell: &str, unit: Option<&str>) -> Result<Option<Value>, String> {
    let cell = cell.trim();
    if cell.is_empty() {
        return Ok(None);
    }
    if let Some(inner) = cell.strip_prefix('[') {
        let Some(inner) = inner.strip_suffix(']') else {
            return Err(format!("`{cell}`: the list has no end"));
        };
        if inner.contains(['[', ']']) {
            return Err("a list within a list: a cell holds a value or one list of values".into());
        }
        let entries = inner.split([';', ',', ' ']).filter(|e| !e.is_empty());
        let entries = entries.map(|e| value(e, unit).map(|v| v.unwrap_or(Value::Null)));
        return entries.collect::<Result<_, _>>().map(|l| Some(Value::Array(l)));
    }
    if let Some(number) = with_point(cell) {
        return Err(format!("`{cell}`: a number has a point before its decimals: `{number}`"));
    }
    match (cell.parse::<f64>(), unit) {
        (Ok(x), _) if !x.is_finite() => Err(format!("`{cell}` is not a finite number")),
        (Ok(_), Some(unit)) => Ok(Some(Value::String(format!("{cell} {unit}")))),
        (Ok(x), None) => Ok(Number::from_f64(x).map(Value::Number)),
        (Err(_), _) => Ok(Some(match cell {
            "true" | "TRUE" => Value::Bool(true),
            "false" | "FALSE" => Value::Bool(false),
            text => Value::String(text.into()),
        })),
    }
}

/// An expected verdict.
pub fn verdict(cell: &str) -> Result<Option<Verdict>, String> {
    match cell.trim().to_ascii_lowercase().replace([' ', '-'], "_").as_str() {
        "" => Ok(None),
        "ok" => Ok(Some(Verdict::Ok)),
        "not_ok" => Ok(Some(Verdict::NotOk)),
        "undecided" => Ok(Some(Verdict::Undecided)),
        _ => Err(format!("`{cell}` is not a verdict: ok, not_ok or undecided")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    #[test]
    fn headers() {
        let path = |p: &str, u: Option<&str>| {
            Ok(Column::Path(SpecPath::parse(p).expect("a path"), u.map(str::to_owned)))
        };
        for (header, want) in [
            (" Name ", Ok(Column::Name)),
            ("expect", Ok(Column::Expect)),
            ("plate.thickness", path("plate.thickness", None)),
            ("bolts.rows[0] (cm)", path("bolts.rows[0]", Some("cm"))),
            ("loads.ULS1.My [kN m]", path("loads.ULS1.My", Some("kN m"))),
        ] {
            assert_eq!(Column::parse(header), want, "{header}");
        }
        for header in ["", "My kNm", "a..b"] {
            assert!(Column::parse(header).is_err(), "{header}");
        }
    }

    #[test]
    fn cells() {
        for (cell, unit, want) in [
            ("", None, Ok(None)),
            ("12", None, Ok(Some(json!(12.0)))),
            ("-43.2", Some("kN m"), Ok(Some(json!("-43.2 kN m")))),
            ("5 kN", Some("kN m"), Ok(Some(json!("5 kN")))),
            ("IPE330", None, Ok(Some(json!("IPE330")))),
            ("[-105; 105]", None, Ok(Some(json!([-105.0, 105.0])))),
            ("TRUE", None, Ok(Some(json!(true)))),
        ] {
            assert_eq!(value(cell, unit), want, "{cell}");
        }
        for (cell, why) in [("12,5", "`12.5`"), ("[1; 2", "no end"), ("inf", "not a finite")] {
            let fault = value(cell, None).expect_err(cell);
            assert!(fault.contains(why), "{cell}: {fault}");
        }
        // the reading of a list within a list would go as deep as the lists
        for depth in [2, 100_000] {
            let cell = format!("{}1{}", "[".repeat(depth), "]".repeat(depth));
            assert!(value(&cell, None).expect_err("nested").contains("a list within a list"));
        }
        assert_eq!(verdict("NOT OK"), Ok(Some(Verdict::NotOk)));
        assert!(verdict("perhaps").is_err());
    }
}
