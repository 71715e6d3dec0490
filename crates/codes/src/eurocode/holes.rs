//! Kind of the holes by their clearance, and what it does to slip and to the shear of small bolts.

use super::slip::SlipHole;
use crate::check::within;
use bracket_joint::catalog::{BoltGrade, BoltSize};

/// Clause of the clearances.
pub const CLEARANCES: &str = "EN 1090-2:2008 Table 11";
/// Largest bolt that 3.6.1(5) allows in holes with 2 mm clearance \[mm\].
const SMALL_BOLT: f64 = 14.0;
/// That clearance \[mm\].
const SMALL_CLEARANCE: f64 = 2.0;
/// Factor on F_v,Rd of such bolts.
const SMALL_SHEAR: f64 = 0.85;
/// Grades without that factor.
const FULL_SHEAR: [&str; 2] = ["4.6", "5.6"];

/// Kind of a round hole by its nominal clearance.
///
/// # Source
/// EN 1090-2:2008 Table 11; EN 1993-1-8:2005 3.6.1(4) and (5).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Clearance {
    /// At most that of a normal hole.
    Normal,
    /// 2 mm of a bolt up to M14, whose normal clearance is 1 mm.
    Small,
    /// At most that of an oversize hole.
    Oversize,
    /// Beyond oversize: the code has no such hole.
    Beyond,
}

impl Clearance {
    /// Kind of a hole of a diameter \[mm\] for a bolt.
    pub fn of(bolt: &BoltSize, hole: f64) -> Self {
        if within(hole, bolt.hole_normal) {
            Clearance::Normal
        } else if within(bolt.d, SMALL_BOLT) && within(hole, bolt.d + SMALL_CLEARANCE) {
            Clearance::Small
        } else if within(hole, bolt.hole_oversize) {
            Clearance::Oversize
        } else {
            Clearance::Beyond
        }
    }

    /// Kind for slip. A clearance of 2 mm is that of an oversize hole for a small bolt.
    ///
    /// # Source
    /// EN 1993-1-8:2005 Table 3.6.
    pub fn slip(self) -> Option<SlipHole> {
        match self {
            Clearance::Normal => Some(SlipHole::Normal),
            Clearance::Small | Clearance::Oversize => Some(SlipHole::Oversize),
            Clearance::Beyond => None,
        }
    }
}

/// Factor on F_v,Rd of bolts up to M14 in holes wider than normal: 0.85, but 1 for grades 4.6 and
/// 5.6. 3.6.1(5) has it for 2 mm; a wider hole is not treated better.
///
/// # Source
/// EN 1993-1-8:2005 3.6.1(5).
pub fn shear_factor(bolt: &BoltSize, grade: &BoltGrade, hole: f64) -> f64 {
    let small = within(bolt.d, SMALL_BOLT) && Clearance::of(bolt, hole) != Clearance::Normal;
    if small && !FULL_SHEAR.contains(&grade.grade.as_str()) { SMALL_SHEAR } else { 1.0 }
}
