//! The sections on the input: the input as read, the values derived from it, and at the end the
//! file itself.

use crate::markdown::markup::{heading, inline, paragraph, strings, table};
use crate::markdown::report_data::ReportData;
use crate::markdown::report_data::Table;

/// The input as it was read, resolved values, catalogue rows, notes.
pub(crate) fn sections(page: &mut String, data: &ReportData) {
    heading(page, "Input");
    paragraph(
        page,
        "The input as it was read: without comments, and with the defaults for what it leaves \
         out. The file itself is at the end of this report.",
    );
    yaml(page, &data.input.read);
    values(page, data);
}

/// The input file as given, at the end of the report.
pub(crate) fn file(page: &mut String, data: &ReportData) {
    heading(page, "Input file as given");
    yaml(page, &data.input.text);
    page.truncate(page.trim_end().len());
    page.push('\n');
}

fn yaml(page: &mut String, text: &str) {
    // the input cannot close a fence that is longer than any run of backticks in it
    let mut longest = 2;
    let mut run = 0;
    for c in text.chars() {
        run = if c == '`' { run + 1 } else { 0 };
        longest = longest.max(run);
    }
    let fence = "`".repeat(longest + 1);
    page.push_str(&format!("{fence}yaml\n{}\n{fence}\n\n", text.trim_end()));
}

/// Resolved values, catalogue rows, notes.
pub(crate) fn values(page: &mut String, data: &ReportData) {
    if !data.input.resolved.is_empty() {
        heading(page, "Resolved values");
        let rows = data
            .input
            .resolved
            .iter()
            .map(|v| vec![v.name.clone(), v.value.clone(), v.unit.clone(), v.origin.clone()]);
        table(
            page,
            &Table {
                columns: strings(["quantity", "value", "unit", "origin"]),
                rows: rows.collect(),
            },
        );
    }
    if !data.input.catalogue_rows.is_empty() {
        heading(page, "Catalogue rows");
        let rows = data.input.catalogue_rows.iter().map(|r| {
            let values: Vec<String> =
                r.values.iter().map(|(column, value)| format!("{column} {value}")).collect();
            vec![r.kind.clone(), r.name.clone(), values.join(", "), r.source.clone()]
        });
        table(
            page,
            &Table { columns: strings(["kind", "name", "values", "source"]), rows: rows.collect() },
        );
    }
    if !data.notes.is_empty() {
        heading(page, "Notes");
        for note in &data.notes {
            page.push_str(&format!("- {}\n", inline(note)));
        }
        page.push('\n');
    }
}
