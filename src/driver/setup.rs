//! What the cases of a run share beside solver and limits: the joint as the meshes see it, and how
//! far the meshes are refined.

use bracket_base::words::Text;
use bracket_engine::refine::plan;
use bracket_joint::assembly::BoltLine;
use bracket_joint::spec::polygon::PolygonSpec;
use bracket_report::result::evidence::EvidencePlan;

/// What the cases of a run share.
#[derive(Clone, Debug, Default)]
pub struct RunSetup {
    /// Hash of everything the result depends on.
    pub input_hash: String,
    /// Warnings that come with the input: the notes of the joint and of its checks.
    pub warnings: Vec<Text>,
    /// Symmetry planes used (axes).
    pub mirror: Vec<usize>,
    /// Positions of the bolts.
    pub bolts: Vec<BoltLine>,
    /// What is measured for the route of analysis in elastoplastic analysis with elastic bolts.
    pub evidence: Option<EvidencePlan>,
    /// Load factors at which elastoplastic analysis is run as well, rising.
    pub load_steps: Vec<f64>,
    /// Whether only a verdict is asked for: no mesh and no analysis that it does not need.
    pub decide: bool,
    /// The requested polygon.
    pub polygon: Option<PolygonSpec>,
    /// How far the meshes are refined.
    pub refinement: Refinement,
}

/// How far the meshes of a run are refined, and what its user can do about their size.
#[derive(Clone, Copy, Debug, Default)]
pub struct Refinement {
    /// Limits of the adaptation; `None`: there is only one mesh, and no gap is requested.
    pub adapt: Option<plan::Limits>,
    /// Advice on how to get a finer mesh.
    pub finer: &'static str,
    /// Advice on how to get a coarser mesh.
    pub coarser: &'static str,
}

impl Refinement {
    /// Whether a first mesh is to be refined.
    pub fn refines(&self) -> bool {
        self.adapt.is_some_and(|a| a.max_passes > 1)
    }
}
