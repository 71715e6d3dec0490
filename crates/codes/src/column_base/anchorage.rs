//! What the anchors need of the concrete: the matter of EN 1992-4.

use super::case_end::at;
use crate::check::{Check, CheckId, Topic, Unit};
use crate::eurocode::bolts::tension_resistance;
use crate::subject::Part;
use bracket_base::say;
use bracket_joint::assembly::{ColumnBase, PlaneActions};

/// Tension of an anchor \[N\].
#[derive(Clone, Copy, Debug)]
pub(super) enum Pull {
    /// By the forces of the base.
    Known(f64),
    /// Nothing tells it: its own resistance, which limit analysis does not exceed.
    AtMost(f64),
}

impl Pull {
    /// The most it can be.
    pub fn most(self) -> f64 {
        match self {
            Pull::Known(n) | Pull::AtMost(n) => n,
        }
    }

    /// The tension where no check knows it.
    pub fn unknown(e: &ColumnBase) -> Self {
        Pull::AtMost(tension_resistance(&e.bolt, &e.grade, e.factors.gamma_m2).value)
    }
}

/// The forces of an anchor that its anchorage must carry, tension and shear \[N\]; `None` where the
/// anchors carry nothing. It leaves the case undecided until the engineer has checked it.
///
/// # Source
/// EN 1993-1-8:2005 6.2.6.12: bond, cone, pull-out, splitting and edge of EN 1992-4 are not in
/// these checks.
pub(super) fn check(e: &ColumnBase, a: &PlaneActions, pull: Pull, shear: f64) -> Option<Check> {
    if pull.most() == 0.0 && shear == 0.0 {
        return None;
    }
    let relation = match pull {
        Pull::Known(_) => "=",
        Pull::AtMost(_) => "≤",
    };
    let why = say!(
        "an anchor brings N_Ed {} {}, prying included, and V_Ed = {} into the concrete: bond, \
         pull-out, concrete cone, splitting and concrete edge are not covered",
        relation,
        Unit::Force.show(pull.most()),
        Unit::Force.show(shear)
    );
    let (topic, clause, id) = (Topic::Bolts, "EN 1992-4:2018", CheckId::Anchorage);
    let subject = at(a).and(Part::Anchors);
    if e.anchorage_checked {
        return Some(Check::assumption(topic, subject, clause, id, why));
    }
    let step = "a check of the anchorage by EN 1992-4, and `anchorage_checked` true";
    Some(Check::undecided(topic, subject, clause, id, why, step))
}
