//! The history in `result.json`: cost and result of each mesh.

use crate::result::quantity::Upper;
use bracket_base::words::Text;
use serde::{Deserialize, Serialize};

/// Cost and result of one mesh. Bounds apply to the whole structure, sizes to the meshed part.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct HistoryRow {
    /// Tetrahedra of the mesh, before any of them is split in four.
    pub macro_tets: usize,
    /// Unknowns of the kinematic program.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub kinematic_dofs: Option<usize>,
    /// Unknowns of the static program.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub static_dofs: Option<usize>,
    /// Lower bound, unit of the case's quantity.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub lower: Option<f64>,
    /// Upper bound, unit of the case's quantity.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub upper: Option<Upper>,
    /// Relative gap, a fraction.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub gap: Option<f64>,
    /// The kinematic program.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub kinematic: Option<ProgramRun>,
    /// The static program.
    #[serde(default, rename = "static", skip_serializing_if = "Option::is_none")]
    pub static_: Option<ProgramRun>,
    /// Limit analysis with friction: the static program without it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub static_frictionless: Option<ProgramRun>,
    /// Wall time of everything on this mesh, the mesher included \[s\].
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub seconds: Option<f64>,
    /// The best bounds of this and the earlier meshes.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub so_far: Option<SoFar>,
    /// Prediction for this mesh before it was made.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub predicted: Option<Predicted>,
    /// Wall time of the mesher and the reader \[s\].
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub mesh_seconds: Option<f64>,
    /// Peak resident memory of the process so far \[MiB\].
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub peak_memory_mib: Option<u64>,
}

/// The best bounds of all meshes so far, joined as in the answer.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct SoFar {
    /// Lower bound, unit of the case's quantity.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub lower: Option<f64>,
    /// Upper bound, unit of the case's quantity.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub upper: Option<Upper>,
    /// Relative gap, a fraction.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub gap: Option<f64>,
    /// True if both are certified bounds.
    pub strict: bool,
}

/// Prediction for a mesh before it was made.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Predicted {
    /// Tetrahedra.
    pub macro_tets: usize,
    /// Relative gap of this mesh's bounds, a fraction. For a mesh made for one bound: of the best
    /// bounds with this one. Absent where no bracket is expected.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub gap: Option<f64>,
    /// Wall time of everything on this mesh \[s\].
    pub seconds: f64,
}

/// One program on one mesh.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct ProgramRun {
    /// Wall time of assembly, solution and recovery together \[s\].
    pub seconds: f64,
    /// Iterations of the solver.
    pub iterations: u32,
    /// Elastic, perfectly plastic analysis: tets with a yield condition.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub yielding_tets: Option<usize>,
    /// Elastic, perfectly plastic analysis: number of solves until every tet without a yield
    /// condition was below yield.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub solves: Option<u32>,
    /// Status of the solver at its end.
    pub status: Text,
    /// Part of `seconds` spent in assembly \[s\].
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub assembly_seconds: Option<f64>,
    /// Part of `seconds` spent in the solver \[s\].
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub solve_seconds: Option<f64>,
    /// Peak resident memory of the process at the end of this program \[MiB\].
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub peak_memory_mib: Option<u64>,
    /// Nonzeros of the sparse factor.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub factor_entries: Option<usize>,
    /// Forecast of the memory of the solve \[MiB\]; where Clarabel took over, the memory that it
    /// was granted.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub forecast_memory_mib: Option<u64>,
    /// Forecast of the time of the solve \[s\].
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub forecast_seconds: Option<f64>,
    /// Every iteration of the solver.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub trace: Vec<TraceRow>,
}

/// One iteration of a solver. If the numbers start again, another solver took over.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct TraceRow {
    /// Its number; 0 is the starting point.
    pub number: u32,
    /// Relative duality gap; absent if it is not finite.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub gap: Option<f64>,
    /// Largest relative residual; absent if it is not finite.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub residual: Option<f64>,
    /// Length of the step that led to this iterate, 0 to 1.
    pub step: f64,
    /// Wall time since the solve began \[s\].
    pub seconds: f64,
}
