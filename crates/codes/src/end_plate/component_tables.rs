//! Component method for each sense of bending: its tables, the welds that must not limit the joint,
//! and the parts on which its rotation capacity depends.

use super::component_joint::component_joint;
use super::doubler::doubler_fault;
use super::hand_checks::HandChecks;
use super::method_record::MethodRecord;
use super::rotation_rules::SenseLimits;
use super::sense::{self, Sense};
use super::weld_checks;
use crate::check::{Check, Status, Topic, Unit, number as n};
use crate::component_method::rows::Component;
use crate::component_method::stiffness::{Joins, for_elastic_analysis};
use crate::component_method::{Assessment, assess};
use crate::ductility::panel_in_shear;
use crate::eurocode::i_section::Section;
use crate::worked::Worked;
use bracket_joint::assembly::EndPlate;

/// Adds the tables of each sense of bending and β. Returns the parts that limit the joint in each
/// sense; a sense that the tables of the code do not cover becomes a note.
pub(super) fn senses(e: &EndPlate, out: &mut HandChecks) -> Vec<SenseLimits> {
    let (mut limits, all) = (Vec::new(), sense::senses(e));
    for &(sense, beta) in &all {
        let joint = sense.of(&component_joint(e, beta));
        let assessment = match assess(&joint) {
            Ok(assessment) => assessment,
            Err(fault) => {
                out.notes.push(format!("component method, {}: {fault}", sense.words()));
                continue;
            }
        };
        let several = all.iter().filter(|s| s.0 == sense).count() > 1;
        let subject = if several {
            format!("{}, β = {}", sense.words(), n(beta))
        } else {
            sense.words().into()
        };
        out.checks.extend(tables(e, &subject, sense, &assessment));
        let bends = sense::bent(e).contains(&(sense, beta));
        out.methods.push(MethodRecord::new(&subject, bends, sense, &joint, &assessment));
        out.checks.extend(weld_checks::not_the_weakest(e, &subject, sense, &assessment));
        let panel = panel(e, &subject, &assessment);
        let bending = assessment.rows.iter().filter_map(|r| r.bending_of()).collect();
        let panel_turns = panel.as_ref().is_some_and(|rule| rule.status == Status::Ok);
        limits.push(SenseLimits { sense, bending, panel_turns });
        out.checks.extend(panel);
    }
    limits
}

/// Rotation capacity of the web panel where it limits the joint in shear.
fn panel(e: &EndPlate, subject: &str, a: &Assessment) -> Option<Check> {
    let c = e.column.as_ref().filter(|_| a.shear_governs())?;
    let subject = format!("column web panel, {subject}");
    let clear = Section::from(&c.section).clear_depth();
    Some(panel_in_shear(&subject, clear, c.section.tw, c.steel.fy.mpa()))
}

/// Notes on the parts that the component method leaves out, on the safe side.
pub(super) fn left_out(e: &EndPlate) -> Vec<String> {
    let mut out = Vec::new();
    if e.rib > 0.0 {
        out.push(
            "component method: the rib is left out, on the safe side (EN 1993-1-8 has no formula \
             for it)"
                .into(),
        );
    }
    if let Some(c) = e.column.as_ref().filter(|c| c.doubler > 0.0) {
        out.extend(
            doubler_fault(c)
                .map(|why| format!("component method: the web doubler is left out: {why}")),
        );
    }
    out
}

/// Rows, limits, moment resistance and stiffness for one sense of bending.
fn tables(e: &EndPlate, subject: &str, sense: Sense, a: &Assessment) -> Vec<Check> {
    let topic = Topic::ComponentMethod;
    let mut out = Vec::new();
    for (r, row) in a.rows.iter().enumerate() {
        let row_subject = format!("{subject}, row {} at z = {} mm", r + 1, n(sense.z(row.z)));
        // the formula shows the numbers of the component that limits the row
        let name = row.limited_by.split(',').next().unwrap_or_default();
        let of = |c: &&Component| c.name == name;
        let groups = row.groups.iter().map(|g| &g.component);
        let shown = if row.limited_by.contains("rows") {
            groups.rev().find(of)
        } else {
            row.alone.iter().find(of)
        };
        let formula = match shown {
            Some(c) if row.limited_by.contains("rows") => {
                format!("{} less the rows above", c.worked.formula)
            }
            Some(c) => c.worked.formula.clone(),
            None => "what is left of the sum".into(),
        };
        let mut force = Worked::new(
            "EN 1993-1-8:2005 6.2.7.2",
            "tension resistance of a row",
            row.force,
            Unit::Force,
            format!("F_tr,Rd, limited by {}: {formula}; F_tr,Rd", row.limited_by),
        )
        .with("h_r", row.lever, Unit::Length);
        for c in &row.alone {
            force = force.with(&format!("{} alone", c.name), c.worked.value, Unit::Force);
        }
        force = force.with("after groups", row.grouped, Unit::Force);
        // m, n, effective lengths and modes of that component
        force.steps.extend(shown.into_iter().flat_map(|c| c.worked.steps.iter().cloned()));
        out.push(force.information(topic, row_subject));
    }
    out.extend(a.limits.iter().map(|l| l.worked.clone().information(topic, subject)));
    out.push(a.moment.clone().information(topic, subject));
    let (joint, beam) = (a.moment.value, a.beam_moment.value);
    let formula =
        format!("M_j,Rd/M_c,Rd = {}/{}", Unit::Moment.show(joint), Unit::Moment.show(beam));
    let share = Worked::new(
        "EN 1993-1-8:2005 5.2.3",
        "strength against that of the beam",
        joint / beam,
        Unit::Number,
        formula,
    );
    out.push(share.information(topic, subject));
    let initial = &a.stiffness.initial;
    out.push(initial.clone().information(Topic::Stiffness, subject));
    let joins = if e.column.is_some() { Joins::BeamToColumn } else { Joins::Other };
    out.push(for_elastic_analysis(initial.value, joins).information(Topic::Stiffness, subject));
    out
}
