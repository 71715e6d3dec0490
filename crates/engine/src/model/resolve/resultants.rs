//! Reads cuts and the limits on their resultants.

use super::claims::Claims;
use super::cut_faces::{Section, check_open};
use super::faults::Faults;
use super::names::Scene;
use crate::mesh::split::{OpenPair, SplitMesh, TetFace};
use crate::model::AnalysisKind;
use crate::model::analysis::{Cut, FacePair, Support};
use crate::model::file::{ModelFile, ResultantLimitEntry};
use crate::model::loads::face_nodes;
use crate::model::resultant_limit::ResultantLimit;
use bracket_base::diag::{Diagnostics, did_you_mean};
use bracket_base::math::vec3;
use bracket_base::say;
use bracket_base::words::Text;
use std::collections::{BTreeMap, BTreeSet};

/// Rows of the norm, at most.
const ROWS: usize = 3;

/// A cut before the nodes are split: side A, side B of each face.
pub(super) struct OpenCut {
    name: String,
    pub faces: Vec<[TetFace; 2]>,
}

/// Reads `cuts` and `resultant_limits`. Outside limit analysis the cuts stay closed, and a note
/// reports it.
pub(super) fn read(
    file: &ModelFile,
    scene: &Scene<'_>,
    claims: &Claims,
    supports: &[Support],
    faults: &mut Faults<'_>,
    notes: &mut Vec<Text>,
) -> (Vec<OpenCut>, Vec<ResultantLimit>) {
    let limit = file.analysis == AnalysisKind::Limit;
    let mut taken = BTreeMap::new();
    let mut cuts = Vec::new();
    for (i, entry) in file.cuts.iter().enumerate() {
        let path = format!("cuts[{i}]");
        let section = Section {
            body: &entry.body,
            cut: &entry.cut,
            axis: entry.axis,
            code: "model/cut",
            path: &path,
        };
        if limit && is_rigid(file, &entry.body) {
            let m = format!(
                "the body `{}` of the cut `{}` has no yield strength: limit analysis takes it as \
                 rigid",
                entry.body, entry.cut
            );
            let help = "give its material an `fy`, or cut another body";
            faults.add("model/cut", &format!("{path}.body"), m, help);
        }
        if let Some((_, faces)) = section.faces(scene, claims, &mut taken, faults) {
            cuts.push(OpenCut { name: entry.cut.clone(), faces });
        }
    }
    let mut limits = Vec::new();
    let mut names = BTreeSet::new();
    for (i, entry) in file.resultant_limits.iter().enumerate() {
        let path = format!("resultant_limits[{i}]");
        if entry.name.trim().is_empty() || !names.insert(&entry.name) {
            let m = format!("the name `{}` is empty or taken", entry.name);
            let help = "give every resultant limit a name of its own";
            faults.add("model/value", &format!("{path}.name"), m, help);
        }
        // cuts with faults are missing, so that the places would be wrong
        if cuts.len() == file.cuts.len()
            && let Some(found) = one(entry, &path, &cuts, faults)
        {
            check_held(&found, &path, &cuts, scene, supports, faults);
            limits.push(found);
        }
    }
    if !limit {
        if !limits.is_empty() {
            notes.push("resultant limits act in limit analysis only".into());
        }
        cuts.iter_mut().for_each(|c| c.faces.clear());
        limits.clear();
    }
    let used: BTreeSet<usize> = limits.iter().flat_map(|l| &l.cuts).map(|c| c.0).collect();
    for (i, cut) in cuts.iter().enumerate().filter(|(i, _)| limit && !used.contains(i)) {
        let (name, number) = (&cut.name, i.to_string());
        notes.push(say!("no resultant limit names the cut `{}` (cuts[{}])", name, number));
    }
    (cuts, limits)
}

fn is_rigid(file: &ModelFile, body: &str) -> bool {
    let material = file.bodies.get(body).and_then(|m| file.materials.get(m));
    material.is_some_and(|m| m.fy.is_none())
}

/// A limit whose values are valid.
fn one(
    entry: &ResultantLimitEntry,
    path: &str,
    cuts: &[OpenCut],
    faults: &mut Faults<'_>,
) -> Option<ResultantLimit> {
    let name = &entry.name;
    let mut bad = |key: &str, m: String, help: &str| {
        faults.add("model/value", &format!("{path}.{key}"), m, help);
    };
    let mut terms: Vec<(usize, f64)> = Vec::new();
    let mut valid = true;
    for (key, list, sign) in [("cuts", &entry.cuts, 1.0), ("minus", &entry.minus, -1.0)] {
        for (k, cut) in list.iter().enumerate() {
            let at = cuts.iter().position(|c| c.name == *cut);
            let twice = terms.iter().any(|t| Some(t.0) == at);
            match at.filter(|_| !twice) {
                Some(at) => terms.push((at, sign)),
                None => {
                    let hint = did_you_mean(cut, cuts.iter().map(|c| c.name.as_str()));
                    let what =
                        if twice { "is named twice" } else { "is not in `cuts` of the model" };
                    let m = format!("the cut `{cut}` of the limit `{name}` {what}{hint}");
                    bad(&format!("{key}[{k}]"), m, "name each cut of the model once");
                    valid = false;
                }
            }
        }
    }
    if entry.cuts.is_empty() {
        let m = format!("the limit `{name}` names no cut");
        bad("cuts", m, "name a cut of the model, `cuts: [NAME]`");
        valid = false;
    }
    let finite = |v: &[f64; 3]| v.iter().all(|x| x.is_finite());
    if !(entry.at_most.is_finite() && entry.at_most > 0.0) {
        let m = format!("the limit `{name}` permits {} N, it must be > 0", entry.at_most);
        bad("at_most", m, "write the resistance of the meshed part in N");
        valid = false;
    }
    let rows = entry.across.iter();
    if !finite(&entry.along) || rows.clone().any(|r| !finite(r) || vec3::norm(*r) == 0.0) {
        let m = format!("the limit `{name}` has a row without a direction");
        bad("across", m, "write vectors such as `[0, 1, 0]`");
        valid = false;
    } else if entry.across.len() > ROWS {
        let m = format!("the limit `{name}` has {} rows, at most {ROWS}", entry.across.len());
        bad("across", m, "a norm of a force needs no more than three rows");
        valid = false;
    } else if entry.across.is_empty() && vec3::norm(entry.along) == 0.0 {
        let m = format!("the limit `{name}` limits no direction");
        bad("along", m, "write `along`, `across` or both");
        valid = false;
    }
    valid.then(|| ResultantLimit {
        name: name.clone(),
        cuts: terms,
        along: entry.along,
        across: entry.across.clone(),
        at_most: entry.at_most,
    })
}

/// A fault where a limit has a component that a support holds at the rim of one of its cuts: there
/// the support carries a part of the force.
fn check_held(
    limit: &ResultantLimit,
    path: &str,
    cuts: &[OpenCut],
    scene: &Scene<'_>,
    supports: &[Support],
    faults: &mut Faults<'_>,
) {
    let mesh = scene.mesh;
    let nodes: BTreeSet<u32> = limit
        .cuts
        .iter()
        .flat_map(|c| &cuts[c.0].faces)
        .flat_map(|f| face_nodes(mesh, &f[0].into()))
        .collect();
    for (d, axis) in ["x", "y", "z"].into_iter().enumerate() {
        if limit.rows().all(|row| row[d] == 0.0) {
            continue;
        }
        let holds = |s: &&Support| {
            s.fix[d]
                && s.faces.iter().any(|f| face_nodes(mesh, f).iter().any(|n| nodes.contains(n)))
        };
        if let Some(support) = supports.iter().find(holds) {
            let m = format!(
                "the support `{}` holds {axis} at the rim of a cut of `{}`, whose limit has a \
                 component along {axis}",
                support.name, limit.name
            );
            let help = "on a plane of symmetry leave this component out: it is zero in the whole \
                        structure";
            faults.add("model/cut", path, m, help);
        }
    }
}

/// The cuts after the nodes are split; `pairs` are in the order of the cuts. An error where
/// something ties both sides together at the rim of a cut.
pub(super) fn opened(
    cuts: Vec<OpenCut>,
    pairs: &[OpenPair],
    split: &SplitMesh,
) -> Result<Vec<Cut>, Diagnostics> {
    let mut rest = pairs;
    let open = |cut: OpenCut| {
        let (mine, others) = rest.split_at(cut.faces.len());
        rest = others;
        check_open(&cut.name, mine, split, "model/cut")?;
        Ok(Cut { name: cut.name, faces: mine.iter().map(FacePair::from).collect() })
    };
    cuts.into_iter().map(open).collect()
}
