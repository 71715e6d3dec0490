//! The meshes of a case: bounds, cost of the programs, predictions.

use crate::document::Doc;
use crate::document::table::{Table, cells, dash};
use crate::figures::{Rounding, bracket, fixed, percent_up, significant};
use crate::markdown::words::analysis_word;
use crate::result::result_file::CaseResult;
use crate::result::result_file::HistoryRow;
use crate::result::result_file::ProgramRun;
use crate::result::result_file::Quantity;
use crate::result::result_file::Upper;
use bracket_base::say;
use bracket_base::words::Text;

/// The tables of one case. The structure consists of `symmetry` copies of the meshed part.
pub(crate) fn history(doc: &mut Doc, case: &CaseResult, symmetry: u32) {
    let part = match symmetry {
        1 => "the whole structure is meshed".into(),
        2 => "half of the structure is meshed".into(),
        4 => "a quarter of the structure is meshed".into(),
        n => say!("one of {} equal parts of the structure is meshed", n),
    };
    let [lower, upper] = match case.quantity {
        Quantity::PotentialEnergy => ["lower [N mm]", "upper [N mm]"],
        Quantity::LoadFactor => ["lower", "upper"],
    };
    let what = if case.is_strict() { "bounds" } else { "estimates" };
    doc.paragraph(say!(
        "**{}** ({}; {}, {} are those of the whole structure):",
        &case.name,
        analysis_word(case.analysis),
        part,
        what
    ));
    let columns = Table::columns([
        "mesh",
        "macro tets",
        "mesh [s]",
        lower,
        upper,
        "gap so far",
        "peak memory [MiB]",
    ]);
    let rows = case.history.iter().enumerate().map(|(i, h)| {
        let (low, high) = match (h.lower, h.upper) {
            (Some(l), Some(Upper::Finite(u))) => {
                let (l, u) = bracket(l, u, 4);
                (Some(l.into()), Some(u.into()))
            }
            (l, u) => (
                l.map(|l| significant(l, 6, Rounding::Down).into()),
                u.map(|u| match u.finite() {
                    Some(u) => significant(u, 6, Rounding::Up).into(),
                    None => Text::from("unbounded"),
                }),
            ),
        };
        cells![
            (i + 1).to_string(),
            count(Some(h.macro_tets)),
            seconds(h.mesh_seconds),
            low.unwrap_or_else(dash),
            high.unwrap_or_else(dash),
            gap_so_far(h).map_or_else(dash, |x| percent_up(x).into()),
            h.peak_memory_mib.map_or_else(dash, |m| m.to_string().into()),
        ]
    });
    doc.table(&Table { columns, rows: rows.collect() });
    expectations(doc, case);
    let columns = Table::columns([
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
        doc.table(&Table { columns, rows });
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
fn expectations(doc: &mut Doc, case: &CaseResult) {
    let further = case.history.iter().enumerate().filter_map(|(i, h)| Some((i, h, h.predicted?)));
    let rows: Vec<Vec<Text>> = further
        .map(|(i, h, p)| {
            cells![
                (i + 1).to_string(),
                count(Some(p.macro_tets)),
                count(Some(h.macro_tets)),
                p.gap.map_or_else(dash, |x| percent_up(x).into()),
                resulting(h).map_or_else(dash, |x| percent_up(x).into()),
                seconds(Some(p.seconds)),
                seconds(h.seconds),
            ]
        })
        .collect();
    if rows.is_empty() {
        return;
    }
    doc.paragraph("What was expected of each further mesh before it was made, and the result:");
    let columns = Table::columns([
        "mesh",
        "tets expected",
        "tets",
        "gap expected",
        "gap",
        "expected in all [s]",
        "in all [s]",
    ]);
    doc.table(&Table { columns, rows });
}

fn programs(mesh: usize, h: &HistoryRow) -> Vec<Vec<Text>> {
    let row = |name: &'static str, unknowns: Option<usize>, run: &ProgramRun| {
        cells![
            mesh.to_string(),
            name,
            count(unknowns),
            seconds(run.assembly_seconds),
            seconds(run.solve_seconds),
            seconds(Some(run.seconds)),
            run.iterations.to_string(),
            run.peak_memory_mib.map_or_else(dash, |m| m.to_string().into()),
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

fn count(n: Option<usize>) -> Text {
    n.map_or_else(dash, |n| fixed(n as f64, 0, Rounding::Nearest).into())
}

fn seconds(s: Option<f64>) -> Text {
    s.map_or_else(dash, |s| match s < 10.0 {
        true => format!("{s:.2}").into(),
        false => format!("{s:.1}").into(),
    })
}
