//! `report.md`: one page with the answer first and its justification below.

use crate::markdown::answer::answer;
use crate::markdown::assumptions::assumptions;
use crate::markdown::certificate::certificates;
use crate::markdown::collapse::mechanism;
use crate::markdown::history::history;
use crate::markdown::joint::joint;
use crate::markdown::markup::{heading, inline, paragraph, table};
use crate::markdown::report_data::ReportData;
use crate::markdown::title::title_block;
use crate::markdown::warnings::warnings;
use crate::markdown::yielding::yielding;
use crate::markdown::{
    component_method, demand, forces, hand_checks, input, method, polygon, stiffness, summary,
    verdict,
};
use crate::words::Words;
use bracket_base::diag::visible;

/// The text of `report.md` in the language of `words`. Equal data give equal texts.
pub fn report_markdown(data: &ReportData, words: &Words) -> String {
    let mut page = String::new();
    title_block(&mut page, data);
    heading(&mut page, "Answer");
    verdict::verdict(&mut page, &data.result);
    hand_checks::failed(&mut page, &data.result.checks);
    summary::table_of_checks(&mut page, &data.result);
    demand::demands(&mut page, &data.result, &data.input.demands);
    if !data.input.plane_actions.rows.is_empty() {
        paragraph(&mut page, &format!("{}:", inline(demand::ON_PLANES)));
        table(&mut page, &data.input.plane_actions);
    }
    for case in &data.result.cases {
        answer(&mut page, case, data);
        component_method::lines(&mut page, case);
        stiffness::lines(&mut page, case);
        forces::tables(&mut page, case, data.result.symmetry);
    }
    if data.result.cases.is_empty() {
        paragraph(&mut page, "By the code's checks alone: no analysis was run.");
    }
    polygon::section(&mut page, &data.result);
    for picture in &data.pictures {
        paragraph(&mut page, &format!("![{}]({})", inline(&picture.caption), picture.file));
    }
    for case in &data.result.cases {
        mechanism(&mut page, case);
        yielding(&mut page, case);
    }
    warnings(&mut page, data);
    joint(&mut page, data);
    input::sections(&mut page, data);
    hand_checks::checks(&mut page, &data.result.checks);
    method::section(&mut page, &data.result.component_method);
    if !data.result.cases.is_empty() {
        analyses(&mut page, data);
    }
    input::file(&mut page, data);
    visible(&words.markdown(&page))
}

/// The sections behind the numbers of the analyses.
fn analyses(page: &mut String, data: &ReportData) {
    heading(page, "Mesh and history");
    if !data.mesh_quality.rows.is_empty() {
        table(page, &data.mesh_quality);
    }
    for case in data.result.cases.iter().filter(|c| !c.history.is_empty()) {
        history(page, case, data.result.symmetry);
    }
    heading(page, "Certificate");
    certificates(page, data);
    heading(page, "Assumptions and limits");
    for sentence in assumptions(data) {
        page.push_str(&format!("- {}\n", inline(&sentence)));
    }
    page.push('\n');
}
