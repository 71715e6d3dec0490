//! Reads preloaded bolts: the mesh faces that sever the shank, and the conditions under which one
//! side can be drawn towards the other.

use super::claims::Claims;
use super::cut_faces::{Section, check_open};
use super::faults::Faults;
use super::names::Scene;
use crate::mesh::split::{OpenPair, SplitMesh, TetFace};
use crate::mesh::topology::face_nodes;
use crate::model::AnalysisKind;
use crate::model::analysis::{FacePair, Preload};
use crate::model::file::{ModelFile, PreloadEntry};
use bracket_base::diag::Diagnostics;
use bracket_base::math::vec3;
use bracket_base::say;
use bracket_base::words::Text;
use std::collections::BTreeMap;

/// A cut before the nodes are split: side A, side B of each face.
pub(super) struct Cut {
    preload: Preload,
    pub faces: Vec<[TetFace; 2]>,
}

/// Reads `preload`. In limit analysis preload has no effect: the cuts stay closed, and a note
/// reports it. In elastic, perfectly plastic analysis a preloaded bolt stays elastic.
pub(super) fn read(
    file: &ModelFile,
    scene: &Scene<'_>,
    claims: &Claims,
    faults: &mut Faults<'_>,
    notes: &mut Vec<Text>,
) -> Vec<Cut> {
    let mut yielding = file.preload.iter().filter(|entry| strength(file, entry).is_some());
    if let (AnalysisKind::Elastoplastic, Some(entry)) = (file.analysis, yielding.next()) {
        let m = format!(
            "`{}` is preloaded and may yield: an elastic, perfectly plastic analysis tightens \
             elastic bolts only",
            entry.body
        );
        let help = "leave out `fy` of its material, so that it stays elastic (`bolts: elastic` in \
                    a spec); or take `analysis: elastic`, or `limit`, where preload drops out";
        faults.add("model/unavailable", "preload", m, help);
        return Vec::new();
    }
    let mut cuts = Vec::new();
    let mut taken = BTreeMap::new();
    for (i, entry) in file.preload.iter().enumerate() {
        let path = format!("preload[{i}]");
        let section = Section {
            body: &entry.body,
            cut: &entry.cut,
            axis: entry.axis,
            code: "model/preload",
            path: &path,
        };
        let forced = has_force(entry, &path, faults);
        let found = section.faces(scene, claims, &mut taken, faults);
        let (true, Some((axis, faces))) = (forced, found) else { continue };
        strength_note(file, entry, &faces, scene, notes);
        let preload = Preload {
            body: entry.body.clone(),
            cut: entry.cut.clone(),
            axis,
            force: entry.force,
            closure: None,
            faces: Vec::new(),
        };
        cuts.push(Cut { preload, faces });
    }
    if file.analysis == AnalysisKind::Limit && !cuts.is_empty() {
        let bodies: Vec<&str> = cuts.iter().map(|c| c.preload.body.as_str()).collect();
        notes.push(say!("limit analysis: the preload of {} drops out", bodies.join(", ")));
        cuts.iter_mut().for_each(|c| c.faces.clear());
    }
    cuts
}

/// True for a preload > 0.
fn has_force(entry: &PreloadEntry, path: &str, faults: &mut Faults<'_>) -> bool {
    let force = entry.force.is_finite() && entry.force > 0.0;
    if !force {
        let m = format!("the preload of `{}` is {} N, a preload is > 0", entry.body, entry.force);
        let help = "write the tension of the meshed part of the bolt in N; a bolt without preload \
                    needs no entry";
        faults.add("model/value", &format!("{path}.force"), m, help);
    }
    force
}

/// Yield strength of the body of a preloaded bolt \[MPa\]; `None`: it stays elastic.
fn strength(file: &ModelFile, entry: &PreloadEntry) -> Option<f64> {
    file.bodies.get(&entry.body).and_then(|m| file.materials.get(m))?.fy
}

/// Adds a note where a preload exceeds the yield force of the shank.
fn strength_note(
    file: &ModelFile,
    entry: &PreloadEntry,
    faces: &[[TetFace; 2]],
    scene: &Scene<'_>,
    notes: &mut Vec<Text>,
) {
    let Some(fy) = strength(file, entry) else { return };
    let area = faces.iter().map(|f| {
        let t = &scene.mesh.tets[f[0].tet as usize];
        vec3::norm(vec3::area_vector(
            &face_nodes(t, f[0].local).map(|n| scene.mesh.nodes[n as usize]),
        ))
    });
    let yields = fy * area.sum::<f64>();
    if entry.force > yields {
        notes.push(say!(
            "warning: the preload of `{}`, {} N, exceeds the {} N at which its shank yields",
            &entry.body,
            entry.force.to_string(),
            format!("{yields:.0}")
        ));
    }
}

/// The preloads after the nodes are split; `pairs` are in the order of the cuts. An error where
/// something ties both halves together at the rim of a cut.
pub(super) fn preloads(
    cuts: Vec<Cut>,
    pairs: &[OpenPair],
    split: &SplitMesh,
) -> Result<Vec<Preload>, Diagnostics> {
    let mut rest = pairs;
    cuts.into_iter()
        .map(|cut| {
            let (mine, others) = rest.split_at(cut.faces.len());
            rest = others;
            check_open(&cut.preload.cut, mine, split, "model/preload")?;
            Ok(Preload { faces: mine.iter().map(FacePair::from).collect(), ..cut.preload })
        })
        .collect()
}
