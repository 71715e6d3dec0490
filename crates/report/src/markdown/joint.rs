//! The section on the joint: drawings and the lists of bolts, plates, stiffeners and welds.

use crate::markdown::markup::{heading, inline, paragraph, table};
use crate::markdown::report_data::ReportData;

/// Drawings, bolts, plates and welds.
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
    if !data.welds.rows.is_empty() {
        paragraph(page, "Welds, with the metal of fillets of equal legs:");
        table(page, &data.welds);
    }
    if !data.supports.rows.is_empty() {
        paragraph(page, "Supports of the model:");
        table(page, &data.supports);
    }
}
