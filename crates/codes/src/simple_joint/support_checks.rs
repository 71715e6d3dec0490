//! The element of the support under the forces of a simple joint.

use super::plies::support_part;
use crate::check::{Check, CheckId, Status, Topic, Unit};
use crate::eurocode::yielding::{plastic, plastic_shear};
use crate::formula::Traced;
use crate::subject::{Part, Subject};
use crate::worked::Worked;
use bracket_joint::assembly::{PlaneActions, SimpleJoint, SimpleKind, SupportElement};

/// Whether the plate stands on a web, which bends out of its plane.
fn on_web(e: &SimpleJoint) -> bool {
    matches!(e.support.element, SupportElement::ColumnWeb | SupportElement::BeamWeb)
}

/// Whether a fin plate yields before it punches through the web that it stands on; `None` for
/// another support. The rule suffices, so that a thicker plate stays undecided.
///
/// `t_p ≤ t_w f_u/(f_y,p γ_M2)`.
///
/// # Source
/// NCCI SN017, 14; Steelwork Building 15.2.3 f. The column flange has no such mode.
pub(super) fn punching(e: &SimpleJoint) -> Option<Check> {
    (e.kind == SimpleKind::FinPlate && on_web(e)).then(|| {
        let ratio = Traced::stress("f_u", e.support.steel.fu.mpa())
            / (Traced::stress("f_y,p", e.plate_steel.fy.mpa())
                * Traced::number("γ_M2", e.factors.gamma_m2));
        let limit = Traced::length("t_w", e.support.thickness()) * ratio;
        let what = ("NCCI SN017, 14", CheckId::SupportPunching);
        let of = (Topic::Member, support_part(e));
        let step = "a thinner fin plate, or a support with a thicker web";
        Check::at_most(of, what, "t_p", limit, e.thickness, Status::Undecided).decided_by(step)
    })
}

/// Local shear of the web that a fin plate stands on, on either side of it; tension of the support.
///
/// # Source
/// Steel Buildings in Europe, Part 5, 3.2, and SCI P358: `V_Ed/2 ≤ h_p t_w f_y/(√3 γ_M0)`, beside a
/// plate on one side of the web. EN 1993-1-8:2005 6.2.6.3, without spread of the force, for the web
/// of a column behind its flange.
pub(super) fn under_load(e: &SimpleJoint, a: &PlaneActions) -> Vec<Check> {
    let [axial, _, vz] = a.at(1.0)[0];
    let place = |part: Part| Subject::end(&a.end).and(part);
    let f_y = || Traced::stress("f_y", e.support.steel.fy.mpa());
    let gamma = || Traced::number("γ_M0", e.factors.gamma_m0);
    let area = |t: f64| Traced::length("h_p", e.height()) * Traced::length("t_w", t);
    let mut out = Vec::new();
    if e.kind == SimpleKind::FinPlate && on_web(e) && vz != 0.0 {
        let faces = Traced::from(2.0) * area(e.support.thickness());
        let value = plastic_shear(faces, f_y(), gamma());
        let (clause, id) = ("Steel Buildings in Europe 5, 3.2; SCI P358", CheckId::SupportShear);
        let worked = Worked::of(clause, id, "V_Rd", value, Unit::Force);
        let part = place(support_part(e));
        out.push(worked.against(Topic::Member, part, vz.abs(), Status::Failed).of_strength());
    }
    if axial <= 0.0 {
        return out;
    }
    let id = CheckId::SupportTension;
    if e.kind == SimpleKind::FinPlate && e.support.element == SupportElement::ColumnFlange {
        let value = plastic(area(e.support.section.tw), f_y(), gamma());
        let clause = "EN 1993-1-8:2005 6.2.6.3";
        let worked = Worked::of(clause, id, "F_t,wc,Rd", value, Unit::Force);
        let part = place(Part::ColumnWeb);
        out.push(worked.against(Topic::Member, part, axial, Status::Failed).of_strength());
        return out;
    }
    let why = match e.kind {
        SimpleKind::FinPlate => "the plate bends the web out of its plane",
        SimpleKind::HeaderPlate => "the bolts bend the support out of its plane",
    };
    let step = "a limit analysis (`kind: limit`)";
    let clause = "EN 1993-1-8:2005 6.2.6";
    let part = place(support_part(e));
    let check = Check::undecided(Topic::Member, part, clause, id, why, step);
    out.push(check.without_method());
    out
}
