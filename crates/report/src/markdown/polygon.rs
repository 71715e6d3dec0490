//! The section on the capacity under two actions together.

use crate::document::Doc;
use crate::document::table::{Table, cells};
use crate::figures::{Rounding, significant};
use crate::result::polygon::Axis;
use crate::result::result_file::ResultFile;
use bracket_base::say;

/// The section of the report; empty without a polygon.
pub(crate) fn section(doc: &mut Doc, result: &ResultFile) {
    let Some(polygon) = &result.polygon else { return };
    let [first, second] = &polygon.axes;
    doc.heading(say!("Capacity in {} and {}", &first.action, &second.action));
    let open = match polygon.outer_bounded {
        true => "",
        false => " Some sides have no such bound: the outer hull is open.",
    };
    doc.paragraph(say!(
        "{} and {} acting together on {} at {}. The joint carries every combination inside the \
         hull of the inner points: if it carries two loads, it carries every weighted mean of \
         them. It carries no combination outside the outer hull: the mechanism of each direction \
         bounds a half plane, not only its own load.{}",
        &first.action,
        &second.action,
        &polygon.end,
        &polygon.at,
        open
    ));
    let shown = |axis: &Axis, factor: Option<f64>, part: f64, rounding: Rounding| {
        let size = |f: f64| significant(f * part.abs() * axis.unit.shown().0, 4, rounding);
        let sign = if part < 0.0 { "−" } else { "" };
        factor.map_or("–".into(), |f| {
            if part == 0.0 { "0".into() } else { format!("{sign}{}", size(f)) }
        })
    };
    let rows = polygon.points.iter().map(|p| {
        let at = |bound, rounding| {
            [0, 1].map(|k| shown(&polygon.axes[k], bound, p.direction[k], rounding))
        };
        let ([a, b], [c, d]) = (
            at(p.lower.map(f64::next_down), Rounding::Down),
            at(p.upper.map(f64::next_up), Rounding::Up),
        );
        cells![p.case.clone(), a, b, c, d]
    });
    let name = |axis: &Axis, what: &'static str| {
        say!("{} {} [{}]", &axis.action, what, axis.unit.shown().1.to_owned())
    };
    let mut columns = Table::columns(["direction"]);
    for what in ["at least", "at most"] {
        columns.extend(polygon.axes.iter().map(|a| name(a, what)));
    }
    doc.table(&Table { columns, rows: rows.collect() });
}
