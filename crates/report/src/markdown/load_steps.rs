//! The load steps of a case.

use crate::document::Doc;
use crate::document::table::{Table, dash};
use crate::figures::{Rounding, bracket, significant};
use crate::result::case_result::CaseResult;
use crate::result::load_step::LoadStep;
use crate::result::quantity::LoadSize;
use bracket_base::diag::number;
use bracket_base::math::vec3;
use bracket_base::say;
use bracket_base::words::Text;

/// A table of the steps.
pub(crate) fn section(doc: &mut Doc, case: &CaseResult) {
    let Some(first) = case.load_steps.first() else { return };
    doc.heading(say!("Load steps of {}", &case.name));
    doc.paragraph(
        "Every step is an analysis of its own at that factor of the live loads, by Hencky's law, \
         with the closures of preloaded bolts of the case. The energies are bounds. The bracket \
         of the load's own motion (the rotation of a moment, the displacement of a force, members \
         included) follows from the energies of all steps and is certified; it is wide where the \
         steps are far apart, and the last step has no upper end. Rotation and displacement of \
         the loaded end and the forces of bolts are estimates.",
    );
    let (load, unit, scale) = match first.load {
        Some(LoadSize::Moment(_)) => ("moment [kN m]", "rotation of the load [mrad]", 1e3),
        _ => ("force [kN]", "displacement of the load [mm]", 1.0),
    };
    let columns = Table::columns([
        "load factor",
        load,
        "energy, lower bound [N mm]",
        "energy, upper bound [N mm]",
        unit,
        "end turns [mrad]",
        "end moves [mm]",
        "largest bolt force [kN]",
    ]);
    let rows = case.load_steps.iter().map(|s| row(s, scale)).collect();
    doc.table(&Table { columns, rows });
}

fn row(step: &LoadStep, scale: f64) -> Vec<Text> {
    let shown = |x: Option<f64>, digits: i32, rounding: Rounding| {
        x.map_or_else(dash, |x| Text::given(significant(x, digits, rounding)))
    };
    let load = step.load.map(|load| match load {
        LoadSize::Force(v) => 1e-3 * v,
        LoadSize::Moment(v) => 1e-6 * v,
    });
    let own = match (step.load_displacement_at_least, step.load_displacement_at_most) {
        (Some(low), Some(high)) => {
            let (a, b) = bracket(scale * low, scale * high, 3);
            say!("{} to {}", a, b)
        }
        (Some(low), None) => say!("at least {}", significant(scale * low, 3, Rounding::Down)),
        (None, Some(high)) => say!("at most {}", significant(scale * high, 3, Rounding::Up)),
        (None, None) => dash(),
    };
    let nearest = Rounding::Nearest;
    vec![
        Text::given(number(step.factor)),
        shown(load, 4, nearest),
        shown(step.lower, 5, Rounding::Down),
        shown(step.upper, 5, Rounding::Up),
        own,
        shown(step.turn().map(|t| 1e3 * t), 3, nearest),
        shown(step.displacement(), 3, nearest),
        shown(largest_force(step), 3, nearest),
    ]
}

/// Largest force in a section of a bolt, of both fields \[kN\].
fn largest_force(step: &LoadStep) -> Option<f64> {
    let sections = step.bolts.iter().flat_map(|b| &b.sections);
    let forces = sections.flat_map(|s| [s.by_stress, s.by_displacement]).flatten();
    forces.map(|f| 1e-3 * vec3::norm(f)).reduce(f64::max)
}
