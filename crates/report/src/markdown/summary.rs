//! The summary of the checks as a table, with the governing one in bold.

use crate::document::Doc;
use crate::document::table::{Table, bold, cells};
use crate::result::result_file::ResultFile;
use crate::summary::{SummaryRow, summary_rows};

/// Writes check, Ed, Rd, utilisation, clause and status; empty without a demand.
pub(crate) fn table_of_checks(doc: &mut Doc, result: &ResultFile) {
    let rows = summary_rows(result);
    if rows.is_empty() {
        return;
    }
    let cells = |r: SummaryRow| {
        let cells =
            cells![r.case, r.check, r.demand, r.resistance, r.utilisation, r.clause, r.status];
        match r.governs {
            true => cells.into_iter().map(bold).collect(),
            false => cells,
        }
    };
    doc.paragraph(
        "Every check with a demand, the worst first; the governing one is bold. Distances and \
         throats that are kept measure no strength and come last:",
    );
    let columns = Table::columns([
        "case",
        "check",
        "required",
        "provided",
        "utilisation",
        "clause",
        "status",
    ]);
    let rows = rows.into_iter().map(cells).collect();
    doc.table(&Table { columns, rows });
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::english;
    use bracket_codes::formula::Traced;
    use bracket_codes::subject::Part;
    use bracket_codes::verdict::Verdict;
    use bracket_codes::{Check, CheckId, Status, Topic, Unit, Worked};

    /// The largest utilisation of a deciding check is bold. That of the component method is never
    /// bold, however large it is.
    #[test]
    fn what_governs_is_bold_and_information_never() {
        let check = |topic, value: f64, otherwise| {
            Worked::of("6.2", CheckId::MomentAndAxial, "u", Traced::from(value), Unit::Number)
                .utilised(topic, Part::BoltRows, otherwise)
                .of_case("ULS1")
        };
        // beside a limit analysis
        let exceeded = |check: Check, status| Check { status, ..check };
        let mut result = ResultFile::new("", 1, Verdict::NotOk);
        result.checks = vec![
            check(Topic::Bolts, 0.7, Status::Failed),
            check(Topic::Bolts, 0.9, Status::Failed),
            exceeded(check(Topic::ComponentMethod, 1.3, Status::Failed), Status::Warning),
        ];
        let page = english(|doc| table_of_checks(doc, &result));
        let line =
            |number: &str| page.lines().find(|l| l.contains(number)).unwrap_or_default().to_owned();
        assert!(line("0.90").contains("**0.90**") && !line("0.70").contains("**"), "{page}");
        assert!(
            line("1.30").contains("exceeded, information") && !line("1.30").contains("**"),
            "{page}"
        );
        result.checks.push(check(Topic::Welds, 1.01, Status::Failed));
        let page = english(|doc| table_of_checks(doc, &result));
        assert!(page.contains("**FAILED**") && !page.contains("**0.90**"), "{page}");
        // a throat below its minimum governs; a throat above it does not, however close it is
        result.checks.pop();
        let throat = |a: f64, case: &str| {
            let what = ((Topic::Welds, Part::BeamWeb), ("4.5.2", CheckId::LeastThroat));
            Check::at_least(what.0, what.1, "a", 3.0, a, Status::Failed).of_case(case)
        };
        result.checks.push(throat(3.1, "ULS1"));
        let page = english(|doc| table_of_checks(doc, &result));
        let line =
            |words: &str| page.lines().find(|l| l.contains(words)).unwrap_or_default().to_owned();
        assert!(
            line("least throat").contains("0.97") && !line("least throat").contains("**"),
            "{page}"
        );
        assert!(page.contains("**0.90**"), "{page}");
        result.checks.push(throat(2.9, "ULS2"));
        let page = english(|doc| table_of_checks(doc, &result));
        assert!(page.contains("**ULS2**") && page.contains("**FAILED**"), "{page}");
        // information that is satisfied is reported with the same word as other checks
        let held = check(Topic::ComponentMethod, 0.5, Status::Failed);
        result.checks.push(exceeded(held, Status::Information));
        let page = english(|doc| table_of_checks(doc, &result));
        assert!(page.contains("OK, information") && !page.contains("holds"), "{page}");
        // without a load there is no demand
        result.checks.iter_mut().for_each(|c| c.case = None);
        let page = english(|doc| table_of_checks(doc, &result));
        assert!(page.trim().is_empty(), "{page}");
    }
}
