//! The bolts and plates of a joint, with masses from nominal sizes.

use super::clamped_plates::length_for;
use bracket_base::units::limits;
use bracket_base::words::Text;
use bracket_joint::assembly::content::{Content, Piece};
use bracket_joint::catalog::BoltSize;
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
    /// An anchor with nut and washer; how it is anchored in the concrete is not known.
    Anchor {
        /// Size of the anchor: `M20`.
        size: String,
        /// Length below the plate to where the model holds it.
        below: f64,
        /// Thickness of the plate.
        grip: f64,
    },
    /// Thickness, width and length of a plate; its holes are not subtracted.
    Plate([f64; 3]),
}

/// Equal parts of a joint.
#[derive(Clone, Debug, PartialEq)]
pub struct PartItem {
    /// `bolt`, `end plate`, `column stiffener`, or the words of a template.
    pub part: Text,
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

/// Bolts and plates of a joint as its geometry has them: the bolts first, then the plates that the
/// hand checks know, then all others.
pub fn parts_list(joint: &Content) -> Vec<PartItem> {
    let mut out: Vec<PartItem> = Vec::new();
    for b in &joint.fasteners {
        let Some((size, grade)) = &joint.bolt else { continue };
        if let Some(below) = b.anchor {
            let of = PartSize::Anchor { size: size.size.clone(), below, grip: b.grip() };
            let (part, steel) = ("anchor".into(), grade.grade.clone());
            add(&mut out, PartItem { part, count: 1, size: of, steel, each: None });
            continue;
        }
        let length = length_for(size, b.grip());
        add(
            &mut out,
            PartItem {
                part: "bolt".into(),
                count: 1,
                size: PartSize::Bolt { size: size.size.clone(), length, grip: b.grip() },
                steel: grade.grade.clone(),
                each: length.map(|l| bolt_mass(size, l)),
            },
        );
    }
    let mut plates: Vec<&Piece> = joint.pieces.iter().collect();
    plates.sort_by_key(|p| p.kind);
    for p in plates {
        let sizes = p.sizes();
        add(
            &mut out,
            PartItem {
                part: p.label.clone(),
                count: 1,
                size: PartSize::Plate(sizes),
                steel: p.steel.clone(),
                each: Some(DENSITY * sizes.iter().product::<f64>()),
            },
        );
    }
    out
}

/// Adds a part to its like.
fn add(items: &mut Vec<PartItem>, item: PartItem) {
    let like =
        |i: &&mut PartItem| i.part == item.part && i.steel == item.steel && i.size.is(&item.size);
    match items.iter_mut().find(like) {
        Some(same) => same.count += 1,
        None => items.push(item),
    }
}

impl PartSize {
    /// True if both are the same but for rounding.
    fn is(&self, other: &Self) -> bool {
        match (self, other) {
            (PartSize::Plate(a), PartSize::Plate(b)) => {
                a.iter().zip(b).all(|(a, b)| limits::same(*a, *b))
            }
            (PartSize::Bolt { size, grip, .. }, PartSize::Bolt { size: other, grip: far, .. }) => {
                size == other && limits::same(*grip, *far)
            }
            (
                PartSize::Anchor { size, below, grip },
                PartSize::Anchor { size: other, below: far_below, grip: far },
            ) => {
                let same = limits::same(*grip, *far) && limits::same(*below, *far_below);
                size == other && same
            }
            _ => false,
        }
    }
}

/// Mass of all parts \[kg\]; `None` if that of one is unknown.
pub fn total_mass(items: &[PartItem]) -> Option<f64> {
    items.iter().map(|i| Some(i.count as f64 * i.each?)).sum()
}

#[cfg(test)]
mod tests {
    use super::*;
    use bracket_joint::catalog::Catalog;

    /// An M20 × 80 bolt set has a mass of about 0.36 kg in the lists of suppliers (bolt 0.26, nut
    /// 0.06, washers 0.03).
    #[test]
    fn a_bolt_set_weighs_what_lists_say() {
        let catalog = Catalog::builtin().expect("the shipped catalogue is sound");
        let mass = bolt_mass(catalog.bolt("M20").expect("size"), 80.0);
        assert!((mass - 0.36).abs() < 0.03, "{mass}");
    }
}
