//! Classification of joints by stiffness and by strength: EN 1993-1-8:2005 5.2.

use crate::check::{CheckId, within};
use crate::formula::Traced;
use crate::subject::Frame;
use crate::unit::Unit;
use crate::worked::Worked;
use serde::{Deserialize, Serialize};

/// Class of a joint by stiffness.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum StiffnessClass {
    /// Zone 1.
    Rigid,
    /// Zone 2.
    SemiRigid,
    /// Zone 3.
    NominallyPinned,
}

/// Limits of the classes by stiffness for one beam \[N mm/rad\].
#[derive(Clone, Debug, PartialEq)]
pub struct StiffnessLimits {
    /// Least stiffness of a rigid joint.
    pub rigid: Worked,
    /// Greatest stiffness of a nominally pinned joint.
    pub pinned: Worked,
}

/// Limits of the classes by stiffness; `length` of the beam between the centres of columns \[mm\],
/// `inertia` I_b \[mm⁴\].
///
/// Rigid: `S_j,ini ≥ k_b E I_b/L_b`; nominally pinned: `S_j,ini ≤ 0.5 E I_b/L_b`. An unbraced frame
/// with K_b/K_c < 0.1 has no rigid joints: `stiff_columns`.
///
/// # Source
/// EN 1993-1-8:2005 5.2.2.5(1), figure 5.4.
pub fn stiffness_limits(
    frame: Frame,
    stiff_columns: bool,
    young: f64,
    inertia: f64,
    length: f64,
) -> StiffnessLimits {
    const CLAUSE: &str = "EN 1993-1-8:2005 5.2.2.5(1)";
    let unit =
        Traced::stress("E", young) * Traced::number("I_b", inertia) / Traced::length("L_b", length);
    let never = frame == Frame::Unbraced && stiff_columns;
    let factor = if never { f64::INFINITY } else { frame.factor() };
    let rigid = Traced::number("k_b", factor) * unit.clone();
    let pinned = Traced::from(0.5) * unit;
    let limit = |id, of| Worked::of(CLAUSE, id, "", of, Unit::Rotational);
    StiffnessLimits {
        rigid: limit(CheckId::RigidLimit, rigid),
        pinned: limit(CheckId::PinnedLimit, pinned),
    }
}

impl StiffnessClass {
    /// The class as a report prints it.
    pub fn words(self) -> &'static str {
        match self {
            StiffnessClass::Rigid => "rigid",
            StiffnessClass::SemiRigid => "semi-rigid",
            StiffnessClass::NominallyPinned => "nominally pinned",
        }
    }
}

impl StiffnessLimits {
    /// The class of an initial stiffness \[N mm/rad\].
    pub fn class(&self, initial: f64) -> StiffnessClass {
        if within(self.rigid.value, initial) {
            StiffnessClass::Rigid
        } else if within(initial, self.pinned.value) {
            StiffnessClass::NominallyPinned
        } else {
            StiffnessClass::SemiRigid
        }
    }
}

/// Class of a joint by strength.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum StrengthClass {
    /// As strong as the members it joins.
    FullStrength,
    /// Between.
    PartialStrength,
    /// At most a quarter of full strength.
    NominallyPinned,
}

impl StrengthClass {
    /// The class as a report prints it.
    pub fn words(self) -> &'static str {
        match self {
            StrengthClass::FullStrength => "full strength",
            StrengthClass::PartialStrength => "partial strength",
            StrengthClass::NominallyPinned => "nominally pinned",
        }
    }
}

/// Least K_b/K_c of a storey of an unbraced frame whose joints can be rigid, 5.2.2.5(1).
pub const STIFF_COLUMNS: f64 = 0.1;

/// Class by strength; moments \[N mm\] of the joint, of the beam and of the column, `storeys` how
/// many columns meet at the joint (1 at the top, 2 within the height).
///
/// Full strength: M_j,Rd ≥ min(M_b,pl,Rd, storeys · M_c,pl,Rd); nominally pinned: at most 0.25 of
/// that.
///
/// # Source
/// EN 1993-1-8:2005 5.2.3.2, 5.2.3.3, figure 5.5.
pub fn strength_class(joint: f64, beam: f64, column: f64, storeys: u32) -> StrengthClass {
    let full = beam.min(f64::from(storeys) * column);
    if within(full, joint) {
        StrengthClass::FullStrength
    } else if within(joint, 0.25 * full) {
        StrengthClass::NominallyPinned
    } else {
        StrengthClass::PartialStrength
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// 5.2.2.5: braced frames need 8 E I/L, others 25 E I/L.
    #[test]
    fn clause_5_2_2_5_classes_by_stiffness() {
        let of =
            |frame, s: f64| stiffness_limits(frame, false, 210_000.0, 1e8, 7000.0).class(s * 3e9);
        for (frame, s, class) in [
            (Frame::Braced, 8.0, StiffnessClass::Rigid),
            (Frame::Braced, 7.9, StiffnessClass::SemiRigid),
            (Frame::Unbraced, 8.0, StiffnessClass::SemiRigid),
            (Frame::Unbraced, 25.0, StiffnessClass::Rigid),
            (Frame::Unbraced, 0.51, StiffnessClass::SemiRigid),
            (Frame::Braced, 0.5, StiffnessClass::NominallyPinned),
        ] {
            assert_eq!(of(frame, s), class, "{frame:?} {s}");
        }
        // columns much softer than the beams: no joint of an unbraced frame is rigid
        let soft = stiffness_limits(Frame::Unbraced, true, 210_000.0, 1e8, 7000.0);
        assert_eq!(soft.class(1e30), StiffnessClass::SemiRigid);
    }

    #[test]
    fn clause_5_2_3_classes_by_strength() {
        assert_eq!(strength_class(100.0, 100.0, 80.0, 2), StrengthClass::FullStrength);
        assert_eq!(strength_class(80.0, 100.0, 80.0, 1), StrengthClass::FullStrength);
        assert_eq!(strength_class(80.0, 100.0, 80.0, 2), StrengthClass::PartialStrength);
        assert_eq!(strength_class(25.0, 100.0, 80.0, 2), StrengthClass::NominallyPinned);
    }
}
