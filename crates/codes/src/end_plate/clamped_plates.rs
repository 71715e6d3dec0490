//! The plates that the bolts clamp, and the length of bolt that they need.

use crate::ductility::Clamped;
use crate::eurocode::bearing::{Along, Bearing, Hole};
use crate::eurocode::bolt_length::{self, least_length};
use crate::subject::Part;
use crate::worked::Worked;
use bracket_joint::assembly::EndPlate;
use bracket_joint::catalog::BoltSize;

/// Washers of a bolt: one under the head and one under the nut.
pub(super) const WASHERS: u32 = 2;

/// A plate on which the bolts bear. Lengths in mm.
#[derive(Clone, Copy, Debug)]
pub(super) struct ClampedPlate {
    /// End plate or column flange.
    pub part: Part,
    pub thickness: f64,
    /// Yield strength \[MPa\].
    pub fy: f64,
    /// Ultimate strength \[MPa\].
    pub fu: f64,
    pub width: f64,
}

impl ClampedPlate {
    /// Bearing resistance at a bolt \[N\]; `across` the force: the distance to the edge e2 and the
    /// pitch p2 \[mm\].
    ///
    /// # Source
    /// EN 1993-1-8:2005 Table 3.4.
    pub fn bearing(&self, e: &EndPlate, along: Along, [e2, p2]: [f64; 2], hole: Hole) -> Worked {
        let place = Bearing {
            along,
            e2,
            p2,
            hole,
            d: e.bolt.d,
            d0: e.hole,
            thickness: self.thickness,
            fu: self.fu,
            fub: e.grade.fub,
        };
        place.resistance(e.factors.gamma_m2)
    }
}

/// The end plate, and the column flange where there is a column. The other plate of a splice is the
/// same as the first.
pub(super) fn clamped_plates(e: &EndPlate) -> Vec<ClampedPlate> {
    let plate = ClampedPlate {
        part: Part::EndPlate,
        thickness: e.thickness,
        fy: e.plate_steel.fy.mpa(),
        fu: e.plate_steel.fu.mpa(),
        width: e.width,
    };
    let flange = e.column.as_ref().map(|c| ClampedPlate {
        part: Part::ColumnFlange,
        thickness: c.section.tf,
        fy: c.steel.fy.mpa(),
        fu: c.steel.fu.mpa(),
        width: c.section.b,
    });
    [plate].into_iter().chain(flange).collect()
}

/// These plates with their bolts, as the rules of rotation capacity see them.
pub(super) fn clamped(e: &EndPlate) -> impl Iterator<Item = (Part, Clamped)> {
    let (d, fub) = (e.bolt.d, e.grade.fub);
    let of = move |p: ClampedPlate| (p.part, Clamped { d, fub, thickness: p.thickness, fy: p.fy });
    clamped_plates(e).into_iter().map(of)
}

/// Thickness of the part that the end plate is bolted to \[mm\].
pub(super) fn other_thickness(e: &EndPlate) -> f64 {
    e.column.as_ref().map_or(e.thickness, |c| c.section.tf)
}

/// Nominal length of a bolt \[mm\] for a grip: the shortest stocked length that suffices; `None`
/// beyond the longest.
pub(super) fn length_for(bolt: &BoltSize, grip: f64) -> Option<f64> {
    bolt_length::stocked_length(least_length(bolt, grip, WASHERS).value)
}

/// Nominal length of the bolts \[mm\]: the shortest stocked length that suffices; `None` beyond the
/// longest.
pub fn stocked_length(e: &EndPlate) -> Option<f64> {
    length_for(&e.bolt, e.grip)
}
