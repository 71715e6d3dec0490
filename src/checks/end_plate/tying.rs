//! Tying resistance of the plate, information for structural integrity.

use super::{
    EndPlate, Sense, Topic, Unit, Worked, assess, bearing_parts, from_top, joint, mean_diameter, n,
    punching_resistance, tension_resistance,
};
use crate::checks::check::Check;
use crate::checks::component_method::Assessment;
use crate::checks::component_method::assembly::RowForce;

/// γ_Mu of tying resistances, as SCI P358 takes it.
const GAMMA_MU: f64 = 1.1;

/// Sum of the rows under a pull along the beam, with ultimate strengths and γ_Mu, at most what the
/// beam's area carries; nothing where the component method has no answer. Large deformations are
/// allowed, so that the rows need not keep to the lever arms of 6.2.7.2(9); welds are left out.
///
/// # Source
/// EN 1991-1-7:2006 A.5; SCI P358, tying resistance of end plates: T-stubs of EN 1993-1-8:2005
/// Table 6.2 with f_u and γ_Mu = 1.1.
pub(super) fn tying(e: &EndPlate) -> Option<Check> {
    let mut j = joint(e, 0.0);
    j.plate.fy = e.plate_steel.fu;
    j.beam.fy = e.beam_steel.fu;
    if let (Some(c), Some(side)) = (&mut j.column, &e.column) {
        c.fy = side.steel.fu;
    }
    (j.gamma_m0, j.gamma_m1) = (GAMMA_MU, GAMMA_MU);
    let dm = mean_diameter(&e.bolt);
    let punching = bearing_parts(e)
        .into_iter()
        .map(|(_, t, fu, _)| punching_resistance(dm, t, fu, GAMMA_MU).value);
    j.bolts.tension =
        punching.fold(tension_resistance(&e.bolt, &e.grade, false, GAMMA_MU).value, f64::min);
    let of = |sense: Sense| {
        let sign = if sense == Sense::Bottom { -1.0 } else { 1.0 };
        let found = assess(&sense.of(&j)).ok()?;
        Some(forces(&found).into_iter().map(|(z, force)| (sign * z, force)).collect::<Vec<_>>())
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
    let beam = 1e2 * e.beam.area * e.beam_steel.fu / GAMMA_MU;
    let value = each.iter().sum::<f64>().min(beam);
    if !value.is_finite() {
        return None;
    }
    let terms: Vec<String> = each.iter().map(|f| Unit::Force.show(*f)).collect();
    let formula = format!(
        "N_Rd,u = min(Σ F_tr,Rd,u, A f_u/γ_Mu) = min({}, {}) with f_u and γ_Mu = {}",
        terms.join(" + "),
        Unit::Force.show(beam),
        n(GAMMA_MU)
    );
    let title = "tying resistance, without welds";
    let worked = Worked::new("EN 1991-1-7:2006 A.5, SCI P358", title, value, Unit::Force, formula);
    Some(worked.information(Topic::Member, "end plate"))
}

/// z and force of the rows by what they carry alone and in groups \[mm, N\].
fn forces(a: &Assessment) -> Vec<(f64, f64)> {
    let mut out: Vec<(f64, f64)> = Vec::new();
    for row in &a.rows {
        let force = left(row, &out).max(0.0);
        out.push((row.z, force));
    }
    out
}

fn left(row: &RowForce, above: &[(f64, f64)]) -> f64 {
    let of_group =
        |first: usize, whole: f64| whole - above.iter().skip(first).map(|r| r.1).sum::<f64>();
    row.groups
        .iter()
        .map(|g| of_group(g.first, g.component.worked.value))
        .fold(row.single, f64::min)
}
