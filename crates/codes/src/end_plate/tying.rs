//! Tying resistance of the end plate: information for structural integrity.

use super::at_plate;
use super::bolt_checks::bolt_tension;
use super::bolt_rows::from_top;
use super::component_joint::component_joint;
use crate::check::{Check, CheckId, Topic, Unit};
use crate::component_method::assembly::RowForce;
use crate::component_method::{Assessment, assess};
use crate::formula::{Number, Traced};
use crate::subject::{Part, Sense};
use crate::worked::Worked;
use bracket_joint::assembly::EndPlate;
use bracket_joint::strength::Strength;

/// γ_Mu of tying resistances in SCI P358.
pub(crate) const GAMMA_MU: f64 = 1.1;

/// Tying resistance: sum of the rows under a tension along the beam, with ultimate strengths and
/// γ_Mu, at most that of the beam's area; `None` where the component method does not cover the
/// joint. Large deformations are allowed, so that the lever arms of 6.2.7.2(9) do not limit the
/// rows. Welds are left out.
///
/// # Source
/// EN 1991-1-7:2006 A.5; SCI P358, tying resistance of end plates: T-stubs of EN 1993-1-8:2005
/// Table 6.2 with f_u and γ_Mu = 1.1.
pub(super) fn tying(e: &EndPlate) -> Option<Check> {
    let mut j = component_joint(e, 0.0);
    j.plate.fy = e.plate_steel.fu.mpa();
    let fu = |s: &Strength| s.fu.mpa();
    let haunch = at_plate::haunch(e).map_or(f64::INFINITY, |h| fu(&h.steel));
    j.beam.fy = fu(&e.beam_steel).min(haunch);
    if let (Some(c), Some(side)) = (&mut j.column, &e.column) {
        c.fy = side.steel.fu.mpa();
    }
    (j.gamma_m0, j.gamma_m1) = (GAMMA_MU, GAMMA_MU);
    j.bolts.tension = bolt_tension(e, GAMMA_MU);
    let of = |sense: Sense| {
        let found = assess(&j.turned(sense)).ok()?;
        Some(forces(&found).into_iter().map(|(z, force)| (sense.z(z), force)).collect::<Vec<_>>())
    };
    let both = [of(Sense::Top)?, of(Sense::Bottom)?];
    let each: Vec<f64> = from_top(e)
        .into_iter()
        .map(|z| {
            both.iter()
                .flatten()
                .filter(|r| (r.0 - z).abs() < 1e-9)
                .map(|r| r.1)
                .fold(f64::INFINITY, f64::min)
        })
        .collect();
    let mut beam = Traced::area("A", 1e2 * e.beam.area)
        * Traced::stress("f_u", e.beam_steel.fu.mpa())
        / Traced::number("γ_Mu", GAMMA_MU);
    if let Some(r) = at_plate::rafter(e) {
        beam = beam * Traced::number("cos α", r.slope.cos());
    }
    let rows = Traced::series(each.iter().map(|f| Traced::force("F_tr,Rd,u", *f)));
    let value = rows.min(beam);
    if !value.value().is_finite() {
        return None;
    }
    let id = CheckId::Tying;
    let clause = "EN 1991-1-7:2006 A.5, SCI P358";
    let worked = Worked::of(clause, id, "N_Rd,u", value, Unit::Force);
    Some(worked.information(Topic::Member, Part::EndPlate))
}

/// z and force of the rows \[mm, N\], limited by each row alone and by the groups.
fn forces(a: &Assessment) -> Vec<(f64, f64)> {
    let mut out: Vec<(f64, f64)> = Vec::new();
    for row in &a.rows {
        let force = beside(row, &out).max(0.0);
        out.push((row.z, force));
    }
    out
}

/// Force of a row beside the forces of the rows above \[N\].
fn beside(row: &RowForce, above: &[(f64, f64)]) -> f64 {
    let of_group =
        |first: usize, whole: f64| whole - above.iter().skip(first).map(|r| r.1).sum::<f64>();
    row.groups
        .iter()
        .map(|g| of_group(g.first, g.component.worked.value))
        .fold(row.single, f64::min)
}
