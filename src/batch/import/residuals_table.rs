//! `residuals.csv`: what the members at each node leave, load case by load case.

use super::equilibrium::OfCase;
use bracket_report::escaped::csv_cell;

/// Name of the file.
pub const FILE: &str = "residuals.csv";

/// Relative size of the steps in which a remainder is written: a sum has the noise of its parts.
const DIGITS: usize = 11;

/// The headers.
const HEADERS: [&str; 6] = [
    "joint",
    "load_case",
    "vertical [kN]",
    "largest_part [kN]",
    "moment [kN m]",
    "largest_part [kN m]",
];

/// The table; `None` if no joint has a member of the column.
pub fn text<'a>(joints: impl Iterator<Item = (&'a str, &'a [OfCase])>) -> Option<String> {
    let mut out = csv::Writer::from_writer(Vec::new());
    // a writer to memory cannot fail
    let _ = out.write_record(HEADERS);
    let mut any = false;
    for (name, cases) in joints {
        for case in cases {
            any = true;
            let [force, part] = [case.vertical.value, case.vertical.scale].map(|x| plain(x, 1e3));
            let moment = case.moment.map(|m| [m.value, m.scale].map(|x| plain(x, 1e6)));
            let [moment, of_moment] = moment.unwrap_or_default();
            let [name, case] = [name, &case.case].map(|n| csv_cell(n).to_string());
            let _ = out.write_record([name, case, force, part, moment, of_moment]);
        }
    }
    let text = String::from_utf8(out.into_inner().ok()?).ok()?;
    any.then_some(text)
}

/// A value in a unit without the noise of its last digits.
fn plain(value: f64, unit: f64) -> String {
    let text = format!("{:.*e}", DIGITS, value / unit + 0.0);
    text.parse::<f64>().map_or(text, |x| x.to_string())
}

#[cfg(test)]
mod tests {
    use super::super::equilibrium::Sum;
    use super::*;

    #[test]
    fn a_row_for_each_load_case() {
        let sum = |value: f64, scale: f64| Sum { value, scale };
        let cases = [
            OfCase {
                case: "A".into(),
                vertical: sum(12_300.000_000_000_002, 485e3),
                moment: Some(sum(-1.5e6, 8e6)),
            },
            OfCase { case: "B, 2".into(), vertical: sum(0.0, 1.0), moment: None },
        ];
        let table = text([("J1", &cases[..])].into_iter()).expect("rows");
        let rows: Vec<&str> = table.lines().skip(1).collect();
        assert_eq!(rows, ["J1,A,12.3,485,-1.5,8", "J1,\"B, 2\",0,0.001,,"]);
        assert_eq!(text([("J1", &[][..])].into_iter()), None);
    }
}
