//! Checks of the joint as a whole under a load case: moment and axial force, components that may
//! buckle, the column web panel.

use super::column_forces::PanelShear;
use super::comparison::largest_multiple;
use super::member_end::{LoadedEnd, MemberEnd};
use super::transformation::other_ends;
use crate::check::{Check, CheckId, Status, Topic, Unit, within};
use crate::component_method::Summed;
use crate::formula::Traced;
use crate::worked::Worked;

/// Moment and axial force against the resistance of the joint.
pub(super) fn moment_and_axial(loaded: &LoadedEnd<'_>) -> Check {
    let (end, method, topic) = (loaded.end, loaded.method, Topic::ComponentMethod);
    let Some(mut check) = method.share(end.a.at(1.0)) else {
        let (clause, id) = ("EN 1993-1-8:2005 6.2.7.1", CheckId::MomentAndAxial);
        let why = "no plastic equilibrium of the rows with an axial force beyond 5 % of \
                   N_pl,Rd is covered";
        let step = "a smaller axial force, or rows that the equilibrium covers";
        let open = Check::undecided(topic, end.subject(), clause, id, why, step);
        return open.of_strength();
    };
    check = check.with("M_j,Rd", method.moment, Unit::Moment);
    if let Some(e) = &method.equilibrium {
        check = check.with("N_j,Rd in tension", e.tension, Unit::Force);
        check = check.with("N_j,Rd in compression", e.compression, Unit::Force);
    }
    if end.e.column.is_some() {
        check = check.with("β", method.beta, Unit::Number);
    }
    let at = end.a.at(1.0);
    let (axial, my) = (at[0][0].abs(), at[1][1].abs());
    let bending = my / method.moment;
    let used = check.value;
    let mut check = check.utilised(topic, end.subject(), Status::Failed).of_strength();
    // a moment against the one that the joint carries beside the axial force; an axial force that
    // uses more of its own resistance stands in place of it
    let alone = used > bending && method.with_axial(at).is_none();
    (check.demand, check.resistance, check.unit) = match (my > 0.0 && !alone, used > bending) {
        (true, false) => (Some(my), Some(method.moment), Unit::Moment),
        (true, true) => (Some(my), Some(my / used), Unit::Moment),
        _ if axial > 0.0 && used > 0.0 => (Some(axial), Some(axial / used), Unit::Force),
        _ => (Some(my), Some(method.moment), Unit::Moment),
    };
    check
}

/// A small axial force that the code leaves out beside the moment, where the plastic equilibrium of
/// the rows does not carry both: a warning. `None` where it does, or where the force counts anyway.
///
/// # Source
/// EN 1993-1-8:2005 6.2.7.1(2).
pub(super) fn left_out_axial(loaded: &LoadedEnd<'_>) -> Option<Check> {
    let (end, method) = (loaded.end, loaded.method);
    let at = end.a.at(1.0);
    let (axial, my) = (at[0][0], at[1][1]);
    let equilibrium = method.equilibrium.as_ref().filter(|_| axial != 0.0)?;
    if method.with_axial(at).is_some() {
        return None;
    }
    let carried = equilibrium.at(axial, my).filter(|c| c.factor > 0.0)?;
    let before = largest_multiple(my, axial).then("6.2.7.1(2) leaves N_Ed ≤ 0.05 N_pl,Rd out");
    let id = CheckId::AxialLeftOut;
    let together = Traced::from(1.0) / Traced::number("α", carried.factor);
    let worked =
        Worked::of("EN 1993-1-8:2005 6.2.7.1(2)", id, "1/α", together, Unit::Number).after(before);
    let check = worked.utilised(Topic::ComponentMethod, end.subject(), Status::Warning);
    let check = check.of_strength();
    (check.status == Status::Warning).then_some(check)
}

/// Components that may buckle: the compressed column web against its reduced resistance. Where the
/// code gives no resistance the check is undecided.
pub(super) fn stability(loaded: &LoadedEnd<'_>) -> Vec<Check> {
    let (end, method, push) = (loaded.end, loaded.method, loaded.push);
    let mut out = Vec::new();
    for s in &end.assessment.stability {
        let web = end.assessment.limit(Summed::ColumnWeb).filter(|_| s.covered);
        let Some(web) = web else {
            let id = CheckId::Unseen;
            let open = Check::undecided(
                Topic::Stability,
                end.subject(),
                s.clause,
                id,
                s.why.clone(),
                s.step,
            );
            out.push(open.without_method());
            continue;
        };
        let mut worked = web.clone();
        worked.id = CheckId::ColumnWebBuckling;
        worked = worked.after(s.why.clone());
        out.push(worked.against(Topic::Stability, end.subject(), push, Status::Failed));
    }
    let axial = end.a.at(1.0)[0][0];
    let buckling = method.equilibrium.as_ref().filter(|_| axial < 0.0);
    if let Some((e, why)) = buckling.and_then(|e| Some((e, e.buckles.as_ref()?))) {
        let why = why.clone().then("N_j,Rd by the plastic equilibrium of the joint");
        let id = CheckId::AxialBuckling;
        let resistance = Traced::force("N_j,Rd", e.compression);
        let worked = Worked::of("EN 1993-1-8:2005 6.2.6.2", id, "N_j,Rd", resistance, Unit::Force)
            .after(why);
        out.push(worked.against(Topic::Stability, end.subject(), -axial, Status::Failed));
    }
    out
}

/// The web panel of the column, once in a load case: at the end with the larger moment.
pub(super) fn panel(end: &MemberEnd<'_>) -> Option<Check> {
    let resistance = end.assessment.panel.clone()?;
    let own = end.a.at(1.0)[1][1];
    let mut other = 0.0;
    for o in other_ends(end.e, end.a) {
        let m = o.at(1.0)[1][1];
        other += m;
        let (larger, less) = (!within(m.abs(), own.abs()), !within(own.abs(), m.abs()));
        if larger || (!less && o.end < end.a.end) {
            return None;
        }
    }
    let shear = PanelShear::new(end.e, end.a, other, end.assessment.stiffness.lever);
    // equal moments of two beams, and no shear of the column
    if end.joint.beta == 0.0 && shear.demand == 0.0 {
        return None;
    }
    let mut check = resistance.after(shear.derivation);
    check.id = shear.id;
    check.clause = "EN 1993-1-8:2005 5.3(3), 6.2.6.1";
    let (topic, of) = (Topic::ComponentMethod, end.subject());
    Some(check.against(topic, of, shear.demand, Status::Failed).of_strength())
}
