//! Rows that the tables of effective lengths do not cover.

use super::{Rows, WELD};
use crate::check::{number as n, within};
use crate::component_method::component_kind::ComponentKind;
use crate::error::CheckError;
use bracket_base::say;
use bracket_base::words::Text;

impl Rows<'_> {
    /// Refuses rows that the tables of effective lengths do not cover.
    pub(super) fn covered(&self) -> Result<(), CheckError> {
        let not = |what: Text, clause, step| Err(CheckError::NotCovered { what, clause, step });
        let outside =
            |up: bool| self.z.iter().filter(|z| self.outside(**z) && (**z > 0.0) == up).count();
        if outside(true) > 1 || outside(false) > 1 {
            return not(
                "two rows or more lie outside the tension flange of the beam".into(),
                "EN 1993-1-8:2005 Table 6.6",
                "one row outside each flange (`bolts.rows`)",
            );
        }
        let (gauge, flange) = (self.joint.bolts.gauge, self.joint.beam.least_width());
        if !within(gauge, flange) {
            return not(
                say!(
                    "the bolts stand beyond the tips of the beam flange: a gauge of {} mm beside a \
                     flange of {} mm leaves the T-stub of the end plate without a flange",
                    n(gauge),
                    n(flange)
                ),
                "EN 1993-1-8:2005 figure 6.10",
                "a gauge inside the flange (`bolts.gauge`)",
            );
        }
        let column =
            self.joint.column.as_ref().map(|c| (self.m_column(c), ComponentKind::ColumnWeb));
        for (m, what) in column.into_iter().chain([(self.m_beam(), ComponentKind::BeamWeb)]) {
            if m <= 0.0 {
                let what = what.words();
                return not(
                    say!("the bolts stand in the root or weld of the {}: m = {} mm", what, n(m)),
                    "EN 1993-1-8:2005 figures 6.8 and 6.10",
                    "a wider gauge (`bolts.gauge`)",
                );
            }
        }
        for (i, z) in self.z.iter().enumerate() {
            let to_flange = match self.outside(*z) {
                true => self.mx(*z),
                false => self
                    .to_flanges(*z)
                    .into_iter()
                    .flatten()
                    .fold(self.to_inner_flange(*z), f64::min),
            };
            if to_flange <= 0.0 {
                return not(
                    say!("the row at z = {} mm stands on the beam flange or its weld", n(*z)),
                    "EN 1993-1-8:2005 figure 6.10",
                    "a row farther from the flange (`bolts.rows`)",
                );
            }
            let [above, below] = self.stiffeners(i);
            if above.into_iter().chain(below).any(|m2| m2 <= 0.0) {
                return not(
                    say!("the row at z = {} mm stands on a stiffener of the column", n(*z)),
                    "EN 1993-1-8:2005 figure 6.11",
                    "a row farther from the stiffener (`bolts.rows`)",
                );
            }
        }
        Ok(())
    }

    /// Distance of a row from the weld of the flange between the two webs of a haunched end \[mm\],
    /// infinite without one. That flange does not stiffen the plate in the tables, on the safe
    /// side, but no T-stub has its bolts on it.
    fn to_inner_flange(&self, z: f64) -> f64 {
        let haunch = self.joint.beam.sloped.and_then(|s| s.haunch);
        haunch.map_or(f64::INFINITY, |h| {
            let [lower, upper] = h.inner_flange;
            (z - upper).max(lower - z) - WELD * self.joint.beam.flange_throat
        })
    }
}
