//! The column's own cross-section at the joint: axial force, shear and moment of the column above
//! or below it.

use super::column_forces::{CornerForces, columns, node_moment, of_case};
use crate::assembly::{ColumnSide, EndPlate};
use crate::checks::check::{Check, Status, Topic, Unit, number as n, within};
use crate::checks::eurocode::section::CrossSection;
use crate::checks::worked::Worked;

/// Clause of the section's resistance to several forces.
const CLAUSE: &str = "EN 1993-1-1:2005 6.2.8 to 6.2.10";
/// Subject of the checks.
const SUBJECT: &str = "column";

/// Forces of a column at the joint, with where they come from.
struct Forces {
    /// N, tension positive \[N\].
    axial: f64,
    /// |M| about the strong axis \[N mm\].
    moment: f64,
    /// |V| along the web \[N\].
    shear: f64,
    /// Where they come from, in words.
    from: String,
}

/// The column's section under the forces that the spec gives. They belong to no load case.
pub(super) fn given(e: &EndPlate) -> Vec<Check> {
    let Some(c) = &e.column else { return Vec::new() };
    // at a corner the forces of each load case are known
    let corner = columns(c) == 1 && !e.actions.is_empty();
    if corner || (c.axial.is_none() && c.moment.is_none()) {
        return Vec::new();
    }
    let (mut absent, mut named) = (Vec::new(), Vec::new());
    for (name, given) in [("N_Ed", c.axial), ("M_Ed", c.moment)] {
        if given.is_some() { &mut named } else { &mut absent }.push(name);
    }
    let mut from = format!("{} of the spec", named.join(" and "));
    if let [absent] = absent[..] {
        from += &format!(", which gives no {absent}: taken as 0");
    }
    let forces = Forces {
        axial: c.axial.unwrap_or(0.0),
        moment: c.moment.unwrap_or(0.0).abs(),
        shear: c.shear.abs(),
        from,
    };
    section(e, c, &forces)
}

/// The column's section under a load case: at a corner with the forces that follow from the
/// equilibrium of the node; elsewhere, if the spec gives no forces, what is not known.
pub(super) fn under_load(e: &EndPlate, case: &str) -> Vec<Check> {
    let Some(c) = &e.column else { return Vec::new() };
    if let Some(corner) = CornerForces::new(e, case) {
        let at_node = Unit::Moment.show(corner.at_node);
        let mut from =
            format!("equilibrium of the node with one column, M = {at_node} at the node");
        if c.axial.is_some() {
            from += ", N_Ed of the spec";
        }
        let given = c.moment.unwrap_or(0.0).abs();
        if !within(given, corner.moment) {
            from += ", M_Ed of the spec";
        }
        let forces = Forces {
            axial: c.axial.unwrap_or(corner.axial),
            moment: corner.moment.max(given),
            shear: corner.shear.max(c.shear.abs()),
            from,
        };
        return section(e, c, &forces);
    }
    if c.axial.is_some() || c.moment.is_some() {
        return Vec::new();
    }
    not_known(e, c, case).into_iter().collect()
}

/// Axial force, shear and moment of the column against its section.
///
/// # Source
/// EN 1993-1-1:2005 6.2.3 to 6.2.6 and 6.2.8 to 6.2.10.
fn section(e: &EndPlate, c: &ColumnSide, f: &Forces) -> Vec<Check> {
    let column = cross_section(e, c);
    let of = |mut worked: Worked, title: &'static str, demand: f64| {
        worked.title = title;
        worked.formula = format!("{}; {}", f.from, worked.formula);
        worked.against(Topic::Member, SUBJECT, demand, Status::Failed)
    };
    let mut out = Vec::new();
    if f.shear > 0.0 {
        out.push(of(column.shear(), "shear of the column", f.shear));
    }
    if f.axial != 0.0 {
        out.push(of(column.axial(), "axial force of the column", f.axial.abs()));
    }
    if f.axial > 0.0 {
        out.push(of(net_tension(e, c), "tension of the column beside its holes", f.axial));
    }
    let title = "moment of the column with its shear and axial force";
    out.push(match column.bending_6_2_10(f.shear, f.axial) {
        Ok(worked) => {
            let worked = worked.with("N_Ed", f.axial, Unit::Force);
            of(worked.with("V_Ed", f.shear, Unit::Force), title, f.moment)
        }
        // class 4
        Err(fault) => {
            let why = format!("{}; {fault}", f.from);
            Check::undecided(Topic::Member, SUBJECT, CLAUSE, title, why)
        }
    });
    out
}

fn cross_section(e: &EndPlate, c: &ColumnSide) -> CrossSection {
    CrossSection { section: (&c.section).into(), fy: c.steel.fy, gamma_m0: e.factors.gamma_m0 }
}

/// Tension of the section less the holes of a row in its flanges,
/// `N_u,Rd = 0.9 A_net f_u/γ_M2`.
///
/// # Source
/// EN 1993-1-1:2005 6.2.3(2)b.
fn net_tension(e: &EndPlate, c: &ColumnSide) -> Worked {
    let mut ends: Vec<&str> = e.actions.iter().map(|a| a.end.as_str()).collect();
    ends.sort_unstable();
    ends.dedup();
    // a beam on either side has holes in both flanges
    let holes = (ends.len().max(1) * e.columns().len()) as f64;
    let (area, gamma) = (1e2 * c.section.area, e.factors.gamma_m2);
    let net = area - holes * e.hole * c.section.tf;
    let formula = format!(
        "N_u,Rd = 0.9 A_net f_u/γ_M2 = 0.9 · ({} − {} · {} · {}) · {}/{}",
        n(area),
        n(holes),
        n(e.hole),
        n(c.section.tf),
        n(c.steel.fu),
        n(gamma)
    );
    let value = 0.9 * net * c.steel.fu / gamma;
    let title = "tension of the column beside its holes";
    Worked::new("EN 1993-1-1:2005 6.2.3(2)b", title, value, Unit::Force, formula)
}

/// What the beams bring into a column that continues both ways. Its share above and below is not
/// known, so that nothing is checked.
fn not_known(e: &EndPlate, c: &ColumnSide, case: &str) -> Option<Check> {
    of_case(e, case).next().filter(|_| columns(c) == 2)?;
    let moment = node_moment(e, case).abs();
    let worked = cross_section(e, c).bending_6_2_10(0.0, 0.0).ok()?;
    let title = "column beside the joint, not checked";
    let formula = format!(
        "the column continues both ways, and the spec gives no N_Ed and M_Ed of it: its share of \
         the moment {} at the node is not known (one half would be {} of M_c,Rd); members.column \
         takes N_Ed, M_Ed and V_Ed",
        Unit::Moment.show(moment),
        n(0.5 * moment / worked.value)
    );
    Some(Check::assumption(Topic::Member, SUBJECT, CLAUSE, title, formula))
}
