//! Rotation capacity: EN 1993-1-8:2005 6.4.2 and the rule of UK practice.

use crate::check::{Check, CheckId, Status, Topic};
use crate::eurocode::section::epsilon;
use crate::formula::{Number, Traced};
use crate::subject::{Part, Subject};

/// A bolt and the plate or flange that it clamps.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Clamped {
    /// Diameter of the bolt \[mm\].
    pub d: f64,
    /// Ultimate strength of the bolt \[MPa\].
    pub fub: f64,
    /// Thickness of the plate or flange \[mm\].
    pub thickness: f64,
    /// Its nominal yield strength \[MPa\].
    pub fy: f64,
}

/// Whether a plate or flange whose bending governs gives enough rotation for plastic analysis; a
/// warning where it does not.
///
/// `t ≤ 0.36 d √(f_ub/f_y)`.
///
/// # Source
/// EN 1993-1-8:2005 6.4.2(2), formula 6.32.
pub fn rotation_capacity(part: Part, c: &Clamped) -> Check {
    let limit = Traced::from(0.36) * Traced::length("d", c.d) * strengths(c);
    let what = ("EN 1993-1-8:2005 6.4.2(2)", CheckId::RotationCapacity);
    let of = (Topic::Ductility, part);
    Check::at_most(of, what, "t", limit, c.thickness, Status::Warning)
}

/// √(f_ub/f_y).
fn strengths(c: &Clamped) -> Traced {
    (Traced::stress("f_ub", c.fub) / Traced::stress("f_y", c.fy)).sqrt()
}

/// Whether the rows may reach their plastic forces side by side; a warning where they may not.
///
/// `t ≤ (d/1.9) √(f_ub/f_y)` for the end plate or the column flange.
///
/// # Source
/// UK National Annex to BS EN 1993-1-8, NA.2.7; SCI P398, 2.
pub fn plastic_distribution(part: Part, c: &Clamped) -> Check {
    let limit = Traced::length("d", c.d) / Traced::from(1.9) * strengths(c);
    let what = ("UK NA to BS EN 1993-1-8, NA.2.7", CheckId::PlasticRows);
    let of = (Topic::Ductility, part);
    Check::at_most(of, what, "t", limit, c.thickness, Status::Warning)
}

/// Whether a web panel that governs in shear gives enough rotation, `d_c/t_w ≤ 69 ε`; a warning
/// where it does not.
///
/// # Source
/// EN 1993-1-8:2005 6.4.2(1).
pub fn panel_in_shear(subject: Subject, clear_depth: f64, web: f64, fy: f64) -> Check {
    let what = ("EN 1993-1-8:2005 6.4.2(1)", CheckId::PanelSlenderness);
    let limit = Traced::from(69.0) * Traced::number("ε", epsilon(fy));
    let of = (Topic::Ductility, subject);
    Check::at_most(of, what, "d_c/t_w", limit, clear_depth / web, Status::Warning).of_numbers()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn clause_6_4_2_rotation_capacity() {
        // M20 8.8 on S235: 0.36 · 20 · √(800/235) = 13.28 mm; (20/1.9) √(800/235) = 19.42 mm
        let clamped = |thickness| Clamped { d: 20.0, fub: 800.0, thickness, fy: 235.0 };
        let status = |c: Check| c.status;
        assert_eq!(status(rotation_capacity(Part::EndPlate, &clamped(13.2))), Status::Ok);
        assert_eq!(status(rotation_capacity(Part::EndPlate, &clamped(13.3))), Status::Warning);
        assert_eq!(status(plastic_distribution(Part::EndPlate, &clamped(19.4))), Status::Ok);
        assert_eq!(status(plastic_distribution(Part::EndPlate, &clamped(19.5))), Status::Warning);
        assert_eq!(status(panel_in_shear(Part::Panel.into(), 690.0, 10.0, 235.0)), Status::Ok);
        assert_eq!(status(panel_in_shear(Part::Panel.into(), 691.0, 10.0, 235.0)), Status::Warning);
    }
}
