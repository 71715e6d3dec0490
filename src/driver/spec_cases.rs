//! The cases of a spec on the mesh of its joint.

use crate::diag::Diagnostics;
use crate::driver::case::Case;
use crate::driver::interrupt::Interrupt;
use crate::driver::remesh::{ByMap, Places};
use crate::driver::spec_file::SpecFile;
use crate::mesh::joint::{JointMesh, MeshOptions};
use crate::model::from_joint;
use crate::model::resolve::resolve;
use crate::result::file_names::stem_of;
use crate::spec::analysis::AnalysisKind;
use crate::spec::polygon::PolygonSpec;

/// A case for each load case and kind of analysis, and one for each direction of `polygon`.
pub fn cases<'a>(
    input: &SpecFile,
    meshed: &JointMesh,
    kinds: &[AnalysisKind],
    polygon: Option<&PolygonSpec>,
    mesh_seconds: f64,
    interrupt: &Interrupt,
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
            interrupt.check("reading the cases")?;
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

/// Lets the cases make further meshes: the geometry is meshed again with a map of sizes. Mmg does
/// not suit the thin walls of joints (docs/theory.md, section 12). The directions of a polygon
/// share the first mesh and get no further one.
pub fn give_remesh<'a>(
    cases: &mut [Case<'a>],
    input: &'a SpecFile,
    options: &MeshOptions,
    meshed: &JointMesh,
    place: Places<'a>,
) {
    let assembly = &input.joint.assembly;
    for case in cases.iter_mut().filter(|c| c.direction.is_none()) {
        let kind = (case.name.clone(), case.model.analysis);
        let by_map = ByMap::new(assembly, options.clone(), kind, place, meshed.mesh.clone());
        case.remesh = Some(Box::new(by_map.estimating(case.model.coulomb_estimate)));
    }
}
