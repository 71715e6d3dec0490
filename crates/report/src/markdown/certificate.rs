//! The section on the certificate: every residual with its tolerance.

use crate::figures::residual;
use crate::markdown::markup::{dash, paragraph, strings, table};
use crate::markdown::report_data::ReportData;
use crate::markdown::report_data::Table;
use crate::result::result_file::RESIDUAL_TOLERANCE;

pub(crate) fn certificates(page: &mut String, data: &ReportData) {
    paragraph(
        page,
        "Residuals of the two fields, recomputed from the fields themselves by code that shares \
         nothing with the solver; all dimensionless.",
    );
    let mut rows = Vec::new();
    for case in &data.result.cases {
        let Some(certificate) = case.certificate else {
            rows.push(vec![
                case.name.clone(),
                dash(),
                dash(),
                dash(),
                dash(),
                "no certificate".into(),
            ]);
            continue;
        };
        for (name, definition, value) in certificate.residuals() {
            if let Some(value) = value {
                let pass = if value <= RESIDUAL_TOLERANCE { "pass" } else { "FAIL" };
                let tolerance = format!("{RESIDUAL_TOLERANCE:.0e}");
                rows.push(vec![
                    case.name.clone(),
                    name.into(),
                    definition.into(),
                    residual(value),
                    tolerance,
                    pass.into(),
                ]);
            }
        }
        let (value, pass) =
            if certificate.strict { ("yes", "bounds") } else { ("no", "estimates only") };
        rows.push(vec![
            case.name.clone(),
            "strict".into(),
            "all of the above".into(),
            value.into(),
            dash(),
            pass.into(),
        ]);
    }
    let columns = strings(["case", "residual", "definition", "value", "tolerance", ""]);
    table(page, &Table { columns, rows });
}
