//! One member end under one load case: the forces that its actions put into rows, bolts and
//! flanges.
//!
//! The component method spreads the moment over its rows. A row takes the share of its resistance
//! that the joint takes of M_j,Rd, prying included (`RowForce::bolt_force`), also where that
//! exceeds its resistance: no demand is capped silently. Beside an axial force that counts, the
//! rows have the forces of the plastic equilibrium (`component_method::equilibrium`).

use super::at_plate;
use super::column_forces::{ColumnForces, known};
use super::comparison::Method;
use super::component_joint::component_joint;
use super::transformation::beta;
use crate::component_method::assembly::RowForce;
use crate::component_method::equilibrium::{Carried, RowPull};
use crate::component_method::joint::EndPlateJoint;
use crate::component_method::{Assessment, Equilibrium, assess};
use crate::error::CheckError;
use crate::subject::{Place, Sense, Subject};
use bracket_joint::assembly::{EndPlate, PlaneActions};

/// A member end under a load case, with the component method of its sense of bending.
pub(super) struct MemberEnd<'a> {
    /// The end plate.
    pub e: &'a EndPlate,
    /// Actions on it.
    pub a: &'a PlaneActions,
    /// Sense of bending.
    pub sense: Sense,
    /// The joint in its own axes.
    pub joint: EndPlateJoint,
    /// Component method of the joint turned by `sense`.
    pub assessment: Assessment,
}

impl<'a> MemberEnd<'a> {
    /// The member end with the joint of the component method; an error where the tables of the code
    /// do not cover it.
    pub fn new(e: &'a EndPlate, a: &'a PlaneActions) -> Result<Self, CheckError> {
        let sense = Sense::of_moment(a.at(1.0)[1][1]);
        let mut joint = component_joint(e, beta(e, a));
        joint.beam.shear = at_plate::web_shear(e, a.at(1.0)).hypot(a.at(1.0)[0][1]);
        if let (Some(c), Some(side)) = (&mut joint.column, e.column.as_ref().filter(|c| known(c))) {
            c.longitudinal = ColumnForces::of_case(e, side, &a.case).longitudinal(side);
        }
        let assessment = assess(&joint.turned(sense))?;
        Ok(Self { e, a, sense, joint, assessment })
    }

    /// Member end and sense of bending.
    pub fn subject(&self) -> Subject {
        subject(self.a, self.sense)
    }

    /// Resistance of the joint for the sense of bending of the case. The equilibrium is computed
    /// only where an axial force acts.
    pub fn method(&self) -> Method {
        let axial = self.a.at(1.0)[0][0];
        let acts = axial != 0.0 || self.a.dead[0][0] != 0.0;
        Method {
            moment: self.assessment.moment.value,
            equilibrium: if acts { Equilibrium::new(&self.joint).ok() } else { None },
            beta: self.joint.beta,
            sense: self.sense,
        }
    }
}

/// Member end and sense of bending, as a check names them.
pub(super) fn subject(a: &PlaneActions, sense: Sense) -> Subject {
    Subject::end(&a.end).and(sense)
}

/// A member end with the forces of its actions.
pub(super) struct LoadedEnd<'a> {
    /// The member end.
    pub end: &'a MemberEnd<'a>,
    /// Resistance of the joint by the component method.
    pub method: &'a Method,
    /// States of the rows that the actions may cause: the axial force alone, and together with the
    /// moment where it counts. Each is a linear program or two, so they are computed once.
    states: Vec<Carried>,
    /// Largest compression of a flange of the beam \[N\].
    pub push: f64,
}

impl<'a> LoadedEnd<'a> {
    /// Distributes the actions of a member end.
    pub fn new(end: &'a MemberEnd<'a>, method: &'a Method) -> Self {
        let at = end.a.at(1.0);
        let alone = method.equilibrium.as_ref().and_then(|e| e.at(at[0][0], 0.0));
        let states =
            alone.into_iter().chain(method.with_axial(at)).filter(|c| c.factor > 0.0).collect();
        Self { end, method, states, push: push(end, method) }
    }

    /// Member end and a place at it.
    pub fn place(&self, further: impl Into<Subject>) -> Subject {
        Subject::end(&self.end.a.end).and(further)
    }

    /// Force of a row, counted from the tension side \[N\]; more than its resistance where the load
    /// is.
    pub fn row_force(&self, row: usize) -> f64 {
        let rows = &self.end.assessment.rows;
        rows.get(row).map_or(0.0, |row| self.pull(self.end.sense.z(row.z)))
    }

    /// Force of the row at `z` \[mm\] without prying \[N\].
    pub fn pull(&self, z: f64) -> f64 {
        let share = self.method.bending(self.end.a.at(1.0)[1][1]);
        self.at_row(z, |row| share * row.force, |pull| pull.force)
    }

    /// Tension of one bolt of the row at `z` \[mm\], prying included \[N\].
    pub fn bolt_force(&self, z: f64) -> f64 {
        let share = self.method.bending(self.end.a.at(1.0)[1][1]);
        self.at_row(z, |row| row.bolt_force(share), |pull| pull.bolt)
    }

    /// Force at the row at `z` \[mm\], not limited by any resistance: the share of the moment, or
    /// more where the axial force causes more. Compression that relieves a row is not counted, so
    /// that a larger load never has smaller forces.
    fn at_row(
        &self,
        z: f64,
        by_moment: impl Fn(&RowForce) -> f64,
        by_equilibrium: fn(&RowPull) -> f64,
    ) -> f64 {
        let rows = &self.end.assessment.rows;
        let row = rows.iter().find(|r| (self.end.sense.z(r.z) - z).abs() < 1e-9);
        let pulled = self.states.iter().filter_map(|c| {
            Some(by_equilibrium(c.rows.iter().find(|r| (r.z - z).abs() < 1e-9)?) / c.factor)
        });
        pulled.fold(row.map_or(0.0, by_moment), f64::max)
    }

    /// The rows `first..=last` as a check names them.
    pub fn rows(&self, first: usize, last: usize) -> Place {
        let each = self.end.assessment.rows.get(first..=last).unwrap_or_default().iter();
        Place::Rows(each.map(|r| self.end.sense.z(r.z)).collect())
    }
}

/// Largest compression of a flange of the beam under the actions \[N\].
fn push(end: &MemberEnd<'_>, method: &Method) -> f64 {
    let at = end.a.at(1.0);
    // a small axial compression that does not count for the joint still presses the flanges, half
    // of it each
    let bending = method.bending(at[1][1]) * end.assessment.tension();
    let plain = bending + 0.5 * (-at[0][0]).max(0.0);
    let together = method.with_axial(at).filter(|c| c.factor > 0.0);
    let of = |c: Carried| c.compression.into_iter().fold(0.0, f64::max) / c.factor;
    together.map_or(plain, |c| of(c).max(bending))
}
