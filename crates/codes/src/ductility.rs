//! Rotation capacity: EN 1993-1-8:2005 6.4.2 and the rule of UK practice.

use crate::check::{Check, Status, Topic, Unit, number as n};
use crate::eurocode::section::epsilon;

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
pub fn rotation_capacity(subject: &str, c: &Clamped) -> Check {
    let limit = 0.36 * c.d * (c.fub / c.fy).sqrt();
    let rule = format!("0.36 d √(f_ub/f_y) = 0.36 · {} · √({}/{})", n(c.d), n(c.fub), n(c.fy));
    let title = ("EN 1993-1-8:2005 6.4.2(2)", "thickness for rotation capacity");
    Check::at_most(
        (Topic::Ductility, subject),
        title,
        "t",
        (limit, rule),
        c.thickness,
        Status::Warning,
    )
}

/// Whether the rows may reach their plastic forces side by side; a warning where they may not.
///
/// `t ≤ (d/1.9) √(f_ub/f_y)` for the end plate or the column flange.
///
/// # Source
/// UK National Annex to BS EN 1993-1-8, NA.2.7; SCI P398, 2.
pub fn plastic_distribution(subject: &str, c: &Clamped) -> Check {
    let limit = c.d / 1.9 * (c.fub / c.fy).sqrt();
    let rule = format!("(d/1.9) √(f_ub/f_y) = ({}/1.9) √({}/{})", n(c.d), n(c.fub), n(c.fy));
    let title = ("UK NA to BS EN 1993-1-8, NA.2.7", "thickness for plastic forces of the rows");
    Check::at_most(
        (Topic::Ductility, subject),
        title,
        "t",
        (limit, rule),
        c.thickness,
        Status::Warning,
    )
}

/// Whether a web panel that governs in shear gives enough rotation, `d_c/t_w ≤ 69 ε`; a warning
/// where it does not.
///
/// # Source
/// EN 1993-1-8:2005 6.4.2(1).
pub fn panel_in_shear(subject: &str, clear_depth: f64, web: f64, fy: f64) -> Check {
    let title = ("EN 1993-1-8:2005 6.4.2(1)", "slenderness of the web panel");
    let rule = (69.0 * epsilon(fy), format!("69 ε = 69 · {}", n(epsilon(fy))));
    let mut check = Check::at_most(
        (Topic::Ductility, subject),
        title,
        "d_c/t_w",
        rule,
        clear_depth / web,
        Status::Warning,
    );
    check.unit = Unit::Number;
    check.formula = check.formula.replace(" mm", "");
    check
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn clause_6_4_2_rotation_capacity() {
        // M20 8.8 on S235: 0.36 · 20 · √(800/235) = 13.28 mm; (20/1.9) √(800/235) = 19.42 mm
        let clamped = |thickness| Clamped { d: 20.0, fub: 800.0, thickness, fy: 235.0 };
        let status = |c: Check| c.status;
        assert_eq!(status(rotation_capacity("end plate", &clamped(13.2))), Status::Ok);
        assert_eq!(status(rotation_capacity("end plate", &clamped(13.3))), Status::Warning);
        assert_eq!(status(plastic_distribution("end plate", &clamped(19.4))), Status::Ok);
        assert_eq!(status(plastic_distribution("end plate", &clamped(19.5))), Status::Warning);
        assert_eq!(status(panel_in_shear("column", 690.0, 10.0, 235.0)), Status::Ok);
        assert_eq!(status(panel_in_shear("column", 691.0, 10.0, 235.0)), Status::Warning);
    }
}
