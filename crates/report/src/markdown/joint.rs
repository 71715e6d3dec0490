//! The section on the joint: drawings and the lists of bolts, plates, stiffeners and welds.

use crate::document::Doc;
use crate::markdown::report_data::ReportData;

/// Drawings, bolts, plates and welds.
pub(crate) fn joint(doc: &mut Doc, data: &ReportData) {
    if data.input.drawings.is_empty() && data.input.schedule.rows.is_empty() {
        return;
    }
    doc.heading("Joint");
    for drawing in &data.input.drawings {
        doc.picture(drawing);
    }
    if !data.input.schedule.rows.is_empty() {
        doc.paragraph(
            "Bolts, plates and stiffeners, with masses from nominal sizes at 7850 kg/m³; members \
             are not listed:",
        );
        doc.table(&data.input.schedule);
    }
    if !data.input.welds.rows.is_empty() {
        doc.paragraph("Welds, with the metal of fillets of equal legs:");
        doc.table(&data.input.welds);
    }
    if !data.input.supports.rows.is_empty() {
        doc.paragraph("Supports of the model:");
        doc.table(&data.input.supports);
    }
}
