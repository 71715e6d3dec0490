//! The list of bolts with their lengths, plates and stiffeners, with masses.

use crate::checks::check::number as n;
use crate::checks::end_plate::{PartItem, PartSize};
use crate::report::markdown::markup::strings;
use crate::report::markdown::report_data::Table;

/// The parts of a joint as a table.
pub fn schedule(items: &[PartItem]) -> Table {
    let kilograms = |mass: Option<f64>| mass.map_or("–".into(), |m| format!("{m:.2}"));
    let row = |i: &PartItem| {
        let size = match &i.size {
            PartSize::Bolt { size, length, grip } => {
                let long = length
                    .map_or_else(|| "longer than stocked".into(), |l| format!("{size} × {}", n(l)));
                format!("{long}, grip {} mm, 2 washers", n(*grip))
            }
            PartSize::Plate(sizes) => sizes.map(n).join(" × "),
        };
        let all = i.each.map(|m| m * i.count as f64);
        let count = i.count.to_string();
        vec![i.part.into(), count, size, i.steel.clone(), kilograms(i.each), kilograms(all)]
    };
    Table {
        columns: strings(["part", "number", "size [mm]", "steel", "each [kg]", "all [kg]"]),
        rows: items.iter().map(row).collect(),
    }
}
