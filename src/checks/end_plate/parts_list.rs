//! What a bolted end plate is made of: bolts, plates and stiffeners, with masses from nominal
//! sizes.

use super::clamped_plates::{grip, stocked_length};
use crate::assembly::EndPlate;
use crate::catalog::BoltSize;
use std::f64::consts::PI;

/// Density of steel \[kg/mm³\], EN 1991-1-1 Table A.4 and EN 1993-1-1 3.2.6 as used in practice.
pub(super) const DENSITY: f64 = 7.85e-6;

/// The sizes of a part. Lengths in mm.
#[derive(Clone, Debug, PartialEq)]
pub enum PartSize {
    /// A bolt with nut and two washers.
    Bolt {
        /// Size of the bolt: `M20`.
        size: String,
        /// Nominal length; `None`: longer than stocked.
        length: Option<f64>,
        /// Clamped thickness.
        grip: f64,
    },
    /// Thickness, width and length of a plate; its holes are not subtracted.
    Plate([f64; 3]),
}

/// Equal parts of a joint.
#[derive(Clone, Debug, PartialEq)]
pub struct PartItem {
    /// `bolt`, `end plate` or `column stiffener`.
    pub part: &'static str,
    /// How many there are.
    pub count: usize,
    /// The sizes of each.
    pub size: PartSize,
    /// The steel or bolt grade.
    pub steel: String,
    /// Mass of each \[kg\]; `None` if its length is unknown.
    pub each: Option<f64>,
}

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

/// Bolts, end plates and column stiffeners of a joint with `plates` end plates.
pub fn parts_list(e: &EndPlate, plates: usize) -> Vec<PartItem> {
    // the bolts of a splice clamp both of its plates
    let sets = if e.column.is_some() { plates } else { 1 };
    let length = stocked_length(e);
    let plate = |part: &'static str, count: usize, sizes: [f64; 3], steel: &str| PartItem {
        part,
        count,
        size: PartSize::Plate(sizes),
        steel: steel.into(),
        each: Some(DENSITY * sizes.iter().product::<f64>()),
    };
    let bolts = PartItem {
        part: "bolt",
        count: e.bolt_count() * sets,
        size: PartSize::Bolt { size: e.bolt.size.clone(), length, grip: grip(e) },
        steel: e.grade.grade.clone(),
        each: length.map(|l| bolt_mass(&e.bolt, l)),
    };
    let sizes = [e.thickness, e.width, e.top - e.bottom];
    let mut out = vec![bolts, plate("end plate", plates, sizes, &e.plate_steel.grade)];
    if let Some(c) = e.column.as_ref().filter(|c| c.stiffener > 0.0) {
        let s = &c.section;
        let sizes = [c.stiffener, 0.5 * (s.b - s.tw), s.h - 2.0 * s.tf];
        out.push(plate("column stiffener", 4, sizes, &c.steel.grade));
    }
    out
}

/// Mass of all parts \[kg\]; `None` if that of one is unknown.
pub fn total_mass(items: &[PartItem]) -> Option<f64> {
    items.iter().map(|i| Some(i.count as f64 * i.each?)).sum()
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
