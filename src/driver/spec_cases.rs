//! The cases of a spec on the mesh of its joint.

use crate::assembly::assembly::PartRole;
use crate::diag::Diagnostics;
use crate::driver::by_metric::{ByMetric, Tools};
use crate::driver::case::Case;
use crate::driver::remesh::{ByMap, Places, Remesh, remesher};
use crate::driver::spec_file::SpecFile;
use crate::mesh::joint::{JointMesh, MeshOptions};
use crate::model::from_joint;
use crate::model::resolve::resolve;
use crate::report::console::log::Log;
use crate::result::file_names::stem_of;
use crate::spec::analysis::AnalysisKind;
use crate::spec::polygon::PolygonSpec;
use std::rc::Rc;

/// A case for each load case and kind of analysis, and one for each direction of `polygon`.
pub fn cases<'a>(
    input: &SpecFile,
    meshed: &JointMesh,
    kinds: &[AnalysisKind],
    polygon: Option<&PolygonSpec>,
    mesh_seconds: f64,
) -> Result<Vec<Case<'a>>, Diagnostics> {
    let loads = &input.spec.value.loads;
    let of_polygon = |name: &String| loads.iter().any(|l| l.of_polygon && l.name == *name);
    let directions = polygon.map_or(Vec::new(), PolygonSpec::directions);
    let names = from_joint::cases(&input.joint.assembly);
    let asked = names.iter().filter(|name| !of_polygon(name));
    let cases = asked
        .flat_map(|name| kinds.iter().enumerate().map(move |(k, kind)| (name, *kind, k > 0)))
        .chain(directions.iter().map(|d| (&d.case, AnalysisKind::Limit, false)))
        .enumerate()
        .map(|(i, (name, kind, again))| {
            let assembly = &input.joint.assembly;
            let mut file = from_joint::model_file(
                assembly,
                &meshed.mesh,
                &meshed.symmetry_used,
                "mesh.msh",
                name,
                kind,
            );
            file.symmetry = meshed.copies;
            let estimates = input.spec.value.analysis.coulomb_estimate && !of_polygon(name);
            file.coulomb_estimate = estimates && kind == AnalysisKind::Limit;
            let model = resolve(&file, meshed.mesh.clone(), &|path| input.spec.index.place(path))?;
            let file_name = if i == 0 {
                "model.yaml".into()
            } else {
                format!("model_{}.yaml", stem_of(name, kind, again))
            };
            Ok(Case {
                name: name.clone(),
                model,
                model_file: (file_name, file),
                remesh: None,
                mesh_seconds: Some(mesh_seconds),
                direction: directions.iter().find(|d| d.case == *name).map(|d| d.unit),
            })
        });
    let mut cases = cases.collect::<Result<Vec<Case>, Diagnostics>>()?;
    if let Some((first, others)) = cases.split_first_mut() {
        others.iter_mut().for_each(|c| c.model.share_mesh(&first.model));
    }
    Ok(cases)
}

/// Lets the cases make further meshes: the geometry is meshed again with a map of sizes. The
/// directions of a polygon share the first mesh and get no further one.
pub fn give_remesh<'a>(
    cases: &mut [Case<'a>],
    input: &'a SpecFile,
    options: &MeshOptions,
    meshed: &JointMesh,
    place: Places<'a>,
    log: &Log,
) {
    let assembly = &input.joint.assembly;
    let remesher = remesher(log);
    for case in cases.iter_mut().filter(|c| c.direction.is_none()) {
        let kind = (case.name.clone(), case.model.analysis);
        let (estimate, map_options) = (case.model.coulomb_estimate, options.clone());
        let by_map = move |mesh| {
            let by_map = ByMap::new(assembly, map_options.clone(), kind.clone(), place, mesh);
            Box::new(by_map.estimating(estimate)) as Box<dyn Remesh<'a> + 'a>
        };
        case.remesh = Some(match &remesher {
            None => by_map(meshed.mesh.clone()),
            Some(remesher) => {
                let tools = Tools {
                    remesher: remesher.clone(),
                    dir: options.work_dir.clone(),
                    interrupt: options.interrupt.clone().unwrap_or_default(),
                    fallback: Rc::new(by_map),
                };
                let bolt = |name: &str| {
                    assembly.parts.iter().any(|p| p.name == name && p.role == PartRole::Bolt)
                };
                let mesh = meshed.mesh.clone();
                Box::new(ByMetric::new(tools, &case.model_file.1, place, mesh, bolt))
            }
        });
    }
}
