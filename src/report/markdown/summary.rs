//! The table that a checker reads first: every check with a demand, with the governing one in bold.

use crate::checks::check::number;
use crate::checks::verdict::Verdict;
use crate::checks::{Check, Status, Topic, Unit};
use crate::report::figures::{Rounding, significant};
use crate::report::markdown::markup::{paragraph, strings, table};
use crate::report::markdown::report_data::Table;
use crate::result::result_file::Quantity;
use crate::result::result_file::ResultFile;

/// A row, with the utilisation by which it may govern; `None` if the row decides nothing.
struct Row {
    cells: Vec<String>,
    governs_by: Option<f64>,
}

/// Writes check, Ed, Rd, utilisation, clause and status; empty without a demand.
pub(crate) fn table_of_checks(page: &mut String, result: &ResultFile) {
    let mut rows: Vec<Row> = Vec::new();
    for case in &result.cases {
        let Some(demand) = case.demand.as_ref().filter(|_| case.quantity == Quantity::LoadFactor)
        else {
            continue;
        };
        let used = case.utilisation.map(|[l, u]| {
            let (l, u) = (significant(l, 3, Rounding::Down), significant(u, 3, Rounding::Up));
            format!("{l} … {u}")
        });
        let bounds = match case.factor_bounds() {
            (Some(l), Some(u)) => {
                format!(
                    "{} … {}",
                    significant(l, 3, Rounding::Down),
                    significant(u, 3, Rounding::Up)
                )
            }
            (Some(l), None) => format!("≥ {}", significant(l, 3, Rounding::Down)),
            (None, Some(u)) => format!("≤ {}", significant(u, 3, Rounding::Up)),
            (None, None) => "–".into(),
        };
        let cells = vec![
            case.name.clone(),
            "joint at collapse, load factor".into(),
            "1".into(),
            bounds,
            used.unwrap_or_else(|| "–".into()),
            "limit analysis".into(),
            demand.by_analysis.words().into(),
        ];
        let governs_by = case
            .utilisation
            .map(|u| u[1])
            .or((demand.by_analysis == Verdict::Undecided).then_some(1.0));
        rows.push(Row { cells, governs_by });
    }
    let loaded: Vec<&Check> =
        result.checks.iter().filter(|c| c.case.is_some() && c.demand.is_some()).collect();
    if rows.is_empty() && loaded.is_empty() {
        return;
    }
    rows.extend(worst_distance(&result.checks).map(row));
    // checks that decide without a load; the distances have their own row
    let open =
        |c: &&Check| matches!(c.status, Status::Failed | Status::Undecided) && c.case.is_none();
    rows.extend(result.checks.iter().filter(open).filter(|c| c.unit != Unit::Length).map(row));
    rows.extend(loaded.into_iter().map(row));
    let most = rows.iter().filter_map(|r| r.governs_by).fold(f64::NEG_INFINITY, f64::max);
    let bold = |r: Row| match r.governs_by {
        Some(u) if u >= most => r.cells.into_iter().map(|c| format!("**{c}**")).collect(),
        _ => r.cells,
    };
    paragraph(page, "Every check with a demand; the governing one is bold:");
    let columns = strings(["case", "check", "Ed", "Rd", "utilisation", "clause", "status"]);
    table(page, &Table { columns, rows: rows.into_iter().map(bold).collect() });
}

/// The minimum distance of Table 3.3 with the largest utilisation.
fn worst_distance(checks: &[Check]) -> Option<&Check> {
    let used = |c: &Check| c.utilisation.unwrap_or(f64::INFINITY);
    checks
        .iter()
        .filter(|c| c.clause.contains("Table 3.3") && !c.title.contains("exposed"))
        .reduce(|a, b| if used(b) > used(a) { b } else { a })
}

fn row(c: &Check) -> Row {
    let show = |v: Option<f64>| v.map_or("–".into(), |v| c.unit.show(v));
    let decides = matches!(c.status, Status::Ok | Status::Failed | Status::Undecided)
        && !matches!(c.topic, Topic::Stiffness | Topic::Ductility);
    let status = match (c.status, c.utilisation) {
        (Status::Failed, _) => "FAILED",
        (Status::Undecided, _) => "UNDECIDED",
        (Status::Ok, _) => "OK",
        // a limit analysis decides the case
        (Status::Warning, _) => "exceeded, information",
        (Status::Information, Some(_)) => "OK, information",
        (Status::Information, None) => "information",
    };
    let cells = vec![
        c.case.clone().unwrap_or_else(|| "all".into()),
        format!("{}, {}", c.title, c.subject),
        show(c.demand),
        show(c.resistance),
        c.utilisation.map_or_else(|| "–".into(), number),
        c.clause.clone(),
        status.into(),
    ];
    // a minimum distance or throat decides, but does not measure strength
    let strength = decides && (c.unit != Unit::Length || c.status == Status::Failed);
    Row { cells, governs_by: strength.then_some(c.utilisation.unwrap_or(f64::INFINITY)) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::checks::{Unit, Worked};

    /// The largest utilisation of a deciding check is bold. That of the component method is never
    /// bold, however large it is.
    #[test]
    fn what_governs_is_bold_and_information_never() {
        let check = |topic, value: f64, otherwise| {
            Worked::new("6.2", "share", value, Unit::Number, "u")
                .utilised(topic, "row", otherwise)
                .of_case("ULS1")
        };
        let mut result = ResultFile::new("", 1, Verdict::NotOk);
        result.checks = vec![
            check(Topic::Bolts, 0.7, Status::Failed),
            check(Topic::Bolts, 0.9, Status::Failed),
            check(Topic::ComponentMethod, 1.3, Status::Warning),
        ];
        let mut page = String::new();
        table_of_checks(&mut page, &result);
        let line =
            |number: &str| page.lines().find(|l| l.contains(number)).unwrap_or_default().to_owned();
        assert!(line("0.9").contains("**0.9**") && !line("0.7").contains("**"), "{page}");
        assert!(
            line("1.3").contains("exceeded, information") && !line("1.3").contains("**"),
            "{page}"
        );
        result.checks.push(check(Topic::Welds, 1.01, Status::Failed));
        let mut page = String::new();
        table_of_checks(&mut page, &result);
        assert!(page.contains("**FAILED**") && !page.contains("**0.9**"), "{page}");
        // a throat below its minimum governs; a throat above it does not, however close it is
        result.checks.pop();
        let throat = |a: f64, case: &str| {
            let what = ((Topic::Welds, "beam web"), ("4.5.2", "least throat"));
            Check::at_least(what.0, what.1, "a", (3.0, "3 mm"), a, Status::Failed).of_case(case)
        };
        result.checks.push(throat(3.1, "ULS1"));
        let mut page = String::new();
        table_of_checks(&mut page, &result);
        let line =
            |words: &str| page.lines().find(|l| l.contains(words)).unwrap_or_default().to_owned();
        assert!(
            line("least throat").contains("0.9677") && !line("least throat").contains("**"),
            "{page}"
        );
        assert!(page.contains("**0.9**"), "{page}");
        result.checks.push(throat(2.9, "ULS2"));
        let mut page = String::new();
        table_of_checks(&mut page, &result);
        assert!(page.contains("**ULS2**") && page.contains("**FAILED**"), "{page}");
        // information that is satisfied is reported with the same word as other checks
        let held = check(Topic::ComponentMethod, 0.5, Status::Warning);
        result.checks.push(Check { status: Status::Information, ..held });
        let mut page = String::new();
        table_of_checks(&mut page, &result);
        assert!(page.contains("OK, information") && !page.contains("holds"), "{page}");
        // without a load there is no demand
        result.checks.iter_mut().for_each(|c| c.case = None);
        let mut page = String::new();
        table_of_checks(&mut page, &result);
        assert!(page.is_empty(), "{page}");
    }
}
