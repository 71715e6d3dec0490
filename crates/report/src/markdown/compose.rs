//! `report.md`: one page with the answer first and its justification below.

use crate::document::Doc;
use crate::document::markdown::markdown;
use crate::markdown::answer::answer;
use crate::markdown::assumptions::assumptions;
use crate::markdown::certificate::certificates;
use crate::markdown::collapse::mechanism;
use crate::markdown::history::history;
use crate::markdown::joint::joint;
use crate::markdown::report_data::ReportData;
use crate::markdown::title::title_block;
use crate::markdown::warnings::warnings;
use crate::markdown::yielding::yielding;
use crate::markdown::{
    component_method, demand, forces, hand_checks, input, load_cases, load_steps, method, polygon,
    route, stiffness, summary, verdict,
};
use crate::words::Words;
use bracket_base::diag::visible;
use bracket_base::say;

/// The text of `report.md` in the language of `words`. Equal data give equal texts.
pub fn report_markdown(data: &ReportData, words: &Words) -> String {
    let (doc, all) = (&mut Doc::new(words), data);
    let data = &*load_cases::condensed(all);
    title_block(doc, data);
    doc.heading("Answer");
    verdict::verdict(doc, &data.result);
    hand_checks::failed(doc, &all.result.checks);
    load_cases::section(doc, all);
    summary::table_of_checks(doc, &data.result);
    demand::demands(doc, &data.result, &data.input.demands);
    if !data.input.plane_actions.rows.is_empty() {
        doc.paragraph(say!("{}:", &data.input.plane_note));
        doc.table(&data.input.plane_actions);
    }
    for case in &data.result.cases {
        answer(doc, case, data);
        component_method::lines(doc, case);
        stiffness::lines(doc, case);
        forces::tables(doc, case, &data.result);
    }
    if data.result.cases.is_empty() {
        doc.paragraph("By the code's checks alone: no analysis was run.");
    }
    route::section(doc, &data.result);
    polygon::section(doc, &data.result);
    for picture in &data.pictures {
        doc.picture(picture);
    }
    for case in &data.result.cases {
        mechanism(doc, case);
        yielding(doc, case);
        load_steps::section(doc, case);
    }
    warnings(doc, data);
    joint(doc, data);
    input::sections(doc, data);
    hand_checks::checks(doc, &data.result.checks);
    method::section(doc, &data.result.component_method);
    if !data.result.cases.is_empty() {
        analyses(doc, data);
    }
    input::file(doc, data);
    visible(&markdown(&doc.blocks))
}

/// The sections behind the numbers of the analyses.
fn analyses(doc: &mut Doc, data: &ReportData) {
    doc.heading("Mesh and history");
    if !data.mesh_quality.rows.is_empty() {
        doc.table(&data.mesh_quality);
    }
    for case in data.result.cases.iter().filter(|c| !c.history.is_empty()) {
        history(doc, case, data.result.symmetry);
    }
    doc.heading("Certificate");
    certificates(doc, data);
    doc.heading("Assumptions and limits");
    doc.list(assumptions(data));
}
