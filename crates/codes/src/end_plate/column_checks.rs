//! The column's own cross-section at the joint: axial force, shear and moment of the column above
//! or below it.

use super::column_forces::{ColumnForces, Moment, columns, known, unsupported};
use crate::check::{Check, CheckId, Status, Topic, Unit, number as n, within};
use crate::eurocode::section::CrossSection;
use crate::eurocode::yielding::plastic;
use crate::formula::{Derivation, Traced};
use crate::subject::Part;
use crate::worked::Worked;
use bracket_base::say;
use bracket_base::words::Text;
use bracket_joint::assembly::{ColumnSide, EndPlate};

/// Clause of the section's resistance to several forces.
const CLAUSE: &str = "EN 1993-1-1:2005 6.2.8 to 6.2.10";
/// Subject of the checks.
const SUBJECT: Part = Part::Column;

/// The check of the moment.
const MOMENT: CheckId = CheckId::ColumnMoment;

/// The column's section under the forces that the spec gives, where no load case at the ultimate
/// limit state has actions at a member end.
pub(super) fn given(e: &EndPlate) -> Vec<Check> {
    if e.actions.iter().any(|a| a.state.is_ultimate()) {
        return Vec::new();
    }
    let forces = e.column.as_ref().and_then(|c| Some((c, ColumnForces::given(c)?)));
    forces.map_or_else(Vec::new, |(c, forces)| section(e, c, &forces))
}

/// The column's section under a load case, with the forces of the spec and those that follow from
/// the equilibrium of the node; if the spec gives none and the column continues, what is not known.
pub(super) fn under_load(e: &EndPlate, case: &str) -> Vec<Check> {
    let Some(c) = &e.column else { return Vec::new() };
    let forces = ColumnForces::of_case(e, c, case);
    match known(c) {
        _ if columns(c) == 0 => unsupported(e, c, case).map(no_support).into_iter().collect(),
        true => section(e, c, &forces),
        false => shear(e, c, &forces).into_iter().chain(not_known(e, c, &forces)).collect(),
    }
}

/// A column that ends above and below has nothing that holds what the beams bring.
fn no_support([push, lift, moment]: [f64; 3]) -> Check {
    let why = say!(
        "the column ends above and below the joint, and nothing carries what the beams leave at \
         the node: {} across, {} along the column, M = {}",
        Unit::Force.show(push.abs()),
        Unit::Force.show(lift.abs()),
        Unit::Moment.show(moment.abs())
    );
    let (clause, id) = ("EN 1993-1-8:2005 2.5(1)", CheckId::NodeEquilibrium);
    let step = "a column that continues (`column_ends_above` or `column_ends_below` false), or \
                beams in balance";
    Check::undecided(Topic::Member, SUBJECT, clause, id, why, step)
}

/// The shear force of the column against its section; `None` without one.
fn shear(e: &EndPlate, c: &ColumnSide, f: &ColumnForces) -> Option<Check> {
    let mut worked = cross_section(e, c).shear();
    worked.id = CheckId::ColumnShear;
    let worked = worked.after(f.from.clone());
    (f.shear > 0.0).then(|| worked.against(Topic::Member, SUBJECT, f.shear, Status::Failed))
}

/// Note on forces of the spec that exceed the resistance of the column itself: most likely a wrong
/// number or unit.
pub(super) fn beyond_the_column(e: &EndPlate) -> Option<Text> {
    let c = e.column.as_ref()?;
    let column = cross_section(e, c);
    let plastic = plastic(column.section.w_pl, column.fy.mpa(), column.gamma_m0);
    let given = [
        ("N_Ed", c.axial, column.axial().value, Unit::Force),
        ("M_Ed", c.moment, plastic, Unit::Moment),
        ("V_Ed", Some(c.shear), column.shear().value, Unit::Force),
    ];
    let beyond = given.into_iter().find_map(|(name, given, most, unit)| {
        let given = given?.abs();
        (!within(given, most)).then_some((name, given, most, unit))
    });
    let (name, given, most, unit) = beyond?;
    Some(say!(
        "members.column.{} = {} is {} times the resistance {} of the column {}: check the number \
         and its unit",
        name,
        unit.show(given),
        n(given / most),
        unit.show(most),
        &c.section.name
    ))
}

/// Axial force, shear and moment of the column against its section.
///
/// # Source
/// EN 1993-1-1:2005 6.2.3 to 6.2.6 and 6.2.8 to 6.2.10.
fn section(e: &EndPlate, c: &ColumnSide, f: &ColumnForces) -> Vec<Check> {
    let column = cross_section(e, c);
    let of = |mut worked: Worked, id: CheckId, demand: f64| {
        worked.id = id;
        worked.after(f.from.clone()).against(Topic::Member, SUBJECT, demand, Status::Failed)
    };
    let mut out = Vec::new();
    out.extend(shear(e, c, f));
    if f.axial != 0.0 {
        out.push(of(column.axial(), CheckId::ColumnAxial, f.axial.abs()));
    }
    if f.axial > 0.0 {
        out.push(of(net_tension(e, c), CheckId::ColumnNetTension, f.axial));
    }
    out.push(match column.bending_6_2_10(f.shear, f.axial) {
        Ok(worked) => {
            let resistance = worked.value;
            let worked = worked.with("N_Ed", f.axial, Unit::Force);
            let check = of(worked.with("V_Ed", f.shear, Unit::Force), MOMENT, f.moment);
            as_far_as_known(check, f, resistance)
        }
        // class 4
        Err(fault) => {
            let why = Derivation::default().followed_by(f.from.clone()).then(fault.text());
            let step = match f.known {
                Moment::Contradicts => say!("{}, and {}", fault.step(), more_moment(f)),
                _ => fault.step().into(),
            };
            Check::undecided(Topic::Member, SUBJECT, CLAUSE, MOMENT, why, step)
        }
    });
    out
}

/// The check of the moment. One that holds under the least moment is undecided if the given moment
/// contradicts equilibrium, or if none is given and the whole moment of the node would not hold.
fn as_far_as_known(mut check: Check, f: &ColumnForces, resistance: f64) -> Check {
    let open = match f.known {
        Moment::Known => false,
        Moment::NotGiven { most } => !within(most, resistance),
        Moment::Contradicts => true,
    };
    if open && check.status == Status::Ok {
        check.status = Status::Undecided;
    }
    check.decided_by(more_moment(f))
}

/// What supplies a missing or contradicted moment.
fn more_moment(f: &ColumnForces) -> Text {
    let least = Unit::Moment.show(f.moment);
    say!("members.column.M_Ed of the frame analysis, at least {}", least)
}

fn cross_section(e: &EndPlate, c: &ColumnSide) -> CrossSection {
    CrossSection { section: (&c.section).into(), fy: c.steel.fy, gamma_m0: e.factors.gamma_m0 }
}

/// Tension of the section less the holes of a row in its flanges,
/// `N_u,Rd = 0.9 A_net f_u/γ_M2` with A_net = A − n_h d0 t_f.
///
/// # Source
/// EN 1993-1-1:2005 6.2.3(2)b.
fn net_tension(e: &EndPlate, c: &ColumnSide) -> Worked {
    let mut ends: Vec<&str> = e.actions.iter().map(|a| a.end.as_str()).collect();
    ends.sort_unstable();
    ends.dedup();
    // a beam on either side has holes in both flanges
    let holes = (ends.len().max(1) * e.columns().len()) as f64;
    let holes = Traced::number("n_h", holes) * Traced::length("d0", e.hole);
    let net = Traced::area("A", 1e2 * c.section.area) - holes * Traced::length("t_f", c.section.tf);
    let (f_u, gamma) = (Traced::stress("f_u", c.steel.fu.mpa()), e.factors.gamma_m2);
    let value = Traced::from(0.9) * net * f_u / Traced::number("γ_M2", gamma);
    let id = CheckId::ColumnNetTension;
    Worked::of("EN 1993-1-1:2005 6.2.3(2)b", id, "N_u,Rd", value, Unit::Force)
}

/// What the beams bring into a column that continues both ways. Its share above and below is not
/// known, so that nothing is checked, unless the least share is too much already.
fn not_known(e: &EndPlate, c: &ColumnSide, f: &ColumnForces) -> Option<Check> {
    let worked = cross_section(e, c).bending_6_2_10(0.0, 0.0).ok()?;
    if !within(f.moment, worked.value) {
        // the last of the section's checks is that of the moment
        return section(e, c, f).pop();
    }
    let id = CheckId::ColumnNotChecked;
    let most = if let Moment::NotGiven { most } = f.known { most } else { 0.0 };
    let formula = say!(
        "the column continues both ways, and the spec gives no N_Ed and M_Ed of it: its share of \
         the moment {} at the node is not known (one half would be {} of M_c,Rd); members.column \
         takes N_Ed, M_Ed and V_Ed",
        Unit::Moment.show(most),
        n(f.moment / worked.value)
    );
    Some(Check::assumption(Topic::Member, SUBJECT, CLAUSE, id, formula))
}
