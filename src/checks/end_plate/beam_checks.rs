//! The beam's own cross-section under the actions at the joint.

use crate::assembly::{EndPlate, PlaneActions};
use crate::checks::check::{Check, Status, Topic, Unit, number as n};
use crate::checks::eurocode::i_section::Section;
use crate::checks::eurocode::section::{CrossSection, plastic_shear};
use crate::checks::worked::Worked;

/// Shear, axial force and moment of the beam at the bolt plane. They bind: a beam that cannot carry
/// these forces cannot load the joint with them.
///
/// # Source
/// EN 1993-1-1:2005 6.2.
pub(super) fn beam(e: &EndPlate, a: &PlaneActions) -> Vec<Check> {
    let [[axial, vy, vz], [_, my, _]] = a.at(1.0);
    let beam = CrossSection {
        section: (&e.beam).into(),
        fy: e.beam_steel.fy,
        gamma_m0: e.factors.gamma_m0,
    };
    let subject = format!("{}, beam", a.end);
    let against = |worked: Worked, demand: f64| {
        worked.against(Topic::Member, subject.clone(), demand.abs(), Status::Failed)
    };
    let mut out = Vec::new();
    if vz != 0.0 {
        out.push(against(beam.shear(), vz));
        let (slenderness, limit) = beam.web_slenderness();
        if slenderness > limit {
            let worked = beam.shear_buckling(e.factors.gamma_m1);
            out.push(worked.against(Topic::Stability, subject.clone(), vz.abs(), Status::Failed));
        }
    }
    if vy != 0.0 {
        out.push(against(beam.shear_across(), vy));
    }
    if axial != 0.0 {
        out.push(against(beam.axial(), axial));
    }
    // compression alone can be too much for a slender web
    if my != 0.0 || axial < 0.0 {
        match beam.bending_6_2_10(vz, axial) {
            Ok(worked) => out.push(against(worked, my)),
            // class 4
            Err(fault) => {
                let (clause, title) =
                    ("EN 1993-1-1:2005 5.5.2", "moment of the beam with its shear and axial force");
                out.push(Check::undecided(
                    Topic::Member,
                    subject,
                    clause,
                    title,
                    fault.to_string(),
                ));
            }
        }
    }
    out
}

/// Note on actions that exceed the resistance of the beam itself: most likely a wrong number or
/// unit.
pub(super) fn beyond_the_beam(e: &EndPlate, a: &PlaneActions) -> Option<String> {
    let [[axial, vy, vz], [_, my, _]] = a.at(1.0);
    let section = Section::from(&e.beam);
    let fyd = e.beam_steel.fy / e.factors.gamma_m0;
    let moment = (my.abs(), section.w_pl * fyd, "My", "M_pl,Rd", Unit::Moment);
    let normal = (axial.abs(), section.area * fyd, "N", "N_pl,Rd", Unit::Force);
    let shear = (
        vy.hypot(vz),
        plastic_shear(section.shear_area(), e.beam_steel.fy, e.factors.gamma_m0),
        "V",
        "V_pl,Rd",
        Unit::Force,
    );
    let worst =
        [moment, normal, shear].into_iter().max_by(|a, b| (a.0 / a.1).total_cmp(&(b.0 / b.1)))?;
    let (demand, capacity, action, resistance, unit) = worst;
    (demand > capacity).then(|| {
        format!(
            "{action} = {} is {} times {resistance} = {} of the beam {}: check the number and its \
             unit",
            unit.show(demand),
            n(demand / capacity),
            unit.show(capacity),
            e.beam.name
        )
    })
}
