//! Markdown elements: headings, paragraphs, tables, and text that is safe inside them.

use crate::report::markdown::report_data::Table;

/// The text of a cell without a value.
pub(crate) fn dash() -> String {
    "–".into()
}

pub(crate) fn heading(page: &mut String, text: &str) {
    page.push_str(&format!("## {text}\n\n"));
}

pub(crate) fn paragraph(page: &mut String, text: &str) {
    page.push_str(text);
    page.push_str("\n\n");
}

/// Escapes a text so that it remains within its line or cell, and becomes no link, no picture and
/// no element of HTML.
pub(crate) fn inline(text: &str) -> String {
    let line = text.replace(['\n', '\r'], " ").replace('|', "\\|").replace('<', "&lt;");
    line.replace("](", "]\\(")
}

pub(crate) fn table(page: &mut String, table: &Table) {
    let row = |cells: &[String]| {
        format!("| {} |\n", cells.iter().map(|c| inline(c)).collect::<Vec<_>>().join(" | "))
    };
    page.push_str(&row(&table.columns));
    let number = |c: usize| {
        table.rows.iter().all(|r| {
            r.get(c).is_none_or(|t| {
                t.is_empty() || t.starts_with(|l: char| l.is_ascii_digit() || "-<–".contains(l))
            })
        })
    };
    let rule: Vec<&str> =
        (0..table.columns.len()).map(|c| if number(c) { "---:" } else { "---" }).collect();
    page.push_str(&format!("| {} |\n", rule.join(" | ")));
    for r in &table.rows {
        page.push_str(&row(r));
    }
    page.push('\n');
}

pub(crate) fn strings<const N: usize>(cells: [&str; N]) -> Vec<String> {
    cells.map(String::from).to_vec()
}
