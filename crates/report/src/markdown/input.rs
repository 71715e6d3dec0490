//! The sections on the input: the input as read, the values derived from it, and at the end the
//! file itself.

use crate::document::Doc;
use crate::document::table::Table;
use crate::markdown::report_data::ReportData;
use bracket_base::words::Text;

/// The input as it was read, resolved values, catalogue rows, notes.
pub(crate) fn sections(doc: &mut Doc, data: &ReportData) {
    doc.heading("Input");
    doc.paragraph(
        "The input as it was read: without comments, and with the defaults for what it leaves \
         out. The file itself is at the end of this report.",
    );
    doc.code(&data.input.read);
    values(doc, data);
}

/// The input file as given, at the end of the report.
pub(crate) fn file(doc: &mut Doc, data: &ReportData) {
    doc.heading("Input file as given");
    doc.code(&data.input.text);
}

/// Resolved values, catalogue rows, notes.
pub(crate) fn values(doc: &mut Doc, data: &ReportData) {
    if !data.input.resolved.is_empty() {
        doc.heading("Resolved values");
        let rows = data.input.resolved.iter().map(|v| {
            [Text::given(&v.name), v.value.clone(), v.unit.clone().into(), v.origin.clone()]
        });
        doc.table(&Table::new(["quantity", "value", "unit", "origin"], rows));
    }
    if !data.input.catalogue_rows.is_empty() {
        doc.heading("Catalogue rows");
        let rows = data.input.catalogue_rows.iter().map(|r| {
            let values: Vec<String> =
                r.values.iter().map(|(column, value)| format!("{column} {value}")).collect();
            [r.kind.clone(), Text::given(&r.name), values.join(", ").into(), r.source.clone()]
        });
        doc.table(&Table::new(["kind", "name", "values", "source"], rows));
    }
    if !data.notes.is_empty() {
        doc.heading("Notes");
        doc.list(data.notes.iter().cloned());
    }
}
