//! Actions on a member at the splice axis, and the least ones of a column splice.

use super::side::{Side, sides};
use crate::check::{Check, CheckId, Status, Topic, Unit, within};
use crate::error::CheckError;
use crate::formula::{Derivation, Formula, Traced};
use crate::subject::{Part, Subject};
use bracket_base::say;
use bracket_joint::assembly::{CoverSplice, PlaneActions, SpliceUse};

/// Clause of the least forces without contact.
const NO_CONTACT: &str = "EN 1993-1-8:2005 6.2.7.1(13)";
/// Clause of the least forces with contact.
pub(super) const CONTACT: &str = "EN 1993-1-8:2005 6.2.7.1(14)";
/// Share of the moment resistance, 6.2.7.1(13).
const LEAST_MOMENT: f64 = 0.25;
/// Share of the axial resistance that is the least shear force, 6.2.7.1(13).
const LEAST_SHEAR: f64 = 0.025;
/// Share of the compression that covers transfer beside contact, 6.2.7.1(14).
pub(super) const BESIDE_CONTACT: f64 = 0.25;
/// Largest gap of ends in contact \[mm\]. Source: EN 1090-2:2008 Table D.2.7, gap between
/// bearing surfaces of members, rounded down from 1 mm at single places.
const CLOSED: f64 = 0.5;

/// Actions on a member at the splice axis, about its own axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Demand {
    /// N, tension positive \[N\].
    pub axial: f64,
    /// V along the web, without its sign \[N\].
    pub shear: f64,
    /// My, positive: tension at the top \[N mm\].
    pub moment: f64,
}

/// Least moment \[N mm\] and shear force \[N\] of a column splice without contact.
struct Least {
    moment: Formula,
    shear: Formula,
}

/// M_c,Rd of the weaker section \[N mm\]; an error for one of class 4.
fn weaker_moment(e: &CoverSplice) -> Result<f64, CheckError> {
    let of = |side: &Side<'_>| side.cross_section(e.factors.gamma_m0).bending_6_2_10(0.0, 0.0);
    let all = sides(e);
    all.iter().try_fold(f64::INFINITY, |least, side| Ok(least.min(of(side)?.value)))
}

/// N_pl,Rd of the weaker section \[N\].
fn weaker_axial(e: &CoverSplice) -> f64 {
    let of = |side: &Side<'_>| side.cross_section(e.factors.gamma_m0).axial().value;
    sides(e).iter().map(of).fold(f64::INFINITY, f64::min)
}

/// The least forces; `None` where the code has none.
fn least(e: &CoverSplice) -> Option<Result<Least, CheckError>> {
    (e.used == SpliceUse::Column { contact: false }).then(|| {
        let moment = Traced::symbol("M_c,Rd", weaker_moment(e)?, Unit::Moment);
        let axial = Traced::force("N_pl,Rd", weaker_axial(e));
        let moment = Traced::from(LEAST_MOMENT) * moment;
        Ok(Least {
            moment: Formula::new("M_min", moment, Unit::Moment),
            shear: Formula::new("V_min", Traced::from(LEAST_SHEAR) * axial, Unit::Force),
        })
    })
}

/// The actions of a load case on a member; more than one where the least moment acts in either
/// sense.
///
/// # Source
/// EN 1993-1-8:2005 6.2.7.1(13).
pub(super) fn demands(e: &CoverSplice, a: &PlaneActions, side: &Side<'_>) -> Vec<Demand> {
    let [[axial, _, vz], [_, my, _]] = a.at(1.0);
    let (mut shear, mut moments) = (vz.abs(), vec![my]);
    if let Some(Ok(least)) = least(e).filter(|_| a.state.is_ultimate()) {
        shear = shear.max(least.shear.value);
        if my.abs() < least.moment.value {
            moments = vec![least.moment.value, -least.moment.value];
        }
    }
    // the axial force acts beside the member's own axis
    let about_axis = |my: f64| my - axial * side.member.axis;
    moments.iter().map(|my| Demand { axial, shear, moment: about_axis(*my) }).collect()
}

/// What a column splice must carry at least, and what it leaves undecided.
pub(super) fn checks(e: &CoverSplice, a: &PlaneActions) -> Vec<Check> {
    let (topic, subject) = (Topic::Member, Subject::end(&a.end).and(Part::Joint));
    match e.used {
        SpliceUse::Beam => Vec::new(),
        SpliceUse::Column { contact: true } => contact(e, a, &subject),
        SpliceUse::Column { contact: false } => {
            let mut out = Vec::new();
            match least(e) {
                Some(Ok(least)) => {
                    let words = "covers and bolts carry no less than these forces; the actions \
                                 must hold the moments of imperfections and of second order";
                    let words = Derivation::from(least.moment).then(least.shear).then(words);
                    let id = CheckId::SpliceLeastForces;
                    out.push(Check::assumption(topic, subject.clone(), NO_CONTACT, id, words));
                }
                Some(Err(fault)) => {
                    let id = CheckId::SpliceLeastForces;
                    let (why, step) = (fault.text(), fault.step());
                    out.push(Check::undecided(topic, subject.clone(), NO_CONTACT, id, why, step));
                }
                None => {}
            }
            let why = "the code asks for 25 % of M_c,Rd about the weak axis and 2.5 % of N_pl,Rd \
                       across the web as well, for which these checks have no formula";
            let step = "ends prepared for contact, or a check of the covers about the weak axis";
            let id = CheckId::SpliceWeakAxis;
            let check = Check::undecided(topic, subject, NO_CONTACT, id, why, step);
            out.push(check.without_method());
            out
        }
    }
}

/// Ends in contact: what the covers carry, and whether the ends meet.
fn contact(e: &CoverSplice, a: &PlaneActions, subject: &Subject) -> Vec<Check> {
    let (topic, id) = (Topic::Member, CheckId::SpliceContact);
    let push = (-a.at(1.0)[0][0]).max(0.0);
    let least = Traced::from(BESIDE_CONTACT) * Traced::force("N_Ed", push);
    let words = "the ends transfer the compression of flanges and web by contact; covers and \
                 bolts carry the tension, the shear force, the moment of the web and this part \
                 of the compression";
    let words = Derivation::from(Formula::new("N_min", least, Unit::Force)).then(words);
    let mut out = vec![Check::assumption(topic, subject.clone(), CONTACT, id, words)];
    let what = (CONTACT, id);
    let limit = Traced::from(CLOSED);
    let open = Check::at_most((topic, subject.clone()), what, "g", limit, e.gap, Status::Failed);
    out.extend((open.status != Status::Ok).then_some(open));
    let (l, r) = (&e.left, &e.right);
    let depth = |axis: f64, h: f64| [axis - 0.5 * h, axis + 0.5 * h];
    let same = |x: f64, y: f64| within((x - y).abs(), CLOSED);
    let [one, other] = [depth(l.axis, l.section.h), depth(r.axis, r.section.h)];
    if !(same(one[0], other[0]) && same(one[1], other[1])) {
        let why = say!(
            "the flanges of {} and {} do not meet: what spreads the force between them is not \
             checked",
            &l.section.name,
            &r.section.name
        );
        let step = "members of one depth, or ends without contact";
        out.push(Check::undecided(topic, subject.clone(), CONTACT, id, why, step));
    }
    out
}
