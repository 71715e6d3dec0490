//! The lists of bolts with their lengths, plates and stiffeners, and of welds, with masses.

use crate::document::table::{Table, dash};
use bracket_base::say;
use bracket_base::words::Text;
use bracket_codes::check::number as n;
use bracket_codes::end_plate::{PartItem, PartSize, WeldItem};

/// The parts of a joint as a table.
pub fn schedule(items: &[PartItem]) -> Table {
    let kilograms = |mass: Option<f64>| mass.map_or_else(dash, |m| format!("{m:.2}").into());
    let row = |i: &PartItem| {
        let size = match &i.size {
            PartSize::Bolt { size, length: Some(l), grip } => {
                say!("{} × {}, grip {} mm, with nut and 2 washers", size, n(*l), n(*grip))
            }
            PartSize::Bolt { length: None, grip, .. } => {
                say!("longer than stocked, grip {} mm, with nut and 2 washers", n(*grip))
            }
            PartSize::Anchor { size, below, grip } => say!(
                "{}, {} mm and its anchorage below the plate, grip {} mm, with nut and washer",
                size,
                n(*below),
                n(*grip)
            ),
            PartSize::Plate(sizes) => sizes.map(n).join(" × ").into(),
        };
        let all = i.each.map(|m| m * i.count as f64);
        let count = i.count.to_string().into();
        [i.part.clone(), count, size, i.steel.clone().into(), kilograms(i.each), kilograms(all)]
    };
    Table::new(
        ["part", "number", "size [mm]", "steel", "each [kg]", "all [kg]"],
        items.iter().map(row),
    )
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
            a => say!("fillet, a = {}", n(a)),
        };
        let length = i.length.map_or_else(|| Text::from("as drawn"), |l| n(l).into());
        let all = i.length.map_or_else(dash, |l| n(l * i.count as f64).into());
        let mass = i.mass().map_or_else(dash, |m| format!("{m:.2}").into());
        [i.place.clone(), kind, i.count.to_string().into(), length, all, mass]
    };
    let columns =
        ["weld", "kind [mm]", "seams", "length of each [mm]", "all [mm]", "weld metal [kg]"];
    Table::new(columns, items.iter().map(row))
}
