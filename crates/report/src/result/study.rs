//! The rows of a study of speed against error.

use crate::result::case_result::CaseResult;
use crate::result::history::HistoryRow;
use crate::result::quantity::Upper;
use bracket_engine::model::AnalysisKind;
use serde::Serialize;

/// Source of the meshes of a row.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Meshes {
    /// Refined uniformly; every row is independent of the others.
    Uniform,
    /// Refined where the gap originates; a row includes the cost of the rows before it.
    Adaptive,
}

/// One mesh under one solver.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Row {
    /// Load case.
    pub case: String,
    /// Kind of analysis.
    pub analysis: AnalysisKind,
    /// Source of the mesh.
    pub meshes: Meshes,
    /// Solver.
    pub solver: String,
    /// Number of the mesh, from 1.
    pub mesh: usize,
    /// Tetrahedra.
    pub macro_tets: usize,
    /// Unknowns of both programs.
    pub dofs: usize,
    /// Largest certified lower bound so far, over the meshes whose cost the row includes.
    pub lower: Option<f64>,
    /// Smallest certified upper bound so far.
    pub upper: Option<f64>,
    /// Gap of these two, a fraction.
    pub gap: Option<f64>,
    /// Gap expected before the mesh was made.
    pub expected_gap: Option<f64>,
    /// Wall time of everything on this mesh, the mesher included \[s\].
    pub seconds: f64,
    /// Wall time of this mesh and of all meshes that led to it \[s\].
    pub total_seconds: f64,
    /// Peak resident memory \[MiB\].
    pub peak_memory_mib: Option<u64>,
}

/// All rows.
#[derive(Clone, Debug, PartialEq)]
pub struct Study {
    /// The gap asked for.
    pub target_gap: f64,
    /// Its rows.
    pub rows: Vec<Row>,
}

/// The rows of an entry's history.
pub fn study_rows(meshes: Meshes, solver: &str, entry: &CaseResult) -> Vec<Row> {
    let mut total = 0.0;
    let mut one = |(i, h): (usize, &HistoryRow)| {
        let own = h.kinematic.as_ref().map_or(0.0, |r| r.seconds)
            + h.static_.as_ref().map_or(0.0, |r| r.seconds);
        let seconds = h.seconds.unwrap_or(own);
        total += seconds;
        let so_far = h.so_far.filter(|b| b.strict).unwrap_or_default();
        Row {
            case: entry.name.clone(),
            analysis: entry.analysis,
            meshes,
            solver: solver.into(),
            mesh: i + 1,
            macro_tets: h.macro_tets,
            dofs: h.kinematic_dofs.unwrap_or(0) + h.static_dofs.unwrap_or(0),
            lower: so_far.lower,
            upper: so_far.upper.and_then(Upper::finite),
            gap: so_far.gap,
            expected_gap: h.predicted.and_then(|p| p.gap),
            seconds,
            total_seconds: total,
            peak_memory_mib: h.peak_memory_mib,
        }
    };
    entry.history.iter().enumerate().map(&mut one).collect()
}
