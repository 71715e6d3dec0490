//! The meshes of a case: bounds, cost of the programs, predictions.

use crate::figures::{Rounding, bracket, fixed, percent_up, significant};
use crate::markdown::markup::{dash, inline, paragraph, strings, table};
use crate::markdown::report_data::Table;
use crate::markdown::words::analysis_word;
use crate::result::result_file::CaseResult;
use crate::result::result_file::HistoryRow;
use crate::result::result_file::ProgramRun;
use crate::result::result_file::Quantity;
use crate::result::result_file::Upper;

/// The tables of one case. The structure consists of `symmetry` copies of the meshed part.
pub(crate) fn history(page: &mut String, case: &CaseResult, symmetry: u32) {
    let part = match symmetry {
        1 => "the whole structure is meshed".to_string(),
        2 => "half of the structure is meshed".to_string(),
        4 => "a quarter of the structure is meshed".to_string(),
        n => format!("one of {n} equal parts of the structure is meshed"),
    };
    let unit = match case.quantity {
        Quantity::PotentialEnergy => " [N mm]",
        Quantity::LoadFactor => "",
    };
    let what = if case.is_strict() { "bounds" } else { "estimates" };
    paragraph(
        page,
        &format!(
            "**{}** ({}; {part}, {what} are those of the whole structure):",
            inline(&case.name),
            analysis_word(case.analysis)
        ),
    );
    let columns = vec![
        "mesh".into(),
        "macro tets".into(),
        "mesh [s]".into(),
        format!("lower{unit}"),
        format!("upper{unit}"),
        "gap so far".into(),
        "peak memory [MiB]".into(),
    ];
    let rows = case.history.iter().enumerate().map(|(i, h)| {
        let (low, high) = match (h.lower, h.upper) {
            (Some(l), Some(Upper::Finite(u))) => {
                let (l, u) = bracket(l, u, 4);
                (Some(l), Some(u))
            }
            (l, u) => (
                l.map(|l| significant(l, 6, Rounding::Down)),
                u.map(|u| {
                    u.finite().map_or("unbounded".into(), |u| significant(u, 6, Rounding::Up))
                }),
            ),
        };
        vec![
            (i + 1).to_string(),
            count(Some(h.macro_tets)),
            seconds(h.mesh_seconds),
            low.unwrap_or_else(dash),
            high.unwrap_or_else(dash),
            gap_so_far(h).map_or_else(dash, percent_up),
            h.peak_memory_mib.map_or_else(dash, |m| m.to_string()),
        ]
    });
    table(page, &Table { columns, rows: rows.collect() });
    expectations(page, case);
    let columns = strings([
        "mesh",
        "program",
        "unknowns",
        "assembly [s]",
        "solution [s]",
        "in all [s]",
        "iterations",
        "peak memory [MiB]",
        "status",
    ]);
    let rows: Vec<_> =
        case.history.iter().enumerate().flat_map(|(i, h)| programs(i + 1, h)).collect();
    if !rows.is_empty() {
        table(page, &Table { columns, rows });
    }
}

/// The gap of the best bounds of a mesh and the meshes before it.
fn gap_so_far(h: &HistoryRow) -> Option<f64> {
    h.so_far.map_or(h.gap, |b| b.gap)
}

/// The gap that the prediction of a mesh is about: of its own bounds, or for a mesh with one bound
/// of the best bounds with this one.
fn resulting(h: &HistoryRow) -> Option<f64> {
    h.gap.or_else(|| gap_so_far(h))
}

/// Prediction and result of each further mesh.
fn expectations(page: &mut String, case: &CaseResult) {
    let further = case.history.iter().enumerate().filter_map(|(i, h)| Some((i, h, h.predicted?)));
    let rows: Vec<Vec<String>> = further
        .map(|(i, h, p)| {
            vec![
                (i + 1).to_string(),
                count(Some(p.macro_tets)),
                count(Some(h.macro_tets)),
                p.gap.map_or_else(dash, percent_up),
                resulting(h).map_or_else(dash, percent_up),
                seconds(Some(p.seconds)),
                seconds(h.seconds),
            ]
        })
        .collect();
    if rows.is_empty() {
        return;
    }
    paragraph(page, "What was expected of each further mesh before it was made, and the result:");
    let columns = strings([
        "mesh",
        "tets expected",
        "tets",
        "gap expected",
        "gap",
        "expected in all [s]",
        "in all [s]",
    ]);
    table(page, &Table { columns, rows });
}

fn programs(mesh: usize, h: &HistoryRow) -> Vec<Vec<String>> {
    let row = |name: &str, unknowns: Option<usize>, run: &ProgramRun| {
        vec![
            mesh.to_string(),
            name.into(),
            count(unknowns),
            seconds(run.assembly_seconds),
            seconds(run.solve_seconds),
            seconds(Some(run.seconds)),
            run.iterations.to_string(),
            run.peak_memory_mib.map_or_else(dash, |m| m.to_string()),
            run.status.clone(),
        ]
    };
    let kinematic = h.kinematic.as_ref().map(|r| row("kinematic", h.kinematic_dofs, r));
    let static_ = h.static_.as_ref().map(|r| row("static", h.static_dofs, r));
    // its unknowns are those of the static program, because friction adds none
    let smooth =
        h.static_frictionless.as_ref().map(|r| row("static, frictionless", h.static_dofs, r));
    kinematic.into_iter().chain(static_).chain(smooth).collect()
}

fn count(n: Option<usize>) -> String {
    n.map_or_else(dash, |n| fixed(n as f64, 0, Rounding::Nearest))
}

fn seconds(s: Option<f64>) -> String {
    s.map_or_else(dash, |s| if s < 10.0 { format!("{s:.2}") } else { format!("{s:.1}") })
}
