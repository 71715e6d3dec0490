//! A column of a sweep's table: its path, and the unit in its header.

use super::spec_path::SpecPath;
use bracket_base::units::{plain_minus, with_point};
use bracket_codes::verdict::Verdict;
use serde_json::{Number, Value};

/// Start of the header of a note.
pub const NOTE_MARK: &str = "note.";

/// What a column holds.
#[derive(Clone, Debug, PartialEq)]
pub enum Column {
    /// Names of the joints.
    Name,
    /// Expected verdicts.
    Expect,
    /// Texts of the user that stand in the tables of results as they are: `note.member`.
    Note(String),
    /// Values of a path of the spec, with the unit of bare numbers.
    Path(SpecPath, Option<String>),
}

impl Column {
    /// Reads a header: `name`, `expect`, `note.` with a word, or a path, with the unit of its
    /// numbers in brackets: `loads.ULS1.My [kN m]`.
    pub fn parse(header: &str) -> Result<Self, String> {
        let header = header.trim();
        if header.is_empty() {
            return Err("a column has no header".into());
        }
        match header.to_ascii_lowercase().as_str() {
            "name" => return Ok(Self::Name),
            "expect" => return Ok(Self::Expect),
            lower if lower.starts_with(NOTE_MARK) => return Ok(Self::Note(header.into())),
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

/// How the numbers of a table are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Decimals {
    /// Only with a point: the comma separates the cells.
    Point,
    /// With a point or a comma: another character separates the cells.
    PointOrComma,
}

/// The value of a cell; `None` if it is empty.
pub fn value(cell: &str, unit: Option<&str>, decimals: Decimals) -> Result<Option<Value>, String> {
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
        // between semicolons a comma stands before decimals
        let commas = decimals == Decimals::PointOrComma && inner.contains(';');
        let entries = inner.split(|c| matches!(c, ';' | ' ') || (c == ',' && !commas));
        let entries = entries.filter(|e| !e.is_empty());
        let entries = entries.map(|e| value(e, unit, decimals).map(|v| v.unwrap_or(Value::Null)));
        return entries.collect::<Result<_, _>>().map(|l| Some(Value::Array(l)));
    }
    let pointed = with_point(cell);
    let text = match (&pointed, decimals) {
        (Some(number), Decimals::PointOrComma) => number.as_str(),
        (Some(number), Decimals::Point) => {
            return Err(format!("`{cell}`: a number has a point before its decimals: `{number}`"));
        }
        (None, _) if grouped(cell) => {
            return Err(format!(
                "`{cell}` may be {} or {}: write a point before decimals and nothing between \
                 thousands",
                cell.replace(',', "."),
                cell.replace(',', "")
            ));
        }
        (None, _) => cell,
    };
    let number = plain_minus(text);
    match (number.parse::<f64>(), unit) {
        (Ok(x), _) if !x.is_finite() => Err(format!("`{cell}` is not a finite number")),
        (Ok(_), Some(unit)) => Ok(Some(Value::String(format!("{number} {unit}")))),
        (Ok(x), None) => Ok(Number::from_f64(x).map(Value::Number)),
        (Err(_), _) => Ok(Some(match text {
            "true" | "TRUE" => Value::Bool(true),
            "false" | "FALSE" => Value::Bool(false),
            text => Value::String(text.into()),
        })),
    }
}

/// True for `1,250`, of which nobody knows whether the comma stands before decimals.
fn grouped(cell: &str) -> bool {
    let digits = |t: &str| !t.is_empty() && t.bytes().all(|b| b.is_ascii_digit());
    let number = cell.trim_start_matches(['+', '-', '−']);
    let number = number.split_whitespace().next().unwrap_or_default();
    number.split_once(',').is_some_and(|(whole, rest)| digits(whole) && digits(rest))
}

/// The decimal sign of a cell that is a number: its comma or its point; `None` where it has none.
pub fn decimal_sign(cell: &str) -> Option<char> {
    let number = cell.trim().trim_start_matches(['+', '-', '−']);
    let number = number.split_whitespace().next().unwrap_or_default();
    let (whole, rest) = number.split_once([',', '.'])?;
    let digits = |t: &str| !t.is_empty() && t.bytes().all(|b| b.is_ascii_digit());
    let sign = number[whole.len()..].chars().next();
    sign.filter(|_| digits(whole) && digits(rest))
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
            ("−12", None, Ok(Some(json!(-12.0)))),
            ("−43.2", Some("kN m"), Ok(Some(json!("-43.2 kN m")))),
        ] {
            for decimals in [Decimals::Point, Decimals::PointOrComma] {
                assert_eq!(value(cell, unit, decimals), want, "{cell}");
            }
        }
        for (cell, unit, want) in [
            ("12,5", None, json!(12.5)),
            ("-0,125", None, json!(-0.125)),
            ("−43,25", Some("kN m"), json!("-43.25 kN m")),
            ("1250,125", None, json!(1250.125)),
            ("7,5 kN", Some("kN m"), json!("7.5 kN")),
            ("[-105,5; 105]", None, json!([-105.5, 105.0])),
            ("[-105,105]", None, json!([-105.0, 105.0])),
            ("Joint A, left", None, json!("Joint A, left")),
        ] {
            assert_eq!(value(cell, unit, Decimals::PointOrComma), Ok(Some(want)), "{cell}");
        }
        for cell in ["1,250", "-12,500"] {
            let fault = value(cell, None, Decimals::PointOrComma).expect_err(cell);
            assert!(fault.contains("may be"), "{fault}");
        }
        for (cell, why) in [("12,5", "`12.5`"), ("[1; 2", "no end"), ("inf", "not a finite")] {
            let fault = value(cell, None, Decimals::Point).expect_err(cell);
            assert!(fault.contains(why), "{cell}: {fault}");
        }
        // the reading of a list within a list would go as deep as the lists
        for depth in [2, 100_000] {
            let cell = format!("{}1{}", "[".repeat(depth), "]".repeat(depth));
            assert!(
                value(&cell, None, Decimals::Point)
                    .expect_err("nested")
                    .contains("a list within a list")
            );
        }
        assert_eq!(verdict("NOT OK"), Ok(Some(Verdict::NotOk)));
        assert!(verdict("perhaps").is_err());
    }
}
