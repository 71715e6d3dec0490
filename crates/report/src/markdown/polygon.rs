//! The section on the capacity under two actions together.

use crate::figures::{Rounding, significant};
use crate::markdown::markup::{heading, inline, paragraph, strings, table};
use crate::markdown::report_data::Table;
use crate::result::polygon::Axis;
use crate::result::result_file::ResultFile;

/// The section of the report; empty without a polygon.
pub(crate) fn section(page: &mut String, result: &ResultFile) {
    let Some(polygon) = &result.polygon else { return };
    let [first, second] = &polygon.axes;
    heading(page, &format!("Capacity in {} and {}", first.action, second.action));
    paragraph(
        page,
        &format!(
            "{} and {} acting together on {} at {}. The joint carries every combination inside \
             the hull of the inner points: if it carries two loads, it carries every weighted \
             mean of them. It carries no combination outside the outer hull: the mechanism of \
             each direction bounds a half plane, not only its own load.{}",
            first.action,
            second.action,
            inline(&polygon.end),
            inline(&polygon.at),
            if polygon.outer_bounded {
                ""
            } else {
                " Some sides have no such bound: the outer hull is open."
            }
        ),
    );
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
        vec![p.case.clone(), a, b, c, d]
    });
    let name =
        |axis: &Axis, what: &str| format!("{} {what} [{}]", axis.action, axis.unit.shown().1);
    let mut columns = strings(["direction"]);
    for what in ["at least", "at most"] {
        columns.extend(polygon.axes.iter().map(|a| name(a, what)));
    }
    table(page, &Table { columns, rows: rows.collect() });
}
