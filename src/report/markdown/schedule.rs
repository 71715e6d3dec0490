//! The list of bolts with their lengths, plates and stiffeners, with masses.

use crate::assembly::EndPlate;
use crate::catalog::BoltSize;
use crate::checks::check::number as n;
use crate::report::markdown::markup::strings;
use crate::report::markdown::report_data::Table;
use std::f64::consts::PI;

/// Density of steel \[kg/mm³\], EN 1991-1-1 Table A.4 and EN 1993-1-1 3.2.6 as used in practice.
const DENSITY: f64 = 7.85e-6;

/// Mass of a bolt with nut and two washers \[kg\], from nominal sizes: the shank is a cylinder of
/// the nominal diameter, head and nut are hexagons.
pub fn bolt_mass(b: &BoltSize, length: f64) -> f64 {
    let circle = |d: f64| 0.25 * PI * d * d;
    let hexagon = |flats: f64| 0.5 * 3f64.sqrt() * flats * flats;
    let head = hexagon(b.head_width) * b.head_height;
    let nut = (hexagon(b.nut_width) - circle(b.d)) * b.nut_height;
    let washer = (circle(b.washer_outer) - circle(b.washer_inner)) * b.washer_thickness;
    DENSITY * (head + circle(b.d) * length + nut + 2.0 * washer)
}

/// Bolts, end plates, stiffeners and doubler. `plates` is the number of end plates of the joint,
/// `length` the nominal length of the bolts \[mm\], `grip` the clamped thickness \[mm\].
pub fn schedule(e: &EndPlate, plates: usize, length: Option<f64>, grip: f64) -> Table {
    let sets = if e.column.is_some() { plates } else { 1 };
    let mut rows = Vec::new();
    let mut item = |what: String, count: usize, size: String, steel: String, mass: Option<f64>| {
        let each = mass.map_or("–".into(), |m| format!("{m:.2}"));
        let all = mass.map_or("–".into(), |m| format!("{:.2}", m * count as f64));
        rows.push(vec![what, count.to_string(), size, steel, each, all]);
    };
    let long = length
        .map_or_else(|| "longer than stocked".into(), |l| format!("{} × {}", e.bolt.size, n(l)));
    let size = format!("{long}, grip {} mm, 2 washers", n(grip));
    item(
        "bolt".into(),
        e.bolt_count() * sets,
        size,
        e.grade.grade.clone(),
        length.map(|l| bolt_mass(&e.bolt, l)),
    );
    let plate =
        |sizes: [f64; 3]| (sizes.map(n).join(" × "), Some(DENSITY * sizes.iter().product::<f64>()));
    let (size, mass) = plate([e.thickness, e.width, e.top - e.bottom]);
    item("end plate".into(), plates, size, e.plate_steel.grade.clone(), mass);
    if let Some(c) = &e.column {
        let s = &c.section;
        if c.stiffener > 0.0 {
            let (size, mass) = plate([c.stiffener, 0.5 * (s.b - s.tw), s.h - 2.0 * s.tf]);
            item("column stiffener".into(), 4, size, c.steel.grade.clone(), mass);
        }
    }
    Table {
        columns: strings(["part", "number", "size [mm]", "steel", "each [kg]", "all [kg]"]),
        rows,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::catalog::Catalog;

    /// An M20 × 80 bolt set has a mass of about 0.36 kg in the lists of suppliers (bolt 0.26, nut
    /// 0.06, washers 0.03).
    #[test]
    fn a_bolt_set_weighs_what_lists_say() {
        let catalog = Catalog::builtin().expect("the shipped catalogue is sound");
        let mass = bolt_mass(catalog.bolt("M20").expect("size"), 80.0);
        assert!((mass - 0.36).abs() < 0.03, "{mass}");
    }
}
