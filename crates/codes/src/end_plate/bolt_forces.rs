//! Forces of the bolts under the actions of a load case, and their checks.
//!
//! Shear goes to the bolts in proportion to the share that tension leaves of their shear
//! resistance, `1 − F_t,Ed/(1.4 F_t,Rd)`: 1 for a bolt without tension, 0.4/1.4 for a bolt at
//! F_t,Rd, the two values of 6.2.2(2). Beside a force across the member the bolts have different
//! forces (`bolt_group`); a row has that of its bolt that is used most.

use super::bolt_checks::{bearing_at, bolt_shear, for_bearing};
use super::bolt_group::{GroupBolt, assumption, bearing_across, block_across, shear_forces};
use super::bolt_rows::from_top;
use super::clamped_plates::{ClampedPlate, clamped_plates};
use super::member_end::LoadedEnd;
use crate::check::{Check, CheckId, Status, Topic, Unit, largest, number as n};
use crate::eurocode::block_tearing::Blocks;
use crate::eurocode::bolts::{shear_resistance, tension_resistance};
use crate::eurocode::holes::Clearance;
use crate::eurocode::interaction::{self, Forces};
use crate::eurocode::punching::{mean_diameter, punching_resistance};
use crate::formula::{Derivation, Number, Traced};
use crate::subject::{Part, Place, Subject};
use crate::worked::Worked;
use bracket_base::say;
use bracket_joint::assembly::{EndPlate, Way};

/// Divisor of the tension in the interaction formula of Table 3.4.
const TENSION_DIVISOR: f64 = 1.4;

/// A row of bolts under load.
#[derive(Clone, Copy)]
struct Row {
    /// z of the row \[mm\].
    z: f64,
    /// Tension of one of its bolts, prying included \[N\].
    tension: f64,
    /// Force of the row without prying \[N\].
    pull: f64,
}

/// The bolts of a member end with their forces.
pub(super) struct BoltForces<'a> {
    e: &'a EndPlate,
    end: &'a str,
    /// The rows, from the top.
    rows: Vec<Row>,
    /// Shear force on all bolts together \[N\].
    shear: f64,
    /// F_t,Rd of one bolt \[N\].
    tension_resistance: f64,
    /// F_v,Rd of one bolt, thread in the shear plane \[N\].
    shear_resistance: Traced,
    /// Its derivation, where it is not that of Table 3.4 alone.
    reduced: Derivation,
    /// Shear forces across and along the member \[N\].
    force: [f64; 2],
}

/// Share of the shear resistance of a bolt that its tension leaves, `1 − F_t,Ed/(1.4 F_t,Rd)`.
///
/// # Source
/// EN 1993-1-8:2005 Table 3.4.
fn shear_share<N: Number>(f_t_ed: N, f_t_rd: N) -> N {
    N::from(1.0) - f_t_ed / (N::from(TENSION_DIVISOR) * f_t_rd)
}

impl<'a> BoltForces<'a> {
    /// Bolt forces under the actions of a member end.
    pub fn new(loaded: &LoadedEnd<'a>) -> Self {
        let (e, a) = (loaded.end.e, loaded.end.a);
        let [[_, vy, vz], _] = a.at(1.0);
        let whole = shear_resistance(&e.bolt, &e.grade, e.factors.gamma_m2).value;
        let shear = bolt_shear(e, [vy, vz]);
        Self {
            e,
            end: &a.end,
            rows: from_top(e)
                .into_iter()
                .map(|z| Row { z, tension: loaded.bolt_force(z), pull: loaded.pull(z) })
                .collect(),
            shear: vz.hypot(vy),
            tension_resistance: tension_resistance(&e.bolt, &e.grade, e.factors.gamma_m2).value,
            shear_resistance: shear.traced(),
            reduced: if shear.value < whole { shear.derivation } else { Derivation::default() },
            force: [vy, vz],
        }
    }

    /// Tension that counts beside shear: a bolt yields at F_t,Rd, and tension beyond it appears in
    /// the check of tension.
    fn capped(&self, tension: f64) -> f64 {
        tension.min(self.tension_resistance)
    }

    /// Share of the shear resistance of a bolt that its tension leaves.
    fn shear_share(&self, tension: f64) -> f64 {
        shear_share(self.capped(tension), self.tension_resistance)
    }

    /// Sum of the shares of all bolts. Tensions print with their cap where it binds at a row.
    fn shear_shares(&self) -> Traced {
        let capped = self.rows.iter().any(|r| r.tension > self.tension_resistance);
        let of = |row: &Row| {
            let [ed, rd] = [("F_t,Ed", row.tension), ("F_t,Rd", self.tension_resistance)]
                .map(|(symbol, value)| Traced::force(symbol, value));
            let ed = if capped { ed.min(rd.clone()) } else { ed };
            Traced::from(2.0) * shear_share(ed, rd)
        };
        Traced::series(self.rows.iter().map(of))
    }

    /// The bolts, two of each row, with the shares that tension leaves.
    fn group(&self) -> Vec<GroupBolt> {
        let half = 0.5 * self.e.gauge;
        let of = |row: &Row| {
            let weight = self.shear_share(row.tension);
            [-half, half].map(|y| GroupBolt { at: [y, row.z], weight })
        };
        self.rows.iter().flat_map(of).collect()
    }

    /// The rows with the shear forces `[y, z]` of their two bolts \[N\].
    fn sheared(&self) -> Vec<(Row, [[f64; 2]; 2])> {
        let forces = shear_forces(&self.group(), self.force);
        let pairs = forces.chunks_exact(2).map(|pair| [pair[0], pair[1]]);
        self.rows.iter().copied().zip(pairs).collect()
    }

    fn place(&self, row: Row) -> Subject {
        Subject::end(self.end).and(Place::Rows(vec![row.z]))
    }

    /// The place of a check in which tension beyond F_t,Rd does not count.
    fn capped_place(&self, row: Row) -> Subject {
        match row.tension > self.tension_resistance {
            true => self.place(row).and(Place::Capped),
            false => self.place(row),
        }
    }

    /// The row with the largest tension.
    fn most_pulled(&self) -> Option<Row> {
        largest(self.rows.iter().copied(), |r| r.tension)
    }

    /// A value with the note that it counts no more than F_t,Rd.
    fn note_cap(&self, worked: Worked, tension: f64) -> Worked {
        if tension > self.tension_resistance {
            let tension = Unit::Force.show(tension);
            return worked.then(say!("F_t,Ed = {} counts as F_t,Rd here", tension));
        }
        worked
    }

    /// Shear, tension, both together, bearing and punching.
    pub fn checks(&self) -> Vec<Check> {
        let mut out = vec![self.shear()];
        out.extend(self.tension());
        out.extend(self.shear_and_tension());
        let [across, _] = self.force;
        if across != 0.0 {
            out.push(assumption(&self.group(), self.end, across));
        }
        for plate in clamped_plates(self.e) {
            out.extend(self.bearing(&plate));
            out.extend(self.block_tearing(&plate));
            if across != 0.0 {
                out.extend(self.bearing_across(&plate));
                let place = Subject::from(plate.part).and(Subject::end(self.end));
                let block = block_across(self.e, &plate);
                out.push(block.against(Topic::Bolts, place, across.abs(), Status::Failed));
            }
            out.extend(self.punching(&plate));
        }
        out
    }

    /// The bolts together in shear, each with the share that its tension leaves.
    fn shear(&self) -> Check {
        let clause = "EN 1993-1-8:2005 6.2.2(2), Table 3.4";
        let id = CheckId::BoltGroupShear;
        let value = self.shear_shares() * self.shear_resistance.clone();
        let mut worked =
            Worked::of(clause, id, "V_Rd", value, Unit::Force).after(self.reduced.clone());
        if let Some(row) = self.most_pulled() {
            worked = self.note_cap(worked, row.tension);
        }
        for row in &self.rows {
            let symbol = say!("F_t,Ed of the row at z = {} mm", n(row.z));
            worked = worked.with(symbol, row.tension, Unit::Force);
        }
        worked.against(Topic::Bolts, Subject::end(self.end), self.shear, Status::Failed)
    }

    /// Tension of the bolts of the row that is pulled most.
    fn tension(&self) -> Option<Check> {
        let (e, row) = (self.e, self.most_pulled()?);
        let mut worked = tension_resistance(&e.bolt, &e.grade, e.factors.gamma_m2);
        worked.id = CheckId::BoltTension;
        if row.pull > 0.0 {
            let prying = 2.0 * row.tension / row.pull;
            worked = worked.with("F_tr,Ed", row.pull, Unit::Force);
            worked = worked.with("2 F_t,Ed/F_tr,Ed", prying, Unit::Number);
        }
        let topic = Topic::ComponentMethod;
        Some(worked.against(topic, self.place(row), row.tension, Status::Failed).of_strength())
    }

    /// Interaction of shear and tension, for each bolt on its own as Table 3.4 has it.
    fn shear_and_tension(&self) -> Option<Check> {
        let each = self.sheared().into_iter().map(|(row, [a, b])| {
            let worked = interaction::utilisation(&Forces {
                shear: a[0].hypot(a[1]).max(b[0].hypot(b[1])),
                tension: self.capped(row.tension),
                shear_resistance: self.shear_resistance.value(),
                tension_resistance: self.tension_resistance,
            });
            (row, self.note_cap(worked, row.tension))
        });
        let (row, worked) = largest(each, |(_, worked)| worked.value)?;
        Some(worked.utilised(Topic::Bolts, self.capped_place(row), Status::Failed))
    }

    /// Bearing of a plate at the row that uses it most.
    fn bearing(&self, plate: &ClampedPlate) -> Option<Check> {
        let each = self.sheared().into_iter().flat_map(|(row, pair)| {
            let of = |[_, force]: [f64; 2]| {
                let least = bearing_at(self.e, plate, row.z, [0.0, force])?;
                Some((row, force.abs(), least))
            };
            pair.into_iter().filter_map(of).collect::<Vec<_>>()
        });
        let (row, force, worked) = largest(each, |(_, force, worked)| force / worked.value)?;
        let place = Subject::from(plate.part).and(self.place(row));
        Some(worked.against(Topic::Bolts, place, force, Status::Failed))
    }

    /// Bearing of a plate across the member at the row that uses it most.
    fn bearing_across(&self, plate: &ClampedPlate) -> Option<Check> {
        let known = Clearance::of(&self.e.bolt, self.e.hole) != Clearance::Beyond;
        let hole = for_bearing(self.e, self.force);
        let each = self.sheared().into_iter().filter(|_| known).map(|(row, [a, b])| {
            let force = a[0].abs().max(b[0].abs());
            (row, force, bearing_across(self.e, plate, hole, row.z))
        });
        let (row, force, worked) = largest(each, |(_, force, worked)| force / worked.value)?;
        let place = Subject::from(plate.part).and(self.place(row));
        Some(worked.against(Topic::Bolts, place, force, Status::Failed))
    }

    /// Block tearing of both edges of a plate under the vertical force: along each column of bolts
    /// to the end that the bolts press the plate to, and across to the edge. `None` without a
    /// vertical force, and where the column goes on.
    fn block_tearing(&self, plate: &ClampedPlate) -> Option<Check> {
        let e = self.e;
        let on_column = Way::of(self.force[1])?;
        let (first, last) = (self.rows.first()?.z, self.rows.last()?.z);
        let farthest = |way| if way == Way::Up { last } else { first };
        let whole = match e.column.as_ref().filter(|_| plate.part != Part::EndPlate) {
            Some(c) => c.ends().from(farthest(on_column), on_column)?,
            // the bolts press the end plate against the force of the beam
            None if on_column == Way::Down => e.top - farthest(Way::Up),
            None => farthest(Way::Down) - e.bottom,
        };
        let blocks = Blocks {
            count: 2.0,
            tension: 0.5 * (plate.width - e.gauge.max(e.outer_gauge)) - 0.5 * e.hole,
            shear: whole - (self.rows.len() as f64 - 0.5) * e.hole,
            thickness: plate.thickness,
            fy: plate.fy,
            fu: plate.fu,
        };
        let worked = blocks.resistance(e.factors.gamma_m0, e.factors.gamma_m2);
        let place = Subject::from(plate.part).and(Subject::end(self.end));
        Some(worked.against(Topic::Bolts, place, self.force[1].abs(), Status::Failed))
    }

    /// Punching of a plate at the row that is pulled most.
    fn punching(&self, plate: &ClampedPlate) -> Option<Check> {
        let (e, row) = (self.e, self.most_pulled()?);
        let worked = punching_resistance(
            mean_diameter(&e.bolt),
            plate.thickness,
            plate.fu,
            e.factors.gamma_m2,
        );
        let worked = self.note_cap(worked, row.tension);
        let place = Subject::from(plate.part).and(self.capped_place(row));
        Some(worked.against(Topic::Bolts, place, self.capped(row.tension), Status::Failed))
    }
}
