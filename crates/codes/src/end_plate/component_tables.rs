//! Component method for each sense of bending: its tables, the welds that must not limit the joint,
//! and the parts on which its rotation capacity depends.

use super::at_plate;
use super::capacity::Capacity;
use super::component_joint::component_joint;
use super::doubler::doubler_fault;
use super::hand_checks::HandChecks;
use super::method_record::MethodRecord;
use super::rotation_rules::SenseLimits;
use super::sense;
use super::weld_checks;
use crate::check::{Check, CheckId, Status, Topic, Unit};
use crate::component_method::assembly::RowForce;
use crate::component_method::rows::Component;
use crate::component_method::stiffness::{Joins, for_elastic_analysis};
use crate::component_method::{Assessment, LimitedBy, assess};
use crate::ductility::panel_in_shear;
use crate::eurocode::i_section::Section;
use crate::formula::{Derivation, Number, Traced};
use crate::subject::{Part, Place, Sense, Subject};
use crate::worked::Worked;
use bracket_base::say;
use bracket_base::words::Text;
use bracket_joint::assembly::EndPlate;

/// Adds the tables of each sense of bending and β. Returns the parts that limit the joint in each
/// sense; a sense that the tables of the code do not cover becomes a note.
pub(super) fn senses(e: &EndPlate, out: &mut HandChecks) -> Vec<SenseLimits> {
    let (mut limits, all) = (Vec::new(), sense::senses(e));
    for &(sense, beta) in &all {
        let joint = component_joint(e, beta).turned(sense);
        let assessment = match assess(&joint) {
            Ok(assessment) => assessment,
            Err(fault) => {
                let note = say!("component method, {}: {}", sense.words(), fault.text());
                out.notes.push(note);
                continue;
            }
        };
        let several = all.iter().filter(|s| s.0 == sense).count() > 1;
        let subject = Subject::from(sense);
        let subject = if several { subject.and(Place::Beta(beta)) } else { subject };
        out.checks.extend(tables(e, &subject, sense, &assessment));
        let bends = sense::bent(e).contains(&(sense, beta));
        let method = MethodRecord::new(subject.text(), bends, sense, &joint, &assessment);
        out.capacities.push(Capacity::Moment(method));
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
fn panel(e: &EndPlate, subject: &Subject, a: &Assessment) -> Option<Check> {
    let c = e.column.as_ref().filter(|_| a.shear_governs())?;
    let subject = Subject::from(Part::Panel).and(subject.clone());
    let clear = Section::from(&c.section).clear_depth();
    Some(panel_in_shear(subject, clear, c.section.tw, c.steel.fy.mpa()))
}

/// Notes on the parts that the component method leaves out, on the safe side.
pub(super) fn left_out(e: &EndPlate) -> Vec<Text> {
    let mut out = Vec::new();
    if e.rib > 0.0 {
        out.push(
            "component method: the rib is left out, on the safe side (EN 1993-1-8 has no formula \
             for it)"
                .into(),
        );
    }
    if at_plate::haunch(e).is_some() {
        out.push(
            "component method: the flange of the beam between its web and that of the haunch does \
             not stiffen the end plate, on the safe side"
                .into(),
        );
    }
    if let Some(c) = e.column.as_ref().filter(|c| c.doubler > 0.0) {
        out.extend(
            doubler_fault(c)
                .map(|why| say!("component method: the web doubler is left out: {}", why)),
        );
    }
    out
}

/// Rows, limits, moment resistance and stiffness for one sense of bending.
fn tables(e: &EndPlate, subject: &Subject, sense: Sense, a: &Assessment) -> Vec<Check> {
    let topic = Topic::ComponentMethod;
    let mut out = Vec::new();
    for (r, row) in a.rows.iter().enumerate() {
        let place = Place::Row { number: r + 1, z: sense.z(row.z) };
        // the formula shows the numbers of the component that limits the row
        let alone = |kind| row.alone.iter().find(|c| c.kind == kind);
        let group = |kind, first| {
            let mut groups = row.groups.iter().filter(|g| g.first == first).map(|g| &g.component);
            groups.find(|c| c.kind == kind)
        };
        let (shown, grouped) = match row.limited_by {
            LimitedBy::Row(kind) => (alone(kind), false),
            LimitedBy::Group { component, rows: [first, _] } => (group(component, first), true),
            LimitedBy::Elastic(_) | LimitedBy::Sum(_) => (None, false),
        };
        let before = Derivation::from(say!("F_tr,Rd, limited by {}", row.limited_by.text()));
        let before = match shown {
            Some(c) if grouped => {
                before.followed_by(c.worked.derivation.clone()).then("less the rows above")
            }
            Some(c) => before.followed_by(c.worked.derivation.clone()),
            None if of_sum(row) => before.then("what is left of the sum"),
            None => before,
        };
        let mut force = Worked::of(
            "EN 1993-1-8:2005 6.2.7.2",
            CheckId::RowTension,
            "F_tr,Rd",
            row_force(a, r, shown),
            Unit::Force,
        )
        .after(before)
        .with("h_r", row.lever, Unit::Length);
        for c in &row.alone {
            force = force.with(say!("{} alone", c.kind.words()), c.worked.value, Unit::Force);
        }
        force = force.with("after groups", row.grouped, Unit::Force);
        // m, n, effective lengths and modes of that component
        force.steps.extend(shown.into_iter().flat_map(|c| c.worked.steps.iter().cloned()));
        out.push(force.information(topic, subject.clone().and(place)));
    }
    out.extend(a.limits.iter().map(|l| l.worked.clone().information(topic, subject.clone())));
    out.push(a.moment.clone().information(topic, subject.clone()));
    let (joint, beam) = (a.moment.value, a.beam_moment.value);
    let share = Traced::symbol("M_j,Rd", joint, Unit::Moment)
        / Traced::symbol("M_c,Rd", beam, Unit::Moment);
    let id = CheckId::StrengthBesideBeam;
    let share = Worked::of("EN 1993-1-8:2005 5.2.3", id, "M_j,Rd/M_c,Rd", share, Unit::Number);
    out.push(share.information(topic, subject.clone()));
    let initial = &a.stiffness.initial;
    out.push(initial.clone().information(Topic::Stiffness, subject.clone()));
    let joins = if e.column.is_some() { Joins::BeamToColumn } else { Joins::Other };
    out.push(
        for_elastic_analysis(initial.value, joins).information(Topic::Stiffness, subject.clone()),
    );
    out
}

/// Whether a row has what the components in compression and shear leave of the sum.
fn of_sum(row: &RowForce) -> bool {
    matches!(row.limited_by, LimitedBy::Sum(_))
}

/// The force of a row by the formula of what limits it; a symbol of its own where several limits
/// are equal but for rounding.
fn row_force(a: &Assessment, r: usize, shown: Option<&Component>) -> Traced {
    let row = &a.rows[r];
    let above =
        |x: usize, force: f64| Traced::force(Text::given(format!("F_t{},Rd", x + 1)), force);
    let grouped = |x: usize| above(x, a.rows[x].grouped);
    let alone = shown.map(|c| c.worked.traced());
    let group = row.groups.iter().find(|g| shown.is_some_and(|c| std::ptr::eq(c, &g.component)));
    let found = match (alone, group) {
        (Some(all), Some(g)) => (g.first..r).map(grouped).reduce(|a, b| a + b).map(|sum| all - sum),
        (Some(alone), None) => Some(alone),
        (None, _) if !of_sum(row) => {
            let h = Traced::length("h_r", row.lever);
            let of = |x: usize| {
                let symbol = Text::given(format!("h_{}", x + 1));
                let lever = Traced::length(symbol, a.rows[x].lever);
                grouped(x) * h.clone() / lever
            };
            (0..r).map(of).find(|force| force.value() == row.force)
        }
        (None, _) => {
            let least = a.limits.iter().map(|l| &l.worked);
            let least = least.min_by(|a, b| a.value.total_cmp(&b.value));
            least.map(|l| (0..r).fold(l.traced(), |left, x| left - above(x, a.rows[x].force)))
        }
    };
    let positive = |f: Traced| if f.value() < 0.0 { f.max(Traced::from(0.0)) } else { f };
    let same = found.map(positive).filter(|f| f.value() == row.force);
    same.unwrap_or_else(|| Traced::force("F_tr,Rd", row.force))
}
