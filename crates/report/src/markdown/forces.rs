//! Forces of the bolts and between the parts.

use crate::document::Doc;
use crate::document::table::{Table, cells};
use crate::figures::{Rounding, significant};
use crate::result::forces::BoltForce;
use crate::result::result_file::CaseResult;
use bracket_base::say;
use bracket_engine::model::AnalysisKind;

/// Tables of bolts and of contacts.
pub(crate) fn tables(doc: &mut Doc, case: &CaseResult, symmetry: u32) {
    let Some(s) = case.static_forces.as_ref().filter(|s| !s.bolts.is_empty()) else { return };
    let kn = |f: f64| significant(1e-3 * f, 3, Rounding::Nearest);
    let what = match case.analysis {
        AnalysisKind::Limit => "one of the distributions that plasticity allows",
        _ => "estimates, not bounds",
    };
    let copies = if symmetry > 1 { "; the others are their mirror images" } else { "" };
    doc.paragraph(say!(
        "{}: forces of the bolts at load factor {}, from the stress of the lower bound ({}), \
         prying included{}:",
        &case.name,
        significant(s.load_factor, 4, Rounding::Down),
        what,
        copies
    ));
    let at = |b: &BoltForce, axis: usize| {
        b.place.as_ref().map_or_else(String::new, |p| format!("{:.1}", p.position[axis]))
    };
    let row =
        |b: &BoltForce| cells![b.bolt.clone(), at(b, 1), at(b, 2), kn(b.tension), kn(b.shear)];
    let rows = s.bolts.iter().map(row).collect();
    let columns = Table::columns(["bolt", "y [mm]", "z [mm]", "tension [kN]", "shear [kN]"]);
    doc.table(&Table { columns, rows });
    if s.contacts.is_empty() {
        return;
    }
    let rows = s.contacts.iter().map(|c| {
        let [a, b] = &c.between;
        let centre = c.centre.map(|x| format!("{x:.1}")).join(", ");
        cells![say!("{} on {}", a, b), kn(c.compression), centre]
    });
    let columns =
        Table::columns(["contact", "compression [kN]", "centre of pressure x, y, z [mm]"]);
    doc.table(&Table { columns, rows: rows.collect() });
}
