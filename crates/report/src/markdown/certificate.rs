//! The section on the certificate: every residual with its tolerance.

use crate::document::Doc;
use crate::document::table::{Table, cells, dash};
use crate::figures::residual;
use crate::markdown::report_data::ReportData;
use crate::markdown::words::case_title;
use crate::result::result_file::RESIDUAL_TOLERANCE;

pub(crate) fn certificates(doc: &mut Doc, data: &ReportData) {
    doc.paragraph(
        "Residuals of the two fields, recomputed from the fields themselves by code that shares \
         nothing with the solver; all dimensionless.",
    );
    let mut rows = Vec::new();
    for case in &data.result.cases {
        let title = case_title(case, &data.result);
        let Some(certificate) = case.certificate else {
            rows.push(cells![title.clone(), dash(), dash(), dash(), dash(), "no certificate",]);
            continue;
        };
        for (name, definition, value) in certificate.residuals() {
            if let Some(value) = value {
                let pass = if value <= RESIDUAL_TOLERANCE { "pass" } else { "FAIL" };
                let tolerance = format!("{RESIDUAL_TOLERANCE:.0e}");
                rows.push(cells![
                    title.clone(),
                    name,
                    definition,
                    residual(value),
                    tolerance,
                    pass,
                ]);
            }
        }
        let (value, pass) =
            if certificate.strict { ("yes", "bounds") } else { ("no", "estimates only") };
        rows.push(cells![title.clone(), "strict", "all of the above", value, dash(), pass,]);
    }
    let columns = Table::columns(["case", "residual", "definition", "value", "tolerance", ""]);
    doc.table(&Table { columns, rows });
}
