//! The section on the joint: drawings and the list of bolts, plates and stiffeners.

use crate::report::markdown::markup::{heading, inline, paragraph, table};
use crate::report::markdown::report_data::ReportData;

/// Drawings, bolts and plates.
pub(crate) fn joint(page: &mut String, data: &ReportData) {
    if data.drawings.is_empty() && data.schedule.rows.is_empty() {
        return;
    }
    heading(page, "Joint");
    for drawing in &data.drawings {
        paragraph(page, &format!("![{}]({})", inline(&drawing.caption), drawing.file));
    }
    if !data.schedule.rows.is_empty() {
        paragraph(
            page,
            "Bolts, plates and stiffeners, with masses from nominal sizes at 7850 kg/m³; members \
             are not listed:",
        );
        table(page, &data.schedule);
    }
}
