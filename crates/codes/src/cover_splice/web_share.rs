//! Forces of a web by its elastic share of axial force and moment, with all of the shear force.

use super::flange_share::web_inertia;
use super::least_forces::{BESIDE_CONTACT, Demand};
use super::side::Side;
use super::web_group::{BoltForces, WebGroup};
use crate::check::Unit;
use crate::formula::{Derivation, Formula, Traced};
use bracket_joint::assembly::{CoverSplice, SpliceUse};

/// What a web transfers through the bolts of one side of the splice axis.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct WebForces {
    /// N of the web, tension positive \[N\].
    pub axial: Formula,
    /// V \[N\].
    pub shear: Formula,
    /// M about the centre of the bolts, tension at the top positive \[N mm\].
    pub moment: Formula,
    /// Forces of the bolts.
    pub bolts: BoltForces,
}

impl WebForces {
    /// How axial force and moment follow from the actions.
    pub fn derivation(&self) -> Derivation {
        Derivation::from(self.axial.clone()).then(self.moment.clone())
    }
}

/// The forces of a web under the actions on its member, each with the moment of the shear force in
/// either sense, because the bolts lie on both sides of the splice axis.
///
/// `N_w = A_w/A N`, `M_w = I_w/I M + N_w e_z ± V e`.
///
/// # Source
/// EN 1993-1-8:2005 6.2.7.1(16)c: the shear force, the moment of its eccentricity and the share of
/// the web in the moment act together.
pub(super) fn web_forces(
    e: &CoverSplice,
    side: &Side<'_>,
    group: &WebGroup,
    demands: &[Demand],
) -> Vec<WebForces> {
    let s = &side.section;
    let [x, z] = group.centre;
    let share = || Traced::area("A_w", s.web_depth() * s.tw) / Traced::area("A", s.area);
    let contact = e.used == SpliceUse::Column { contact: true };
    let of = |d: &Demand, sense: f64| {
        let axial = share() * Traced::force("N_Ed", d.axial);
        let axial = match contact && d.axial < 0.0 {
            true => Traced::from(BESIDE_CONTACT) * axial,
            false => axial,
        };
        let axial = Formula::new("N_w,Ed", axial, Unit::Force);
        let inertia = Traced::number("I_w", web_inertia(s)) / Traced::number("I", s.i);
        let mut moment = inertia * Traced::symbol("M_Ed", d.moment, Unit::Moment);
        let above = side.member.axis - z;
        if above != 0.0 {
            moment = moment + axial.traced() * Traced::length("e_z", above);
        }
        let turn = Traced::force("V_Ed", sense * d.shear) * Traced::length("e", x);
        let moment = Formula::new("M_w,Ed", moment + turn, Unit::Moment);
        let shear = Formula::new("V_Ed", Traced::force("V_Ed", d.shear), Unit::Force);
        let bolts = group.forces([&axial, &shear, &moment]);
        WebForces { axial, shear, moment, bolts }
    };
    demands.iter().flat_map(|d| [1.0, -1.0].map(|sense| of(d, sense))).collect()
}
