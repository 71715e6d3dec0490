//! The section on the joint: drawings and the lists of bolts, plates, stiffeners and welds.

use crate::markdown::markup::{heading, inline, paragraph, table};
use crate::markdown::report_data::ReportData;

/// Drawings, bolts, plates and welds.
pub(crate) fn joint(page: &mut String, data: &ReportData) {
    if data.input.drawings.is_empty() && data.input.schedule.rows.is_empty() {
        return;
    }
    heading(page, "Joint");
    for drawing in &data.input.drawings {
        paragraph(page, &format!("![{}]({})", inline(&drawing.caption), drawing.file));
    }
    if !data.input.schedule.rows.is_empty() {
        paragraph(
            page,
            "Bolts, plates and stiffeners, with masses from nominal sizes at 7850 kg/m³; members \
             are not listed:",
        );
        table(page, &data.input.schedule);
    }
    if !data.input.welds.rows.is_empty() {
        paragraph(page, "Welds, with the metal of fillets of equal legs:");
        table(page, &data.input.welds);
    }
    if !data.input.supports.rows.is_empty() {
        paragraph(page, "Supports of the model:");
        table(page, &data.input.supports);
    }
}
