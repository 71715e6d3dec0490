//! Forces of the bolts and between the parts.

use crate::document::Doc;
use crate::document::table::{Table, cells};
use crate::figures::{Rounding, significant};
use crate::markdown::words::case_title;
use crate::result::forces::BoltForce;
use crate::result::result_file::{CaseResult, ResultFile};
use bracket_base::say;
use bracket_engine::model::AnalysisKind;

/// Headings of the coordinates of bolts.
const PLACE: [&str; 3] = ["x [mm]", "y [mm]", "z [mm]"];

/// The axes that tell bolts apart: those across the axis that all of them have, else all.
fn across(bolts: &[BoltForce]) -> Vec<usize> {
    let axes = || bolts.iter().filter_map(|b| b.place.as_ref()).map(|p| p.axis);
    let along = |k: &usize| axes().all(|a| a[*k].abs() > 0.999);
    match (0..3).find(along) {
        Some(k) => (0..3).filter(|i| *i != k).collect(),
        None => vec![0, 1, 2],
    }
}

/// Tables of bolts and of contacts.
pub(crate) fn tables(doc: &mut Doc, case: &CaseResult, result: &ResultFile) {
    let Some(s) = case.static_forces.as_ref().filter(|s| !s.bolts.is_empty()) else { return };
    let kn = |f: f64| significant(1e-3 * f, 3, Rounding::Nearest);
    let what = match case.analysis {
        AnalysisKind::Limit => "one of the distributions that plasticity allows",
        _ => "estimates, not bounds",
    };
    let copies = if result.symmetry > 1 { "; the others are their mirror images" } else { "" };
    doc.paragraph(say!(
        "{}: forces of the bolts at load factor {}, from the stress of the lower bound ({}), \
         prying included{}:",
        case_title(case, result),
        significant(s.load_factor, 4, Rounding::Down),
        what,
        copies
    ));
    let at = |b: &BoltForce, axis: usize| {
        b.place.as_ref().map_or_else(String::new, |p| format!("{:.1}", p.position[axis]))
    };
    let across = across(&s.bolts);
    let row = |b: &BoltForce| {
        let mut row = cells![b.bolt.clone()];
        row.extend(across.iter().map(|k| at(b, *k).into()));
        row.extend(cells![kn(b.tension), kn(b.shear)]);
        row
    };
    let rows = s.bolts.iter().map(row).collect();
    let mut columns = Table::columns(["bolt"]);
    columns.extend(across.iter().flat_map(|k| Table::columns([PLACE[*k]])));
    columns.extend(Table::columns(["tension [kN]", "shear [kN]"]));
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
