//! The title block.

use crate::document::Doc;
use crate::document::table::{Table, cells};
use crate::markdown::report_data::ReportData;
use bracket_base::say;
use bracket_base::words::Text;

pub(crate) fn title_block(doc: &mut Doc, data: &ReportData) {
    let mut lines = data.input.project.iter();
    let title = lines.next().map_or(data.input.name.as_str(), |(_, title)| title.as_str());
    doc.title(Text::given(title));
    let mut rows: Vec<Vec<Text>> = lines.map(|(name, value)| line(name, value)).collect();
    let tool = &data.result.tool;
    rows.push(cells!["software", format!("{} {}", tool.name, tool.version)]);
    rows.push(cells!["input", data.input.name.clone()]);
    rows.push(cells!["input hash (BLAKE3)", say!("`{}`", &data.result.input_hash)]);
    doc.table(&Table { columns: Table::columns(["project", "value"]), rows });
}

/// A line of the title block; its own names are words of the program.
fn line(name: &str, value: &str) -> Vec<Text> {
    cells![project_word(name), value.to_owned()]
}

/// The name of a line of the title block: one of the program, or one of the user.
pub(crate) fn project_word(name: &str) -> Text {
    const OWN: [&str; 6] = ["title", "author", "checker", "revision", "date", "mesher"];
    match name {
        "number" => "project number".into(),
        other => Text::word_of(&OWN, other),
    }
}
