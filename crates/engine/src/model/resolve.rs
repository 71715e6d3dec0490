//! Builds an [`AnalysisModel`] from a `MODEL.yaml` and a mesh, and checks every rule of
//! docs/contract.md.

mod actions;
mod claims;
mod cut_faces;
mod faults;
mod held;
mod interfaces;
mod limits;
mod materials;
mod motions;
mod names;
mod parity;
mod parts;
mod preload;
mod resultants;
mod ties;

use super::analysis::AnalysisModel;
use super::file::{ModelFile, Nodes};
use super::opening::ConeShift;
use crate::mesh::split::{TetFace, split};
use crate::mesh::topology::FaceTable;
use crate::mesh::{TetMesh, merge, msh};
use crate::model::AnalysisKind;
use bracket_base::diag::{Diagnostic, Diagnostics, Place};
use bracket_base::say;
use bracket_base::text_file;
use bracket_base::yaml;
use faults::Faults;
pub use motions::LooseParts;
pub use parity::{MirrorPlane, parities};
use std::path::Path;
use std::sync::Arc;

/// Reads a `MODEL.yaml` and the mesh it names (a path relative to it).
pub fn load_model(path: &Path) -> Result<AnalysisModel, Diagnostics> {
    let text = text_file::read(path, |e| {
        Diagnostic::input(
            "model/read",
            format!("the model file `{}` cannot be read: {e}", path.display()),
        )
        .file(path)
        .help("check the path and the right to read it")
    })?;
    let parsed = yaml::parse::<ModelFile>(&text, path)?;
    let mesh_path = path.parent().unwrap_or(Path::new("")).join(&parsed.value.mesh);
    if !mesh_path.is_file() {
        let mut d = Diagnostic::input(
            "model/no-mesh",
            format!("there is no mesh file `{}`", mesh_path.display()),
        );
        d.place = parsed.index.place("mesh");
        return Err(d
            .help("the path is relative to the model file; make the mesh with `gmsh -3`")
            .into());
    }
    let (mesh, mut notes) = msh::read_with_notes(&mesh_path)?;
    let mut model = resolve(&parsed.value, mesh, &|path| parsed.index.place(path))?;
    notes.append(&mut model.notes);
    model.notes = notes;
    Ok(model)
}

/// Checks `file` against `mesh` and builds the model; `place` returns the place of a path such as
/// `supports[1].face` in the file.
///
/// All faults of the file's values are reported together. Faults of the geometry are reported only
/// once the values are valid.
pub fn resolve(
    file: &ModelFile,
    mesh: TetMesh,
    place: &dyn Fn(&str) -> Place,
) -> Result<AnalysisModel, Diagnostics> {
    let mut mesh = mesh;
    let mut notes = Vec::new();
    let mut faults = Faults::new(place);

    let (materials, body_material) = materials::read(file, &mesh, &mut faults);
    materials::check_units(file, &mesh, &mut notes);
    materials::note_strengths(file, &mut notes);
    if ![1, 2, 4, 8].contains(&file.symmetry) {
        let m = format!(
            "`symmetry` is {}, it counts copies of the meshed part: 1, 2, 4 or 8",
            file.symmetry
        );
        faults.add(
            "model/value",
            "symmetry",
            m,
            "write 1, 2, 4 or 8, for none to three planes of symmetry",
        );
    }
    if let Some(adapt) = &file.adapt {
        if !(adapt.target_gap > 0.0 && adapt.target_gap < 1.0) {
            let m = format!("`target_gap` is {}, it must lie between 0 and 1", adapt.target_gap);
            faults.add("model/value", "adapt.target_gap", m, "write a fraction such as 0.05");
        }
        for (key, value) in [
            ("max_passes", adapt.max_passes.map(u64::from)),
            ("max_macro_tets", adapt.max_macro_tets.map(|n| n as u64)),
        ] {
            if value == Some(0) {
                let m = format!("`{key}` is 0, it must be at least 1");
                faults.add(
                    "model/value",
                    &format!("adapt.{key}"),
                    m,
                    "leave it out for its usual value",
                );
            }
        }
    }
    if file.nodes == Nodes::Split {
        let gone = merge::merge_coincident(&mut mesh)?;
        if gone == 0 && mesh.bodies.len() > 1 && !file.interfaces.is_empty() {
            notes.push("`nodes: split`, but no two bodies have coincident nodes".into());
        }
    }
    if file.nodes == Nodes::Shared && mesh.bodies.len() > 1 {
        let mut probe = mesh.clone();
        match merge::merge_coincident(&mut probe) {
            Ok(n) if n > 0 => notes.push(say!(
                "warning: {} nodes of different bodies coincide but are not shared: the bodies \
                 are not connected there; `nodes: split` pairs them",
                n
            )),
            _ => {}
        }
    }
    let table = FaceTable::new(&mesh.tets);
    merge::check_matching(&mesh, &table)?;
    let scene = names::Scene { mesh: &mesh, table: &table };

    limits::check(file, &scene, &mut faults, &mut notes);
    let claims = interfaces::claim(file, &scene, &mut faults, &mut notes);
    let (supports, ground) = held::supports(file, &scene, &claims, &mut faults, &mut notes);
    let rigid = held::rigid_faces(file, &scene, &claims, &mut faults);
    held::check_twice(file, &supports, &ground, &rigid, &mut faults);
    let cuts = preload::read(file, &scene, &claims, &mut faults, &mut notes);
    let (sections, resultant_limits) =
        resultants::read(file, &scene, &claims, &supports, &mut faults, &mut notes);
    let (surface_loads, body_loads) = actions::loads(file, &scene, &claims, &mut faults);
    faults.into_result()?;

    let open = claims.open.iter().flat_map(|o| o.faces.iter().copied());
    let tied = match file.analysis {
        AnalysisKind::Limit => ties::ties(&mesh, &table, &claims, &materials, &body_material),
        _ => Vec::new(),
    };
    let open: Vec<[TetFace; 2]> = open
        .chain(cuts.iter().flat_map(|c| c.faces.iter().copied()))
        .chain(sections.iter().flat_map(|c| c.faces.iter().copied()))
        .chain(tied.iter().flat_map(|t| t.faces.iter().copied()))
        .collect();
    let mut cut = split(&mesh, &table, &open);
    let mut of_cuts = cut.pairs.split_off(claims.open.iter().map(|o| o.faces.len()).sum());
    let mut of_sections = of_cuts.split_off(cuts.iter().map(|c| c.faces.len()).sum());
    let of_ties = of_sections.split_off(sections.iter().map(|c| c.faces.len()).sum());
    let (interfaces, welds) = interfaces::pairs(&claims, &cut.pairs);
    parts::join(&mut cut, of_cuts.iter().chain(&of_sections).chain(&of_ties));
    let ties = ties::opened(tied, &of_ties);
    let preload = preload::preloads(cuts, &of_cuts, &cut)?;
    let cuts = resultants::opened(sections, &of_sections, &cut)?;
    let parts = parts::names(&cut, &mut notes);
    if surface_loads.is_empty()
        && body_loads.is_empty()
        && rigid.iter().all(no_action)
        && preload.is_empty()
    {
        notes.push("there is no load".into());
    }
    let mut model = AnalysisModel {
        analysis: file.analysis,
        bounds: file.bounds,
        coulomb_estimate: file.coulomb_estimate,
        mesh: Arc::new(cut.mesh),
        materials,
        body_material,
        tet_part: cut.tet_part,
        parts,
        interfaces,
        welds,
        ties,
        ground,
        shift: ConeShift::default(),
        supports,
        rigid,
        preload,
        cuts,
        resultant_limits,
        surface_loads,
        body_loads,
        free_modes: Vec::new(),
        symmetry: file.symmetry,
        notes,
    };
    model.free_modes = motions::free_modes(&model).map_err(Diagnostic::from)?;
    for mode in &model.free_modes {
        let motion = motions::in_words(&model, mode);
        let note = say!("{}: no load works on it, it is held at one point", motion);
        model.notes.push(note);
    }
    Ok(model)
}

/// The model with every contact frictionless, and with pins against the rigid motions that friction
/// resisted. An error names the parts that a load drives along such a motion.
pub fn without_friction(model: &AnalysisModel) -> Result<AnalysisModel, LooseParts> {
    let mut smooth = model.without_friction();
    smooth.free_modes = motions::free_modes(&smooth)?;
    Ok(smooth)
}

fn no_action(r: &super::analysis::RigidFace) -> bool {
    r.action.iter().chain(&r.dead_action).all(|a| *a == 0.0)
}

#[cfg(test)]
mod tests;
