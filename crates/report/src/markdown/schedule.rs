//! The lists of bolts with their lengths, plates and stiffeners, and of welds, with masses.

use crate::markdown::markup::strings;
use crate::markdown::report_data::Table;
use bracket_codes::check::number as n;
use bracket_codes::end_plate::{PartItem, PartSize, WeldItem};

/// The parts of a joint as a table.
pub fn schedule(items: &[PartItem]) -> Table {
    let kilograms = |mass: Option<f64>| mass.map_or("–".into(), |m| format!("{m:.2}"));
    let row = |i: &PartItem| {
        let size = match &i.size {
            PartSize::Bolt { size, length, grip } => {
                let long = length
                    .map_or_else(|| "longer than stocked".into(), |l| format!("{size} × {}", n(l)));
                format!("{long}, grip {} mm, with nut and 2 washers", n(*grip))
            }
            PartSize::Plate(sizes) => sizes.map(n).join(" × "),
        };
        let all = i.each.map(|m| m * i.count as f64);
        let count = i.count.to_string();
        vec![i.part.clone(), count, size, i.steel.clone(), kilograms(i.each), kilograms(all)]
    };
    Table {
        columns: strings(["part", "number", "size [mm]", "steel", "each [kg]", "all [kg]"]),
        rows: items.iter().map(row).collect(),
    }
}

/// Whether one of the welds is a butt weld.
pub fn has_butt_welds(items: &[WeldItem]) -> bool {
    items.iter().any(|i| i.throat == 0.0)
}

/// The welds of a joint as a table.
pub fn welds(items: &[WeldItem]) -> Table {
    let row = |i: &WeldItem| {
        let kind = match i.throat {
            0.0 => "full penetration".into(),
            a => format!("fillet, a = {}", n(a)),
        };
        let length = i.length.map_or("as drawn".into(), n);
        let all = i.length.map_or("–".into(), |l| n(l * i.count as f64));
        let mass = i.mass().map_or("–".into(), |m| format!("{m:.2}"));
        vec![i.place.clone(), kind, i.count.to_string(), length, all, mass]
    };
    let columns =
        ["weld", "kind [mm]", "seams", "length of each [mm]", "all [mm]", "weld metal [kg]"];
    Table { columns: strings(columns), rows: items.iter().map(row).collect() }
}
