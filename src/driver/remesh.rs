//! Makes the next mesh of a case where Mmg does not ([`super::by_metric`]). The geometry of a spec
//! is meshed again with a map of sizes; a user's mesh is refined by bisection.

use crate::driver::interrupt::Interrupt;
use crate::driver::meshing::{clean, quality_table};
use bracket_base::diag::{Diagnostic, Diagnostics, Place};
use bracket_base::math::mandel::Mandel;
use bracket_codes::design_strengths;
use bracket_engine::mesh::gmsh::Until;
use bracket_engine::mesh::mmg::Remesher;
use bracket_engine::mesh::size_field::{Edges, FILLING, SizeField};
use bracket_engine::mesh::{TetMesh, bisect, quality};
use bracket_engine::model::AnalysisModel;
use bracket_engine::model::file::{ModelFile, Nodes};
use bracket_engine::model::resolve::resolve;
use bracket_engine::refine::optimum::Design;
use bracket_engine::refine::plan;
use bracket_joint::assembly::Joint;
use bracket_joint::meshing::joint::{MeshOptions, mesh_joint};
use bracket_joint::model_file::{self, Asked};
use bracket_report::console::log::Log;
use bracket_report::document::table::Table;
use std::time::{Duration, Instant};

/// A mesh made by adaptation.
pub struct Made {
    /// The model on the new mesh.
    pub model: AnalysisModel,
    /// The mesh as in its file, where bodies share nodes.
    pub mesh: TetMesh,
    /// The model file; the caller sets the name of its mesh.
    pub file: ModelFile,
    /// Quality.
    pub quality: Table,
    /// Wall time of meshing \[s\].
    pub seconds: f64,
}

/// Makes the next mesh of a case.
pub trait Remesh<'a> {
    /// A second remesher in the same state, for a sequence of meshes of its own.
    fn twin(&self) -> Box<dyn Remesh<'a> + 'a>;

    /// Number of parts into which each tet of the last mesh will be divided for the wanted numbers
    /// and directions, as far as it is known beforehand.
    fn realised(&self, wanted: &[f64], directions: &[Mandel]) -> Vec<f64>;

    /// Ratio of real to ideal gap for a four-fold growth of the mesh, before any pass shows it.
    fn loss(&self) -> f64 {
        plan::LOSS
    }

    /// Makes the mesh of a design, in at most `seconds`.
    fn remesh(&mut self, design: &Design, seconds: f64, log: &Log) -> Result<Made, Diagnostics>;
}

/// Mmg, if it is installed; if not, the log says what is used in its place, `otherwise`.
pub fn remesher(otherwise: &str, interrupt: &Interrupt, log: &Log) -> Option<Remesher> {
    let flag = interrupt.flag();
    match Remesher::find_until(Until { limit: None, interrupt: Some(&flag) }) {
        Ok(remesher) => Some(remesher),
        Err(error) => {
            log.line(format!("{otherwise} in place of Mmg: {error}"));
            None
        }
    }
}

/// Relative deviation of the count of tets below which the mesher does not run again.
const NEAR: f64 = 0.07;

/// Runs of the mesher for one mesh.
const RUNS: usize = 3;

/// Exponent with which the mesher's count of tets depends on the size.
const COUNT_EXPONENT: f64 = 2.5;

/// Time limit of one run of the mesher \[s\].
const MESHER_SECONDS: f64 = 600.0;

/// Position of a path in the input file.
pub type Places<'a> = &'a dyn Fn(&str) -> Place;

/// Meshes a spec's geometry again with a map of sizes.
#[derive(Clone)]
pub struct ByMap<'a> {
    joint: &'a Joint,
    options: MeshOptions,
    asked: Asked,
    /// The model file of the case on its first mesh.
    first: ModelFile,
    place: Places<'a>,
    mesh: TetMesh,
    edges: Edges,
    /// Ratio of the count of tets to that of regular tetrahedra of the wanted size, in the last run
    /// of the mesher.
    filling: f64,
}

impl<'a> ByMap<'a> {
    /// Starts from the first mesh, which was made with these options; `asked` and `first`: the case
    /// and its model file on that mesh.
    pub fn new(
        joint: &'a Joint,
        options: MeshOptions,
        (asked, first): (Asked, ModelFile),
        place: Places<'a>,
        mesh: TetMesh,
    ) -> Self {
        let edges = Edges::new(&mesh);
        Self { joint, options, asked, first, place, mesh, edges, filling: FILLING }
    }
}

impl<'a> Remesh<'a> for ByMap<'a> {
    fn twin(&self) -> Box<dyn Remesh<'a> + 'a> {
        Box::new(self.clone())
    }

    fn realised(&self, wanted: &[f64], _: &[Mandel]) -> Vec<f64> {
        SizeField::new(&self.mesh, &self.edges, wanted).parts(&self.mesh)
    }

    fn remesh(&mut self, design: &Design, seconds: f64, log: &Log) -> Result<Made, Diagnostics> {
        let start = Instant::now();
        let field = SizeField::new(&self.mesh, &self.edges, &design.wanted);
        let mut scale = self.filling.cbrt();
        let mut made = None;
        // another run if the count is off: sizes set by the geometry do not follow the map
        for _ in 0..RUNS {
            let left = (seconds - start.elapsed().as_secs_f64()).clamp(0.0, MESHER_SECONDS);
            let mut options = self.options.clone();
            options.size_view = Some(field.view(&self.mesh, scale));
            options.time_limit = Duration::from_secs_f64(left);
            let meshed = mesh_joint(&self.joint.assembly, &options, &mut |stage| log.stage(stage));
            clean(&options)?;
            let meshed = meshed?;
            let ratio = meshed.mesh.tets.len() as f64 / design.tets;
            made = Some(meshed);
            if ratio.ln().abs() < NEAR {
                break;
            }
            scale *= ratio.powf(1.0 / COUNT_EXPONENT);
        }
        // the loop runs at least once
        let meshed =
            made.ok_or_else(|| Diagnostic::undecided("cli/lost", "no finer mesh was made"))?;
        self.filling = scale.powi(3).clamp(0.3, 1.2);
        let mut file = model_file::model_file(
            &self.joint.assembly,
            &design_strengths(self.joint),
            &meshed.mesh,
            &meshed.symmetry_used,
            "mesh.msh",
            &self.asked,
        );
        file.symmetry = meshed.copies;
        // what acts may be no load case of the joint, and depends on no mesh
        file.rigid.clone_from(&self.first.rigid);
        file.coulomb_estimate = self.first.coulomb_estimate;
        let model = resolve(&file, meshed.mesh.clone(), self.place)?;
        self.edges = Edges::new(&meshed.mesh);
        self.mesh = meshed.mesh.clone();
        let quality = quality_table(&meshed.quality);
        Ok(Made { model, mesh: meshed.mesh, file, quality, seconds: start.elapsed().as_secs_f64() })
    }
}

/// Refines a user's mesh by bisection.
#[derive(Clone)]
pub struct ByBisection<'a> {
    file: ModelFile,
    place: Places<'a>,
    mesh: TetMesh,
}

impl<'a> ByBisection<'a> {
    /// Starts from the first mesh. `mesh` is the mesh as read, with coincident nodes of different
    /// bodies merged.
    pub fn new(file: &ModelFile, place: Places<'a>, mesh: TetMesh) -> Self {
        Self { file: ModelFile { nodes: Nodes::Shared, ..file.clone() }, place, mesh }
    }
}

impl<'a> Remesh<'a> for ByBisection<'a> {
    fn twin(&self) -> Box<dyn Remesh<'a> + 'a> {
        Box::new(self.clone())
    }

    fn realised(&self, wanted: &[f64], _: &[Mandel]) -> Vec<f64> {
        bisect::refine(&self.mesh, wanted).parts(self.mesh.tets.len())
    }

    fn remesh(&mut self, design: &Design, _: f64, log: &Log) -> Result<Made, Diagnostics> {
        let start = Instant::now();
        log.stage("bisecting the mesh");
        self.mesh = bisect::refine(&self.mesh, &design.wanted).mesh;
        let model = resolve(&self.file, self.mesh.clone(), self.place)?;
        let quality = quality_table(&quality::table(&self.mesh));
        let seconds = start.elapsed().as_secs_f64();
        Ok(Made { model, mesh: self.mesh.clone(), file: self.file.clone(), quality, seconds })
    }
}
