//! The cases of a spec on the mesh of its joint.

use crate::driver::by_metric::{ByMetric, Tools};
use crate::driver::case::Case;
use crate::driver::combinations::with_actions;
use crate::driver::interrupt::Interrupt;
use crate::driver::remesh::{ByMap, Places, Remesh, remesher};
use crate::driver::spec_file::SpecFile;
use bracket_base::diag::Diagnostics;
use bracket_codes::design_strengths;
use bracket_engine::certify::half_space::Actions;
use bracket_engine::mesh::TetMesh;
use bracket_engine::model::AnalysisKind;
use bracket_engine::model::file::ModelFile;
use bracket_engine::model::resolve::resolve;
use bracket_joint::assembly::assembly::SymmetryPlane;
use bracket_joint::meshing::joint::{JointMesh, MeshOptions};
use bracket_joint::model_file::{self, Asked};
use bracket_joint::spec::polygon::PolygonSpec;
use bracket_report::console::log::Log;
use bracket_report::result::file_names::stem_of;
use std::rc::Rc;

/// A load case of a spec under one kind of analysis.
#[derive(Clone, Debug, PartialEq)]
pub struct AskedCase {
    /// The load case and the kind of analysis.
    pub of: Asked,
    /// True if an earlier kind of analysis has the same load case.
    pub again: bool,
    /// For a direction of the polygon: both actions in the units of its axes.
    pub direction: Option<[f64; 2]>,
    /// For actions of no load case: the load case whose model they act on, and the actions.
    pub like: Option<(String, Actions)>,
}

/// A load case of a spec under a kind of analysis.
fn asked(input: &SpecFile, name: &str, kind: AnalysisKind) -> Asked {
    let elastic_bolts = input.elastic_bolts(kind);
    // the tension that EN 1993-1-8 Table 3.4 limits does not count the preload
    let preload = !(input.decide && kind == AnalysisKind::Elastoplastic);
    Asked { elastic_bolts, preload, ..Asked::new(name, kind) }
}

/// The load cases under each kind of analysis, then the directions of `polygon`, in the order in
/// which they are analysed.
pub fn asked_cases(
    input: &SpecFile,
    kinds: &[AnalysisKind],
    polygon: Option<&PolygonSpec>,
) -> Vec<AskedCase> {
    let loads = &input.spec.value.loads;
    let of_polygon = |name: &String| loads.iter().any(|l| l.of_polygon && l.name == *name);
    let names = model_file::cases(&input.joint.assembly);
    let of_name = |name: &String| {
        let of_kind = |(k, &kind): (usize, &AnalysisKind)| AskedCase {
            of: asked(input, name, kind),
            again: k > 0,
            direction: None,
            like: None,
        };
        kinds.iter().enumerate().map(of_kind).collect::<Vec<_>>()
    };
    let directions = polygon.map_or(Vec::new(), PolygonSpec::directions);
    let directions = directions.into_iter().map(|d| AskedCase {
        of: Asked::new(d.case, AnalysisKind::Limit),
        again: false,
        direction: Some(d.unit),
        like: None,
    });
    names.iter().filter(|n| !of_polygon(n)).flat_map(of_name).chain(directions).collect()
}

impl AskedCase {
    /// Limit analysis of a load case, or of actions under a name.
    pub fn limit(input: &SpecFile, name: &str) -> Self {
        let of = asked(input, name, AnalysisKind::Limit);
        Self { of, again: false, direction: None, like: None }
    }

    /// The model on a mesh of the joint that uses these symmetry planes.
    pub fn model_file(
        &self,
        input: &SpecFile,
        mesh: &TetMesh,
        symmetry_used: &[SymmetryPlane],
    ) -> ModelFile {
        let mut of = self.of.clone();
        if let Some((like, _)) = &self.like {
            of.case.clone_from(like);
        }
        let file = model_file::model_file(
            &input.joint.assembly,
            &design_strengths(&input.joint),
            mesh,
            symmetry_used,
            "mesh.msh",
            &of,
        );
        let file = match &self.like {
            Some((_, actions)) => with_actions(&file, actions),
            None => file,
        };
        let estimates = input.spec.value.analysis.coulomb_estimate && self.direction.is_none();
        ModelFile { coulomb_estimate: estimates && self.of.kind == AnalysisKind::Limit, ..file }
    }
}

/// A case for each load case and kind of analysis, and one for each direction of `polygon`.
pub fn cases<'a>(
    input: &SpecFile,
    meshed: &JointMesh,
    kinds: &[AnalysisKind],
    polygon: Option<&PolygonSpec>,
    mesh_seconds: f64,
    interrupt: &Interrupt,
) -> Result<Vec<Case<'a>>, Diagnostics> {
    let asked = asked_cases(input, kinds, polygon).into_iter().enumerate();
    let cases = asked.map(|(i, asked)| {
        interrupt.check("reading the cases")?;
        let file = asked.model_file(input, &meshed.mesh, &meshed.symmetry_used);
        case(input, meshed, (asked, file), i == 0, mesh_seconds)
    });
    let mut cases = cases.collect::<Result<Vec<Case>, Diagnostics>>()?;
    if let Some((first, others)) = cases.split_first_mut() {
        others.iter_mut().for_each(|c| c.model.share_mesh(&first.model));
    }
    Ok(cases)
}

/// A case on the first mesh with its model file. The first case of a run writes `model.yaml`.
pub fn case<'a>(
    input: &SpecFile,
    meshed: &JointMesh,
    (asked, file): (AskedCase, ModelFile),
    first: bool,
    mesh_seconds: f64,
) -> Result<Case<'a>, Diagnostics> {
    let model = resolve(&file, meshed.mesh.clone(), &|path| input.spec.index.place(path))?;
    let Asked { case: name, kind, .. } = asked.of;
    let file_name = match first {
        true => "model.yaml".into(),
        false => format!("model_{}.yaml", stem_of(&name, kind, asked.again)),
    };
    Ok(Case {
        name,
        model,
        model_file: (file_name, file),
        remesh: None,
        mesh_seconds: Some(mesh_seconds),
        direction: asked.direction,
    })
}

/// What makes further meshes where Mmg is absent or fails.
const BY_MAP: &str = "gmsh with a map of sizes";

/// Lets the cases make further meshes. In elastic and in limit analysis Mmg makes them from the
/// last one and a metric; else, and where it fails, gmsh meshes the geometry again with a map of
/// sizes. The directions of a polygon share the first mesh and get no further one.
pub fn give_remesh<'a>(
    cases: &mut [Case<'a>],
    input: &'a SpecFile,
    options: &MeshOptions,
    meshed: &JointMesh,
    place: Places<'a>,
    (interrupt, log): (&Interrupt, &Log),
) {
    let metric = |k: AnalysisKind| k != AnalysisKind::Elastoplastic;
    let any = cases.iter().any(|c| metric(c.model.analysis));
    let remesher = any.then(|| remesher(BY_MAP, interrupt, log)).flatten();
    for case in cases.iter_mut().filter(|c| c.direction.is_none()) {
        let asked = asked(input, &case.name, case.model.analysis);
        let (options, of) = (options.clone(), (asked, case.model_file.1.clone()));
        let dir = options.work_dir.clone();
        let by_map = move |mesh: TetMesh| {
            let by_map = ByMap::new(&input.joint, options.clone(), of.clone(), place, mesh);
            Box::new(by_map) as Box<dyn Remesh<'a> + 'a>
        };
        let by_metric = remesher.clone().filter(|_| metric(case.model.analysis));
        case.remesh = Some(match by_metric {
            Some(remesher) => {
                let tools = Tools {
                    remesher,
                    dir,
                    interrupt: interrupt.flag(),
                    fallback: Rc::new(by_map),
                    otherwise: BY_MAP,
                };
                let mesh = meshed.mesh.clone();
                Box::new(ByMetric::new(tools, &case.model_file.1, place, mesh))
            }
            None => by_map(meshed.mesh.clone()),
        });
    }
}
