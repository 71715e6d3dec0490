//! The title block.

use crate::markdown::markup::{inline, strings, table};
use crate::markdown::report_data::ReportData;
use crate::markdown::report_data::Table;

pub(crate) fn title_block(page: &mut String, data: &ReportData) {
    let mut lines = data.input.project.iter();
    let title = lines.next().map_or(data.input.name.as_str(), |(_, title)| title.as_str());
    page.push_str(&format!("# {}\n\n", inline(title)));
    let mut rows: Vec<Vec<String>> =
        lines.map(|(name, value)| vec![name.clone(), value.clone()]).collect();
    let tool = &data.result.tool;
    rows.push(vec!["software".into(), format!("{} {}", tool.name, tool.version)]);
    rows.push(vec!["input".into(), data.input.name.clone()]);
    rows.push(vec!["input hash (BLAKE3)".into(), format!("`{}`", data.result.input_hash)]);
    table(page, &Table { columns: strings(["project", "value"]), rows });
}
