//! One member end under one load case, as the checks see it that need the row forces of the
//! component method.

use super::{Sense, class_checks, n, stiffener_checks, weld_checks};
use crate::assembly::{EndPlate, PlaneActions};
use crate::checks::check::Check;
use crate::checks::component_method::Assessment;
use crate::checks::component_method::assembly::RowForce;
use crate::checks::component_method::rows::Component;

/// A member end under a load case.
pub(super) struct Case<'a> {
    /// The end plate.
    pub e: &'a EndPlate,
    /// What acts on it.
    pub a: &'a PlaneActions,
    /// Sense of bending.
    pub sense: Sense,
    /// The component method of that sense.
    pub assessment: &'a Assessment,
    /// Force of every row of the assessment under the load \[N\]; more than the row carries where
    /// the load is.
    pub rows: Vec<f64>,
    /// Largest compression of a flange of the beam under the load \[N\].
    pub push: f64,
}

impl Case<'_> {
    /// Member end and what else says the place.
    pub fn place(&self, words: &str) -> String {
        format!("{}, {words}", self.a.end)
    }

    /// z of a row in the axes of the spec: the assessment has the tension at the top.
    pub fn z(&self, row: &RowForce) -> f64 {
        if self.sense == Sense::Bottom { -row.z } else { row.z }
    }

    /// Force of a row under the load, counted from the tension side \[N\].
    pub fn row_demand(&self, row: usize) -> f64 {
        self.rows.get(row).copied().unwrap_or(0.0)
    }

    /// The rows `first..=last` in words.
    pub fn rows(&self, first: usize, last: usize) -> String {
        let each = self.assessment.rows.get(first..=last).unwrap_or_default().iter();
        let each: Vec<String> = each.map(|r| n(self.z(r))).collect();
        let many = if each.len() > 1 { "rows" } else { "row" };
        format!("{many} at z = {} mm", each.join(" and "))
    }
}

/// An intermediate value of a component.
pub(super) fn value(c: &Component, symbol: &str) -> Option<f64> {
    c.worked.steps.iter().find(|s| s.symbol == symbol).map(|s| s.value)
}

/// The checks of a member end under a load case.
pub(super) fn checks(c: &Case<'_>) -> Vec<Check> {
    let mut out: Vec<Check> = weld_checks::tension_zone(c).into_iter().collect();
    out.extend(stiffener_checks::stiffeners(c));
    out.extend(stiffener_checks::doubler_welds(c));
    out.extend(class_checks::classes(c));
    out
}
