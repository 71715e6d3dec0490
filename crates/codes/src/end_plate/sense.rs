//! Sense of bending of a joint.

use super::transformation::beta;
use crate::component_method::joint::EndPlateJoint;
use bracket_joint::assembly::{EndPlate, Way};

/// Side of the beam that a moment puts in tension.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Sense {
    /// Tension at the top.
    Top,
    /// Tension at the bottom.
    Bottom,
}

impl Sense {
    /// The sense as a report prints it.
    pub fn words(self) -> &'static str {
        match self {
            Sense::Top => "tension at the top",
            Sense::Bottom => "tension at the bottom",
        }
    }

    /// The joint turned so that its tension is at the top.
    pub fn of(self, joint: &EndPlateJoint) -> EndPlateJoint {
        match self {
            Sense::Top => joint.clone(),
            Sense::Bottom => joint.mirrored(),
        }
    }

    /// Flange of the beam in tension.
    pub fn pulled(self) -> Way {
        if self == Sense::Top { Way::Up } else { Way::Down }
    }

    /// Flange of the beam in compression.
    pub fn compressed(self) -> Way {
        if self == Sense::Top { Way::Down } else { Way::Up }
    }

    /// Sense of a moment My of a member end; positive: tension at the top.
    pub fn of_moment(my: f64) -> Self {
        if my < 0.0 { Sense::Bottom } else { Sense::Top }
    }

    /// Converts z of the turned joint to the axes of the spec, and back.
    pub fn z(self, z: f64) -> f64 {
        if self == Sense::Bottom { -z } else { z }
    }
}

/// Senses of bending of the load cases with their β.
pub(super) fn bent(e: &EndPlate) -> Vec<(Sense, f64)> {
    let mut out: Vec<(Sense, f64)> = Vec::new();
    for a in &e.actions {
        let entry = (Sense::of_moment(a.at(1.0)[1][1]), beta(e, a));
        if !out.contains(&entry) {
            out.push(entry);
        }
    }
    out
}

/// Senses of bending with their β: those of the load cases, and the template's β for a sense that
/// no load case has.
pub(super) fn senses(e: &EndPlate) -> Vec<(Sense, f64)> {
    let mut out = bent(e);
    for sense in [Sense::Top, Sense::Bottom] {
        if out.iter().all(|o| o.0 != sense) {
            out.push((sense, e.column.as_ref().map_or(0.0, |c| c.beta)));
        }
    }
    out.sort_by(|a, b| {
        (a.0 == Sense::Bottom).cmp(&(b.0 == Sense::Bottom)).then(a.1.total_cmp(&b.1))
    });
    out
}
